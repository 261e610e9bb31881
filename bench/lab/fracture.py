"""Challenge problems of elastic brittle fracture, those that a straight cohesive front can do."""

import math
import typing

import numpy as np

from . import bodies
from .fem_cases import POISSON_RATIO
from .fem_solid import Solid, solid_box
from .tear import (MOST_ERROR, MOST_RELEASE, Hands, Strip, Trouser, edges, material_of, percent,
                   simulate, slit, tear)
from .workshop import bullets, progress, publish, remove, table

MATERIAL, SPEED, RESOLUTION = "gelatin", "fast", "coarse"
#: Of a uniaxial stretch at which a body begins to part. Meshes of bars resolve its cohesive zone.
STRENGTH = 0.05
ZONE, EDGES = 0.88, 5  # length of that zone, as docs/physics.md has it, and edges in it
LOADING = 20  # waves that pass a bar until it should part
FARTHEST = 4  # of the extension at which it should: then it has not parted
PARTED = 0.5  # of the largest force
CELLS = 12, 10, 1  # of finite elements along a bar, smaller near the notch, across and through it
NOTCH_STEP = 0.1  # in widths: energy release rates are differences of so much more and less

#: What Kerf can't do, and why.
OTHERS = {
    "biaxial tension": "A tear begins where the skin is stretched too far in any one direction: "
                       "no strength along two axes can be set.",
    "torsion": "It asks for a strength in shear, which can't be set, and its front winds.",
    "indentation": "The crack around a punch is closed in itself; a front is one straight line.",
    "poker chip": "A tear begins at the skin, never inside, and no pressure parts a body."}


class Row(typing.NamedTuple):
    """A problem that was run."""
    problem: str
    quantity: str
    expected: float
    found: typing.Optional[float]  #: none where it did not tear

    @property
    def ratio(self):
        return None if self.found is None else self.found / self.expected

    @property
    def is_within(self):
        return self.ratio is not None and bool(abs(self.ratio - 1) <= MOST_ERROR)


# --- Bars -----------------------------------------------------------------------------------------


class Bar:
    """A bar that hands draw out, whole or notched from one side in its middle."""

    def __init__(self, cells, notch=0):
        """Squares across, along and through it, and the depth of the notch in widths."""
        self.cells, self.notch = cells, notch
        material = material_of(MATERIAL)
        self.square = ZONE * material.length / STRENGTH**2 / EDGES
        self.material = material.held_firmly(self.square)
        self.width, self.height, self.thickness = self.square * np.array(cells)
        self.across, self.area = Strip.across, self.width * self.thickness
        self.strength = STRENGTH * material.modulus

    def hands(self):
        return edges(self, self.height / 2 - 0.3 * self.square)

    def breaking_stress(self, expected):
        """The largest mean stress until it parts; none if it doesn't [Pa]."""
        size = np.array([self.width, self.height, self.thickness])
        sim = simulate(self, bodies.box(size, self.cells), self.material)
        if self.notch:
            slit(sim, -self.width / 2 - self.square, (self.notch - 0.5) * self.width,
                 0.5 * self.square, self.thickness)
        sim.set("tensile_strength", self.strength)
        sim.set("tearing", 1)
        hands, most = Hands(sim, self), 0
        opening = expected / self.material.modulus * self.height
        while hands.opening < FARTHEST * opening:
            hands.go(opening * self.material.wave / self.height / LOADING, 0)
            stress = hands.release / 2 / self.width
            most = max(most, stress)
            if stress < PARTED * most and most > PARTED * expected:
                return most
        return None

    def griffith_stress(self):
        """At which the notch runs on, by what a shorter and a longer one store [Pa]."""
        shorter, longer = (self.stored(self.notch + by) for by in (-NOTCH_STEP, NOTCH_STEP))
        released = (shorter - longer) / (2 * NOTCH_STEP * self.area)
        stress = (shorter + longer) / (self.height / 100) / self.area
        return stress * math.sqrt(self.material.toughness / released)

    def stored(self, notch):
        """By finite elements, drawn out by a hundredth [J]."""
        half = np.array([self.height, self.width, self.thickness]) / 2
        along, across, through = (np.linspace(-1, 1, cells + 1) for cells in CELLS)
        lines = [half[0] * along * abs(along), half[1] * across, half[2] * through]
        mesh = solid_box(lines, (0, half[1] - notch * self.width, self.thickness))
        ends, moved = abs(mesh.nodes[:, 0]) == half[0], np.zeros_like(mesh.nodes)
        moved[:, 0] = ends * mesh.nodes[:, 0] / 100
        solid = Solid(mesh, self.material.modulus, POISSON_RATIO, np.zeros(3),
                      np.stack([ends] * 3, axis=1), moved)
        return solid.elastic_energy(solid.relaxed())


# --- Problems -------------------------------------------------------------------------------------


class Beam(Trouser):
    """A double cantilever beam: hands pull the legs of a sheet apart within it."""
    name, SIZE = "double cantilever beam", 160
    across = Strip.across

    def __init__(self, material, resolution):
        super().__init__(material, resolution)
        self.opening = self.height / 2

    @property
    def most_force(self):
        return self.thickness / self.height * math.sqrt(MOST_RELEASE / self.SIZE / 12) / self.LEGS

    def grips(self, sim):
        return BeamHands(sim, self)


class BeamHands(Hands):
    """They know the energy release rate of slender legs by their force."""

    def go(self, speed, torn):
        report = super().go(speed, torn)
        specimen = self.specimen
        moment = self.release / 2 * specimen.length_of(torn) * specimen.height
        self.release = 12 * moment**2 / specimen.material.modulus / specimen.height**3
        return report


def tension():
    bar = Bar((8, 24, 2))
    return Row("uniaxial tension", "strength, Pa", bar.strength, bar.breaking_stress(bar.strength))


def edge_notch():
    bar = Bar((20, 30, 2), notch=0.4)
    expected = bar.griffith_stress()
    return Row("single edge notch", "stress, Pa", expected, bar.breaking_stress(expected))


def toughness_of(kind, problem):
    specimen = kind(material_of(MATERIAL), RESOLUTION)
    specimen.calibrate()
    run = tear(specimen, SPEED, RESOLUTION)
    return Row(problem, "toughness, J/m²", specimen.material.toughness, run.found)


PROBLEMS = {"uniaxial tension": tension,
            "pure shear": lambda: toughness_of(Strip, "pure shear"),
            "single edge notch": edge_notch,
            "double cantilever beam": lambda: toughness_of(Beam, "double cantilever beam"),
            "trousers": lambda: toughness_of(Trouser, "trousers")}


# --- Report ---------------------------------------------------------------------------------------


def report_of(rows):
    return (
        "# Challenge problems of fracture\n\n"
        "Of the nine of arXiv 2507.00266 those that a straight cohesive front can do. Expected is "
        "the strength or toughness that was set; of the notched bar the stress at which a crack "
        "runs on, by finite elements. "
        f"Within {100 * MOST_ERROR:.0f} %: {sum(r.is_within for r in rows)} of {len(rows)}.\n\n"
        + table(["problem", "quantity", "expected", "found", "%", "within"],
                [[r.problem, r.quantity, f"{r.expected:.4g}",
                  "-" if r.found is None else f"{r.found:.4g}", percent(r.ratio),
                  "yes" if r.is_within else "no"] for r in rows])
        + "Not run:\n\n" + bullets([f"{name}. {why}" for name, why in OTHERS.items()]))


def failure_of(rows):
    """The first problem whose answer is off as a sentence, or ""."""
    return next((f"fracture: {r.problem}: " + ("it did not tear." if r.ratio is None else
                                               f"{percent(r.ratio)} % of what is expected.")
                 for r in rows if not r.is_within), "")


def summary_of(rows):
    return {"problems": [{**r._asdict(), "ratio": r.ratio, "within": r.is_within} for r in rows],
            "not_run": OTHERS}


def run(arguments):
    """Prints the report. Returns what is off as a sentence, or ""."""
    folder = arguments.out / "fracture"
    remove(folder, "summary.json", "report.md")
    rows = []
    for name, problem in PROBLEMS.items():
        progress(f"fracture: {name}")
        rows.append(problem())
    publish(arguments, folder, report_of(rows), summary_of(rows))
    return failure_of(rows)
