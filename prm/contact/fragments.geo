// Irregular fragments on a loose lattice. A fragment is a cube whose corners are
// moved at random, turned at random, of six tetrahedra. The same numbers give
// the same fragments. Lengths in m.
DefineConstant[ n_x = 12 ];
DefineConstant[ n_y = 12 ];
DefineConstant[ n_z = 14 ];
// Edge of the largest cubes.
DefineConstant[ fragment_size = 0.02 ];
// Edge of the smallest cubes, and the largest shift of a corner along each
// axis, over the edge of the largest.
DefineConstant[ smallest = 0.85 ];
DefineConstant[ distortion = 0.1 ];
DefineConstant[ seed = 1 ];
// 1: a closed box around them; 0: none.
DefineConstant[ with_box = 1 ];

// Corners of the edges, along x, y, z, and the edges of the sides; negative:
// backward.
from() = {0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};
to() = {1, 3, 5, 7, 2, 3, 6, 7, 4, 5, 6, 7};
sides() = {1, 6, -2, -5, 3, 8, -4, -7, 1, 10, -3, -9, 2, 12, -4, -11,
           5, 11, -7, -9, 6, 12, -8, -10};

// Fragments do not meet on the lattice: no corner is further from the centre
// than the half diagonal of a cube of this edge.
cell = fragment_size * Sqrt(3) * (1 + 2 * distortion) * 1.01;
n = n_x * n_y * n_z;
state = seed;
For f In {0 : n - 1}
  // Park and Miller's generator: 0 < random < 1.
  For m In {0 : 27}
    state = Fmod(16807 * state, 2147483647);
    random(m) = state / 2147483647;
  EndFor
  // A turn around z, one around x, one around z
  c1 = Cos(2 * Pi * random(24));
  s1 = Sin(2 * Pi * random(24));
  c2 = 2 * random(25) - 1;
  s2 = Sqrt(1 - c2 * c2);
  c3 = Cos(2 * Pi * random(26));
  s3 = Sin(2 * Pi * random(26));
  edge = fragment_size * (smallest + (1 - smallest) * random(27));
  shift = fragment_size * distortion;
  For m In {0 : 7}
    u = edge * ((m % 2) - 0.5) + shift * (2 * random(3 * m) - 1);
    v = edge * (Floor(m / 2) % 2 - 0.5) + shift * (2 * random(3 * m + 1) - 1);
    w = edge * (Floor(m / 4) - 0.5) + shift * (2 * random(3 * m + 2) - 1);
    x = c1 * u - s1 * v;
    y = c2 * (s1 * u + c1 * v) - s2 * w;
    z = s2 * (s1 * u + c1 * v) + c2 * w;
    Point(8 * f + m + 1) = {cell * (f % n_x + 0.5) + c3 * x - s3 * y,
                            cell * (Floor(f / n_x) % n_y + 0.5) + s3 * x + c3 * y,
                            cell * (Floor(f / (n_x * n_y)) + 0.5) + z};
  EndFor
  point = 8 * f + 1;
  For m In {0 : 11}
    Line(12 * f + m + 1) = {point + from(m), point + to(m)};
  EndFor
  Transfinite Curve{12 * f + 1 : 12 * f + 12} = 2;
  side = 6 * f + 1;
  For m In {0 : 5}
    loop() = {};
    For k In {4 * m : 4 * m + 3}
      loop() += sides(k) > 0 ? 12 * f + sides(k) : sides(k) - 12 * f;
    EndFor
    Curve Loop(side + m) = loop();
    Surface(side + m) = {side + m};
  EndFor
  Transfinite Surface{side : side + 5};
  Surface Loop(f + 1) = {side : side + 5};
  Volume(f + 1) = {f + 1};
  Transfinite Volume{f + 1} = {point, point + 1, point + 3, point + 2,
                               point + 4, point + 5, point + 7, point + 6};
EndFor
half = n_x * n_y * Floor(n_z / 2);
Physical Volume("lower") = {1 : half};
Physical Volume("upper") = {half + 1 : n};

If (with_box)
  wall = fragment_size;
  For m In {0 : 1}
    point = newp;
    For k In {0 : 7}
      i = k % 2;
      j = Floor(k / 2) % 2;
      l = Floor(k / 4);
      Point(point + k) = {n_x * cell * i + m * wall * (2 * i - 1),
                          n_y * cell * j + m * wall * (2 * j - 1),
                          n_z * cell * l + m * wall * (2 * l - 1), 2 * wall};
    EndFor
    line = newl;
    For k In {0 : 11}
      Line(line + k) = {point + from(k), point + to(k)};
    EndFor
    side = news;
    For k In {0 : 5}
      loop() = {};
      For i In {4 * k : 4 * k + 3}
        loop() += sides(i) > 0 ? line - 1 + sides(i) : sides(i) - line + 1;
      EndFor
      Curve Loop(side + k) = loop();
      Plane Surface(side + k) = {side + k};
    EndFor
    Surface Loop(n + 1 + m) = {side : side + 5};
  EndFor
  Volume(n + 1) = {n + 2, n + 1};
  Physical Volume("box") = {n + 1};
EndIf
