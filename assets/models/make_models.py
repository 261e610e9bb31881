#!/usr/bin/python3
"""Makes Kerf's models. Needs Debian's python3 and python3-numpy, nothing else.

    /usr/bin/python3 assets/models/make_models.py [FOLDER [NAME...]]

writes those of MODELS (or those named) into FOLDER (default: the folder of this script) and prints
a line of figures for each. The result is the same, byte for byte, each time: array arithmetic is
limited to + - * / and sqrt, and there is no randomness.

Spheres, orange and cloth are written down directly. The others are described by an implicit
function (negative inside), contoured by marching tetrahedra and remeshed to even triangles on that
surface. Lengths in metres, +y up.
"""

import math
import os
import sys

import numpy as np


# ---------------------------------------------------------------- vectors

def dot(a, b):
    return a[..., 0] * b[..., 0] + a[..., 1] * b[..., 1] + a[..., 2] * b[..., 2]


def cross(a, b):
    return np.stack([a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1],
                     a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2],
                     a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]], axis=-1)


def length(a):
    return np.sqrt(dot(a, a))


def unit(a):
    return a / np.maximum(length(a), 1e-12)[..., None]


# ---------------------------------------------------------------- spheres

def icosahedron():
    g = (1 + math.sqrt(5)) / 2
    points = np.array([(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
                       (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)])
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11),
             (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9),
             (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    return points, faces


def subdivide(points, faces):
    points = list(points)
    middles = {}

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in middles:
            middles[key] = len(points)
            points.append((points[a] + points[b]) / 2)
        return middles[key]

    finer = []
    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.array(points), finer


def on_sphere(points, radius=0.5):
    return radius * unit(np.asarray(points, dtype=float))


def cube_sphere(n):
    """n x n quads on each face of a cube, spaced by equal angles; each quad is split along its
    shorter diagonal, which makes the triangles at the cube's corners nearly equilateral."""
    index, grid, quads = {}, [], []

    def vertex(key):
        if key not in index:
            index[key] = len(grid)
            grid.append(key)
        return index[key]

    for axis in range(3):
        for side in (-n, n):
            for i in range(n):
                for j in range(n):
                    corners = []
                    for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        key = [0, 0, 0]
                        key[axis] = side
                        key[(axis + 1) % 3] = (2 * u - n) * (1 if side > 0 else -1)
                        key[(axis + 2) % 3] = 2 * v - n
                        corners.append(vertex(tuple(key)))
                    quads.append(corners)
    tangents = {k: math.tan(math.pi / 4 * k / n) for k in range(-n, n + 1)}
    points = on_sphere([[tangents[k] for k in key] for key in grid])
    faces = []
    for a, b, c, d in quads:
        if length(points[a] - points[c]) <= length(points[b] - points[d]) + 1e-9:
            faces += [(a, b, c), (a, c, d)]
        else:
            faces += [(a, b, d), (b, c, d)]
    return points, faces


# ---------------------------------------------------------------- contouring

def contour(shape, low, high, step):
    """Marching tetrahedra (six a cube, all along one diagonal): a closed manifold, always.
    The field's zero set must lie inside the box."""
    low, high = np.array(low), np.array(high)
    counts = np.ceil((high - low) / step).astype(int) + 1
    ix, iy, iz = np.meshgrid(*[np.arange(c) for c in counts], indexing="ij")
    nodes = low + step * np.stack([ix, iy, iz], axis=-1).reshape(-1, 3)
    values = np.concatenate([shape(part)[0] for part in np.array_split(nodes, 64)])
    values = np.where(values == 0, 1e-12, values)

    def node(i, j, k):
        return (i * counts[1] + j) * counts[2] + k

    inside = values < 0
    border = (np.stack([ix, iy, iz], -1) % (counts - 1) == 0).any(axis=-1).ravel()
    assert not inside[border].any(), "the shape reaches out of the box"
    i, j, k = (a[:-1, :-1, :-1].ravel() for a in (ix, iy, iz))
    corners = np.stack([node(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)) for c in range(8)], 1)
    crossed = inside[corners].any(axis=1) & ~inside[corners].all(axis=1)
    tetrahedra = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7),
                  (0, 5, 1, 7)]
    points, index, faces = [], {}, []

    def cut(a, b):
        key = (min(a, b), max(a, b))
        if key not in index:
            index[key] = len(points)
            t = values[key[0]] / (values[key[0]] - values[key[1]])
            points.append(nodes[key[0]] + t * (nodes[key[1]] - nodes[key[0]]))
        return index[key]

    for cell in corners[crossed]:
        for tetrahedron in tetrahedra:
            t = [int(cell[c]) for c in tetrahedron]
            inner = [v for v in t if inside[v]]
            outer = [v for v in t if not inside[v]]
            if len(inner) in (1, 3):
                apex, rest = (inner[0], outer) if len(inner) == 1 else (outer[0], inner)
                polygon = [cut(apex, v) for v in rest]
            elif len(inner) == 2:
                (a, b), (c, d) = inner, outer
                polygon = [cut(a, c), cut(a, d), cut(b, d), cut(b, c)]
            else:
                continue
            p = [points[v] for v in polygon]
            outward = sum(nodes[v] for v in outer) / len(outer) - sum(
                nodes[v] for v in inner) / len(inner)
            if float(dot(cross(p[1] - p[0], p[2] - p[0]), outward)) < 0:
                polygon.reverse()
            for corner in range(1, len(polygon) - 1):
                faces.append((polygon[0], polygon[corner], polygon[corner + 1]))
    return np.array(points), faces


# ---------------------------------------------------------------- remeshing

class Remesher:
    """Isotropic remeshing (Botsch and Kobbelt 2004): split long edges, collapse short ones, flip
    towards six neighbours, relax in the tangent plane, project back on the shape."""

    def __init__(self, points, faces, shape, edge):
        self.points = [tuple(map(float, p)) for p in points]
        self.faces = [tuple(f) for f in faces]
        self.shape = shape
        self.edge = edge
        self.around = [set() for _ in self.points]
        for number, face in enumerate(self.faces):
            for v in face:
                self.around[v].add(number)

    # -- queries
    def neighbours(self, v):
        return {u for f in self.around[v] for u in self.faces[f]} - {v}

    def edges(self):
        found = []
        for face in self.faces:
            if face is not None:
                a, b, c = face
                found += [(u, v) for u, v in ((a, b), (b, c), (c, a)) if u < v]
        return sorted(found)

    def distance(self, a, b):
        p, q = self.points[a], self.points[b]
        return math.sqrt((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 + (p[2] - q[2]) ** 2)

    def opposite(self, a, b):
        """The two triangles at an edge, each with its third corner; a -> b runs in the first."""
        first, second = sorted(self.around[a] & self.around[b])
        face = self.faces[first]
        if face[(face.index(a) + 1) % 3] != b:
            first, second = second, first
        third = [next(v for v in self.faces[f] if v not in (a, b)) for f in (first, second)]
        return first, third[0], second, third[1]

    def normal(self, a, b, c):
        p, q, r = self.points[a], self.points[b], self.points[c]
        u = (q[0] - p[0], q[1] - p[1], q[2] - p[2])
        w = (r[0] - p[0], r[1] - p[1], r[2] - p[2])
        return (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])

    @staticmethod
    def agree(n, m, least):
        d = n[0] * m[0] + n[1] * m[1] + n[2] * m[2]
        sizes = (n[0] ** 2 + n[1] ** 2 + n[2] ** 2) * (m[0] ** 2 + m[1] ** 2 + m[2] ** 2)
        return d > least * math.sqrt(sizes)

    # -- edits
    def set_face(self, number, face):
        for v in self.faces[number] or ():
            self.around[v].discard(number)
        self.faces[number] = face
        for v in face or ():
            self.around[v].add(number)

    def add_face(self, face):
        self.faces.append(None)
        self.set_face(len(self.faces) - 1, face)

    def split_long(self):
        limit = 4 / 3 * self.edge
        for a, b in self.edges():
            if self.distance(a, b) <= limit:
                continue
            first, c, second, d = self.opposite(a, b)
            m = len(self.points)
            p, q = self.points[a], self.points[b]
            self.points.append(tuple((p[i] + q[i]) / 2 for i in range(3)))
            self.around.append(set())
            self.set_face(first, (a, m, c))
            self.set_face(second, (m, a, d))
            self.add_face((m, b, c))
            self.add_face((b, m, d))

    def collapse_short(self):
        short, long = 4 / 5 * self.edge, 4 / 3 * self.edge
        gone = set()
        for a, b in self.edges():
            if a in gone or b in gone or not self.around[a] & self.around[b]:
                continue
            if self.distance(a, b) < short and self.may_collapse(a, b, long):
                self.collapse(a, b)
                gone.add(b)

    def may_collapse(self, a, b, long):
        shared = self.neighbours(a) & self.neighbours(b)
        if len(shared) != 2 or any(len(self.around[v]) <= 4 for v in shared):
            return False
        p, q = self.points[a], self.points[b]
        middle = tuple((p[i] + q[i]) / 2 for i in range(3))
        both = self.around[a] & self.around[b]
        ring = [f for f in sorted((self.around[a] | self.around[b]) - both)]
        before = [self.normal(*self.faces[f]) for f in ring]
        self.points[a] = self.points[b] = middle
        fine = all(self.distance(a, v) <= long
                   for v in (self.neighbours(a) | self.neighbours(b)) - {a, b})
        fine = fine and all(self.agree(n, self.normal(*self.faces[f]), 0.7)
                            for n, f in zip(before, ring))
        self.points[a], self.points[b] = p, q
        return fine

    def collapse(self, a, b):
        p, q = self.points[a], self.points[b]
        self.points[a] = tuple((p[i] + q[i]) / 2 for i in range(3))
        for f in self.around[a] & self.around[b]:
            self.set_face(f, None)
        for f in sorted(self.around[b]):
            self.set_face(f, tuple(a if v == b else v for v in self.faces[f]))

    def flip_edges(self, worth_it):
        for a, b in self.edges():
            if len(self.around[a] & self.around[b]) != 2:
                continue
            first, c, second, d = self.opposite(a, b)
            if self.around[c] & self.around[d] or not worth_it(a, b, c, d):
                continue
            old, new = self.normal(a, b, c), self.normal(a, d, c)
            other, newer = self.normal(b, a, d), self.normal(d, b, c)
            if self.agree(new, newer, 0.7) and self.agree(old, new, 0.7) and self.agree(
                    other, newer, 0.7):
                self.set_face(first, (a, d, c))
                self.set_face(second, (d, b, c))

    def evens_valence(self, a, b, c, d):
        va, vb, vc, vd = (len(self.around[v]) for v in (a, b, c, d))
        now = abs(va - 6) + abs(vb - 6) + abs(vc - 6) + abs(vd - 6)
        then = abs(va - 7) + abs(vb - 7) + abs(vc - 5) + abs(vd - 5)
        return then < now and min(va, vb) > 4

    def is_not_delaunay(self, a, b, c, d):
        def cotangent(apex):
            p, q, r = (self.points[v] for v in (apex, a, b))
            u = (q[0] - p[0], q[1] - p[1], q[2] - p[2])
            w = (r[0] - p[0], r[1] - p[1], r[2] - p[2])
            x, y, z = self.normal(apex, a, b)
            return (u[0] * w[0] + u[1] * w[1] + u[2] * w[2]) / max(
                math.sqrt(x * x + y * y + z * z), 1e-12)
        return cotangent(c) + cotangent(d) < -1e-6 and min(
            len(self.around[a]), len(self.around[b])) > 4

    def compact(self):
        faces = [f for f in self.faces if f is not None]
        order = {}
        for face in faces:
            for v in face:
                order.setdefault(v, len(order))
        self.points = [self.points[v] for v in order]
        self.faces = []
        self.around = [set() for _ in self.points]
        for face in faces:
            self.add_face(tuple(order[v] for v in face))

    # -- motion
    def relax(self, rounds):
        self.compact()
        faces = np.array(self.faces)
        points = np.array(self.points)
        for _ in range(rounds):
            points = project(self.shape, self.relaxed(points, faces), steps=2)
        self.points = [tuple(map(float, p)) for p in project(self.shape, points, steps=2)]

    @staticmethod
    def relaxed(points, faces):
        """Each vertex moves to the area-weighted mean of its triangles' centres, less what that
        moves it along its normal."""
        a, b, c = (points[faces[:, i]] for i in range(3))
        normals = cross(b - a, c - a)
        areas = length(normals)
        centres = (a + b + c) / 3
        weight, mean, normal = np.zeros(len(points)), np.zeros_like(points), np.zeros_like(points)
        for corner in range(3):
            np.add.at(weight, faces[:, corner], areas)
            np.add.at(mean, faces[:, corner], centres * areas[:, None])
            np.add.at(normal, faces[:, corner], normals)
        move = mean / weight[:, None] - points
        normal = unit(normal)
        return points + 0.8 * (move - normal * dot(move, normal)[:, None])

    def run(self, rounds=8):
        for _ in range(rounds):
            self.split_long()
            self.collapse_short()
            self.flip_edges(self.evens_valence)
            self.relax(3)
        for _ in range(4):
            self.flip_edges(self.is_not_delaunay)
            self.relax(6)
        return np.array(self.points), self.faces


def project(shape, points, steps=4):
    for _ in range(steps):
        value, gradient = shape(points)
        points = points - gradient * (value / np.maximum(dot(gradient, gradient), 1e-6))[:, None]
    return points


def smooth_union(a, b, k):
    """Quadratic smooth minimum of two (value, gradient) pairs; k: width of the fillet [m]."""
    (fa, ga), (fb, gb) = a, b
    h = np.maximum(k - np.abs(fa - fb), 0) / k
    mix = np.where(fa < fb, h / 2, 1 - h / 2)
    return np.minimum(fa, fb) - h * h * k / 4, ga + (gb - ga) * mix[:, None]


class Chain:
    """The nearest point on a polyline of centres, for many points at once."""

    def __init__(self, centres, radii):
        self.start = np.array(centres[:-1])
        self.along = np.array(centres[1:]) - self.start
        self.squared = dot(self.along, self.along)
        self.radii = np.array(radii)

    def nearest(self, points):
        """Segment, place in it (0 to 1), vector from there, distance."""
        best = np.full(len(points), np.inf)
        which = np.zeros(len(points), dtype=int)
        place = np.zeros(len(points))
        for i in range(len(self.start)):
            away = points - self.start[i]
            t = np.minimum(np.maximum(dot(away, self.along[i]) / self.squared[i], 0), 1)
            away = away - t[:, None] * self.along[i]
            squared = dot(away, away)
            closer = squared < best
            best = np.where(closer, squared, best)
            which = np.where(closer, i, which)
            place = np.where(closer, t, place)
        away = points - self.start[which] - place[:, None] * self.along[which]
        return which, place, away, np.sqrt(best)

    def tube(self, points):
        """(value, gradient) of the round tube along the chain."""
        which, place, away, distance = self.nearest(points)
        radius = self.radii[which] + place * (self.radii[which + 1] - self.radii[which])
        return distance - radius, away / np.maximum(distance, 1e-9)[:, None]


def eased(table, s):
    """Interpolates (place, value) pairs, level at each of them."""
    for (s0, v0), (s1, v1) in zip(table, table[1:]):
        if s <= s1:
            t = (s - s0) / (s1 - s0)
            return v0 + (v1 - v0) * t * t * (3 - 2 * t)
    return table[-1][1]


def catmull_rom(table, s):
    """Interpolates (place, value) pairs with continuous slope."""
    last = len(table) - 1
    i = next((n for n in range(last) if s <= table[n + 1][0]), last - 1)

    def slope(n):
        low, high = max(n - 1, 0), min(n + 1, last)
        return (table[high][1] - table[low][1]) / (table[high][0] - table[low][0])

    (s0, v0), (s1, v1) = table[i], table[i + 1]
    w = s1 - s0
    t = (s - s0) / w
    return ((1 + 2 * t) * (1 - t) ** 2 * v0 + t * (1 - t) ** 2 * w * slope(i)
            + t * t * (3 - 2 * t) * v1 + t * t * (t - 1) * w * slope(i + 1))


# ---------------------------------------------------------------- banana

# Radius along the fruit [m], from the stem's end (0) to the blossom's (1).
BANANA_RADIUS = [(0.0, 0.034), (0.02, 0.031), (0.07, 0.026), (0.13, 0.029), (0.19, 0.055),
                 (0.27, 0.088), (0.40, 0.112), (0.55, 0.118), (0.70, 0.108), (0.82, 0.085),
                 (0.90, 0.059), (0.95, 0.036), (0.98, 0.026), (1.0, 0.024)]
# Curvature along the fruit [1/m]: strongest in the shoulder; the blossom's end straightens.
BANANA_CURVATURE = [(0.0, 0.3), (0.12, 1.4), (0.3, 1.7), (0.6, 1.4), (0.85, 1.0), (1.0, 0.3)]
# How much of the five ridges shows.
BANANA_RIDGE = [(0.0, 0.0), (0.08, 0.03), (0.2, 0.055), (0.5, 0.05), (0.85, 0.06), (0.97, 0.0)]
BANANA_LENGTH = 1.10
BANANA_EDGE = 0.0145


class Banana:
    SEGMENTS = 160

    def __init__(self):
        chord = self.centre_line(0.0)[0][-1]
        centres, headings = self.centre_line(-math.atan2(chord[1], chord[0]))
        places = [i / self.SEGMENTS for i in range(self.SEGMENTS + 1)]
        self.chain = Chain(centres, [catmull_rom(BANANA_RADIUS, s) for s in places])
        self.inward = np.array([(-math.sin(h), math.cos(h), 0.0) for h in headings])
        self.ridges = np.array([eased(BANANA_RIDGE, s) for s in places])

    def centre_line(self, heading):
        """Points and headings of the centre line; it starts with the given heading [radians]."""
        x, y, centres, headings = 0.0, 0.0, [], []
        step = BANANA_LENGTH / self.SEGMENTS
        for i in range(self.SEGMENTS + 1):
            centres.append((x, y, 0.0))
            headings.append(heading)
            heading += step * catmull_rom(BANANA_CURVATURE, i / self.SEGMENTS)
            x, y = x + step * math.cos(heading), y + step * math.sin(heading)
        return centres, headings

    def __call__(self, points):
        which, place, away, distance = self.chain.nearest(points)
        radius = self.between(self.chain.radii, which, place)
        ridge = self.between(self.ridges, which, place)
        up = away / np.maximum(distance, 1e-9)[:, None]
        c = dot(up, self.inward[which])
        five = ((16 * c * c - 20) * c * c + 5) * c  # cosine of five times the angle
        profile = -five - 0.3 * (2 * five * five - 1)  # crests narrower than the hollows
        return distance - radius * (1 + ridge * profile), up

    @staticmethod
    def between(values, which, place):
        return values[which] + place * (values[which + 1] - values[which])


def banana():
    shape = Banana()
    centres = shape.chain.start
    points, faces = contour(shape, centres.min(axis=0) - 0.16, centres.max(axis=0) + 0.16, 0.02)
    return Remesher(project(shape, points), faces, shape, BANANA_EDGE).run()


# ---------------------------------------------------------------- octopus

# Each arm: direction [degrees from +z towards +x], length [m], and how far its tip turns upwards
# and sideways [degrees].
OCTOPUS_ARMS = [(24, 0.72, 285, 25), (68, 0.70, 50, 205), (112, 0.76, 255, -35),
                (157, 0.70, 60, 195), (203, 0.72, 290, 20), (248, 0.74, 45, -215),
                (292, 0.70, 265, 30), (336, 0.72, 60, -200)]
ARM_RADIUS = [(0.0, 0.072), (0.22, 0.062), (0.5, 0.049), (0.8, 0.034), (1.0, 0.025)]
ARM_PITCH = [(0.0, -42), (0.12, -36), (0.36, 0), (0.5, 4), (1.0, 4)]  # degrees along the arm
ARM_CURL_START = 0.42
NECK = [((0.0, 0.17, 0.0), 0.118), ((0.0, 0.36, 0.0), 0.118)]  # centres [m], radii [m]
MANTLE_CENTRE, MANTLE_RADII, MANTLE_TILT = (0.0, 0.485, -0.055), (0.170, 0.215, 0.178), 24
EYES = [((-0.100, 0.330, 0.085), 0.048), ((0.100, 0.330, 0.085), 0.048)]
OCTOPUS_EDGE = 0.0195


class Octopus:
    ARM_SEGMENTS = 48

    def __init__(self):
        self.arms = [self.arm(*entry) for entry in OCTOPUS_ARMS]
        self.neck = Chain([centre for centre, _ in NECK], [radius for _, radius in NECK])

    def arm(self, direction, size, upwards, sideways):
        around = math.radians(direction)
        x, y, z = 0.06 * math.sin(around), 0.19, 0.06 * math.cos(around)
        centres, radii = [], []
        for i in range(self.ARM_SEGMENTS + 1):
            s = i / self.ARM_SEGMENTS
            centres.append((x, y, z))
            radii.append(catmull_rom(ARM_RADIUS, s))
            curl = (max(s - ARM_CURL_START, 0) / (1 - ARM_CURL_START)) ** 1.7
            pitch = math.radians(catmull_rom(ARM_PITCH, s) + upwards * curl)
            heading = around + math.radians(sideways * curl)
            step = size / self.ARM_SEGMENTS
            x += step * math.cos(pitch) * math.sin(heading)
            y += step * math.sin(pitch)
            z += step * math.cos(pitch) * math.cos(heading)
        return Chain(centres, radii)

    @staticmethod
    def mantle(points):
        """An ellipsoid that leans back; its value is a distance to first order."""
        c, s = math.cos(math.radians(MANTLE_TILT)), math.sin(math.radians(MANTLE_TILT))
        x, y, z = (points - np.array(MANTLE_CENTRE)).T
        scaled = np.stack([x, c * y - s * z, s * y + c * z], axis=-1) / np.array(MANTLE_RADII)
        slope = scaled / np.array(MANTLE_RADII)
        size, steepness = length(scaled), np.maximum(length(slope), 1e-9)
        gx, gy, gz = (slope / steepness[:, None]).T
        return size * (size - 1) / steepness, np.stack([gx, c * gy + s * gz, c * gz - s * gy], -1)

    def __call__(self, points):
        value = smooth_union(self.neck.tube(points), self.mantle(points), 0.12)
        for arm in self.arms:
            value = smooth_union(value, arm.tube(points), 0.05)
        for centre, radius in EYES:
            away = points - np.array(centre)
            distance = length(away)
            eye = distance - radius, away / np.maximum(distance, 1e-9)[:, None]
            value = smooth_union(value, eye, 0.035)
        return value


def octopus():
    shape = Octopus()
    points, faces = contour(shape, (-0.60, -0.06, -0.60), (0.60, 0.74, 0.60), 0.019)
    return Remesher(project(shape, points), faces, shape, OCTOPUS_EDGE).run()


# ---------------------------------------------------------------- scenes of the start page

ORANGE_RADIUS = 0.04
ORANGE_PARTS = 11


def geodesic(parts):
    """A ball of radius 1: an icosahedron with `parts` edges along each of its own."""
    corners, faces = icosahedron()
    index, points, finer = {}, [], []

    def vertex(*shares):
        key = tuple(sorted((corner, share) for corner, share in shares if share > 0))
        if key not in index:
            index[key] = len(points)
            points.append(sum(share * corners[corner] for corner, share in key))
        return index[key]

    for a, b, c in faces:
        def at(i, j):
            return vertex((a, parts - i - j), (b, i), (c, j))
        for i in range(parts):
            for j in range(parts - i):
                finer.append((at(i, j), at(i + 1, j), at(i, j + 1)))
                if i + j < parts - 1:
                    finer.append((at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))
    return on_sphere(points, 1.0), finer


def orange():
    """A ball, a little flattened, with a dimple where the stalk was."""
    points, faces = geodesic(ORANGE_PARTS)
    x, y, z = points.T
    away = np.minimum((x * x + z * z) / 0.07, 1)
    dimple = np.where(y > 0, 0.09, 0.03) * (1 - away) ** 2
    return ORANGE_RADIUS * np.stack([x, y * (0.94 - dimple), z], axis=-1), faces


def ellipsoid(points, centre, radii):
    """(value, gradient); the value is a distance to first order."""
    scaled = (points - np.array(centre)) / np.array(radii)
    slope = scaled / np.array(radii)
    size, steepness = length(scaled), np.maximum(length(slope), 1e-9)
    return size * (size - 1) / steepness, slope / steepness[:, None]


def remeshed(shape, low, high, step, edge):
    points, faces = contour(shape, low, high, step)
    return Remesher(project(shape, points), faces, shape, edge).run()


# Centres and radii [m] of the right, the middle and the left lobe, which lie on a table.
LIVER_LOBES = [((-0.040, 0.0, 0.004), (0.075, 0.036, 0.066)),
               ((0.018, 0.0, -0.010), (0.066, 0.031, 0.050)),
               ((0.075, -0.004, -0.016), (0.056, 0.020, 0.036))]
LIVER_NOTCH = ((0.034, -0.012, 0.054), (0.006, 0.040, 0.030))


def liver_shape(points):
    value = ellipsoid(points, *LIVER_LOBES[0])
    for lobe in LIVER_LOBES[1:]:
        value = smooth_union(value, ellipsoid(points, *lobe), 0.03)
    f, g = value
    up = np.tile(np.array([0.0, 1.0, 0.0]), (len(points), 1))
    # Without what lies below the table, and without the notch: the union of what is outside.
    outside = smooth_union((-f, -g), (points[:, 1] + 0.018, up), 0.016)
    outside = smooth_union(outside, ellipsoid(points, *LIVER_NOTCH), 0.014)
    return -outside[0], -outside[1]


def liver():
    return remeshed(liver_shape, (-0.13, -0.04, -0.09), (0.15, 0.05, 0.09), 0.005, 0.0056)


JELLY_HALF, JELLY_ROUND, JELLY_EDGE = 0.035, 0.009, 0.0041


def rounded_box(half, rounding):
    """A box with rounded edges, of this half size [m]."""
    def shape(points):
        out = np.abs(points) - (half - rounding)
        most = out.max(axis=1)
        beyond = np.maximum(out, 0)
        flat = np.where(out == most[:, None], 1.0, 0.0)
        direction = np.where((most > 0)[:, None], unit(beyond), flat)
        value = np.where(most > 0, length(beyond), most) - rounding
        return value, direction * np.where(points < 0, -1.0, 1.0)
    return shape


def jelly():
    reach = 1.3 * JELLY_HALF
    return remeshed(rounded_box(JELLY_HALF, JELLY_ROUND), [-reach] * 3, [reach] * 3, JELLY_EDGE,
                    JELLY_EDGE)


SLAB_HALF, SLAB_ROUND, SLAB_EDGE = np.array([0.08, 0.006, 0.06]), 0.005, 0.005


def slab():
    reach = SLAB_HALF + 2 * SLAB_EDGE
    return remeshed(rounded_box(SLAB_HALF, SLAB_ROUND), -reach, reach, SLAB_EDGE, SLAB_EDGE)


# Pads to practise on [m], with a cavity for what lies in them, which has a little air about it.
PAD_HALF, PAD_ROUND, PAD_EDGE = np.array([0.06, 0.01, 0.04]), 0.007, 0.0045
VESSEL_RADIUS, VESSEL_HALF, VESSEL_EDGE = 0.0029, 0.027, 0.0022
LUMP_RADIUS = 0.0049
AIR = 0.03  # about these, as a share


def capsule(radius, half):
    """About the z axis."""
    def shape(points):
        off = points.copy()
        off[:, 2] = np.sign(points[:, 2]) * np.maximum(np.abs(points[:, 2]) - half, 0)
        return length(off) - radius, unit(off)
    return shape


def pad(inside, offset):
    """The pad, and a second surface about what lies inside, which faces the hollow."""
    reach = PAD_HALF + 1.63 * PAD_EDGE  # so that no node of the grid lies on the surface
    points, faces = remeshed(rounded_box(PAD_HALF, PAD_ROUND), -reach, reach, PAD_EDGE, PAD_EDGE)
    inner, around = inside
    faces += [tuple(len(points) + v for v in face[::-1]) for face in around]
    return np.concatenate([points, (1 + AIR) * inner + np.array(offset)]), faces


def vessel():
    return remeshed(capsule(VESSEL_RADIUS, VESSEL_HALF), (-0.008, -0.008, -0.036),
                    (0.008, 0.008, 0.036), 0.0018, VESSEL_EDGE)


def pad_vessel():
    points, faces = vessel()
    return pad((centred(points), faces), (0.010, -0.002, 0))


def pad_lump():
    points, faces = make("sphere80")
    return pad((LUMP_RADIUS / 0.5 * points, faces), (0, 0, 0))


EGG_HEIGHT, EGG_RADIUS, EGG_WALL, EGG_EDGE = 0.044, 0.033, 0.006, 0.0036


def egg_shape(inset):
    """The surface of an egg that lies this much within its shell [m]."""
    tall, wide = EGG_HEIGHT - inset, EGG_RADIUS - inset

    def shape(points):
        x, y, z = points.T
        lean = 1 - 0.16 * y / tall
        round_ = x * x + z * z
        f = round_ / (wide * lean) ** 2 + (y / tall) ** 2 - 1
        across = 2 / (wide * lean) ** 2
        along = 2 * y / tall ** 2 + across * round_ * 0.16 / (tall * lean)
        g = np.stack([x * across, along, z * across], axis=-1)
        steep = np.maximum(length(g), 1 / tall)
        return f / steep, g / steep[:, None]

    return shape


def egg():
    """Hollow: a second surface inside, which faces the hollow."""
    points, faces = [], []
    for inset in (0, EGG_WALL):
        more, around = remeshed(egg_shape(inset), (-0.05,) * 3, (0.05,) * 3, EGG_EDGE, EGG_EDGE)
        faces += [tuple(len(points) + v for v in (face if inset == 0 else face[::-1]))
                  for face in around]
        points += list(more)
    return np.array(points), faces


CLOTH_SIDE, CLOTH_THICKNESS, CLOTH_CELLS = 0.30, 0.005, 32


def cloth():
    """A square sheet with a thickness, of rows of triangles that are nearly equilateral."""
    rows = CLOTH_CELLS + 4  # lower than wide
    grid, quads, rim = [], [], []
    for r in range(rows + 1):
        shift = 0.5 if r % 2 else 0.0
        row = [0.0] + [c + shift for c in range(1 - r % 2, CLOTH_CELLS)] + [float(CLOTH_CELLS)]
        row = sorted(set(row))
        grid.append([(c / CLOTH_CELLS - 0.5, r / rows - 0.5) for c in row])
    first = [sum(len(row) for row in grid[:r]) for r in range(rows + 2)]
    count = first[-1]
    for r in range(rows):
        a, b = 0, 0  # along this row and the next
        while a < len(grid[r]) - 1 or b < len(grid[r + 1]) - 1:
            ahead = a < len(grid[r]) - 1 and (
                b == len(grid[r + 1]) - 1 or grid[r][a + 1][0] <= grid[r + 1][b + 1][0])
            third = first[r] + a + 1 if ahead else first[r + 1] + b + 1
            quads.append((first[r] + a, first[r + 1] + b, third))
            a, b = (a + 1, b) if ahead else (a, b + 1)
    last = [first[r] + len(grid[r]) - 1 for r in range(rows + 1)]
    rim = (list(range(first[0], last[0])) + last[:-1] + list(range(last[rows], first[rows], -1))
           + first[rows:0:-1])
    flat = [p for row in grid for p in row]
    points = [(CLOTH_SIDE * u, y * CLOTH_THICKNESS / 2, CLOTH_SIDE * w) for y in (1, -1)
              for u, w in flat]
    faces = quads + [(b + count, a + count, c + count) for a, b, c in quads]
    for a, b in zip(rim, rim[1:] + rim[:1]):
        faces += [(a, b, b + count), (a, b + count, a + count)]
    return np.array(points), faces


# ---------------------------------------------------------------- output

def centred(points):
    return points - (points.min(axis=0) + points.max(axis=0)) / 2


def figures(points, faces):
    """Counts, Euler characteristic, volume [m^3], edge lengths [m] and the worst ratio of height
    to longest edge; the last is 0.866 for an equilateral triangle."""
    faces = np.array(faces)
    a, b, c = (points[faces[:, i]] for i in range(3))
    sides = np.stack([length(b - a), length(c - b), length(a - c)], axis=1)
    longest = sides.max(axis=1)
    height = length(cross(b - a, c - a)) / longest
    euler = len(points) - len(faces) // 2
    volume = float(dot(a, cross(b, c)).sum()) / 6
    return (f"{len(points)} vertices, {len(faces)} triangles, Euler characteristic {euler}, "
            f"volume {volume:.4f}, edges {sides.min():.4f} / {sides.mean():.4f} / "
            f"{sides.max():.4f}, worst height ratio {(height / longest).min():.3f}")


def write_obj(path, title, points, faces):
    lines = [f"# {title}, made for Kerf by make_models.py", f"o {title}"]
    lines += ["v " + " ".join(f"{x + 0.0:.5f}".replace("-0.00000", "0.00000") for x in p)
              for p in points]
    lines += ["f %d %d %d" % (a + 1, b + 1, c + 1) for a, b, c in faces]
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write("\n".join(lines) + "\n")


def make(name):
    if name == "sphere20":
        points, faces = icosahedron()
        return on_sphere(points), faces
    if name == "sphere80":
        points, faces = subdivide(*icosahedron())
        return on_sphere(points), faces
    if name == "sphere768":
        return cube_sphere(8)
    points, faces = SHAPES[name]()
    return centred(points), faces


SHAPES = {"banana": banana, "octopus": octopus, "orange": orange, "liver": liver, "jelly": jelly,
          "slab": slab, "vessel": vessel, "pad-vessel": pad_vessel, "pad-lump": pad_lump,
          "egg": egg, "cloth": cloth}
MODELS = ["sphere20", "sphere80", "sphere768", *SHAPES]


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
    for name in sys.argv[2:] or MODELS:
        points, faces = make(name)
        write_obj(os.path.join(folder, name + ".obj"), name, points, faces)
        print(f"{name}: {figures(points, faces)}")


if __name__ == "__main__":
    main()
