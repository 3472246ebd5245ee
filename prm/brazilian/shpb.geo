// The bars of a split Hopkinson test and a disc between them: striker with a
// pulse shaper, incident bar, disc, transmission bar, in a row along x. The disc
// has its centre at the origin and its axis along z. Lengths in m.
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
// Not published; README.md says why so.
DefineConstant[ striker_length = 0.45 ];
shaper_thickness = 0.005;
// Ring of the skin over which stress and velocity are measured: from the end of
// a bar at the disc to the middle of the ring, and its width.
DefineConstant[ gauge = 0.3 ];
gauge_width = 0.01;
gap = 1e-6;

// Bars are prisms with the area of the circle, so that any mesh has it.
n_sides = 12;
angle = 2 * Pi / n_sides;
bar_radius = bar_diameter / 2 * Sqrt(angle / Sin(angle));

// A prism from `x` to `x + length` in parts: `before` long, `ring` long if that is
// not 0, and the rest. Its volumes are in `parts`, its ends in `ends`, the sides
// of the ring in `sides`.
Macro Prism
  point = newp;
  line = newl;
  For i In {0 : n_sides - 1}
    Point(point + i) = {x, bar_radius * Cos((i + 0.5) * angle),
                        bar_radius * Sin((i + 0.5) * angle)};
  EndFor
  For i In {0 : n_sides - 1}
    Line(line + i) = {point + i, point + (i + 1) % n_sides};
  EndFor
  loop = newll;
  Curve Loop(loop) = {line : line + n_sides - 1};
  end = news;
  Plane Surface(end) = {loop};
  first() = Extrude {before, 0, 0} { Surface{end}; };
  If (ring > 0)
    second() = Extrude {ring, 0, 0} { Surface{first(0)}; };
    third() = Extrude {length - before - ring, 0, 0} { Surface{second(0)}; };
    parts() = {first(1), second(1), third(1)};
    sides() = second({2 : n_sides + 1});
    ends() = {end, third(0)};
  Else
    second() = Extrude {length - before, 0, 0} { Surface{first(0)}; };
    parts() = {first(1), second(1)};
  EndIf
Return

// Striker and shaper are one body.
front = disc_diameter / 2 + gap;
length = striker_length + shaper_thickness;
x = -front - bar_length - gap - length;
before = striker_length;
ring = 0;
Call Prism;
Physical Volume("striker") = {parts(0)};
Physical Volume("shaper") = {parts(1)};

length = bar_length;
x = -front - bar_length;
before = bar_length - gauge - gauge_width / 2;
ring = gauge_width;
Call Prism;
Physical Volume("incident bar") = {parts()};
Physical Surface("incident gauge") = {sides()};
Physical Surface("incident end") = {ends(1)};

x = front;
before = gauge - gauge_width / 2;
Call Prism;
Physical Volume("transmission bar") = {parts()};
Physical Surface("transmission gauge") = {sides()};
Physical Surface("transmission end") = {ends(0)};

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
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
