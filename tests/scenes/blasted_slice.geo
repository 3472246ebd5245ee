// A slice of rock around a hole.
SetFactory("OpenCASCADE");
DefineConstant[element_size = 8e-3];
w = 0.1;
Box(1) = {-w, -w, 0, 2 * w, 2 * w, element_size};
Cylinder(2) = {0, 0, 0, 0, 0, element_size, 0.02};
BooleanDifference(3) = {Volume{1}; Delete;}{Volume{2}; Delete;};
Physical Volume("rock") = {3};
e = 1e-6;
r = 0.02 + e;
Physical Surface("hole") =
  {Surface In BoundingBox{-r, -r, -e, r, r, element_size + e}};
MeshSize{:} = element_size;
