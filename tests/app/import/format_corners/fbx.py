import struct
import zlib

from solids import BOX, CONCAVE, STAR, STRAIGHT, TETRAHEDRON, TOUCHING, TWO, png

RED = [1, 0, 0, 1]


class Long(int):
    pass


class Name(str):
    """Of an object: "Model::box" in texts, "box\\0\\1Model" in binary files."""


class Numbers:
    def __init__(self, code, values):
        self.code, self.values = code, list(values)


def text_of(node, depth=0):
    name, properties, children = node
    indent = "\t" * depth
    if properties and isinstance(properties[0], Numbers):
        values = properties[0].values
        numbers = ",".join(repr(v) for v in values)
        return f"{indent}{name}: *{len(values)} {{\n{indent}\ta: {numbers}\n{indent}}}\n"
    words = ",".join(f'"{p}"' if isinstance(p, str) else repr(p) if isinstance(p, float) else str(int(p))
                     for p in properties)  # fmt: skip
    if not children and name not in ("Objects", "Connections"):
        return f"{indent}{name}: {words}\n"
    inner = "".join(text_of(child, depth + 1) for child in children)
    return f"{indent}{name}: {words} {{\n{inner}{indent}}}\n"


def bytes_of_property(value, packed):
    if isinstance(value, Numbers):
        data = struct.pack(f"<{len(value.values)}{value.code}", *value.values)
        content = zlib.compress(data) if packed else data
        return value.code.encode() + struct.pack("<III", len(value.values), int(packed), len(content)) + content
    if isinstance(value, Name):
        kind, _, own = value.partition("::")
        value = f"{own}\0\1{kind}"
    if isinstance(value, str):
        return b"S" + struct.pack("<I", len(value.encode())) + value.encode()
    if isinstance(value, float):
        return b"D" + struct.pack("<d", value)
    return b"L" + struct.pack("<q", value) if isinstance(value, Long) else b"I" + struct.pack("<i", value)


def bytes_of(node, at, packed, wide):
    name, properties, children = node
    head = "<QQQB" if wide else "<IIIB"
    own = b"".join(bytes_of_property(p, packed) for p in properties)
    inner = at + struct.calcsize(head) + len(name) + len(own)
    content = b""
    for child in children:
        content += bytes_of(child, inner + len(content), packed, wide)
    if children:
        content += b"\0" * struct.calcsize(head)
    end = inner + len(content)
    return struct.pack(head, end, len(properties), len(own), len(name)) + name.encode() + own + content


def text(nodes, version=7400):
    return f"; FBX {version // 1000}.{version // 100 % 10}.0 project file\n" + "".join(map(text_of, nodes))


def binary(nodes, version=7400, packed=True):
    out = b"Kaydara FBX Binary  \0\x1a\0" + struct.pack("<I", version)
    for node in nodes:
        out += bytes_of(node, len(out), packed, version >= 7500)
    return out + b"\0" * (25 if version >= 7500 else 13) + b"\xfa\xbc\xab\x09" * 4


def property_of(name, kind, *values):
    label = {"int": "Integer", "double": "Number", "ColorRGB": "Color"}.get(kind, "")
    return ("P", [name, kind, label, "A" if kind.startswith("Lcl") else "", *values], [])


def vector(name, values, kind="Vector3D"):
    return property_of(name, kind, *map(float, values))


def geometry(number, solid=BOX, layers=()):
    corners = [v for face in solid.faces for v in [*face[:-1], -face[-1] - 1]]
    return ("Geometry", [Long(number), Name("Geometry::box"), "Mesh"], [
        ("Vertices", [Numbers("d", [x for p in solid.points for x in p])], []),
        ("PolygonVertexIndex", [Numbers("i", corners)], []),
        ("GeometryVersion", [124], []),
        *layers,
    ])  # fmt: skip


def model(number, *properties, kind="Mesh"):
    return ("Model", [Long(number), Name(f"Model::part{number}"), kind], [
        ("Version", [232], []), ("Properties70", [], list(properties)),
    ])  # fmt: skip


def lcl(translation=None, rotation=None, scaling=None):
    given = (("Translation", translation), ("Rotation", rotation), ("Scaling", scaling))
    return [vector(f"Lcl {name}", v, f"Lcl {name}") for name, v in given if v is not None]


def scene(objects, links, unit=1.0, up=1, version=7400):
    """`links`: pairs of a child and its parent, with a property that it is for where it has three."""
    settings = [
        property_of("UpAxis", "int", up), property_of("UpAxisSign", "int", 1),
        property_of("FrontAxis", "int", 2 if up == 1 else 1),
        property_of("FrontAxisSign", "int", 1 if up == 1 else -1),
        property_of("CoordAxis", "int", 0), property_of("CoordAxisSign", "int", 1),
        property_of("UnitScaleFactor", "double", float(unit)),
    ]  # fmt: skip
    return [
        ("FBXHeaderExtension", [], [("FBXHeaderVersion", [1003], []), ("FBXVersion", [version], [])]),
        ("GlobalSettings", [], [("Version", [1000], []), ("Properties70", [], settings)]),
        ("Definitions", [], [("Version", [100], []), ("Count", [0], [])]),
        ("Objects", [], objects),
        ("Connections", [], [("C", ["OP" if len(k) > 2 else "OO", Long(k[0]), Long(k[1]), *k[2:]], []) for k in links]),
    ]  # fmt: skip


def one(solid=BOX, *properties, layers=(), **options):
    return scene([geometry(1, solid, layers), model(2, *properties)], [(2, 0), (1, 2)], **options)


def add_corners(table):
    add_containers(table)
    add_faces(table)
    add_nodes(table)
    add_deformed(table)
    add_looks(table)


def add_containers(table):
    read, refused = table.of("fbx", "fbx")

    plain = text(one())
    read("text", plain)
    read("bom", "\ufeff" + plain)
    read("crlf", plain.replace("\n", "\r\n"))
    read("blanks", plain.replace("\t", "   ").replace(",", " , "))
    read("comments", plain.replace("Objects:", "; so\nObjects:").replace("Vertices", "; the corners\nVertices"))
    read("wrapped", plain.replace(",", ",\n"))
    for version in (7100, 7200, 7300, 7500, 7700):
        read(f"text-{version}", text(one(version=version), version))
        read(f"binary-{version}", binary(one(version=version), version))
    read("binary", binary(one(), packed=False))
    read("binary-packed", binary(one()))
    for name, factor, unit in (("cm", 1, "cm"), ("inch", 2.54, "in"), ("metre", 100, "m"), ("mm", 0.1, "mm")):
        read(f"unit-{name}", text(one(unit=factor)), unit=unit, up="y")
        read(f"unit-{name}-binary", binary(one(unit=factor)), unit=unit, up="y")
    read("z-up", text(one(up=2)), unit="cm", up="z")
    refused("old", text(one(version=6100), 6100), "version")
    refused("cut-off", plain[: plain.index("PolygonVertexIndex") + 40], "end of file")
    refused("cut-off-binary", binary(one())[:400], "offset")
    refused("no-objects", text(scene([], [])), "no surface")
    refused("not-linked", text(scene([geometry(1), model(2)], [(2, 0)])), "no surface")
    refused("index-beyond", plain.replace("a: 0,2,3,-2", "a: 0,2,8,-2"), "damaged", "line ")
    refused("nan", plain.replace("a: 0.0", "a: nan"), "not a finite number")
    refused("three-numbers", plain.replace("*24 {\n\t\t\ta: 0.0,", "*23 {\n\t\t\ta: ", 1), "damaged", "line ")
    refused("comma", plain.replace(".0,", ",0,").replace(".0\n", ",0\n"), "line ", "48 numbers", "24", "comma")
    refused("no-end-of-face", plain.replace(",-6\n", ",5\n"), "no end")


def add_faces(table):
    for name, solid in (("concave", CONCAVE), ("star", STAR), ("straight", STRAIGHT), ("two", TWO),
                        ("tetrahedron", TETRAHEDRON), ("triangles", BOX.in_triangles())):  # fmt: skip
        table.read(f"fbx/{name}.fbx", text(one(solid)), solid)
        table.read(f"fbx/{name}-binary.fbx", binary(one(solid)), solid)
    lines = text(one()).replace("*24 {\n\t\t\ta: 0,2", "*26 {\n\t\t\ta: 0,-2,0,2")
    table.read("fbx/two-corners.fbx", lines)


def add_nodes(table):
    def read(name, solid, *properties):
        table.read(f"fbx/{name}.fbx", text(one(BOX, *properties)), solid)

    quarter = lambda x, y, z: (-y, x, z)
    read("translation", BOX.moved(1, 2, 3), *lcl((1, 2, 3)))
    read("rotation", BOX.mapped(quarter), *lcl(rotation=(0, 0, 90)))
    read("scaling", BOX.scaled(1, 2, 3), *lcl(scaling=(1, 2, 3)))
    read("mirrored", BOX.scaled(-1, 1, 1), *lcl(scaling=(-1, 1, 1)))
    read("all", BOX.scaled(2, 1, 1).mapped(quarter).moved(5), *lcl((5, 0, 0), (0, 0, 90), (2, 1, 1)))
    # About x, then y, then z.
    turned = BOX.mapped(lambda x, y, z: (x, -z, y)).mapped(lambda x, y, z: (z, y, -x))
    read("rotation-order", turned, *lcl(rotation=(90, 90, 0)))
    active = property_of("RotationActive", "bool", 1)
    backwards = BOX.mapped(lambda x, y, z: (z, y, -x)).mapped(lambda x, y, z: (x, -z, y))
    read("rotation-order-zyx", backwards, active, property_of("RotationOrder", "enum", 5), *lcl(rotation=(90, 90, 0)))
    read("pre-rotation", BOX.mapped(quarter), active, vector("PreRotation", (0, 0, 90)))
    read("post-rotation", BOX.mapped(lambda x, y, z: (y, -x, z)), active, vector("PostRotation", (0, 0, 90)))
    read("rotation-pivot", BOX.moved(-5).mapped(quarter).moved(5), vector("RotationPivot", (5, 0, 0)),
         *lcl(rotation=(0, 0, 90)))  # fmt: skip
    read("rotation-offset", BOX.moved(5), vector("RotationOffset", (5, 0, 0)))
    read("scaling-pivot", BOX.moved(-1).scaled(2).moved(1), vector("ScalingPivot", (1, 0, 0)),
         *lcl(scaling=(2, 2, 2)))  # fmt: skip
    read("geometric-translation", BOX.moved(1, 2, 3), vector("GeometricTranslation", (1, 2, 3)))
    read("geometric-rotation", BOX.mapped(quarter), vector("GeometricRotation", (0, 0, 90)))
    read("geometric-scaling", BOX.scaled(2), vector("GeometricScaling", (2, 2, 2)))
    read("geometric-and-own", BOX.moved(1).scaled(2).moved(0, 5), vector("GeometricTranslation", (1, 0, 0)),
         *lcl((0, 5, 0), None, (2, 2, 2)))  # fmt: skip

    def put(name, solid, objects, links, **facts):
        table.read(f"fbx/{name}.fbx", text(scene(objects, links)), solid, **facts)

    part, away = geometry(1), model(3, *lcl((5, 0, 0)))
    put("nested", BOX.scaled(2).moved(5), [part, model(2, *lcl(scaling=(2, 2, 2))), away], [(3, 0), (2, 3), (1, 2)])
    null = model(3, *lcl((5, 0, 0)), kind="Null")
    put("in-null", BOX.moved(5), [part, model(2), null], [(3, 0), (2, 3), (1, 2)])
    # What a parent has for its own geometry is not handed down.
    parent = model(3, vector("GeometricTranslation", (9, 0, 0)), *lcl((5, 0, 0)), kind="Null")
    put("geometric-of-parent", BOX.moved(5), [part, model(2), parent], [(3, 0), (2, 3), (1, 2)])
    put("instanced", TWO, [part, model(2), away], [(2, 0), (3, 0), (1, 2), (1, 3)])
    put("two-geometries", TWO, [part, geometry(4, BOX.moved(5)), model(2), model(5)],
        [(2, 0), (5, 0), (1, 2), (4, 5)])  # fmt: skip
    halves = text(scene([part, geometry(4, BOX.moved(5)), model(2), model(5)], [(2, 0), (5, 0), (1, 2), (4, 5)]))
    before, corners, behind = halves.rpartition("a: 0,2,3,-2")
    table.read("fbx/half-damaged.fbx", before + corners.replace("3", "8") + behind, remarks=["line "])
    put("number-twice", BOX, [geometry(1, BOX.moved(5)), part, model(2)], [(2, 0), (1, 2)], remarks=["duplicate"])
    touching = model(3, *lcl((1, 0, 0)))
    put("touching", TOUCHING, [part, model(2), touching], [(2, 0), (3, 0), (1, 2), (1, 3)])


def add_deformed(table):
    """The shape is the one without bones and shape keys, which a remark tells."""

    def read(name, word, objects, links):
        table.read(f"fbx/{name}.fbx", text(scene(objects, links)), remarks=[word])
        table.read(f"fbx/{name}-binary.fbx", binary(scene(objects, links)), remarks=[word])

    def matrix(x):
        return Numbers("d", [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, float(x), 0.0, 0.0, 1.0])

    def skinned(bound, moved):
        """A bone that stood at `bound` when it was bound, and stands at `moved` in the scene."""
        bone = model(3, *lcl((moved, 0, 0)), kind="LimbNode")
        skin = ("Deformer", [Long(5), Name("Deformer::s"), "Skin"], [("Version", [101], [])])
        cluster = ("Deformer", [Long(6), Name("SubDeformer::c"), "Cluster"], [
            ("Version", [100], []), ("Indexes", [Numbers("i", range(8))], []),
            ("Weights", [Numbers("d", [1.0] * 8)], []), ("Transform", [matrix(-bound)], []),
            ("TransformLink", [matrix(bound)], []),
        ])  # fmt: skip
        links = [(2, 0), (3, 0), (1, 2), (5, 1), (6, 5), (3, 6)]
        return [geometry(1), model(2), bone, skin, cluster], links

    read("skin", "bones", *skinned(5, 5))
    read("skin-moved", "bones", *skinned(0, 5))

    def morphed(percent):
        shape = ("Geometry", [Long(4), Name("Geometry::high"), "Shape"], [
            ("Version", [100], []), ("Indexes", [Numbers("i", range(4, 8))], []),
            ("Vertices", [Numbers("d", [0.0, 0.0, 3.0] * 4)], []),
            ("Normals", [Numbers("d", [0.0, 0.0, 0.0] * 4)], []),
        ])  # fmt: skip
        blend = ("Deformer", [Long(5), Name("Deformer::b"), "BlendShape"], [("Version", [100], [])])
        channel = ("Deformer", [Long(6), Name("SubDeformer::high"), "BlendShapeChannel"], [
            ("Version", [100], []), ("DeformPercent", [float(percent)], []),
            ("Properties70", [], [property_of("DeformPercent", "Number", float(percent))]),
            ("FullWeights", [Numbers("d", [100.0])], []),
        ])  # fmt: skip
        return [geometry(1), model(2), shape, blend, channel], [(2, 0), (1, 2), (5, 1), (6, 5), (4, 6)]

    read("morph-none", "shape keys", *morphed(0))
    read("morph", "shape keys", *morphed(100))


def layer(kind, values, mapping="ByPolygonVertex", name=None, extra=()):
    return (f"LayerElement{kind}", [0], [
        ("Version", [101], []), ("Name", [""], []), ("MappingInformationType", [mapping], []),
        ("ReferenceInformationType", ["IndexToDirect" if extra else "Direct"], []),
        (name, [values], []), *extra,
    ])  # fmt: skip


def layers_of(*kinds):
    parts = [("LayerElement", [], [("Type", [f"LayerElement{k}"], []), ("TypedIndex", [0], [])]) for k in kinds]
    return ("Layer", [0], [("Version", [100], []), *parts])


def add_looks(table):
    def read(name, nodes, **facts):
        table.read(f"fbx/{name}.fbx", text(nodes), BOX, **facts)
        table.read(f"fbx/{name}-binary.fbx", binary(nodes), BOX, **facts)

    colors = layer("Color", Numbers("d", [1.0, 0.0, 0.0, 1.0] * 24), name="Colors")
    read("colors", one(layers=[colors, layers_of("Color")]), colors=[RED])
    material = ("Material", [Long(7), Name("Material::red"), ""], [
        ("Version", [102], []), ("ShadingModel", ["lambert"], []), ("MultiLayer", [0], []),
        ("Properties70", [], [property_of("DiffuseColor", "ColorRGB", 1.0, 0.0, 0.0)]),
    ])  # fmt: skip
    same = layer("Material", Numbers("i", [0]), "AllSame", "Materials")
    links = [(2, 0), (1, 2), (7, 2)]
    read("material", scene([geometry(1, BOX, [same, layers_of("Material")]), model(2), material], links),
         materials={"red": RED})  # fmt: skip
    table.beside("fbx/red.png", png(255, 0, 0))
    for name, file in (("picture", "red.png"), ("picture-missing", "gone.png")):
        texture = ("Texture", [Long(8), Name("Texture::t"), ""], [
            ("Type", ["TextureVideoClip"], []), ("Version", [202], []),
            ("FileName", [f"C:\\work\\{file}"], []), ("RelativeFilename", [file], []),
        ])  # fmt: skip
        uvs = layer("UV", Numbers("d", [0.25, 0.75] * 24), name="UV")
        part = geometry(1, BOX, [same, uvs, layers_of("Material", "UV")])
        found = {"images": 1, "uvs": [[0.25, 0.75]]}
        facts = found if name == "picture" else {"images": 0, "remarks": [file]}
        read(name, scene([part, model(2), material, texture], [*links, (8, 7, "DiffuseColor")]), **facts)
