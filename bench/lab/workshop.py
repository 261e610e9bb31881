"""What all experiments share: files that appear whole, replays, progress, Markdown."""

import io
import json
import os
import pathlib
import sys

import kerf
import matplotlib.pyplot as plt
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]  #: of the source tree
SESSIONS = ROOT / "assets/sessions"
NOT_GIVEN = "-"  #: stands where there is no figure


def write(file, content):
    """Writes text or bytes so that the file is never seen half-finished."""
    file = pathlib.Path(file)
    file.parent.mkdir(parents=True, exist_ok=True)
    half = file.with_name(file.name + ".part")
    half.write_bytes(content.encode() if isinstance(content, str) else content)
    os.replace(half, file)


def write_json(file, value):
    write(file, json.dumps(value, indent=2) + "\n")


def save_figure(figure, file):
    """Writes a figure of matplotlib as a PNG, and closes it."""
    png = io.BytesIO()
    figure.savefig(png, format="png")
    plt.close(figure)
    write(file, png.getvalue())


def publish(arguments, folder, report, summary):
    """Writes report.md, then summary.json, and prints the one or, with --json, the other."""
    write(folder / "report.md", report)
    write_json(folder / "summary.json", summary)
    progress()
    print(json.dumps(summary) if arguments.json else report, end="\n" if arguments.json else "")


def remove(folder, *names):
    """Removes results of an earlier run, so that none is taken for one of this run."""
    for name in names:
        (folder / name).unlink(missing_ok=True)


def replay(session, folder, what, **options):
    """The summary of a run and its rows of metrics.csv, also where a check failed."""
    progress(what)
    try:
        summary = kerf.replay(session, folder, **options)
    except kerf.CheckFailed as failed:
        summary = failed.summary
    return summary, np.genfromtxt(folder / "metrics.csv", delimiter=",", names=True)


def progress(text=""):
    """A line on the terminal that the next one writes over; nothing elsewhere."""
    if sys.stderr.isatty():
        print(f"\r\x1b[K{text}", end="", file=sys.stderr, flush=True)


# --- Markdown -------------------------------------------------------------------------------------


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(map(str, cells))} |\n" for cells in lines) + "\n"


def value_text(value):
    """A value of a parameter as a session has it."""
    if value is None:
        return "none"
    if isinstance(value, str):
        return value
    if isinstance(value, (int, float)):
        return f"{value:g}"
    return "[" + ", ".join(f"{x:g}" for x in value) + "]"


def bullets(sentences):
    return "".join(f"- {sentence}\n" for sentence in sentences) + ("\n" if sentences else "")


def section(title, sentences):
    """A list below a title; nothing where there is no sentence."""
    return f"## {title}\n\n{bullets(sentences)}" if sentences else ""


def picture(alt, file):
    return f"![{alt}]({file})\n\n"


def caption(number, text):
    return f"**{number}.** {text}\n\n"


def percent(ratio):
    return f"{100 * ratio:.2f}"
