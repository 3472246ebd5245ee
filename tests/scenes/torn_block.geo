// A block of two materials, glued together at x = 30 mm.
SetFactory("OpenCASCADE");
DefineConstant[element_size = 4e-3];
Box(1) = {0, 0, 0, 0.03, 0.02, 0.02};
Box(2) = {0.03, 0, 0, 0.03, 0.02, 0.02};
Coherence;
e = 1e-6;
Physical Volume("barre") = {1};
Physical Volume("granite") = {2};
Physical Surface("left") = {Surface In BoundingBox{-e, -e, -e, e, 1, 1}};
Physical Surface("right") = {Surface In BoundingBox{0.06 - e, -e, -e, 1, 1, 1}};
Physical Surface("top") = {Surface In BoundingBox{-e, 0.02 - e, -e, 1, 1, 1}};
MeshSize{:} = element_size;
