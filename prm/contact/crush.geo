// Granite cube between two rigid platens; m
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 3e-3 ];
DefineConstant[ edge = 0.02 ];
t = 0.005; o = 0.005; gap = 1e-6;
Box(1) = {-edge/2, -edge/2, 0, edge, edge, edge};
Box(2) = {-edge/2-o, -edge/2-o, -gap-t, edge+2*o, edge+2*o, t};
Box(3) = {-edge/2-o, -edge/2-o, edge+gap, edge+2*o, edge+2*o, t};
Physical Volume("granite") = {1};
Physical Volume("lower platen") = {2};
Physical Volume("upper platen") = {3};
top() = Surface In BoundingBox{-edge, -edge, edge-1e-7, edge, edge, edge+1e-7};
Physical Surface("cube top") = {top()};
MeshSize{ PointsOf{ Volume{1}; } } = element_size;
MeshSize{ PointsOf{ Volume{2,3}; } } = 0.01;
