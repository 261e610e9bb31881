"""Scores of practised cuts: an expert's, and those of the same hand with one mistake each."""

import json
import math
import sys

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
         "idle_time": 0.1, "force_max": 2e-3, "force_mean": 1e-3}


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
     {"deviation_max": 0.0017, "deviation_mean": 0.0008}, ("smoothness", "path", "margin_least")),
    ("a tremor of 0.4 mm, 6 Hz", "incision", lambda: line(aside=shaking(0.0004, 6)),
     {"tremor": 0.0001}, ("deviation_mean", "deviation_max", "smoothness", "path", "economy",
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


def score_of(session, folder, name):
    """Replays it beside its models, and returns its score."""
    progress(name)
    for model in (session["model"], *session.get("more_models", ())):
        if "path" in model:
            model["path"] = str((ROOT / "assets/practice" / model["path"]).resolve())
    known = json.loads((ROOT / f"assets/practice/{name.split()[0]}.kerf.json").read_text())
    session["task"] = {**known["task"], "expert": ""}
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


def run(arguments):
    """The table of mistakes. Returns what failed first, or ""."""
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
    report = "# Practised cuts with one mistake each\n\n" + table(
        ["mistake", "task", "its figures", "what follows", "others"], rows)
    publish(arguments, folder, report, summary)
    return failures[0] if failures else ""
