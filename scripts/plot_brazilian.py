#!/usr/bin/env python3
"""Figures of the dynamic Brazilian test with rigid bars (prm/brazilian).

usage: scripts/plot_brazilian.py FOLDER NAME=RESULTS...

Draws into FOLDER, for each run side by side: the indirect tensile stress
2 P/(pi D t) over time, the stress across the load on the mid-plane at the last
state before anything breaks in one of them, and the cracks at the two plane
surfaces 58 us after the peak.
"""
import os
import sys

if len(sys.argv) < 3 or not all("=" in run for run in sys.argv[2:]):
    sys.exit(__doc__)

from rift_output import deformed, import_pyplot, np, read_series, read_table, read_vtu

plt = import_pyplot()
from matplotlib.collections import LineCollection, PolyCollection

DIAMETER, THICKNESS = 0.04, 0.016
AFTER_PEAK = 58e-6


def history(results):
    """Times and indirect tensile stress by the mean of both forces, Pa."""
    table = read_table(os.path.join(results, "probes.csv"))
    forces = [np.abs(table[f"{name} force [N]"])
              for name in ("incident", "transmitted")]
    scale = 2 / (np.pi * DIAMETER * THICKNESS)
    return table["time [s]"], [scale * force for force in forces]


def first_insertion(results):
    times = [piece[3]["time of insertion [s]"].min()
             for files in read_series(results, "fracture").values()
             for file in files for piece in read_vtu(file) if len(piece[1])]
    return min(times, default=np.inf)


def state_near(results, name, time):
    series = read_series(results, name)
    moment = min(series, key=lambda t: abs(t - time))
    return moment, [piece for file in series[moment] for piece in read_vtu(file)]


def section(pieces):
    """Triangles and quadrangles in which cells cross y = 0, as (x, z), and the
    stress xx of each cell."""
    polygons, stress = [], []
    for points, cells, at_points, fields in pieces:
        x = deformed(points, at_points)[cells]
        y = x[:, :, 1] + 1e-9
        crosses = (y.min(1) < 0) & (y.max(1) > 0)
        for corners, s in zip(x[crosses], fields["stress [Pa]"][crosses, 0]):
            cut = []
            for i in range(4):
                for j in range(i):
                    a, b = corners[i], corners[j]
                    if (a[1] + 1e-9) * (b[1] + 1e-9) < 0:
                        w = (a[1] + 1e-9) / (a[1] - b[1])
                        cut.append((a + w * (b - a))[[0, 2]])
            cut = np.array(cut)
            middle = cut.mean(0)
            order = np.argsort(np.arctan2(*(cut - middle).T[::-1]))
            polygons.append(1e3 * cut[order])
            stress.append(s)
    return polygons, 1e-6 * np.array(stress)


def surface_edges(results, time, side):
    """Edges of cohesive faces at the plane surface y = side t/2, as (x, z) in the
    deformed disc, and whether the face has failed."""
    lines, failed = [], []
    for points, faces, at_points, cells in state_near(results, "fracture", time)[1]:
        at_side = np.isclose(points[:, 1], side * THICKNESS / 2)
        x = deformed(points, at_points)
        for face, time_of_failure in zip(faces, cells["time of failure [s]"]):
            ends = [c for c in face if at_side[c]]
            if len(ends) == 2:
                lines.append(1e3 * x[ends][:, [0, 2]])
                failed.append(time_of_failure >= 0)
    return lines, np.array(failed, dtype=bool)


def draw_histories(axes, runs):
    for colour, (name, results) in zip(("C0", "C1", "C2"), runs):
        times, stresses = history(results)
        mean = .5 * (stresses[0] + stresses[1])
        axes.plot(1e6 * times, 1e-6 * mean, colour, label=name)
        axes.plot(1e6 * times, 1e-6 * stresses[0], colour, lw=.6, ls="--")
        axes.plot(1e6 * times, 1e-6 * stresses[1], colour, lw=.6, ls=":")
    axes.set(xlabel="time (us)", ylabel="2P/(pi D t) (MPa)")
    axes.legend(title="mean of both ends\n(dashed: incident,\ndotted: transmitted)",
                fontsize=8, title_fontsize=8)
    axes.grid(alpha=.3)


def peak_of(results):
    times, stresses = history(results)
    mean = .5 * (stresses[0] + stresses[1])
    return times[mean.argmax()], mean.max()


def main(folder, runs):
    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    draw_histories(axes, runs)
    figure.savefig(os.path.join(folder, "brazilian_history.png"), dpi=90)

    figure, all_axes = plt.subplots(1, len(runs), figsize=(4.6 * len(runs), 4.2),
                                    layout="constrained", squeeze=False)
    insertions = {name: first_insertion(results) for name, results in runs}
    before = max(t for t in read_series(runs[0][1], "solid")
                 if t < min(insertions.values()))
    for axes, (name, results) in zip(all_axes[0], runs):
        insertion = insertions[name]
        moment, pieces = state_near(results, "solid", before)
        polygons, stress = section(pieces)
        drawing = PolyCollection(polygons, array=stress, cmap="RdBu_r",
                                 edgecolors="face", linewidths=.2)
        drawing.set_clim(-20, 20)
        axes.add_collection(drawing)
        axes.set(title=f"{name}, {1e6 * moment:.0f} us", xlabel="x (mm)",
                 ylabel="z (mm)", aspect="equal", xlim=(-21, 21), ylim=(-21, 21))
        core = [s for p, s in zip(polygons, stress)
                if np.hypot(*p.mean(0)) < 5]
        peak_time, peak = peak_of(results)
        times, stresses = history(results)
        now = np.interp(moment, times, .5 * (stresses[0] + stresses[1]))
        print(f"{name}: peak {1e-6 * peak:.2f} MPa at {1e6 * peak_time:.1f} us, "
              f"first insertion after {1e6 * insertion:.1f} us; at "
              f"{1e6 * moment:.0f} us 2P/(pi D t) = {1e-6 * now:.2f} MPa, mean "
              f"sigma_11 within 5 mm of the axis {np.mean(core):.2f} MPa, largest "
              f"there {max(core):.2f} MPa")
    figure.colorbar(drawing, ax=all_axes[0], label="stress across the load (MPa)",
                    shrink=.8)
    figure.savefig(os.path.join(folder, "brazilian_stress.png"), dpi=80)

    figure, all_axes = plt.subplots(2, len(runs), figsize=(4.2 * len(runs), 8),
                                    layout="constrained", squeeze=False)
    for column, (name, results) in enumerate(runs):
        time = peak_of(results)[0] + AFTER_PEAK
        for axes, side in zip(all_axes[:, column], (-1, 1)):
            lines, failed = surface_edges(results, time, side)
            axes.add_patch(plt.Circle((0, 0), 500 * DIAMETER, fill=False, lw=.6))
            for which, colour, width in ((~failed, ".65", .6), (failed, "C3", 1.3)):
                axes.add_collection(LineCollection(
                    [line for line, w in zip(lines, which) if w],
                    colors=colour, linewidths=width))
            axes.set(title=f"{name}, y = {side * 500 * THICKNESS:+.0f} mm",
                     xlabel="x (mm)", ylabel="z (mm)", aspect="equal",
                     xlim=(-22, 22), ylim=(-22, 22))
    figure.savefig(os.path.join(folder, "brazilian_cracks.png"), dpi=80)


main(sys.argv[1], [run.split("=", 1) for run in sys.argv[2:]])
