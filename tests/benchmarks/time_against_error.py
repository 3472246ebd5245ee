#!/usr/bin/env python3
"""Run time against error: problems with a closed solution, on meshes of several
sizes, without cohesive elements, with the extrinsic and with the intrinsic model.

Writes WORK/time_against_error.csv; runs that are in it already are not made again,
so that the program can be stopped and called again. With --doc, draws the figure, puts
the tables between the markers of DOC/time_against_error.md, and copies the .csv there.

Needs gmsh and, for Python, numpy and matplotlib.
"""
import argparse
import csv
import os
import shutil
import time

from errors import measure, problems, report

# So strong that nothing softens: stresses are about 1 MPa.
STRONG = {"Tensile strength": 1e9, "Cohesion": 1e9,
          "Fracture energy I": 1e6, "Fracture energy II": 1e6}


def intrinsic(penalty):
    return {"Fracture": {"Cohesive model": "intrinsic",
                         "Cohesive penalty": f"{penalty} E"},
            "Material rock": STRONG}


# What each model adds to a scene.
MODELS = {"none": {},
          "extrinsic": {"Fracture": {"Cohesive model": "extrinsic",
                                     "Cohesive law": "faces"},
                        "Material rock": STRONG},
          **{f"intrinsic {p}E": intrinsic(p) for p in (1, 5, 10, 50, 100, 1000)}}

COLUMNS = ("problem", "model", "element_size", "cells", "steps", "time_step",
           "cell_steps", "loop_seconds", "runs", "velocity_error", "stress_error",
           "arrival_error")


def read_rows(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="") as file:
        return [{name: text if name in ("problem", "model") else float(text)
                 for name, text in row.items()} for row in csv.DictReader(file)]


def append_row(path, row):
    is_new = not os.path.exists(path)
    with open(path, "a", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        if is_new:
            writer.writeheader()
        writer.writerow({name: f"{value:.6g}" if isinstance(value, float) else value
                         for name, value in row.items()})


def expected_seconds(rows, row):
    """From the next larger elements of the same problem and model."""
    same = [r for r in rows if r["problem"] == row["problem"]
            and r["model"] == row["model"]]
    if not same:
        return 0
    last = min(same, key=lambda r: r["element_size"])
    return last["loop_seconds"] * (last["element_size"] / row["element_size"])**4


def measure_one(arguments, problem, mesh, model, size):
    """Runs a case, a short one several times."""
    scene = os.path.join(arguments.work, f"{problem.name}.prm")
    measure.write_scene(problem, mesh, MODELS[model], scene)
    runs, start = [], time.monotonic()
    while not runs or (len(runs) < arguments.repetitions
                       and time.monotonic() - start < arguments.repeat_for):
        results, summary, share = measure.run(arguments.rift, scene)
        runs.append((measure.loop_seconds(summary), share))
    velocity, stress = measure.field_errors(problem, results)
    return {"problem": problem.name, "model": model, "element_size": size,
            "cells": summary["cells"], "steps": summary["steps"],
            "time_step": summary["time_step"],
            "cell_steps": summary["cells"] * summary["steps"],
            "loop_seconds": float(measure.best_time(runs)), "runs": len(runs),
            "velocity_error": velocity, "stress_error": stress,
            "arrival_error": measure.arrival_error(problem, results)}


def measure_size(arguments, problem, size, rows, table):
    """All models on one mesh, one after another, so that all have their share of
    what else the machine does."""
    done = {(r["problem"], r["model"], r["element_size"]) for r in rows}
    mesh = os.path.join(arguments.work, f"{problem.name}.msh")
    has_mesh = False
    for model in arguments.models:
        row = {"problem": problem.name, "model": model, "element_size": size}
        if (problem.name, model, size) in done:
            continue
        expected = expected_seconds(rows, row)
        if expected > arguments.longest:
            print(f"{problem.name}, {model}, {1e3 * size:g} mm: left out, would take "
                  f"about {expected:.0f} s", flush=True)
            continue
        if not has_mesh:
            measure.make_mesh(problem, size, mesh)
            has_mesh = True
        row = measure_one(arguments, problem, mesh, model, size)
        rows.append(row)
        append_row(table, row)
        print(f"{problem.name}, {model}, {1e3 * size:g} mm: {row['cells']} cells, "
              f"{row['steps']} steps, {row['loop_seconds']:.3g} s; errors: velocity "
              f"{row['velocity_error']:.2%}, stress {row['stress_error']:.2%}, "
              f"arrival {row['arrival_error']:+.2%}", flush=True)


def run_apart(arguments, problem, size, model, time_step="auto"):
    """A run that is not for the table: its folder and its summary."""
    path = os.path.join(arguments.work, f"{problem.name}_apart")
    measure.make_mesh(problem, size, path + ".msh")
    measure.write_scene(problem, path + ".msh", MODELS[model], path + ".prm", time_step)
    return measure.run(arguments.rift, path + ".prm")[:2]


def same_without_insertion(arguments, problem):
    """Says whether the extrinsic model, while it inserts nothing, gives the bits of
    plain finite elements with the same time step."""
    time_step = f"{problem.end_time / 1000:.16g}"
    hashes = [run_apart(arguments, problem, problem.sizes[0], model, time_step)[1]
              ["state_hash"] for model in ("none", "extrinsic")]
    result = "the same bits as" if hashes[0] == hashes[1] else "OTHER BITS THAN"
    return (f"With the same time step ({problem.title}) the extrinsic model, which "
            f"inserts nothing here, gives {result} plain finite elements.")


def rod_speed(arguments, rod):
    """Says how slow a long wave in a rod with free sides is."""
    size = rod.sizes[-1]
    time, values = measure.velocity_at_probe(
        rod, run_apart(arguments, rod, size, "none")[0])
    delay = measure.fitted_delay(time, values, rod.without_dispersion(time))
    return (f"The pulse in the rod, fitted by least squares on a mesh of "
            f"{1e3 * size:g} mm, comes {delay / rod.travel_time:.2%} of its time of "
            "travel later than with sqrt(E/rho); of this, Pochhammer and Chree's first "
            f"correction for its length is {rod.correction():.2%}.")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rift", help="the program")
    parser.add_argument("work", help="a folder for meshes, scenes and results")
    parser.add_argument("--doc", help="where time_against_error.md stands")
    parser.add_argument("--quick", action="store_true", help="three coarse meshes")
    parser.add_argument("--models", nargs="+", choices=MODELS, default=list(MODELS))
    parser.add_argument("--problems", nargs="+", choices=problems.all_problems(),
                        default=list(problems.all_problems()))
    parser.add_argument("--longest", type=float, default=5,
                        help="runs that would take more seconds are left out")
    parser.add_argument("--repetitions", type=int, default=5,
                        help="so often a case is run to find its time...")
    parser.add_argument("--repeat-for", type=float, default=2,
                        help="... but not again after so many seconds")
    arguments = parser.parse_args()
    os.makedirs(arguments.work, exist_ok=True)
    arguments.work = os.path.abspath(arguments.work)
    table = os.path.join(arguments.work, "time_against_error.csv")
    rows = read_rows(table)
    cases = problems.all_problems()
    for name in arguments.problems:
        sizes = cases[name].sizes[:3] if arguments.quick else cases[name].sizes
        for size in sizes:
            measure_size(arguments, cases[name], size, rows, table)
    if arguments.doc:
        remarks = [same_without_insertion(arguments, cases["bar"]), "",
                   rod_speed(arguments, cases["rod"])]
        report.write(rows, cases, list(MODELS), remarks, arguments.doc)
        shutil.copy(table, arguments.doc)


if __name__ == "__main__":
    main()
