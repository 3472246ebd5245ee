#!/usr/bin/env python3
"""Compares runs of prm/spalling with the extrinsic and the intrinsic model as
Figs. 6 and 7 of Fukuda et al. (2021) do: axial stress at 20 us, velocity of the
free end, where it cracks. Prints a table in Markdown.

usage: scripts/compare_spalling.py FIGURE.png LABEL=RESULTS...
"""
import os
import sys

if len(sys.argv) < 3 or any("=" not in a for a in sys.argv[2:]):
    sys.exit(__doc__)

from rift_output import (deformed, import_pyplot, np, read_series, read_summary,
                         read_table, read_vtu)

plt = import_pyplot()

LENGTH, RADIUS = 0.18, 0.019
TIME_OF_STRESS = 20e-6
EDGES = np.arange(0, LENGTH + 4e-3, 4e-3)
CENTRES = 0.5 * (EDGES[1:] + EDGES[:-1])


def read_state(results, series, time):
    """Pieces of the state nearest to a time."""
    files = read_series(results, series)
    nearest = min(files, key=lambda t: abs(t - time))
    if abs(nearest - time) > 1e-6:
        sys.exit(f"{results} has no state at {time} s")
    return [piece for file in files[nearest] for piece in read_vtu(file)]


class Run:
    def __init__(self, results):
        probes = read_table(os.path.join(results, "probes.csv"))
        self.time, self.fspv = probes["time [s]"], probes["fspv [m/s]"]
        self.summary = read_summary(results)
        self.read_stress(results)
        self.read_damage(results)

    def read_stress(self, results):
        """sigma_xx of the cells near the axis: means and scatter over x."""
        x, stress = [], []
        for points, cells, at_points, fields in read_state(results, "solid",
                                                           TIME_OF_STRESS):
            centre = deformed(points, at_points)[cells].mean(axis=1)
            near = np.hypot(centre[:, 1], centre[:, 2]) < 0.4 * RADIUS
            x.append(centre[near, 0])
            stress.append(fields["stress [Pa]"][near, 0])
        x, stress = np.concatenate(x), np.concatenate(stress) / 1e6
        bins = np.digitize(x, EDGES) - 1
        self.stress = np.array([stress[bins == i].mean() if (bins == i).any() else 0
                                for i in range(len(CENTRES))])
        self.cells_x, self.cells_stress = x, stress
        noise = stress - np.interp(x, CENTRES, self.stress)
        self.noise = np.sqrt(np.mean(noise[x < 0.06]**2))

    def read_damage(self, results):
        """Area of the faces that are open by more than 10 um over x."""
        self.opened = np.zeros(len(CENTRES))
        for points, faces, at_points, fields in read_state(results, "fracture",
                                                           self.summary["time"]):
            x = deformed(points, at_points)[faces]
            normal = np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0])
            is_open = fields["opening [m]"] > 10e-6
            area = 0.5 * np.abs(normal[:, 0])
            self.opened += np.histogram(x[is_open].mean(axis=1)[:, 0], EDGES,
                                        weights=area[is_open])[0]
        self.opened /= np.pi * RADIUS**2

    def front(self):
        """Where the pulse has a fourth of its largest stress at 20 us, m."""
        level = 0.25 * self.stress.min()
        ahead = len(CENTRES) - 1 - np.argmax(self.stress[::-1] < level)
        return np.interp(level, self.stress[ahead:ahead + 2], CENTRES[ahead:ahead + 2])

    def arrival(self):
        """When the free end has reached 1 m/s, s."""
        i = np.argmax(self.fspv >= 1)
        return np.interp(1, self.fspv[i - 1:i + 1], self.time[i - 1:i + 1])

    def peak(self):
        return self.fspv[self.time < self.arrival() + 60e-6].max()


def print_table(runs):
    reference = next(iter(runs.values()))
    print("| | front at 20 us | over the first run | noise of sigma_xx | "
          "FSPV reaches 1 m/s | peak of the FSPV | largest opened area at | "
          "dissipated by fracture | steps | residual |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for label, run in runs.items():
        s = run.summary
        place = (f"{1e3 * CENTRES[np.argmax(run.opened)]:.0f} mm"
                 if run.opened.max() > 0 else "none")
        print(f"| {label} | {1e3 * run.front():.1f} mm | "
              f"{run.front() / reference.front():.2f} | {run.noise:.2f} MPa | "
              f"{1e6 * run.arrival():.1f} us | {run.peak():.2f} m/s | {place} | "
              f"{s['energy']['fracture']:.2f} J | {s['steps']} | "
              f"{s['energy_residual_relative']:.1e} |")


def warn_of_other_meshes(runs):
    cells = {label: run.summary["cells"] for label, run in runs.items()}
    if len(set(cells.values())) > 1:
        print("WARNING: these runs have other meshes, of so many cells: " +
              ", ".join(f"{label} {n}" for label, n in cells.items()),
              file=sys.stderr)


def main(figure, runs):
    warn_of_other_meshes(runs)
    print_table(runs)
    plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3})
    n = len(runs)
    plots = plt.figure(figsize=(9, 4 + 1.5 * n))
    grid = plots.add_gridspec(n + 1, 2, height_ratios=[2.2] + [1] * n)
    stress, fspv = plots.add_subplot(grid[0, 0]), plots.add_subplot(grid[0, 1])
    for i, (label, run) in enumerate(runs.items()):
        style = {"color": "k", "linewidth": 1.6} if i == 0 else {"linewidth": 1}
        stress.plot(1e3 * CENTRES, run.stress, label=label, **style)
        fspv.plot(1e6 * run.time, run.fspv, label=label, **style)
        cells = plots.add_subplot(grid[i + 1, 0], sharex=stress)
        cells.scatter(1e3 * run.cells_x, run.cells_stress, s=1, c=run.cells_stress,
                      cmap="coolwarm", vmin=-40, vmax=40)
        cells.set(xlim=(0, 120), ylim=(-50, 15), ylabel=f"{label}\n(MPa)")
        opened = plots.add_subplot(grid[i + 1, 1])
        opened.bar(1e3 * EDGES[:-1], run.opened, width=4, align="edge")
        opened.set(xlim=(0, 180), ylim=(0, 1.2))
        if i == 0:
            opened.set_title("area open by > 10 um at the end, over the section,\n"
                             "in slices of 4 mm", fontsize=9)
            cells.set_title("sigma_xx of the cells near the axis at 20 us",
                            fontsize=9)
        if i == n - 1:
            cells.set_xlabel("x (mm)")
            opened.set_xlabel("x (mm)")
    stress.set(title="sigma_xx near the axis at 20 us", ylabel="mean (MPa)")
    stress.legend(fontsize=7)
    fspv.set(title="velocity of the free end", xlabel="time (us)",
             ylabel="FSPV (m/s)")
    plots.tight_layout()
    plots.savefig(figure, dpi=100)


if __name__ == "__main__":
    main(sys.argv[1], {a.split("=", 1)[0]: Run(a.split("=", 1)[1])
                       for a in sys.argv[2:]})
