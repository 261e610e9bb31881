from solids import BOX, CONCAVE, STAR, STRAIGHT, TETRAHEDRON, TOUCHING, TWO, png, row

RED = [1, 0, 0, 1]
NODE = '<node id="n"><instance_geometry url="#g"/></node>'
UNIT = '<unit name="metre" meter="1"/>'


def source(name, items, params="XYZ", stride=None, offset=0):
    stride = stride or len(params)
    named = "".join(f'<param name="{p}" type="float"/>' for p in params)
    skip = f' offset="{offset}"' if offset else ""
    count = sum(map(len, items))
    numbers = " ".join(["9"] * offset + [row(i) for i in items])
    return (
        f'<source id="{name}"><float_array id="{name}-a" count="{count + offset}">{numbers}</float_array>'
        f'<technique_common><accessor source="#{name}-a" count="{len(items)}" stride="{stride}"{skip}>'
        f"{named}</accessor></technique_common></source>"
    )


VERTEX = '<input semantic="VERTEX" source="#v" offset="0"/>'


def polylist(solid, inputs=VERTEX, corner="{0}", more=""):
    sizes = " ".join(str(len(f)) for f in solid.faces)
    corners = " ".join(corner.format(v) for f in solid.faces for v in f)
    return (
        f'<polylist count="{len(solid.faces)}"{more}>{inputs}<vcount>{sizes}</vcount><p>{corners}</p></polylist>'
    )


def triangles(solid, kind="triangles"):
    corners = " ".join(row(t) for t in solid.triangles())
    return f'<{kind} count="{len(solid.triangles())}">{VERTEX}<p>{corners}</p></{kind}>'


def of_lists(kind, lists):
    return f'<{kind} count="{len(lists)}">{VERTEX}' + "".join(f"<p>{row(c)}</p>" for c in lists) + f"</{kind}>"


def geometry(solid=BOX, faces=None, name="g", sources="", places=None, vertices=""):
    places = source("s", solid.points) if places is None else places
    return (
        f'<geometry id="{name}" name="{name}"><mesh>{places}{sources}<vertices id="v">'
        f'<input semantic="POSITION" source="#s"/>{vertices}</vertices>{faces or polylist(solid)}</mesh></geometry>'
    )


def dae(geometries=None, nodes=NODE, unit=UNIT, up="Y_UP", libraries="", version="1.4.1", scene="#scene"):
    geometries = geometry() if geometries is None else geometries
    axis = f"<up_axis>{up}</up_axis>" if up else ""
    shown = f'<scene><instance_visual_scene url="{scene}"/></scene>' if scene else ""
    return (
        f'<?xml version="1.0" encoding="utf-8"?>\n<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" '
        f'version="{version}">\n<asset><created>2026-01-01</created>{unit}{axis}</asset>\n{libraries}\n'
        f"<library_geometries>{geometries}</library_geometries>\n<library_visual_scenes>"
        f'<visual_scene id="scene" name="scene">{nodes}</visual_scene></library_visual_scenes>\n{shown}</COLLADA>\n'
    )


def add_corners(table):
    read, refused = table.of("dae", "dae")

    plain = dae()
    read("plain", plain)
    read("bom", "\ufeff" + plain)
    read("crlf", plain.replace("\n", "\r\n"))
    read("spread", plain.replace(" 0 ", "\n\t0\n\t").replace("><", ">\n  <"))
    read("comments", plain.replace("<mesh>", "<mesh><!-- a <mesh> -->"))
    read("no-namespace", plain.replace(' xmlns="http://www.collada.org/2005/11/COLLADASchema"', ""))
    read("version-1.4.0", dae(version="1.4.0"))
    read("version-1.5.0", dae(version="1.5.0"))
    read("numbers", plain.replace("1 2 3</float", "+1.0 .2e1 3.E0</float"))
    read("triangles", dae(geometry(faces=triangles(BOX))))
    read("polygons", dae(geometry(faces=of_lists("polygons", BOX.faces))))
    strip = [0, 2, 1, 3, 5, 7, 4, 6, 0, 2]
    caps = [[0, 1, 5], [0, 5, 4], [2, 6, 7], [2, 7, 3]]
    read("strips", dae(geometry(faces=of_lists("tristrips", [strip, *caps]))))
    read("fans", dae(geometry(faces=of_lists("trifans", BOX.faces))))
    hole = f'<polygons count="1">{VERTEX}<ph><p>0 2 3 1</p><h>4 5 7 6</h></ph></polygons>'
    refused("crossing-hole", dae(geometry(faces=hole + polylist(type(BOX)(BOX.points, BOX.faces[1:])))), "crosses its outline")
    add_holes(read)
    lines = f'<lines count="1">{VERTEX}<p>0 7</p></lines>'
    read("lines", dae(geometry(faces=lines + polylist(BOX))))
    for name, solid in (("concave", CONCAVE), ("star", STAR), ("straight", STRAIGHT), ("two", TWO),
                        ("tetrahedron", TETRAHEDRON)):  # fmt: skip
        read(name, dae(geometry(solid)), solid)
    read("split", dae(geometry(faces=polylist(type(BOX)(BOX.points, BOX.faces[:3]))
                               + polylist(type(BOX)(BOX.points, BOX.faces[3:])))))  # fmt: skip
    lost = NODE + '<node id="m"><instance_geometry url="#h"/></node>'
    read("part-missing", dae(nodes=lost), remarks=["Unable to find geometry"])
    add_units(read)
    add_nodes(read)
    add_sources(read, refused)
    add_deformed(read, refused)
    add_looks(table, read)
    refused("cut-off", plain[: plain.index("</polylist>")], "line 5: its XML is broken")
    refused("deep", plain.replace("<asset>", "<a>" * 600 + "</a>" * 600 + "<asset>"), "500 deep")
    refused("no-scene", dae(scene=None), "empty")
    refused("empty", dae("", nodes=""), "no surface")
    refused("not-collada", "<html><body/></html>", "Collada")
    for coding in ("utf-16", "utf-16-le", "utf-16-be", "utf-32"):
        read(coding, plain.replace("utf-8", "utf-16").encode(coding))


def add_holes(read):
    """A plate with square bores."""
    square = lambda x, y, size: [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]
    for bores in (1, 3):
        loops = [[(0, 0), (3 * bores, 0), (3 * bores, 3), (0, 3)]]
        loops += [square(3 * i + 1, 1, 1)[::-1] for i in range(bores)]
        corners = [p for loop in loops for p in loop]
        count = len(corners)
        points = [(x, y, z) for z in (0, 1) for x, y in corners]
        quads = [[4 * l + i, 4 * l + (i + 1) % 4] for l in range(len(loops)) for i in range(4)]
        sides = BOX.__class__(points, [[a, b, b + count, a + count] for a, b in quads])
        facts = {"volume": 8 * bores, "triangles": 2 * len(sides.faces) + 2 * (count + 2 * bores - 2)}
        for name, turn in (("", 1), ("-turned", -1)):  # the holes either way round
            tops = [[[z * count + 4 * l + i for i in range(4)] for l in range(len(loops))] for z in (0, 1)]
            tops[0] = [loop[::-1] for loop in tops[0]]
            holes = "".join(
                f"<ph><p>{row(top[0])}</p>" + "".join(f"<h>{row(h[::turn])}</h>" for h in top[1:]) + "</ph>"
                for top in tops
            )
            faces = f'<polygons count="2">{VERTEX}{holes}</polygons>'
            read(f"bores-{bores}{name}", dae(geometry(sides, faces + polylist(sides))), sides, **facts)


def add_units(read):
    flat = BOX.mapped(lambda x, y, z: (x, z, -y))
    cm = '<unit name="centimeter" meter="0.01"/>'
    read("unit-cm", dae(unit=cm), BOX.scaled(0.01), unit="m", up="y")
    read("unit-inch", dae(unit='<unit meter="0.0254" name="inch"/>'), BOX.scaled(0.0254), unit="m")
    read("unit-named-alone", dae(unit='<unit name="meter"/>'), unit="m")
    read("no-unit", dae(unit=""), unit="m")
    read("no-axis", dae(up=None), up="y")
    read("z-up", dae(up="Z_UP"), flat, up="y")
    read("x-up", dae(up="X_UP"), BOX.mapped(lambda x, y, z: (-y, x, z)), up="y")
    read("z-up-cm", dae(up="Z_UP", unit=cm), flat.scaled(0.01), unit="m", up="y")
    away = NODE.replace('id="n">', 'id="n"><translate>0 0 5</translate>')
    read("z-up-moved", dae(up="Z_UP", nodes=away), BOX.moved(0, 0, 5).mapped(lambda x, y, z: (x, z, -y)))


def add_nodes(read):
    def node(transforms, inside='<instance_geometry url="#g"/>', name="n"):
        return f'<node id="{name}">{transforms}{inside}</node>'

    quarter = lambda x, y, z: (-y, x, z)
    move, turn, grow = "<translate>5 0 0</translate>", "<rotate>0 0 1 90</rotate>", "<scale>2 1 1</scale>"
    read("translate", dae(nodes=node(move)), BOX.moved(5))
    read("rotate", dae(nodes=node(turn)), BOX.mapped(quarter))
    read("scale", dae(nodes=node(grow)), BOX.scaled(2, 1, 1))
    read("mirrored", dae(nodes=node("<scale>-1 1 1</scale>")), BOX.scaled(-1, 1, 1))
    read("all", dae(nodes=node(move + turn + grow)), BOX.scaled(2, 1, 1).mapped(quarter).moved(5))
    read("other-order", dae(nodes=node(grow + move)), BOX.moved(5).scaled(2, 1, 1))
    read("matrix", dae(nodes=node("<matrix>0 -1 0 5 1 0 0 6 0 0 1 7 0 0 0 1</matrix>")),
         BOX.mapped(quarter).moved(5, 6, 7))  # fmt: skip
    read("nested", dae(nodes=node(move, node(grow), "m")), BOX.scaled(2, 1, 1).moved(5))
    read("instanced", dae(nodes=NODE + node(move, name="m")), TWO)
    read("instanced-in-node", dae(nodes=node("", NODE + node(move, name="m"), "o")), TWO)
    part = NODE.replace("n\"", "part\"", 1)
    library = f"<library_nodes>{part}</library_nodes>"
    inside = '<instance_node url="#part"/>'
    read("instance-node", dae(libraries=library, nodes=node("", inside, "a") + node(move, inside, "b")), TWO)
    read("touching", dae(nodes=NODE + node("<translate>1 0 0</translate>", name="m")), TOUCHING)
    other = f'<visual_scene id="other"><node id="x"><scale>9 9 9</scale>{NODE}</node></visual_scene>'
    read("scene-chosen", dae().replace("<library_visual_scenes>", "<library_visual_scenes>" + other))
    read("not-in-scene", dae(geometry() + geometry(BOX.scaled(9), name="h").replace('"s"', '"s2"').replace(
        '"#s"', '"#s2"').replace('"v"', '"v2"').replace('"#v"', '"#v2"').replace('"s-a"', '"s2-a"').replace(
        '"#s-a"', '"#s2-a"')))  # fmt: skip


def add_sources(read, refused):
    padded = [(*p, 1) for p in BOX.points]
    read("stride-4", dae(geometry(places=source("s", padded, "XYZW"))))
    read("stride-4-unnamed", dae(geometry(places=source("s", padded, "XYZ", stride=4))))
    read("offset", dae(geometry(places=source("s", BOX.points, offset=3))))
    normals = source("n", [(0, 0, 1)])
    with_normals = VERTEX + '<input semantic="NORMAL" source="#n" offset="1"/>'
    read("normals", dae(geometry(faces=polylist(BOX, with_normals, "{0} 0"), sources=normals)))
    swapped = with_normals.replace('offset="0"', 'offset="2"')
    read("offsets-swapped", dae(geometry(faces=polylist(BOX, swapped, "7 0 {0}"), sources=normals)))
    plain = dae()
    refused("index-beyond", plain.replace("<p>0 2 3", "<p>0 8 3"), "index (8/8)")
    refused("index-negative", plain.replace("<p>0 2 3", "<p>0 -1 3"), "open edges")
    refused("source-missing", plain.replace('source="#s"', 'source="#t"'), '"t"')
    refused("array-short", plain.replace("1 2 3</float", "1 2</float"), "float_array")
    refused("vcount-long", plain.replace("<vcount>4", "<vcount>5"), "<p>")
    refused("corners-missing", plain.replace(" 7 5</p>", "</p>"), "<p>")
    refused("nan", plain.replace("1 2 3</float", "1 nan 3</float"), "not a finite number")
    read("comma", plain.replace("1 2 3</float", "1,0 2,0 3,0</float"))
    refused("ind", plain.replace("1 2 3</float", "1 -1.#IND 3</float"), "#IND")
    refused("geometry-missing", plain.replace('url="#g"', 'url="#h"'), "geometry", '"h"')


def add_looks(table, read):
    effect = (
        '<library_effects><effect id="e"><profile_COMMON>{}<technique sid="c"><lambert><diffuse>{}</diffuse>'
        "</lambert></technique></profile_COMMON></effect></library_effects>"
        '<library_materials><material id="m" name="red"><instance_effect url="#e"/></material></library_materials>'
    )
    bound = NODE.replace("/></node>", "><bind_material><technique_common><instance_material symbol=\"m\" "
                         "target=\"#m\"/></technique_common></bind_material></instance_geometry></node>")  # fmt: skip
    red = effect.format("", "<color>1 0 0 1</color>")
    faces = polylist(BOX, more=' material="m"')
    read("material", dae(geometry(faces=faces), bound, libraries=red), materials={"red": RED})
    for name, blanks in (("blank", " "), ("tab", "\t"), ("line", "\n"), ("crlf", "\r\n\t"), ("lines", "\n\n ")):
        spread = red.replace("<color>", f"<color>{blanks}").replace("0 0", f"0{blanks}0")
        read(f"color-{name}", dae(geometry(faces=faces), bound, libraries=spread), materials={"red": RED})
    colors = source("c", [(1, 0, 0)] * 8, "RGB")
    read("colors", dae(geometry(sources=colors, vertices='<input semantic="COLOR" source="#c"/>')), colors=[RED])
    table.beside("dae/red.png", png(255, 0, 0))
    uvs = source("t", [(0.25, 0.75)], "ST")
    inputs = VERTEX + '<input semantic="TEXCOORD" source="#t" offset="1" set="0"/>'
    textured = geometry(faces=polylist(BOX, inputs, "{0} 0", ' material="m"'), sources=uvs)
    for name, file in (("picture", "red.png"), ("picture-missing", "gone.png"), ("picture-blank", "a%20red.png")):
        images = f'<library_images><image id="i"><init_from>{file}</init_from></image></library_images>'
        own = effect.format('<newparam sid="p"><surface type="2D"><init_from>i</init_from></surface></newparam>'
                            '<newparam sid="q"><sampler2D><source>p</source></sampler2D></newparam>',
                            '<texture texture="q" texcoord="u"/>')  # fmt: skip
        found = {"images": 1, "uvs": [[0.25, 0.75]]}
        facts = {"images": 0, "remarks": [file]} if "missing" in name else found
        read(name, dae(textured, bound, libraries=images + own), **facts)
    table.beside("dae/a red.png", png(255, 0, 0))


def add_deformed(read, refused):
    """The shape is the one without bones, which a remark tells."""

    def names(name, items):
        return (
            f'<source id="{name}"><Name_array id="{name}-a" count="{len(items)}">{" ".join(items)}</Name_array>'
            f'<technique_common><accessor source="#{name}-a" count="{len(items)}" stride="1">'
            f'<param name="JOINT" type="name"/></accessor></technique_common></source>'
        )

    def matrix(x):
        return (1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)

    def skinned(joint=0, inverse=0, shape=0):
        binds = source("ib", [matrix(inverse)], ["TRANSFORM"], 16).replace('"float"', '"float4x4"')
        weights = " ".join(["1 0 0"] * 8)
        skin = (
            f'<controller id="c"><skin source="#g"><bind_shape_matrix>{row(matrix(shape))}</bind_shape_matrix>'
            f'{names("j", ["b"])}{binds}{source("w", [(1,)], ["WEIGHT"])}<joints>'
            '<input semantic="JOINT" source="#j"/><input semantic="INV_BIND_MATRIX" source="#ib"/></joints>'
            '<vertex_weights count="8"><input semantic="JOINT" source="#j" offset="0"/>'
            '<input semantic="WEIGHT" source="#w" offset="1"/><vcount>1 1 1 1 1 1 1 1</vcount>'
            f'<v>{" ".join(["0 0"] * 8)}</v></vertex_weights></skin></controller>'
        )
        nodes = (
            f'<node id="bone" sid="b" type="JOINT"><translate>{joint} 0 0</translate></node>'
            '<node id="n"><instance_controller url="#c"><skeleton>#bone</skeleton></instance_controller></node>'
        )
        return dae(nodes=nodes, libraries=f"<library_controllers>{skin}</library_controllers>")

    read("skin", skinned(), remarks=["bones"])
    read("skin-bound", skinned(5, -5), remarks=["bones"])
    read("skin-moved", skinned(5), remarks=["bones"])
    read("skin-shape", skinned(0, 0, 5), remarks=["bones"])
    refused("bones-only", dae("", nodes='<node type="JOINT"><node type="JOINT"><translate>0 1 0</translate></node></node>'),
            "no surface")  # fmt: skip

    def morphed(weight):
        targets = names("mt", ["h"]).replace("Name_array", "IDREF_array")
        morph = (
            f'<controller id="c"><morph source="#g" method="NORMALIZED">{targets}'
            f'{source("mw", [(weight,)], ["MORPH_WEIGHT"])}<targets><input semantic="MORPH_TARGET" source="#mt"/>'
            '<input semantic="MORPH_WEIGHT" source="#mw"/></targets></morph></controller>'
        )
        other = geometry(BOX.scaled(1, 1, 2), name="h")
        for name in ("s", "s-a", "v"):
            other = other.replace(f'"{name}"', f'"{name}2"').replace(f'"#{name}"', f'"#{name}2"')
        nodes = '<node id="n"><instance_controller url="#c"/></node>'
        return dae(geometry() + other, nodes, libraries=f"<library_controllers>{morph}</library_controllers>")

    refused("morph", morphed(1), "geometry", '"c"')
