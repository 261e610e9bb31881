#!/usr/bin/env python3
"""Draws the figures of docs/physics.md as SVG, with the Python standard library alone.

  docs/figures/make_physics_figures.py    writes docs/images/physics-constraints.svg

Rays, normals and gradients are worked out, not drawn by eye.
"""
import math
import re

from svg import (BLUE, GREEN, GREY, IMAGES, INK, ORANGE, PALE, add, between, cross, dot, scaled, sub,
                 unit)

BLUE_FILL, ORANGE_FILL, GREEN_FILL, GREY_FILL = "#dbe8fb", "#fbe3d2", "#dcf1e3", "#eef1f5"


class Drawing:
    """SVG elements, in pixels, y down."""

    def __init__(self, width, height, title):
        self.width, self.height = width, height
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif" '
            f'font-size="16" stroke-linejoin="round" stroke-linecap="round">',
            f"<title>{title}</title>",
            "<defs>" + "".join(self.arrow_head(c) for c in (INK, GREY, BLUE, ORANGE, GREEN)) + "</defs>",
            f'<rect x="1" y="1" width="{width - 2}" height="{height - 2}" rx="14" fill="#ffffff" '
            f'stroke="{PALE}"/>',
        ]

    @staticmethod
    def arrow_head(color):
        return (f'<marker id="tip{color[1:]}" viewBox="0 0 10 10" refX="8.5" refY="5" '
                f'markerWidth="7" markerHeight="7" orient="auto-start-reverse">'
                f'<path d="M0,0.8 L9.5,5 L0,9.2 z" fill="{color}"/></marker>')

    @staticmethod
    def path_of(points, closed):
        return "M" + " L".join(f"{x:.1f},{y:.1f}" for x, y in points) + (" z" if closed else "")

    def polygon(self, points, fill, stroke=INK, width=1.6):
        self.parts.append(f'<path d="{self.path_of(points, True)}" fill="{fill}" stroke="{stroke}" '
                          f'stroke-width="{width}"/>')

    def line(self, points, stroke=INK, width=1.6, dashes="", arrow=False):
        extra = f' stroke-dasharray="{dashes}"' if dashes else ""
        extra += f' marker-end="url(#tip{stroke[1:]})"' if arrow else ""
        self.parts.append(f'<path d="{self.path_of(points, False)}" fill="none" stroke="{stroke}" '
                          f'stroke-width="{width}"{extra}/>')

    def dot(self, at, color=INK, radius=4.0):
        self.parts.append(f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius}" fill="{color}" '
                          f'stroke="#ffffff" stroke-width="1"/>')

    def text(self, at, words, color=INK, anchor="start", size=16, weight="normal"):
        """`_x` and `_{xy}` are set lower."""
        spans = []
        lowered = False
        for part in re.split(r"(_\{[^}]*\}|_\w)", words):
            if part.startswith("_"):
                spans.append(f'<tspan dy="4" font-size="{0.72 * size:.1f}">{part.strip("_{}")}</tspan>')
                lowered = True
            elif part:
                shift = ' dy="-4"' if lowered else ""
                spans.append(f"<tspan{shift}>{part}</tspan>")
                lowered = False
        self.parts.append(f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" fill="{color}" font-size="{size}" '
                          f'font-weight="{weight}" text-anchor="{anchor}" xml:space="preserve">'
                          f'{"".join(spans)}</text>')

    def save(self, name):
        (IMAGES / name).write_text("\n".join([*self.parts, "</svg>"]) + "\n")


class Panel:
    """A quarter of the figure: a heading, a drawing, the constraint function below it."""

    def __init__(self, drawing, x, y, color, heading, subtitle, formula):
        self.drawing, self.x, self.y = drawing, x, y
        drawing.text((x + 24, y + 34), heading, color, size=19, weight="bold")
        drawing.text((x + 24, y + 56), subtitle, GREY, size=14.5)
        drawing.text((x + 240, y + 344), formula, INK, "middle", size=17)

    def at(self, x, y):
        return (self.x + x, self.y + y)


def zigzag(a, b, turns, height):
    along = sub(b, a)
    aside = unit((-along[1], along[0]))
    points = [a, between(a, b, 0.14)]
    for i in range(2 * turns):
        t = 0.14 + 0.72 * (i + 0.5) / (2 * turns)
        points.append(add(between(a, b, t), scaled(aside, height if i % 2 == 0 else -height)))
    return [*points, between(a, b, 0.86), b]


def draw_edge(drawing, x, y):
    panel = Panel(drawing, x, y, BLUE, "Edge", "one for each edge of the skin",
                  "C = |p_a − p_b| − L")
    a, b = panel.at(120, 194), panel.at(330, 194)
    above, below = panel.at(206, 92), panel.at(252, 300)
    drawing.polygon([a, b, above], BLUE_FILL)
    drawing.polygon([a, b, below], BLUE_FILL)
    # As wide as both areas over the length: half of both heights together.
    half = 0.25 * ((a[1] - above[1]) + (below[1] - a[1]))
    strip = [(a[0], a[1] - half), (b[0], a[1] - half), (b[0], a[1] + half), (a[0], a[1] + half)]
    drawing.line([*strip, strip[0]], GREY, 1.4, "5 5")
    drawing.line(zigzag(a, b, 9, 7), BLUE, 2.4)
    drawing.text(panel.at(206, 134), "A_1", INK, "middle")
    drawing.text(panel.at(250, 268), "A_2", INK, "middle")
    drawing.text((a[0] - 12, a[1] + 5), "p_a", INK, "end")
    drawing.text((b[0] + 12, b[1] + 5), "p_b")
    drawing.text(panel.at(344, 146), "band of area", GREY, size=14.5)
    drawing.text(panel.at(344, 165), "A_1 + A_2,", GREY, size=14.5)
    drawing.text(panel.at(344, 243), "thickness t", GREY, size=14.5)
    drawing.dot(a)
    drawing.dot(b)


def draw_bend(drawing, x, y):
    panel = Panel(drawing, x, y, ORANGE, "Bend", "one for each edge, over four vertices",
                  "C = θ − θ_{rest},  at most ±0.3 rad")
    v0, v1 = (0.0, -0.95, 0.0), (0.0, 0.95, 0.0)
    v2, v3 = (-1.45, 0.1, -0.66), (1.45, -0.1, -0.66)

    def seen(p):
        return panel.at(240 + 100 * p[0] + 9 * p[1], 206 - 92 * p[2] - 62 * p[1])

    edge = sub(v1, v0)
    normals = [unit(cross(edge, sub(v2, v0))), unit(cross(sub(v3, v0), edge))]
    drawing.polygon([seen(v0), seen(v1), seen(v2)], ORANGE_FILL)
    drawing.polygon([seen(v0), seen(v1), seen(v3)], "#f7cfb1")
    drawing.line([seen(v0), seen(v1)], ORANGE, 3.4)
    middle = between(v0, v1, 0.5)
    for normal, name, aside in zip(normals, ("n_A", "n_B"), (-1, 1)):
        tip = seen(add(middle, scaled(normal, 1.2)))
        drawing.line([seen(middle), tip], INK, 1.8, arrow=True)
        drawing.text((tip[0] + 8 * aside, tip[1] + 2), name, INK, "end" if aside < 0 else "start")
    # The angle between both normals, in their plane.
    cosine = dot(*normals)
    theta = math.acos(cosine)
    square = unit(sub(normals[1], scaled(normals[0], cosine)))
    turned = [add(scaled(normals[0], math.cos(t)), scaled(square, math.sin(t)))
              for t in (theta * i / 24 for i in range(25))]
    arc = [seen(add(middle, scaled(n, 1.0))) for n in turned]
    drawing.line(arc, ORANGE, 2)
    drawing.text((arc[12][0], arc[12][1] - 8), "θ", ORANGE, "middle", weight="bold")
    for p, name, dx, dy, anchor in ((v0, "p_0", 0, 24, "middle"), (v1, "p_1", -9, 4, "end"),
                                    (v2, "p_2", -6, 22, "middle"), (v3, "p_3", 8, 22, "middle")):
        at = seen(p)
        drawing.dot(at)
        drawing.text((at[0] + dx, at[1] + dy), name, INK, anchor)
    left, right = seen(between(between(v0, v1, 0.42), v2, 0.48)), seen(between(between(v0, v1, 0.42), v3, 0.45))
    drawing.text((left[0], left[1] + 6), "A", GREY, "middle")
    drawing.text((right[0], right[1] + 6), "B", GREY, "middle")


def outline(count, radius_x, radius_y, dent):
    """A section of a soft body, counter-clockwise on the screen with y down taken as up."""
    points = []
    for i in range(count):
        angle = 2 * math.pi * (i + 0.5) / count
        r = 1 - dent * math.cos(2 * angle + 0.7) + 0.05 * math.cos(3 * angle)
        points.append((radius_x * r * math.cos(angle), radius_y * r * math.sin(angle)))
    return points


def inward_normal(points, i):
    """Of a vertex of the outline: the mean of its two sides', turned inwards."""
    total = (0.0, 0.0)
    for j in (i - 1, i):
        side = unit(sub(points[(j + 1) % len(points)], points[j]))
        total = add(total, (-side[1], side[0]))
    return unit(total)


def ray_hit(points, i, direction):
    """The side on which the ray from a vertex ends, and where."""
    best = None
    for j in range(len(points)):
        k = (j + 1) % len(points)
        if i in (j, k):
            continue
        side = sub(points[k], points[j])
        scale = direction[0] * side[1] - direction[1] * side[0]
        if abs(scale) < 1e-9:
            continue
        way = sub(points[j], points[i])
        t = (way[0] * side[1] - way[1] * side[0]) / scale
        u = (way[0] * direction[1] - way[1] * direction[0]) / scale
        if t > 0 and 0 <= u <= 1 and (best is None or t < best[0]):
            best = (t, j, add(points[i], scaled(direction, t)))
    return best


def draw_ispc(drawing, x, y):
    panel = Panel(drawing, x, y, GREEN, "ISPC", "one for each vertex, along its inward normal",
                  "C = |p_v − q| − L_0,   q = b_0 p_0 + b_1 p_1 + b_2 p_2")
    points = outline(18, 158, 84, 0.06)

    def seen(p):
        return panel.at(236 + p[0], 200 + p[1])

    chosen = 13
    drawing.polygon([seen(p) for p in points], GREY_FILL, INK, 1.8)
    for i in range(len(points)):
        if i != chosen:
            hit = ray_hit(points, i, inward_normal(points, i))
            drawing.line([seen(points[i]), seen(hit[2])], PALE, 1.2)
    normal = inward_normal(points, chosen)
    length, side, hit = ray_hit(points, chosen, normal)
    # The column that the ray stands for: half of the way to both neighbours.
    across = (-normal[1], normal[0])
    widths = [0.5 * dot(sub(points[(chosen + step) % len(points)], points[chosen]), across)
              for step in (-1, 1)]
    column = [add(points[chosen], scaled(across, w)) for w in widths]
    column += [add(p, scaled(normal, length)) for p in reversed(column)]
    drawing.parts.append(f'<path d="{drawing.path_of([seen(p) for p in column], True)}" '
                         f'fill="{GREEN}" fill-opacity="0.16" stroke="none"/>')
    drawing.polygon([seen(p) for p in points], "none", INK, 1.8)
    ends = [points[side], points[(side + 1) % len(points)]]
    drawing.line([seen(p) for p in ends], GREEN, 3.4)
    drawing.line([seen(points[chosen]), seen(hit)], GREEN, 2.6)
    outward = add(points[chosen], scaled(normal, -32))
    drawing.line([seen(points[chosen]), seen(outward)], INK, 1.6, arrow=True)
    for p in points:
        drawing.dot(seen(p), radius=3.2)
    drawing.dot(seen(points[chosen]), GREEN, 5)
    drawing.dot(seen(hit), GREEN, 5)
    at = seen(points[chosen])
    drawing.text((at[0] + 10, at[1] - 10), "p_v", INK)
    tip = seen(outward)
    drawing.text((tip[0] - 9, tip[1] + 9), "normal", GREY, "end", size=14.5)
    at = seen(hit)
    drawing.text((at[0] + 2, at[1] + 22), "q", INK, "middle")
    drawing.text((seen(ends[0])[0] + 30, seen(ends[0])[1] + 24), "opposite triangle", GREEN, size=14.5)
    at = seen(between(points[chosen], hit, 0.52))
    drawing.text((at[0] + 16, at[1] + 5), "L_0", GREEN, weight="bold")


def draw_volume(drawing, x, y):
    panel = Panel(drawing, x, y, INK, "Volume", "one for each closed piece, over all of its vertices",
                  "C = V − V_{target}")
    whole = outline(26, 150, 76, 0.05)
    cut = 6.0  # where the blade went
    n = len(whole)
    crossings = [i for i in range(n) if (whole[i][0] < cut) != (whole[(i + 1) % n][0] < cut)]
    places = []
    for i in crossings:
        p, q = whole[i], whole[(i + 1) % n]
        places.append(between(p, q, (cut - p[0]) / (q[0] - p[0])))
    # Into the left piece at the first crossing, back into the right one at the second.
    left = whole[crossings[0] + 1:crossings[1] + 1]
    right = whole[crossings[1] + 1:] + whole[:crossings[0] + 1]
    pieces = []
    for half, begin, end, sign in ((left, places[0], places[1], -1), (right, places[1], places[0], 1)):
        kept = [p for p in half if abs(p[0] - cut) > 12]
        wall = [between(end, begin, t) for t in (0.0, 0.25, 0.5, 0.75, 1.0)]
        pieces.append(([add(p, (36 * sign, 0)) for p in [*kept, *wall]], sign))
    for (points, sign), name in zip(pieces, ("V_1", "V_2")):
        seen = [panel.at(232 + px, 196 + py) for px, py in points]
        drawing.polygon(seen, GREY_FILL, INK, 1.8)
        n = len(points)
        for i in range(n):
            # The gradient of the area by a vertex of its outline.
            chord = sub(points[(i + 1) % n], points[i - 1])
            gradient = scaled((chord[1], -chord[0]), 0.34)
            drawing.line([seen[i], add(seen[i], gradient)], BLUE, 1.6, arrow=True)
        for p in seen:
            drawing.dot(p, radius=3.2)
        middle = scaled((sum(p[0] for p in seen), sum(p[1] for p in seen)), 1 / n)
        drawing.text((middle[0], middle[1] + 7), name, INK, "middle", size=20)
    drawing.text(panel.at(410, 118), "∇V", BLUE, weight="bold")


def draw_constraints():
    drawing = Drawing(960, 740, "The four constraints of a soft body: edge, bend, ISPC, volume")
    drawing.line([(480, 24), (480, 716)], PALE, 1.2)
    drawing.line([(24, 370), (936, 370)], PALE, 1.2)
    draw_edge(drawing, 0, 0)
    draw_bend(drawing, 480, 0)
    draw_ispc(drawing, 0, 370)
    draw_volume(drawing, 480, 370)
    drawing.save("physics-constraints.svg")


if __name__ == "__main__":
    draw_constraints()
