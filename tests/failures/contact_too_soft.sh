cat > contact_too_soft.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
3 1 "rock"
3 2 "steel"
$EndPhysicalNames
$Nodes
8
1 0 0 0
2 0.1 0 0
3 0 0.1 0
4 0 0 0.1
5 0.01 0.01 -0.001
6 0.01 0.05 -0.001
7 0.05 0.01 -0.001
8 0.01 0.01 -0.04
$EndNodes
$Elements
2
1 4 2 1 1 1 2 3 4
2 4 2 2 2 5 6 7 8
$EndElements
END
