cat > table_in_mpa.csv <<'END'
time [s],pressure [MPa]
0,0
5e-6,1
END
