// Direct shear box, held below and pushed above a gap whose middle line carries
// no nodes, or (aligned = 1) a plane of faces. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2e-3, aligned = 0, half_gap = 1.5e-3 ];
length = 24e-3; width = 6e-3; height = 16e-3;

If (aligned == 1)
  Box(1) = {0, 0, 0, length, width, height / 2};
  Box(2) = {0, 0, height / 2, length, width, height / 2};
Else
  Box(1) = {0, 0, 0, length, width, height};
EndIf
// Edges of the grips on the two ends.
edges() = {};
For end In {0:1}
  For side In {-1:1:2}
    z = height / 2 + side * half_gap;
    a = newp; Point(a) = {end * length, 0, z};
    b = newp; Point(b) = {end * length, width, z};
    line = newl; Line(line) = {a, b};
    edges() += line;
  EndFor
EndFor
volumes() = Volume{:};
BooleanFragments{ Volume{volumes()}; Delete; }{ Line{edges()}; Delete; }
MeshSize{ PointsOf{ Volume{:}; } } = element_size;

e = 1e-6;
low = height / 2 - half_gap; high = height / 2 + half_gap;
Physical Volume("rock") = {Volume{:}};
bottom() = Surface In BoundingBox{-e, -e, -e, length + e, width + e, e};
held_left() = Surface In BoundingBox{-e, -e, -e, e, width + e, low + e};
held_right() = Surface In BoundingBox{length - e, -e, -e, length + e, width + e, low + e};
pushed_left() = Surface In BoundingBox{-e, -e, high - e, e, width + e, height + e};
pushed_right() = Surface In BoundingBox{length - e, -e, high - e, length + e, width + e, height + e};
top() = Surface In BoundingBox{-e, -e, height - e, length + e, width + e, height + e};
Physical Surface("held") = {bottom(), held_left(), held_right()};
Physical Surface("pushed") = {pushed_left(), pushed_right()};
Physical Surface("top") = {top()};
