"""One run of rift and its errors against the closed solution."""
import glob
import json
import os
import shutil
import subprocess
import sys

import numpy as np

sys.path.append(os.path.join(os.path.dirname(__file__), "..", "..", "..", "scripts"))
from rift_output import read_table, read_vtu  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))

# Rows of the histories until the end of a run.
N_ROWS = 400

# What is not part of the loop over the steps.
NOT_COUNTED = ("setup", "ledger and output")

# Seconds in which a program is not always left alone.
LONG = 0.02


def call(command):
    """Runs a program; what it says is shown only if it fails."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\nfailed with {done.returncode}:\n"
                 f"{done.stdout[-3000:]}")


def make_mesh(problem, size, path):
    """As rift meshes: the worst cells are improved first."""
    script = path[:-4] + ".geo"
    with open(script, "w") as file:
        file.write(f'Include "{HERE}/{problem.geo}";\nMesh 3;\n'
                   'Mesh.OptimizeThreshold = 0.5;\nOptimizeMesh "Gmsh";\n'
                   'Mesh.OptimizeThreshold = 0.7;\nOptimizeMesh "Gmsh";\n'
                   f'Save "{path}";\n')
    numbers = {"element_size": size, **problem.mesh_numbers}
    settings = [text for name, number in numbers.items()
                for text in ("-setnumber", name, f"{number:.16g}")]
    call(["gmsh", script, "-nt", "1", *settings, "-"])


def write_scene(problem, mesh, model, path, time_step="auto"):
    """The scene with the entries that the cohesive model adds."""
    direction, point = problem.probe_direction, problem.probe
    sections = {
        "Mesh": {"File": os.path.basename(mesh)}, **problem.sections,
        "Time": {"End time": f"{problem.end_time:.16g}", "Time step": time_step},
        "Output": {"Solution interval": f"{problem.end_time:.16g}",
                   "History interval": f"{problem.end_time / N_ROWS:.16g}",
                   "Overwrite": "true"}}
    for d, axis in enumerate("xyz"):
        if direction[d] != 0:
            sections[f"Probe {axis}"] = {
                "Field": f"velocity {axis}",
                "Point": ", ".join(f"{x:.16g}" for x in point)}
    for section, entries in model.items():
        sections[section] = {**sections.get(section, {}), **entries}
    with open(path, "w") as file:
        for section, entries in sections.items():
            lines = "".join(f"  set {k} = {v}\n" for k, v in entries.items())
            file.write(f"subsection {section}\n{lines}end\n")


def run(rift, scene):
    """Runs it, and returns the folder of its results, its summary, and which part
    of the time in which it could run it had a processor (Linux)."""
    results = scene[:-4]
    shutil.rmtree(results, ignore_errors=True)
    with open(scene[:-4] + ".log", "w") as log:
        process = subprocess.Popen([rift, scene, "--output", results], stdout=log,
                                   stderr=subprocess.STDOUT)
        os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
        with open(f"/proc/{process.pid}/schedstat") as file:
            running, waiting = [int(text) for text in file.read().split()[:2]]
    if process.wait() != 0:
        sys.exit(f"{rift} {scene} has failed: see {log.name}")
    with open(os.path.join(results, "summary.json")) as file:
        return results, json.load(file), running / (running + waiting)


def loop_seconds(summary):
    """Wall time of the loop over the steps without ledger and output, s."""
    return sum(seconds for stage, seconds in summary["wall_seconds_by_stage"].items()
               if stage not in NOT_COUNTED)


def best_time(runs):
    """Of the same case, from its wall times and parts of the time with a processor:
    the least time, or for a long loop, in which other programs are bound to have had
    their turns, the median of the times with a processor."""
    walls, shares = np.array(runs).T
    return walls.min() if walls.min() < LONG else np.median(walls * shares)


def relative_error(values, exact, weights):
    """In the L2 norm, over that of the exact field."""
    def square(field):
        return weights @ (field**2).sum(axis=1)
    return np.sqrt(square(values - exact) / square(exact))


def field_errors(problem, results):
    """Of velocities at nodes, with lumped volumes, and of stresses of cells, at
    their centres, at the end."""
    last = sorted(glob.glob(os.path.join(results, "solid-*.vtu")))[-1]
    (points, cells, at_points, at_cells), = read_vtu(last)
    t = problem.end_time
    corners = points[cells]
    edges = corners[:, 1:] - corners[:, :1]
    volumes = np.linalg.det(edges) / 6
    shares = np.bincount(cells.ravel(), np.repeat(volumes / 4, 4), len(points))
    nodes = problem.counts(points, t)
    velocity = relative_error(at_points["velocity [m/s]"][nodes],
                              problem.velocity(points[nodes], t), shares[nodes])
    centres = corners.mean(axis=1)
    inside = problem.counts(centres, t)
    # Shear stresses stand for two components of the tensor.
    twice = np.sqrt([1, 1, 1, 2, 2, 2])
    stress = relative_error(at_cells["stress [Pa]"][inside] * twice,
                            problem.stress(centres[inside], t) * twice,
                            volumes[inside])
    return velocity, stress


def crossing(time, values, level):
    """When rising values first reach a level; not a number if they do not."""
    after = np.argmax(values >= level)
    if values[after] < level:
        return np.nan
    before = after - 1
    return np.interp(level, values[[before, after]], time[[before, after]])


def velocity_at_probe(problem, results):
    """Times and velocities along the problem's direction."""
    probes = read_table(os.path.join(results, "probes.csv"))
    values = sum(problem.probe_direction[d] * probes[f"{axis} [m/s]"]
                 for d, axis in enumerate("xyz") if f"{axis} [m/s]" in probes)
    return probes["time [s]"], values


def arrival_error(problem, results):
    """How much later (+) than in theory the velocity at the probe reaches half of
    the largest exact value, over the time of travel."""
    measured_time, values = velocity_at_probe(problem, results)
    time = np.linspace(0, problem.end_time, 20 * N_ROWS)
    exact = problem.velocity(np.array([problem.probe]), time) @ problem.probe_direction
    half = 0.5 * exact.max()
    late = crossing(measured_time, values, half) - crossing(time, exact, half)
    return late / problem.travel_time


def fitted_delay(time, values, exact):
    """By how much later `exact` fits the values best (least squares), s; for delays
    that are short beside the pulse."""
    slope = np.gradient(exact, time)
    return -slope @ (values - exact) / (slope @ slope)
