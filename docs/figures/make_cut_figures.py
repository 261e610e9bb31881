#!/usr/bin/env python3
"""Draws the figures of the cut from what the cutter did: `kerf_cut_figures | make_cut_figures.py`.

Writes cut-step.svg, cut-walls.svg, cut-copies.svg and cut-crossing.svg to docs/images. scripts/figures
builds the program and runs both.
"""
import json
import math
import sys

from svg import (BLUE, BLUE_FILL, GREY, INK, ORANGE, ORANGE_FILL, PALE, RED, RED_FILL, Drawing, View,
                 add, between, cross, dot, mean, mixed, normal_of, scaled, sub, unit)

SKIN = "#e3e7ec"
SAND, SAND_LINE, SAND_INK = "#efe6c9", "#b7a468", "#75642a"  # of older slits
UP = (0.0, 1.0, 0.0)


class Mesh:
    """Triangles with the copies of their vertices. A wall has label 2 * stroke + side."""

    def __init__(self, data):
        self.points = [tuple(p) for p in data["points"]]
        self.faces = list(zip(data["triangles"], data["labels"]))
        self.copies = data["copies"]
        self.sides = {}  # of a vertex on a wall of a stroke: 0 or 1
        for corners, label in self.faces:
            if label >= 0:
                for v in corners:
                    self.sides.setdefault((v, label // 2), set()).add(label % 2)

    def corners(self, face):
        return [self.points[v] for v in face[0]]

    def walls(self, stroke, side):
        return [face for face in self.faces if face[1] == 2 * stroke + side]

    def skin(self):
        return [face for face in self.faces if face[1] < 0]


class Slit:
    """The plane of a stroke: `normal` points to the side that W- bounds."""

    def __init__(self, mesh, stroke, bottom):
        face = mesh.walls(stroke, 0)[0]
        self.mesh, self.stroke, self.bottom = mesh, stroke, bottom
        self.normal = unit(normal_of(*mesh.corners(face)))
        self.point = mesh.corners(face)[0]

    def height(self, p):
        return dot(sub(p, self.point), self.normal)

    def side(self, v):
        """-1 or 1 for what lies beside the slit, 0 for its end. W+ faces along the normal, so its
        body lies on the other side."""
        sides = self.mesh.sides.get((v, self.stroke), set())
        if len(sides) == 2:
            return 0
        if sides:
            return -1 if 0 in sides else 1
        return 1 if self.height(self.mesh.points[v]) > 0 else -1

    def opened(self, v, angle):
        """Where v goes when what lies above the bottom turns away to its side, by `angle` at most."""
        p = self.mesh.points[v]
        above = p[1] - self.bottom
        if above <= 0:
            return (0.0, 0.0, 0.0)
        away = abs(self.height(p))
        turn = math.radians(angle) / (1 + 1.2 * away)
        return add(scaled(self.normal, self.side(v) * above * math.sin(turn)),
                   scaled(UP, -above * (1 - math.cos(turn))))


def polygon_through(mesh, point, normal):
    """Where a plane meets the skin, as one loop about its middle."""
    hits = []
    for face in mesh.skin():
        c = mesh.corners(face)
        for i in range(3):
            a, b = c[i], c[(i + 1) % 3]
            da, db = dot(sub(a, point), normal), dot(sub(b, point), normal)
            if (da > 0) != (db > 0):
                hits.append(between(a, b, da / (da - db)))
    middle = mean(hits)
    along = unit(cross(normal, UP))
    return sorted(hits, key=lambda p: math.atan2(dot(sub(p, middle), UP), dot(sub(p, middle), along)))


def painted(drawing, view, faces, color_of, stroke=mixed(GREY, "#ffffff", 0.35), width=0.7):
    """Faces from the farthest to the nearest; a face is a list of three points."""
    for points, kind in sorted(faces, key=lambda f: view.depth(mean(f[0]))):
        normal = normal_of(*points)
        drawing.polygon([view.at(p) for p in points], view.shade(normal, color_of(kind)), stroke, width)


def covers(view, points, p):
    """Whether a face hides the point p."""
    a, b, c = (view.at(q) for q in points)
    x = view.at(p)
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if abs(area) < 1e-6:
        return False
    u = ((b[0] - x[0]) * (c[1] - x[1]) - (b[1] - x[1]) * (c[0] - x[0])) / area
    v = ((c[0] - x[0]) * (a[1] - x[1]) - (c[1] - x[1]) * (a[0] - x[0])) / area
    w = 1 - u - v
    if min(u, v, w) < 1e-6:
        return False
    return u * view.depth(points[0]) + v * view.depth(points[1]) + w * view.depth(points[2]) > \
        view.depth(p) + 1e-3


class Opened:
    """A mesh whose slits stand open, so that copies lie apart."""

    def __init__(self, mesh, view, slits):
        self.mesh, self.view = mesh, view
        self.points = []
        for v, p in enumerate(mesh.points):
            for slit, angle in slits:
                p = add(p, slit.opened(v, angle))
            self.points.append(p)
        self.faces = [([self.points[v] for v in corners], label) for corners, label in mesh.faces]

    def paint(self, drawing):
        def color(label):
            return SKIN if label < 0 else (BLUE_FILL, ORANGE_FILL)[label % 2]
        painted(drawing, self.view, self.faces, color)

    def at(self, v):
        return self.view.at(self.points[v])

    def is_seen(self, v):
        return not any(covers(self.view, points, self.points[v]) for points, _ in self.faces)

    def seen_copies(self):
        return [c for c in self.mesh.copies if all(self.is_seen(v) for v in c)]


def color_of_copy(mesh, v, stroke=0):
    return ORANGE if 1 in mesh.sides.get((v, stroke), set()) else BLUE


def rung_line(d, view, rung, color, width=3.4):
    """Heavy inside the body, dashed in the air."""
    points = [view.at(n["at"]) for n in rung]
    for a, b, node in zip(points, points[1:], rung):
        if node["attached"]:
            d.line([a, b], color, width)
        elif math.dist(a, b) > 1:
            d.line([a, b], color, 1.6, "5 5")
    for p, node in zip(points, rung):
        if node["vertex"] >= 0:
            d.dot(p, color, 4.6)
        else:
            d.dot(p, color, 4.6, "#ffffff")


def step_figure(scene):
    d = Drawing(920, 520, "Rung, front and strip of one step of the cut")
    view = View(30, 24, 420, (455, 262))
    mesh, step = Mesh(scene["before"]), scene["step"]
    slit = Slit(mesh, 0, 0)
    toward = slit.normal if dot(slit.normal, view.toward) > 0 else scaled(slit.normal, -1)
    behind = [f for f in mesh.skin() if dot(sub(mean(mesh.corners(f)), slit.point), toward) < 0]
    painted(d, view, [(mesh.corners(f), f) for f in behind], lambda _: SKIN)
    section = [view.at(p) for p in polygon_through(mesh, slit.point, slit.normal)]
    d.polygon(section, "#ffffff", INK, 1.4, 0.9)
    circle = [scaled(add(scaled(view.right, math.cos(a)), scaled(view.up, math.sin(a))), 0.497)
              for a in (2 * math.pi * i / 90 for i in range(91))]
    d.line([view.at(p) for p in circle], GREY, 1.1, "4 5")
    for face in mesh.walls(0, 0):
        d.polygon([view.at(p) for p in mesh.corners(face)], BLUE_FILL,
                  mixed(BLUE, "#ffffff", 0.45), 0.9)
    strip = [tuple(p) for p in step["strip"]["points"]]
    for t in step["strip"]["triangles"]:
        d.polygon([view.at(strip[i]) for i in t], RED_FILL, mixed(RED, "#ffffff", 0.45), 0.9, 0.72)
    d.line(section + section[:1], INK, 1.2)
    rung = step["rung"]
    blade = [view.at(strip[step["strip"]["new"][i]]) for i in (0, -1)]
    d.line(blade, RED, 4)
    deep = rung[0]["at"][1] - strip[step["strip"]["new"][0]][1]
    for i in (2, 5):
        start, end = (view.at(sub(rung[i]["at"], (0, share * deep, 0))) for share in (0.12, 0.9))
        d.line([start, end], RED, 2.2, arrow=True)
    rung_line(d, view, rung, INK)
    for end, name, dx in ((blade[0], "A", -18), (blade[1], "B", 9)):
        d.text((end[0] + dx, end[1] + 6), name, RED, weight="bold", size=17)
    seen = [view.at(n["at"]) for n in rung]
    d.label(seen[0], (34, 200), "air point\na node of the rung\noutside the body", INK)
    d.label(between(seen[1], seen[2], 0.35), (100, 34), "front\nthe part of the rung\ninside the body", INK)
    d.label(view.at((0.2, 0.3, 0.02)), (680, 50),
            "walls of the steps before\nboth sides of the slit,\nstill at the same place", BLUE)
    d.label(between(seen[-2], seen[-1], 0.6), (745, 200),
            "rung\nwhere the blade stood\nafter the last step", INK)
    d.label(add(between(seen[-1], blade[1], 0.5), (-34, -4)), (700, 450),
            "strip\nwhat the blade\nsweeps in this step", RED)
    d.label(between(blade[0], blade[1], 0.1), (34, 350), "blade AB\nwhere it stands now", RED)
    d.label(view.at((0.08, -0.36, 0)), (330, 504), "material that is still uncut", GREY)
    d.text((34, 500), "The half of the body in front is left away.", GREY, size=13.5)
    d.save("cut-step.svg")


def outline_panel(d, plan, x, y, scale, aside=None):
    """The strip in its own plane, turned so that the blade goes down. `aside`: by node, how far it
    is moved."""
    layout = plan["layout"]
    right = max(p[0] for p in layout)
    aside = aside or {}

    def at(i):
        return (x + scale * (right - layout[i][0]) - aside.get(i, 0), y + scale * layout[i][1])

    for t in plan["wallPlus"]:
        d.polygon([at(i) for i in t], BLUE_FILL, mixed(BLUE, "#ffffff", 0.5), 0.9)
    colors = {"cut": INK, "free": RED, "front": GREY}
    for a, b, kind in plan["outline"]:
        d.line([at(a), at(b)], colors[kind], 3.2)
        if math.dist(at(a), at(b)) > 24:
            d.line([between(at(a), at(b), 0.4), between(at(a), at(b), 0.64)], colors[kind], 3.2,
                   arrow=True)
    for a, _, _ in plan["outline"]:
        d.dot(at(a), INK, 3.6)
    return at


def loops_aside(plan, distance):
    """By node of the outline: its loop is moved to the left or to the right of all of them."""
    loop = {}
    for _ in plan["outline"]:
        for a, b, _ in plan["outline"]:
            loop[a] = loop[b] = min(loop.get(a, a), loop.get(b, b))
    middle = mean([plan["layout"][i] for i in loop])[0]
    result = {}
    for own in set(loop.values()):
        nodes = [i for i in loop if loop[i] == own]
        side = 1 if mean([plan["layout"][i] for i in nodes])[0] > middle else -1
        result |= {i: side * distance for i in nodes}
    for triangle in plan["wallPlus"]:  # inner nodes go with their sheet
        known = [result[i] for i in triangle if i in result]
        result |= {i: known[0] for i in triangle if i not in result and known}
    return result


def edges_of(plan, kind):
    return [e for e in plan["outline"] if e[2] == kind]


def walls_figure(scene):
    d = Drawing(920, 420, "The outline of a step and its two walls")
    mesh, plan = Mesh(scene["before"]), scene["step"]["plan"]
    d.text((30, 42), "The outline of the new wall", INK, size=17, weight="bold")
    d.text((30, 64), "the strip seen face on; the blade goes down", GREY, size=14)
    at = outline_panel(d, plan, 55, 160, 370)
    cut, free, front = (edges_of(plan, kind) for kind in ("cut", "free", "front"))

    def middle(e):
        return between(at(e[0]), at(e[1]), 0.5)

    d.label(middle(front[3]), (262, 112), "front\nthe slit grows on here", GREY)
    d.label(middle(min(cut, key=lambda e: middle(e)[0])), (30, 328), "cut\nthe skin opens here", INK)
    d.label(middle(free[len(free) // 2]), (215, 328), "free\ninside the body: the new front", RED)
    d.text((30, 398), "The wall lies on the left of each arrow.", GREY, size=13.5)

    d.text((480, 42), "Two walls stand on it", INK, size=17, weight="bold")
    d.text((480, 64), "the same triangles, turned opposite ways; drawn open", GREY, size=14)
    view = View(74, 36, 375, (700, 240), (0, -0.03, 0))
    points = [tuple(p) for p in plan["points"]]
    slit = Slit(mesh, 0, 0)
    bottom = min(p[1] for p in points)
    turn = math.radians(38)

    def opened(p, side):
        above = p[1] - bottom
        return add(p, add(scaled(slit.normal, side * above * math.sin(turn)),
                          scaled(UP, -above * (1 - math.cos(turn)))))

    looks = {-1: (BLUE_FILL, BLUE), 1: (ORANGE_FILL, ORANGE)}
    far = 1 if dot(slit.normal, view.toward) < 0 else -1
    for side in (far, -far):
        fill, color = looks[side]
        largest = sorted(plan["wallPlus"], reverse=True,
                         key=lambda t: math.dist((0, 0, 0), normal_of(*(points[i] for i in t))))
        for t in plan["wallPlus"]:
            d.polygon([view.at(opened(points[i], side)) for i in t], fill,
                      mixed(color, "#ffffff", 0.3), 0.9)
        border = [view.at(opened(points[i], side)) for e in front for i in e[:2]]
        d.line(border, GREY, 2.6)
        for e in cut:
            d.line([view.at(opened(points[i], side)) for i in e[:2]], INK, 2.6)
        for t in largest[:7:2]:
            c = [opened(points[i], side) for i in t]
            along = unit(normal_of(*c))
            into = scaled(along, 1 if dot(along, slit.normal) * side < 0 else -1)
            d.line([view.at(mean(c)), view.at(add(mean(c), scaled(into, 0.11)))], color, 2.4, arrow=True)
    front_line = [view.at(points[i]) for i in [free[0][0]] + [e[1] for e in free]]
    d.line(front_line, RED, 3.8)
    for p in front_line:
        d.dot(p, RED, 4)
    for side, name, target, at in ((1, "W−", (-0.25, 0.05), (500, 215)),
                                   (-1, "W+", (-0.25, 0.05), (862, 215))):
        p = add(scaled(cross(slit.normal, UP), target[0]), (0, target[1], 0))
        d.label(view.at(opened(p, side)), at, name, looks[side][1], size=18)
    d.label(between(front_line[0], front_line[1], 0.5), (500, 350),
            "new front\nboth walls\nend here", RED)
    d.label(view.at(opened(points[front[0][0]], -1)) if far > 0 else
            view.at(opened(points[front[-1][1]], -1)), (765, 110),
            "old front\nhere each goes on\nin an older wall", GREY)
    d.save("cut-walls.svg")


def copies_figure(scene):
    d = Drawing(920, 500, "Copies of vertices at a slit")
    view = View(77, 36, 430, (460, 280))
    mesh = Mesh(scene["after"])
    rung = scene["rungAfter"]
    bottom = min(n["at"][1] for n in rung)
    opened = Opened(mesh, view, [(Slit(mesh, 0, bottom), 36)])
    opened.paint(d)
    pairs = sorted(opened.seen_copies(), key=lambda c: min(opened.at(v)[1] for v in c))
    on_skin = {v for corners, label in mesh.faces if label < 0 for v in corners}
    near = [c for c in pairs if c[0] in on_skin and opened.at(c[0])[1] > 300]
    shown = near[0::3]
    for c in shown:
        d.line([opened.at(v) for v in c], INK, 1.4, "3 4")
    for c in pairs:
        for v in c:
            d.dot(opened.at(v), color_of_copy(mesh, v), 5.2 if c in shown else 3.2)
    front = [n["vertex"] for n in rung if n["vertex"] >= 0 and opened.is_seen(n["vertex"])]
    d.line([opened.at(v) for v in front], RED, 3.6)
    for v in front:
        d.dot(opened.at(v), RED, 4.8)
    left, right = sorted((opened.at(v) for v in shown[0]), key=lambda p: p[0])
    d.label(left, (30, 400), "one point of the body,\ntwo copies: one vertex\non each side of the slit", ORANGE)
    d.label(right, (735, 400), "its other copy", BLUE)
    d.label(opened.at(front[2]), (470, 26), "front\none vertex each: the slit\nends here, both walls meet", RED)
    wall = {side: mean([opened.at(v) for f in mesh.walls(0, side) for v in f[0]]) for side in (0, 1)}
    d.label(add(wall[1], (-14, -90)), (60, 90), "wall W−", ORANGE, size=17)
    d.label(add(wall[0], (46, -90)), (790, 90), "wall W+", BLUE, size=17)
    d.text((30, 34), "Drawn open: at first all copies of a point lie at one place.", GREY, size=13.5)
    d.save("cut-copies.svg")


def crossing_figure(scene):
    d = Drawing(920, 520, "A step that crosses an older slit")
    plan = scene["step"]["plan"]
    aside = loops_aside(plan, 9)
    middle = max(plan["layout"][i][0] for i in aside if aside[i] < 0)
    d.text((30, 42), "The strip, face on", INK, size=17, weight="bold")
    d.text((30, 64), "the older slit, seen edge on, parts the outline", GREY, size=14)
    at = outline_panel(d, plan, 36, 205, 350, aside)
    gap = [i for e in edges_of(plan, "cut") for i in e[:2]
           if abs(plan["layout"][i][0] - middle) < 0.02]
    inner = {kind: [i for e in edges_of(plan, kind) for i in e[:2]
                    if abs(plan["layout"][i][0] - middle) < 0.02] for kind in ("front", "free")}
    d.line([add(mean([at(i) for i in inner["front"]]), (0, -70)),
            add(mean([at(i) for i in inner["front"]]), (0, -4))], SAND_LINE, 5)
    d.line([add(mean([at(i) for i in inner["free"]]), (0, 4)),
            add(mean([at(i) for i in inner["free"]]), (0, 84))], SAND_LINE, 5)
    d.label(add(mean([at(i) for i in inner["front"]]), (0, -50)), (250, 130), "older slit", SAND_INK)
    d.label(min((at(i) for i in inner["front"])), (40, 124), "two vertices\nof the front, one\non each side", INK)
    d.label(mean([at(i) for i in gap]), (256, 400), "cut\nthe older walls\nopen here", INK)
    d.text((30, 495), "In the picture on the right both slits are drawn open.", GREY, size=13.5)

    after = Mesh(scene["after"])
    view = View(36, 48, 400, (675, 290))
    bottom = min(n["at"][1] for n in scene["rungAfter"])
    opened = Opened(after, view, [(Slit(after, 0, -0.24), 20), (Slit(after, 1, bottom), 26)])
    painted(d, view, opened.faces, lambda label: SKIN if label < 0 else SAND if label < 2 else
            (BLUE_FILL, ORANGE_FILL)[label % 2])
    top = max((c for c in after.copies if len(c) == 4), key=lambda c: after.points[c[0]][1])
    around = sorted((opened.at(v) for v in top),
                    key=lambda p, m=mean([opened.at(v) for v in top]): math.atan2(p[1] - m[1], p[0] - m[0]))
    d.line(around + around[:1], INK, 1.4, "3 4")
    for p in around:
        d.dot(p, INK, 5.6)
    d.label(min(around, key=lambda p: p[1]), (675, 30), "one point of the body, four copies", INK,
            "middle")
    d.label(view.at(add(after.points[top[0]], (-0.2, 0.02, -0.12))), (440, 110), "older slit", SAND_INK)
    d.label((560, 350), (430, 460), "new slit", ORANGE)
    d.save("cut-crossing.svg")


def main():
    data = json.load(sys.stdin)
    for scene in (data["step"], data["crossing"]):
        if scene["reason"]:
            raise SystemExit(f"the first try of a scene's step fails: {scene['reason']}")
    step_figure(data["step"])
    walls_figure(data["step"])
    copies_figure(data["step"])
    crossing_figure(data["crossing"])


if __name__ == "__main__":
    main()
