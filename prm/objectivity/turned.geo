// Prism of 8 x 8 x 24 mm whose middle is meshed in layers: planes of faces, one
// element_size apart, whose normal is turned by `angle` (degrees) from the z axis
// about y. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2e-3, angle = 45 ];
width = 8e-3; height = 24e-3; grip = 2e-3;

Box(1) = {0, 0, 0, width, width, height};
rise = width / 2 * Tan(angle * Pi / 180);
step = element_size / Cos(angle * Pi / 180);
n_side = Floor((height / 2 - rise - grip) / step);
planes() = {};
For i In {-n_side:n_side}
  z = height / 2 + i * step;
  a = newp; Point(a) = {0, 0, z - rise};
  b = newp; Point(b) = {width, 0, z + rise};
  c = newp; Point(c) = {width, width, z + rise};
  d = newp; Point(d) = {0, width, z - rise};
  l = newl; Line(l) = {a, b}; Line(l + 1) = {b, c}; Line(l + 2) = {c, d}; Line(l + 3) = {d, a};
  loop = newll; Curve Loop(loop) = {l:l + 3};
  plane = news; Plane Surface(plane) = {loop};
  planes() += plane;
EndFor
BooleanFragments{ Volume{1}; Delete; }{ Surface{planes()}; Delete; }
MeshSize{ PointsOf{ Volume{:}; } } = element_size;

e = 1e-6;
Physical Volume("rock") = {Volume{:}};
bottom() = Surface In BoundingBox{-e, -e, -e, width + e, width + e, e};
top() = Surface In BoundingBox{-e, -e, height - e, width + e, width + e, height + e};
Physical Surface("z_min") = {bottom()};
Physical Surface("z_max") = {top()};
