// Cylinder along z between two rigid platens; m
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2e-3 ];
DefineConstant[ diameter = 0.02 ];
DefineConstant[ height = 0.04 ];
t = 4e-3; r = 0.75*diameter; gap = 1e-6;
Cylinder(1) = {0, 0, -height/2, 0, 0, height, diameter/2};
Cylinder(2) = {0, 0, height/2 + gap, 0, 0, t, r};
Cylinder(3) = {0, 0, -height/2 - gap, 0, 0, -t, r};
Physical Volume("specimen") = {1};
Physical Volume("upper platen") = {2};
Physical Volume("lower platen") = {3};
MeshSize{ PointsOf{ Volume{1}; } } = element_size;
MeshSize{ PointsOf{ Volume{2,3}; } } = r/2;
