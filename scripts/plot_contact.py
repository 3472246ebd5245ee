#!/usr/bin/env python3
"""Plots where the energy goes in a run of prm/contact, and beside it the number
of fragments, or where nothing breaks the kinetic energy.

usage: scripts/plot_contact.py RESULTS FIGURE.png
"""
import sys

if len(sys.argv) != 3:
    sys.exit(__doc__)

from rift_output import import_pyplot, np, read_series, read_table, read_vtu

plt = import_pyplot()

ENERGIES = ("kinetic", "strain", "contact", "fracture", "friction", "damping",
            "closing")


def count_fragments(files):
    numbers = [cells["fragment"] for file in files
               for _, _, _, cells in read_vtu(file)]
    return len(np.unique(np.concatenate(numbers)))


def main(results, figure):
    table = read_table(f"{results}/energy.csv")
    times = 1e3 * table["time [s]"]
    _, (left, right) = plt.subplots(1, 2, figsize=(11, 3.8), layout="constrained")
    for name in ENERGIES:
        values = table.get(f"{name} [J]")
        if values is not None and values.any():
            left.plot(times, values, label=name)
    left.plot(times, table["residual [J]"], "k:", label="residual")
    left.set(xlabel="time (ms)", ylabel="energy (J)")
    left.legend(fontsize=8)

    if table["fracture [J]"].any():
        series = read_series(results, "solid")
        moments = sorted(series)
        counts = [count_fragments(series[moment]) for moment in moments]
        right.step(1e3 * np.array(moments), counts, where="post")
        right.set(xlabel="time (ms)", ylabel="fragments")
        for moment, count in zip(moments, counts):
            print(f"{moment:.3g} s: {count} fragments")
    else:
        kinetic = table["kinetic [J]"]
        right.semilogy(times[1:], kinetic[1:] / kinetic.max())
        right.set(xlabel="time (ms)", ylabel="kinetic energy over its largest")
    left.grid(alpha=.3)
    right.grid(alpha=.3)
    plt.savefig(figure, dpi=90)


main(sys.argv[1], sys.argv[2])
