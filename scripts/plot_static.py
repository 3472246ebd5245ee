#!/usr/bin/env python3
"""Figure of the two static tests of prm/brazilian: curves, and the cracks on planes
through the axis.

usage: scripts/plot_static.py UCS STATIC FIGURE.png
"""
import os
import sys

if len(sys.argv) != 4:
    sys.exit(__doc__)

from rift_output import deformed, import_pyplot, np, read_series, read_table, read_vtu

plt = import_pyplot()
from matplotlib.collections import LineCollection

UCS_RADIUS, UCS_HEIGHT, GAUGE_LENGTH, GAUGE_RADIUS = 0.01, 0.04, 0.02, 0.0095
DISC_DIAMETER, DISC_THICKNESS = 0.0408, 0.016


def warn_if_rising(name, values):
    if values.argmax() >= 0.99 * (len(values) - 1):
        print(f"WARNING: {name}: the force is highest at the end of the run, so that "
              "this is no peak. Take a later end.", file=sys.stderr)


def force_of(table):
    return .5 * (np.abs(table["upper force [N]"]) + np.abs(table["lower force [N]"]))


def column(table, name):
    return next(table[header] for header in table if header.startswith(name))


def uniaxial(results):
    """Stress, and strains from the gauges, compression positive."""
    table = read_table(os.path.join(results, "probes.csv"))
    gauge = {(side, i): column(table, f"{side} gauge {i}")
             for side in ("upper", "lower", "lateral") for i in (1, 2)}
    axial = sum(gauge["lower", i] - gauge["upper", i]
                for i in (1, 2)) / (2 * GAUGE_LENGTH)
    lateral = (gauge["lateral", 1] - gauge["lateral", 2]) / (2 * GAUGE_RADIUS)
    return force_of(table) / (np.pi * UCS_RADIUS**2), axial, lateral


def brazilian(results):
    table = read_table(os.path.join(results, "probes.csv"))
    return (table["time [s]"],
            2 * force_of(table) / (np.pi * DISC_DIAMETER * DISC_THICKNESS))


def crossings(results, time, axis):
    """Lines in which cohesive faces cross the plane of x (axis 0) or y (1) = 0, as
    (y or x, z), and the damage of each face, above 1 where it has failed."""
    series = read_series(results, "fracture")
    moment = min(series, key=lambda t: abs(t - time))
    lines, damages = [], []
    for file in series[moment]:
        for points, faces, at_points, cells in read_vtu(file):
            x = deformed(points, at_points)[faces]
            distance = x[:, :, axis] + 1e-9
            damage = cells["damage"] + 1. * (cells["time of failure [s]"] >= 0)
            for corners, d, how_much in zip(x, distance, damage):
                ends = [corners[i] - d[i] / (d[j] - d[i]) * (corners[j] - corners[i])
                        for i in range(3) for j in range(i) if d[i] * d[j] < 0]
                if len(ends) == 2:
                    lines.append(1e3 * np.array(ends)[:, [1 - axis, 2]])
                    damages.append(how_much)
    return lines, np.array(damages)


def draw_cracks(axes, results, outline, time, axis=1):
    lines, damages = crossings(results, time, axis)
    axes.plot(*outline, "k", lw=.6)
    for least, most, colour, width in ((-1, .3, ".7", .5), (.3, 1.1, "C0", .9),
                                       (1.1, 3, "C3", 1.4)):
        axes.add_collection(LineCollection(
            [line for line, d in zip(lines, damages) if least <= d < most],
            colors=colour, linewidths=width))
    axes.set(xlabel=f"{'yx'[axis]} (mm)", ylabel="z (mm)", aspect="equal",
             title=f"{'xy'[axis]} = 0 at {1e6 * time:.0f} us")


def end_of(results):
    return max(read_series(results, "fracture"))


def main(ucs, static, figure):
    _, ((curve, cracks, more_cracks), (history, disc_cracks, words)) = plt.subplots(
        2, 3, figsize=(11, 8), layout="constrained")
    stress, axial, lateral = uniaxial(ucs)
    peak = stress.argmax()
    warn_if_rising("uniaxial", stress)
    part = np.flatnonzero((stress > .2 * stress[peak]) & (stress < .5 * stress[peak]))
    part = part[part < peak]
    modulus = np.polyfit(axial[part], stress[part], 1)[0]
    ratio = np.polyfit(axial[part], lateral[part], 1)[0]
    print(f"uniaxial: peak {1e-6 * stress[peak]:.1f} MPa, from 20 to 50 % of it "
          f"E = {1e-9 * modulus:.2f} GPa, nu = {ratio:.4f}")
    curve.plot(1e3 * axial, 1e-6 * stress, label="axial")
    curve.plot(-1e3 * lateral, 1e-6 * stress, label="lateral")
    curve.set(xlabel="strain (1e-3)", ylabel="stress (MPa)", title="uniaxial")
    curve.legend()
    width, height = 1e3 * UCS_RADIUS, .5e3 * UCS_HEIGHT
    outline = ([-width, width, width, -width, -width],
               [-height, -height, height, height, -height])
    draw_cracks(cracks, ucs, outline, end_of(ucs))
    draw_cracks(more_cracks, ucs, outline, end_of(ucs), axis=0)

    times, tension = brazilian(static)
    warn_if_rising("Brazilian", tension)
    print(f"Brazilian: peak {1e-6 * tension.max():.2f} MPa at "
          f"{1e6 * times[tension.argmax()]:.0f} us")
    history.plot(1e6 * times, 1e-6 * tension)
    history.set(xlabel="time (us)", ylabel="2P/(pi D t) (MPa)", title="Brazilian")
    angle = np.linspace(0, 2 * np.pi, 200)
    draw_cracks(disc_cracks, static, (.5e3 * DISC_DIAMETER * np.cos(angle),
                                      .5e3 * DISC_DIAMETER * np.sin(angle)),
                end_of(static))
    words.axis("off")
    words.text(0, .5, "faces that have opened:\nred: failed\nblue: damage > 0.3\n"
               "grey: the others")
    for axes in (curve, history):
        axes.grid(alpha=.3)
    plt.savefig(figure, dpi=80)


main(*sys.argv[1:])
