"""Toughness found again where specimens tear, against the toughness that was set."""

import dataclasses
import json
import math
import typing

import numpy as np

from . import bodies, drawing
from .legs import StoredEnergy
from .workshop import ROOT, picture, progress, publish, remove, save_figure, table

MATERIALS = ("gelatin", "silicone", "liver")
MOST_ERROR = 0.15
MOST_MISSING = 0.05

#: Without what is not measured. Without a strength no second tear begins elsewhere.
PARAMS = {"gravity": [0, 0, 0], "floor": None, "air_drag": 0, "damping": 0, "wall_coarsening": 1,
          "tensile_strength": 1e9}
STEP = 2  # squares that a wave in a bar passes in a time step
ITERATIONS = 24  # in such a step
SHORTEST, LONGEST = 0.0005, 0.02  # of time steps [s]
RESOLUTIONS = ("coarse", "fine")
#: Of opening: the stretch at which it tears, in the time in which a wave passes the specimen.
SPEEDS = {"slow": 0.002, "medium": 0.004, "fast": 0.008}
HAND_RATE = 120  # of the springs of hands, as docs/physics.md has it [1/s]
FAR = 1e3  # radius of a hand that holds an edge, in heights: its ball is flat there
SOFT = 1e3  # modulus at which hands are firm, to measure forces; they are in proportion to it [Pa]
DENSITIES = 10, 20000  # that a body may have [kg/m^3]
STARTS_AT = 0.65  # of the toughness: the energy release rate from which on it is pulled slowly
MOST_RELEASE = 4  # of the toughness: then it has not torn
MOST_OPENING = 15  # of that at which it was to tear
MOST_STEPS = 8000
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

    def held_firmly(self, length):
        """As heavy as makes hands firm: a wave passes `length` while they settle."""
        density = self.modulus / (HAND_RATE * length)**2
        return self._replace(density=float(np.clip(density, *DENSITIES)))


def material_of(name):
    values = json.loads((ROOT / f"assets/materials/{name}.json").read_text())
    return Material(name, *(values[key]["value"]
                            for key in ("youngs_modulus", "density", "toughness")))


#: Height of specimens, in lengths of the material: those of the softest stay within metres.
HEIGHT = {"gelatin": 600, "silicone": 200, "liver": 30}


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
    specimen: typing.Any
    resolution: str
    speed: str
    triangles: int
    opening_speed: float  #: [m/s]
    points: list
    image: object = None  #: while it tears

    @property
    def material(self):
        return self.specimen.material

    @property
    def read(self):
        """The points from which the toughness is read; none if it did not tear on."""
        low, high = self.specimen.WINDOW
        return ([p for p in self.points if low <= p.torn <= high]
                if self.points[-1].torn >= high else [])

    @property
    def found(self):
        """The toughness, or None if it did not tear on [J/m^2]."""
        return self.specimen.toughness_from(self.read) if self.read else None

    @property
    def ratio(self):
        return None if self.found is None else self.found / self.material.toughness

    @property
    def balance(self):
        """The share of the work that is found at the end as strain, motion and new surface."""
        end = self.points[-1]
        return (end.strain + end.kinetic + end.fracture) / end.work

    def __str__(self):
        return f"{self.specimen.name} of {self.material.name}, {self.resolution}, {self.speed}"


# --- Specimens ------------------------------------------------------------------------------------


class Strip:
    """Pure shear (Rivlin and Thomas 1953): a strip between two long grips, notched from one end.

    Where the tear runs, material that is strained evenly becomes material without strain. So the
    energy release rate is the density of strain energy far ahead of the tear, times the height.
    """
    name = "strip"
    squares = {"coarse": 16, "fine": 24}  #: over the height
    LENGTH, NOTCH = 2.5, 1  # in heights
    WINDOW, torn, pace, loading = (0.2, 0.6), 0.7, 1, 10
    view = {"eye": [0, -0.5, 2.4], "target": [0, 0, 0]}  # in heights
    across = np.array([0, 1, 0])  #: it is pulled apart along y

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

    def toughness_from(self, points):
        return mean_release(points)

    def grips(self, sim):
        return Pins(sim, self)

    def held(self, opening):
        """Where the pins are: a side, low and high corners of two boxes."""
        for side in (1, -1):
            y = side * (self.height + opening) / 2
            yield side, np.array([-2 * self.length, y - 0.3 * self.square, -self.thickness]), (
                np.array([2 * self.length, y + 0.3 * self.square, self.thickness]))

    def hands(self):
        return edges(self, self.height / 2 - 0.3 * self.square)

    def cut(self, sim, length=NOTCH):
        slit(sim, -self.length / 2 - self.square, -self.length / 2 + length * self.height,
             0.5 * self.square, self.thickness)

    def calibrate(self):
        """Finds the energy release rate by opening: half a strip less, the ends are the same."""
        long, short = (Fit(*loaded(self, self.body(length), 1.3 * self.opening))
                       for length in (self.length, self.length / 2))
        self.energy = (long - short) / (self.length / 2 * self.thickness)
        self.notched = Fit(*loaded(self, self.body(), 1.3 * self.opening, self.NOTCH))

    def release(self, opening, torn):
        """[J/m^2]"""
        del torn  # it goes on at the same rate
        return self.energy(opening)

    def force(self, opening, torn):
        """Of the pins [N]."""
        return self.notched.slope(opening) - torn * self.ligament * self.energy.slope(opening)


class Ring:
    """A ring that is pulled apart, notched from inside where it is bent most.

    The energy release rate is what the strain energy loses by torn area at a held opening (Irwin
    and Kies 1954), of rings with longer notches that don't tear.
    """
    name = "ring"
    squares = {"coarse": 12, "fine": 16}  #: across the ring
    INNER, OUTER = 0.5, 1.5  # radii, in widths of the ring
    NOTCH, LONGER = 0.3, (0.3, 0.45, 0.6, 0.75)  # in widths
    WINDOW, torn, pace, loading = (0.2, 0.6), 0.7, 1, 40
    view = {"eye": [0.6, -0.6, 5.2], "target": [0, 0, 0]}  # in widths
    across = Strip.across

    def __init__(self, material, resolution):
        self.material = material
        self.height = HEIGHT[material.name] * material.length
        self.square = self.height / self.squares[resolution]
        self.thickness = 2 * self.square
        self.ligament = (1 - self.NOTCH) * self.height * self.thickness
        self.opening = 0.1 * self.height  # for a start

    def body(self):
        across = round(self.height / self.square)
        around = 2 * round(np.pi * (self.INNER + self.OUTER) / 2 * across)
        return bodies.ring(self.INNER * self.height, self.OUTER * self.height, self.thickness,
                           [across, around, 2])

    def toughness_from(self, points):
        return mean_release(points)

    def grips(self, sim):
        return Pins(sim, self)

    def held(self, opening):
        """Where the pins are: a side, low and high corners of two boxes."""
        for side in (1, -1):
            y = side * (self.OUTER * self.height + opening / 2)
            half = np.array([2, 0.12, 1]) * self.height
            yield side, np.array([0, y, 0]) - half, np.array([0, y, 0]) + half

    def hands(self):
        return edges(self, (self.OUTER - 0.12) * self.height)

    def cut(self, sim, length=NOTCH):
        start = self.INNER * self.height
        slit(sim, start - self.square, start + length * self.height, 0.1 * self.square,
             self.thickness)

    def calibrate(self):
        """Finds the energies by opening and length of the notch."""
        for lengths in (self.LONGER[:2], self.LONGER):
            fits = [Fit(*loaded(self, self.body(), 1.3 * self.opening, length))
                    for length in lengths]
            self.by_length = [np.polyfit(lengths, values, len(lengths) - 1)
                              for values in zip(*(f.terms for f in fits))]
            self.opening *= math.sqrt(self.material.toughness / self.release(self.opening, 0))

    def release(self, opening, torn):
        """[J/m^2]"""
        by_length = Fit.of(np.polyval(np.polyder(fit), self.length_of(torn))
                           for fit in self.by_length)
        return -by_length(opening) / (self.height * self.thickness)

    def force(self, opening, torn):
        """Of the pins [N]."""
        length = self.length_of(torn)
        return Fit.of(np.polyval(fit, length) for fit in self.by_length).slope(opening)

    def length_of(self, torn):
        """Of the notch, in widths."""
        return self.NOTCH + (1 - self.NOTCH) * torn


class Trouser:
    """A sheet with two legs that hands pull apart across it (Rivlin and Thomas 1953).

    The toughness is the hands' work, less what the legs store by finite elements as they get
    longer, over the torn area. 2 F over the thickness is the energy release rate of long legs
    alone: it tells when to pull slowly.
    """
    name = "trouser"
    squares = {"coarse": 4.5, "fine": 6.5}  #: over a leg: the slit lies amid squares
    SIZE = 40  # a leg's width, in material lengths
    LENGTH, LEGS, REACH = 6, 2, 0.45  # in widths of a leg
    WINDOW, torn, pace, loading = (0.2, 0.45), 0.5, 1.5, 20
    view = {"eye": [-3.5, -7, 5], "target": [-0.5, 0, 0]}  # in widths of a leg
    across = np.array([0, 0, 1])

    def __init__(self, material, resolution):
        self.height = self.SIZE * material.length
        self.material = material.held_firmly(self.height)
        self.square = self.height / self.squares[resolution]
        self.thickness = 2 * self.square
        self.length = self.LENGTH * self.height
        self.ligament = (self.LENGTH - self.LEGS) * self.height * self.thickness
        self.opening = self.height

    def body(self):
        size = np.array([self.length, 2 * self.height, self.thickness])
        return bodies.box(size, np.rint(size / self.square).astype(int))

    def cut(self, sim):
        slit(sim, -self.length / 2 - self.square, -self.length / 2 + self.LEGS * self.height,
             0, self.thickness)

    def hands(self):
        """A side, where its hand is, and its reach."""
        return [(side, [-self.length / 2, side * self.height / 2, 0], self.REACH * self.height)
                for side in (1, -1)]

    @property
    def hand_stiffness(self):
        """Of hands in a unit of volume, for a leg whose width and modulus are 1."""
        return self.material.density * (HAND_RATE * self.height)**2 / self.material.modulus

    @property
    def most_force(self):
        """At which it has not torn, in the same units."""
        return MOST_RELEASE * self.thickness / self.height / self.SIZE / 2

    def calibrate(self):
        """Finds what the legs store by opening and length of the slit. The force is measured."""
        self.stored = StoredEnergy(self)

    def toughness_from(self, points):
        """[J/m^2]"""
        start, end = points[0], points[-1]
        released = end.work - self.energy(end) - start.work + self.energy(start)
        return released / ((end.torn - start.torn) * self.ligament)

    def energy(self, point):
        """What the legs store [J]."""
        return self.stored(point.opening, self.length_of(point.torn))

    def length_of(self, torn):
        """Of the slit, in widths of a leg."""
        return self.LEGS + (self.LENGTH - self.LEGS) * torn

    def grips(self, sim):
        return Hands(sim, self)


class Hands:
    """Two hands that pull a specimen apart. Their work is measured."""

    def __init__(self, sim, specimen):
        self.sim, self.specimen, self.work, self.release = sim, specimen, 0, 0
        self.led = self.opening = 0  # where they are led, and by how much it has opened
        params = sim.params
        self.step = params["time_step"]
        self.speed = 0
        wave = math.sqrt(params["youngs_modulus"] / params["density"])
        self.quickens = min(1, self.step * wave / specimen.height / 2)  # without a jerk
        self.hands = []
        for number, (side, at, reach) in enumerate(specimen.hands()):
            sim.grab(at, reach, hand=number)
            held = np.flatnonzero(np.linalg.norm(sim.positions - at, axis=1) <= reach)
            self.hands.append((side * specimen.across / 2, at, held, sim.positions[held]))

    def go(self, speed, torn):
        """A step towards a speed of opening [m/s]."""
        del torn
        before, mass = self.sim.positions, masses(self.sim)
        self.speed += (speed - self.speed) * self.quickens
        self.led += self.speed * self.step
        for number, (way, at, *_) in enumerate(self.hands):
            self.sim.drag(list(at + way * self.led), hand=number)
        report = self.sim.step()
        force = self.opening = 0
        for way, _, held, rest in self.hands:
            now, moved = self.sim.positions[held], self.sim.positions[held] - before[held]
            # In the mean over an implicit step, in which the hand goes where it is led.
            led = way * (self.led - self.speed * self.step / report.implicit_steps / 2)
            pull = mass[held][:, None] * (
                HAND_RATE**2 * (rest + led - now + moved / 2)
                + 2 * HAND_RATE * (way * self.speed - moved / self.step))
            self.work += (pull * moved).sum()
            force += (pull @ way).sum()
            self.opening += 2 * ((now - rest) @ way).mean()
        self.release = 2 * force / self.specimen.thickness
        return report


class Pins:
    """Moving pins that hold both ends of a specimen."""

    def __init__(self, sim, specimen):
        self.sim, self.specimen, self.opening, self.work, self.release = sim, specimen, 0, 0, 0
        self.step = sim.params["time_step"]
        self.speed, self.force = 0, 0

    def go(self, speed, torn):
        """A step at a speed of opening [m/s]; `torn`: of the ligament before it."""
        if speed != self.speed:
            pull(self.sim, self.specimen, self.opening, speed)
            self.speed = speed
        report = self.sim.step()
        self.opening += speed * self.step
        force = self.specimen.force(self.opening, torn)
        self.work += (force + self.force) / 2 * speed * self.step
        self.force = force
        self.release = self.specimen.release(self.opening, torn)
        return report


def mean_release(points):
    """The mean energy release rate by torn area [J/m^2]."""
    torn, rates = np.array([(p.torn, p.release) for p in points]).T
    return float(np.trapz(rates, torn) / (torn[-1] - torn[0]))


def masses(sim):
    """Of each vertex: its share of the area, as of the whole [kg]."""
    points, triangles = np.asarray(sim.mesh.rest_positions), np.asarray(sim.mesh.triangles)
    shares = np.zeros(len(points))
    np.add.at(shares, triangles, bodies.areas(points, triangles)[:, None] / 3)
    return sim.params["density"] * bodies.volume(points, triangles) * shares / shares.sum()


class Fit:
    """An energy over the opening: a square and a cube."""

    def __init__(self, openings, energies):
        terms = np.stack([openings**2, openings**3], axis=1)
        self.terms = np.linalg.lstsq(terms, energies, rcond=None)[0]

    @classmethod
    def of(cls, terms):
        fit = cls.__new__(cls)
        fit.terms = np.array(list(terms))
        return fit

    def __sub__(self, other):
        return Fit.of(self.terms - other.terms)

    def __truediv__(self, number):
        return Fit.of(self.terms / number)

    def __call__(self, opening):
        return self.terms @ [opening**2, opening**3]

    def slope(self, opening):
        return self.terms @ [2 * opening, 3 * opening**2]


def simulate(specimen, body, material):
    step = STEP * specimen.square / material.wave
    time_step = float(f"{min(max(step, SHORTEST), LONGEST):.3g}")
    iterations = max(4, math.ceil(ITERATIONS * time_step / step))
    return bodies.simulate(*body, material=material.name, params={
        **PARAMS, "time_step": time_step, "iterations": iterations, "density": material.density,
        "youngs_modulus": material.modulus, "toughness": material.toughness})


def edges(specimen, height):
    """Hands that hold all beyond a height: a side, where its hand is, and its reach."""
    reach = FAR * specimen.height
    return [(side, [0, side * (height + reach), 0], reach) for side in (1, -1)]


def slit(sim, start, end, y, depth):
    """Cuts from x = start to x = end in a plane across y."""
    sim.move_blade([start, y, -depth], [start, y, depth])
    sim.step()
    sim.sweep([end, y, -depth], [end, y, depth], steps=30)
    sim.lift_blade()
    sim.step()


def pull(sim, specimen, opening, speed):
    """The grips go on from an opening at a speed [m, m/s]."""
    for side, low, high in specimen.held(opening):
        sim.pin(low=low, high=high, velocity=[0, side * speed / 2, 0],
                seconds=MOST_STEPS * sim.params["time_step"])


def loaded(specimen, body, opening, notch=0):
    """Openings and measured works of hands on a body that does not tear, without the first few.

    They are those of a soft body of this shape, by its modulus.
    """
    material = specimen.material._replace(modulus=SOFT).held_firmly(specimen.square)
    sim = simulate(specimen, body, material)
    if notch:
        specimen.cut(sim, notch)
    hands = Hands(sim, specimen)
    speed = opening / loading_time(specimen, material)
    points = []
    while hands.opening < opening:
        hands.go(speed, 0)
        points.append((hands.opening, hands.work * specimen.material.modulus / SOFT))
    return np.array(points[len(points) // 6:]).T


def loading_time(specimen, material):
    """Long against the specimen's slowest swing [s]."""
    return specimen.loading * specimen.height / material.wave


def tear(specimen, speed, resolution):
    """Loads a notched specimen and pulls on until it is torn."""
    material = specimen.material
    sim = simulate(specimen, specimen.body(), material)
    specimen.cut(sim)
    sim.set("tearing", 1)
    slow = SPEEDS[speed] * specimen.opening * material.wave / specimen.height * specimen.pace
    fast = max(slow, specimen.opening / loading_time(specimen, material))
    run = Run(specimen, resolution, speed, len(sim.mesh.triangles), slow, [])
    grips, now, fracture, torn = specimen.grips(sim), fast, 0.0, 0.0
    for _ in range(MOST_STEPS):
        if grips.release > STARTS_AT * material.toughness:
            now = slow
        report = grips.go(now, torn)
        fracture += report.fracture_energy or 0
        torn = fracture / material.toughness / specimen.ligament
        run.points.append(Point(grips.opening, grips.release, torn, grips.work,
                                report.strain_energy, report.kinetic_energy, fracture))
        if run.image is None and torn > 0.6 * specimen.torn:
            run.image = sim.picture(*SIZE, view=scaled(specimen.view, specimen.height))
        if (torn > specimen.torn or grips.release > MOST_RELEASE * material.toughness
                or grips.opening > MOST_OPENING * specimen.opening):
            break
    return run


def scaled(view, size):
    return {key: [size * x for x in place] for key, place in view.items()}


SPECIMENS = (Strip, Ring, Trouser)


# --- Report ---------------------------------------------------------------------------------------


def percent(ratio):
    return "-" if ratio is None else f"{100 * ratio:.0f}"


def rows_of(runs):
    """A row for each specimen, material and resolution, with a column for each speed."""
    rows = {}
    for run in runs:
        key = (run.specimen.name, run.material.name, run.resolution)
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
        "Specimens with a notch are pulled apart until they tear: strips and rings by pins, the "
        "legs of trousers by hands. The toughness found is the energy release rate while it tears, "
        "in per cent of the toughness that was set; a dash where it did not tear on. Work is the "
        "share that is found again as strain, motion and new surface; the rest is dissipated. That "
        "of hands is measured. The force of pins is that of hands on specimens that don't tear, "
        "with shorter and longer notches.\n\n"
        f"Within {100 * MOST_ERROR:.0f} %: {within} of {len(runs)} runs. Work found "
        f"again within {100 * MOST_MISSING:.0f} %: {balanced} of {len(runs)}.\n\n"
        + table(["specimen", "material", "mesh", *(f"found, {s}, %" for s in speeds),
                 *(f"work, {s}, %" for s in speeds)], ratios)
        + picture("Energy release rate against torn area", "release.png")
        + "".join(picture(str(r), file_of(r)) for r in pictured(runs)))


def file_of(run):
    return f"{run.specimen.name}-{run.material.name}.png"


def pictured(runs):
    """The finest run of each specimen and material that has a picture."""
    by_name = {(r.specimen.name, r.material.name): r for r in runs if r.image is not None}
    return list(by_name.values())


def missed(run):
    return run.ratio is None or abs(run.ratio - 1) > MOST_ERROR


def summary_of(run):
    end = run.points[-1]
    return {"specimen": run.specimen.name, "material": run.material.name, "mesh": run.resolution,
            "speed": run.speed, "triangles": run.triangles, "opening_speed": run.opening_speed,
            "toughness": run.material.toughness, "found": run.found, "ratio": run.ratio,
            "work": end.work, "strain": end.strain, "kinetic": end.kinetic,
            "fracture": end.fracture, "balance": run.balance, "steps": len(run.points)}


def plot_of(runs):
    names = list(dict.fromkeys((r.specimen.name, r.material.name) for r in runs))
    figure, axes = drawing.panels(math.ceil(len(names) / 3), min(3, len(names)), 420, 280)
    colors = dict(zip(SPEEDS, (drawing.BLUE, drawing.GREEN, drawing.VERMILLION)))
    for name, panel in zip(names, axes.flat):
        for run in runs:
            if (run.specimen.name, run.material.name) == name:
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
