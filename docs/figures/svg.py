"""What the scripts of the figures share: vectors, a view onto three dimensions, SVG elements."""
import html
import math
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
IMAGES = ROOT / "docs" / "images"

INK, GREY, PALE, FAINT = "#1f2933", "#5f6b7a", "#c3cad3", "#eef1f5"
RED, BLUE, ORANGE = "#c8102e", "#1b5fc1", "#c4540a"
GREEN, BROWN = "#1d7a45", "#8a5a00"
RED_FILL, BLUE_FILL, ORANGE_FILL = "#f7c9d0", "#cfe0f8", "#fadcc6"


def add(a, b):
    return tuple(p + q for p, q in zip(a, b))


def sub(a, b):
    return tuple(p - q for p, q in zip(a, b))


def scaled(a, factor):
    return tuple(factor * p for p in a)


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scaled(a, 1 / math.sqrt(dot(a, a)))


def between(a, b, t):
    return add(scaled(a, 1 - t), scaled(b, t))


def mean(points):
    return scaled(tuple(map(sum, zip(*points))), 1 / len(points))


def normal_of(a, b, c):
    """Of length twice the area."""
    return cross(sub(b, a), sub(c, a))


def mixed(color, other, share):
    """`share` of the way from one hexadecimal colour to the other."""
    pairs = [(int(color[i:i + 2], 16), int(other[i:i + 2], 16)) for i in (1, 3, 5)]
    return "#" + "".join(f"{round(a + (b - a) * share):02x}" for a, b in pairs)


def width_of(words, size):
    """About as wide as a sans-serif draws it [px]."""
    return 0.57 * size * len(words)


def rounded(corners, radius=12):
    """The path along these corners, each of them rounded."""
    path = f"M{corners[0][0]:.1f},{corners[0][1]:.1f}"
    for before, corner, after in zip(corners, corners[1:], corners[2:]):
        a, b = (add(corner, scaled(unit(sub(p, corner)), radius)) for p in (before, after))
        path += f" L{a[0]:.1f},{a[1]:.1f} Q{corner[0]:.1f},{corner[1]:.1f} {b[0]:.1f},{b[1]:.1f}"
    return path + f" L{corners[-1][0]:.1f},{corners[-1][1]:.1f}"


class View:
    """Parallel projection: turned about +y by `turn`, then looked at from `tilt` above [degrees]."""

    def __init__(self, turn, tilt, scale, center, looks_at=(0, 0, 0)):
        t, e = math.radians(turn), math.radians(tilt)
        self.right = (math.cos(t), 0, -math.sin(t))
        self.toward = (math.sin(t) * math.cos(e), math.sin(e), math.cos(t) * math.cos(e))
        self.up = cross(self.toward, self.right)
        self.scale, self.center, self.looks_at = scale, center, looks_at

    def at(self, p):
        p = sub(p, self.looks_at)
        return (self.center[0] + self.scale * dot(p, self.right),
                self.center[1] - self.scale * dot(p, self.up))

    def depth(self, p):
        """Larger is nearer."""
        return dot(p, self.toward)

    def shade(self, normal, color):
        """The colour of a face under a light from above on the left."""
        light = unit(add(add(self.up, scaled(self.right, -0.5)), scaled(self.toward, 0.9)))
        return mixed(mixed(color, INK, 0.16), "#ffffff", 0.5 * max(0.0, dot(unit(normal), light)))


class Drawing:
    """SVG elements, in pixels, y down, on a white ground that reads in light and dark pages."""

    def __init__(self, width, height, title):
        self.width, self.height = width, height
        colors = (INK, GREY, RED, BLUE, ORANGE, GREEN, BROWN)
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif" '
            f'font-size="15" stroke-linejoin="round" stroke-linecap="round">',
            f"<title>{html.escape(title)}</title>",
            "<defs>" + "".join(self.arrow_head(c) for c in colors) + "</defs>",
            f'<rect x="1" y="1" width="{width - 2}" height="{height - 2}" rx="14" fill="#ffffff" '
            f'stroke="{PALE}"/>',
        ]

    @staticmethod
    def arrow_head(color):
        return (f'<marker id="tip{color[1:]}" viewBox="0 0 10 10" refX="8.5" refY="5" '
                f'markerWidth="11" markerHeight="11" markerUnits="userSpaceOnUse" '
                f'orient="auto-start-reverse">'
                f'<path d="M0,0.8 L9.5,5 L0,9.2 z" fill="{color}"/></marker>')

    @staticmethod
    def path_of(points, closed):
        return "M" + " L".join(f"{x:.1f},{y:.1f}" for x, y in points) + (" z" if closed else "")

    def add(self, element):
        self.parts.append(element)

    def polygon(self, points, fill, stroke=INK, width=1.2, opacity=1.0):
        extra = f' fill-opacity="{opacity}"' if opacity < 1 else ""
        self.add(f'<path d="{self.path_of(points, True)}" fill="{fill}" stroke="{stroke}" '
                 f'stroke-width="{width}"{extra}/>')

    def line(self, points, stroke=INK, width=1.6, dashes="", arrow=False, opacity=1.0):
        extra = f' stroke-dasharray="{dashes}"' if dashes else ""
        extra += f' marker-end="url(#tip{stroke[1:]})"' if arrow else ""
        extra += f' stroke-opacity="{opacity}"' if opacity < 1 else ""
        self.add(f'<path d="{self.path_of(points, False)}" fill="none" stroke="{stroke}" '
                 f'stroke-width="{width}"{extra}/>')

    def way(self, corners, stroke=GREY, width=1.8, dashes="", radius=12):
        """An arrow along these corners."""
        extra = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.add(f'<path d="{rounded(corners, radius)}" fill="none" stroke="{stroke}" '
                 f'stroke-width="{width}" marker-end="url(#tip{stroke[1:]})"{extra}/>')

    def dot(self, at, color=INK, radius=4.0, fill=None):
        self.add(f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius}" fill="{fill or color}" '
                 f'stroke="{color if fill else "#ffffff"}" stroke-width="{1.8 if fill else 1}"/>')

    def box(self, x, y, width, height, fill=FAINT, stroke=PALE, radius=8, line=1.2):
        self.add(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" '
                 f'rx="{radius}" fill="{fill}" stroke="{stroke}" stroke-width="{line}"/>')

    def text(self, at, words, color=INK, anchor="start", size=15, weight="normal", halo=False,
             family=None):
        extra = ' stroke="#ffffff" stroke-width="4" paint-order="stroke"' if halo else ""
        extra += f' font-family="{family}"' if family else ""
        self.add(f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" fill="{color}" font-size="{size}" '
                 f'font-weight="{weight}" text-anchor="{anchor}"{extra}>{html.escape(words)}</text>')

    def lines(self, at, words, color=INK, anchor="start", size=15, first="bold", halo=False):
        """Lines of text below each other, the first one heavier."""
        for i, line in enumerate(words.split("\n")):
            self.text((at[0], at[1] + i * size * 1.27), line, color if i == 0 else GREY, anchor,
                      size if i == 0 else size - 1, first if i == 0 else "normal", halo)

    def label(self, target, at, words, color=INK, anchor="start", size=15):
        """Words at `at`, and a thin line from the nearest side of them to `target`."""
        rows = words.split("\n")
        width = max(width_of(row, size - (i > 0)) for i, row in enumerate(rows))
        left = at[0] - {"start": 0, "middle": width / 2, "end": width}[anchor]
        last = at[1] + size * 1.27 * (len(rows) - 1)
        beside = min(max(target[1], at[1] - 5), last - 5)
        if target[0] > left + width + 8:
            row = rows[round((beside + 5 - at[1]) / (size * 1.27))]
            near = (left + width_of(row, size) + 6 if anchor == "start" else left + width + 5, beside)
        elif target[0] < left - 8:
            near = (left - 6, beside)
        else:
            near = (min(max(target[0], left + 10), left + width - 10),
                    at[1] - size - 2 if target[1] < at[1] else last + 6)
        self.line([near, target], "#ffffff", 3.5, opacity=0.8)
        self.line([near, target], color, 1.1)
        self.add(f'<circle cx="{target[0]:.1f}" cy="{target[1]:.1f}" r="2.6" fill="{color}"/>')
        self.lines(at, words, color, anchor, size, halo=True)

    def save(self, name):
        (IMAGES / name).write_text("\n".join([*self.parts, "</svg>"]) + "\n")
