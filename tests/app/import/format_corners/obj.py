from solids import BOX, CONCAVE, STAR, STRAIGHT, TETRAHEDRON, TOUCHING, TWO, linear, png, row

RED = [1, 0, 0, 1]
HALF = linear(0.5)


def vertices(solid=BOX, behind=""):
    return "".join(f"v {row(p)}{behind}\n" for p in solid.points)


def faces(solid=BOX, corner="{0}", shift=1):
    return "".join(
        "f " + " ".join(corner.format(v + shift) for v in face) + "\n" for face in solid.faces
    )


def whole(solid=BOX):
    return vertices(solid) + faces(solid)


def add_corners(table):
    add_lines(table)
    add_numbers(table)
    add_faces(table)
    add_looks(table)


def add_lines(table):
    def read(name, text, solid=BOX, **facts):
        table.read(f"obj/{name}.obj", text, solid, **facts)

    box = whole()
    read("plain", box)
    read("bom", "\ufeff# by a text editor\n" + box)
    read("bom-vertex", "\ufeff" + box)
    read("crlf", box.replace("\n", "\r\n"))
    read("cr", box.replace("\n", "\r"))
    read("mixed-ends", vertices().replace("\n", "\r\n") + faces().replace("\n", "\r"))
    read("no-end", box.rstrip())
    read("tabs", box.replace(" ", "\t"))
    read("blanks", "".join(f" \t {line}  \t\n" for line in box.splitlines()))
    read("empty-lines", box.replace("\n", "\n\n \n"))
    read("form-feeds", vertices() + "\f\n" + faces().replace(" ", "\v"))
    read("comments", "#\n" + box.replace("\n", " # why\n#f 1 2 3\n"))
    read("glued-comments", box.replace("\n", "#why\n"))
    read("continued", vertices() + faces().replace(" ", " \\\n"))
    read("continued-crlf", (vertices() + faces().replace(" ", " \\\n")).replace("\n", "\r\n"))
    read("continued-vertices", vertices().replace(" ", "\\\n ") + faces())
    read("backslash-comment", "# C:\\\n" + box)
    read("backslash-object", "o C:\\\n" + box)
    read("zeros-at-end", box + "\0" * 16, remarks=["were left out"])
    table.refused("obj/utf16.obj", ("\ufeff" + box).encode("utf-16-le"), "UTF-16")
    table.refused("obj/utf16-big.obj", ("\ufeff" + box).encode("utf-16-be"), "UTF-16")
    table.refused("obj/capitals.obj", box.upper(), "no surface")
    read("objects", vertices() + "o a b\ng ä ö\ns off\n" + faces())
    read("two-objects", "o a\n" + whole(TWO), TWO)
    second = vertices(BOX.moved(1)) + faces(shift=9)
    read("touching", "o a\n" + box + "o b\n" + second, TOUCHING)
    read("smoothing", "s 1\nmg 1 2\nlod 3\n" + box)
    read("curves", vertices() + "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n" + faces(),
         remarks=["curv"])  # fmt: skip


def add_numbers(table):
    def read(name, old, new, solid=BOX):
        table.read(f"obj/{name}.obj", whole().replace(old, new), solid)

    def refused(name, new, *words):
        table.refused(f"obj/{name}.obj", whole().replace("v 1 2 3", new), *words)

    read("exponents", "v 1 2 3", "v 1e0 0.2E+1 300.e-2")
    read("plus", "v 1 2 3", "v +1 +2.0 +3e+0")
    read("short", "v 1 2 3", "v 1. .2e1 3.")
    read("leading-zeros", "v 1 2 3", "v 001 02.000 0003")
    read("minus-zero", "v 0 0 0", "v -0 -0.0 -.0")
    read("subnormal", "v 0 0 0", "v 1e-320 -1e-400 0")
    read("many-digits", "v 1 2 3", "v 1." + "0" * 400 + " 2 2." + "9" * 300)
    table.read("obj/large.obj", whole(BOX.scaled(1e9)), BOX.scaled(1e9))
    table.read("obj/far.obj", whole(BOX.moved(5e5, 5e6)), BOX.moved(5e5, 5e6))
    refused("nan", "v 1 nan 3", "not a finite number")
    refused("inf", "v 1 inf 3", "not a finite number")
    refused("overflow", "v 1 1e400 3", "not a finite number")
    refused("ind", "v 1 -1.#IND 3", "line 8", "number")
    refused("comma", "v 1,0 2,0 3,0", "line 8", "1,0")
    refused("fortran", "v 1.0D+00 2 3", "line 8", "1.0D+00")
    refused("too-few", "v 1 2", "line 8", "three")
    refused("glued", "v 1 2 3v", "line 8", "3v")
    refused("minus-plus", "v 1 +-2 3", "line 8", "+-2")
    table.refused("obj/huge.obj", whole(BOX.scaled(1e300)), "not a finite number")
    table.refused("obj/tiny.obj", whole(BOX.scaled(1e-9)), "scale or move")
    table.read("obj/weight.obj", vertices(BOX.scaled(2), " 2") + faces())
    table.read("obj/weight-zero.obj", vertices(BOX, " 0") + faces())


def add_faces(table):
    read, refused = table.of("obj", "obj")

    uvs = "".join(f"vt {u} {v}\n" for v in (0, 1) for u in (0, 0.25, 0.5, 1))
    all_uvs = [[u, v] for v in (0, 1) for u in (0, 0.25, 0.5, 1)]
    read("backwards", vertices() + faces(shift=-8))
    read("backwards-between", "".join(
        vertices(part) + "f 1 2\n" + faces(part, shift=-8) for part in (BOX, BOX.moved(5))), TWO)  # fmt: skip
    read("forward", faces() + vertices())
    read("uvs", vertices() + uvs + faces(corner="{0}/{0}"), uvs=all_uvs)
    read("normals", vertices() + "vn 0 0 1\nvn nan -1.#IND 0\n" + faces(corner="{0}//1"))
    read("uvs-normals", vertices() + uvs + "vn 0 0 1\n" + faces(corner="{0}/{0}/1"), uvs=all_uvs)
    read("uvs-backwards", vertices() + uvs + faces(corner="{0}/{0}", shift=-8), uvs=all_uvs)
    read("uvs-in-three", vertices() + uvs.replace("\n", " 0\n") + faces(corner="{0}/{0}"), uvs=all_uvs)
    read("open-slash", vertices() + faces(corner="{0}/"))
    read("open-slashes", vertices() + faces(corner="{0}//"))
    read("uvs-nowhere", vertices() + faces(corner="{0}/{0}/{0}"))
    read("mixed-corners", vertices() + uvs + "vn 1 0 0\nf 1/1/1 3//1 4/4 2\n" + faces()[10:])
    read("old-word", vertices() + faces().replace("f", "fo"))
    read("triangles", whole(BOX.in_triangles()))
    read("tetrahedron", whole(TETRAHEDRON), TETRAHEDRON)
    read("concave", whole(CONCAVE), CONCAVE)
    read("star", whole(STAR), STAR)
    read("straight", whole(STRAIGHT), STRAIGHT)
    read("repeated-corner", whole().replace("f 1 3 4 2", "f 1 3 3 4 2"))
    read("closed-outline", whole().replace("f 1 3 4 2", "f 1 3 4 2 1"))
    read("two-corners", whole() + "f 1 2\nf 3\nf\n")
    read("points-lines", whole() + "p 1 2\nl 1 2 3\nl 1/1 2/2\n")
    read("unused", "v 9 9 9\n" + vertices() + "v -9 9 9\n" + faces(shift=2))
    read("inside-out", whole(BOX.turned()))
    refused("index-zero", whole().replace("f 1 3", "f 0 3"), "line 9", "corner")
    refused("index-beyond", whole().replace("f 1 3", "f 10 3"), "vertex 9", "there are 8")
    refused("index-before", whole().replace("f 1 3", "f -9 3"), "line 9", "corner")
    refused("index-fraction", whole().replace("f 1 3", "f 1.5 3"), "line 9", "1.5")
    refused("index-commas", vertices() + faces().replace(" ", ",").replace("f,", "f "), "line 9")
    refused("uv-beyond", vertices() + uvs + faces(corner="{0}/9"), "texture coordinate 8", "there are 8")
    refused("no-faces", vertices(), "no surface")
    refused("open", vertices() + faces()[:-10], "open edges")
    refused("cut-off", whole()[:-8], "open edges")


def add_looks(table):
    def read(name, text, **facts):
        table.read(f"obj/{name}.obj", text, **facts)

    red = "newmtl red\nKd 1 0 0\n"
    used = vertices() + "usemtl red\n" + faces()
    uvs = "vt 0 0\nvt 1 0\nvt 1 1\n"
    table.beside("obj/red.mtl", red)
    table.beside("obj/my red.mtl", red)
    table.beside("obj/bom.mtl", "\ufeff" + red)
    table.beside("obj/rötlich.mtl", red.replace("red", "rötlich"))
    table.beside("obj/cr.mtl", red.replace("\n", "\r"))
    table.beside("obj/green.mtl", "newmtl green\nKd 0 1 0 # so\n\td 0.5\nnewmtl old grün\nKd 0.5\nTr 0.25\n")
    table.beside("obj/a picture.png", png(255, 0, 0))
    table.beside("obj/picture.mtl", "newmtl red\nmap_Kd -clamp on -bm 1 C:\\work\\a picture.png\n")
    table.beside("obj/moved.mtl", "newmtl red\nmap_Kd -s 2 2 1 -o 0.5 a picture.png\n")
    table.beside("obj/gone.mtl", "newmtl red\nmap_Kd gone.png\n")
    read("material", "mtllib red.mtl\n" + used, materials={"red": RED})
    read("material-bom", "\ufeffmtllib bom.mtl\n" + used, materials={"red": RED})
    read("material-cr", "mtllib cr.mtl\n" + used, materials={"red": RED})
    read("material-blank", "mtllib my red.mtl\n" + used, materials={"red": RED})
    read("material-dot", "mtllib ./red.mtl\n" + used, materials={"red": RED})
    read("material-umlaut", "mtllib rötlich.mtl\n" + used.replace("red", "rötlich"),
         materials={"rötlich": RED})  # fmt: skip
    read("materials-two", "mtllib red.mtl green.mtl\n" + used.replace("f 3", "usemtl green\nf 3"),
         materials={"red": RED, "green": [0, 1, 0, 0.5]})  # fmt: skip
    read("material-last", used + "mtllib red.mtl\n", materials={"red": RED})
    read("material-grey", "mtllib green.mtl\n" + used.replace("red", "old grün"),
         materials={"old grün": [0.5, 0.5, 0.5, 0.75]})  # fmt: skip
    read("library-missing", "mtllib nowhere.mtl\n" + used, remarks=["nowhere.mtl"])
    table.beside("obj/comma.mtl", red.replace("1 0", "1,0 0"))
    read("library-damaged", "mtllib comma.mtl\n" + used, remarks=["comma.mtl\" were left out: line 2"])
    read("library-unnamed", used, remarks=["red"])
    read("material-unknown", "mtllib red.mtl\n" + used.replace("red", "blue"), remarks=["blue"])
    textured = vertices() + uvs + "usemtl red\n" + faces(corner="{0}/2")
    read("picture", "mtllib picture.mtl\n" + textured, images=1, uvs=[[1, 0]], materials={"red": [1, 1, 1, 1]})
    read("picture-moved", "mtllib moved.mtl\n" + textured, images=1, remarks=["-o"])
    read("picture-missing", "mtllib gone.mtl\n" + textured, images=0, remarks=["gone.png"])
    read("colors", vertices(behind=" 0.5 0 1") + faces(), colors=[[HALF, 0, 1, 1]])
    read("colors-bytes", vertices(behind=" 255 0 0") + faces(), colors=[RED])
    read("colors-opacity", vertices(behind=" 1 0 0 1") + faces(), colors=[RED])
    some = vertices().replace("v 1 2 3\n", "v 1 2 3 1 0 0\n")
    read("colors-some", some + faces(), colors=[RED, [1, 1, 1, 1]])
