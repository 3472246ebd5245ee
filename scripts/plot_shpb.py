#!/usr/bin/env python3
"""Three-wave analysis of a run of prm/brazilian/shpb.prm: the incident pulse, the
forces on both sides of the disc, its indirect tensile stress and loading rate.
Prints them as a table in Markdown and plots them.

usage: scripts/plot_shpb.py RESULTS FIGURE.png
"""
import sys

if len(sys.argv) != 3:
    sys.exit(__doc__)

from rift_output import import_pyplot, np, read_summary, read_table

plt = import_pyplot()

# As in shpb.geo and shpb.prm.
MODULUS, DENSITY = 210e9, 7850
AREA = np.pi / 4 * 0.022**2
DIAMETER, THICKNESS = 0.0408, 0.016
GAUGE = 0.3
SPEED = np.sqrt(MODULUS / DENSITY)
TENSION_OF_FORCE = 2 / (np.pi * DIAMETER * THICKNESS)
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
    """Height, rise, plateau and fall of the trapezoid that has the mean stress in
    the middle of the pulse, and its times at 10 and 90 % of it."""

    def __init__(self, time, stress):
        half = np.flatnonzero(stress > 0.5 * stress.max())
        first, last = half[0], half[-1]
        fifth = (last - first) // 5
        self.height = stress[first + 2 * fifth:last - fifth].mean()
        up, down = [[crossing(time, stress, level * self.height, after)
                     for level in (0.1, 0.5, 0.9)] for after in
                    (0, (first + last) // 2)]
        self.rise = (up[2] - up[0]) / 0.8
        self.fall = (down[0] - down[2]) / 0.8
        self.duration = down[1] - up[1]
        self.plateau = self.duration - 0.5 * (self.rise + self.fall)
        self.half_time = up[1]


class Disc:
    """Indirect tensile stress, Pa, of the force on one side, its first peak (after
    which it falls by 5 %), and its rate between 30 and 70 % of that, from a
    straight line."""

    def __init__(self, time, force):
        self.stress = TENSION_OF_FORCE * force
        highest = np.maximum.accumulate(self.stress)
        fallen = (self.stress < 0.95 * highest) & (highest > 0.2 * highest[-1])
        end = np.argmax(fallen) if fallen.any() else len(time)
        at_peak = np.argmax(self.stress[:end])
        self.peak, self.peak_time = self.stress[at_peak], time[at_peak]
        self.start = time[np.argmax(self.stress > 0.05 * self.peak)]
        rising = np.flatnonzero(self.stress[:at_peak] < 0.3 * self.peak)[-1] + 1
        end = rising + np.argmax(self.stress[rising:] > 0.7 * self.peak)
        self.rate = np.polyfit(time[rising:end], self.stress[rising:end], 1)[0]

    def mean_rate(self):
        return self.peak / (self.peak_time - self.start)


def print_table(pulse, incident_side, transmission_side, imbalance, summary):
    print("| | rift | measured |")
    print("|---|---|---|")
    rows = (
        ("incident stress, MPa", f"{1e-6 * pulse.height:.1f}",
         f"{1e-6 * MEASURED_PULSE[0]:.0f}"),
        ("its rise, plateau, fall, us",
         ", ".join(f"{1e6 * t:.0f}" for t in (pulse.rise, pulse.plateau, pulse.fall)),
         ", ".join(f"{1e6 * t:.0f}" for t in MEASURED_PULSE[1])),
        ("its duration at half height, us", f"{1e6 * pulse.duration:.1f}", ""),
        ("peak of 2 P/(pi D t), transmission bar, MPa",
         f"{1e-6 * transmission_side.peak:.1f}", f"{1e-6 * MEASURED_PEAK:.1f}"),
        ("the same, incident bar, MPa", f"{1e-6 * incident_side.peak:.1f}", ""),
        ("rate between 30 and 70 % of the peak, transmission bar, GPa/s",
         f"{1e-9 * transmission_side.rate:.0f}", f"{1e-9 * MEASURED_RATE:.0f}"),
        ("peak over the time since a twentieth of it, transmission bar, GPa/s",
         f"{1e-9 * transmission_side.mean_rate():.0f}", ""),
        ("mean |P1 - P2| over mean P2 until the peak", f"{imbalance:.3f}", ""),
        ("residual of the ledger", f"{summary['energy_residual_relative']:.1e}", ""),
        ("cells, steps, wall time", f"{summary['cells']}, {summary['steps']}, "
         f"{summary['wall_seconds']:.0f} s", ""))
    for row in rows:
        print("| " + " | ".join(row) + " |")


def main(results, figure):
    waves = Waves(results)
    pulse = Pulse(waves.gauge_time, waves.pulse)
    forces = waves.forces()
    sides = [Disc(waves.time, force) for force in forces]
    # From a tenth of the peak on.
    until = (waves.time < sides[1].peak_time) & (sides[1].stress > 0.1 * sides[1].peak)
    imbalance = (np.abs(forces[0] - forces[1])[until].mean() / forces[1][until].mean())
    print_table(pulse, *sides, imbalance, read_summary(results))

    time = 1e6 * waves.time
    _, (left, right) = plt.subplots(1, 2, figsize=(11, 3.8), layout="constrained")
    for wave, name in ((waves.incident, "incident"), (waves.reflected, "reflected"),
                       (waves.transmitted, "transmitted")):
        left.plot(time, 1e-6 * wave, label=name)
    rise, plateau, fall = MEASURED_PULSE[1]
    # Laid so that both pass half of their height together.
    start = pulse.half_time + GAUGE / SPEED - rise / 2
    left.plot(1e6 * (start + np.cumsum([0, rise, plateau, fall])),
              1e-6 * MEASURED_PULSE[0] * np.array([0, 1, 1, 0]), "k:",
              label="incident, measured")
    left.set(title="waves at the faces of the disc", xlabel="time (us)",
             ylabel="compressive stress in the bars (MPa)")
    for side, name in zip(sides, ("P1, incident bar", "P2, transmission bar")):
        right.plot(time, 1e-6 * side.stress, label=name)
    right.axhline(1e-6 * MEASURED_PEAK, color="k", linestyle=":",
                  label="measured peak")
    right.set(title="2 P/(pi D t)", xlabel="time (us)",
              ylabel="indirect tensile stress (MPa)",
              xlim=(1e6 * sides[1].peak_time - 60, time[-1]))
    for axes in left, right:
        axes.grid(alpha=.3)
        axes.legend(fontsize=8)
    plt.savefig(figure, dpi=90)


main(sys.argv[1], sys.argv[2])
