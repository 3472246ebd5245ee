// Two bars in a row. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2.5e-3 ];
length = 0.1;
width = 0.01;
gap = 1e-6;

Box(1) = {0, 0, 0, length, width, width};
Box(2) = {length + gap, 0, 0, length, width, width};
Physical Volume("hammer") = {1};
Physical Volume("anvil") = {2};
MeshSize{ PointsOf{ Volume{:}; } } = element_size;
