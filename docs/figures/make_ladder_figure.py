#!/usr/bin/env python3
"""Draws docs/images/cut-ladder.svg: what a step tries, and the levels of the retry ladder.

`kerf_cut_figures | make_ladder_figure.py`: the levels come from the program, the numbers of tries
from the constants in sim/cut/stroke.
"""
import json
import re
import sys

from svg import BLUE, FAINT, GREEN, GREY, INK, ORANGE, RED, RED_FILL, ROOT, Drawing, mixed

GREEN_FILL = "#d8efdf"


def constant(name):
    """What stands behind `name` in the sources of the stroke: a number, or how many entries."""
    for source in sorted((ROOT / "sim/cut/stroke").glob("*.cpp")):
        found = re.search(rf"\b{name}\b(?:\[\])? ?(?:= ?)?(\d+|\{{.*?\}});", source.read_text(), re.S)
        if found:
            value = found[1]
            if value.isdigit():
                return int(value)
            inner = value[1:-1]
            return inner.count("{") or inner.count(",") + 1
    raise SystemExit(f"no constant {name} in sim/cut/stroke")


def box(d, x, y, width, words, color, fill, number=""):
    rows = words.split("\n")
    height = 16 + 18 * len(rows)
    d.box(x, y, width, height, fill, color, 8, 1.4)
    for i, row in enumerate(rows):
        d.text((x + 12, y + 21 + 18 * i), row, INK if i == 0 else GREY, size=14 if i == 0 else 13,
               weight="bold" if i == 0 else "normal")
    if number:
        d.text((x + width - 10, y + 21), number, color, "end", 13, "bold")
    return height


def arrow(d, corners, words="", color=GREY):
    d.way(corners, color)
    if words:
        a, b = corners[0], corners[-1]
        d.text((a[0] + 10, (a[1] + b[1]) / 2 + 4), words, color, size=13, halo=True)


def flow(d, levels):
    ways = 2 * constant("kDetours")
    refusals = constant("kRefusalsBeforeDetach")
    d.text((28, 40), "What a step tries, one after the other, until one try succeeds", INK, size=17,
           weight="bold")
    d.box(22, 62, 330, 278, mixed(BLUE, "#ffffff", 0.95), mixed(BLUE, "#ffffff", 0.6), 12)
    d.text((36, 85), "Climb the retry ladder", BLUE, weight="bold")
    box(d, 36, 98, 302, "older slits along the way\nseen slightly open", BLUE, "#ffffff", f"{levels} tries")
    box(d, 36, 186, 302, "seen open by more, and\nwith what the transit divided", BLUE, "#ffffff",
        f"{constant('kFirstLevels')} tries")
    box(d, 36, 274, 302, "older slits as they are\nfrom now on, in this transit", BLUE, "#ffffff",
        f"{levels} tries")
    arrow(d, [(120, 150), (120, 184)], "all fail, a slit is seen open")
    arrow(d, [(120, 238), (120, 272)], "all fail")

    d.box(402, 62, 330, 278, mixed(ORANGE, "#ffffff", 0.95), mixed(ORANGE, "#ffffff", 0.6), 12)
    d.text((416, 85), "Resume behind the front", ORANGE, weight="bold")
    box(d, 416, 98, 302, "beside the old walls\nmust cross them all along", ORANGE, "#ffffff",
        f"{ways} tries")
    box(d, 416, 274, 302, "the same without proof\na bridge may stay", ORANGE, "#ffffff",
        f"{ways} tries")
    arrow(d, [(500, 150), (500, 272)], "all fail")
    d.line([(338, 116), (378, 116)], GREY, 1.8)
    arrow(d, [(338, 300), (378, 300), (378, 116), (414, 116)])
    d.text((384, 216), "all fail", GREY, "middle", 13, halo=True)

    box(d, 772, 98, 128, "step done\nonly now the\nmesh changes", GREEN, GREEN_FILL)
    arrow(d, [(732, 132), (770, 132)], color=GREEN)
    d.text((772, 87), "one try succeeds", GREEN, size=13)
    box(d, 772, 274, 128, "step refused\nno byte changes", RED, RED_FILL)
    arrow(d, [(718, 300), (770, 300)], color=RED)
    d.text((772, 263), "all fail", RED, size=13)

    notes = [
        "In a moving body two failed steps in a row are refused at once, unresumed: mostly the next one succeeds.",
        f"After {refusals} refusals in a row the front is let go: it stays as the end of a slit.",
        "Where only unequal sides of an older wall stood in the way, all runs once more without that rule.",
    ]
    for i, note in enumerate(notes):
        d.dot((34, 366 + 21 * i), GREY, 3)
        d.text((44, 371 + 21 * i), note, GREY, size=13.5)


def table(d, levels):
    top, left, step, row = 494, 222, 62, 25
    d.text((28, 462), "The levels of the ladder", INK, size=17, weight="bold")
    d.text((28, 482), "each column is one try; what it changes lasts for that try alone", GREY, size=13.5)
    rows = [
        ("skin at the front seen flat", lambda l: l["seenFlat"], BLUE),
        ("blade farther aside", lambda l: l["offset"] > 1, RED),
        ("older slits seen closed", lambda l: l["closed"], ORANGE),
        ("near nodes made one", lambda l: l["tolerance"] > 0, GREY),
    ]
    for r, (name, _, _) in enumerate(rows):
        y = top + 22 + r * row
        d.text((left - 12, y + 17), name, INK, "end", 13)
    for i in range(len(levels)):
        x = left + i * step
        d.text((x + step / 2, top + 14), str(i), GREY, "middle", 12)
        for r, (_, is_on, color) in enumerate(rows):
            on = is_on(levels[i])
            words = f"×{levels[i]['offset']:g}" if on and r == 1 else ""
            d.box(x + 2, top + 22 + r * row + 2, step - 4, row - 4,
                  mixed(color, "#ffffff", 0.35) if on else FAINT, "none", 4)
            if words:
                d.text((x + step / 2, top + 22 + r * row + 16), words, "#ffffff", "middle",
                       10.5 if len(words) < 4 else 9.5, "bold")
    d.text((left, top + 22 + len(rows) * row + 20),
           "Only the predicates see them: nothing real moves.", GREY, size=13.5)


def main():
    levels = json.load(sys.stdin)["ladder"]
    d = Drawing(920, 688, "The retry ladder: what a step of the cut tries")
    flow(d, len(levels))
    table(d, levels)
    d.save("cut-ladder.svg")


if __name__ == "__main__":
    main()
