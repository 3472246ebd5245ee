// An octant of a ball with a spherical cavity; its flat sides are planes of
// symmetry. Lengths in metres; the numbers can be set.
SetFactory("OpenCASCADE");

DefineConstant[ element_size = 2e-3 ];
DefineConstant[ inner_radius = 10e-3 ];
DefineConstant[ outer_radius = 44e-3 ];

Sphere(1) = {0, 0, 0, outer_radius, 0, Pi/2, Pi/2};
Sphere(2) = {0, 0, 0, inner_radius, 0, Pi/2, Pi/2};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };

// Surfaces by their place, since gmsh numbers them as it likes.
e = 1e-3 * inner_radius;
R = outer_radius + e;
x_min() = Surface In BoundingBox{-e, -e, -e, e, R, R};
y_min() = Surface In BoundingBox{-e, -e, -e, R, e, R};
z_min() = Surface In BoundingBox{-e, -e, -e, R, R, e};
cavity() = Surface In BoundingBox{-e, -e, -e,
                                  inner_radius + e, inner_radius + e, inner_radius + e};

Physical Volume("rock") = {3};
Physical Surface("x_min") = x_min();
Physical Surface("y_min") = y_min();
Physical Surface("z_min") = z_min();
Physical Surface("cavity") = cavity();

Mesh.MeshSizeMin = element_size;
Mesh.MeshSizeMax = element_size;
