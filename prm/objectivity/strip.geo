// Strip with an edge notch in the middle; its top is divided into bands, which are
// pulled by speeds that fall along x, so that a crack grows stably. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2e-3, thickness = 4e-3 ];
length = 60e-3; height = 40e-3; notch = 20e-3; gap = 0.6e-3;
n_bands = 12;

Box(1) = {0, 0, 0, length, thickness, height};
Box(2) = {-1e-3, -1e-3, (height - gap) / 2, notch + 1e-3, thickness + 2e-3, gap};
BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }
lines() = {};
For i In {1:n_bands - 1}
  x = length * i / n_bands;
  a = newp; Point(a) = {x, 0, height};
  b = newp; Point(b) = {x, thickness, height};
  line = newl; Line(line) = {a, b};
  lines() += line;
EndFor
BooleanFragments{ Volume{1}; Delete; }{ Line{lines()}; Delete; }
MeshSize{ PointsOf{ Volume{:}; } } = element_size;

e = 1e-6;
Physical Volume("rock") = {Volume{:}};
bottom() = Surface In BoundingBox{-e, -e, -e, length + e, thickness + e, e};
Physical Surface("bottom") = {bottom()};
For i In {0:n_bands - 1}
  band() = Surface In BoundingBox{length * i / n_bands - e, -e, height - e, length * (i + 1) / n_bands + e, thickness + e, height + e};
  Physical Surface(Sprintf("top_%g", i)) = {band()};
EndFor
