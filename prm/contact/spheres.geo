// Two spheres that nearly touch at the origin, with small elements there.
// Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 0.2e-3 ];
radius = 0.01;
gap = 2e-6;

Sphere(1) = {-radius - gap / 2, 0, 0, radius};
Sphere(2) = {radius + gap / 2, 0, 0, radius};
Physical Volume("left") = {1};
Physical Volume("right") = {2};

// The contact of the scene has a radius of 0.9 mm.
Field[1] = Ball;
Field[1].Radius = 1.3e-3;
Field[1].Thickness = 8e-3;
Field[1].VIn = element_size;
Field[1].VOut = 2e-3;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
