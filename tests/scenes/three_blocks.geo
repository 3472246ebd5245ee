// Two blocks side by side and a third one across both.
SetFactory("OpenCASCADE");
DefineConstant[element_size = 4e-3];
gap = 1e-6;
Box(1) = {0, 0, 0, 0.012, 0.012, 0.008};
Box(2) = {0.012 + gap, 0.001, 0, 0.012, 0.012, 0.008};
Box(3) = {0.006, 0.002, 0.008 + gap, 0.012, 0.012, 0.008};
Physical Volume("left") = {1};
Physical Volume("right") = {2};
Physical Volume("upper") = {3};
MeshSize{PointsOf{Volume{:};}} = element_size;
