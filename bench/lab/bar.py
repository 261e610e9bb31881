"""The virtual test bench: effective Young's modulus of specimens that their own weight loads."""

import itertools
import math
import sys
import typing

import kerf
import numpy as np

from . import bodies
from .workshop import progress, publish, remove, table, value_text

STRAIN = 0.01
DENSITY = 1000  # [kg/m^3]
DRAG = 20  # [1/s]: about critical for the slowest stretching mode
FIRST_BENDING = 3.516  # of a bar that is held at one end: (1.875)^2
PRESSED = 0.02  # of a sphere's diameter
WINDOW = 0.2  # between two looks [s]
SETTLED = 1e-4  # relative change of the end's motion in a window
MOST_SECONDS = 16  # enough for what drag slows most; then it has not settled
MOST_VOLUME_CHANGE = 0.01
MOST = {row["name"]: row["high"] for row in kerf.parameters()}  # of each parameter

MODULI = (1e4, 1e5, 1e6)
CELLS = (2, 3, 4, 6)
ITERATIONS = (5, 10, "auto")
TIME_STEPS = (0.0025, 0.005, 0.02)
# Of the bar that comes down, which needs no shorter steps than these: each is one implicit step.
ORDER_ITERATIONS, ORDER_STEPS = (5, 20), (0.005, 0.0025, 0.00125)
EXACT_ITERATIONS, EXACT_STEP = 60, 0.0005
ORDER_LOOKS, ORDER_LOOK = 8, 0.02  # [s]


class Loading(typing.NamedTuple):
    """How a specimen is loaded and what a solid does then."""
    size: tuple  #: [m]
    support: str  #: top, bottom or floor
    theory: str  #: stretched, bent, sheared or pressed
    #: How stiff an incompressible solid is against the formula: clamps, the width of a slab and
    #: free rims are not in it (docs/notes/effective-modulus.md).
    solid: float

    @property
    def aside(self):
        return self.theory in ("bent", "sheared")

    @property
    def supported_at(self):
        return (0.5 if self.support == "top" else -0.5) * self.size[1]


KINDS = {
    "hanging bar": Loading((0.1, 0.4, 0.1), "top", "stretched", 1.04),
    "bent bar": Loading((0.1, 0.4, 0.1), "top", "bent", 1.00),
    "bent slab": Loading((0.1, 0.4, 0.5), "top", "bent", 1.16),
    "compressed block": Loading((0.2, 0.2, 0.2), "floor", "stretched", 0.96),
    "sheared block": Loading((0.4, 0.1, 0.4), "bottom", "sheared", 0.83),
    "hanging cube": Loading((0.2, 0.2, 0.2), "top", "stretched", 1.09),
    "pressed sphere": Loading((0.2, 0.2, 0.2), "floor", "pressed", 1.00),
}


class Setting(typing.NamedTuple):
    """One test."""
    kind: str = "hanging bar"
    cells: int = 4  #: squares across the specimen
    modulus: float = 1e5  #: the parameter `youngs_modulus` [Pa]
    iterations: typing.Union[int, str] = "auto"  #: the parameter
    time_step: float = 0.005  #: [s]

    def __str__(self):
        return (f"{self.kind}, E = {self.modulus:.0e} Pa, {self.cells} cells, steps of "
                f"{self.time_step:g} s, {self.iterations} iterations")


class Run(typing.NamedTuple):
    """A test that was run."""
    setting: Setting
    triangles: int
    strain: float  #: how far the end went, over the specimen's length
    modulus: float  #: of the solid that would move as much [Pa]
    volume_ratio: float  #: at rest under load, against the unloaded specimen
    settled: bool  #: False where it still moved when time was up

    @property
    def ratio(self):
        return self.modulus / self.setting.modulus


class Accuracy(typing.NamedTuple):
    """The error of a bar that sags."""
    iterations: int
    time_step: float  #: [s]
    error: float  #: the largest, as a share of how far it comes down


def ball(diameter, cells):
    """A cube that is blown up. Contact is small: four times as many squares as on a block."""
    points, triangles = bodies.box([1, 1, 1], [4 * cells] * 3)
    points = np.tan(points * np.pi / 2)  # of even angles: squares are of about one size
    return points * (diameter / 2 / np.linalg.norm(points, axis=1))[:, None], triangles


class Specimen:
    """A body on the bench, its axis along y, about to feel its weight.

    With the weight of the vertices m g, at distances h from the support, a bar of length L and
    cross-section A changes its length by sum(m g h) / (E A), and a flat block is sheared by 3 times
    that. One with the second moment of area I that is bent moves its end by
    sum(m g h^2 (3 L - h)) / (6 E I) (Euler and Bernoulli, without shear). The middle of a sphere of
    radius R goes down by d, with F = 16/9 E sqrt(R) d^(3/2) (Hertz).
    """

    def __init__(self, setting):
        self.loading = loading = KINDS[setting.kind]
        size, self.length = np.array(loading.size), loading.size[1]
        square = size.min() / setting.cells
        self.points, self.triangles = (
            ball(self.length, setting.cells) if loading.theory == "pressed"
            else bodies.box(size, np.rint(size / square).astype(int)))
        gravity = np.zeros(3)
        self.strength = self.gravity_for(setting.modulus)
        gravity[0 if loading.aside else 1] = self.strength * (1 if loading.aside else -1)
        self.sim = bodies.simulate(self.points, self.triangles, params={
            "time_step": setting.time_step, "iterations": setting.iterations,
            "youngs_modulus": setting.modulus, "density": DENSITY,
            "air_drag": self.drag_for(setting.modulus), "friction": 0,
            "floor": -self.length / 2 if loading.support == "floor" else None,
            "gravity": gravity})
        if loading.support != "floor":
            middle, hair = np.array([0, loading.supported_at, 0]), 1e-3 * self.length
            across = np.array([size[0] / 2, 0, size[2] / 2]) + hair
            self.sim.pin(low=middle - across, high=middle + across)
        self.rest = self.sim.mesh.rest_positions
        self.free = (slice(None) if loading.theory == "pressed" else
                     np.isclose(self.rest[:, 1], -loading.supported_at, rtol=0, atol=1e-6))

    # --- Theory -----------------------------------------------------------------------------------

    def compliance(self, distance):
        """Displacement of the end by a unit force at a distance from the support, times E [1/m]."""
        width, length, depth = self.loading.size
        if self.loading.theory == "bent":
            return distance**2 * (3 * length - distance) / (6 * depth * width**3 / 12)
        return (3 if self.loading.theory == "sheared" else 1) * distance / (width * depth)

    def load_per_gravity(self):
        """Displacement of the end times E per unit of gravity [Pa s^2]. Weight lies on the skin."""
        areas = bodies.areas(self.points, self.triangles)
        middles = sum(bodies.corners(self.points, self.triangles))[:, 1] / 3
        motion = areas @ self.compliance(abs(middles - self.loading.supported_at))
        mass = DENSITY * math.prod(self.loading.size)
        return mass * motion / areas.sum() / self.loading.solid

    def hertz_force(self, way):
        """The force per modulus, with Poisson's ratio 1/2 [m^2]."""
        return 16 / 9 * math.sqrt(self.length / 2) * way**1.5

    def gravity_for(self, modulus):
        """The gravity that strains a specimen of this modulus by 1 %, or nearly [m/s^2]."""
        if self.loading.theory == "pressed":
            mass = DENSITY * bodies.volume(self.points, self.triangles)
            return modulus * self.hertz_force(PRESSED * self.length) / mass
        return min(STRAIN * modulus * self.length / self.load_per_gravity(), MOST["gravity"])

    def modulus_for(self, way):
        """The modulus of the solid whose end would move as far [Pa]."""
        if self.loading.theory == "pressed":
            mass = DENSITY * bodies.volume(self.points, self.triangles)
            return mass * self.strength / self.hertz_force(way)
        return self.load_per_gravity() * self.strength / way

    def drag_for(self, modulus):
        """About critical for the slowest mode, so that it settles soon [1/s]."""
        if self.loading.theory != "bent":
            return DRAG
        gyration = self.loading.size[0] / math.sqrt(12)
        critical = 2 * FIRST_BENDING * gyration / self.length**2 * math.sqrt(modulus / DENSITY)
        return min(critical, MOST["air_drag"])

    # --- Runs -------------------------------------------------------------------------------------

    def way_of_end(self):
        """Displacement of the free end since rest, along the weight [m]."""
        way = (self.sim.positions - self.rest)[self.free].mean(axis=0)
        return abs(way[0 if self.loading.aside else 1])

    def settle(self):
        """Steps until the end stands still. False where it does not in time."""
        before, look = self.way_of_end(), WINDOW
        while self.sim.report.time < MOST_SECONDS:
            while self.sim.report.time < look:
                self.sim.step()
            look += WINDOW
            now = self.way_of_end()
            if abs(now - before) <= SETTLED * now:
                return True
            before = now
        return False

    def motion(self, looks, seconds):
        """Displacement of the end at each of the samples [m]."""
        steps = round(seconds / self.sim.params["time_step"])
        ways = []
        for _ in range(looks):
            self.sim.step(steps)
            ways.append(self.way_of_end())
        return np.array(ways)


def measure(setting):
    """Loads a specimen so that it strains by 1 % at the parameter's modulus, and lets it settle."""
    specimen = Specimen(setting)
    settled = specimen.settle()
    way = specimen.way_of_end()
    return Run(setting, len(specimen.triangles), way / specimen.length, specimen.modulus_for(way),
               specimen.sim.report.volume_ratio, settled)


def measure_accuracy(iterations=ORDER_ITERATIONS, time_steps=ORDER_STEPS):
    """Compares a bar that sags with one in the shortest steps, with the most iterations."""
    def motion(count, step):
        bar = Specimen(Setting(cells=2, iterations=count, time_step=step))
        return bar.motion(ORDER_LOOKS, ORDER_LOOK)

    exact = motion(EXACT_ITERATIONS, EXACT_STEP)
    return [Accuracy(n, step, abs(motion(n, step) - exact).max() / exact[-1])
            for n in iterations for step in time_steps]


def order_of(runs):
    """The order of convergence in the length of a step, of the most iterations: the slope in
    logarithms."""
    most = max(r.iterations for r in runs)
    steps, errors = zip(*((r.time_step, r.error) for r in runs if r.iterations == most))
    return np.polyfit(np.log(steps), np.log(errors), 1)[0]


def settings(whole=False):
    """One of resolution, iterations and time step changes at a time; `whole`: all combinations."""
    usual = Setting()
    made = [Setting(kind, cells, modulus, iterations, step) for kind, modulus, cells, iterations,
            step in itertools.product(KINDS, MODULI, CELLS, ITERATIONS, TIME_STEPS)]
    return [s for s in made if whole or (s.cells != usual.cells) +
            (s.iterations != usual.iterations) + (s.time_step != usual.time_step) <= 1]


# --- Report ---------------------------------------------------------------------------------------


def count_runs(runs):
    """How many runs there are, and how many within 10 and 25 % of the modulus."""
    errors = [abs(r.ratio - 1) for r in runs]
    return [len(errors), *(sum(e <= most for e in errors) for most in (0.10, 0.25))]


def count_table(runs):
    """Those of all iterations alike, and spheres by themselves."""
    def is_ball(r):
        return KINDS[r.setting.kind].theory == "pressed"

    groups = {"spheres": list(filter(is_ball, runs))}
    for n in ITERATIONS:
        groups[f"others, {n} iterations"] = [r for r in runs if not is_ball(r)
                                             and r.setting.iterations == n]
    return table(["specimens", "runs", "within 10 %", "within 25 %"],
                 [[name, *count_runs(own)] for name, own in groups.items()])


def still_moving(runs):
    return [str(r.setting) for r in runs if not r.settled]


def modulus_tables(runs):
    by_setting = {r.setting: r for r in runs}

    def cell(setting):
        r = by_setting.get(setting)
        return "-" if r is None else f"{r.ratio:.2f}" + ("" if r.settled else " (still moving)")

    text = ""
    for title, unit, key, columns in (
            ("By resolution (squares across the specimen)", "across", "cells", CELLS),
            ("By iterations", "iterations", "iterations", ITERATIONS),
            ("By time step", "s", "time_step", TIME_STEPS)):
        rows = [[kind, f"{modulus:.0e}",
                 *(cell(Setting(kind=kind, modulus=modulus, **{key: column}))
                   for column in columns)]
                for kind in KINDS for modulus in MODULI]
        text += f"\n## {title}\n\n" + table(
            ["specimen", "E, Pa", *(f"{value_text(column)} {unit}" for column in columns)],
            rows).rstrip("\n") + "\n"
    return text


def report_of(runs, accuracy=()):
    return (
        "# Effective Young's modulus\n\n"
        "A bar that hangs from its pinned top, the same bar and one five times as wide bent by a "
        "weight that acts sideways, a block that stands on a floor without friction, a flat one "
        "that a weight sideways shears, and a cube that hangs from its pinned top. Each is loaded "
        "by its own weight so that a solid of modulus E changes its length, or moves its end "
        "aside, by 1 %. A sphere is pressed on a floor so that Hertz's formula lets its middle "
        "down by 2 % of its diameter. The figures are E_eff / E: the modulus of the incompressible "
        "solid that would move as much as ours, over the parameter `youngs_modulus`. 1 is true to "
        "the parameter, more is too stiff. Specimens are four squares across, steps 5 ms and "
        "iterations auto, where a table does not say otherwise.\n\n## How many hold\n\n"
        + count_table(runs).rstrip("\n") + "\n" + modulus_tables(runs)
        + (accuracy_section(accuracy) if accuracy else ""))


def accuracy_section(accuracy):
    return (
        "\n## Accuracy by steps and iterations\n\n"
        "The hanging bar of 1e5 Pa, two squares across. The largest error of where its end is "
        "while it comes down, in per cent of that way.\n\n"
        + table(["iterations", "time step, s", "error, %"],
                [[a.iterations, f"{a.time_step:g}", f"{100 * a.error:.2g}"] for a in accuracy])
        + "With the most iterations the error falls as the step to the power of "
          f"{order_of(accuracy):.2f}.\n")


def summary_of(runs, accuracy=()):
    return {
        "tests": [{
            "specimen": r.setting.kind, "cells": r.setting.cells, "triangles": r.triangles,
            "youngs_modulus": r.setting.modulus, "iterations": r.setting.iterations,
            "time_step": r.setting.time_step, "strain": r.strain, "effective_modulus": r.modulus,
            "ratio": r.ratio, "volume_ratio": r.volume_ratio, "settled": r.settled,
        } for r in runs],
        "still_moving": still_moving(runs),
        "accuracy": [a._asdict() for a in accuracy],
    }


def warning_of(runs):
    """One sentence that names all specimens that did not settle; empty where all did."""
    names = still_moving(runs)
    count = "1 specimen was" if len(names) == 1 else f"{len(names)} specimens were"
    return (f"bar: {count} still moving when time was up, so what stands there is not final: "
            f"{'; '.join(names)}." if names else "")


def failure_of(runs):
    """The first specimen that did not keep its volume; empty where all did."""
    return next((f"bar: {r.setting}: the volume is {100 * r.volume_ratio:.2f} % of what it was."
                 for r in runs if not abs(r.volume_ratio - 1) < MOST_VOLUME_CHANGE), "")


def run(arguments):
    """Prints the report. Returns the first specimen that lost volume as a sentence, or ""."""
    folder = arguments.out / "bar"
    remove(folder, "summary.json", "report.md")
    progress("bar: accuracy")
    accuracy, runs, wanted = measure_accuracy(), [], settings(arguments.whole)
    for setting in wanted:
        progress(f"bar: {len(runs) + 1} of {len(wanted)}")
        runs.append(measure(setting))
    publish(arguments, folder, report_of(runs, accuracy), summary_of(runs, accuracy))
    if warning := warning_of(runs):
        print(warning, file=sys.stderr)
    return failure_of(runs)
