"""The paper's experiments: their sessions, their runs, and what these measured."""

import copy
import dataclasses
import json

import kerf
import numpy as np

from .hollow import hollow_session
from .workshop import SESSIONS, replay

NEGLIGIBLE = "negligible change"
#: What only the report tells: the gain over the previous method [%] (the paper's section 3.3), and
#: how the volume recovers (3.2 on figure 10).
SAID = {
    "sphere20": {"gain": None, "course": NEGLIGIBLE},
    "sphere80": {"gain": None, "course": NEGLIGIBLE},
    "sphere768": {"gain": 48.06, "course": "drops at impact, recovers"},
    "octopus": {"gain": 56.87, "course": "drops at impact, stays lost"},
    "banana": {"gain": 61.37, "course": NEGLIGIBLE},
}
PAPER = {row["name"]: {**row, **SAID[row["name"]]} for row in kerf.paper_experiments()}

AS_PUBLISHED = {"solver": "pbd", "paper_contact": 1, "open_cut": 1}
WAYS = next(p["choices"] for p in kerf.parameters() if p["name"] == "cut_search")
CUTTING_WIDTH, FALL_WIDTH, PICTURE_HEIGHT = 360, 480, 360  # of pictures in strips [pixels]
HOLLOW_PLACE = 2  # in the strip of the cut: behind the picture half way
HOLLOW_FILE = "hollow.png"

FIGURE_2 = "figure-2"
FIGURE_2_MODEL = "sphere768"
FIGURE_2_STEP = 260  # the halves lie on the floor
FIGURE_2_STEPS = 400


@dataclasses.dataclass
class Picture:
    """A picture of a report, with its caption."""
    step: int  #: before which it is taken
    file: str  #: relative to the folder of the run
    caption: str


@dataclasses.dataclass
class Moments:
    """Steps at which the phases of an experiment begin."""
    blade: int  #: its first pose
    lift: int  #: the stroke ends
    gravity: int  #: it begins to act

    def of_stroke(self, rows):
        return rows[(rows["step"] >= self.blade) & (rows["step"] <= self.lift)]


@dataclasses.dataclass
class Result:
    """One of the paper's experiments, run. Rows are those of metrics.csv."""
    name: str
    session: dict  #: as it ran
    params: dict  #: all, at its start
    summary: dict
    rows: np.ndarray
    strokes: list  #: rows of the stroke in each run, the complete one first
    searches: dict  #: rows of a stroke by its way of finding triangles
    cutting: list
    falling: list

    @property
    def paper(self):
        return PAPER[self.name]

    @property
    def label(self):
        return self.paper["label"]

    @property
    def after_stroke(self):
        return self.rows[self.rows["step"] == moments_of(self.session).lift][0]

    def rates(self):
        """Mean frame rates of the strokes [1/s]."""
        return [fps(stroke) for stroke in self.strokes]


@dataclasses.dataclass
class HollowRun:
    """One of the two runs of figure 2."""
    picture: str  #: relative to the report
    picture_volume: float  #: over that at rest, before the step of the picture
    summary: dict


def fps(rows):
    """Steps over the whole time [1/s]."""
    return 1000 / rows["frame_ms"].mean()


# --- Sessions -------------------------------------------------------------------------------------


def paper_session(name, published):
    session = json.loads((SESSIONS / f"{name}.kerf.json").read_text())
    if published:
        session["params"].update(AS_PUBLISHED, iterations=PAPER[name]["iterations"])
    return session


def moments_of(session):
    def first(kind, **keys):
        return next(e["step"] for e in session["events"]
                    if e["type"] == kind and all(e[k] == v for k, v in keys.items()))
    return Moments(first("blade"), first("lift"), first("set", name="gravity"))


def picture_at(step, text):
    return Picture(step, f"pictures/step-{step:03}.png", text)


def later_pictures(session):
    """The steps of the session's own pictures behind the cut, by time."""
    gravity = moments_of(session).gravity
    return sorted(e["step"] for e in session["events"]
                  if e["type"] == "screenshot" and e["step"] >= gravity)


def cutting_pictures(session):
    """The paper's figures 5 and 6: before, half way, through, parted."""
    at = moments_of(session)
    impact = (later_pictures(session) or [session["steps"]])[0]
    return [picture_at(at.blade, "before the cut"),
            picture_at((at.blade + at.lift) // 2, "half way"),
            picture_at(at.lift + 1, "cut through"),
            picture_at((at.gravity + 2 * impact) // 3, "falling")]


def fall_pictures(session):
    """The paper's figures 7 and 8: at the session's own screenshots, from the impact on."""
    return [picture_at(step, "at the impact" if i == 0
                       else "at the end" if step == session["steps"] else "afterwards")
            for i, step in enumerate(later_pictures(session))]


def with_pictures(session, pictures, width):
    """The session with these pictures of the given width, besides its own."""
    session = copy.deepcopy(session)
    session["events"] += [{"step": p.step, "type": "screenshot", "file": p.file, "width": width,
                           "height": PICTURE_HEIGHT} for p in pictures]
    session["events"].sort(key=lambda event: event["step"])
    return session


def shortened(session, steps, without):
    """The session up to a step, without events of these kinds."""
    events = [e for e in session["events"] if e["step"] <= steps and e["type"] not in without]
    return {**session, "steps": steps, "events": events}


def stroke_alone(session):
    """The session without pictures and checks, up to the end of its stroke: for timing."""
    return shortened(session, moments_of(session).lift + 1, ("screenshot", "check"))


# --- Runs -----------------------------------------------------------------------------------------


def run_experiment(name, out, published, runs):
    """Runs an experiment as a whole, then its stroke alone, one run after the other."""
    folder = out / name
    plain = paper_session(name, published)
    cutting, falling = cutting_pictures(plain), fall_pictures(plain)
    session = with_pictures(with_pictures(plain, cutting, CUTTING_WIDTH), falling, FALL_WIDTH)
    params = kerf.Simulation.from_session(session).params
    summary, rows = replay(session, folder, name)

    at, stroke = moments_of(session), stroke_alone(session)

    def timed(params, place, what):
        altered = {**stroke, "params": {**stroke["params"], **params}}
        return at.of_stroke(replay(altered, folder / place, f"{name}, {what}")[1])

    strokes = [at.of_stroke(rows)]
    strokes += [timed({}, f"runs/{n}", f"stroke {n}") for n in range(2, runs + 1)]
    searches = {way: strokes[-1] if way == params["cut_search"]
                else timed({"cut_search": way}, f"search/{way}", f"search {way}") for way in WAYS}
    if published:
        cutting[HOLLOW_PLACE:HOLLOW_PLACE] = picture_hollow(plain, folder)
    return Result(name, session, params, summary, rows, strokes, searches, cutting, falling)


def picture_hollow(session, folder):
    """The body in the middle of the cut, in a run with hands that pull the lips apart."""
    rest = kerf.Simulation.from_session(session).positions
    hollow = hollow_session(session, rest, HOLLOW_FILE, (CUTTING_WIDTH, PICTURE_HEIGHT))
    if hollow is None:
        return []
    session, end = hollow
    replay(session, folder / "hollow", "hollow", until=end)
    return [Picture(end, f"hollow/{HOLLOW_FILE}", "hollow: lips drawn apart")]


def run_figure_2(out, published):
    """The halves of Sphere 768 on the floor, without ISPCs and with those of the experiment."""
    session = paper_session(FIGURE_2_MODEL, published)

    def run(name, ispc_stiffness):
        shown = [Picture(FIGURE_2_STEP, f"{name}.png", "")]
        own = with_pictures(shortened(session, FIGURE_2_STEPS, ("screenshot",)), shown, FALL_WIDTH)
        own["params"]["ispc_stiffness"] = ispc_stiffness
        summary, rows = replay(own, out / FIGURE_2 / name, f"figure 2, {name}")
        before = rows[rows["step"] == FIGURE_2_STEP - 1]["volume_ratio"][0]
        return HollowRun(f"{FIGURE_2}/{name}/{name}.png", before, summary)

    return run("without", 0), run("with", session["params"]["ispc_stiffness"])
