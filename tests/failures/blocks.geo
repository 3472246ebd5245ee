// Two blocks that face each other, and which share a face where the gap is none.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 0.02 ];
DefineConstant[ gap = 1e-3 ];
Box(1) = {0, 0, 0, 0.02, 0.02, 0.02};
Box(2) = {0.02 + gap, 0, 0, 0.02, 0.02, 0.02};
If(gap == 0)
  Coherence;
EndIf
Physical Volume("rock") = {1};
Physical Volume("steel") = {2};
far() = Surface In BoundingBox{0.0399 + gap, -1, -1, 1, 1, 1};
Physical Surface("far end") = {far(0)};
MeshSize{ PointsOf{ Volume{:}; } } = element_size;
