// A block with a corner at the origin. Lengths in metres; the numbers can be set.
SetFactory("OpenCASCADE");

DefineConstant[ element_size = 2e-3 ];
DefineConstant[ length = 90e-3 ];
DefineConstant[ width = 6e-3 ];
DefineConstant[ height = 6e-3 ];

Box(1) = {0, 0, 0, length, width, height};

// Surfaces by their place, since gmsh numbers them as it likes.
e = 1e-3 * height;
x_min() = Surface In BoundingBox{-e, -e, -e, e, width + e, height + e};
y_min() = Surface In BoundingBox{-e, -e, -e, length + e, e, height + e};
y_max() = Surface In BoundingBox{-e, width - e, -e, length + e, width + e, height + e};
z_min() = Surface In BoundingBox{-e, -e, -e, length + e, width + e, e};
z_max() = Surface In BoundingBox{-e, -e, height - e, length + e, width + e, height + e};

Physical Volume("rock") = {1};
Physical Surface("x_min") = x_min();
Physical Surface("y_min") = y_min();
Physical Surface("y_max") = y_max();
Physical Surface("z_min") = z_min();
Physical Surface("z_max") = z_max();

Mesh.MeshSizeMin = element_size;
Mesh.MeshSizeMax = element_size;
