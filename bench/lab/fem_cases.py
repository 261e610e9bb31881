"""Bodies that are cut, held and loaded, for Kerf and as finite elements."""

import dataclasses
import math
import typing

import numpy as np

from . import bodies
from .fem_solid import Solid, lines_through, solid_ball, solid_box

MODULUS = 1e5  # [Pa]
POISSON_RATIO = 0.45  # of the elements: Kerf's bodies have none, and keep their volume
DENSITY = 1000  # [kg/m^3]
HAIR = 1e-5  # around places, since Kerf has them as floats [m]
TIME_STEP = 0.005  # [s]
PARAMS = {"youngs_modulus": MODULUS, "density": DENSITY, "time_step": TIME_STEP,
          "gravity": [0, 0, 0], "floor": None, "air_drag": 6}  # comes to rest soon
BLADE_SPEED = 1  # [m/s]
CLEARANCE = 0.03  # of the blade above the body and beside it [m]

# The bar: along x, clamped at its lower end, notched from above.
BAR, BAR_CELLS = np.array([0.4, 0.1, 0.1]), (16, 4, 4)
NOTCH_AT = -0.1125  # between planes of Kerf's squares
BAR_GRAVITY = 0.4  # [m/s^2]: the whole bar sags by 4 % of its length
DEPTHS = (0, 25, 50, 75)  # [%]

# The slab: drawn apart along x, with an incision across from above.
SLAB, SLAB_CELLS = np.array([0.3, 0.1, 0.2]), (13, 4, 7)
INCISION_HALF = 0.05  # [m]
STRETCH, STRETCH_STEPS = 0.2, 100  # of its length

# The ball: hangs by the half of a cap around its top, x > 0.
RADIUS, ROWS = 0.5, 8
PINNED_ROWS = 4  # of triangles from the top on
BALL_GRAVITY = 5  # [m/s^2]


@dataclasses.dataclass
class Case:
    """One body, for both."""
    name: str  #: of its folder: "bar-50"
    body: str  #: "notched bar"
    cut: str  #: "50 % of its height"
    model: typing.Tuple[np.ndarray, np.ndarray]  #: points and triangles that Kerf cuts, at rest
    events: list  #: of a session: pins, stroke, load
    loaded: int  #: step from which on it may come to rest
    pinned: np.ndarray  #: a point at rest, the vertex nearest to which is pinned
    solid: typing.Callable[[int], Solid]  #: the same as elements: 2 fine, 1 of twice their size
    end: typing.Optional[float] = None  #: x of what comes down, at rest; none: see `hangs`
    hangs: bool = False  #: its lowest point is what comes down
    cut_plane: typing.Optional[float] = None  #: x of the cut
    opens: bool = False  #: whether the cut has lips that can be measured
    params: dict = dataclasses.field(default_factory=lambda: dict(PARAMS))


class Script:
    """The events of a session, in their order."""

    def __init__(self):
        self.events, self.step = [], 0

    def add(self, kind, **keys):
        self.events.append({"step": self.step, "type": kind, **keys})

    def cut(self, start, end):
        """Moves the blade along z from one place (x, y, half its length) to another one."""
        for at in (start, end):
            x, y, half = at
            self.add("blade", a=[x, y, -half], b=[x, y, half])
            self.step += (math.ceil(math.dist(start, end) / BLADE_SPEED / TIME_STEP)
                          if at is start else 1)
        self.add("lift")

    def load(self, gravity):
        self.add("set", name="gravity", value=[0, -gravity, 0])


def plane_at(x, size):
    """A plane x of a body at rest, as a pin has it."""
    across = np.array([0, *size[1:] / 2]) + HAIR
    return {"low": list(np.array([x, 0, 0]) - across), "high": list(np.array([x, 0, 0]) + across)}


def solid_of(mesh, gravity, held, moved=0, load_steps=1):
    by = np.zeros_like(mesh.nodes)
    by[:, 0] = moved
    return Solid(mesh, MODULUS, POISSON_RATIO, np.array([0, -DENSITY * gravity, 0]),
                 np.stack([held] * 3, axis=1), by, load_steps)


def even(half, cells):
    return np.linspace(-half, half, cells + 1)


def bar(depth):
    half = BAR / 2
    bottom = half[1] - BAR[1] * depth / 100
    script = Script()
    script.add("pin", **plane_at(-half[0], BAR))
    if depth:
        reach = half[2] + CLEARANCE
        script.cut((NOTCH_AT, half[1] + CLEARANCE, reach), (NOTCH_AT, bottom, reach))
    script.load(BAR_GRAVITY)

    def solid(fineness):
        mesh = solid_box([lines_through(-half[0], NOTCH_AT, half[0], 2 * fineness),
                          even(half[1], 4 * fineness), even(half[2], 2 * fineness)],
                         (NOTCH_AT, bottom, BAR[2]) if depth else None)
        return solid_of(mesh, BAR_GRAVITY, mesh.nodes[:, 0] == -half[0])

    return Case(f"bar-{depth}", "notched bar", f"{depth} % of its height" if depth else "none",
                bodies.box(BAR, BAR_CELLS), script.events, script.step,
                np.array([-half[0], 0, 0]), solid, end=half[0],
                cut_plane=NOTCH_AT if depth else None, opens=depth > 0)


def slab(cut):
    half = SLAB / 2
    script = Script()
    if cut:
        script.cut((0, half[1] + CLEARANCE, INCISION_HALF), (0, 0, INCISION_HALF))
    still = plane_at(-half[0], SLAB)
    script.add("pin", **plane_at(half[0], SLAB))
    script.add("pin", **still)
    for _ in range(STRETCH_STEPS):  # what is pinned moves as a whole, so the other end is free then
        script.add("unpin", **still)
        script.add("move_pins", by=[STRETCH * SLAB[0] / STRETCH_STEPS, 0, 0])
        script.add("pin", **still)
        script.step += 1

    def solid(fineness):
        mesh = solid_box([lines_through(-half[0], 0, half[0], 3 * fineness),
                          even(half[1], 2 * fineness), even(half[2], 4 * fineness)],
                         (0, 0, INCISION_HALF) if cut else None)
        x = mesh.nodes[:, 0]
        return solid_of(mesh, 0, abs(x) == half[0], STRETCH * SLAB[0] * (x == half[0]), 3)

    return Case("slab-incised" if cut else "slab-whole", "slab drawn apart",
                "incision" if cut else "none", bodies.box(SLAB, SLAB_CELLS), script.events,
                script.step, np.array([-half[0], 0, 0]), solid, cut_plane=0 if cut else None,
                opens=cut)


def cap():
    """Where pins hold the ball: corners of its first rows from the top on, none of the cut."""
    below = ROWS - PINNED_ROWS  # of the lowest of them, on an axis
    height = RADIUS * below / math.hypot(below, PINNED_ROWS)
    return {"low": [HAIR, height - HAIR, -RADIUS - HAIR], "high": [RADIUS + HAIR] * 3}


def ball(half):
    script = Script()
    script.add("pin", **cap())
    if half:
        reach = RADIUS + CLEARANCE
        script.cut((0, reach, reach), (0, -reach, reach))
    script.load(BALL_GRAVITY)

    def solid(fineness):
        mesh = solid_ball(RADIUS, ROWS, fineness + 1, half)
        faces = mesh.faces()
        pinned = ((mesh.nodes >= cap()["low"]) & (mesh.nodes <= cap()["high"])).all(axis=1)
        held = np.zeros(len(mesh.nodes), bool)
        for a, b, middle in ((0, 1, 3), (1, 2, 4), (2, 0, 5)):  # sides with both ends pinned
            own = faces[pinned[faces[:, a]] & pinned[faces[:, b]]]
            held[own[:, [a, middle, b]]] = True
        return solid_of(mesh, BALL_GRAVITY, held)

    # Kerf has the large triangles of the skin alone.
    whole = solid_ball(RADIUS, ROWS, 1, False)
    used, triangles = bodies.numbered(whole.faces()[:, :3].tolist())
    middle = (cap()["low"][0] + cap()["high"][0]) / 2
    return Case("ball-half" if half else "ball-whole", "hanging ball",
                "in half" if half else "none", (whole.nodes[used], triangles),
                script.events, script.step, np.array([middle, RADIUS, 0]), solid, hangs=True,
                cut_plane=0 if half else None,
                params={**PARAMS, "floor": -4 * RADIUS})


def all_cases():
    """A bar with notches of four depths, a slab that is drawn apart with an incision and without, a
    ball that hangs whole and in half. In the order of the report."""
    return [*map(bar, DEPTHS), slab(False), slab(True), ball(False), ball(True)]
