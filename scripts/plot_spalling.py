#!/usr/bin/env python3
"""Plots a run of prm/spalling: velocity of the free surface, ledger of energy,
opening and damage along the axis; and prints the figures of doc/verification.md.

usage: scripts/plot_spalling.py RESULTS FIGURE.png
"""
import os
import sys

if len(sys.argv) != 3:
    sys.exit(__doc__)

from rift_output import (deformed, import_pyplot, np, read_series, read_summary,
                         read_table, read_vtu)

plt = import_pyplot()

# x of the plane of the one-dimensional reference with rigid bonds: least and
# largest for cells of 1 to 4.2 mm (doc/verification.md).
REFERENCE_PLANE = (85e-3, 100e-3)
OPEN = 10e-6
BIN_WIDTH = 2e-3
EDGES = np.arange(0, 0.18 + BIN_WIDTH, BIN_WIDTH)
SECTION = np.pi * 19e-3**2


def read_fracture(path):
    """Corners, where they are now, and fields of the cohesive faces in the pieces of
    one file."""
    return [(deformed(points, at_points)[corners.reshape(-1, 3)], fields)
            for points, corners, at_points, fields in read_vtu(path)]


def join(pieces):
    """Corners and fields of all pieces of a state; no fields without faces."""
    corners = np.concatenate([piece[0] for piece in pieces])
    if len(corners) == 0:
        return corners, None
    return corners, {name: np.concatenate([fields[name] for _, fields in pieces])
                     for name in pieces[0][1]}


def read_fractures(results):
    """(time, corners, fields) at each time of fracture.pvd, which may list
    several files for a time."""
    files = read_series(results, "fracture")
    return [(time, *join([piece for file in files[time]
                          for piece in read_fracture(file)]))
            for time in sorted(files)]


def axial_areas(corners):
    """Areas of faces projected on the cross section, m^2."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return 0.5 * np.abs(normal[:, 0])


def find_planes(corners, fields):
    """Macroscopic planes as ranges of x: bins in which faces that are open by
    more than OPEN cover a part of the cross section; neighbouring bins are one
    plane if they cover more than half of it."""
    is_open = fields["opening [m]"] > OPEN
    area, x = axial_areas(corners), corners[:, :, 0].mean(axis=1)
    covered, _ = np.histogram(x[is_open], EDGES, weights=area[is_open])
    ranges, group = [], []
    for i in list(np.nonzero(covered > 0.02 * SECTION)[0]) + [10**6]:
        if group and i > group[-1] + 1:
            if covered[group].sum() > 0.5 * SECTION:
                ranges.append((EDGES[group[0]], EDGES[group[-1] + 1]))
            group = []
        group.append(i)
    return ranges, covered / SECTION


def describe_plane(begin, end, fractures):
    """Prints where a plane is, how wide it opens, and when it did."""
    means = []
    for _, corners, fields in fractures:
        if fields is None:
            means.append(0)
            continue
        x = corners[:, :, 0].mean(axis=1)
        inside = (x >= begin) & (x < end)
        area = axial_areas(corners)[inside]
        means.append((area * fields["opening [m]"][inside]).sum() / SECTION)
    weight = area * fields["opening [m]"][inside]
    mean = np.average(x[inside], weights=weight)
    spread = np.sqrt(np.average((x[inside] - mean)**2, weights=weight))
    has_failed = fields["time of failure [s]"][inside] >= 0
    times = [time for time, _, _ in fractures]
    reached = np.interp(OPEN, means, times) if means[-1] > OPEN else np.nan
    failures = fields["time of failure [s]"][inside][has_failed]
    half = f"{np.median(failures) * 1e6:.0f} us" if len(failures) else "never"
    print(f"plane: x = {mean * 1e3:.1f} mm (spread {spread * 1e3:.1f} mm); mean "
          f"opening {OPEN * 1e6:.0f} um at {reached * 1e6:.0f} us, "
          f"{means[-1] * 1e6:.0f} um at the end; {has_failed.sum()} faces failed, "
          f"which cover {area[has_failed].sum() / SECTION:.2f} of the section, half of "
          f"them at {half}")


def elastic_fspv(time):
    """Free-surface velocity of an elastic bar, twice that of the pulse."""
    density, speed = 2641, np.sqrt(40.6e9 / 2641)
    phase = np.clip((time - 0.18 / speed) / 60e-6, 0, 1)
    return 2 * 40e6 / (density * speed) * np.sin(np.pi * phase)


def time_at(time, values, level):
    """When rising values first reach a level."""
    after = np.argmax(values >= level)
    return np.interp(level, values[after - 1:after + 1], time[after - 1:after + 1])


def main(results, figure):
    probes = read_table(os.path.join(results, "probes.csv"))
    energy = read_table(os.path.join(results, "energy.csv"))
    summary = read_summary(results)
    fractures = read_fractures(results)
    _, corners, fields = fractures[-1]
    planes, covered = find_planes(corners, fields)

    time, fspv = probes["time [s]"], probes["fspv [m/s]"]
    peak = np.argmax(fspv * (time < 100e-6))
    loads = energy["loads [J]"]
    intact = energy["time [s]"] < fields["time of insertion [s]"].min()
    residual = energy["residual [J]"] / loads.max()
    first = np.argmin(fields["time of insertion [s]"])
    print(f"cells {summary['cells']}, step {summary['time_step']:.3e} s, "
          f"{summary['steps']} steps, {summary['wall_seconds']:.1f} s of wall time")
    reference = elastic_fspv(time)
    half = 0.5 * reference.max()
    print(f"FSPV: peak {fspv[peak]:.3f} m/s at {time[peak] * 1e6:.1f} us (elastic bar "
          f"{reference.max():.3f} m/s at {time[np.argmax(reference)] * 1e6:.1f} us); "
          f"half of the bar's peak at {time_at(time, fspv, half) * 1e6:.2f} us (bar "
          f"{time_at(time, reference, half) * 1e6:.2f} us)")
    print(f"first opening: x = {corners[first, :, 0].mean() * 1e3:.1f} mm at "
          f"{fields['time of insertion [s]'][first] * 1e6:.1f} us")
    print(f"faces: {summary['faces_inserted']} cut, {len(corners)} opened, "
          f"{summary['faces_broken']} failed; fragments {summary['fragments']}")
    for begin, end in planes:
        describe_plane(begin, end, fractures)
    print(f"energy put in {loads.max():.4f} J; largest residual while intact "
          f"{np.abs(residual[intact]).max():.2e}, at all times "
          f"{np.abs(residual).max():.2e} of it, at the end {residual[-1]:.2e}")

    plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3})
    plots, axes = plt.subplots(3, 1, figsize=(7, 8.4))
    axes[0].plot(time * 1e6, fspv, label="rift")
    until = time < 95e-6
    axes[0].plot(time[until] * 1e6, elastic_fspv(time[until]), "k--",
                 linewidth=0.8, label="elastic bar, 1-D")
    axes[0].set(xlabel="time (us)", ylabel="FSPV (m/s)")
    axes[0].legend()
    for name in ("kinetic", "strain", "cohesive", "fracture", "friction", "loads"):
        axes[1].plot(energy["time [s]"] * 1e6, energy[name + " [J]"], label=name)
    axes[1].plot(energy["time [s]"] * 1e6, 1e6 * energy["residual [J]"], "k:",
                 label="residual x 1e6")
    axes[1].set(xlabel="time (us)", ylabel="energy (J)")
    axes[1].legend(ncol=1, loc="upper left", fontsize=7)
    axes[2].bar(1e3 * EDGES[:-1], covered, width=1e3 * BIN_WIDTH, align="edge",
                label="open by more than 10 um")
    damage, _ = np.histogram(corners[:, :, 0].mean(axis=1), EDGES,
                             weights=fields["damage"])
    axes[2].step(1e3 * EDGES[:-1], damage / damage.max(), where="post", color="C1",
                 label="sum of damage over its largest")
    axes[2].axvspan(1e3 * REFERENCE_PLANE[0], 1e3 * REFERENCE_PLANE[1], color="k",
                    alpha=.12, label="plane of the 1-D reference")
    axes[2].set(xlabel="x (mm)", ylabel="share of the cross section")
    axes[2].legend(loc="upper left", fontsize=7)
    plots.tight_layout()
    plots.savefig(figure, dpi=110)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
