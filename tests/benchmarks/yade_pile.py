"""The heap of a run of prm/contact/pile.prm in Yade (Debian package yade): the
fragments where rift has left them, as convex polyhedra in a fixed box, with
Yade's volumetric law. Prints time of the processor per step and contact; see
doc/benchmarks.md.

usage: yade -n -x -j1 tests/benchmarks/yade_pile.py RESULTS 2> /dev/null
"""
import os
import sys
import time

# Yade runs this text without telling where it stands.
sys.path.insert(0, os.path.join(os.getcwd(), "scripts"))
from rift_output import np, read_series, read_vtu
from yade import log, polyhedra_utils

# Tells at each step what it thinks of polyhedra that only touch.
log.setLevel("Polyhedra_support.cpp", 1)

BOX = 2
STEPS = 20


def read_heap(results):
    """Corners of each fragment, and of the box inside."""
    series = read_series(results, "solid")
    fragments = {}
    box = []
    for file in series[max(series)]:
        for points, corners, _, fields in read_vtu(file):
            for material, number, cell in zip(fields["material"],
                                              fields["fragment"], corners):
                if material == BOX:
                    box += list(cell)
                else:
                    fragments.setdefault(number, set()).update(cell)
            walls = points[box]
    return [points[sorted(corners)] for corners in fragments.values()], walls


fragments, walls = read_heap(sys.argv[1])
rock = PolyhedraMat(density=2700, young=1e9, poisson=.2, frictionAngle=np.arctan(.5))
for corners in fragments:
    O.bodies.append(polyhedra_utils.polyhedra(
        rock, v=[Vector3(*map(float, corner)) for corner in corners]))
# The walls are one fragment_size thick.
low, high = walls.min(axis=0) + .02, walls.max(axis=0) - .02
for axis in range(3):
    for side, sense in ((low, 1), (high, -1)):
        position = Vector3(*map(float, (low + high) / 2))
        position[axis] = float(side[axis])
        O.bodies.append(utils.wall(position, axis, sense=sense, material=rock))

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Polyhedra_Aabb(), Bo1_Wall_Aabb()],
                          verletDist=.001),
    InteractionLoop([Ig2_Wall_Polyhedra_PolyhedraGeom(),
                     Ig2_Polyhedra_Polyhedra_PolyhedraGeom()],
                    [Ip2_PolyhedraMat_PolyhedraMat_PolyhedraPhys()],
                    [Law2_PolyhedraGeom_PolyhedraPhys_Volumetric()]),
    NewtonIntegrator(damping=.3, gravity=(0, 0, -9.81)),
]
O.dt = 2e-5
O.run(2 * STEPS, True)
for _ in range(5):
    start = time.process_time()
    O.run(STEPS, True)
    seconds = (time.process_time() - start) / STEPS
    contacts = sum(1 for i in O.interactions if i.isReal)
    print(f"{len(fragments)} polyhedra, {len(O.interactions)} pairs near, "
          f"{contacts} contacts: {1e3 * seconds:.2f} ms per step, "
          f"{1e6 * seconds / max(contacts, 1):.2f} us per contact and step")
