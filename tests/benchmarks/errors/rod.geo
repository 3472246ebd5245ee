// A round rod along x. Lengths in metres; the numbers can be set.
SetFactory("OpenCASCADE");

DefineConstant[ element_size = 2e-3 ];
DefineConstant[ radius = 5e-3 ];
DefineConstant[ length = 180e-3 ];

Cylinder(1) = {0, 0, 0, length, 0, 0, radius};

// Surfaces by their place, since gmsh numbers them as it likes.
e = 1e-3 * radius;
x_min() = Surface In BoundingBox{-e, -radius - e, -radius - e,
                                 e, radius + e, radius + e};

Physical Volume("rock") = {1};
Physical Surface("x_min") = x_min();

Mesh.MeshSizeMin = element_size;
Mesh.MeshSizeMax = element_size;
