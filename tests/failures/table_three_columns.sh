cat > table_three_columns.csv <<'END'
time [s],pressure [Pa]
0,0,0
END
