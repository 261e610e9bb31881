"""Kerf beside finite elements: the same bodies, cut, held and loaded."""

import dataclasses
import os
import typing

import kerf
import numpy as np
from scipy.spatial import cKDTree

from . import bodies, fem_pictures
from .fem_cases import POISSON_RATIO, TIME_STEP, all_cases
from .workshop import (NOT_GIVEN, percent, picture, progress, publish, remove, save_figure, section,
                       table, write_json)

#: The most by which Kerf may differ: sag, opening and volume as a share of those of the elements,
#: the shape as a share of the diagonal of the unloaded body.
BAR, SHAPE_BAR = 0.15, 0.05
WINDOW = 40  # steps between two looks
SETTLED = 1e-4  # change in a window, of how far the body has moved in all
MOST_SECONDS = 20  # of the load; then it has not settled
MOST_STEPS = 1_000_000
SAME_PLACE = 1e-6  # of coordinates, which Kerf has as floats [m]
NEAREST = 32  # triangles by their middles, of which one is the nearest


class Surface(typing.NamedTuple):
    """Of a body that is held and loaded."""
    rest: np.ndarray  #: per vertex, unloaded [m]
    positions: np.ndarray  #: per vertex, under the load [m]
    triangles: np.ndarray  #: outward
    walls: np.ndarray  #: per triangle: a cut made it


@dataclasses.dataclass
class Figures:
    """Measurements of a body under its load; None where one does not apply to it."""
    sag: typing.Optional[float]  #: [m]
    opening: typing.Optional[float]  #: [m]
    volume_ratio: float


@dataclasses.dataclass
class KerfRun:
    """Kerf's body at rest under its load."""
    surface: Surface
    settled: bool  #: False where it still moved when time was up
    steps: int  #: of the session
    state_hash: str  #: behind them


@dataclasses.dataclass
class Result:
    """A case that was run."""
    name: str
    body: str
    cut: str
    run: KerfRun
    kerf: Figures
    elements: Figures
    coarse: Figures  #: of elements of twice the size
    largest: float  #: distance of a vertex of either surface from the other one (Hausdorff) [m]
    mean: float  #: of all vertices of both [m]
    diagonal: float  #: of the unloaded body [m]

    @property
    def sag_deviation(self):
        return deviation(self.kerf.sag, self.elements.sag)

    @property
    def opening_deviation(self):
        return deviation(self.kerf.opening, self.elements.opening)

    @property
    def volume_deviation(self):
        return self.kerf.volume_ratio / self.elements.volume_ratio - 1

    @property
    def shape_share(self):
        return self.largest / self.diagonal

    def within(self):
        """Whether sag, opening, volume and shape are within the bars."""
        return [*map(is_within, (self.sag_deviation, self.opening_deviation,
                                 self.volume_deviation)), bool(self.shape_share <= SHAPE_BAR)]

    def holds(self):
        return all(self.within())

    def title(self):
        return f"{self.body}, cut: {self.cut}"


def deviation(ours, theirs):
    return None if ours is None or theirs is None else ours / theirs - 1


def is_within(share):
    return share is None or bool(abs(share) <= BAR)  # False where it is not a number


# --- Measures -------------------------------------------------------------------------------------


def elements_surface(case, fineness):
    solid = case.solid(fineness)
    skin = solid.mesh.skin()
    walls = (np.zeros(len(skin), bool) if case.cut_plane is None
             else (solid.mesh.nodes[skin, 0] == case.cut_plane).all(axis=1))
    return Surface(solid.mesh.nodes, solid.relaxed(), skin, walls)


def piece_surface(sim, vertex):
    """The piece of Kerf's body that holds a vertex."""
    mesh = sim.mesh
    own = mesh.piece == mesh.piece[(mesh.triangles == vertex).any(axis=1)][0]
    used, triangles = np.unique(mesh.triangles[own], return_inverse=True)
    return Surface(mesh.rest_positions[used], sim.positions[used], triangles.reshape(-1, 3),
                   mesh.cut[own])


def opening_of(surface):
    """Opening between the lips of a cut on the upper side, at z = 0 [m]; 0 without a cut.

    Lips are pairs of vertices that were one point before the cut.
    """
    at_top = np.flatnonzero(surface.rest[:, 1] > surface.rest[:, 1].max() - SAME_PLACE)
    _, place, count = np.unique(surface.rest[at_top], axis=0, return_inverse=True,
                                return_counts=True)
    pairs = np.array([at_top[place.ravel() == p] for p in np.flatnonzero(count == 2)])
    if len(pairs) == 0:
        return 0
    pairs = pairs[np.argsort(surface.rest[pairs[:, 0], 2], kind="stable")]
    z = surface.rest[pairs[:, 0], 2]
    gaps = surface.positions[pairs[:, 1]] - surface.positions[pairs[:, 0]]
    gaps *= np.sign(gaps[:, :1])  # from low to high x
    if not z[0] <= 0 < z[-1]:
        return 0
    return float(np.linalg.norm([np.interp(0, z, gap) for gap in gaps.T]))


def figures_of(case, surface):
    down = surface.rest[:, 1] - surface.positions[:, 1]
    sag = (down[abs(surface.rest[:, 0] - case.end) < SAME_PLACE].mean() if case.end is not None
           else surface.rest[:, 1].min() - surface.positions[:, 1].min() if case.hangs else None)
    ratio = (bodies.volume(surface.positions, surface.triangles)
             / bodies.volume(surface.rest, surface.triangles))
    return Figures(sag, opening_of(surface) if case.opens else None, ratio)


def distances(points, surface):
    """Of points from a surface under its load [m]."""
    corners = surface.positions[surface.triangles]
    middles = corners.mean(axis=1)
    reach = np.linalg.norm(corners - middles[:, None], axis=2).max()
    count = min(NEAREST, len(middles))
    away, near = cKDTree(middles).query(points, count)
    found = np.array([triangle_distances(p, corners[own]).min() for p, own in zip(points, near)])
    for i in np.flatnonzero(away[:, -1] - reach < found):  # another one might be nearer
        found[i] = triangle_distances(points[i], corners).min()
    return found


def triangle_distances(point, corners):
    """Of a point from triangles [n, 3 corners, 3]: from their planes, or from their sides."""
    best = np.full(len(corners), np.inf)
    inside = np.ones(len(corners), bool)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    for i in range(3):
        start, side = corners[:, i], corners[:, (i + 1) % 3] - corners[:, i]
        way = point - start
        along = np.clip((way * side).sum(axis=1) / (side * side).sum(axis=1), 0, 1)
        best = np.minimum(best, np.linalg.norm(way - along[:, None] * side, axis=1))
        inside &= (np.cross(side, way) * normal).sum(axis=1) >= 0
    height = abs(((point - corners[:, 0]) * normal).sum(axis=1)) / np.linalg.norm(normal, axis=1)
    return np.where(inside, height, best)


def shape_deviation(a, b):
    """The largest distance of a vertex of either from the other one, and the mean of all [m]."""
    def used(surface):
        return surface.positions[np.unique(surface.triangles)]

    every = np.concatenate([distances(used(a), b), distances(used(b), a)])
    return every.max(), every.mean()


# --- Runs -----------------------------------------------------------------------------------------


def run_kerf(case, folder):
    """Runs the session of a case until the body rests; leaves model and session for replays."""
    model = f"{case.name}.ply"
    points, triangles = case.model
    bodies.write_ply(folder / model, np.float32(points), triangles)  # as Kerf itself writes it
    session = {"format": "kerf-session", "version": 1, "model": {"path": model},
               "params": case.params, "steps": MOST_STEPS, "events": case.events}
    sim = kerf.Simulation.from_session(
        {**session, "model": {"path": os.path.abspath(folder / model)}}, undo_memory=0)
    sim.step(case.loaded + 1)
    used = np.unique(sim.mesh.triangles)
    away = np.linalg.norm(sim.mesh.rest_positions[used] - case.pinned, axis=1)
    vertex = used[away.argmin()]
    settled = settle(sim, vertex, case.loaded * TIME_STEP + MOST_SECONDS)
    write_json(folder / f"{case.name}.kerf.json", {**session, "steps": sim.step_count})
    return KerfRun(piece_surface(sim, vertex), settled, sim.step_count, sim.state_hash)


def settle(sim, vertex, seconds):
    """Steps until the piece that holds `vertex` stands still. False where it does not in time."""
    def largest_way(start, end):
        return np.linalg.norm(end - start, axis=1).max()

    before = piece_surface(sim, vertex).positions
    while sim.report.time < seconds:
        sim.step(WINDOW)
        now = piece_surface(sim, vertex)
        same = len(before) == len(now.positions)  # wounds are still being smoothed where it is not
        if same and (largest_way(before, now.positions)
                     <= SETTLED * largest_way(now.rest, now.positions)):
            return True
        before = now.positions
    return False


def run_case(case, folder, finest=2):
    """Runs a case, and its elements."""
    progress(f"fem: {case.name}, elements")
    elements, coarse = elements_surface(case, finest), elements_surface(case, 1)
    progress(f"fem: {case.name}")
    run, points = run_kerf(case, folder), case.model[0]
    result = Result(
        case.name, case.body, case.cut, run, figures_of(case, run.surface),
        figures_of(case, elements), figures_of(case, coarse),
        *shape_deviation(run.surface, elements),
        np.linalg.norm(points.max(axis=0) - points.min(axis=0)))
    save_figure(fem_pictures.figure_of(result.title(), run.surface, elements),
                folder / f"{case.name}.png")
    return result


# --- Report ---------------------------------------------------------------------------------------


def millimetres(length):
    return NOT_GIVEN if length is None else f"{1000 * length:.2f}"


def marked(share):
    """"+12.3", with an exclamation mark where it is beyond the bar."""
    return (NOT_GIVEN if share is None
            else f"{100 * share:+.1f}" + ("" if is_within(share) else " !"))


def main_table(results):
    return table(
        ["body", "cut", "sag, mm: Kerf", "elements", "%", "opening, mm: Kerf", "elements", "%",
         "volume, %: Kerf", "elements", "%", "shape, % of the diagonal: largest", "mean",
         "within the bars"],
        [[r.body, r.cut + ("" if r.run.settled else " (still moving)"),
          millimetres(r.kerf.sag), millimetres(r.elements.sag), marked(r.sag_deviation),
          millimetres(r.kerf.opening), millimetres(r.elements.opening), marked(r.opening_deviation),
          percent(r.kerf.volume_ratio), percent(r.elements.volume_ratio),
          marked(r.volume_deviation),
          f"{100 * r.shape_share:.2f}" + ("" if r.shape_share <= SHAPE_BAR else " !"),
          percent(r.mean / r.diagonal), "yes" if r.holds() else "no"] for r in results])


def count_table(results):
    """How many cases are within the bars."""
    measured = ([r for r in results if r.sag_deviation is not None],
                [r for r in results if r.opening_deviation is not None], results, results)
    counts = [f"{sum(r.within()[i] for r in some)} of {len(some)}"
              for i, some in enumerate(measured)]
    return table(["sag within 15 %", "opening within 15 %", "volume within 15 %",
                  "shape within 5 %", "all of these"],
                 [[*counts, f"{sum(r.holds() for r in results)} of {len(results)}"]])


def element_table(results):
    """The accuracy of the elements themselves."""
    return table(["body", "cut", "sag, %", "opening, %"],
                 [[r.body, r.cut, marked(deviation(r.coarse.sag, r.elements.sag)),
                   marked(deviation(r.coarse.opening, r.elements.opening))] for r in results])


def remarks(results):
    return section("Remarks", [
        f"{r.title()}: it still moved when time was up, so what stands there is not final."
        for r in results if not r.run.settled])


def report_of(results):
    return (
        "# Kerf beside finite elements\n\n"
        "The same bodies as Kerf's and as quadratic tetrahedra of a stable neo-Hookean solid, with "
        "the same Young's modulus of 100 kPa, density, pins and load. Poisson's ratio of the "
        f"elements is {POISSON_RATIO}; Kerf's bodies have none, and keep their volume. Cuts are "
        "made by a blade before the load, those of the elements are there from the start. Kerf's "
        "body is compared once it rests. *Sag* is how far the free end, or the lowest point, comes "
        "down, *opening* how far the lips stand apart in the middle. *Shape* is the distance of "
        "the vertices of either surface from the other one. An exclamation mark stands beyond a "
        "bar: 15 % of what the elements say, or 5 % of the diagonal.\n\n"
        + count_table(results) + main_table(results) + remarks(results)
        + "## How far the elements can be trusted\n\n"
          "What elements of twice the size give, against those above. The rest of their error is "
          "smaller than that.\n\n"
        + element_table(results) + "## Pictures\n\n"
        + "".join(picture(r.title(), f"{r.name}.png") for r in results))


def summary_of(results):
    return {"cases": [{
        "case": r.name, "body": r.body, "cut": r.cut,
        "settled": r.run.settled, "steps": r.run.steps, "state_hash": r.run.state_hash,
        "kerf": dataclasses.asdict(r.kerf), "elements": dataclasses.asdict(r.elements),
        "coarse_elements": dataclasses.asdict(r.coarse),
        "shape": {"largest": r.largest, "mean": r.mean, "diagonal": r.diagonal},
        "within_bars": r.holds(), "picture": f"{r.name}.png", "session": f"{r.name}.kerf.json",
    } for r in results]}


def run(arguments):
    """Prints the report. A value beyond a bar is no failure: returns ""."""
    folder = arguments.out / "fem"
    remove(folder, "summary.json", "report.md")
    results = [run_case(case, folder) for case in all_cases()]
    publish(arguments, folder, report_of(results), summary_of(results))
    return ""
