// A rigid block flies past a soft one and grazes it; another rigid one, faster,
// runs into it from behind. Rigid cells come first. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 4e-3 ];
Box(1) = {0, 0, 0, 0.02, 0.02, 0.02};
Box(2) = {-0.0149, 0.008, 0.009, 0.012, 0.016, 0.02};
Rotate { {0, 0, 1}, {-0.009, 0.016, 0.019}, 0.3 } { Volume{2}; }
Rotate { {0, 1, 0}, {-0.009, 0.016, 0.019}, 0.2 } { Volume{2}; }
Box(3) = {-0.0282, 0.012, 0.012, 0.01, 0.006, 0.009};
Physical Volume("missile", 1) = {2};
Physical Volume("chaser", 2) = {3};
Physical Volume("target", 3) = {1};
MeshSize{ PointsOf{ Volume{:}; } } = element_size;
