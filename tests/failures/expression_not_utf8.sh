sed 's/1e6$/1e6 \xb7 t/' good.prm >expression_not_utf8.prm
