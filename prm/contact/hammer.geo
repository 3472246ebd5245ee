// A block before the end of a bar. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2.5e-3 ];
length = 0.1;
width = 0.01;
overhang = 1e-3;
gap = 1e-6;
thickness = 0.02;

Box(1) = {0, 0, 0, length, width, width};
Box(2) = {-gap - thickness, -overhang, -overhang,
          thickness, width + 2 * overhang, width + 2 * overhang};
Physical Volume("bar") = {1};
Physical Volume("hammer") = {2};
MeshSize{ PointsOf{ Volume{1}; } } = element_size;
MeshSize{ PointsOf{ Volume{2}; } } = width;
