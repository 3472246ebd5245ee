cat > table_without_header.csv <<'END'
0,0
5e-6,1e6
END
