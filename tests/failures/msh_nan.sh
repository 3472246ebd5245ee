cat > msh_nan.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
3 1 "rock"
2 2 "x_min"
$EndPhysicalNames
$Nodes
5
1 0 0 0
2 0.1 0 0
3 0 nan 0
4 0 0 0.1
5 0 0 -0.1
$EndNodes
$Elements
3
1 2 2 2 1 1 2 4
2 4 2 1 1 1 2 3 4
3 4 2 1 1 1 3 2 5
$EndElements
END
