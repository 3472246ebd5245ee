// A rigid block flies past a soft one and grazes it. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 4e-3 ];
Box(1) = {0, 0, 0, 0.02, 0.02, 0.02};
Box(2) = {-0.0149, 0.008, 0.009, 0.012, 0.016, 0.02};
Rotate { {0, 0, 1}, {-0.009, 0.016, 0.019}, 0.3 } { Volume{2}; }
Rotate { {0, 1, 0}, {-0.009, 0.016, 0.019}, 0.2 } { Volume{2}; }
Physical Volume("target") = {1};
Physical Volume("missile") = {2};
MeshSize{ PointsOf{ Volume{:}; } } = element_size;
