"""The box of solids.py in cells, as corners in VTK's order. Its points are numbered x first."""

import itertools

from solids import BOX

HEXAHEDRON = [0, 1, 3, 2, 4, 5, 7, 6]
POINTS = BOX.points + [(0.5, 1.0, 1.5)]  # the last is the middle
# A tetrahedron for each way along the edges from one corner to the one across.
TETRAHEDRA = [[0, a, a + b, 7] for a, b in itertools.permutations((1, 2, 4), 2)]
WEDGES = [[0, 1, 3, 4, 5, 7], [0, 3, 2, 4, 7, 6]]
PYRAMIDS = [[*face, 8] for face in BOX.faces]


def grid(count):
    """The box in count**3 hexahedra: points and cells."""
    steps = range(count + 1)
    points = [(x / count, 2 * y / count, 3 * z / count) for z in steps for y in steps for x in steps]
    number = lambda x, y, z: x + (count + 1) * (y + (count + 1) * z)
    cells = [
        [number(x + a, y + b, z + c) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
        for z in range(count) for y in range(count) for x in range(count)
    ]  # fmt: skip
    return points, cells


def curved(cells, points, edges):
    """With a node in the middle of each edge: points and cells."""
    points, numbers, out = list(points), {}, []
    for cell in cells:
        nodes = list(cell)
        for a, b in edges:
            key = tuple(sorted((cell[a], cell[b])))
            if key not in numbers:
                numbers[key] = len(points)
                points.append(tuple((p + q) / 2 for p, q in zip(points[key[0]], points[key[1]])))
            nodes.append(numbers[key])
        out.append(nodes)
    return points, out


TETRAHEDRON_EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
HEXAHEDRON_EDGES = [(i, (i + 1) % 4) for i in range(4)]
HEXAHEDRON_EDGES += [(i + 4, (i + 1) % 4 + 4) for i in range(4)] + [(i, i + 4) for i in range(4)]
