"""Problems with a closed solution: the scene and the solution of each.

Stresses have VTK's order xx yy zz xy yz xz. All solutions are at rest at t = 0.
"""
import numpy as np

from . import elasticity

ROCK = {"density": 2650, "youngs_modulus": 60e9, "poissons_ratio": 0.25}

# Barre granite, Pa: orthotropic, the axes normal to hardway, grain, rift.
BARRE_DENSITY = 2660
BARRE = np.array([[54.7e9, 8.08e9, 7.13e9, 0, 0, 0], [8.08e9, 40.7e9, 5.54e9, 0, 0, 0],
                  [7.13e9, 5.54e9, 35.2e9, 0, 0, 0], [0, 0, 0, 15.5e9, 0, 0],
                  [0, 0, 0, 0, 17.9e9, 0], [0, 0, 0, 0, 0, 19.2e9]])


def isotropic_section(material):
    return {"Density": material["density"],
            "Young's modulus": material["youngs_modulus"],
            "Poisson's ratio": material["poissons_ratio"]}


def orthotropic_section(density, stiffness, axes):
    upper = stiffness[np.triu_indices(6)]
    return {"Density": density, "Elasticity": "anisotropic",
            "Stiffness": ", ".join(f"{c:g}" for c in upper),
            "Axis 1": ", ".join(f"{x:g}" for x in axes[0]),
            "Axis 2": ", ".join(f"{x:g}" for x in axes[1])}


def pulse(duration, amplitude):
    """One period of 1 - cos, for a scene."""
    return (f"t < {duration:.16g} ? {0.5 * amplitude:.16g} * "
            f"(1 - cos(2 * pi * t / {duration:.16g})) : 0")


def pulse_value(t, duration, amplitude):
    inside = (t > 0) & (t < duration)
    return np.where(inside, 0.5 * amplitude * (1 - np.cos(2 * np.pi * t / duration)), 0)


class PlaneWave:
    """A pulse along x in a block. The sides confine it to the plane wave of an
    infinite body (d'Alembert), or are free and so far away that what they do has
    not come to the points that count."""
    geo = "block.geo"
    wavelength, amplitude = 40e-3, 0.1

    def __init__(self, name, title, material, density, stiffness, motion, sides,
                 sizes, width=6e-3, travelled=80e-3):
        self.name, self.title, self.sizes, self.width = name, title, sizes, width
        self.stiffness, self.density, self.sides = stiffness, density, sides
        self.speed, self.polarization = elasticity.plane_wave(
            stiffness, density, motion)
        self.duration = self.wavelength / self.speed
        self.end_time = travelled / self.speed
        self.mesh_numbers = {"length": 1.1 * travelled, "width": width}
        self.probe = (0.375 * travelled, 0.5 * width, 3e-3)
        self.probe_direction = self.polarization
        self.travel_time = self.probe[0] / self.speed
        self.sections = {"Material rock": material, "Boundary x_min": {}}
        for d, axis in enumerate("xyz"):
            value = self.amplitude * self.polarization[d]
            self.sections["Boundary x_min"][f"Velocity {axis}"] = (
                pulse(self.duration, value) if abs(value) > 1e-9 else 0)
        for side, axes in sides.items():
            for end in ("min", "max"):
                self.sections[f"Boundary {side}_{end}"] = {
                    f"Velocity {axis}": 0 for axis in axes}

    def velocity_component(self, x, t):
        return pulse_value(t - x[:, 0] / self.speed, self.duration, self.amplitude)

    def velocity(self, x, t):
        return self.velocity_component(x, t)[:, None] * self.polarization

    def stress(self, x, t):
        strain = np.array([self.polarization[0], 0, 0, 0, self.polarization[2],
                           self.polarization[1]]) / -self.speed
        stress = (self.stiffness @ strain)[[0, 1, 2, 5, 3, 4]]
        return self.velocity_component(x, t)[:, None] * stress

    def counts(self, x, t):
        """What free sides do begins at x = 0 when t = 0 and follows the wave; at
        t it is below each line of normal n that runs ahead of it with the speed
        of the fastest wave of this normal."""
        result = np.full(len(x), True)
        if "y" in self.sides:
            return result
        angles = np.linspace(0, 0.5 * np.pi, 181)[1:]
        moving = [d for d, axis in enumerate("xyz") if axis not in self.sides["z"]]
        for sign, from_side in ((1, x[:, 1]), (-1, self.width - x[:, 1])):
            normals = np.stack([np.cos(angles), sign * np.sin(angles), 0 * angles], 1)
            speeds = elasticity.fastest_speeds(self.stiffness, self.density, moving,
                                               normals)
            is_ahead = np.full(len(x), False)
            for (along, across, _), speed in zip(np.abs(normals), speeds):
                reached = max(speed * t, along * self.speed * t)
                is_ahead |= along * x[:, 0] + across * from_side > reached
            result &= is_ahead
        return result


class Rod:
    """A long wave in a round rod with free sides: Love's equation, the first
    correction to the bar of Pochhammer and Chree,
    omega^2 (1 + nu^2 a^2 k^2 / 2) = c0^2 k^2, so that
    c / c0 = 1 - nu^2 pi^2 (a / Lambda)^2 for long waves."""
    name, title, geo = "rod", "rod with free sides", "rod.geo"
    radius, length, travelled, wavelength, amplitude = 5e-3, 180e-3, 170e-3, 100e-3, 0.1
    mesh_numbers = {"radius": radius, "length": length}
    sizes = (5e-3, 3.54e-3, 2.5e-3, 1.77e-3, 1.25e-3)

    def __init__(self):
        self.speed = np.sqrt(ROCK["youngs_modulus"] / ROCK["density"])
        self.duration = self.wavelength / self.speed
        self.end_time = self.travelled / self.speed
        self.probe = (60e-3, 0, 0)
        self.probe_direction = np.array([1, 0, 0])
        self.travel_time = self.probe[0] / self.speed
        self.sections = {
            "Material rock": isotropic_section(ROCK),
            "Boundary x_min": {"Velocity x": pulse(self.duration, self.amplitude)}}
        # The pulse as a Fourier series over a time in which nothing comes back.
        n = 4096
        period = 8 * self.end_time
        time = np.arange(n) * period / n
        self.series = np.fft.rfft(pulse_value(time, self.duration, self.amplitude)) / n
        self.series[1:] *= 2
        omega = 2 * np.pi * np.arange(len(self.series)) / period
        nu = ROCK["poissons_ratio"]
        # Far below the limit of Love's equation; there is nothing above.
        keep = omega < 0.5 * self.speed / (nu * self.radius)
        self.series, self.omega = self.series[keep], omega[keep]
        self.wavenumber = self.omega / np.sqrt(
            self.speed**2 - 0.5 * (nu * self.radius * self.omega)**2)

    def correction(self):
        """By which a long wave is slower than sqrt(E/rho)."""
        return (ROCK["poissons_ratio"] * np.pi * self.radius / self.wavelength)**2

    def without_dispersion(self, t):
        """The velocity at the probe if all waves had the speed sqrt(E/rho)."""
        return pulse_value(t - self.travel_time, self.duration, self.amplitude)

    def transform(self, x, t, factor):
        """The series with its terms times a factor, at places x and a time, or at
        a place and several times."""
        x, t = np.atleast_1d(x), np.atleast_1d(t)
        phase = np.exp(1j * (np.multiply.outer(t, self.omega)
                             - np.multiply.outer(x, self.wavenumber)))
        return (phase @ (self.series * factor)).real

    def on_grid(self, x, t, factor):
        grid = np.linspace(0, self.length, 3000)
        return np.interp(x, grid, self.transform(grid, t, factor))

    def velocity(self, x, t):
        nu, k, r2 = ROCK["poissons_ratio"], self.wavenumber, x[:, 1]**2 + x[:, 2]**2
        if np.ndim(t):
            mean = self.transform(x[0, 0], t, 1)
            curvature = self.transform(x[0, 0], t, -k**2)
            slope = self.transform(x[0, 0], t, -1j * k)
        else:
            mean = self.on_grid(x[:, 0], t, 1)
            curvature = self.on_grid(x[:, 0], t, -k**2)
            slope = self.on_grid(x[:, 0], t, -1j * k)
        # Plane sections bend a little so that there is no shear.
        along = mean + 0.5 * nu * (r2 - 0.5 * self.radius**2) * curvature
        return np.stack([along, -nu * slope * x[:, 1], -nu * slope * x[:, 2]], axis=1)

    def stress(self, x, t):
        nu, k, omega = ROCK["poissons_ratio"], self.wavenumber, self.omega
        r2 = x[:, 1]**2 + x[:, 2]**2
        modulus, density = ROCK["youngs_modulus"], ROCK["density"]
        # The mean strain over the mean velocity.
        strain = -np.divide(k, omega, where=omega > 0,
                            out=np.full(len(omega), 1 / self.speed))
        inertia = -0.5 * density * (nu * self.radius * omega)**2
        mean = self.on_grid(x[:, 0], t, strain * (modulus + inertia))
        bent = self.on_grid(x[:, 0], t, -k**2 * strain * modulus)
        result = np.zeros((len(x), 6))
        result[:, 0] = mean + 0.5 * nu * (r2 - 0.5 * self.radius**2) * bent
        return result

    def counts(self, x, t):
        return np.full(len(x), True)


class Cavity:
    """A spherical cavity in an infinite body under a pulse of pressure. With
    u = d/dr (f(t - (r - a) / c_p) / r), f follows from
    f'' + 2 alpha f' + beta^2 f = -a P / rho, alpha = 2 c_s^2 / (c_p a),
    beta = 2 c_s / a."""
    name, title, geo = "cavity", "pressurised cavity", "cavity.geo"
    inner, outer, travelled, wavelength = 15e-3, 60e-3, 42e-3, 40e-3
    pressure = 1e6
    mesh_numbers = {"inner_radius": inner, "outer_radius": outer}
    sizes = (5.66e-3, 4e-3, 2.83e-3, 2e-3, 1.41e-3)

    def __init__(self):
        self.stiffness = elasticity.isotropic_stiffness(ROCK)
        density = ROCK["density"]
        self.p_speed = np.sqrt(self.stiffness[0, 0] / density)
        s_speed = np.sqrt(self.stiffness[3, 3] / density)
        self.duration = self.wavelength / self.p_speed
        self.end_time = self.travelled / self.p_speed
        self.probe_direction = np.ones(3) / np.sqrt(3)
        self.probe = tuple(2 * self.inner * self.probe_direction)
        self.travel_time = self.inner / self.p_speed
        alpha = 2 * s_speed**2 / (self.p_speed * self.inner)
        beta = 2 * s_speed / self.inner
        self.sections = {
            "Material rock": isotropic_section(ROCK),
            "Boundary cavity": {"Pressure": pulse(self.duration, self.pressure)}}
        for axis in "xyz":
            self.sections[f"Boundary {axis}_min"] = {f"Velocity {axis}": 0}
        # f for P (1 - cos(W t)) / 2 is the real part of a sum of these terms.
        wave = 2j * np.pi / self.duration
        root = -alpha + 1j * np.sqrt(beta**2 - alpha**2)
        load = -0.5 * self.pressure * self.inner / density
        static = load / beta**2
        forced = -load / (wave**2 + 2 * alpha * wave + beta**2)
        free_real = -static - forced.real
        free_imaginary = ((forced * wave).real + free_real * root.real) / root.imag
        self.terms = [(static, 0), (forced, wave),
                      (free_real + 1j * free_imaginary, root)]

    def potential(self, tau, derivative):
        """A derivative of f: the answer to a load that goes on, less the same a
        period later."""
        result = np.zeros_like(tau)
        for sign, time in ((1, tau), (-1, tau - self.duration)):
            t = np.maximum(time, 0)
            value = sum((factor * rate**derivative * np.exp(rate * t)).real
                        for factor, rate in self.terms)
            result += sign * np.where(time > 0, value, 0)
        return result

    def in_time(self, x, t):
        r = np.linalg.norm(x, axis=1)
        return r, t - (r - self.inner) / self.p_speed

    def velocity(self, x, t):
        r, tau = self.in_time(x, t)
        c = self.p_speed
        v = -self.potential(tau, 2) / (c * r) - self.potential(tau, 1) / r**2
        return (v / r)[:, None] * x

    def stress(self, x, t):
        r, tau = self.in_time(x, t)
        c = self.p_speed
        f, f1, f2 = (self.potential(tau, n) for n in range(3))
        hoop = (-f1 / (c * r) - f / r**2) / r
        radial = f2 / (c**2 * r) + 2 * f1 / (c * r**2) + 2 * f / r**3
        first, second = self.stiffness[0, 0], self.stiffness[0, 1]
        s_hoop = second * radial + (first + second) * hoop
        difference = (first - second) * (radial - hoop)
        n = x / r[:, None]
        result = difference[:, None] * np.stack(
            [n[:, i] * n[:, j] for i, j in elasticity.VTK_PAIRS], axis=1)
        result[:, :3] += s_hoop[:, None]
        return result

    def counts(self, x, t):
        return np.full(len(x), True)


def all_problems():
    """By name, in the order of the tables."""
    block_sizes = (3e-3, 2.12e-3, 1.5e-3, 1.06e-3, 0.75e-3, 0.6e-3)
    wide_sizes = (3e-3, 2.4e-3, 1.9e-3, 1.5e-3, 1.2e-3)
    along = ((1, 0, 0), (0, 1, 0))
    across = ((1, 1, 0), (0, 0, 1))
    barre = {axes: elasticity.rotate(BARRE, axes) for axes in (along, across)}
    section = {axes: orthotropic_section(BARRE_DENSITY, BARRE, axes) for axes in barre}

    def orthotropic(name, title, axes, motion, sides, **more):
        return PlaneWave(name, title, section[axes], BARRE_DENSITY, barre[axes],
                         motion, sides, **more)

    confined_p, confined_s = {"y": "y", "z": "z"}, {"y": "xz", "z": "xz"}
    problems = [
        PlaneWave("bar", "confined bar", isotropic_section(ROCK), ROCK["density"],
                  elasticity.isotropic_stiffness(ROCK), (1, 0, 0), confined_p,
                  block_sizes),
        Rod(), Cavity(),
        orthotropic("p_along", "orthotropic, P along axis 1", along, (1, 0, 0),
                    confined_p, sizes=block_sizes),
        orthotropic("s_along", "orthotropic, S along axis 1", along, (0, 1, 0),
                    confined_s, sizes=block_sizes),
        orthotropic("p_across", "orthotropic, P at 45 degrees", across, (1, 0, 0),
                    {"z": "z"}, sizes=wide_sizes, width=110e-3, travelled=50e-3),
        orthotropic("s_across", "orthotropic, S at 45 degrees", across, (0, 0, 1),
                    {"z": "xy"}, sizes=wide_sizes, width=110e-3, travelled=50e-3)]
    return {problem.name: problem for problem in problems}
