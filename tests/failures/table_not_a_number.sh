cat > table_not_a_number.csv <<'END'
time [s],pressure [Pa]
0,0
5e-6,1 MPa
END
