#!/usr/bin/env python3
"""Prints the tables of doc/benchmarks.md on scaling, from what
partition_benchmark has counted, and plots them.

usage: scripts/plot_scaling.py PARTS.csv FIGURE.png
"""
import csv
import sys

if len(sys.argv) != 3:
    sys.exit(__doc__)

from rift_output import import_pyplot, np, read_bytes

plt = import_pyplot()

# Of one core, measured: see doc/benchmarks.md.
CELL_STEPS_PER_SECOND = 52.9e6
# Of the network, assumed.
SECONDS_PER_MESSAGE = 2e-6
BYTES_PER_SECOND = 10e9


def read_parts(path):
    """{method: {column: values}}"""
    rows = list(csv.DictReader(read_bytes(path).decode().splitlines()))
    methods = {}
    for row in rows:
        columns = methods.setdefault(row.pop("method"), {})
        for name, value in row.items():
            columns.setdefault(name, []).append(float(value))
    return {m: {n: np.array(v) for n, v in columns.items()}
            for m, columns in methods.items()}


def exchange_time(messages, n_bytes):
    return messages * SECONDS_PER_MESSAGE + n_bytes / BYTES_PER_SECOND


def step_time(cells, parts):
    """Of the slowest rank, which is taken to have the most of everything."""
    return cells / CELL_STEPS_PER_SECOND + exchange_time(parts["messages max"],
                                                         parts["bytes max"])


def strong_efficiency(parts):
    """Time of one rank over that of all ranks together."""
    n_cells = parts["owned mean"] * parts["parts"]
    alone = n_cells / CELL_STEPS_PER_SECOND
    return alone / (parts["parts"] * step_time(parts["visible max"], parts))


def layer_thickness(parts):
    """By how much ghosts widen an inner part, as the number of cells along the
    edge of a cube; of bodies in so many parts that some lie inside."""
    inner = parts["parts"] >= 64
    return np.mean((np.cbrt(parts["visible max"]) - np.cbrt(parts["owned mean"]))[inner])


def weak_scaling(n_owned, parts):
    """Visible over owned cells and efficiency of an inner part of a body of any
    size; messages, and bytes per ghost, as for the most parts."""
    n_visible = (n_owned**(1 / 3) + layer_thickness(parts))**3
    n_bytes = (parts["bytes max"] / parts["ghosts max"])[-1] * (n_visible - n_owned)
    time = n_visible / CELL_STEPS_PER_SECOND + exchange_time(
        parts["messages max"][-1], n_bytes)
    return n_visible / n_owned, n_owned / CELL_STEPS_PER_SECOND / time


def print_strong(name, parts):
    print(f"\n{name}\n| ranks | owned cells | redundancy | imbalance | messages | kB "
          "| step (us) | of it exchange | efficiency | own nodes only |")
    print("|---" * 10 + "|")
    time = step_time(parts["visible max"], parts)
    efficiency = strong_efficiency(parts)
    share = exchange_time(parts["messages max"], parts["bytes max"]) / time
    for i, n in enumerate(parts["parts"]):
        print(f"| {n:.0f} | {parts['owned mean'][i]:,.0f} "
              f"| {parts['redundancy'][i]:.3f} | {parts['imbalance'][i]:.3f} "
              f"| {parts['messages mean'][i]:.1f} / {parts['messages max'][i]:.0f} "
              f"| {parts['bytes mean'][i] / 1e3:.1f} / "
              f"{parts['bytes max'][i] / 1e3:.1f} "
              f"| {1e6 * time[i]:,.0f} | {100 * share[i]:.1f} % "
              f"| {100 * efficiency[i]:.0f} % "
              f"| {parts['redundancy at own nodes'][i]:.3f} |")


def print_weak(methods):
    print("\n| owned cells per rank |" + "".join(
        f" visible / owned, {m} | efficiency, {m} |" for m in methods))
    print("|---" * (1 + 2 * len(methods)) + "|")
    for n in (1e3, 1e4, 3e4, 1e5, 3e5, 1e6):
        line = f"| {n:,.0f} |"
        for parts in methods.values():
            redundancy, efficiency = weak_scaling(n, parts)
            line += f" {redundancy:.2f} | {100 * efficiency:.0f} % |"
        print(line)


def plot(methods, figure):
    plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3})
    plots, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8))
    for i, (name, parts) in enumerate(methods.items()):
        n_owned = parts["owned mean"]
        left.loglog(n_owned, parts["redundancy"] - 1, f"C{i}o-", markersize=3,
                    label=f"{name}, mean")
        left.loglog(n_owned, parts["visible max"] / n_owned - 1, f"C{i}:",
                    label=f"{name}, largest part")
        left.loglog(n_owned, parts["redundancy at own nodes"] - 1, f"C{i}--",
                    linewidth=0.8, label=f"{name}, cells at own nodes only")
        right.semilogx(parts["parts"], 100 * strong_efficiency(parts), f"C{i}o-",
                       markersize=3, label=f"{name}, model")
        right.semilogx(parts["parts"], 100 / parts["redundancy"], f"C{i}--",
                       linewidth=0.8, label=f"{name}, owned / visible cells")
    left.set(xlabel="owned cells per part", ylabel="cells computed twice / owned cells")
    left.legend(fontsize=7)
    right.set(xlabel="ranks", ylabel="efficiency, strong scaling (%)",
              ylim=(0, 102))
    right.set_xscale("log", base=2)
    right.legend(fontsize=8)
    plots.tight_layout()
    plots.savefig(figure, dpi=110)


def main(table, figure):
    methods = read_parts(table)
    for name, parts in methods.items():
        print_strong(name, parts)
    print_weak(methods)
    plot(methods, figure)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
