"""The force on a blade that goes down into blocks of different materials."""

import dataclasses
import typing

import numpy as np

from . import bodies, drawing
from .workshop import picture, progress, publish, remove, save_figure, table, write

SIZE = 0.06  # of the block [m]
CELLS = 12  # across it
SPEED = 0.02  # of the blade [m/s]
ABOVE = 0.002  # where it starts [m]
DEPTH = 0.04  # to which it is led [m]
ASIDE = 0.0007  # of the middle, where no edge of the mesh is [m]
MOST_MISSING = 0.05
FILES = ("summary.json", "report.md", "forces.csv", "forces.png")

#: Without what is not measured: gravity, damping.
PARAMS = {"gravity": [0, 0, 0], "floor": None, "air_drag": 2, "damping": 0, "blade_feels": 1}
#: Label, material, bluntness of the blade.
WANTED = [("gelatin, sharp blade", "gelatin", 0), ("gelatin, blunter blade", "gelatin", 0.5),
          ("cheese", "cheese", 0.5), ("tofu", "tofu", 0.5)]


class Point(typing.NamedTuple):
    """A moment of a blade on its way down."""
    depth: float  #: of the blade as it is led, from the uncut surface [m]
    force: float  #: upwards, on the blade [N]
    work: float  #: of what led the blade, until now [J]
    gained: float  #: energy of the body and of the edge's spring now [J]
    fracture: float  #: energy of the new surface until now [J]
    drag: float  #: energy that air drag has taken until now [J]


@dataclasses.dataclass
class Run:
    """The forces on a blade in one material."""
    label: str
    params: dict
    points: list

    @property
    def expected(self):
        """The force that a cut as wide as the block takes by itself [N]."""
        return self.params["toughness"] * SIZE

    @property
    def rupture(self):
        """Where the force was highest until the blade had broken in."""
        broken = next((i for i, p in enumerate(self.points) if p.fracture > 0), len(self.points))
        return max(self.points[:broken + 1], key=lambda p: p.force)

    @property
    def plateau(self):
        """The mean force from a tenth of the block behind that on [N]."""
        even = [p.force for p in self.points if p.depth >= self.rupture.depth + 0.1 * SIZE]
        return sum(even) / len(even) if even else 0

    @property
    def found(self):
        """The share of the work found at the end as energy gained, new surface and drag."""
        end = self.points[-1]
        return (end.gained + end.fracture + end.drag) / end.work


def measure(label, params, material=None):
    """Moves a blade down into a block that stands on its pinned bottom."""
    points, triangles = bodies.box([SIZE] * 3, [CELLS] * 3)
    sim = bodies.simulate(points + [0, SIZE / 2, 0], triangles, material=material, params=params)
    low = 0.25 * SIZE / CELLS
    sim.pin(low=[-1, -low, -1], high=[1, low, 1])
    run = Run(label, sim.params, [])
    step, drag = run.params["time_step"], run.params["air_drag"]
    point = Point(0, 0, 0, 0, 0, 0)
    depth = -ABOVE
    while depth < DEPTH:
        sim.move_blade([ASIDE, SIZE - depth, -SIZE], [ASIDE, SIZE - depth, SIZE])
        report = sim.step()
        point = Point(
            depth, 0 if report.blade_force is None else float(report.blade_force[1]),
            point.work + report.blade_work,
            report.kinetic_energy + (report.strain_energy or 0) + report.blade_energy,
            point.fracture + (report.fracture_energy or 0),
            point.drag + 2 * drag * report.kinetic_energy * step)
        run.points.append(point)
        depth += SPEED * step
    return run


def summary_of(run):
    end = run.points[-1]
    return {"material": run.label, "youngs_modulus": run.params["youngs_modulus"],
            "toughness": run.params["toughness"], "bluntness": run.params["blade_bluntness"],
            "rupture_force": run.rupture.force, "rupture_depth": run.rupture.depth,
            "plateau_force": run.plateau, "expected_force": run.expected, "work": end.work,
            "gained": end.gained, "fracture": end.fracture, "drag": end.drag, "found": run.found}


def report_of(runs):
    return (
        "# The force on a blade\n\n"
        "A blade goes down into a block of 6 cm, at 2 cm/s. First the material yields and the "
        "force rises; then it breaks in, and goes on at a plateau. What new surface takes is "
        "toughness times width: the plateau lies there by theory. Found again is the share of the "
        "blade's work that became energy of the body, new surface and air drag.\n\n"
        + table(["material", "E, Pa", "toughness, J/m²", "bluntness", "breaks in at, N",
                 "depth, mm", "plateau, N", "toughness times width, N", "found again, %"],
                [[r.label, f"{r.params['youngs_modulus']:.3g}", f"{r.params['toughness']:.3g}",
                  f"{r.params['blade_bluntness']:.2g}", f"{r.rupture.force:.3g}",
                  f"{1000 * r.rupture.depth:.1f}", f"{r.plateau:.3g}", f"{r.expected:.3g}",
                  f"{100 * r.found:.1f}"] for r in runs])
        + picture("Force against depth", "forces.png"))


def plot_of(runs):
    figure, axes = drawing.panels(2, 2, 560, 320)
    for run, panel in zip(runs, axes.flat):
        depth, force = np.array([(1000 * p.depth, p.force) for p in run.points]).T
        panel.plot(depth, force, color=drawing.BLUE, label="force")
        panel.axhline(run.expected, color=drawing.GRAY, linestyle="--",
                      label="toughness times width")
        panel.plot(1000 * run.rupture.depth, run.rupture.force, "v", color=drawing.VERMILLION,
                   label="breaks in")
        panel.set(xlabel="depth, mm", ylabel="force on the blade, N", ylim=(0, None),
                  title=f"{run.label}: toughness {run.params['toughness']:.3g} J/m², bluntness "
                        f"{run.params['blade_bluntness']:.2g}")
        panel.legend(loc="best")
    return figure


def run(arguments):
    """Prints the report. Returns a sentence on work that was not found again, or ""."""
    folder = arguments.out / "blade"
    remove(folder, *FILES)
    runs = []
    for label, material, bluntness in WANTED:
        progress(f"blade: {label}")
        runs.append(measure(label, {**PARAMS, "blade_bluntness": bluntness}, material))
    write(folder / "forces.csv", ",".join(["material", *Point._fields]) + "\n" + "".join(
        ",".join([f'"{r.label}"', *map(repr, p)]) + "\n" for r in runs for p in r.points))
    save_figure(plot_of(runs), folder / "forces.png")
    publish(arguments, folder, report_of(runs), {"runs": [summary_of(r) for r in runs]})
    return next((f"blade: {r.label}: {100 * r.found:.1f} % of the work are found again."
                 for r in runs if not abs(r.found - 1) < MOST_MISSING), "")
