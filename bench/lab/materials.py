"""Each material that comes with Kerf dropped, pressed, cut and pulled open."""

import json

import kerf
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import EngFormatter

from . import drawing
from .workshop import ROOT, SESSIONS, remove, replay, save_figure

SESSION = SESSIONS / "material.kerf.json"
STRIP_FILE, SHEET_FILE = "strip.png", "materials.png"


def title_of(material):
    """"Gelatin, Young's modulus 18 kPa, toughness 1.1 J/m²"."""
    file = json.loads((ROOT / f"assets/materials/{material}.json").read_text())
    shown = [file["label"]]
    for key, text, unit in (("youngs_modulus", "Young's modulus", "Pa"),
                            ("toughness", "toughness", "J/m²")):
        if key in file:
            shown.append(f"{text} {EngFormatter(unit)(file[key]['value'])}")
    return ", ".join(shown)


def sheet_of(strips):
    """One picture below the other."""
    width = max(strip.shape[1] for strip in strips)
    return np.vstack([np.pad(strip, ((0, 0), (0, width - strip.shape[1]), (0, 0)),
                             constant_values=1) for strip in strips])


def run(arguments):
    """Prints where the pictures are. Returns the first check that failed as a sentence, or ""."""
    folder = arguments.out / "materials"
    remove(folder, SHEET_FILE)
    session = json.loads(SESSION.read_text())
    files = [e["file"] for e in session["events"] if e["type"] == "screenshot"]
    summaries, strips = {}, []
    for material in kerf.builtin_materials():
        own = folder / material
        summaries[material] = replay(SESSION, own, material, material=material)[0]
        pictures = [(plt.imread(own / file), file.removesuffix(".png").replace("-", " "))
                    for file in files]
        save_figure(drawing.strip(title_of(material), pictures), own / STRIP_FILE)
        strips.append(plt.imread(own / STRIP_FILE))
    sheet = sheet_of(strips)
    figure = plt.figure(figsize=(sheet.shape[1] / drawing.DPI, sheet.shape[0] / drawing.DPI))
    figure.figimage(sheet)
    save_figure(figure, folder / SHEET_FILE)
    print(json.dumps({"materials": summaries}) if arguments.json
          else f"written to {folder / SHEET_FILE}")
    return next((f"{name}: {summary['failures'][0]}" for name, summary in summaries.items()
                 if summary["failures"]), "")
