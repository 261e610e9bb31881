import struct

import cells
from solids import BOX, CONCAVE, TWO, row

LINE, TRIANGLE, QUAD, TETRAHEDRON, HEXAHEDRON, WEDGE, PYRAMID, CURVED_TETRAHEDRON, POINT = 1, 2, 3, 4, 5, 6, 7, 11, 15
PHYSICAL = b'$PhysicalNames\n1\n3 1 "a body"\n$EndPhysicalNames\n'


class Msh:
    """`order`: "" for text. Nodes have numbers with gaps."""

    def __init__(self, version="2.2", order=""):
        self.version, self.order = version, order

    def head(self):
        one = struct.pack(self.order + "i", 1) + b"\n" if self.order else b""
        return f"$MeshFormat\n{self.version} {1 if self.order else 0} 8\n".encode() + one + b"$EndMeshFormat\n"

    def line(self, kinds, *values):
        return struct.pack(self.order + kinds, *values) if self.order else (row(values) + "\n").encode()

    def nodes_2(self, points):
        lines = b"".join(self.line("iddd", 3 * i + 5, *p) for i, p in enumerate(points))
        return f"{len(points)}\n".encode() + lines

    def elements_2(self, blocks):
        out = f"{sum(len(lists) for _, lists in blocks)}\n".encode()
        for kind, lists in blocks:
            out += self.line("iii", kind, len(lists), 2) if self.order else b""
            for number, nodes in enumerate(lists):
                head = (number + 1, 1, 1) if self.order else (number + 1, kind, 2, 1, 1)
                out += self.line("i" * (len(head) + len(nodes)), *head, *(3 * n + 5 for n in nodes))
        return out

    def nodes_4(self, points):
        half = len(points) // 2
        tags = [3 * i + 5 for i in range(len(points))]
        out = self.line("QQQQ", 2, len(points), tags[0], tags[-1])
        for first, end, parameters in ((0, half, 0), (half, len(points), 2)):
            out += self.line("iiiQ", 2, 1, 1 if parameters else 0, end - first)
            out += b"".join(self.line("Q", tag) for tag in tags[first:end])
            out += b"".join(self.line("d" * (3 + parameters), *p, *[0.5] * parameters) for p in points[first:end])
        return out

    def elements_4(self, blocks):
        count = sum(len(lists) for _, lists in blocks)
        out = self.line("QQQQ", len(blocks), count, 1, count)
        for kind, lists in blocks:
            out += self.line("iiiQ", 2, 1, kind, len(lists))
            out += b"".join(self.line("Q" * (1 + len(n)), 1, *(3 * v + 5 for v in n)) for n in lists)
        return out

    def file(self, points, *blocks):
        new = self.version == "4.1"
        nodes = (self.nodes_4 if new else self.nodes_2)(points)
        elements = (self.elements_4 if new else self.elements_2)(blocks)
        end = b"\n" if self.order else b""
        entities = b"$Entities\n" + self.line("QQQQ", 0, 0, 0, 0) + end + b"$EndEntities\n" if new else b""
        return (
            self.head() + PHYSICAL + entities + b"$Nodes\n" + nodes + end + b"$EndNodes\n$Elements\n" + elements + end
            + b"$EndElements\n"
        )  # fmt: skip


def add_corners(table):
    read, refused = table.of("msh", "msh")
    for version in ("2.2", "4.1"):
        for order in ("", "<", ">"):
            msh = Msh(version, order)
            name = f"{version}-{ {'': 'text', '<': 'little', '>': 'big'}[order]}"
            read(f"{name}-triangles", msh.file(BOX.points, (TRIANGLE, BOX.triangles())))
            read(f"{name}-quads", msh.file(TWO.points, (QUAD, TWO.faces)), TWO)
            read(f"{name}-tetrahedra", msh.file(BOX.points, (TETRAHEDRON, cells.TETRAHEDRA)))
            points, lists = cells.grid(2)
            read(f"{name}-hexahedra", msh.file(points, (HEXAHEDRON, lists)), triangles=48)
            read(f"{name}-wedges", msh.file(BOX.points, (WEDGE, cells.WEDGES)))
            read(f"{name}-pyramids", msh.file(cells.POINTS, (PYRAMID, cells.PYRAMIDS)))
            points, lists = cells.curved(cells.TETRAHEDRA, BOX.points, cells.TETRAHEDRON_EDGES)
            read(f"{name}-curved", msh.file(points, (CURVED_TETRAHEDRON, lists)), remarks=["curved"])
            read(f"{name}-marked", msh.file(
                BOX.points, (POINT, [[0], [7]]), (LINE, [[0, 1], [1, 3]]), (TRIANGLE, cells_skin()),
                (TETRAHEDRON, cells.TETRAHEDRA)))  # fmt: skip
            whole = msh.file(BOX.points, (TRIANGLE, BOX.triangles()))
            refused(f"{name}-cut-off", whole[: whole.index(b"$EndElements") - 9], "byte " if order else "line ")
            refused(f"{name}-kind", msh.file(BOX.points, (140, [[0, 1, 2]])), "Gmsh's type 140")
    box = Msh().file(BOX.points, (QUAD, BOX.faces))
    read("crlf", box.replace(b"\n", b"\r\n"))
    read("blanks", box.replace(b" ", b"  \t").replace(b"2.2  \t", b"2.2 "))
    read("data", box + b"$NodeData\n1\n\"a\"\n1\n0\n3\n0\n1\n1\n5 1\n$EndNodeData\n")
    read("concave", Msh().file(CONCAVE.points, (TRIANGLE, CONCAVE.triangles())), CONCAVE.in_triangles())
    new = Msh("4.1").file(BOX.points, (QUAD, BOX.faces))
    refused("negative-dimension", new.replace(b"2 1 1 4\n", b"-9 1 1 4\n"), "section \"$Nodes\" does not end")
    refused("other", "(0 \"Fluent\")\n", "no file of Gmsh")
    refused("old", box.replace(b"2.2 0 8", b"4 0 8"), "version 4 ", "4.1 or 2.2")
    refused("node", box.replace(b" 26 23\n", b" 27 23\n"), "names node 27")
    refused("no-end", box.replace(b"$EndNodes\n", b""), "section \"$Nodes\" does not end")
    refused("word", box.replace(b"$Nodes", b"Nodes"), "\"Nodes\" stands where a section must begin")


def cells_skin():
    """The faces of the tetrahedra that belong to one alone."""
    sides = [(a, b, c) for t in cells.TETRAHEDRA for a, b, c in (
        (t[0], t[1], t[2]), (t[0], t[1], t[3]), (t[0], t[2], t[3]), (t[1], t[2], t[3]))]  # fmt: skip
    keys = [tuple(sorted(s)) for s in sides]
    return [s for s, key in zip(sides, keys) if keys.count(key) == 1]
