// Two blocks that share a face, which has a name, as has part of the surface.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 1, 1, 1};
Coherence;
Physical Volume("soft") = {1};
Physical Volume("hard") = {2};
eps = 1e-3;
joint() = Surface In BoundingBox{1 - eps, -eps, -eps, 1 + eps, 1 + eps, 1 + eps};
left() = Surface In BoundingBox{-eps, -eps, -eps, eps, 1 + eps, 1 + eps};
DefineConstant[ names = 1 ];
If(names == 1)
  Physical Surface("joint") = joint();
EndIf
If(names == 2)
  Physical Surface("plane") = {joint(), left()};
EndIf
MeshSize{ PointsOf{ Volume{:}; } } = 1;
