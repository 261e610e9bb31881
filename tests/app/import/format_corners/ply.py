import struct

from solids import BOX, CONCAVE, STAR, STRAIGHT, TETRAHEDRON, TOUCHING, TWO, linear, png, row

SCALARS = {
    "char": ("int8", "b"), "uchar": ("uint8", "B"), "short": ("int16", "h"), "ushort": ("uint16", "H"),
    "int": ("int32", "i"), "uint": ("uint32", "I"), "float": ("float32", "f"), "double": ("float64", "d"),
}  # fmt: skip
CODES = {name: code for own, (other, code) in SCALARS.items() for name in (own, other)}
ENCODINGS = {"<": "binary_little_endian", ">": "binary_big_endian", "": "ascii"}
PLACE = ["float x", "float y", "float z"]
CORNERS = ["list uchar int vertex_indices"]
RED = [1, 0, 0, 1]


class Element:
    """`rows`: a list of values for each; lists for those that are lists."""

    def __init__(self, name, properties, rows, count=None):
        self.name, self.properties, self.rows = name, properties, rows
        self.count = len(rows) if count is None else count

    def head(self):
        lines = "".join(f"property {p}\n" for p in self.properties)
        return f"element {self.name} {self.count}\n{lines}"

    def text(self):
        flat = lambda v: [len(v), *v] if isinstance(v, list) else [v]
        return "".join(row(n for v in values for n in flat(v)) + "\n" for values in self.rows)

    def bytes(self, order):
        out = b""
        for values in self.rows:
            for value, words in zip(values, (p.split() for p in self.properties)):
                if isinstance(value, list):
                    out += struct.pack(order + CODES[words[1]], len(value))
                    out += struct.pack(order + CODES[words[2]] * len(value), *value)
                else:
                    out += struct.pack(order + CODES[words[0]], value)
        return out


def vertices(solid=BOX, properties=PLACE, behind=(), count=None):
    return Element("vertex", properties, [[*p, *behind] for p in solid.points], count)


def integers(solid, properties):
    return Element("vertex", properties, [[int(x) for x in p] for p in solid.points])


def faces(solid=BOX, properties=CORNERS, behind=(), count=None):
    return Element("face", properties, [[f, *behind] for f in solid.faces], count)


def ply(*elements, order="", comments=""):
    head = f"ply\nformat {ENCODINGS[order]} 1.0\n{comments}" + "".join(e.head() for e in elements)
    head += "end_header\n"
    if not order:
        return head + "".join(e.text() for e in elements)
    return head.encode() + b"".join(e.bytes(order) for e in elements)


def add_corners(table):
    add_types(table)
    add_elements(table)
    add_headers(table)
    add_bodies(table)
    add_looks(table)


def add_types(table):
    for own, (other, code) in SCALARS.items():
        solid = BOX if code in "bBhHiI" else BOX.moved(0.5)
        make = integers if solid is BOX else vertices
        for name, order in ((own, "<"), (other, ">")):
            properties = [f"{name} {axis}" for axis in "xyz"]
            table.read(f"ply/{name}.ply", ply(make(solid, properties), faces(), order=order), solid)
    for count, index in (("uint8", "uint"), ("ushort", "short"), ("int", "char"), ("uint", "uchar"),
                         ("char", "ushort"), ("short", "float")):  # fmt: skip
        for order in "<>":
            properties = [f"list {count} {index} vertex_index"]
            table.read(f"ply/list-{count}-{ENCODINGS[order]}.ply",
                       ply(vertices(), faces(properties=properties), order=order))  # fmt: skip


def add_elements(table):
    camera = Element("camera", ["float view_px", "list uchar int ids"], [[1, [1, 2, 3]], [2, []]])
    edges = Element("edge", ["int vertex1", "int vertex2"], [[0, 1], [1, 2]])
    marks = ["float x", "list uchar float weights", "float y", "uchar mark", "float z"]
    marked = Element("vertex", marks, [[x, [1] * int(z), y, 7, z] for x, y, z in BOX.points])
    behind = ["list int short ids", *CORNERS, "double quality"]
    listed = Element("face", behind, [[[1] * i, f, 0.5] for i, f in enumerate(BOX.faces)])
    strip = [1, 0, 3, 2, 7, 6, 5, 4, 1, 0, -1, 5, 1, 7, 3, -1, 0, 4, 2, 6]
    strips = Element("tristrips", ["list int int vertex_indices"], [[strip]])
    for order, name in (("", "text"), ("<", "little"), (">", "big")):

        def read(what, *elements, solid=BOX, **facts):
            table.read(f"ply/{what}-{name}.ply", ply(*elements, order=order), solid, **facts)

        read("plain", vertices(), faces())
        read("before", camera, vertices(), faces(), remarks=["camera"])
        read("between", vertices(), edges, faces(), remarks=["edge"])
        read("after", vertices(), faces(), edges, remarks=["edge"])
        read("empty-element", Element("edge", ["int vertex1"], []), vertices(), faces())
        read("bare-element", vertices(), faces(), Element("nothing", [], [], 0))
        read("faces-first", faces(), vertices())
        read("unknown-properties", marked, listed)
        read("strips", vertices(), strips)
    pieces = [*CORNERS, "int piece"]
    apart = Element("face", pieces, [[f, i // 6] for i, f in enumerate(TOUCHING.faces)])
    table.read("ply/touching.ply", ply(vertices(TOUCHING), apart), TOUCHING)


def add_headers(table):
    box = ply(vertices(), faces())
    little = ply(vertices(), faces(), order="<")
    end = little.index(b"end_header\n") + len(b"end_header\n")
    head, body = little[:end], little[end:]

    def read(name, content):
        table.read(f"ply/{name}.ply", content)

    def refused(name, content, *words):
        table.refused(f"ply/{name}.ply", content, *words)

    read("bom", "\ufeff" + box)
    read("bom-binary", b"\xef\xbb\xbf" + little)
    read("crlf", box.replace("\n", "\r\n"))
    read("cr", box.replace("\n", "\r"))
    read("crlf-binary", head.replace(b"\n", b"\r\n") + body)
    read("cr-binary", head.replace(b"\n", b"\r") + body)
    read("blanks", "\n".join("  ".join(line.split(" ")) + " " for line in box.split("\n")))
    read("tabs", box.replace(" ", "\t"))
    read("indented", box.replace("\nelement", "\n element").replace("\nproperty", "\n\tproperty"))
    notes = "comment made by hand\nobj_info num_cols 5\ncomment element face 7\ncomment\n"
    read("comments", ply(vertices(), faces(), comments=notes))
    read("comment-first", box.replace("ply\n", "ply\ncomment before the format\n", 1))
    read("empty-line", box.replace("element face", "\nelement face"))
    bytes_of_ten = ply(integers(BOX.moved(10), ["uchar x", "uchar y", "uchar z"]), faces(), order="<")
    end = bytes_of_ten.index(b"end_header\n") + len(b"end_header\n")
    cr_head = bytes_of_ten[:end].replace(b"\n", b"\r")
    table.read("ply/cr-then-ten.ply", cr_head + bytes_of_ten[end:], BOX.moved(10))
    refused("utf16", box.encode("utf-16"), "UTF-16")
    refused("capitals", box.upper(), "ply")
    refused("no-end-of-header", box[: box.index("end_header")], "end_header")
    refused("unknown-type", box.replace("float x", "half x"), "half")
    refused("unknown-format", box.replace("ascii", "utf8"), "utf8")
    refused("no-count", box.replace("vertex 8", "vertex"), "count")
    refused("negative-count", box.replace("vertex 8", "vertex -8"), "count")
    refused("no-x", box.replace("float x", "float px"), "x, y and z")
    refused("twice", box.replace("element face 6", "element vertex 6"), "vertex", "twice")
    refused("count-and-more", box.replace("face 6", "face 6.5"), "count")
    refused("other-line", box.replace("end_header", "propert float w\nend_header"), "propert")
    refused("no-name", box.replace("float x", "float x\nproperty float64"), "without a name")
    refused("points-only", ply(vertices()), "no surface")
    refused("other-corners", box.replace("vertex_indices", "corners"), "no surface")


def add_bodies(table):
    box = ply(vertices(), faces())
    little = ply(vertices(), faces(), order="<")

    read, refused = table.of("ply", "ply")

    head, body = box.split("end_header\n")
    head += "end_header\n"
    read("one-line", head + body.replace("\n", " "))
    read("one-word-a-line", head + body.replace(" ", "\n"))
    read("no-end", box.rstrip())
    read("numbers", box.replace("\n1 2 3\n", "\n+1.0 .2e1 3.E0\n"))
    read("real-indices", head + body.replace("4 0 2", "4 0.0 2.0"))
    read("concave", ply(vertices(CONCAVE), faces(CONCAVE)), CONCAVE)
    read("star", ply(vertices(STAR), faces(STAR), order=">"), STAR)
    read("straight", ply(vertices(STRAIGHT), faces(STRAIGHT)), STRAIGHT)
    read("tetrahedron", ply(vertices(TETRAHEDRON), faces(TETRAHEDRON)), TETRAHEDRON)
    read("two", ply(vertices(TWO), faces(TWO), order="<"), TWO)
    read("repeated-corner", box.replace("4 0 2 3 1", "5 0 2 2 3 1"))
    read("few-corners", box.replace("face 6", "face 9") + "2 0 1\n1 0\n0\n")
    read("bytes-behind", little + b"\n")
    read("double-far", ply(vertices(BOX.moved(5e5 + 0.125), ["double x", "double y", "double z"]),
                           faces(), order="<"), BOX.moved(5e5 + 0.125))  # fmt: skip
    two = ply(vertices(TWO), faces(TWO))
    read("behind", two.replace("face 12", "face 6"), remarks=["behind"])
    binary = ply(vertices(TWO), faces(TWO), order="<").replace(b"face 12", b"face 6")
    read("behind-binary", binary, remarks=["behind"])
    refused("cut-off", box[:-8], 'ends too early within its element "face"')
    refused("cut-off-binary", little[:-8], 'ends too early within its element "face"', "5 of 6")
    refused("cut-off-vertices", little[: little.index(b"end_header\n") + 40], '"vertex"', "2 of 8")
    refused("faces-missing", box.replace("face 6", "face 7"), '"face"', "6 of 7")
    refused("vertices-missing", box.replace("vertex 8", "vertex 9"), "face")
    refused("vertices-more", box.replace("vertex 8", "vertex 7"), "vertex 7", "there are 7")
    refused("huge-count", little.replace(b"vertex 8", b"vertex 4000000000"), '"vertex"')
    refused("index-beyond", box.replace("4 0 2", "4 8 2"), "vertex 8", "there are 8")
    refused("index-negative", box.replace("4 0 2", "4 -1 2"), "vertex -1")
    refused("index-half", box.replace("4 0 2", "4 0.5 2"), "vertex -1")
    refused("length-half", box.replace("4 0 2", "3.5 0 2"), '"face"', "0 of 6", "3.5")
    refused("nan", box.replace("\n1 2 3\n", "\n1 nan 3\n"), "not a finite number")
    refused("inf-binary", little.replace(struct.pack("<fff", 1, 2, 3), struct.pack("<fff", 1, 2, 1e999)),
            "not a finite number")  # fmt: skip
    refused("comma", box.replace("\n1 2 3\n", "\n1,0 2,0 3,0\n"), "1,0", '"vertex"', "7 of 8")
    refused("ind", box.replace("\n1 2 3\n", "\n1 -1.#IND 3\n"), "-1.#IND", '"vertex"')
    refused("open", ply(vertices(), faces(count=5)).replace("4 1 3 7 5\n", ""), "open edges")


def add_looks(table):
    def read(name, *elements, order="<", comments="", **facts):
        table.read(f"ply/{name}.ply", ply(*elements, order=order, comments=comments), BOX, **facts)

    half = linear(128 / 255)
    rgb = lambda kind, names=("red", "green", "blue"): [f"{kind} {n}" for n in names]
    read("colors-uchar", vertices(properties=PLACE + rgb("uchar"), behind=(255, 0, 128)), faces(),
         colors=[[1, 0, half, 1]])  # fmt: skip
    read("colors-ushort", vertices(properties=PLACE + rgb("ushort"), behind=(65535, 0, 0)), faces(),
         colors=[RED])  # fmt: skip
    read("colors-float", vertices(properties=PLACE + rgb("float"), behind=(1, 0, 0.5)), faces(),
         colors=[[1, 0, linear(0.5), 1]])  # fmt: skip
    read("colors-int", vertices(properties=PLACE + rgb("int"), behind=(255, 0, 128)), faces(),
         colors=[[1, 0, half, 1]])  # fmt: skip
    read("colors-float-bytes", vertices(properties=PLACE + rgb("float"), behind=(255, 0, 128)), faces(),
         colors=[[1, 0, half, 1]])  # fmt: skip
    bright = PLACE + rgb("float")
    read("colors-float-bright", vertices(properties=bright, behind=(1.000001, 0, 1)), faces(), colors=[[1, 0, 1, 1]])
    read("colors-alpha", vertices(properties=PLACE + [*rgb("uchar"), "uchar alpha"],
         behind=(255, 0, 0, 51)), faces(), colors=[[1, 0, 0, 0.2]])  # fmt: skip
    diffuse = ("diffuse_red", "diffuse_green", "diffuse_blue")
    read("colors-diffuse", vertices(properties=PLACE + rgb("uchar", diffuse), behind=(255, 0, 0)), faces(),
         order="", colors=[RED])  # fmt: skip
    read("colors-letters", vertices(properties=PLACE + rgb("uchar", "rgb"), behind=(255, 0, 0)), faces(),
         colors=[RED])  # fmt: skip
    read("colors-faces", vertices(), faces(properties=CORNERS + rgb("uchar"), behind=(255, 0, 0)),
         colors=[RED])  # fmt: skip
    table.beside("ply/red.png", png(255, 0, 0))
    table.beside("ply/blue.png", png(0, 0, 255))
    own = [[u, u] for u in (0, 0.25, 0.5, 0.75)]
    corner_uvs = [u for pair in own for u in pair]
    textured = CORNERS + ["list uchar float texcoord"]
    image = "comment TextureFile red.png\n"
    read("texcoords", vertices(), faces(properties=textured, behind=(corner_uvs,)), comments=image,
         images=1, uvs=own)  # fmt: skip
    for pair in ("s t", "u v", "texture_u texture_v"):
        names = [f"float {n}" for n in pair.split()]
        read(f"uvs-{pair[0]}{len(pair)}", vertices(properties=PLACE + names, behind=(0.5, 0.25)), faces(),
             comments=image, images=1, uvs=[[0.5, 0.25]])  # fmt: skip
    read("picture-missing", vertices(properties=PLACE + ["float s", "float t"], behind=(0, 0)), faces(),
         comments=image.replace("red", "gone"), images=0, remarks=["gone.png"])  # fmt: skip
    numbered = Element("face", [*textured, "int texnumber"],
                       [[f, corner_uvs, i % 2] for i, f in enumerate(BOX.faces)])  # fmt: skip
    read("pictures-two", vertices(), numbered, comments=image + image.replace("red", "blue"), images=2)
