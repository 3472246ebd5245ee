cat > msh_not_a_mesh.msh <<'END'
time [s],value [Pa]
0,1
END
