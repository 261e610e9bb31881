#!/usr/bin/env python3
"""Draws docs/images/house.svg: the rooms of the source and which of them includes which.

The rooms and their order come from kRooms in tests/house/include_direction_test.cpp, the arrows from
the #includes: those that follow from others are left out. Fails where a room has no place in FLOORS,
or an arrow points ahead in that order.
"""
import pathlib
import re

from svg import (BLUE, BROWN, GREEN, GREY, INK, ORANGE, ROOT, Drawing, mixed, rounded)

COLORS = {"app": ORANGE, "ui": BROWN, "render": GREEN, "sim": BLUE, "gpu": GREY}
# Where a room stands: its left side, its top and its width; and what it is for.
FLOORS = {
    "app/link": (24, 206, 84, "OpenIGTLink"),
    "app/practice": (20, 82, 68, "a cut\nmeasured"),
    "app/session": (92, 82, 66, "their files,\nmetrics"),
    "app/journal": (162, 82, 62, "work kept\nat once"),
    "app/regression": (228, 82, 84, "sessions as\ntests"),
    "app/study": (316, 82, 62, "many runs,\none table"),
    "app/doctor": (382, 82, 64, "the driver\nexamined"),
    "app/scene": (450, 82, 62, "the edited\nbody"),
    "app/tools": (516, 82, 56, "blades,\ncamera"),
    "app/editor": (576, 82, 60, "keys and\nmenus"),
    "app/window": (640, 82, 72, "the window\nand its loop"),
    "app/cli/replay": (716, 82, 66, "a session,\nheadless"),
    "app/cli": (786, 82, 44, "verbs"),
    "app": (834, 82, 46, "main()"),
    "app/files/io": (128, 180, 122, "whole files, CSV,\nmemory, errors"),
    "app/files/jobs": (268, 180, 126, "threads, children,\nprogress"),
    "app/files/import": (412, 180, 130, "kerf-import asked,\nmodels joined"),
    "app/files/export": (560, 180, 106, "meshes written"),
    "app/files/film": (684, 180, 84, "ffmpeg fed"),
    "app/import": (786, 180, 104, "kerf-import:\nreads, mends"),
    "ui": (252, 298, 338, "panels, plots, themes, keys; they queue actions"),
    "render/scene": (30, 384, 150, "what is drawn"),
    "render/passes": (212, 384, 150, "one pass a file"),
    "render": (394, 384, 150, "the renderer"),
    "sim/body": (30, 590, 140, "rest shape, masses,\nconstraints"),
    "sim/contact": (190, 590, 140, "with itself, boxes\nand the blade"),
    "sim/solve": (350, 590, 140, "the soft body\non the GPU"),
    "sim/run/start": (30, 490, 142, "the body to begin\nwith, its memory"),
    "sim/run/parts": (196, 490, 150, "body, blade, clock;\ncommands, snapshot"),
    "sim/run/undo": (370, 490, 106, "changes taken\nback"),
    "sim/run/blade": (500, 490, 106, "the course of\na stroke"),
    "sim/run": (630, 490, 104, "Simulation:\na step"),
    "sim/base": (130, 810, 94, "mathematics,\npredicates"),
    "sim/mesh": (130, 724, 94, "half-edges,\npieces, trees"),
    "sim/repair": (20, 724, 84, "faults\nfound"),
    "sim/cut": (264, 733, 98, "types, words"),
    "sim/cut/surface": (392, 733, 106, "what lies near"),
    "sim/cut/exact": (392, 819, 106, "triangulation"),
    "sim/cut/plan": (526, 772, 106, "one try of\na step"),
    "sim/cut/commit": (660, 709, 100, "carries it out"),
    "sim/cut/patch": (660, 772, 100, "closes wounds"),
    "sim/cut/cleanup": (660, 835, 100, "removes slivers"),
    "sim/cut/stroke": (786, 772, 94, "Cutter, retry\nladder"),
    "gpu": (14, 920, 892, "OpenGL: context, buffers, programs"),
}
# Where the straight way would lead through rooms: corners of the arrow.
WAYS = {
    ("app/practice", "sim/cut"): [(34, 144), (34, 170), (17, 170), (17, 670), (340, 670), (340, 732)],
    ("app/session", "app/files/export"): [(138, 144), (138, 156), (613, 156), (613, 179)],
    ("app/session", "render"): [(112, 144), (112, 355), (469, 355), (469, 383)],
    ("app/cli/replay", "app/link"): [(738, 144), (738, 162), (103, 162), (103, 205)],
    ("app/link", "app/files/export"): [(92, 250), (92, 262), (600, 262), (600, 225)],
    ("app/link", "sim/run"): [(60, 250), (60, 352), (664, 352), (664, 489)],
    ("app/study", "ui"): [(337, 144), (337, 168), (279, 168), (279, 297)],
    ("app/scene", "ui"): [(471, 144), (471, 168), (441, 168), (441, 297)],
    ("app/files/film", "app/files/io"): [(726, 224), (726, 256), (189, 256), (189, 243)],
    ("sim/repair", "sim/cut/exact"): [(64, 786), (64, 892), (445, 892), (445, 865)],
    ("sim/repair", "sim/mesh"): [(106, 755), (129, 755)],
    ("app/session", "sim/run"): [(118, 144), (118, 349), (682, 349), (682, 489)],
    ("render/scene", "sim/solve"): [(166, 428), (166, 446), (184, 446), (184, 581), (400, 581), (400, 589)],
    ("sim/run/start", "sim/solve"): [(130, 552), (130, 568), (430, 568), (430, 589)],
    ("sim/run/start", "sim/cut/stroke"): [(90, 552), (90, 574), (833, 574), (833, 771)],
    ("sim/contact", "gpu"): [(239, 652), (239, 919)],
    ("sim/cut/exact", "sim/base"): [(392, 841), (225, 841)],
}
HEIGHTS = {"gpu": 42}


def height_of(room):
    return HEIGHTS.get(room, 44 if "\n" not in FLOORS[room][3] else 62)


def rooms_in_order():
    test = (ROOT / "tests/house/include_direction_test.cpp").read_text()
    every = re.findall(r'"((?!shaders)[\w/]+)"', re.search(r"kRooms = \{(.*?)\};", test, re.S)[1])
    # Rooms within one that has a place are drawn as that.
    return [room for room in every if room in FLOORS or room.rpartition("/")[0] not in FLOORS]


def room_of(path, rooms):
    return next((str(p) for p in pathlib.PurePath(path).parents if str(p) in rooms), None)


def includes(rooms):
    """Pairs (from, to) of different rooms."""
    pairs = set()
    for folder in sorted({room.split("/")[0] for room in rooms}):
        for source in sorted((ROOT / folder).rglob("*")):
            if source.suffix not in (".cpp", ".h"):
                continue
            own = room_of(source.relative_to(ROOT), rooms)
            for path in re.findall(r'^\s*#\s*include\s+"([^"]+)"', source.read_text(), re.M):
                beside = source.parent / path
                other = room_of(beside.relative_to(ROOT) if beside.exists() else path, rooms)
                if other and other != own:
                    pairs.add((own, other))
    return pairs


def without_implied(pairs):
    """The pairs that no way over other rooms stands for."""
    after = {}
    for a, b in pairs:
        after.setdefault(a, set()).add(b)

    def reached(a, without):
        seen, waiting = set(), [b for b in after.get(a, ()) if b != without]
        while waiting:
            room = waiting.pop()
            if room not in seen:
                seen.add(room)
                waiting += after.get(room, ())
        return seen

    return sorted((a, b) for a, b in pairs if b not in reached(a, b))


def way(a, b):
    """The path of the arrow from room a to room b."""
    ax, ay, aw, _ = FLOORS[a]
    bx, by, bw, _ = FLOORS[b]
    ah, bh = height_of(a), height_of(b)
    if (a, b) in WAYS:
        return rounded(WAYS[a, b])
    if ay == by and ax - bx - bw > 40:  # over what stands between
        return rounded([(ax + aw / 2, ay), (ax + aw / 2, ay - 14), (bx + bw / 2, ay - 14), (bx + bw / 2, by - 1)])
    if ay < by + bh + 60 and ax > bx + bw and by < ay + ah + 90:
        return rounded([(ax, ay + ah / 2), (bx + bw + 1, by + bh / 2)])
    x = min(max(bx + bw / 2, ax + 16), ax + aw - 16)
    end = (min(max(x, bx + 16), bx + bw - 16), by - 1)
    bend = (end[1] - ay - ah) / 2
    return (f"M{x},{ay + ah} C{x},{ay + ah + bend} {end[0]},{end[1] - bend} {end[0]},{end[1]}")


def arrow(d, a, b):
    color = COLORS[a.split("/")[0]]
    d.add(f'<path d="{way(a, b)}" fill="none" stroke="{color}" stroke-width="1.6" '
          f'marker-end="url(#tip{color[1:]})"/>')


def main():
    rooms = rooms_in_order()
    if set(rooms) != set(FLOORS):
        raise SystemExit(f"rooms without a place in FLOORS, or places without a room: "
                         f"{sorted(set(rooms) ^ set(FLOORS))}")
    pairs = without_implied(includes(rooms))
    ahead = [pair for pair in pairs if rooms.index(pair[0]) < rooms.index(pair[1])]
    if ahead:
        raise SystemExit(f"includes that look ahead: {ahead}")
    d = Drawing(920, 982, "The rooms of the source, and which of them includes which")
    d.text((20, 30), "A room includes only what stands to its left on the same floor, or on a floor below. "
           "Arrows that follow from others are left out.",
           INK, size=13.5)
    bands = (("app", 46, 218), ("ui", 274, 76), ("render", 360, 76), ("sim", 446, 462))
    for name, top, height in bands:
        d.box(14, top, 892, height, mixed(COLORS[name], "#ffffff", 0.93),
              mixed(COLORS[name], "#ffffff", 0.6), 12)
        d.text((892, top + 22), name + "/", COLORS[name], "end", 16, "bold")
    d.box(20, 460, 724, 102, "#ffffff", mixed(BLUE, "#ffffff", 0.5), 10)
    d.text((32, 480), "sim/run/", BLUE, size=14, weight="bold")
    d.box(250, 680, 642, 214, "#ffffff", mixed(BLUE, "#ffffff", 0.5), 10)
    d.text((262, 701), "sim/cut/", BLUE, size=14, weight="bold")
    d.text((24, 198), "app/files/", ORANGE, size=14, weight="bold")
    for pair in pairs:
        arrow(d, *pair)
    for room in rooms:
        x, y, width, caption = FLOORS[room]
        color = COLORS[room.split("/")[0]]
        d.box(x, y, width, height_of(room), "#ffffff", color, 7, 1.4)
        d.text((x + 8, y + 18), {"app": "main"}.get(room, room.split("/")[-1]), color,
               size=14, weight="bold")
        for i, line in enumerate(caption.split("\n")):
            d.text((x + 8, y + 35 + 15 * i), line, GREY, size=11.5)
    d.save("house.svg")


if __name__ == "__main__":
    main()
