cat > table_not_increasing.csv <<'END'
time [s],pressure [Pa]
0,0
5e-6,1e6
5e-6,0
END
