// A block on a table. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 5e-3 ];

Box(1) = {-0.02, -0.02, -0.01, 0.06, 0.04, 0.01};
Box(2) = {-0.01, -0.01, 0, 0.02, 0.02, 0.01};
Physical Volume("table") = {1};
Physical Volume("block") = {2};
bottom() = Surface In BoundingBox{-1, -1, -0.0101, 1, 1, -0.0099};
Physical Surface("bottom") = {bottom()};
MeshSize{ PointsOf{ Volume{:}; } } = element_size;
