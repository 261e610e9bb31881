import base64
import struct
import zlib

import cells
from solids import BOX, CONCAVE, STAR, TWO, linear, row

RED = [1, 0, 0, 1]
TYPES = {"float": "f", "double": "d", "int": "i", "long": "q", "unsigned_char": "B", "vtkIdType": "i",
         "vtktypeint64": "q", "short": "h"}  # fmt: skip
XML_TYPES = {"Float32": "f", "Float64": "d", "Int32": "i", "Int64": "q", "UInt8": "B"}
# Corners as strips: turns of two triangles each.
STRIPS = [[0, 2, 1, 3], [4, 5, 6, 7], [0, 1, 4, 5], [2, 6, 3, 7], [0, 4, 2, 6], [1, 3, 5, 7]]


def ends(lists):
    return [sum(map(len, lists[: i + 1])) for i in range(len(lists))]


def flat(lists):
    return [number for one in lists for number in one]


# --- Legacy files --------------------------------------------------------------------------------


class Legacy:
    def __init__(self, binary, version="3.0"):
        self.binary, self.version = binary, version

    def numbers(self, kind, values):
        if not self.binary:
            return (row(values) + "\n").encode()
        return struct.pack(f">{len(values)}{TYPES[kind]}", *(values if kind in ("float", "double") else map(int, values))) + b"\n"

    def section(self, head, kind, values):
        return head.encode() + b"\n" + self.numbers(kind, values)

    def points(self, points, kind="float"):
        return self.section(f"POINTS {len(points)} {kind}", kind, flat(points))

    def lists(self, word, lists):
        if self.version < "5":
            values = flat([len(one), *one] for one in lists)
            return self.section(f"{word} {len(lists)} {len(values)}", "int", values)
        head = f"{word} {len(lists) + 1} {len(flat(lists))}\n".encode()
        kind = "vtktypeint64"
        return head + self.section(f"OFFSETS {kind}", kind, [0, *ends(lists)]) + self.section(
            f"CONNECTIVITY {kind}", kind, flat(lists)
        )

    def file(self, kind, *sections):
        encoding = "BINARY" if self.binary else "ASCII"
        head = f"# vtk DataFile Version {self.version}\nwritten by hand\n{encoding}\nDATASET {kind}\n"
        return head.encode() + b"".join(sections)

    def polygons(self, solid=BOX, *more, kind="float"):
        return self.file("POLYDATA", self.points(solid.points, kind), self.lists("POLYGONS", solid.faces), *more)

    def grid(self, points, lists, types, *more):
        kinds = self.section(f"CELL_TYPES {len(types)}", "int", types)
        return self.file("UNSTRUCTURED_GRID", self.points(points), self.lists("CELLS", lists), kinds, *more)


def add_legacy(table):
    read, refused = table.of("vtk", "vtk")
    for version in ("2.0", "3.0", "4.2", "5.1"):
        for binary in (False, True):
            legacy = Legacy(binary, version)
            name = f"{version}-{'binary' if binary else 'text'}"
            read(f"{name}-box", legacy.polygons())
            read(f"{name}-doubles", legacy.polygons(kind="double"))
            read(f"{name}-concave", legacy.polygons(CONCAVE), CONCAVE)
            read(f"{name}-strips", legacy.file("POLYDATA", legacy.points(BOX.points), legacy.lists("TRIANGLE_STRIPS", STRIPS)))
            read(f"{name}-hexahedra", legacy.grid(*cells.grid(2), [12] * 8), triangles=48)
            read(f"{name}-tetrahedra", legacy.grid(BOX.points, cells.TETRAHEDRA, [10] * 6))
            data = legacy.section("POINT_DATA 8\nSCALARS pressure short\nLOOKUP_TABLE default", "short", range(8))
            data += legacy.section("NORMALS Normals float", "float", [0, 0, 1] * 8)
            data += legacy.section("FIELD FieldData 2\nid 1 8 vtkIdType", "int", range(8))
            data += legacy.section("RGB 3 8 unsigned_char", "unsigned_char", [255, 0, 0] * 8)
            read(f"{name}-colors", legacy.polygons(BOX, data), colors=[RED])
    text, binary = Legacy(False), Legacy(True)
    for name, lists, types in (
        ("hexahedron", [cells.HEXAHEDRON], [12]), ("voxel", [range(8)], [11]), ("wedges", cells.WEDGES, [13] * 2),
        ("pyramids", cells.PYRAMIDS, [14] * 6), ("quads", BOX.faces, [9] * 6), ("polygons", BOX.faces, [7] * 6),
        ("pixels", [[f[0], f[1], f[3], f[2]] for f in BOX.faces], [8] * 6), ("strips", STRIPS, [6] * 6),
        ("triangles", BOX.triangles(), [5] * 12),
        ("inverted", [[a, c, b, d] for a, b, c, d in cells.TETRAHEDRA], [10] * 6),
        ("with-lines", [cells.HEXAHEDRON, [0, 1], [8]], [12, 3, 1]),
        ("with-its-skin", [cells.HEXAHEDRON, *BOX.faces], [12] + [9] * 6),
        ("collapsed", [[0, 1, 3, 3, 4, 5, 7, 7], [0, 3, 2, 2, 4, 7, 6, 6]], [12] * 2),
    ):  # fmt: skip
        lists = [list(one) for one in lists]
        read(f"cells-{name}", text.grid(cells.POINTS, lists, types))
    for name, cell, edges, kind, triangles in (
        ("tetrahedra", cells.TETRAHEDRA, cells.TETRAHEDRON_EDGES, 24, 12),
        ("hexahedron", [cells.HEXAHEDRON], cells.HEXAHEDRON_EDGES, 25, 12),
    ):
        read(f"curved-{name}", text.grid(*cells.curved(cell, BOX.points, edges), [kind] * len(cell)), remarks=["curved"])
    two = Legacy(False, "5.1")
    read("two", two.polygons(TWO), TWO)
    read("star", two.polygons(STAR), STAR)
    box = text.polygons()
    read("glued", box.replace(b"# vtk", b"#vtk"))
    read("crlf", box.replace(b"\n", b"\r\n"))
    read("cr", box.replace(b"\n", b"\r"))
    read("bom", b"\xef\xbb\xbf" + box)
    read("blank-lines", box.replace(b"\n", b"\n\n"). replace(b"\n\n", b"\n", 2))
    read("metadata", box.replace(b"POLYGONS", b"METADATA\nINFORMATION 1\nNAME L2 LOCATION vtkDataArray\nDATA 2 0 1\n\nPOLYGONS"))
    read("field-first", box.replace(b"POINTS", b"FIELD FieldData 1\nTIME 1 1 double\n0\nPOINTS"))
    read("upper", box.replace(b"ASCII", b"ascii").replace(b"POLYDATA", b"polydata"))
    read("color-scalars-text", text.polygons(BOX, b"POINT_DATA 8\nCOLOR_SCALARS c 3\n" + b"1 0 0\n" * 8), colors=[RED])
    read("color-scalars", binary.polygons(BOX, b"POINT_DATA 8\nCOLOR_SCALARS c 4\n" + b"\xff\0\0\xff" * 8), colors=[RED])
    read("three-floats", text.polygons(BOX, b"POINT_DATA 8\nSCALARS Colors float 3\nLOOKUP_TABLE default\n" + b"1 0.5 0\n" * 8), colors=[[1, linear(0.5), 0, 1]])
    refused("bits", text.polygons(BOX, b"CELL_DATA 6\nSCALARS on bit\nLOOKUP_TABLE default\n1 0 1 0 1 0\n"), "\"bit\" stands where")
    read("unknown-end", box + b"SOMETHING 1 2 3\n", remarks=["line 9 on was left out"])
    refused("other", "solid a\n", "line 1: it does not begin with")
    refused("image", text.file("STRUCTURED_POINTS", b"DIMENSIONS 2 2 2\n"), "line 4: ", "STRUCTURED_POINTS", "Extract Surface")
    refused("polyhedron", text.grid(BOX.points, [[0]], [42]), "type 42", "Extract Surface")
    refused("cut-off", box[:-20], "it ends too early")
    refused("binary-cut-off", binary.polygons()[:-20], "byte ", "it ends")
    refused("no-types", text.file("UNSTRUCTURED_GRID", text.points(BOX.points), text.lists("CELLS", [[0, 1, 2]])), "no surface")
    refused("vertex", box.replace(b"4 0 2 3 1", b"4 0 2 3 8"), "vertex 8", "there are 8")
    refused("negative", box.replace(b"4 0 2 3 1", b"4 0 2 3 -1"), "vertex -1")
    refused("word", box.replace(b"POLYGONS", b"POLYGONES"), "line 7: \"polygones\" stands where")
    refused("type", box.replace(b"float", b"reals"), "line 5: \"reals\" stands where")
    refused("number", box.replace(b" 3\n", b" 3,0\n"), "\"3,0\" stands where a number must")
    refused("overlap", text.grid(BOX.points, [cells.HEXAHEDRON] * 3, [12] * 3), "3 of its volume cells share a face")
    refused("few-corners", text.grid(BOX.points, [[0, 1, 3]], [10]), "3 corners", "needs 4")
    refused("utf16", box.decode().encode("utf-16"), "UTF-16")


# --- XML -----------------------------------------------------------------------------------------


class Xml:
    def __init__(self, form="ascii", order="<", head="UInt32", packed=False, real="Float32", whole="Int32", block=64):
        self.form, self.order, self.head, self.packed = form, order, head, packed
        self.real, self.whole, self.block, self.appended = real, whole, block, b""

    def packing(self, values, kind):
        """Head and data."""
        data = struct.pack(f"{self.order}{len(values)}{XML_TYPES[kind]}", *values)
        number = lambda *n: struct.pack(f"{self.order}{len(n)}{'Q' if self.head == 'UInt64' else 'I'}", *n)
        if not self.packed:
            return b"", number(len(data)) + data
        blocks = [data[i : i + self.block] for i in range(0, len(data), self.block)]
        last = len(blocks[-1]) % self.block if blocks else 0
        blocks = [zlib.compress(b) for b in blocks]
        return number(len(blocks), self.block, last, *map(len, blocks)), b"".join(blocks)

    def array(self, kind, name, values, components=1):
        values = list(values)
        values = values if kind.startswith("Float") else [int(v) for v in values]
        start = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}"'
        if self.form == "ascii":
            return f'{start} format="ascii">\n{row(values)}\n</DataArray>\n'
        head, data = self.packing(values, kind)
        coded = base64.b64encode(head) + base64.b64encode(data)
        if self.form == "binary":
            return f'{start} format="binary">\n  {coded.decode()}\n</DataArray>\n'
        offset = len(self.appended)
        self.appended += head + data if self.form == "raw" else coded
        return f'{start} format="appended" offset="{offset}"/>\n'

    def lists(self, word, lists, types=None):
        kinds = self.array("UInt8", "types", types) if types else ""
        return f"<{word}>{self.array(self.whole, 'connectivity', flat(lists))}{self.array(self.whole, 'offsets', ends(lists))}{kinds}</{word}>\n"

    def piece(self, points, *more):
        places = self.array(self.real, "Points", flat(points), 3)
        return f'<Piece NumberOfPoints="{len(points)}"><Points>{places}</Points>{"".join(more)}</Piece>\n'

    def file(self, kind, *pieces):
        order = "LittleEndian" if self.order == "<" else "BigEndian"
        packed = ' compressor="vtkZLibDataCompressor"' if self.packed else ""
        text = f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="1.0" byte_order="{order}" header_type="{self.head}"{packed}>\n'
        text = (text + f"<{kind}>\n{''.join(pieces)}</{kind}>\n").encode()
        if self.appended:
            coding = "raw" if self.form == "raw" else "base64"
            text += f'<AppendedData encoding="{coding}">\n _'.encode() + self.appended + b"\n</AppendedData>\n"
        return text + b"</VTKFile>\n"

    def polygons(self, solid=BOX, *more):
        return self.file("PolyData", self.piece(solid.points, *more, self.lists("Polys", solid.faces)))

    def grid(self, points, lists, types):
        return self.file("UnstructuredGrid", self.piece(points, self.lists("Cells", lists, types)))


def add_xml(table):
    read, refused = table.of("vtp", "vtp")
    read_grid, refused_grid = table.of("vtu", "vtu")
    ways = [("ascii", "<", "UInt32", False)]
    ways += [
        (form, order, head, packed)
        for form in ("binary", "raw", "appended") for order in "<>"
        for head in ("UInt32", "UInt64") for packed in (False, True)
    ]  # fmt: skip
    for form, order, head, packed in ways:
        for real, whole in (("Float32", "Int32"), ("Float64", "Int64")):
            make = lambda: Xml(form, order, head, packed, real, whole)
            name = f"{form}-{'little' if order == '<' else 'big'}-{head}-{'zlib' if packed else 'plain'}-{real}"
            xml = make()
            colors = xml.array("UInt8", "Colors", [255, 0, 0] * 8, 3)
            normals = xml.array("Float32", "Normals", [0, 0, 1] * 8, 3)
            read(name, xml.polygons(BOX, f"<PointData>{normals}{colors}</PointData>"), colors=[RED])
            read_grid(name, make().grid(*cells.grid(2), [12] * 8), triangles=48)
    text = lambda **more: Xml(**more)
    read("concave", text().polygons(CONCAVE), CONCAVE)
    strips = text()
    read("strips", strips.file("PolyData", strips.piece(BOX.points, strips.lists("Strips", STRIPS))))
    both = text()
    read("pieces", both.file("PolyData", *(both.piece(s.points, both.lists("Polys", s.faces)) for s in (BOX, BOX.moved(5)))), TWO)
    read("empty-piece", both.file("PolyData", '<Piece NumberOfPoints="0"/>', both.piece(BOX.points, both.lists("Polys", BOX.faces))))
    whole = Xml("binary", packed=True, block=96)
    read("whole-blocks", whole.polygons())
    floats = text()
    read("float-colors", floats.polygons(BOX, f"<PointData>{floats.array('Float32', 'rgba', [1, 0, 0, 0.5] * 8, 4)}</PointData>"), colors=[[1, 0, 0, 0.5]])
    read_grid("tetrahedra", text().grid(BOX.points, cells.TETRAHEDRA, [10] * 6))
    box = text().polygons()
    read("bom", b"\xef\xbb\xbf" + box)
    read("crlf", box.replace(b"\n", b"\r\n"))
    read("utf16", box.decode().encode("utf-16"))
    refused("broken", box[: box.index(b"</Polys>")], "its XML is broken")
    refused("cut-off", Xml("raw").polygons()[:-120], "its array \"Points\": it ends")
    refused("few-points", box.replace(b'NumberOfPoints="8"', b'NumberOfPoints="9"'), "24 coordinates")
    refused("offsets", box.replace(b"4 8 12", b"4 8 99"), "end at 99, and there are 24")
    refused("type", box.replace(b"Float32", b"Float16"), "its array \"Points\": \"Float16\" is no type")
    refused("lz4", Xml("binary", packed=True).polygons().replace(b"vtkZLib", b"vtkLZ4"), "vtkLZ4DataCompressor", "without compression")
    packed = Xml("raw", packed=True).polygons()
    at = packed.rindex(b"\x78\x9c")
    refused("damaged", packed[: at + 6] + b"\xff" * 4 + packed[at + 10 :], "its compressed data is damaged")
    refused("image", text().file("ImageData"), "\"ImageData\"", "Extract Surface")
    refused("base64", Xml("binary").polygons().replace(b"  ", b"  ?"), "its array \"Points\": it has data that is no base64")
    refused_grid("polyhedron", text().grid(BOX.points, [[0]], [42]), "type 42")
    refused_grid("no-vtk", "<html/>", "data set")


def add_corners(table):
    add_legacy(table)
    add_xml(table)
