cat > msh_cut_off.msh <<'END'
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
3 0 0.1 0
4 0 0 0.1
5 0 0 -0.1
$EndNodes
$Elements
3
1 2 2 2 
END
