// The bars of a split Hopkinson test and a disc between them: striker, incident
// bar, disc, transmission bar, in a row along x. The disc has its centre at the
// origin and its axis along z. Lengths in m.
SetFactory("OpenCASCADE");
// Cells of the disc; those of the bars begin with this size at the disc ...
DefineConstant[ element_size = 2e-3 ];
// ... and grow to this one over the length `grading`.
DefineConstant[ bar_size = 7e-3 ];
DefineConstant[ grading = 0.06 ];
// Bars and disc of Saksala et al. (2013).
DefineConstant[ bar_length = 1.2 ];
bar_diameter = 0.022;
disc_diameter = 0.0408;
disc_thickness = 0.016;
// Not published; README.md says why so. Without tapers the striker has the
// diameter of the bars.
DefineConstant[ striker_length = 0.53 ];
DefineConstant[ tapered = 1 ];
striker_diameter = 0.0245;
// From the tip on: where the nose has which diameter, and the same for the tail,
// from its end.
nose_at() = {0, 0.048, 0.1, 0.153};
nose_diameters() = {0.010, 0.017, 0.029, striker_diameter};
// The tip is a flat pyramid of this height, or flat.
DefineConstant[ tip_height = 2e-4 ];
tail_at() = {0, 0.12};
tail_diameters() = {0.012, striker_diameter};
// Cells of both bodies where the tip strikes; they grow as at the disc.
DefineConstant[ tip_size = 3e-3 ];
// Ring of the skin over which stress and velocity are measured: from the end of
// a bar at the disc to the middle of the ring, and its width.
DefineConstant[ gauge = 0.3 ];
gauge_width = 0.01;
gap = 1e-6;
If (tapered && (striker_length < 0.28 || tip_height < 0))
  Error("a tapered striker is longer than its nose and tail, 0.28 m, and its tip_height is not negative; tapered = 0 makes a plain one");
EndIf
If (gauge < gauge_width || gauge > bar_length - gauge_width)
  Error("the gauge must lie on the bars");
EndIf

// Bars are prisms whose area is that of the circle, so that any mesh has it.
n_sides = 12;
angle = 2 * Pi / n_sides;
radius_over_diameter = 0.5 * Sqrt(angle / Sin(angle));

// A body along x in parts: at `at(k)` it has the diameter `diameters(k)`. Its
// volumes are in `parts`, its sections in `sections`, the sides of part `ring` in
// `sides`. Its last section is a flat pyramid of the height `peak`, if that is not
// 0.
Macro Body
  n_parts = #at() - 1;
  point = newp;
  around = newl;
  along = around + (n_parts + 1) * n_sides;
  For k In {0 : n_parts}
    radius = diameters(k) * radius_over_diameter;
    For i In {0 : n_sides - 1}
      Point(point + k * n_sides + i) = {at(k), radius * Cos((i + 0.5) * angle),
                                        radius * Sin((i + 0.5) * angle)};
    EndFor
  EndFor
  For k In {0 : n_parts}
    For i In {0 : n_sides - 1}
      j = k * n_sides + i;
      Line(around + j) = {point + j, point + k * n_sides + (i + 1) % n_sides};
      If (k < n_parts)
        Line(along + j) = {point + j, point + j + n_sides};
      EndIf
    EndFor
  EndFor
  sections() = {};
  For k In {0 : n_parts}
    loop = newll;
    Curve Loop(loop) = {around + k * n_sides : around + (k + 1) * n_sides - 1};
    section = news;
    If (k < n_parts || peak == 0)
      Plane Surface(section) = {loop};
      sections() += section;
    EndIf
  EndFor
  faces() = {};
  If (peak > 0)
    apex = newp;
    Point(apex) = {at(n_parts) + peak, 0, 0};
    rim = n_parts * n_sides;
    up = newl;
    For i In {0 : n_sides - 1}
      Line(up + i) = {point + rim + i, apex};
    EndFor
    For i In {0 : n_sides - 1}
      loop = newll;
      Curve Loop(loop) = {around + rim + i, up + (i + 1) % n_sides, -(up + i)};
      face = news;
      Plane Surface(face) = {loop};
      faces() += face;
    EndFor
  Else
    faces() = {sections(n_parts)};
  EndIf
  parts() = {};
  For k In {0 : n_parts - 1}
    shell() = {};
    For i In {0 : n_sides - 1}
      j = k * n_sides + i;
      next = k * n_sides + (i + 1) % n_sides;
      loop = newll;
      Curve Loop(loop) = {around + j, along + next, -(around + j + n_sides),
                          -(along + j)};
      side = news;
      Plane Surface(side) = {loop};
      shell() += side;
    EndFor
    If (k == ring)
      sides() = shell();
    EndIf
    shell() += sections(k);
    If (k < n_parts - 1)
      shell() += sections(k + 1);
    Else
      shell() += faces();
    EndIf
    loop = newsl;
    Surface Loop(loop) = {shell()};
    part = newv;
    Volume(part) = {loop};
    parts() += part;
  EndFor
Return

front = disc_diameter / 2 + gap;
tip = -front - bar_length - gap;
end = tip - striker_length;
ring = -1;
peak = 0;
at() = {end, tip};
diameters() = {bar_diameter, bar_diameter};
If (tapered)
  at() = {};
  diameters() = {};
  For k In {0 : #tail_at() - 1}
    at() += end + tail_at(k);
    diameters() += tail_diameters(k);
  EndFor
  peak = tip_height;
  For k In {1 : #nose_at()}
    at() += tip - peak - nose_at(#nose_at() - k);
    diameters() += nose_diameters(#nose_at() - k);
  EndFor
EndIf
Call Body;
Physical Volume("striker") = {parts()};

ring = 1;
peak = 0;
x = -front - gauge - gauge_width / 2;
at() = {-front - bar_length, x, x + gauge_width, -front};
diameters() = {bar_diameter, bar_diameter, bar_diameter, bar_diameter};
Call Body;
Physical Volume("incident bar") = {parts()};
Physical Surface("incident gauge") = {sides()};
Physical Surface("incident end") = {sections(3)};

x = front + gauge - gauge_width / 2;
at() = {front, x, x + gauge_width, front + bar_length};
Call Body;
Physical Volume("transmission bar") = {parts()};
Physical Surface("transmission gauge") = {sides()};
Physical Surface("transmission end") = {sections(0)};

// Four arcs, so that there are nodes along the lines that touch the bars.
radius = disc_diameter / 2;
point = newp;
Point(point) = {0, 0, -disc_thickness / 2};
For i In {0 : 3}
  Point(point + 1 + i) = {radius * Cos(i * Pi / 2), radius * Sin(i * Pi / 2),
                          -disc_thickness / 2};
EndFor
line = newl;
For i In {0 : 3}
  Circle(line + i) = {point + 1 + i, point, point + 1 + (i + 1) % 4};
EndFor
loop = newll;
Curve Loop(loop) = {line : line + 3};
end = news;
Plane Surface(end) = {loop};
disc() = Extrude {0, 0, disc_thickness} { Surface{end}; };
Physical Volume("disc") = {disc(1)};

Field[1] = Box;
Field[1].VIn = element_size;
Field[1].VOut = bar_size;
Field[1].XMin = -front;
Field[1].XMax = front;
Field[1].YMin = -1;
Field[1].YMax = 1;
Field[1].ZMin = -1;
Field[1].ZMax = 1;
Field[1].Thickness = grading;
Field[2] = Box;
Field[2].VIn = tapered ? tip_size : bar_size;
Field[2].VOut = bar_size;
Field[2].XMin = tip;
Field[2].XMax = tip + gap;
Field[2].YMin = -1;
Field[2].YMax = 1;
Field[2].ZMin = -1;
Field[2].ZMax = 1;
Field[2].Thickness = grading;
Field[3] = Min;
Field[3].FieldsList = {1, 2};
Background Field = 3;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
