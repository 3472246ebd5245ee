// The granite cylinder of the spalling test, along x. Lengths in metres. The
// numbers can be set in the scene.
SetFactory("OpenCASCADE");

DefineConstant[ element_size = 2.5e-3 ];
DefineConstant[ radius = 19e-3 ];
DefineConstant[ length = 180e-3 ];

Cylinder(1) = {0, 0, 0, length, 0, 0, radius};

// Surfaces by their place, since gmsh numbers them as it likes.
eps = 1e-3 * radius;
loaded() = Surface In BoundingBox{-eps, -radius - eps, -radius - eps,
                                  eps, radius + eps, radius + eps};
free_end() = Surface In BoundingBox{length - eps, -radius - eps, -radius - eps,
                                    length + eps, radius + eps, radius + eps};
side() = Surface{:};
side() -= loaded();
side() -= free_end();

Physical Volume("granite") = {1};
Physical Surface("loaded") = loaded();
Physical Surface("free_end") = free_end();
Physical Surface("side") = side();

Mesh.MeshSizeMin = element_size;
Mesh.MeshSizeMax = element_size;
