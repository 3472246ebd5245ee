"""Stiffness in Voigt's order 11, 22, 33, 23, 13, 12, and plane waves along x."""
import numpy as np

PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
VTK_PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2))


def isotropic_stiffness(material):
    e, nu = material["youngs_modulus"], material["poissons_ratio"]
    mu = e / (2 * (1 + nu))
    result = np.diag([2 * mu] * 3 + [mu] * 3)
    result[:3, :3] += e * nu / ((1 + nu) * (1 - 2 * nu))
    return result


def full_tensor(stiffness):
    result = np.empty((3, 3, 3, 3))
    for i, (a, b) in enumerate(PAIRS):
        for j, (c, d) in enumerate(PAIRS):
            for p, q in ((a, b), (b, a)):
                for r, s in ((c, d), (d, c)):
                    result[p, q, r, s] = stiffness[i, j]
    return result


def rotate(stiffness, axes):
    """The stiffness in the coordinates in which the first two material axes are
    given."""
    first = np.array(axes[0]) / np.linalg.norm(axes[0])
    second = np.array(axes[1]) / np.linalg.norm(axes[1])
    q = np.stack([first, second, np.cross(first, second)], axis=1)
    tensor = np.einsum("ia,jb,kc,ld,abcd->ijkl", q, q, q, q, full_tensor(stiffness))
    return np.array([[tensor[i + j] for j in PAIRS] for i in PAIRS])


def plane_wave(stiffness, density, motion):
    """Speed and direction of motion of the wave along x that moves most along
    `motion` (Christoffel)."""
    of_x = [0, 5, 4]
    squares, directions = np.linalg.eigh(stiffness[np.ix_(of_x, of_x)] / density)
    best = np.argmax(np.abs(directions.T @ motion))
    direction = directions[:, best]
    return np.sqrt(squares[best]), direction * np.sign(direction @ motion)


def fastest_speeds(stiffness, density, components, normals):
    """Of the waves with these normals that move only these components."""
    waves = np.einsum("ijkl,nj,nl->nik", full_tensor(stiffness), normals, normals)
    moving = waves[:, components][:, :, components]
    return np.sqrt(np.linalg.eigvalsh(moving)[:, -1] / density)
