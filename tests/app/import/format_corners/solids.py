"""The shapes that files hold, and the table of what is right about them."""

import struct
import zlib


class Solid:
    """Closed pieces of polygons."""

    def __init__(self, points, faces, pieces=1):
        self.points = [tuple(float(x) for x in p) for p in points]
        self.faces = [list(face) for face in faces]
        self.pieces = pieces

    def triangles(self):
        """Fans, which have the right volume for polygons that are not convex, too."""
        return [(f[0], f[i], f[i + 1]) for f in self.faces for i in range(1, len(f) - 1)]

    def mapped(self, place):
        """It faces outward wherever it did, also where `place` mirrors."""
        points = [place(*p) for p in self.points]
        ahead = Solid(points, self.faces, self.pieces)
        return ahead.turned() if self.signed_volume() * ahead.signed_volume() < 0 else ahead

    def moved(self, x, y=0, z=0):
        return self.mapped(lambda a, b, c: (a + x, b + y, c + z))

    def scaled(self, x, y=None, z=None):
        y, z = x if y is None else y, x if z is None else z
        return self.mapped(lambda a, b, c: (a * x, b * y, c * z))

    def turned(self):
        return Solid(self.points, [face[::-1] for face in self.faces], self.pieces)

    def with_(self, other):
        shift = len(self.points)
        faces = self.faces + [[v + shift for v in face] for face in other.faces]
        return Solid(self.points + other.points, faces, self.pieces + other.pieces)

    def in_triangles(self):
        return Solid(self.points, self.triangles(), self.pieces)

    def signed_volume(self):
        total = 0.0
        for a, b, c in self.triangles():
            p, q, r = self.points[a], self.points[b], self.points[c]
            total += p[0] * (q[1] * r[2] - q[2] * r[1])
            total += p[1] * (q[2] * r[0] - q[0] * r[2])
            total += p[2] * (q[0] * r[1] - q[1] * r[0])
        return total / 6

    def facts(self):
        used = {v for face in self.faces for v in face}
        columns = list(zip(*(self.points[v] for v in used)))
        return {
            "volume": abs(self.signed_volume()),
            "triangles": len(self.triangles()),
            "pieces": self.pieces,
            "low": [min(c) for c in columns],
            "high": [max(c) for c in columns],
        }


BOX = Solid(
    [(x, y, z) for z in (0, 3) for y in (0, 2) for x in (0, 1)],
    [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)],
)
TETRAHEDRON = Solid(
    [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
)
TWO = BOX.with_(BOX.moved(5))
TOUCHING = BOX.with_(BOX.moved(1))


def prism(outline, height=1):
    count = len(outline)
    points = [(x, y, z) for z in (0, height) for x, y in outline]
    sides = [(i, (i + 1) % count, count + (i + 1) % count, count + i) for i in range(count)]
    return Solid(points, [tuple(range(count - 1, -1, -1)), tuple(range(count, 2 * count)), *sides])


CONCAVE = prism([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
# The notch is seen from no corner that a fan could begin at.
STAR = prism([(0, 0), (3, 1), (6, 0), (5, 3), (6, 6), (3, 5), (0, 6), (1, 3)])
STRAIGHT = prism([(0, 0), (1, 0), (2, 0), (2, 2), (0, 2)])


def text(number):
    return repr(float(number)) if number != int(number) else str(int(number))


def row(numbers):
    return " ".join(text(n) for n in numbers)


def linear(share):
    """From what displays take to linear light."""
    return share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4


def png(red, green, blue):
    """A picture of 2 x 2 of one colour."""

    def chunk(kind, data):
        end = struct.pack(">I", zlib.crc32(kind + data))
        return struct.pack(">I", len(data)) + kind + data + end

    rows = (b"\0" + bytes((red, green, blue)) * 2) * 2
    head = struct.pack(">IIBBBBB", 2, 2, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(
        b"IEND", b""
    )


class Table:
    def __init__(self, folder):
        self.folder = folder
        self.rows = []

    def beside(self, name, content):
        """Writes a file that models name."""
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode() if isinstance(content, str) else content)

    def read(self, name, content, solid=BOX, **facts):
        self.beside(name, content)
        self.rows.append({"file": name, **solid.facts(), **facts})

    def refused(self, name, content, *words):
        self.beside(name, content)
        self.rows.append({"file": name, "refused": list(words)})

    def of(self, folder, ending):
        """read() and refused() for files in a folder, by their names without the ending."""
        def read(name, content, solid=BOX, **facts):
            self.read(f"{folder}/{name}.{ending}", content, solid, **facts)

        def refused(name, content, *words):
            self.refused(f"{folder}/{name}.{ending}", content, *words)

        return read, refused
