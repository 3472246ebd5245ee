// Two blocks and a layer between them; the middle of the layer is a plane of faces
// with aligned = 1. Lengths in m.
SetFactory("OpenCASCADE");
DefineConstant[ element_size = 2e-3, aligned = 0 ];
width = 10e-3; block = 2e-3;
layer = 2 * element_size;
height = 2 * block + layer;

Box(1) = {0, 0, 0, width, width, block};
If (aligned == 1)
  Box(2) = {0, 0, block, width, width, layer / 2};
  Box(3) = {0, 0, height / 2, width, width, layer / 2};
Else
  Box(2) = {0, 0, block, width, width, layer};
EndIf
Box(4) = {0, 0, block + layer, width, width, block};
volumes() = Volume{:};
BooleanFragments{ Volume{volumes()}; Delete; }{}
MeshSize{ PointsOf{ Volume{:}; } } = element_size;

e = 1e-6;
lower() = Volume In BoundingBox{-e, -e, -e, width + e, width + e, block + e};
middle() = Volume In BoundingBox{-e, -e, block - e, width + e, width + e, block + layer + e};
upper() = Volume In BoundingBox{-e, -e, block + layer - e, width + e, width + e, height + e};
Physical Volume("block") = {lower(), upper()};
Physical Volume("layer") = {middle()};
bottom() = Surface In BoundingBox{-e, -e, -e, width + e, width + e, e};
top() = Surface In BoundingBox{-e, -e, height - e, width + e, width + e, height + e};
Physical Surface("z_min") = {bottom()};
Physical Surface("z_max") = {top()};
