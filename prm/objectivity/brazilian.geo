// Disc that is pressed along z on two arcs of the half angle `half_angle`; its axis
// is y. With aligned = 1 the plane x = 0 is a plane of faces. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2e-3, aligned = 0, half_angle = 0.15 ];
radius = 20e-3; thickness = 6e-3;

Point(1) = {0, 0, 0};
x = radius * Sin(half_angle); z = radius * Cos(half_angle);
Point(2) = {x, 0, z};
Point(3) = {-x, 0, z};
Point(4) = {-x, 0, -z};
Point(5) = {x, 0, -z};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Circle(3) = {4, 1, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Extrude{0, thickness, 0}{ Surface{1}; }
If (aligned == 1)
  r = 1.1 * radius; p = newp;
  Point(p) = {0, -r, -r};
  Point(p + 1) = {0, r, -r};
  Point(p + 2) = {0, r, r};
  Point(p + 3) = {0, -r, r};
  l = newl;
  Line(l) = {p, p + 1}; Line(l + 1) = {p + 1, p + 2}; Line(l + 2) = {p + 2, p + 3}; Line(l + 3) = {p + 3, p};
  loop = newll; Curve Loop(loop) = {l:l + 3};
  plane = news; Plane Surface(plane) = {loop};
  BooleanFragments{ Volume{1}; Delete; }{ Surface{plane}; Delete; }
  // What of the plane lies outside the disc.
  outside() = Surface In BoundingBox{-1e-6, -1, -1, 1e-6, 1, 1};
  inside() = Surface In BoundingBox{-1e-6, -1e-6, -radius - 1e-6, 1e-6, thickness + 1e-6, radius + 1e-6};
  outside() -= inside();
  Recursive Delete{ Surface{outside()}; }
EndIf
MeshSize{ PointsOf{ Volume{:}; } } = element_size;

e = 1e-6;
Physical Volume("disc") = {Volume{:}};
upper() = Surface In BoundingBox{-x - e, -e, z - e, x + e, thickness + e, radius + e};
lower() = Surface In BoundingBox{-x - e, -e, -radius - e, x + e, thickness + e, -z + e};
Physical Surface("upper") = {upper()};
Physical Surface("lower") = {lower()};
