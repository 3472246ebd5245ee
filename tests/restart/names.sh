# Names that look like numbers or have letters beyond ASCII, and blanks in the
# mesh that the scene does not have, from the mesh to the last file and back from
# a checkpoint.
#
#   bash names.sh RIFT RANKS
. "$(dirname "$0")/common.sh"
cat >blocks.geo <<'END'
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 1, 1, 1};
Coherence;
eps = 1e-3;
left() = Surface In BoundingBox{-eps, -eps, -eps, eps, 2, 2};
right() = Surface In BoundingBox{2 - eps, -eps, -eps, 2 + eps, 2, 2};
Physical Volume("1") = {1};
Physical Volume("  Härte  2 ") = {2};
Physical Surface("1e3") = left();
Physical Surface(" right   end ") = right();
MeshSize{ PointsOf{ Volume{:}; } } = 0.4;
END
material() {
  printf 'subsection Material %s\n  set Density = 2641\n  set Elasticity = isotropic
  set Young'"'"'s modulus = 40e9\n  set Poisson'"'"'s ratio = 0.2\nend\n' "$1"
}
{
  printf 'set Title = 0 – null\nsubsection Mesh\n  set File = blocks.geo\nend\n'
  material 1
  material "Härte 2"
  printf 'subsection Boundary 1e3\n  set Pressure = 1e6\nend\n'
  printf 'subsection Probe 7\n  set Field = velocity x\n  set Boundary = right end\nend\n'
  printf 'subsection Time\n  set End time = 1e-3\nend\n'
  printf 'subsection Output\n  set Solution interval = 5e-4\nend\n'
} >blocks.prm

arguments=(blocks.prm --set "Checkpoint/Interval in steps=20")
expect 0 1 "${arguments[@]}" --output whole
says "Mesh blocks.geo: 2 x 1 x 1 m, [0-9]* cells, [0-9]* nodes; materials: 1, Härte 2; \
boundaries: 1e3, right end" whole/log.txt
says "7 \[m/s\]" whole/probes.csv
says "subsection Material Härte 2" whole/parameters.prm
expect 0 "$ranks" "${arguments[@]}" --output on_ranks
keep_sets_until 20 on_ranks
expect 0 1 "${arguments[@]}" --output on_ranks --restart
says "Going on from on_ranks/checkpoint/20" on_ranks/log.txt
same_results whole on_ranks
expect 0 1 whole/parameters.prm --output again
same_results whole again
