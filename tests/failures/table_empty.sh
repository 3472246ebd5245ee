cat > table_empty.csv <<'END'
time [s],pressure [Pa]
END
