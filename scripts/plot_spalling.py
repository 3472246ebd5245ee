#!/usr/bin/env python3
"""Plots a run of prm/spalling: velocity of the free surface, ledger of energy,
damage along the axis; and prints the figures of doc/verification.md.

usage: scripts/plot_spalling.py RESULTS FIGURE.png
"""
import csv
import json
import os
import struct
import sys
import xml.etree.ElementTree as ElementTree
import zlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

# The one-dimensional reference (bar of 1 mm cells, exact fracture energy).
REFERENCE_PEAK = (75.9e-6, 7.73)
REFERENCE_PLANES = ((82e-3, 125e-6), (103e-3, 135e-6))
BIN_WIDTH = 2e-3
RADIUS = 19e-3


def read_table(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    values = np.array(rows[1:], dtype=float)
    return {name: values[:, i] for i, name in enumerate(rows[0])}


def read_array(element, appended):
    """A DataArray as rift writes it: compressed blocks in the appended data."""
    kind = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4"}
    at = int(element.get("offset"))
    n_blocks = struct.unpack_from("<Q", appended, at)[0]
    sizes = struct.unpack_from(f"<{2 + n_blocks}Q", appended, at + 8)[2:]
    data, at = b"", at + 8 * (3 + n_blocks)
    for size in sizes:
        data += zlib.decompress(appended[at:at + size])
        at += size
    return np.frombuffer(data, dtype=kind[element.get("type")])


def read_last_fracture(results):
    """Corners and fields of the cohesive faces at the last time."""
    series = ElementTree.parse(os.path.join(results, "fracture.pvd"))
    entries = sorted(series.iter("DataSet"), key=lambda d: float(d.get("timestep")))
    with open(os.path.join(results, entries[-1].get("file")), "rb") as file:
        content = file.read()
    start = content.index(b"<AppendedData")
    piece = ElementTree.fromstring(content[:start] + b"</VTKFile>").find(".//Piece")
    appended = content[content.index(b"_", start) + 1:]
    points = read_array(piece.find("Points/DataArray"), appended).reshape(-1, 3)
    cells = next(a for a in piece.find("Cells") if a.get("Name") == "connectivity")
    corners = read_array(cells, appended).reshape(-1, 3)
    fields = {a.get("Name"): read_array(a, appended) for a in piece.find("CellData")}
    return points[corners].astype(float), fields


def planes(corners, fields):
    """Macroscopic planes: bins of x whose failed faces, projected on the cross
    section, cover more than half of it; neighbours count as one."""
    failed = fields["time of failure [s]"] >= 0
    area = 0.5 * np.cross(corners[:, 1] - corners[:, 0],
                          corners[:, 2] - corners[:, 0])
    x = corners[:, :, 0].mean(axis=1)
    edges = np.arange(0, 0.18 + BIN_WIDTH, BIN_WIDTH)
    covered, _ = np.histogram(x[failed], edges, weights=np.abs(area[failed, 0]))
    section = np.pi * RADIUS**2
    found, group = [], []
    for i in list(np.nonzero(covered > 0.05 * section)[0]) + [10**6]:
        if group and i > group[-1] + 1:
            inside = failed & (x >= edges[group[0]]) & (x < edges[group[-1] + 1])
            weight = np.abs(area[inside, 0])
            if weight.sum() > 0.5 * section:
                times = np.sort(fields["time of failure [s]"][inside])
                mean = np.average(x[inside], weights=weight)
                spread = np.sqrt(np.average((x[inside] - mean)**2, weights=weight))
                found.append((mean, spread, times[len(times) // 2],
                              weight.sum() / section))
            group = []
        group.append(i)
    return found, edges, covered / section


def main(results, figure):
    probes = read_table(os.path.join(results, "probes.csv"))
    energy = read_table(os.path.join(results, "energy.csv"))
    with open(os.path.join(results, "summary.json")) as file:
        summary = json.load(file)
    corners, fields = read_last_fracture(results)
    found, edges, covered = planes(corners, fields)

    time, fspv = probes["time [s]"], probes["fspv [m/s]"]
    peak = np.argmax(fspv * (time < 100e-6))
    loads = energy["loads [J]"]
    intact = energy["time [s]"] < fields["time of insertion [s]"].min()
    residual = energy["residual [J]"] / loads.max()
    first = np.argmin(fields["time of insertion [s]"])
    print(f"cells {summary['cells']}, step {summary['time_step']:.3e} s, "
          f"{summary['steps']} steps, {summary['wall_seconds']:.1f} s of wall time")
    print(f"FSPV: peak {fspv[peak]:.3f} m/s at {time[peak] * 1e6:.1f} us")
    print(f"first opening: x = {corners[first, :, 0].mean() * 1e3:.1f} mm at "
          f"{fields['time of insertion [s]'][first] * 1e6:.1f} us")
    print(f"faces: {summary['faces_inserted']} cut, {len(corners)} opened, "
          f"{summary['faces_broken']} failed; fragments {summary['fragments']}")
    for mean, spread, when, share in found:
        print(f"plane: x = {mean * 1e3:.1f} mm (spread {spread * 1e3:.1f} mm), "
              f"half of its faces failed at {when * 1e6:.1f} us, failed area "
              f"{share:.2f} of the cross section")
    print(f"energy put in {loads.max():.4f} J; largest residual while intact "
          f"{np.abs(residual[intact]).max():.2e}, at all times "
          f"{np.abs(residual).max():.2e} of it, at the end {residual[-1]:.2e}")

    plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3})
    plots, axes = plt.subplots(3, 1, figsize=(7, 8.4))
    axes[0].plot(time * 1e6, fspv, label="rift")
    axes[0].plot(REFERENCE_PEAK[0] * 1e6, REFERENCE_PEAK[1], "kx",
                 label="peak of the 1-D reference")
    axes[0].set(xlabel="time (us)", ylabel="FSPV (m/s)")
    axes[0].legend()
    for name in ("kinetic", "strain", "cohesive", "fracture", "friction", "loads"):
        axes[1].plot(energy["time [s]"] * 1e6, energy[name + " [J]"], label=name)
    axes[1].plot(energy["time [s]"] * 1e6, 100 * energy["residual [J]"], "k:",
                 label="residual x 100")
    axes[1].set(xlabel="time (us)", ylabel="energy (J)")
    axes[1].legend(ncol=4)
    axes[2].bar(1e3 * edges[:-1], covered, width=1e3 * BIN_WIDTH, align="edge",
                label="failed area")
    opened, _ = np.histogram(corners[:, :, 0].mean(axis=1), edges,
                             weights=fields["damage"])
    axes[2].step(1e3 * edges[:-1], opened / max(opened.max(), 1), where="post",
                 color="C1", label="damage, summed, over its largest")
    for x, _ in REFERENCE_PLANES:
        axes[2].axvline(1e3 * x, color="k", linestyle="--", linewidth=0.8)
    axes[2].plot([], [], "k--", linewidth=0.8, label="planes of the 1-D reference")
    axes[2].set(xlabel="x (mm)", ylabel="share of the cross section")
    axes[2].legend()
    plots.tight_layout()
    plots.savefig(figure, dpi=110)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
