cat > geo_error.geo <<'END'
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 0.1, 0.02, 0.02;
END
