#!/usr/bin/env python3
"""Three-wave analysis of a run of prm/brazilian/shpb.prm: the incident pulse, the
forces on both sides of the disc, its indirect tensile stress and loading rate.
Prints them as a table in Markdown and plots them, and where the disc is open if
states have been written.

usage: scripts/plot_shpb.py RESULTS FIGURE.png
"""
import sys

if len(sys.argv) != 3:
    sys.exit(__doc__)

import os

from rift_output import (deformed, import_pyplot, np, read_series, read_summary,
                         read_table, read_vtu)

plt = import_pyplot()

# As in shpb.geo and shpb.prm.
MODULUS, DENSITY = 210e9, 7850
AREA = np.pi / 4 * 0.022**2
DIAMETER, THICKNESS = 0.0408, 0.016
GAUGE = 0.3
SPEED = np.sqrt(MODULUS / DENSITY)
TENSION_OF_FORCE = 2 / (np.pi * DIAMETER * THICKNESS)
OPENING = 10e-6
# What Saksala et al. (2013) report at 10 m/s.
MEASURED_PEAK, MEASURED_RATE = 37.0e6, 1000e9
MEASURED_PULSE = 225e6, (55e-6, 150e-6, 35e-6)


class Waves:
    """Incident, reflected and transmitted wave, Pa, positive in compression, at
    the faces of the disc. With the velocity of the bar at its gauge the waves
    that run to and fro there are told apart even where they overlap."""

    def __init__(self, results):
        probes = read_table(f"{results}/probes.csv")
        time = probes["time [s]"]
        stress = -probes["incident gauge [Pa]"]
        motion = DENSITY * SPEED * probes["incident gauge velocity [m/s]"]
        transmitted = -probes["transmission gauge [Pa]"]
        # A wave that is at the disc at t passes the gauge this much earlier or
        # later.
        delay = GAUGE / SPEED
        self.gauge_time, self.pulse = time, 0.5 * (stress + motion)
        self.time = time[(time >= delay) & (time <= time[-1] - delay)]
        if len(self.time) == 0:
            sys.exit(f"{results}: the run ends before any wave has passed the disc")
        self.incident = np.interp(self.time - delay, time, self.pulse)
        self.reflected = np.interp(self.time + delay, time, 0.5 * (stress - motion))
        self.transmitted = np.interp(self.time + delay, time, transmitted)

    def forces(self):
        """On the sides of the incident and of the transmission bar, N."""
        return AREA * (self.incident + self.reflected), AREA * self.transmitted


def crossing(time, values, level, after=0):
    """When the values first pass the level, upward or downward."""
    above = values[after:] >= level
    i = after + np.argmax(above != above[0])
    share = (level - values[i - 1]) / (values[i] - values[i - 1])
    return time[i - 1] + share * (time[i] - time[i - 1])


class Pulse:
    """Height of the incident pulse, Pa, and how long it rises and falls: 1.25 times
    the time between 10 and 90 % of the height, as if it were a trapezoid."""

    def __init__(self, time, stress):
        above = np.flatnonzero(stress > 0.5 * stress.max())
        first, last = above[0], above[-1]
        self.height = stress[(first + last) // 2:last - (last - first) // 5].mean()
        up = [crossing(time, stress, level * self.height)
              for level in (0.1, 0.5, 0.9)]
        self.half_time = up[1]
        self.rise = (up[2] - up[0]) / 0.8
        self.duration = self.fall = None
        # Unless the run ends before.
        lowest, middle = stress[last:].min() / self.height, (first + last) // 2
        if lowest < 0.5:
            self.duration = crossing(time, stress, 0.5 * self.height, middle) - up[1]
        if lowest < 0.1:
            down = [crossing(time, stress, level * self.height, middle)
                    for level in (0.1, 0.9)]
            self.fall = (down[0] - down[1]) / 0.8


class Disc:
    """Indirect tensile stress, Pa, of the force on the side of the transmission
    bar, its first peak (after which it falls by 5 %), and its rate between 30 and
    70 % of that, from a straight line."""

    def __init__(self, time, force):
        self.stress = TENSION_OF_FORCE * force
        highest = np.maximum.accumulate(self.stress)
        fallen = (self.stress < 0.95 * highest) & (highest > 0.2 * highest[-1])
        if not fallen.any() or highest[-1] <= 0:
            sys.exit(f"P2 has not come to a peak: it is known until "
                     f"{1e6 * time[-1]:.0f} us at the disc, which is "
                     f"{1e6 * GAUGE / SPEED:.0f} us before the end of the run. "
                     "Take a later end.")
        end = np.argmax(fallen)
        self.at_peak = np.argmax(self.stress[:end])
        self.peak, self.peak_time = self.stress[self.at_peak], time[self.at_peak]
        self.start = time[self.rising(0.05)]
        part = slice(self.rising(0.3), self.rising(0.7))
        self.rate = np.polyfit(time[part], self.stress[part], 1)[0]

    def rising(self, share):
        """Index at which the stress has come to this share of the peak for good."""
        below = self.stress[:self.at_peak] < share * self.peak
        return np.flatnonzero(below)[-1] + 1

    def mean_rate(self):
        return self.peak / (self.peak_time - self.start)


class Balance:
    """P1/P2 over time from a tenth of the first peak of P2 on; elsewhere nan."""

    def __init__(self, forces, disc):
        from_tenth = disc.rising(0.1)
        self.ratio = np.full(len(forces[0]), np.nan)
        self.ratio[from_tenth:] = forces[0][from_tenth:] / forces[1][from_tenth:]
        self.at_half = self.ratio[disc.rising(0.5)]
        self.at_peak = self.ratio[disc.at_peak]
        until = slice(from_tenth, disc.at_peak)
        self.mean = (np.abs(forces[0] - forces[1])[until].mean() /
                     forces[1][until].mean())


def print_table(pulse, disc, balance, summary):
    rise, plateau, fall = MEASURED_PULSE[1]
    rows = [("incident stress, MPa", f"{1e-6 * pulse.height:.1f}",
             f"{1e-6 * MEASURED_PULSE[0]:.0f}"),
            ("its rise, us", f"{1e6 * pulse.rise:.1f}", f"{1e6 * rise:.0f}")]
    if pulse.duration:
        rows += [("its duration at half height, us", f"{1e6 * pulse.duration:.1f}",
                  f"{1e6 * (plateau + 0.5 * (rise + fall)):.0f}")]
    if pulse.fall:
        rows += [("its fall, us", f"{1e6 * pulse.fall:.1f}", f"{1e6 * fall:.0f}")]
    rows += [
        ("first peak of 2 P2/(pi D t), MPa", f"{1e-6 * disc.peak:.1f}",
         f"{1e-6 * MEASURED_PEAK:.1f}"),
        ("its time, us", f"{1e6 * disc.peak_time:.1f}", ""),
        ("P1/P2 at half of the peak, on the way up", f"{balance.at_half:.2f}", ""),
        ("P1/P2 at the peak", f"{balance.at_peak:.2f}", ""),
        ("rate of 2 P2/(pi D t), 30 to 70 % of the peak, GPa/s",
         f"{1e-9 * disc.rate:.0f}", f"{1e-9 * MEASURED_RATE:.0f}"),
        ("the peak over the time since 5 % of it, GPa/s",
         f"{1e-9 * disc.mean_rate():.0f}", ""),
        ("mean of |P1 - P2| over that of P2, from 10 % of the peak on",
         f"{balance.mean:.2f}", ""),
        ("residual of the ledger", f"{summary['energy_residual_relative']:.1e}", ""),
        ("cells, steps, wall time", f"{summary['cells']}, {summary['steps']}, "
         f"{summary['wall_seconds']:.0f} s", "")]
    print("| | rift | measured |\n|---|---|---|")
    for row in rows:
        print("| " + " | ".join(row) + " |")


def plot_waves(axes, waves, pulse):
    time = 1e6 * waves.time
    for wave, name in ((waves.incident, "incident"), (waves.reflected, "reflected"),
                       (waves.transmitted, "transmitted")):
        axes.plot(time, 1e-6 * wave, label=name)
    rise, plateau, fall = MEASURED_PULSE[1]
    # Laid so that both pass half of their height together.
    start = pulse.half_time + GAUGE / SPEED - rise / 2
    axes.plot(1e6 * (start + np.cumsum([0, rise, plateau, fall])),
              1e-6 * MEASURED_PULSE[0] * np.array([0, 1, 1, 0]), "k:",
              label="incident, measured")
    axes.set(title="waves at the faces of the disc", xlabel="time (us)",
             ylabel="compressive stress in the bars (MPa)",
             xlim=(1e6 * start - 20, time[-1]))


def plot_forces(axes, waves, disc, balance):
    time = 1e6 * waves.time
    for force, name in zip(waves.forces(),
                           ("P1, incident bar", "P2, transmission bar")):
        axes.plot(time, 1e-6 * TENSION_OF_FORCE * force, label=name)
    axes.plot([], [], "C2", linewidth=0.9, label="P1/P2 (right scale)")
    ratio = axes.twinx()
    ratio.plot(time, balance.ratio, "C2", linewidth=0.9)
    ratio.axhline(1, color="C2", linestyle=":", linewidth=0.9)
    ratio.set(ylim=(0, 4), ylabel="P1/P2")
    axes.axhline(1e-6 * MEASURED_PEAK, color="k", linestyle=":",
                 label="measured peak")
    axes.set(title="2 P/(pi D t)", xlabel="time (us)",
             ylabel="indirect tensile stress (MPa)",
             xlim=(1e6 * disc.peak_time - 60, time[-1]))


def plot_cracks(axes, results, time):
    """Faces open by more than OPENING at the state nearest to a time, seen along
    the axis of the disc."""
    files = read_series(results, "fracture")
    nearest = min(files, key=lambda t: abs(t - time))
    for file in files[nearest]:
        for points, faces, at_points, fields in read_vtu(file):
            is_open = fields["opening [m]"] > OPENING
            corners = deformed(points, at_points)[faces[is_open]]
            for x, y, _ in 1e3 * corners.transpose(0, 2, 1):
                axes.fill(x, y, facecolor="C3", edgecolor="C3", linewidth=0.7,
                          alpha=0.4)
    angle = np.linspace(0, 2 * np.pi, 200)
    axes.plot(500 * DIAMETER * np.cos(angle), 500 * DIAMETER * np.sin(angle), "k",
              linewidth=0.8)
    axes.set(title=f"open by > 10 um at {1e6 * nearest:.0f} us", aspect="equal",
             xlabel="x (mm)", ylabel="y (mm)")


def main(results, figure):
    waves = Waves(results)
    pulse = Pulse(waves.gauge_time, waves.pulse)
    forces = waves.forces()
    disc = Disc(waves.time, forces[1])
    balance = Balance(forces, disc)
    summary = read_summary(results)
    print_table(pulse, disc, balance, summary)

    with_cracks = os.path.exists(f"{results}/fracture.pvd")
    n_rows = 2 if with_cracks else 1
    plots, axes = plt.subplots(n_rows, 2, figsize=(10, 3.8 * n_rows),
                               layout="constrained")
    axes = axes.ravel()
    plot_waves(axes[0], waves, pulse)
    plot_forces(axes[1], waves, disc, balance)
    for curves in axes[:2]:
        curves.grid(alpha=.3)
        curves.legend(fontsize=8, loc="upper left")
    if with_cracks:
        plot_cracks(axes[2], results, disc.peak_time)
        plot_cracks(axes[3], results, summary["time"])
    plots.savefig(figure, dpi=80)


main(sys.argv[1], sys.argv[2])
