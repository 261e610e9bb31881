#!/usr/bin/python3
"""Makes the tasks to practise, and how an expert does them. Needs Debian's python3 alone.

    /usr/bin/python3 assets/practice/make_practice.py KERF [NAME...]

writes NAME.kerf.json (the task), NAME.expert.kerf.json (the same with a blade that does it) and,
with the program KERF and imagemagick, NAME.expert.score.json and NAME.png for the start page, for
each NAME (default: all of TASKS), into this folder.

The expert is no person: its hand follows the line with the speed of least jerk (Flash and Hogan
1985), which rises and falls without a bend. bench/lab/practice.py has it make mistakes.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent

#: A phantom: toughness over modulus is 0.2 mm, which the model of the blade takes well. Those of
#: skin (1.3 m) and liver (30 mm) are beyond it (docs/notes/blade-force.md).
PARAMS = {"time_step": 0.02, "gravity": [0, 0, 0], "floor": None, "youngs_modulus": 2000,
          "density": 1000, "toughness": 0.4, "blade_feels": 1, "blade_bluntness": 0.2,
          "blade_width": 0.025, "wall_coarsening": 1, "debris_volume": 0}
SETTLES = 20  # steps after the last lift


def least_jerk(share):
    """The way of a hand at this share of its time, each from 0 to 1."""
    share = min(max(share, 0.0), 1.0)
    return share**3 * (10 - 15 * share + 6 * share**2)


class Stroke:
    """A stroke: the blade at a share of its way, and the time that the way takes [s]."""

    def __init__(self, blade, seconds, way=least_jerk):
        self.blade, self.seconds, self.way = blade, seconds, way

    def at(self, seconds):
        return self.blade(self.way(seconds / self.seconds), seconds)


def events_of(strokes, time_step, away=2):
    """A pose a step. `away`: steps between two strokes."""
    events, step = [], 0
    for stroke in strokes:
        count = round(stroke.seconds / time_step)
        for k in range(count + 1):
            a, b = stroke.at(k * time_step)
            events.append({"step": step + k, "type": "blade", "a": rounded(a), "b": rounded(b)})
        step += count + 1
        events.append({"step": step, "type": "lift"})
        step += away
    return events, step


def rounded(point):
    return [round(x, 7) + 0.0 for x in point]


# ---------------------------------------------------------------- the tasks

TOP, THICK = 0.020, 0.020  # of the pads [m]
WOBBLE = 0.00025  # of the hand, below that of one that shakes by 0.6 mm once a second [m]
BASE = [{"low": [-0.07, -0.01, -0.05], "high": [0.07, 0.001, 0.05]}]  # to which they are glued


def incision():
    """The line is 70 mm long, the vessel lies 12 mm below it."""
    return {
        "model": {"path": "../models/pad-vessel.obj"},
        "placement": {"translate": [0, TOP - THICK / 2, 0]},
        "more_models": [{"path": "../models/vessel.obj",
                         "placement": {"translate": [0.010, 0.008, 0]},
                         "color": [0.65, 0.05, 0.10]}],
        "params": {**PARAMS, "skin_thickness": 0.0015, "skin_modulus": 8500},
        "task": {
            "name": "Incision",
            "about": "Cut along the line with the scalpel, 5 mm deep: press at one end, and lift "
                     "at the other. Spare the vessel below.",
            "lines": [{"points": [[-0.035, TOP, 0], [0.035, TOP, 0]]}],
            "depth": 0.005, "band": 0.001, "spare": [1]},
        "limits": {"deviation": 0.002, "ends": 0.006, "in_band": 0.9, "margin": 0.001,
                   "seconds": 20, "idle": 2, "economy": 0.85, "wobble": WOBBLE},
        "pins": BASE,
        "view": {"eye": [0, 0.17, 0.14], "target": [0, 0.015, 0], "fov_y": 35, "look": "plain",
                 "skin": [0.87, 0.66, 0.54], "flesh": [0.93, 0.79, 0.44]}}


RADIUS = 0.014  # of the circle [m]


def excision():
    """The circle stays 9 mm clear of a lump of 4.9 mm."""
    points = [[RADIUS * math.cos(turn), TOP, RADIUS * math.sin(turn)]
              for turn in (2 * math.pi * k / 24 for k in range(24))]
    return {
        "model": {"path": "../models/pad-lump.obj"},
        "placement": {"translate": [0, TOP - THICK / 2, 0]},
        "more_models": [{"builtin": "sphere80",
                         "placement": {"scale": 0.0098, "translate": [0, 0.010, 0]},
                         "color": [0.55, 0.35, 0.50]}],
        "params": PARAMS,
        "task": {
            "name": "Excision",
            "about": "Cut out the lump in one piece with the stroke, which goes right through: "
                     "begin at the outer ring, go once round on the line, and end at the outer "
                     "ring, across your first cut.",
            "lines": [{"points": [rounded(p) for p in points], "closed": True}],
            "reach": 0.008, "spare": [1], "take": 1},
        "limits": {"deviation": 0.005, "deviation_mean": 0.0015, "ends": 0.004, "margin": 0.007,
                   "seconds": 40, "idle": 5, "economy": 0.75, "wobble": WOBBLE},
        "pins": BASE,
        "view": {"eye": [0, 0.30, 0.001], "target": [0, 0.010, 0], "up": [0, 0, -1],
                 "fov_y": 24, "orthographic": True, "look": "plain",
                 "skin": [0.87, 0.66, 0.54], "flesh": [0.93, 0.79, 0.44]}}


SLICE = (0.060, 0.050)  # where it is cut [m]


def slice_():
    """Ten millimetres between two lines across the left lobe."""
    ends = ((0.0264, -0.0593), (0.0301, -0.0610))  # of the lobe there
    lines = [{"points": [[x, 0.045, z] for z in pair]} for x, pair in zip(SLICE, ends)]
    return {
        "model": {"path": "../models/liver.obj"},
        "placement": {"translate": [0, 0.0283, 0]},
        "params": {**PARAMS, "floor": 0},
        "task": {
            "name": "Slice",
            "about": "Cut off a slice of even thickness with the stroke: down through the "
                     "right line, then the left one.",
            "lines": lines},
        "limits": {"deviation": 0.002, "ends": 0.004, "seconds": 30, "idle": 5, "economy": 0.7,
                   "wobble": WOBBLE},
        "pins": [{"low": [-0.2, -0.01, -0.2], "high": [0.02, 0.2, 0.2]}],
        "view": {"eye": [0.055, 0.030, 0.50], "target": [0.055, 0.030, 0], "fov_y": 14,
                 "orthographic": True, "look": "meat"}}


# ---------------------------------------------------------------- the expert

LAG = 0.0001  # by which the edge cuts less deep than it is led [m]
LIFT = 0.004  # of the blade's back over the skin [m]


def expert_incision(along=1.0, deeper=0.0, aside=lambda share, seconds: 0.0, seconds=4.0,
                    way=least_jerk, begin=0.0):
    """Down into the skin, along the line and up again; all in one stroke. `along`: its end, as a
    share of the line; `begin`: its beginning [m]. `aside` [m] is sideways."""
    sink, depth = 0.2, 0.005 + LAG + deeper

    def blade(share, time):
        down = least_jerk(share / sink) - least_jerk((share - 1 + sink) / sink)
        on = way((share - sink / 2) / (1 - sink))
        x = begin - 0.035 + 0.070 * along * on
        z = aside(on, time)
        y = TOP + 0.005 - (0.005 + depth) * down
        return (x, y, z), (x, y + depth + LIFT + 0.005, z)
    return [Stroke(blade, seconds, lambda share: share)]


BEHIND = 0.0045  # the edge cuts so far behind the blade: a wall edge (docs/physics.md) [m]
OUTSIDE = 0.004  # of the line, at either end of the stroke: so they cross steeply [m]


def expert_excision(aside=lambda share, seconds: 0.0, lean=0.0, seconds=8.0, overlap=1.0,
                    way=least_jerk):
    """Upright, once round and a little farther, so much outside that the edge behind it is on the
    line. It comes in from outside, and leaves across that. `lean` [radians] tilts it towards the
    lump below the skin."""
    lead = math.hypot(RADIUS, BEHIND) - RADIUS
    leaves = 2 * math.pi + math.atan(BEHIND / RADIUS)  # once the edge is round

    def blade(share, time):
        turn = (2 * math.pi + overlap) * share
        come, gone = least_jerk(turn / 0.5), least_jerk((turn - leaves) / 0.5)
        out = lead * come + OUTSIDE * (1 - come + gone)

        def at(y):
            r = RADIUS + out + aside(share, time) + (y - TOP) * math.tan(lean)
            return r * math.cos(turn), y, r * math.sin(turn)
        return at(-0.020), at(0.045)
    return [Stroke(blade, seconds, way)]


def expert_slice(second=0.0, seconds=4.0, way=least_jerk):
    """Down through the lobe, twice. `second` moves the second cut [m]."""
    def through(x):
        return lambda share, time: ((x, 0.075 - 0.095 * share, 0.12),
                                    (x, 0.075 - 0.095 * share, -0.12))
    return [Stroke(through(x), seconds, way) for x in (SLICE[0], SLICE[1] + second)]


TASKS = {"incision": (incision, expert_incision), "excision": (excision, expert_excision),
         "slice": (slice_, expert_slice)}


# ---------------------------------------------------------------- sessions

def session_of(name, strokes=None):
    """The task of a name, done by these strokes if there are any."""
    made = TASKS[name][0]()
    events = [{"step": 0, "type": "pin", **pin} for pin in made.pop("pins")]
    steps = 1
    made["task"].update(made.pop("limits"))
    if strokes:
        poses, steps = events_of(strokes, made["params"]["time_step"])
        steps += SETTLES
        events += poses
        made["task"].update({"person": "expert"})
    else:
        made["task"]["expert"] = f"{name}.expert.kerf.json"
    view = made.pop("view")
    return {"format": "kerf-session", "version": 1, **made, "steps": steps, "events": events,
            "view": view}


def text_of(session):
    """A key a line, an event a line."""
    def line(key, value):
        if key == "events":
            rows = ",\n    ".join(json.dumps(event) for event in value)
            return f'"{key}": [\n    {rows}\n  ]'
        return f'"{key}": {json.dumps(value)}'
    return "{\n  " + ",\n  ".join(line(*item) for item in session.items()) + "\n}\n"


def score_of(kerf, file):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([kerf, "replay", file, "--out", folder], check=True,
                       stdout=subprocess.DEVNULL)
        return json.loads((pathlib.Path(folder) / "summary.json").read_text())["score"]


#: Of the pictures for the start page: the share of the run at which each is taken.
MOMENTS = {"incision": 0.55, "excision": 0.6, "slice": 0.72}


def make_picture(kerf, name, shown):
    session = json.loads(shown.read_text())
    step = round(MOMENTS[name] * session["steps"])
    session["model"]["path"] = str((FOLDER / session["model"]["path"]).resolve())
    for further in session.get("more_models", []):
        if "path" in further:
            further["path"] = str((FOLDER / further["path"]).resolve())
    view = session["view"]
    view["eye"] = [t + 0.72 * (e - t) for e, t in zip(view["eye"], view["target"])]
    session["steps"] = step
    session["events"] = [e for e in session["events"] if e["step"] <= step] + [
        {"step": step, "type": "screenshot", "file": "picture.png", "width": 960, "height": 600}]
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "picture.kerf.json"
        file.write_text(json.dumps(session))
        subprocess.run([kerf, "replay", file, "--out", folder], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run(["convert", f"{folder}/picture.png", "-resize", "50%", "-strip", "-dither",
                        "FloydSteinberg", "-colors", "140", "-define", "png:compression-level=9",
                        f"PNG8:{FOLDER / name}.png"], check=True)


def main():
    for name in sys.argv[2:] or TASKS:
        expert = TASKS[name][1]
        shown = FOLDER / f"{name}.expert.kerf.json"
        done = session_of(name, expert())
        done["task"]["path"] = 1  # not known yet
        shown.write_text(text_of(done))
        score = score_of(sys.argv[1], shown)
        task = session_of(name)
        # What the expert needs is the measure of economy, and half more force is allowed.
        for session in (task, done):
            session["task"]["path"] = round(score["path"], 6)
            if score["force_max"] is not None:
                session["task"]["newtons"] = float(f"{1.5 * score['force_max']:.2g}")
        (FOLDER / f"{name}.kerf.json").write_text(text_of(task))
        shown.write_text(text_of(done))
        score = score_of(sys.argv[1], shown)
        (FOLDER / f"{name}.expert.score.json").write_text(json.dumps(score, indent=2) + "\n")
        make_picture(sys.argv[1], name, shown)
        print(f"{name}: {'passed' if score['passed'] else ' '.join(score['violations'])}")


if __name__ == "__main__":
    main()
