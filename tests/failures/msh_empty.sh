cat > msh_empty.msh <<'END'
END
