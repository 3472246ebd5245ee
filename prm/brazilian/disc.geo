// Disc between two rigid loading discs; its axis is y, the load runs along z. m
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 1.5e-3 ];
DefineConstant[ diameter = 0.04 ];
DefineConstant[ thickness = 0.016 ];
DefineConstant[ bar_diameter = 0.025 ];
gap = 1e-6; plate = 3e-3;
Cylinder(1) = {0, -thickness/2, 0, 0, thickness, 0, diameter/2};
Cylinder(2) = {0, 0, diameter/2 + gap, 0, 0, plate, bar_diameter/2};
Cylinder(3) = {0, 0, -diameter/2 - gap, 0, 0, -plate, bar_diameter/2};
Physical Volume("disc") = {1};
Physical Volume("incident bar") = {2};
Physical Volume("transmission bar") = {3};
MeshSize{ PointsOf{ Volume{1}; } } = element_size;
MeshSize{ PointsOf{ Volume{2,3}; } } = 3e-3;
