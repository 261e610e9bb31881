"""Bodies of triangles that experiments make, as models of a simulation."""

import pathlib
import tempfile

import kerf
import numpy as np

from .workshop import write


def box(size, cells):
    """Points and triangles of a box around the origin, each side divided into squares."""
    triangles = []
    for axis in range(3):
        for upper in (False, True):
            u, v = (axis + 1) % 3, (axis + 2) % 3

            def at(i, j):
                corner = [0, 0, 0]
                corner[axis], corner[u], corner[v] = cells[axis] if upper else 0, i, j
                return tuple(corner)

            for i in range(cells[u]):
                for j in range(cells[v]):
                    a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
                    halves = [(a, b, c), (a, c, d)] if (i + j) % 2 == 0 else [(a, b, d), (b, c, d)]
                    triangles += halves if upper else [(p, r, q) for p, q, r in halves]
    grid, triangles = numbered(triangles)
    return np.array(size) * (np.array(grid) / cells - 0.5), triangles


def ring(inner, outer, thickness, cells):
    """Points and triangles of a flat ring around z: cells across, around and through it."""
    points, triangles = box([1, 1, 1], cells)
    grid = np.rint((points + 0.5) * cells).astype(int)
    around = grid[triangles][:, :, 1]
    is_end = (around == around[:, :1]).all(axis=1) & np.isin(around[:, 0], (0, cells[1]))
    grid[:, 1] %= cells[1]
    grid, triangles = numbered([[tuple(grid[v]) for v in t] for t in triangles[~is_end]])
    radius, angle, height = (np.array(grid) / cells).T
    radius = inner + (outer - inner) * radius
    return np.stack([radius * np.cos(2 * np.pi * angle), radius * np.sin(2 * np.pi * angle),
                     thickness * (height - 0.5)], axis=1), triangles


def numbered(triangles):
    """The different corners of triangles by their first use, and the triangles by their numbers."""
    numbers = {}
    by_number = [[numbers.setdefault(corner, len(numbers)) for corner in t] for t in triangles]
    return list(numbers), np.array(by_number)


def corners(points, triangles):
    """The three corners of all triangles."""
    return (points[triangles[:, i]] for i in range(3))


def areas(points, triangles):
    a, b, c = corners(points, triangles)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def volume(points, triangles):
    a, b, c = corners(points, triangles)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def write_ply(file, points, triangles):
    write(file, "\n".join([
        "ply", "format ascii 1.0", f"element vertex {len(points)}",
        *(f"property double {axis}" for axis in "xyz"), f"element face {len(triangles)}",
        "property list uchar int vertex_indices", "end_header",
        *(" ".join(map(repr, map(float, p))) for p in points),
        *("3 " + " ".join(map(str, t)) for t in triangles), ""]))


def simulate(points, triangles, **options):
    """A simulation of that body, without undo."""
    with tempfile.TemporaryDirectory(prefix="kerf-lab-") as folder:
        file = pathlib.Path(folder, "body.ply")
        write_ply(file, points, triangles)
        return kerf.Simulation({"path": file}, undo_memory=0, **options)
