sed '/^subsection Material/ s/rock/h\xe4rter/' good.prm >scene_not_utf8.prm
