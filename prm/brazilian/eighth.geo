// An eighth of a disc: x, y, z >= 0. Its axis is y; it is pressed along z on an
// arc of the half angle `half_angle`. m
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2e-3 ];
DefineConstant[ diameter = 0.0408 ];
DefineConstant[ thickness = 0.016 ];
DefineConstant[ half_angle = 0.15 ];
r = diameter/2; eps = 1e-6;
Point(1) = {0, 0, 0};
Point(2) = {r, 0, 0};
Point(3) = {r*Sin(half_angle), 0, r*Cos(half_angle)};
Point(4) = {0, 0, r};
Line(1) = {1, 2};
Circle(2) = {2, 1, 3};
Circle(3) = {3, 1, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Extrude{0, thickness/2, 0}{ Surface{1}; }
Physical Volume("disc") = {1};
x_plane() = Surface In BoundingBox{-eps, -1, -1, eps, 1, 1};
y_plane() = Surface In BoundingBox{-1, -eps, -1, 1, eps, 1};
z_plane() = Surface In BoundingBox{-1, -1, -eps, 1, 1, eps};
loaded() = Surface In BoundingBox{-eps, -eps, r*Cos(half_angle) - eps, r*Sin(half_angle) + eps, 1, r + eps};
Physical Surface("x plane") = {x_plane()};
Physical Surface("y plane") = {y_plane()};
Physical Surface("z plane") = {z_plane()};
Physical Surface("loaded") = {loaded()};
MeshSize{ PointsOf{ Volume{:}; } } = element_size;
