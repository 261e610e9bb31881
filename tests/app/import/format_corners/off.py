from solids import BOX, CONCAVE, STAR, STRAIGHT, TETRAHEDRON, TWO, linear, row

RED = [1, 0, 0, 1]


def vertices(solid=BOX, behind=""):
    return "".join(f"{row(p)}{behind}\n" for p in solid.points)


def faces(solid=BOX, behind=""):
    return "".join(f"{len(f)} {row(f)}{behind}\n" for f in solid.faces)


def counts(solid=BOX):
    return f"{len(solid.points)} {len(solid.faces)} 0\n"


def off(solid=BOX, word="OFF", behind="", behind_face=""):
    return f"{word}\n{counts(solid)}{vertices(solid, behind)}{faces(solid, behind_face)}"


def add_corners(table):
    read, refused = table.of("off", "off")

    box = off()
    read("plain", box)
    read("bom", "\ufeff" + box)
    read("crlf", box.replace("\n", "\r\n"))
    read("cr", box.replace("\n", "\r"))
    read("tabs", box.replace(" ", "\t"))
    read("blanks", box.replace("\n", " \n  "))
    read("no-end", box.rstrip())
    read("comments", "# one\n" + box.replace("\n", " # two\n#\n\n"))
    read("counts-on-first-line", box.replace("OFF\n", "OFF "))
    read("counts-glued", box.replace("OFF\n", "OFF"))
    read("counts-apart", box.replace("8 6 0", "8\n6\n0"))
    read("no-edges", box.replace("8 6 0", "8 6"))
    read("edges", box.replace("8 6 0", "8 6 12"))
    read("one-word-a-line", "OFF\n" + counts() + vertices() + faces().replace(" ", "\n"))
    read("numbers", box.replace("\n1 2 3\n", "\n+1.0 .2e1 3.E0\n"))
    read("concave", off(CONCAVE), CONCAVE)
    read("star", off(STAR), STAR)
    read("straight", off(STRAIGHT), STRAIGHT)
    read("tetrahedron", off(TETRAHEDRON), TETRAHEDRON)
    read("two", off(TWO), TWO)
    read("repeated-corner", box.replace("4 0 2 3 1", "5 0 2 2 3 1"))
    read("few-corners", box.replace("8 6 0", "8 9 0") + "2 0 1\n1 0\n0\n")
    read("bytes", off(word="COFF", behind=" 255 0 0 255"), colors=[RED])
    read("floats", off(word="COFF", behind=" 1.0 0.5 0.0 1.0"), colors=[[1, linear(0.5), 0, 1]])
    read("three-floats", off(word="COFF", behind=" 1.0 0.0 0.0"), colors=[RED])
    read("dark-bytes", off(word="COFF", behind=" 0 0 1 255"), colors=[[0, 0, linear(1 / 255), 1]])
    read("normals", off(word="NOFF", behind=" 0 0 1"))
    read("normals-colors", off(word="CNOFF", behind=" 0 0 1 255 0 0 255"), colors=[RED])
    read("uvs", off(word="STOFF", behind=" 0.5 0.25"), uvs=[[0.5, 0.25]])
    read("uvs-colors", off(word="STCOFF", behind=" 255 0 0 255 0.5 0.25"), uvs=[[0.5, 0.25]], colors=[RED])
    read("weights", off(BOX.scaled(2), word="4OFF", behind=" 2"))
    read("face-bytes", off(behind_face=" 255 0 0"), colors=[RED])
    read("face-floats", off(behind_face=" 1.0 0.0 0.0"), colors=[RED])
    read("face-alpha", off(behind_face=" 1.0 0.0 0.0 0.5"), colors=[[1, 0, 0, 0.5]])
    read("face-table", off(behind_face=" 3"), remarks=["Colours"])
    some = off(behind_face=" 255 0 0").replace("4 1 3 7 5 255 0 0", "4 1 3 7 5 0 0 1")
    read("face-dark", some, colors=[RED, [0, 0, linear(1 / 255), 1]])
    read("behind", off(TWO).replace("16 12 0", "16 6 0"), remarks=["behind"])
    refused("vertices-more", box.replace("8 6 0", "7 6 0"), "vertex 7", "there are 7")
    refused("vertices-missing", box.replace("8 6 0", "9 6 0"), "ends too early")
    refused("faces-missing", box.replace("8 6 0", "8 7 0"), "ends too early")
    refused("negative-count", box.replace("8 6 0", "-8 6 0"), "-8")
    refused("cut-off", box[:-8], "ends too early")
    read("no-word", box[4:])
    read("no-word-comments", "# a box\n\n" + box[4:])
    refused("other-word", "FFO\n" + box[4:], "OFF")
    refused("small-word", box.lower(), "OFF")
    refused("dimensions", "nOFF\n3\n" + box[4:], "three dimensions")
    refused("dimensions-four", "4nOFF\n3\n" + box[4:], "three dimensions")
    refused("binary", b"OFF BINARY\n\0\0\0\x08\0\0\0\x06\0\0\0\0", "binary")
    refused("index-beyond", box.replace("4 0 2", "4 8 2"), "vertex 8", "there are 8")
    refused("index-negative", box.replace("4 0 2", "4 -1 2"), "vertex -1")
    refused("index-half", box.replace("4 0 2", "4 0.5 2"), "vertex -1")
    refused("count-half", box.replace("8 6 0", "8.5 6 0"), "8.5")
    refused("nan", box.replace("\n1 2 3\n", "\n1 nan 3\n"), "not a finite number")
    refused("comma", box.replace("\n1 2 3\n", "\n1,0 2,0 3,0\n"), "line 10", "1,0")
    refused("ind", box.replace("\n1 2 3\n", "\n1 -1.#IND 3\n"), "line 10", "-1.#IND")
    refused("points-only", "OFF\n8 0 0\n" + vertices(), "no surface")
    refused("utf16", box.encode("utf-16"), "UTF-16")
    refused("open", off().replace("8 6 0", "8 5 0").replace("4 1 3 7 5\n", ""), "open edges")
