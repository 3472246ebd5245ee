// Disc between two flat rigid platens; its axis is y, the load runs along z. m
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2e-3 ];
DefineConstant[ diameter = 0.0408 ];
DefineConstant[ thickness = 0.016 ];
t = 4e-3; w = 0.012; gap = 1e-6;
Cylinder(1) = {0, -thickness/2, 0, 0, thickness, 0, diameter/2};
Box(2) = {-w, -0.6*thickness, diameter/2 + gap, 2*w, 1.2*thickness, t};
Box(3) = {-w, -0.6*thickness, -diameter/2 - gap - t, 2*w, 1.2*thickness, t};
Physical Volume("specimen") = {1};
Physical Volume("upper platen") = {2};
Physical Volume("lower platen") = {3};
MeshSize{ PointsOf{ Volume{1}; } } = element_size;
MeshSize{ PointsOf{ Volume{2,3}; } } = 4e-3;
