"""Meshes and scenes of the cases, and one run of rift."""
import itertools
import json
import math
import os
import random
import re
import shutil
import subprocess

# Boundaries of a box.
SIDES = [f"{axis}_{end}" for axis in "xyz" for end in ("min", "max")]


class Mesh:
    """Vertices, cells (numbers of four vertices), named triangles."""

    def __init__(self, vertices, cells, boundaries):
        self.vertices = vertices
        self.cells = cells
        self.boundaries = boundaries

    def volume(self, cell):
        a, b, c, d = (self.vertices[v] for v in cell)
        u, v, w = ([q[i] - a[i] for i in range(3)] for q in (b, c, d))
        return (u[0] * (v[1] * w[2] - v[2] * w[1])
                - u[1] * (v[0] * w[2] - v[2] * w[0])
                + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6

    def centre(self, cell):
        return [sum(self.vertices[v][i] for v in cell) / 4 for i in range(3)]

    def inner_faces(self):
        """Number of faces between two cells."""
        faces = {frozenset(f) for c in self.cells
                 for f in itertools.combinations(c, 3)}
        return 4 * len(self.cells) - len(faces)

    def scaled(self, factor):
        return Mesh([[factor * x for x in v] for v in self.vertices],
                    self.cells, self.boundaries)


def box(numbers, size, jitter=0.15):
    """Cubes of six tetrahedra each. `jitter` of an edge is the largest distance by
    which vertices inside the box are moved at random."""
    rng = random.Random(1)
    h = [size[i] / numbers[i] for i in range(3)]
    at, vertices = {}, []
    for key in itertools.product(*(range(n + 1) for n in numbers)):
        at[key] = len(vertices)
        inside = all(0 < k < n for k, n in zip(key, numbers))
        vertices.append([h[i] * (key[i] + (jitter * rng.uniform(-1, 1) if inside
                                           else 0)) for i in range(3)])
    mesh = Mesh(vertices, [], {side: [] for side in SIDES})
    for origin in itertools.product(*(range(n) for n in numbers)):
        for order in itertools.permutations(range(3)):
            corner = list(origin)
            cell = [at[tuple(corner)]]
            for axis in order:
                corner[axis] += 1
                cell.append(at[tuple(corner)])
            if mesh.volume(cell) < 0:
                cell[2], cell[3] = cell[3], cell[2]
            mesh.cells.append(cell)
    keys = {number: key for key, number in at.items()}
    for cell in mesh.cells:
        for face in itertools.combinations(cell, 3):
            for i, axis in enumerate("xyz"):
                for end, k in (("min", 0), ("max", numbers[i])):
                    if all(keys[v][i] == k for v in face):
                        mesh.boundaries[f"{axis}_{end}"].append(face)
    return mesh


def single_cell(h):
    """A crooked tetrahedron; each of its faces is a boundary."""
    vertices = [[0, 0, 0], [h, 0, .1 * h], [.2 * h, .9 * h, 0], [.3 * h, .2 * h, h]]
    faces = itertools.combinations(range(4), 3)
    return Mesh(vertices, [[0, 1, 2, 3]],
                {f"face_{i}": [face] for i, face in enumerate(faces)})


def squeeze_layer(mesh, height, share):
    """What is above z = height comes down until the layer of cells between there and
    the vertices below it is `share` as high."""
    below = max(v[2] for v in mesh.vertices if v[2] < height * (1 - 1e-9))
    down = (height - below) * (1 - share)
    vertices = [[x, y, z - down if z > height * (1 - 1e-9) else z]
                for x, y, z in mesh.vertices]
    return Mesh(vertices, mesh.cells, mesh.boundaries)


def flatten_cell(mesh, share):
    """Moves a vertex of a cell inside the body to the opposite face until the
    cell is `share` as high; the four corners are then nearly in a plane."""
    on_surface = {v for faces in mesh.boundaries.values() for f in faces for v in f}
    for cell in mesh.cells:
        for apex in (v for v in cell if v not in on_surface):
            base = [v for v in cell if v != apex]
            middle = [sum(mesh.vertices[v][i] for v in base) / 3 for i in range(3)]
            vertices = [list(v) for v in mesh.vertices]
            vertices[apex] = [m + share * (x - m)
                              for m, x in zip(middle, mesh.vertices[apex])]
            result = Mesh(vertices, mesh.cells, mesh.boundaries)
            # Its neighbours must not be turned inside out.
            if all(result.volume(c) > share / 2 * abs(mesh.volume(c))
                   for c in mesh.cells):
                return result
    raise ValueError("no cell can be flattened")


def write_mesh(path, mesh, one_material):
    """MSH 2.2. Either one material `rock` or cell n of material `rock_n`."""
    n_materials = 1 if one_material else len(mesh.cells)
    names = ['3 1 "rock"'] if one_material else [
        f'3 {n + 1} "rock_{n}"' for n in range(n_materials)]
    names += [f'2 {n_materials + 1 + i} "{name}"'
              for i, name in enumerate(mesh.boundaries)]
    elements = []
    for n, cell in enumerate(mesh.cells):
        tag = 1 if one_material else n + 1
        elements.append((4, tag, cell))
    for i, faces in enumerate(mesh.boundaries.values()):
        elements += [(2, n_materials + 1 + i, face) for face in faces]
    with open(path, "w") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
        for section, lines in (
                ("PhysicalNames", names),
                ("Nodes", [f"{i + 1} {x!r} {y!r} {z!r}" for i, (x, y, z) in
                           enumerate(mesh.vertices)]),
                ("Elements", [f"{i + 1} {kind} 2 {tag} {tag} "
                              + " ".join(str(v + 1) for v in corners)
                              for i, (kind, tag, corners) in enumerate(elements)])):
            file.write(f"${section}\n{len(lines)}\n" + "\n".join(lines)
                       + f"\n$End{section}\n")


def scene_text(mesh_name, mesh, material, velocities, sections):
    """`velocities`: of each cell at the start, or nothing."""
    rocks = ({"Material rock": material} if velocities is None else
             {f"Material rock_{n}": {
                 **material, "Initial velocity": ", ".join(f"{x!r}" for x in v)}
              for n, v in enumerate(velocities)})
    everything = {"Mesh": {"File": mesh_name}, **rocks, **sections}
    text = ""
    for section, entries in everything.items():
        lines = "".join(f"  set {k} = {v}\n" for k, v in entries.items())
        text += f"subsection {section}\n{lines}end\n"
    return text


class Run:
    """What has come out of one run."""

    def __init__(self, code, error, results):
        self.code = code
        self.error = error
        self.summary = None
        path = os.path.join(results, "summary.json")
        if code == 0 and os.path.exists(path):
            with open(path) as file:
                self.summary = json.load(file)

    @property
    def is_done(self):
        return self.summary is not None

    @property
    def residual(self):
        """Largest of the ledger, over the energy in play."""
        return self.summary["energy_residual_relative"]

    @property
    def caught_at(self):
        """The step at which the program has stopped the run by itself, with its
        message and exit code; nothing if it has not."""
        text = re.search(r"error: (?:energy runs away: .*|cell .* has \S+ of its "
                         r"volume; below .*)[aA]t step (\d+),", self.error)
        return int(text.group(1)) if text and self.code == 2 else None

    @property
    def hit_guard(self):
        return self.caught_at is not None and "of its volume; below" in self.error

    def describe(self):
        if self.is_done:
            return f"residual {self.residual:.1e}"
        if self.caught_at is not None:
            reason = "volume guard" if self.hit_guard else "ledger"
            return f"stopped at step {self.caught_at} ({reason}), exit code 2"
        return f"exit code {self.code}: {self.error.strip()[:200]}"


class Workshop:
    """Makes the runs, in a folder in which scenes, meshes and results stay."""

    def __init__(self, rift, folder):
        self.rift = os.path.abspath(rift)
        self.folder = os.path.abspath(folder)
        os.makedirs(self.folder, exist_ok=True)

    def write(self, name, mesh, material, sections, velocities=None):
        write_mesh(os.path.join(self.folder, name + ".msh"), mesh,
                   velocities is None)
        path = os.path.join(self.folder, name + ".prm")
        with open(path, "w") as file:
            file.write(scene_text(name + ".msh", mesh, material, velocities,
                                  sections))
        return path

    def call(self, *arguments):
        return subprocess.run([self.rift, *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, cwd=self.folder)

    def run(self, name, mesh, material, sections, velocities=None):
        """`sections` needs Time with an End time."""
        end = float(sections["Time"]["End time"])
        output = {"History interval": f"{end / 50!r}", "Overwrite": "true"}
        scene = self.write(name, mesh, material,
                           {**sections, "Output": output}, velocities)
        results = os.path.join(self.folder, name)
        shutil.rmtree(results, ignore_errors=True)
        done = self.call(scene, "--output", results)
        return Run(done.returncode, done.stderr, results)

    def bound(self, name, mesh, material, sections):
        """Bound of the time step, s, with four digits, from the log."""
        scene = self.write(name, mesh, material, {
            **sections, "Time": {"End time": repr(1e3 * max(map(max, mesh.vertices))),
                                 "Safety factor": "1"}})
        done = self.call("--validate", scene)
        found = re.search(r"Time step (\S+) s, 1 times the bound", done.stdout)
        if found is None:
            raise RuntimeError(f"{name}: no time step:\n{done.stdout}{done.stderr}")
        return float(found.group(1))


def speeds(mesh, size, seed=1):
    """A random velocity for each cell, of components normally distributed."""
    rng = random.Random(seed)
    return [[rng.gauss(0, size) for _ in range(3)] for _ in mesh.cells]


def spin(mesh, edge_speed):
    """Velocities of cells that spin about the axis z through the centre of the box;
    the fastest vertex has `edge_speed`."""
    middle = [(min(v[i] for v in mesh.vertices) + max(v[i] for v in mesh.vertices))
              / 2 for i in range(3)]
    radius = max(math.hypot(v[0] - middle[0], v[1] - middle[1])
                 for v in mesh.vertices)
    omega = edge_speed / radius
    result = []
    for cell in mesh.cells:
        x, y, _ = (c - m for c, m in zip(mesh.centre(cell), middle))
        result.append([-omega * y, omega * x, 0.])
    return result
