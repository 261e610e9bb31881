import struct

from solids import BOX, TETRAHEDRON, TOUCHING, TWO, linear, row

RED = [1, 0, 0, 1]


def facets(solid=BOX):
    return [[solid.points[v] for v in t] for t in solid.triangles()]


def binary(solid=BOX, header=b"made by hand", count=None, attribute=0):
    own = facets(solid)
    out = header.ljust(80, b" ") + struct.pack("<I", len(own) if count is None else count)
    for corners in own:
        out += struct.pack("<12f", 0, 0, 0, *(x for p in corners for x in p))
        out += struct.pack("<H", attribute)
    return out


def lines(solid=BOX, polygons=False):
    shapes = [[solid.points[v] for v in f] for f in solid.faces] if polygons else facets(solid)
    out = ""
    for corners in shapes:
        out += "  facet normal 0 0 0\n    outer loop\n"
        out += "".join(f"      vertex {row(p)}\n" for p in corners)
        out += "    endloop\n  endfacet\n"
    return out


def text(solid=BOX, name="a box"):
    return f"solid {name}\n{lines(solid)}endsolid {name}\n"


def add_corners(table):
    add_binary(table)
    add_text(table)


def add_binary(table):
    read, refused = table.of("stl", "stl")

    bits = 0x8000
    read("binary", binary())
    read("binary-solid", binary(header=b"solid box"))
    read("binary-solid-lines", binary(header=b"solid box\nof binary numbers\n"))
    read("binary-zeros", binary(header=b"\0" * 80))
    read("binary-two", binary(TWO), TWO)
    read("binary-attributes", binary(attribute=7))
    read("binary-bytes-behind", binary() + b"x" * 37, remarks=["37 bytes"])
    read("binary-solid-behind", binary(header=b"solid") + b"x" * 14, remarks=["14 bytes"])
    read("binary-joined", binary() + binary(BOX.moved(5)), TWO)
    read("binary-viscam", binary(attribute=bits | 31 << 10), colors=[RED])
    read("binary-materialise", binary(header=b"COLOR=\xff\xff\xff\xff", attribute=31), colors=[RED])
    default = binary(header=b"COLOR=\xff\x00\x80\xff,MATERIAL=", attribute=bits)
    read("binary-default-color", default, colors=[[1, 0, linear(128 / 255), 1]])
    refused("binary-cut-off", binary()[:-20], "neither a binary STL")
    refused("binary-count-large", binary(count=13), "neither a binary STL")
    refused("binary-count-huge", binary(count=0xFFFFFFFF), "neither a binary STL")
    refused("binary-count-small", binary(TWO, count=12), "12 triangles", "24")
    refused("binary-count-zero", binary(count=0), "0 triangles", "12")
    refused("binary-empty", binary(count=0)[:84], "no surface")
    refused("binary-nan", binary(BOX.scaled(float("nan"), 1, 1)), "not a finite number")
    refused("binary-far", binary(BOX.moved(1e6)), "32-bit")
    refused("short", b"solid", "endsolid")


def add_text(table):
    read, refused = table.of("stl", "stl")

    box = text()
    read("text", box)
    read("bom", "\ufeff" + box)
    read("crlf", box.replace("\n", "\r\n"))
    read("cr", box.replace("\n", "\r"))
    read("tabs", box.replace(" ", "\t"))
    read("no-indent", "\n".join(line.strip() for line in box.split("\n")))
    read("no-end", box.rstrip())
    read("capitals", box.upper())
    read("mixed-case", box.replace("facet", "Facet").replace("outer loop", "Outer Loop"))
    read("unnamed", text(name=""))
    read("umlaut", text(name="kästchen größe 2").encode("latin-1"))
    read("name-of-words", text(name="facet vertex 1 2 3 endloop"))
    read("long-name", text(name="x" * 5000))
    read("empty-lines", "\n\n" + box.replace("\n", "\n\n"))
    read("comment-first", "# a comment\n; another\n// and one\n" + box)
    read("comments", box.replace("endfacet", "endfacet\n; so"))
    read("two", text() + text(BOX.moved(5)), TWO)
    read("touching", text() + text(BOX.moved(1)), TOUCHING)
    read("empty-solid", "solid nothing\nendsolid nothing\n" + box)
    read("end-unnamed", box.replace("endsolid a box", "endsolid"))
    read("end-apart", box.replace("endsolid", "end solid").replace("endfacet", "end facet").replace(
        "endloop", "end loop"))  # fmt: skip
    read("ind-normals", box.replace("normal 0 0 0", "normal -1.#IND nan 1.#QNAN"))
    read("no-normals", box.replace("facet normal 0 0 0", "facet"))
    read("quads", f"solid\n{lines(polygons=True)}endsolid\n")
    read("line-facet", box.replace("endsolid", "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"
                                   "endfacet\nendsolid"))  # fmt: skip
    read("one-line", " ".join(box.split("\n")[1:]).join(["solid\n", ""]))
    read("facets-in-lines", "solid\n" + "".join(
        " ".join(part.split()) + "\n" for part in lines(TWO).split("endfacet\n")[:-1]
    ).replace("endloop", "endloop endfacet") + "endsolid\n", TWO)  # fmt: skip
    read("words-in-lines", box.replace("\n    outer", " outer").replace("endloop\n", "endloop"))
    read("exponents", box.replace("vertex 1 2 3", "vertex 1.0E+00 2e0 +.3e+001"))
    read("colors-in-text", box.replace("outer", "color 1 0 0\nouter"))
    read("far", text(BOX.moved(5e5)), BOX.moved(5e5))
    read("tetrahedron", text(TETRAHEDRON), TETRAHEDRON)
    refused("misspelt", text() + text(BOX.moved(5)).replace("vertex", "vertx"), "line ", "vertx")
    refused("misspelt-loop", box.replace("endloop", "endlop", 1), "line ", "endlop")
    refused("no-endloop", box.replace("    endloop\n", "", 1), "line ", "endloop")
    refused("four-numbers", box.replace("vertex 1 2 3", "vertex 1 2 3 4"), "line ", '"4"')
    refused("no-endsolid", box[: box.index("endsolid")], "endsolid")
    refused("cut-off", box[: box.rindex("vertex")], "endsolid")
    refused("nan", box.replace("vertex 1 2 3", "vertex 1 nan 3"), "not a finite number")
    refused("ind", box.replace("vertex 1 2 3", "vertex 1 -1.#IND 3"), "line ", "-1.#IND")
    refused("comma", box.replace("vertex 1 2 3", "vertex 1,0 2,0 3,0"), "line ", "1,0")
    refused("two-numbers", box.replace("vertex 1 2 3", "vertex 1 2"), "line ", "number")
    refused("no-solid", lines(), "solid")
    refused("utf16", box.encode("utf-16"), "UTF-16")
    refused("nothing", "solid\nendsolid\n", "no surface")
    refused("hole", "solid\n" + lines()[lines().index("  facet", 1) :] + "endsolid\n", "open edges")
