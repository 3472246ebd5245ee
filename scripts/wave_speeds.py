#!/usr/bin/env python3
"""Speeds of the pulses of prm/barre/block_*.prm, and those of Christoffel's equation
for the material of the run (doc/theory.md, eq. 31). Prints a table in Markdown; ends
with an error where a run has no clear pulse of one wave.

usage: scripts/wave_speeds.py RESULTS...
"""
import os
import re
import sys

if len(sys.argv) < 2:
    sys.exit(__doc__)

from rift_output import np, read_bytes, read_table

WAVES = ("P", "S1", "S2")
PLACES = ("near", "far")
# A pulse is where the parabola through what is above this part of its largest
# velocity has its top. What comes after that may have been disturbed from the sides.
TOP = 0.5
# Largest velocity of other waves over that of the pulse, and by how much the latter
# may change from one probe to the other.
IMPURITY, CHANGE = 0.01, 0.1


def read_scene(results):
    """{subsection: {entry: value}} of what rift has used."""
    scene, section = {}, {}
    text = read_bytes(os.path.join(results, "parameters.prm")).decode()
    for line in text.splitlines():
        if match := re.match(r"subsection (.*)", line):
            section = scene.setdefault(match[1], {})
        elif match := re.match(r" *set (.*?) *= *(.*)", line):
            section[match[1]] = match[2]
    return scene


def entry(scene, section, name):
    try:
        return scene[section][name]
    except KeyError:
        sys.exit(f"{sys.argv[0]}: the scene has no {section}/{name}")


def numbers(text):
    return np.array(text.split(","), dtype=float)


def christoffel(scene):
    """Speeds of the waves along x, the fastest first, and their polarisations in the
    rows of a matrix, in the frame of the mesh."""
    material = next((s for s in scene if s.startswith("Material ")), "Material")
    if entry(scene, material, "Elasticity") != "anisotropic":
        sys.exit(f"{sys.argv[0]} needs a material with Elasticity = anisotropic")
    voigt = np.zeros((6, 6))
    voigt[np.triu_indices(6)] = numbers(entry(scene, material, "Stiffness"))
    voigt += np.triu(voigt, 1).T
    pairs = np.array([[0, 5, 4], [5, 1, 3], [4, 3, 2]])
    stiffness = voigt[pairs[:, :, None, None], pairs]
    first, second = (numbers(entry(scene, material, f"Axis {i}")) for i in (1, 2))
    first /= np.linalg.norm(first)
    second -= (second @ first) * first
    second /= np.linalg.norm(second)
    axes = np.array([first, second, np.cross(first, second)])
    x = axes[:, 0]
    moduli, vectors = np.linalg.eigh(np.einsum("i,ijkl,l", x, stiffness, x))
    return (np.sqrt(moduli[::-1] / float(entry(scene, material, "Density"))),
            vectors.T[::-1] @ axes)


def time_of_top(time, velocity):
    """And how many rows it took; None where no pulse has come and gone."""
    top = velocity.argmax()
    height = velocity - TOP * velocity[top]
    below = np.flatnonzero(height <= 0)
    before, after = below[below < top], below[below > top]
    if len(before) == 0 or len(after) == 0 or after[0] - before[-1] < 8:
        return None
    part = slice(before[-1] + 1, after[0])
    # With weights, so that it does not matter which row is the first above.
    a, b, _ = np.polyfit(time[part] - time[top], velocity[part], 2,
                         w=np.sqrt(height[part]))
    return time[top] - b / (2 * a), after[0]


def measure(results):
    """Which wave, its measured speed and that of Christoffel's equation, m/s."""
    scene = read_scene(results)
    speeds, polarisations = christoffel(scene)
    table = read_table(os.path.join(results, "probes.csv"))
    x = [numbers(entry(scene, f"Probe {place}_x", "Point"))[0] for place in PLACES]
    # Velocities along the three polarisations.
    along = [polarisations @ [table[f"{place}_{d} [m/s]"] for d in "xyz"]
             for place in PLACES]
    wave = np.abs(along[0]).max(axis=1).argmax()
    times, heights = [], []
    for place, velocities in zip(PLACES, along):
        v = velocities[wave]
        v *= np.sign(v[np.abs(v).argmax()])
        pulse = time_of_top(table["time [s]"], v)
        if pulse is None:
            sys.exit(f"{results}: no pulse of {WAVES[wave]} has passed the probes "
                     f"{place}")
        others = np.abs(np.delete(velocities[:, :pulse[1]], wave, axis=0)).max()
        if others > IMPURITY * v.max():
            sys.exit(f"{results}: {WAVES[wave]} does not run alone at the probes "
                     f"{place}")
        times.append(pulse[0])
        heights.append(v.max())
    if abs(heights[1] / heights[0] - 1) > CHANGE:
        sys.exit(f"{results}: a pulse of {heights[0]:.3g} m/s cannot be one of "
                 f"{heights[1]:.3g} m/s further on")
    return WAVES[wave], (x[1] - x[0]) / (times[1] - times[0]), speeds[wave]


def main(runs):
    print("| run | wave | measured, m/s | Christoffel, m/s | deviation |")
    print("|---|---|---|---|---|")
    for results in runs:
        wave, measured, exact = measure(results)
        print(f"| {results} | {wave} | {measured:.1f} | {exact:.1f} | "
              f"{100 * (measured / exact - 1):+.2f} % |", flush=True)


main(sys.argv[1:])
