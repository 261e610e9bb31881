#!/usr/bin/python3
"""Makes the pictures of the start page from its scenes. Needs Debian's python3 and imagemagick.

    /usr/bin/python3 assets/start/make_pictures.py KERF [NAME...]

replays each NAME.kerf.json of this folder (default: all) with the program KERF, takes a picture
nearer than the scene's own view, and writes it to NAME.png beside it.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
SIZE = (480, 300)
NEARER = {"cloth": 0.86, "citrus": 0.88}  # of the distance of the view
STEPS = {"cloth": 260, "citrus": 310, "egg": 330, "tear": 96, "orange": 196, "incision": 400}  # until the picture
# Cuts before it: the ends of the blade, above and below the model.
CUTS = {"citrus": [[-0.03, 0.09, -0.08], [0.03, 0.09, 0.08]],
        "egg": [[-0.05, 0.11, 0.045], [0.05, 0.11, -0.045]]}
DEPTH = 0.13  # of a cut
# Hands after the events of the scene: their reach, where they take hold, and where they end.
PULLS = {"tear": [0.016, [[0.033, 0.062, 0], [0.082, 0.06, 0]]],
         "orange": [0.035, [[0.036, 0.045, 0], [0.161, 0.05, 0]]],
         "incision": [0.012, *([[x, 0.012, z], [x, 0.012, 5.5 * z]]
                               for x in (-0.012, 0.012) for z in (-0.008, 0.008))]}


def session_for_picture(file):
    session = json.loads(file.read_text(encoding="utf-8"))
    if "path" in session["model"]:
        session["model"]["path"] = str((FOLDER / session["model"]["path"]).resolve())
    view = session["view"]
    view["eye"] = [t + NEARER.get(name_of(file), 0.72) * (e - t) for e, t in zip(view["eye"], view["target"])]
    last = STEPS.get(name_of(file), 0)
    session["steps"] = max(1, last)
    session["events"] = session["events"] if name_of(file) in PULLS else []
    if name_of(file) in CUTS:
        ends = CUTS[name_of(file)]
        below = [[x, y - DEPTH, z] for x, y, z in ends]
        session["events"] = [{"step": 0, "type": "blade", "a": ends[0], "b": ends[1]},
                             {"step": 60, "type": "blade", "a": below[0], "b": below[1]},
                             {"step": 61, "type": "lift"}]
    if name_of(file) in PULLS:
        radius, *hands = PULLS[name_of(file)]
        for hand, (at, to) in enumerate(hands):
            session["events"] += [{"step": 24, "type": "grab", "hand": hand, "at": at,
                                   "radius": radius, "surface": True},
                                  {"step": last, "type": "drag", "hand": hand, "to": to}]
    session["events"].append({"step": last, "type": "screenshot", "file": "picture.png",
                              "width": 2 * SIZE[0], "height": 2 * SIZE[1]})
    return session


def name_of(file):
    return file.name.split(".")[0]


def make(kerf, file):
    with tempfile.TemporaryDirectory() as folder:
        session = pathlib.Path(folder) / file.name
        session.write_text(json.dumps(session_for_picture(file)), encoding="utf-8")
        subprocess.run([kerf, "replay", session, "--out", folder], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run(["convert", f"{folder}/picture.png", "-resize", "50%", "-strip", "-dither",
                        "FloydSteinberg", "-colors", "140", "-define", "png:compression-level=9",
                        f"PNG8:{FOLDER / name_of(file)}.png"], check=True)


def main():
    names = sys.argv[2:] or [name_of(file) for file in sorted(FOLDER.glob("*.kerf.json"))]
    for name in names:
        make(sys.argv[1], FOLDER / f"{name}.kerf.json")


if __name__ == "__main__":
    main()
