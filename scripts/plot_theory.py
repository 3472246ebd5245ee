#!/usr/bin/env python3
"""Draws the figures of doc/theory.md from its formulas, with the granite of
prm/spalling. Numbers in the titles and legends are computed here.

usage: scripts/plot_theory.py DIRECTORY
"""
import os
import sys

if len(sys.argv) != 2:
    sys.exit(__doc__)

from rift_output import import_pyplot, np

plt = import_pyplot()

# The granite of prm/spalling/cylinder.inc.
YOUNGS_MODULUS = 40.6e9
TENSILE_STRENGTH, COHESION = 15e6, 36.7e6
FRICTION = np.tan(np.radians(50))
RESIDUAL_FRICTION = np.tan(np.radians(31))
FRACTURE_ENERGY = 400.
MPA, UM = 1e-6, 1e6


def softening(damage):
    """f(D), eq. 13."""
    a, b, c = .63, 1.8, 6.
    d = np.clip(damage, 0, 1)
    rise = (a + b - 1) / (a + b) * np.exp(d * (a + c * b)
                                          / ((a + b) * (1 - a - b)))
    return (1 - rise) * (a * (1 - d) + b * (1 - d)**c)


SOFTENING_INTEGRAL = .386307294744


def axes(n, **keywords):
    figure, result = plt.subplots(1, n, **keywords)
    for ax in np.atleast_1d(result).flat:
        ax.spines[["top", "right"]].set_visible(False)
    return figure, result


def save(figure, name):
    figure.savefig(os.path.join(sys.argv[1], name), dpi=130)
    plt.close(figure)


# Envelope, eqs. 11, 14, 14a --------------------------------------------------

def shear_limit(normal, f, residual_friction):
    friction = residual_friction + f * (FRICTION - residual_friction)
    return f * COHESION + friction * np.maximum(-normal, 0)


def draw_envelope(ax, residual_friction, title):
    for f, colour in ((1, "C0"), (.5, "C1"), (0, "C3")):
        normal = np.linspace(-60e6, f * TENSILE_STRENGTH, 400)
        limit = shear_limit(normal, f, residual_friction)
        label = {1: "intact, f = 1", 0: "failed, f = 0"}.get(f, f"f = {f}")
        ax.plot(np.append(normal, f * TENSILE_STRENGTH) * MPA,
                np.append(limit, 0) * MPA, colour, label=label)
    ax.set(xlabel="normal traction $t_n$, MPa (tension positive)",
           xlim=(-60, 22), ylim=(0, 115), title=title)
    ax.axvline(0, color="grey", lw=.6)
    ax.legend(loc="upper right", frameon=False)


def plot_envelope():
    figure, (left, right) = axes(2, figsize=(9, 3.8), sharey=True)
    draw_envelope(left, RESIDUAL_FRICTION,
                  "friction falls to $\\varphi_r$ = 31°")
    draw_envelope(right, FRICTION, "$\\varphi_r = \\varphi$ = 50° (default)")
    left.set_ylabel("largest shear traction $|t_s|$, MPa")
    left.annotate("tension cut-off $t_n = T$", (15, 30), (-9, 68), fontsize=9,
                  arrowprops={"arrowstyle": "->", "lw": .7})
    left.annotate("$C$", (.5, 37.5), (2, 47), fontsize=9,
                  arrowprops={"arrowstyle": "->", "lw": .7})
    figure.tight_layout()
    save(figure, "theory_envelope.png")


# Traction and separation, eqs. 13, 14, 14b -----------------------------------

class StraightPoint:
    """A point of the extrinsic model in opening, without energy at its start:
    the offset takes what would leave the envelope."""

    def __init__(self, stiffness):
        self.stiffness = stiffness
        self.offset = self.opening = 0.
        self.separation = FRACTURE_ENERGY / (SOFTENING_INTEGRAL
                                             * TENSILE_STRENGTH)

    def strength(self):
        return softening(self.opening / self.separation) * TENSILE_STRENGTH

    def traction(self, jump):
        trial = self.stiffness * (jump - self.offset)
        over = trial - self.strength()
        if over > 0:
            self.opening += over / self.stiffness
            self.offset = jump - self.strength() / self.stiffness
        if self.opening >= self.separation and jump > 0:
            self.offset = 0
            return 0.
        return self.stiffness * (jump - self.offset)


class ParabolicPoint(StraightPoint):
    """A point of the intrinsic model: the branch is the parabola (14b)."""

    def traction(self, jump):
        trial = self.stiffness * (jump - self.offset)
        over = trial - 2 * self.strength()
        if over > 0:
            self.opening += over / self.stiffness
            self.offset = jump - 2 * self.strength() / self.stiffness
            trial = 2 * self.strength()
        if trial <= 0 or self.strength() == 0:
            return min(trial, 0.)
        return trial * (1 - trial / (4 * self.strength()))


def follow(point, turns, n=4000):
    """Jumps and tractions on a path that goes from turn to turn."""
    jumps = np.concatenate([np.linspace(a, b, n)
                            for a, b in zip(turns, turns[1:])])
    return jumps, np.array([point.traction(jump) for jump in jumps])


def draw_law(ax, kind, stiffness, turns, title):
    point = kind(stiffness)
    monotonic = follow(point, [0, 1.1 * (point.separation
                                         + 2 * TENSILE_STRENGTH / stiffness)])
    energy = np.sum(.5 * (monotonic[1][1:] + monotonic[1][:-1])
                    * np.diff(monotonic[0]))
    ax.plot(monotonic[0] * UM, monotonic[1] * MPA, "C0",
            label=f"opening only: area {energy:.0f} J/m$^2$")
    cycle = follow(kind(stiffness), turns)
    ax.plot(cycle[0] * UM, cycle[1] * MPA, "C1--", lw=1.1,
            label="with unloading and reloading")
    ax.set(xlabel="opening $\\delta_n$, µm", title=title, ylim=(-6, 17))
    ax.axhline(0, color="grey", lw=.6)
    ax.legend(loc="upper right", frameon=False, fontsize=9)
    return monotonic, cycle


def draw_start(ax, curves, right):
    inset = ax.inset_axes([.52, .5, .46, .31])
    for (jumps, tractions), style in zip(curves, ("C0", "C1--")):
        inset.plot(jumps * UM, tractions * MPA, style, lw=1.1)
    inset.set(xlim=(-.15 * right, right), ylim=(-6, 17))
    inset.axhline(0, color="grey", lw=.6)
    inset.tick_params(labelsize=7)


def plot_separation():
    # doc/theory.md: T/k is less than 1 um in the default spalling scene.
    stiffness = TENSILE_STRENGTH / 1e-6
    # The penalty is Young's modulus, the shortest edge 2.5 mm.
    penalty = YOUNGS_MODULUS / 2.5e-3
    figure, (left, right) = axes(2, figsize=(10, 4), sharey=True)
    curves = draw_law(left, StraightPoint, stiffness,
                      [0, 8e-6, 6.2e-6, 25e-6, 23.9e-6, 85e-6, -.3e-6],
                      "extrinsic: $k = T$ / 1 µm")
    draw_start(left, curves, 10)
    curves = draw_law(right, ParabolicPoint, penalty,
                      [0, 8e-6, 6e-6, 25e-6, 23.3e-6, 85e-6],
                      "intrinsic: $P = E_Y$, $h$ = 2.5 mm")
    draw_start(right, curves, 10)
    left.set_ylabel("traction $t_n$, MPa")
    figure.tight_layout()
    save(figure, "theory_separation.png")


# Bond forces at a node that splits, eq. 18 -----------------------------------

# A plane of cells around a node, thickness 1 m: neighbours of the node, m, and
# the part that each cell (between a neighbour and the next) belongs to.
NEIGHBOURS = 2.5e-3 * np.array([(1.0, .05), (.55, .95), (-.35, .9),
                                (-1.05, .25), (-.7, -.75), (.2, -1.05),
                                (.9, -.6)])
PARTS = [0, 0, 1, 1, 1, 2, 2]
STRESS = np.diag([0, TENSILE_STRENGTH])


def nodal_forces():
    """Forces of the cells of each part on the node, and areas of the parts,
    under a uniform stress: eq. 6 in the plane."""
    forces, areas = np.zeros((3, 2)), np.zeros(3)
    for i, part in enumerate(PARTS):
        a, b = NEIGHBOURS[i], NEIGHBOURS[(i + 1) % len(NEIGHBOURS)]
        area = .5 * (a[0] * b[1] - a[1] * b[0])
        gradient = np.array([a[1] - b[1], b[0] - a[0]]) / (2 * area)
        forces[part] -= area * STRESS @ gradient
        areas[part] += area
    return forces, areas


def face_forces(bond):
    """Cut faces as (neighbour, minus part, plus part, area) and their forces
    on the minus parts: least sum of |F|^2 / A that balances the bond forces."""
    faces = []
    for i, part in enumerate(PARTS):
        before = PARTS[i - 1]
        if before != part:
            faces.append((i, min(before, part), max(before, part),
                          np.linalg.norm(NEIGHBOURS[i])))
    laplacian = np.zeros((3, 3))
    for _, minus, plus, area in faces:
        laplacian[minus, minus] += area
        laplacian[plus, plus] += area
        laplacian[minus, plus] -= area
        laplacian[plus, minus] -= area
    multipliers = np.linalg.pinv(laplacian) @ bond
    forces = [area * (multipliers[minus] - multipliers[plus])
              for _, minus, plus, area in faces]
    balance = bond.copy()
    for (_, minus, plus, _), force in zip(faces, forces):
        balance[minus] -= force
        balance[plus] += force
    assert np.abs(balance).max() < 1e-9 * np.abs(bond).max()
    return faces, forces


def centre_direction(part):
    """Unit vector from the node to the middle of a part."""
    middle = sum(NEIGHBOURS[i] + NEIGHBOURS[(i + 1) % len(NEIGHBOURS)]
                 for i, p in enumerate(PARTS) if p == part)
    return middle / np.linalg.norm(middle)


def draw_parts(ax, gap):
    """The cells, in mm, with their parts moved away from the node."""
    for i, part in enumerate(PARTS):
        corners = np.array([(0, 0), NEIGHBOURS[i],
                            NEIGHBOURS[(i + 1) % len(NEIGHBOURS)]])
        ax.fill(*(1e3 * (corners + gap * centre_direction(part))).T,
                color=f"C{part}", alpha=.25, ec="white", lw=1)
        if part != PARTS[i - 1]:
            continue
        ax.text(*(1e3 * (gap + 2e-3) * centre_direction(part)), "ABC"[part],
                color=f"C{part}", fontsize=15, ha="center", va="center")
    ax.set(aspect="equal", xlim=(-4, 4), ylim=(-3.7, 4))
    ax.axis("off")


def arrow(ax, start, force, colour, **keywords):
    """From a place in mm; 1 mm for 15 kN per metre of thickness."""
    tip = start + force / 15e3
    ax.annotate("", tip, start, arrowprops={
        "arrowstyle": "-|>", "color": colour, "lw": 1.8, "shrinkA": 0,
        "shrinkB": 0, **keywords})
    return tip


def draw_bond_forces(ax, bond):
    gap = 1.1e-3
    draw_parts(ax, gap)
    for part, offset in enumerate(((-1.1, -.45), (-1.95, .1), (.12, .1))):
        start = 1e3 * gap * centre_direction(part)
        ax.plot(*start, "ko", ms=4)
        tip = arrow(ax, start, bond[part], "k")
        ax.text(*(tip + offset), f"$b_{'ABC'[part]}$ = "
                f"{np.linalg.norm(bond[part]) * 1e-3:.1f} kN")
    ax.set_title("bond forces (18) on the parts of a node")


def draw_face_forces(ax, faces, forces):
    draw_parts(ax, 0)
    offsets = (.3, .2), (-2.1, -.1), (-2.1, -.25)
    for (neighbour, minus, plus, _), force, offset in zip(faces, forces,
                                                          offsets):
        end = NEIGHBOURS[neighbour]
        middle = .5e3 * end
        ax.plot(*np.array([(0, 0), 1e3 * end]).T, "k", lw=1.5)
        tip = arrow(ax, middle, force, "k")
        ax.text(*(tip + offset),
                f"{np.linalg.norm(force) * 1e-3:.1f} kN on {'ABC'[minus]}")
        # Half of sigma n A, with n from the minus to the plus side.
        outward = np.array([-end[1], end[0]])
        if PARTS[neighbour] == minus:
            outward = -outward
        of_stress = .5 * STRESS @ outward
        arrow(ax, middle + (.18, 0), of_stress, "C3", lw=1, linestyle="--")
        print(f"face between {'ABC'[minus]} and {'ABC'[plus]}: {force} N/m, "
              f"half of the uniform traction {of_stress} N/m")
    ax.set_title("forces of the faces (dashed: half of $\\sigma\\,n\\,A$)")


def plot_bond_forces():
    forces, areas = nodal_forces()
    acceleration = forces.sum(axis=0) / areas.sum()
    bond = areas[:, None] * acceleration - forces
    figure, (left, right) = axes(2, figsize=(9.5, 4.9))
    draw_bond_forces(left, bond)
    draw_face_forces(right, *face_forces(bond))
    figure.subplots_adjust(left=0, right=1, bottom=0, top=.93, wspace=0)
    save(figure, "theory_bond_forces.png")


# Contact, eqs. 24, 26 --------------------------------------------------------

def face_to_face(depth, n=200):
    """Potential and volume of two regular pyramids on a triangle, of height 1
    and base area 1, that overlap face to face by this depth (eq. 24)."""
    # Points of a triangle by their barycentric coordinates, equal weights.
    i, j = np.meshgrid(np.arange(n), np.arange(n))
    keep = i + j < n
    u, v = (i[keep] + 1 / 3) / n, (j[keep] + 1 / 3) / n
    least = np.minimum(np.minimum(u, v), 1 - u - v)
    potential = volume = 0.
    n_slices = 40
    for z in depth * (np.arange(n_slices) + .5) / n_slices:
        # At z the cross-sections are similar triangles on the same axis.
        sizes = np.array([1 - z, 1 - (depth - z)])
        size = sizes.min()
        area = size**2 * depth / n_slices
        volume += area
        for own, height in zip(sizes, (z, depth - z)):
            # Least of the three coordinates of the sides, in the larger one.
            of_sides = (own - size) / 3 + size * least
            potential += area * np.minimum(of_sides, height).mean()
    return potential, volume


def plot_contact():
    depths = np.linspace(0, .6, 121)
    values = np.array([face_to_face(d) for d in depths])
    potential, volume = values.T
    force = np.gradient(potential, depths)
    mean = potential[1:] / volume[1:]
    rising = slice(0, np.argmax(mean))
    limit = np.interp(.15, mean[rising], depths[1:][rising])
    print(f"force largest at depth {depths[np.argmax(force)]:.3f} h: "
          f"{force.max():.3f} p S; mean of phi_A + phi_B 0.15 at "
          f"{limit:.3f} h; potential largest at "
          f"{depths[np.argmax(potential)]:.3f} h")

    figure, (left, right) = axes(2, figsize=(9.5, 3.9))
    left.plot(depths, force, "C0", label="two tetrahedra, face to face")
    left.plot(depths, 2 * depths, "C1--", lw=1,
              label="small overlap, $2d/h$")
    left.axvline(limit, ymax=.8, color="C3", lw=1)
    left.axhline(0, color="grey", lw=.6)
    left.text(limit + .01, .16, "rift warns:\n"
              "mean of $\\varphi_A + \\varphi_B$\nabove 0.15", color="C3",
              fontsize=9)
    left.set(xlabel="depth over height of the cells, $d/h$", xlim=(0, .6),
             ylabel="force over $p\\,S$", ylim=(-.04, .36),
             title="normal force, from $E = p\\,\\Phi$ (24)")
    left.legend(loc="upper right", frameon=False, fontsize=9)

    ratio = np.linspace(1, 8, 400)
    right.plot(ratio, 1 - np.sqrt(1 / ratio), "C0", label="pair with the initial overlap $\\Phi_0$ (26)")
    right.plot([0, 8], [1, 1], "C1", label="pair found apart, $\\Phi_0 = 0$")
    right.plot([0, 1], [0, 0], "C0")
    right.axvline(1, color="grey", lw=.6)
    right.set(xlabel="overlap, $\\Phi/\\Phi_0$", xlim=(0, 8), ylim=(-.05, 1.25),
              ylabel="$(dE/d\\Phi)/p$",
              title="pairs that overlap when they start")
    right.legend(loc="lower right", frameon=False, fontsize=9)
    figure.tight_layout()
    save(figure, "theory_contact.png")


plot_envelope()
plot_separation()
plot_bond_forces()
plot_contact()
