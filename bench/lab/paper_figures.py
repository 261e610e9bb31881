"""The figures of the report on the paper's experiments, by the paper's numbers."""

import typing

import matplotlib.pyplot as plt
import numpy as np

from . import drawing
from .drawing import BLUE, GRAY, GREEN, ORANGE, VERMILLION
from .paper import FIGURE_2_STEP, PAPER
from .workshop import save_figure, value_text

FIGURE_2_FILE = "figures/figure-2.png"
FIGURE_9_FILE = "figures/figure-9.png"
FIGURE_10_FILE = "figures/figure-10.png"
SEARCH_FILE = "figures/search.png"  # the paper has no figure of it
PLOT_FILE = "plots.png"  # in the folder of a run
SPHERES = 3  # experiments of figures 5 and 7; the others are in 6 and 8


class Part(typing.NamedTuple):
    """A part of one of the paper's figures: 5 and "b"."""
    number: int
    letter: str

    @property
    def file(self):
        return f"figures/figure-{self.number}{self.letter}.png"

    @property
    def label(self):
        return f"({self.letter})"


def place_of(name):
    return list(PAPER).index(name)


def part_of(name, of_spheres, of_others):
    place = place_of(name)
    number, first = (of_spheres, 0) if place < SPHERES else (of_others, SPHERES)
    return Part(number, "abcde"[place - first])


def cutting_figure(name):
    return part_of(name, 5, 6)


def fall_figure(name):
    return part_of(name, 7, 8)


def volume_label(name):
    return f"({'abcde'[place_of(name)]})"


def settings_of(r):
    return (f"time step {r.params['time_step']:g} s, {value_text(r.params['iterations'])} "
            "iterations")


def later_files(names):
    """All that is written after the runs."""
    return [FIGURE_2_FILE, FIGURE_9_FILE, FIGURE_10_FILE, SEARCH_FILE,
            *(f"{name}/{PLOT_FILE}" for name in names),
            *(figure(name).file for name in names for figure in (cutting_figure, fall_figure))]


def draw_all(results, figure_2, out):
    """Draws the figures into the folder of the report, from what the runs left there."""
    def save(figure, file):
        save_figure(figure, out / file)

    for r in results:
        save(draw_strip(r, cutting_figure(r.name), r.cutting, out), cutting_figure(r.name).file)
        save(draw_strip(r, fall_figure(r.name), r.falling, out), fall_figure(r.name).file)
        save(draw_run(r), f"{r.name}/{PLOT_FILE}")
    if figure_2:
        save(draw_pair(figure_2, out), FIGURE_2_FILE)
    save(draw_rates(results), FIGURE_9_FILE)
    save(draw_searches(results), SEARCH_FILE)
    save(draw_volumes(results), FIGURE_10_FILE)


def draw_strip(r, part, pictures, out):
    def below(shown):
        return f"{shown.caption}\nstep {shown.step}, {shown.step * r.params['time_step']:.2f} s"

    return drawing.strip(f"{part.label} {r.label}: {settings_of(r)}",
                         [(plt.imread(out / r.name / p.file), below(p)) for p in pictures])


def draw_pair(figure_2, out):
    labels = ("(a) without ISPCs", "(b) with ISPCs")
    return drawing.strip(f"Sphere 768, step {FIGURE_2_STEP}", [
        (plt.imread(out / run.picture), f"{label}\nvolume {100 * run.picture_volume:.2f} %")
        for label, run in zip(labels, figure_2)])


def draw_run(r):
    """Volume and time of a frame over simulated time."""
    figure, axes = drawing.panels(2)
    plot_volume(axes[0, 0], r, "Volume")
    frames = axes[1, 0]
    frames.plot(r.rows["time"], r.rows["frame_ms"], color=BLUE, label="frame")
    mean = 1000 / r.paper["mean_fps"]
    frames.axhline(mean, color=GRAY, linestyle="--", label=f"paper's mean {mean:.1f} ms")
    frames.set(title="Time of a frame", ylabel="time, ms", ylim=(0, None))
    finish_course(frames, r)
    return figure


def draw_volumes(results):
    figure, axes = drawing.panels(len(results), 1, 1400)
    for r, panel in zip(results, axes[:, 0]):
        plot_volume(panel, r, f"{volume_label(r.name)} {r.label}")
    return figure


def plot_volume(panel, r, title):
    volume, mean = 100 * r.rows["volume_ratio"], r.paper["mean_volume"]
    panel.plot(r.rows["time"], volume, color=GREEN, label=f"Kerf, mean {volume.mean():.2f} %")
    panel.axhline(mean, color=GRAY, linestyle="--", label=f"paper's mean {mean:.1f} %")
    panel.set(title=title, ylabel="volume, % of rest")
    finish_course(panel, r)


def finish_course(panel, r):
    """The axis of time, and marks where pieces come off."""
    time, pieces = r.rows["time"], r.rows["pieces"]
    for i in np.flatnonzero(np.diff(pieces)) + 1:
        panel.axvline(time[i], color=GRAY, linewidth=0.8)
        panel.annotate(f"{pieces[i]:.0f} pieces", (time[i], 1), (2, 3), color=GRAY,
                       xycoords=("data", "axes fraction"), textcoords="offset points")
    panel.set(xlabel="time, s", xlim=(0, time[-1]))
    panel.legend(loc="best")


def draw_rates(results):
    figure, axes = drawing.panels(1, 1, 1400, 620)
    rates = [r.rates() for r in results]
    means = np.array([np.mean(own) for own in rates])
    spread = [means - [min(own) for own in rates], [max(own) for own in rates] - means]
    draw_bars(axes[0, 0], results, {
        "paper": ([r.paper["mean_fps"] for r in results], GRAY, None),
        "Kerf, while the blade cuts (bars: least and most of the runs)": (means, BLUE, spread),
        "Kerf, whole run": ([r.summary["fps"]["mean"] for r in results], ORANGE, None),
    }, "{:.1f}")
    axes[0, 0].set(title="Average frames per second", ylabel="frames per second, 1/s")
    return figure


def draw_searches(results):
    figure, axes = drawing.panels(1, 1, 1400, 620)
    draw_bars(axes[0, 0], results, {
        way: ([r.searches[way]["search_ms"].mean() for r in results], hue, None)
        for way, hue in zip(results[0].searches, (BLUE, GREEN, VERMILLION))}, "{:.3f}")
    axes[0, 0].set(title="Finding the triangles near the blade, mean of a stroke's steps",
                   ylabel="time of a step, ms")
    return figure


def draw_bars(panel, results, kinds, number):
    """A group of bars for each experiment: by label the heights, the hue and the spread."""
    width = 0.8 / len(kinds)
    for i, (label, (heights, hue, spread)) in enumerate(kinds.items()):
        places = np.arange(len(results)) + (i - (len(kinds) - 1) / 2) * width
        bars = panel.bar(places, heights, 0.9 * width, color=hue, label=label, yerr=spread,
                         capsize=8)
        panel.bar_label(bars, [number.format(height) for height in heights], padding=3)
    panel.set_xticks(range(len(results)), [r.label for r in results])
    panel.grid(axis="x", visible=False)
    panel.margins(y=0.12)
    panel.legend()
