"""Reads what rift writes, for the other scripts."""
import csv
import struct
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np


def read_table(path):
    """{header: values} of a .csv."""
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


def read_fields(element, appended):
    """{name: values}, a row for each point or cell where there are several."""
    fields = {}
    for array in element:
        values = read_array(array, appended)
        n_components = int(array.get("NumberOfComponents", 1))
        fields[array.get("Name")] = (values if n_components == 1 else
                                     values.reshape(-1, n_components))
    return fields


def read_vtu(path):
    """Of each piece of one file: points, points of each cell, fields at points,
    fields of cells."""
    with open(path, "rb") as file:
        content = file.read()
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
