cat > more_ranks_than_cells.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
3 1 "rock"
2 2 "x_min"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 0.1 0 0
3 0 0.1 0
4 0 0 0.1
$EndNodes
$Elements
2
1 2 2 2 1 1 2 4
2 4 2 1 1 1 2 3 4
$EndElements
END
