"""Figures and tables from the measured rows."""
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

QUANTITIES = {"velocity_error": "velocity", "stress_error": "stress",
              "arrival_error": "arrival"}

# A row of the table is for the first of these that the reference model reaches; the
# second table is for a velocity error that stiff penalties reach, too.
LEVELS = (0.01, 0.02, 0.05, 0.1)
LARGE_LEVEL = 0.05
REFERENCE = "extrinsic"

BEGIN = "<!-- Written by tests/benchmarks/time_against_error.py: -->"
END = "<!-- until here -->"


def curve(rows, problem, model, quantity):
    """Sizes, errors, seconds, cell-steps, from the coarsest mesh on; without runs
    in which the wave has not arrived."""
    chosen = sorted((r for r in rows if r["problem"] == problem
                     and r["model"] == model and np.isfinite(r[quantity])),
                    key=lambda r: -r["element_size"])
    return [np.array([abs(r[name]) if name == quantity else r[name] for r in chosen])
            for name in ("element_size", quantity, "loop_seconds", "cell_steps")]


def cost_at(level, errors, costs):
    """Where the error falls below the level for good, between two meshes by a
    straight line in logarithms: None if it does not, the cost of the coarsest mesh
    if that is good enough."""
    above = np.nonzero(errors > level)[0]
    if len(above) == 0:
        return costs[0] if len(errors) else None
    i = above[-1]
    if i == len(errors) - 1:
        return None
    share = np.log(errors[i] / level) / np.log(errors[i] / errors[i + 1])
    return costs[i] * (costs[i + 1] / costs[i])**share


def percent(error):
    return f"{100 * error:.0f} %" if error >= 0.1 else f"{100 * error:.2g} %"


def count_text(number):
    if number >= 1e9:
        return f"{number / 1e9:.3g} G"
    return f"{number / 1e6:.3g} M" if number >= 1e6 else f"{number / 1e3:.3g} k"


def table_entry(level, measured, reference_seconds):
    _, errors, seconds, cell_steps = measured
    if len(errors) == 0:
        return "-"
    time = cost_at(level, errors, seconds)
    if time is None:
        return f"not below {percent(errors.min())}"
    at_most = "<= " if errors[0] <= level else ""
    return (f"{at_most}{time:.2g} s ({time / reference_seconds:.3g}), "
            f"{count_text(cost_at(level, errors, cell_steps))}")


def cost_table(rows, cases, models, levels, quantities):
    lines = ["| problem | error of | " + " | ".join(models) + " |",
             "|---|---|" + "---|" * len(models)]
    for name, problem in cases.items():
        for quantity, title in quantities.items():
            _, errors, seconds, _ = curve(rows, name, REFERENCE, quantity)
            costs = {level: cost_at(level, errors, seconds) for level in levels}
            reached = [level for level, cost in costs.items() if cost is not None]
            if not reached:
                continue
            level = reached[0]
            entries = [table_entry(level, curve(rows, name, model, quantity),
                                   costs[level]) for model in models]
            lines.append(f"| {problem.title} | {title}, {100 * level:g} % | "
                         + " | ".join(entries) + " |")
    return lines


def order_table(rows, cases, models):
    """Errors on the finest mesh of each model, and orders of the reference."""
    others = [m for m in models if m.startswith("intrinsic")]
    header = ["problem", "cells", *(f"{t}, order" for t in QUANTITIES.values()),
              *(f"velocity, {m}" for m in others)]
    lines = ["| " + " | ".join(header) + " |", "|---" * len(header) + "|"]
    for name, problem in cases.items():
        mine = [r for r in rows if r["problem"] == name and r["model"] == REFERENCE]
        if not mine:
            continue
        entries = [problem.title, f"{max(r['cells'] for r in mine):,.0f}"]
        for quantity in QUANTITIES:
            sizes, errors, _, _ = curve(rows, name, REFERENCE, quantity)
            order = np.polyfit(np.log(sizes), np.log(errors), 1)[0]
            entries.append(f"{percent(errors[-1])}, {order:.1f}")
        for model in others:
            errors = curve(rows, name, model, "velocity_error")[1]
            entries.append(percent(errors[-1]) if len(errors) else "-")
        lines.append("| " + " | ".join(entries) + " |")
    return lines


def draw(rows, cases, models, path):
    plt.rcParams.update({"font.size": 8, "axes.grid": True, "grid.alpha": 0.3})
    figure, axes = plt.subplots(len(cases), len(QUANTITIES), sharex=True,
                                figsize=(9.5, 2.1 * len(cases)), squeeze=False)
    for line, (name, problem) in zip(axes, cases.items()):
        for axis, (quantity, title) in zip(line, QUANTITIES.items()):
            for i, model in enumerate(models):
                _, errors, seconds, _ = curve(rows, name, model, quantity)
                if len(errors):
                    axis.loglog(seconds, errors, "o-", color=f"C{i}", markersize=3,
                                linewidth=1, label=model)
            axis.set_title(f"{problem.title}: {title}", fontsize=8)
        line[0].set_ylabel("relative error")
    for axis in axes[-1]:
        axis.set_xlabel("time of the steps (s)")
    handles = axes[0, 0].get_legend_handles_labels()
    figure.legend(*handles, loc="upper center", ncol=len(models), fontsize=8)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.25 / figure.get_figheight()))
    figure.savefig(path, dpi=90)
    plt.close(figure)


def write(rows, cases, models, remarks, folder):
    models = [m for m in models if any(r["model"] == m for r in rows)]
    cases = {name: problem for name, problem in cases.items()
             if any(r["problem"] == name for r in rows)}
    draw(rows, cases, models, os.path.join(folder, "images", "time_against_error.png"))
    path = os.path.join(folder, "time_against_error.md")
    with open(path) as file:
        text = file.read()
    before, after = text.index(BEGIN) + len(BEGIN), text.index(END)
    lines = [
        "", *cost_table(rows, cases, models, LEVELS, QUANTITIES), "",
        "Seconds of the loop over the steps (as many times those of the extrinsic "
        "model), cell-steps. *Not below*: on no mesh, the smallest error is given; "
        "*<=*: the coarsest mesh is good enough.", "",
        "The same for a larger error, to which stiff penalties come:", "",
        *cost_table(rows, cases, models, (LARGE_LEVEL,),
                    {"velocity_error": QUANTITIES["velocity_error"]}), "",
        *order_table(rows, cases, models), "",
        f"Errors of the {REFERENCE} model on its finest mesh, whose cells are "
        "counted, and their orders over all meshes; errors of the intrinsic model on "
        "its finest mesh.", "", *remarks, ""]
    with open(path, "w") as file:
        file.write(text[:before] + "\n".join(lines) + text[after:])
