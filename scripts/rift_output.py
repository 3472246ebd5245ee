"""Reads what rift writes, for the other scripts. They end with one line on
stderr where a package or a file is missing."""
import csv
import importlib
import json
import os
import struct
import sys
import xml.etree.ElementTree as ElementTree
import zlib


def import_or_exit(module, package):
    try:
        return importlib.import_module(module)
    except ImportError:
        sys.exit(f"{sys.argv[0]} needs the package {package}; "
                 f"try /usr/bin/python3 {sys.argv[0]} ...")


np = import_or_exit("numpy", "python3-numpy")


def import_pyplot():
    """matplotlib.pyplot, which is to draw into files."""
    import_or_exit("matplotlib", "python3-matplotlib").use("Agg")
    return importlib.import_module("matplotlib.pyplot")


def read_bytes(path):
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError as error:
        sys.exit(f"{sys.argv[0]}: cannot read {path}: {error.strerror}")


def read_summary(results):
    return json.loads(read_bytes(os.path.join(results, "summary.json")))


def read_series(results, name):
    """{time: paths of the files of that state} of a .pvd."""
    series = ElementTree.fromstring(read_bytes(os.path.join(results, name + ".pvd")))
    files = {}
    for entry in series.iter("DataSet"):
        files.setdefault(float(entry.get("timestep")), []).append(
            os.path.join(results, entry.get("file")))
    return files


def read_table(path):
    """{header: values} of a .csv."""
    rows = list(csv.reader(read_bytes(path).decode().splitlines()))
    if len(rows) < 2:
        sys.exit(f"{path} has no rows: the run has been stopped before it wrote any")
    try:
        if any(len(row) != len(rows[0]) for row in rows):
            raise ValueError
        values = np.array(rows[1:], dtype=float)
    except ValueError:
        sys.exit(f"{path} is damaged: not all of its rows are {len(rows[0])} numbers")
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


def read_fields(element, appended):
    """{name: values}, a row for each point or cell where there are several."""
    fields = {}
    for array in element:
        values = read_array(array, appended)
        n_components = int(array.get("NumberOfComponents", 1))
        fields[array.get("Name")] = (values if n_components == 1 else
                                     values.reshape(-1, n_components))
    return fields


def deformed(points, at_points):
    """Where the points of the undeformed body are now."""
    return points + at_points["displacement [m]"].astype(float)


def read_vtu(path):
    """Of each piece of one file: points in the undeformed body, points of each
    cell, fields at points, fields of cells."""
    content = read_bytes(path)
    start = content.index(b"<AppendedData")
    pieces = ElementTree.fromstring(content[:start] + b"</VTKFile>").iter("Piece")
    appended = content[content.index(b"_", start) + 1:]
    result = []
    for piece in pieces:
        points = read_array(piece.find("Points/DataArray"), appended).reshape(-1, 3)
        cells = {a.get("Name"): a for a in piece.find("Cells")}
        offsets = read_array(cells["offsets"], appended)
        corners = read_array(cells["connectivity"], appended)
        n_corners = offsets[0] if len(offsets) else 1
        result.append((points, corners.reshape(-1, n_corners),
                       read_fields(piece.find("PointData"), appended),
                       read_fields(piece.find("CellData"), appended)))
    return result
