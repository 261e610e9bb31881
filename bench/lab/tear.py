"""Toughness found again where specimens tear, against the toughness that was set."""

import dataclasses
import json
import math
import typing

import numpy as np

from . import bodies, drawing
from .workshop import ROOT, picture, progress, publish, remove, save_figure, table

MATERIALS = ("gelatin", "silicone", "liver")
MOST_ERROR = 0.15
MOST_MISSING = 0.05

#: Without what is not measured. Without a strength no second tear begins elsewhere.
PARAMS = {"gravity": [0, 0, 0], "floor": None, "air_drag": 0, "true_modulus": 1,
          "wall_coarsening": 1, "bending_stiffness": 0, "tensile_strength": 1e9}
STEP = 4  # squares that a wave in a bar passes in a time step
ITERATIONS = 24  # in such a step
SHORTEST, LONGEST = 0.0005, 0.02  # of time steps [s]
RESOLUTIONS = ("coarse", "fine")
#: Of opening: the stretch at which it tears, in the time in which a wave passes the specimen.
SPEEDS = {"slow": 0.002, "medium": 0.004, "fast": 0.008}
LOADING_STEPS = 60
STARTS_AT = 0.75  # of the toughness: the energy release rate from which on it is pulled slowly
MOST_RELEASE = 2.5  # of the toughness: then it has not torn
WINDOW = (0.2, 0.6)  # of the ligament: while it tears, the toughness is read
TORN = 0.7  # of the ligament: then a run ends
MOST_STEPS = 4000
SIZE = (640, 360)  # of pictures [pixels]
FILES = ("summary.json", "report.md", "release.png")


class Material(typing.NamedTuple):
    """What specimens are made of."""
    name: str
    modulus: float  #: [Pa]
    density: float  #: [kg/m^3]
    toughness: float  #: [J/m^2]

    @property
    def length(self):
        """Toughness over modulus: specimens tear at a stretch that this sets [m]."""
        return self.toughness / self.modulus

    @property
    def wave(self):
        """Speed of a wave in a bar [m/s]."""
        return math.sqrt(self.modulus / self.density)


def material_of(name):
    values = json.loads((ROOT / f"assets/materials/{name}.json").read_text())
    return Material(name, *(values[key]["value"]
                            for key in ("youngs_modulus", "density", "toughness")))


#: Height of specimens, in lengths of the material: those of the softest stay within metres.
HEIGHT = {"gelatin": 600, "silicone": 100, "liver": 30}


class Point(typing.NamedTuple):
    """A moment of a test."""
    opening: float  #: of the pins [m]
    release: float  #: energy release rate [J/m^2]
    torn: float  #: area, as a share of the ligament's
    work: float  #: of the pins until now [J]
    strain: float  #: energy now [J]
    kinetic: float  #: energy now [J]
    fracture: float  #: energy of new surface until now [J]


@dataclasses.dataclass
class Run:
    """A specimen that was torn."""
    specimen: str
    material: Material
    resolution: str
    speed: str
    triangles: int
    opening_speed: float  #: [m/s]
    points: list
    image: object = None  #: while it tears

    @property
    def found(self):
        """The mean energy release rate while the tear goes on; None if it doesn't [J/m^2]."""
        low, high = WINDOW
        if self.points[-1].torn < high:
            return None
        read = [p for p in self.points if low <= p.torn <= high]
        shares = np.array([p.torn for p in read])
        rates = np.array([p.release for p in read])
        return float(np.trapz(rates, shares) / (shares[-1] - shares[0]))

    @property
    def ratio(self):
        return None if self.found is None else self.found / self.material.toughness

    @property
    def balance(self):
        """The share of the work that is found at the end as strain, motion and new surface."""
        end = self.points[-1]
        return (end.strain + end.kinetic + end.fracture) / end.work

    def __str__(self):
        return f"{self.specimen} of {self.material.name}, {self.resolution}, {self.speed}"


# --- Specimens ------------------------------------------------------------------------------------


class Strip:
    """Pure shear (Rivlin and Thomas 1953): a strip between two long grips, notched from one end.

    Where the tear runs, material that is strained evenly becomes material without strain. So the
    energy release rate is the density of strain energy far ahead of the tear, times the height.
    """
    name = "strip"
    squares = {"coarse": 16, "fine": 24}  #: over the height
    LENGTH, NOTCH = 2.5, 1  # in heights
    view = {"eye": [0, -0.5, 2.4], "target": [0, 0, 0]}  # in heights

    def __init__(self, material, resolution):
        self.material = material
        self.height = HEIGHT[material.name] * material.length
        self.square = self.height / self.squares[resolution]
        self.thickness = 2 * self.square
        self.length = self.LENGTH * self.height
        self.ligament = (self.length - self.NOTCH * self.height) * self.thickness
        self.opening = math.sqrt(2 * material.length * self.height)  # where it tears, about

    def body(self, length=None):
        size = np.array([length or self.length, self.height, self.thickness])
        return bodies.box(size, np.rint(size / self.square).astype(int))

    def grips(self, opening):
        """Where the pins are: low and high corners of two boxes."""
        for side in (1, -1):
            y = side * (self.height + opening) / 2
            yield side, np.array([-2 * self.length, y - 0.3 * self.square, -self.thickness]), (
                np.array([2 * self.length, y + 0.3 * self.square, self.thickness]))

    def cut(self, sim):
        slit(sim, -self.length / 2 - self.square, -self.length / 2 + self.NOTCH * self.height,
             0.1 * self.square, self.thickness)

    def calibrate(self):
        """Finds the energy release rate by opening: half a strip less, the ends are the same."""
        long, short = (loaded(self, self.body(length), 1.3 * self.opening)
                       for length in (self.length, self.length / 2))
        self.energy = Fit(long[0], (long[1] - short[1]) / (self.length / 2 * self.thickness))

    def release(self, opening, torn):
        """[J/m^2]"""
        del torn  # it goes on at the same rate
        return self.energy(opening)

    def force_exponent(self, opening):
        return self.energy.exponent(opening)


class Fit:
    """An energy over the opening: a square and a cube."""

    def __init__(self, openings, energies):
        terms = np.stack([openings**2, openings**3], axis=1)
        self.square, self.cube = np.linalg.lstsq(terms, energies, rcond=None)[0]

    def __call__(self, opening):
        return self.square * opening**2 + self.cube * opening**3

    def exponent(self, opening):
        """Opening times force over energy."""
        return 2 + self.cube * opening / (self.square + self.cube * opening)


def simulate(specimen, body):
    step = STEP * specimen.square / specimen.material.wave
    time_step = float(f"{min(max(step, SHORTEST), LONGEST):.3g}")
    iterations = max(4, math.ceil(ITERATIONS * time_step / step))
    return bodies.simulate(*body, material=specimen.material.name, params={
        **PARAMS, "time_step": time_step, "iterations": iterations})


def slit(sim, start, end, y, depth):
    """Cuts from x = start to x = end in a plane across y."""
    sim.move_blade([start, y, -depth], [start, y, depth])
    sim.step()
    sim.sweep([end, y, -depth], [end, y, depth], steps=30)
    sim.lift_blade()
    sim.step()


def pull(sim, specimen, opening, speed):
    """The grips go on from an opening at a speed [m, m/s]."""
    for side, low, high in specimen.grips(opening):
        sim.pin(low=low, high=high, velocity=[0, side * speed / 2, 0],
                seconds=MOST_STEPS * sim.params["time_step"])


def loaded(specimen, body, opening):
    """Openings and strain energies of a body that does not tear, without the first few."""
    sim = simulate(specimen, body)
    step = opening / LOADING_STEPS
    pull(sim, specimen, 0, step / sim.params["time_step"])
    energies = [sim.step().strain_energy for _ in range(LOADING_STEPS)]
    return step * np.arange(1, LOADING_STEPS + 1)[10:], np.array(energies)[10:]


def tear(specimen, speed, resolution):
    """Loads a notched specimen and pulls on until it is torn."""
    material = specimen.material
    sim = simulate(specimen, specimen.body())
    specimen.cut(sim)
    sim.set("tearing", 1)
    time_step = sim.params["time_step"]
    slow = SPEEDS[speed] * specimen.opening * material.wave / specimen.height
    fast = max(slow, specimen.opening / (LOADING_STEPS * time_step))
    pull(sim, specimen, 0, fast)
    run = Run(specimen.name, material, resolution, speed, len(sim.mesh.triangles), slow, [])
    opening, now, is_slow, work, fracture = 0.0, fast, False, 0.0, 0.0
    before = (0.0, 0.0)  # opening, force
    for _ in range(MOST_STEPS):
        release = specimen.release(opening, fracture / material.toughness / specimen.ligament)
        if not is_slow and release > STARTS_AT * material.toughness:
            is_slow, now = True, slow
            pull(sim, specimen, opening, now)
        report = sim.step()
        opening += now * time_step
        fracture += report.fracture_energy or 0
        force = specimen.force_exponent(opening) * report.strain_energy / opening
        work += (force + before[1]) / 2 * (opening - before[0])
        before = (opening, force)
        torn = fracture / material.toughness / specimen.ligament
        release = specimen.release(opening, torn)
        run.points.append(Point(opening, release, torn, work, report.strain_energy,
                                report.kinetic_energy, fracture))
        if run.image is None and torn > 0.45:
            run.image = sim.picture(*SIZE, view=scaled(specimen.view, specimen.height))
        if torn > TORN or release > MOST_RELEASE * material.toughness:
            break
    return run


def scaled(view, size):
    return {key: [size * x for x in place] for key, place in view.items()}


SPECIMENS = (Strip,)


# --- Report ---------------------------------------------------------------------------------------


def percent(ratio):
    return "-" if ratio is None else f"{100 * ratio:.0f}"


def rows_of(runs):
    """A row for each specimen, material and resolution, with a column for each speed."""
    rows = {}
    for run in runs:
        key = (run.specimen, run.material.name, run.resolution)
        rows.setdefault(key, {})[run.speed] = run
    return rows


def report_of(runs):
    speeds = list(dict.fromkeys(r.speed for r in runs))
    ratios = [[*key, *(percent(by[s].ratio) for s in speeds),
               *(percent(by[s].balance) for s in speeds)] for key, by in rows_of(runs).items()]
    within = sum(not missed(r) for r in runs)
    balanced = sum(abs(r.balance - 1) <= MOST_MISSING for r in runs)
    return (
        "# Toughness of tears\n\n"
        "Specimens with a notch are pulled apart by pins until they tear. The toughness found is "
        "the energy release rate while 20 to 60 % of the rest is torn, in per cent of the "
        "toughness that was set. Found again is the share of the pins' work that became strain, "
        "motion and new surface. The pins' force is that of an elastic body of this strain "
        f"energy.\n\nWithin {100 * MOST_ERROR:.0f} %: {within} of {len(runs)} runs. Work found "
        f"again within {100 * MOST_MISSING:.0f} %: {balanced} of {len(runs)}.\n\n"
        + table(["specimen", "material", "mesh", *(f"found, {s}, %" for s in speeds),
                 *(f"work, {s}, %" for s in speeds)], ratios)
        + picture("Energy release rate against torn area", "release.png")
        + "".join(picture(str(r), file_of(r)) for r in pictured(runs)))


def file_of(run):
    return f"{run.specimen}-{run.material.name}.png"


def pictured(runs):
    """The finest run of each specimen and material that has a picture."""
    return list({(r.specimen, r.material.name): r for r in runs if r.image is not None}.values())


def missed(run):
    return run.ratio is None or abs(run.ratio - 1) > MOST_ERROR


def summary_of(run):
    end = run.points[-1]
    return {"specimen": run.specimen, "material": run.material.name, "mesh": run.resolution,
            "speed": run.speed, "triangles": run.triangles, "opening_speed": run.opening_speed,
            "toughness": run.material.toughness, "found": run.found, "ratio": run.ratio,
            "work": end.work, "strain": end.strain, "kinetic": end.kinetic,
            "fracture": end.fracture, "balance": run.balance, "steps": len(run.points)}


def plot_of(runs):
    names = list(dict.fromkeys((r.specimen, r.material.name) for r in runs))
    figure, axes = drawing.panels(math.ceil(len(names) / 3), min(3, len(names)), 420, 280)
    colors = dict(zip(SPEEDS, (drawing.BLUE, drawing.GREEN, drawing.VERMILLION)))
    for name, panel in zip(names, axes.flat):
        for run in runs:
            if (run.specimen, run.material.name) == name:
                torn, rate = np.array([(100 * p.torn, p.release) for p in run.points]).T
                panel.plot(torn, rate / run.material.toughness, color=colors[run.speed],
                           linestyle="-" if run.resolution == "fine" else ":",
                           label=f"{run.speed}, {run.resolution}")
        panel.axhline(1, color=drawing.GRAY, linestyle="--")
        panel.set(xlabel="torn, %", ylabel="release rate over toughness", ylim=(0, 2),
                  title=f"{name[0]}, {name[1]}")
    axes.flat[0].legend(loc="lower right", fontsize=8)
    for panel in list(axes.flat)[len(names):]:
        panel.set_visible(False)
    return figure


def cases(quick):
    """What is torn: specimen, material, resolution and its speeds."""
    for specimen in SPECIMENS:
        for name in MATERIALS[:1] if quick else MATERIALS:
            for resolution in RESOLUTIONS[:1] if quick else RESOLUTIONS:
                yield specimen, name, resolution, ["fast"] if quick else list(SPEEDS)


def failure_of(runs):
    """The first run whose toughness or work was not found again as a sentence, or ""."""
    for run in runs:
        if run.ratio is None:
            return f"tear: {run}: it did not tear."
        if missed(run):
            return f"tear: {run}: {percent(run.ratio)} % of the toughness are found."
        if abs(run.balance - 1) > MOST_MISSING:
            return f"tear: {run}: {percent(run.balance)} % of the work are found again."
    return ""


def run(arguments):
    """Prints the report. Returns what was not found again as a sentence, or ""."""
    folder = arguments.out / "tear"
    remove(folder, *FILES, *(f"{s.name}-{m}.png" for s in SPECIMENS for m in MATERIALS))
    runs = []
    for kind, name, resolution, speeds in cases(arguments.quick):
        progress(f"tear: {kind.name} of {name}, {resolution}")
        specimen = kind(material_of(name), resolution)
        specimen.calibrate()
        runs += [tear(specimen, speed, resolution) for speed in speeds]
    for done in pictured(runs):
        save_figure(drawing.strip(str(done), [(done.image, "")]), folder / file_of(done))
    save_figure(plot_of(runs), folder / "release.png")
    publish(arguments, folder, report_of(runs), {"runs": [summary_of(r) for r in runs]})
    return failure_of(runs)
