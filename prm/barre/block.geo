// A block whose cells come from cubes of the edge element_size, so that a plane
// wave along x stays plane. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 1.2e-3 ];
DefineConstant[ length = 28.8e-3 ];
DefineConstant[ width = 110.4e-3 ];
eps = 1e-6;

Box(1) = {0, 0, 0, length, width, width};
Transfinite Curve{:} = Round(width / element_size) + 1;
// Those along x.
Transfinite Curve{9:12} = Round(length / element_size) + 1;
Transfinite Surface{:};
Transfinite Volume{:};
// All cells are alike; there is nothing to improve.
Mesh.Optimize = 0;

Physical Volume("barre") = {1};
x_min() = Surface In BoundingBox{-eps, -eps, -eps, eps, 1, 1};
Physical Surface("x_min") = {x_min()};
