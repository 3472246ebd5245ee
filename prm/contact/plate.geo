// A square plate and a sphere above its middle. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 4e-3 ];
DefineConstant[ width = 0.1 ];
DefineConstant[ thickness = 0.012 ];
radius = 8e-3;
gap = 1e-5;

Box(1) = {-width / 2, -width / 2, -thickness, width, width, thickness};
Sphere(2) = {0, 0, radius + gap, radius};
Physical Volume("plate") = {1};
Physical Volume("projectile") = {2};
MeshSize{ PointsOf{ Volume{1}; } } = element_size;
MeshSize{ PointsOf{ Volume{2}; } } = radius / 3;
