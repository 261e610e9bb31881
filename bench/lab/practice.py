"""Scores of practised cuts: an expert's, and those of the same hand with one mistake each."""

import json
import math
import sys
from unittest import mock

import kerf

from .workshop import ROOT, progress, publish, remove, table, write

sys.path.append(str(ROOT / "assets/practice"))
import make_practice as tasks  # noqa: E402  pylint: disable=wrong-import-position

FILES = ("summary.json", "report.md")
#: By how much a figure may move that a mistake is not about: a share of it, or this much. What
#: is not cut is as exact as edges of the wall at its end allow (docs/practice.md).
BOUND = 0.05
LEAST = {"deviation_mean": 1e-4, "deviation_max": 2e-4, "depth_mean": 2e-4, "depth_in_band": 0.05,
         "length_under": 1e-3, "length_over": 5e-4, "margin_least": 3e-4, "excised_volume": 2e-7,
         "time": 0.05, "path": 1e-3, "economy": 0.02, "smoothness": 0.6, "tremor": 4e-5,
         "wobble": 4e-5, "idle_time": 0.1, "force_max": 2e-3, "force_mean": 1e-3}


def shaking(size, rate):
    return lambda share, seconds: size * math.sin(2 * math.pi * rate * seconds)


def jerky(share):
    """Five starts and stops, in the time of one motion."""
    part = min(max(share, 0), 1) * 5
    return min((math.floor(part) + tasks.least_jerk(part % 1)) / 5, 1)


def resting(share):
    """A rest in the middle, of a third of the time."""
    return tasks.least_jerk(min(share, 1 / 3) * 1.5 + max(share - 2 / 3, 0) * 1.5)


def line(**mistake):
    return tasks.session_of("incision", tasks.expert_incision(**mistake))


def loop(**mistake):
    return tasks.session_of("excision", tasks.expert_excision(**mistake))


def slices(**mistake):
    return tasks.session_of("slice", tasks.expert_slice(**mistake))


def blunt():
    session = line()
    session["params"]["blade_bluntness"] = 3
    return session


#: A mistake, the task, its session, the figures that it is about, each with how much it moves them
#: at least (SI units, signed), and those that follow from it.
MISTAKES = (
    ("1.5 mm beside the line", "incision", lambda: line(aside=lambda *_: 0.0015),
     {"deviation_mean": 0.0013, "deviation_max": 0.0013}, ("margin_least",)),
    ("a bow of 2 mm", "incision",
     lambda: line(aside=lambda share, _: 0.002 * math.sin(math.pi * share)**2),
     {"deviation_max": 0.0017, "deviation_mean": 0.0008},
     ("wobble", "smoothness", "path", "margin_least")),
    ("a tremor of 0.4 mm, 6 Hz", "incision", lambda: line(aside=shaking(0.0004, 6)),
     {"tremor": 0.0001, "wobble": 0.0002}, ("deviation_mean", "deviation_max", "smoothness", "path", "economy",
                          "force_max", "force_mean")),
    ("five starts and stops", "incision", lambda: line(way=jerky), {"smoothness": -0.7},
     ("tremor", "idle_time", "force_max")),
    ("1.5 mm too deep", "incision", lambda: line(deeper=0.0015),
     {"depth_mean": 0.0012, "depth_in_band": -0.7},
     ("margin_least", "force_max", "force_mean", "path", "economy")),
    ("half the speed", "incision", lambda: line(seconds=8.0), {"time": 3.9}, ("tremor",)),
    ("a rest of 1.6 s", "incision", lambda: line(seconds=6.0, way=resting),
     {"idle_time": 1.3, "time": 1.9}, ("smoothness", "tremor")),
    ("8 mm short", "incision", lambda: line(along=1 - 8 / 70), {"length_under": 0.006},
     ("path", "smoothness", "margin_least", "deviation_mean")),
    ("8 mm beyond the end", "incision", lambda: line(along=1 + 8 / 70), {"length_over": 0.003},
     ("path", "economy", "length_under", "smoothness", "depth_mean")),
    ("a blunt blade", "incision", blunt, {"force_max": 0.004}, ("depth_mean", "depth_in_band",
     "deviation_max", "force_mean", "length_under", "margin_least")),
    ("leaning to the lump", "excision", lambda: loop(lean=0.25), {"margin_least": -0.002},
     ("deviation_mean", "deviation_max", "excised_volume", "taken", "path", "economy", "force_max",
      "force_mean")),
    ("the second cut 3 mm off", "slice", lambda: slices(second=0.003),
     {"deviation_max": 0.002, "deviation_mean": 0.001},
     ("length_under", "length_over", "force_max", "force_mean", "path")),
)


# ---------------------------------------------------------------- the same try otherwise

def with_poses(every):
    """Every so many poses only; in between the blade moves on."""
    session = line()
    poses = [e for e in session["events"] if e["type"] == "blade"]
    left_out = [e for k, e in enumerate(poses[:-1]) if k % every]
    session["events"] = [e for e in session["events"] if e not in left_out]
    return session


def stepped(seconds):
    with mock.patch.dict(tasks.PARAMS, time_step=seconds):
        return line()


def turned(degrees):
    """The scene and the hand, turned about the upright axis."""
    session = line()
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def at(point):
        x, y, z = point
        return tasks.rounded((c * x + s * z, y, c * z - s * x))
    for model in (session, *session["more_models"]):
        model["placement"] = {"rotate": [0, degrees, 0],
                              "translate": at(model["placement"]["translate"])}
    for stroke in session["task"]["lines"]:
        stroke["points"] = [at(point) for point in stroke["points"]]
    for event in session["events"]:
        if event["type"] == "blade":
            event.update(a=at(event["a"]), b=at(event["b"]))
        elif event["type"] == "pin":  # all of the base, however it lies
            event.update(low=[-0.1, event["low"][1], -0.1], high=[0.1, event["high"][1], 0.1])
    return session


def in_millimetres(folder):
    """The models, as a program writes them that has millimetres."""
    session = line()
    for model in (session, *session["more_models"]):
        path = ROOT / "assets/practice" / model.get("model", model)["path"]
        lines = [" ".join(["v", *(repr(1000 * float(x)) for x in row.split()[1:4])])
                 if row.startswith("v ") else row for row in path.read_text().splitlines()
                 if not row.startswith("mtllib")]
        write(folder / path.name, "\n".join(lines) + "\n")
        model.get("model", model)["path"] = str((folder / path.name).resolve())
        model["placement"]["scale"] = 0.001
    return session


def remeshed(edge):
    session = line()
    session["model"].update(remesh=True, remesh_edge=edge)
    return session


#: What must not change a score, and the session of it.
SAME = (
    ("25 poses a second, not 50", lambda folder: with_poses(2)),
    ("steps of 10 ms, not 20", lambda folder: stepped(0.01)),
    ("steps of 12.5 ms", lambda folder: stepped(0.0125)),
    ("turned by 30 degrees", lambda folder: turned(30)),
    ("turned by 90 degrees", lambda folder: turned(90)),
    ("models in millimetres", in_millimetres),
    ("edges of 4 mm", lambda folder: remeshed(0.004)),
    ("edges of 5 mm", lambda folder: remeshed(0.005)),
)
COARSE = (SAME[0][0], "tremor")  #: for which poses may lie too far apart
#: Hands that shake: by so much [m], so often a second.
SHAKES = tuple((size, rate) for size in (0.0003, 0.0006, 0.001, 0.002) for rate in (1, 4))
#: From here on they must not pass.
UNSAFE = 0.0006


def score_of(session, folder, name):
    """Replays it beside its models, and returns its score."""
    progress(name)
    for model in (session["model"], *session.get("more_models", ())):
        if "path" in model:
            model["path"] = str((ROOT / "assets/practice" / model["path"]).resolve())
    known = json.loads((ROOT / f"assets/practice/{name.split()[0]}.kerf.json").read_text())
    session["task"] = {**known["task"], **session["task"]}
    del session["task"]["expert"]
    file = folder / f"{name.replace(' ', '-').replace(',', '')}.kerf.json"
    write(file, tasks.text_of(session))
    return kerf.replay(file, folder / "run")["score"]


def moved(expert, score):
    """By how much each figure moved; what is none in either is left out."""
    return {key: score[key] - expert[key] for key in LEAST
            if score.get(key) is not None and expert.get(key) is not None}


def unwanted(changes, expert, about):
    """The figures that moved by more than their bound without being meant."""
    return [key for key, change in changes.items() if key not in about
            and abs(change) > max(LEAST[key], BOUND * abs(expert[key]))]


def missing(changes, wanted):
    """The figures that should have moved and did not."""
    return [key for key, least in wanted.items()
            if changes.get(key, 0) * math.copysign(1, least) < abs(least)]


def shown(changes, keys):
    return ", ".join(f"{key} {changes.get(key, 0):+.4g}" for key in keys) or "-"


def in_units(key, value):
    """As people read it."""
    if value is None:
        return "none"
    factor, unit = {"time": (1, "s"), "idle_time": (1, "s"), "smoothness": (1, "")}.get(
        key, (100, "%") if key in ("economy", "depth_in_band") else
        (1000, "mN" if key.startswith("force") else "mm"))
    return f"{factor * value:.3g} {unit}".strip()


def spreads(expert, folder, summary):
    """A table of how far each figure of the same try moves, and what failed."""
    scores = {name: score_of(make(folder), folder, f"incision {name}") for name, make in SAME}
    moves = {name: moved(expert, score) for name, score in scores.items()}
    summary["same"] = moves
    failures = [f"practice: {name}: {key} moved." for name, changes in moves.items()
                for key in unwanted(changes, expert, ())]
    rows = []
    for key in (key for key in LEAST if expert[key] is not None):
        worst = max(moves, key=lambda name, k=key: abs(moves[name].get(k, 0)))
        lacking = [name for name in moves if key not in moves[name]]
        failures += [f"practice: {name}: {key} was not measured." for name in lacking
                     if (name, key) != COARSE]
        rows.append([f"`{key}`", in_units(key, expert[key]),
                     in_units(key, abs(moves[worst].get(key, 0))), worst,
                     ", ".join(lacking) or "-"])
    return table(["figure", "expert", "moved by at most", "by", "not measured with"],
                 rows), failures


def shakes(folder, summary):
    """A table of hands that shake, with which figures tell, and what failed."""
    rows, failures = [], []
    keys = ("wobble", "tremor", "smoothness", "deviation_max")
    summary["shakes"] = []
    for size, rate in SHAKES:
        score = score_of(line(aside=shaking(size, rate)), folder,
                         f"incision shaken {1000 * size:g} mm {rate} Hz")
        summary["shakes"].append({"size": size, "rate": rate, "passed": score["passed"],
                                  **{key: score[key] for key in keys}})
        rows.append([f"{1000 * size:g} mm, {rate} Hz", *(in_units(k, score[k]) for k in keys),
                     " ".join(score["violations"]) or "passed"])
        if score["passed"] == (size >= UNSAFE):
            failures.append(f"practice: shaken by {1000 * size:g} mm at {rate} Hz: "
                            f"{'passed' if score['passed'] else 'did not pass'}.")
    return table(["shaken by", *(f"`{key}`" for key in keys), ""], rows), failures


def run(arguments):
    """The tables. Returns what failed first, or ""."""
    folder = arguments.out / "practice"
    remove(folder, *FILES)
    experts = {name: score_of(make(), folder, f"{name} by the expert")
               for name, make in (("incision", line), ("excision", loop), ("slice", slices))}
    rows, failures, summary = [], [], {"experts": experts, "mistakes": []}
    for mistake, name, make, wanted, follows in MISTAKES:
        expert = experts[name]
        score = score_of(make(), folder, f"{name} {mistake}")
        changes = moved(expert, score)
        lacks = missing(changes, wanted)
        others = unwanted(changes, expert, {*wanted, *follows})
        rows.append([mistake, name, shown(changes, wanted), shown(changes, follows),
                     shown(changes, others)])
        summary["mistakes"].append({"mistake": mistake, "task": name, "moved": changes,
                                    "violations": score["violations"]})
        failures += [f"practice: {mistake}: {key} did not move." for key in lacks]
        failures += [f"practice: {mistake}: {key} moved, too." for key in others]
    failures += [f"practice: {name}: {sentence}" for name, score in experts.items()
                 for sentence in score["violations"]]
    same, moved_too = spreads(experts["incision"], folder, summary)
    shaken, not_told = shakes(folder, summary)
    failures += moved_too + not_told
    report = "# Practised cuts with one mistake each\n\n" + table(
        ["mistake", "task", "its figures", "what follows", "others"], rows)
    report += "\n\n# The same try otherwise\n\n" + same
    report += "\n\n# An incision by a hand that shakes\n\n" + shaken
    publish(arguments, folder, report, summary)
    return failures[0] if failures else ""
