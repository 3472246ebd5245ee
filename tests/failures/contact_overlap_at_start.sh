cat > contact_overlap_at_start.msh <<'END'
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
5 0.02 0.02 0.02
6 0.12 0.02 0.02
7 0.02 0.12 0.02
8 0.02 0.02 0.12
$EndNodes
$Elements
2
1 4 2 1 1 1 2 3 4
2 4 2 2 2 5 6 7 8
$EndElements
END
