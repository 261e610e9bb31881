import struct

from solids import BOX, TETRAHEDRON, TOUCHING, TWO, png


def chunk(kind, *parts):
    content = b"".join(parts)
    return struct.pack("<HI", kind, 6 + len(content)) + content


def named(name):
    return name.encode("latin-1") + b"\0"


def mesh(solid=BOX, name="box", uvs=None, matrix=None, faces_more=b"", count=None):
    own = solid.triangles()
    points = struct.pack("<H", len(solid.points) if count is None else count)
    points += b"".join(struct.pack("<3f", *p) for p in solid.points)
    faces = struct.pack("<H", len(own)) + b"".join(struct.pack("<4H", *t, 7) for t in own)
    parts = [chunk(0x4110, points)]
    if uvs:
        parts.append(chunk(0x4140, struct.pack("<H", len(uvs)), *(struct.pack("<2f", *u) for u in uvs)))
    if matrix:
        parts.append(chunk(0x4160, struct.pack("<12f", *matrix)))
    parts.append(chunk(0x4120, faces, faces_more))
    return chunk(0x4000, named(name), chunk(0x4100, *parts))


def threeds(*editor, keys=b""):
    version = chunk(0x0002, struct.pack("<I", 3))
    return chunk(0x4D4D, version, chunk(0x3D3D, chunk(0x3D3E, struct.pack("<I", 3)), *editor), keys)


def track(kind, *values):
    """Of one key."""
    form = f"<HIIIIH{len(values)}f"
    return chunk(kind, struct.pack(form, 0, 0, 0, 1, 0, 0, *values))


def keyframer(*nodes):
    return chunk(0xB000, chunk(0xB00A, struct.pack("<H", 5), named("MAXSCENE"), struct.pack("<I", 100)), *nodes)


def key_node(name, pivot=(0, 0, 0), position=(0, 0, 0), scale=(1, 1, 1), number=0, parent=-1):
    return chunk(
        0xB002,
        chunk(0xB030, struct.pack("<H", number)),
        chunk(0xB010, named(name), struct.pack("<HHh", 0, 0, parent)),
        chunk(0xB013, struct.pack("<3f", *pivot)),
        track(0xB020, *position),
        track(0xB021, 0, 0, 0, 1),
        track(0xB022, *scale),
    )


def add_corners(table):
    def read(name, content, solid=BOX, **facts):
        """Files are z up, and read as y up."""
        table.read(f"3ds/{name}.3ds", content, solid.mapped(lambda x, y, z: (x, z, -y)), **facts)

    def refused(name, content, *words):
        table.refused(f"3ds/{name}.3ds", content, *words)

    plain = threeds(mesh())
    read("plain", plain)
    read("tetrahedron", threeds(mesh(TETRAHEDRON)), TETRAHEDRON)
    read("two-shells", threeds(mesh(TWO)), TWO)
    read("two", threeds(mesh(), mesh(BOX.moved(5), "other")), TWO)
    read("touching", threeds(mesh(), mesh(BOX.moved(1), "other")), TOUCHING)
    read("inside-out", threeds(mesh(BOX.turned())))
    read("umlaut", threeds(mesh(name="k\xe4stchen")))
    read("unnamed", threeds(mesh(name="")))
    read("unknown-chunks", threeds(chunk(0x7777, b"what?"), mesh(), chunk(0x1400, struct.pack("<f", 1))))
    read("smoothing", threeds(mesh(faces_more=chunk(0x4150, struct.pack("<12I", *[1] * 12)))))
    light = chunk(0x4000, named("lamp"), chunk(0x4600, struct.pack("<3f", 9, 9, 9)))
    camera = chunk(0x4000, named("eye"), chunk(0x4700, struct.pack("<8f", 9, 9, 9, 0, 0, 0, 0, 50)))
    read("lamp-camera", threeds(light, mesh(), camera))
    unit = (1, 0, 0, 0, 1, 0, 0, 0, 1)
    read("matrix", threeds(mesh(BOX.moved(5), matrix=(*unit, 5, 0, 0))), BOX.moved(5))
    turned = (0, 1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0)
    read("matrix-turned", threeds(mesh(matrix=turned)))
    own = mesh(BOX.moved(5), matrix=(*unit, 5, 0, 0))
    read("keys", threeds(own, keys=keyframer(key_node("box", position=(5, 0, 0)))), BOX.moved(5))
    read("keys-moved", threeds(own, keys=keyframer(key_node("box", position=(7, 0, 0)))), BOX.moved(7))
    read("keys-pivot", threeds(own, keys=keyframer(key_node("box", (1, 0, 0), (6, 0, 0)))), BOX.moved(5))
    read("keys-scaled", threeds(mesh(), keys=keyframer(key_node("box", scale=(2, 2, 2)))), BOX.scaled(2))
    family = keyframer(key_node("box", number=0), key_node("other", position=(5, 0, 0), number=1, parent=0))
    read("keys-nested", threeds(mesh(), mesh(name="other"), keys=family), TWO)
    add_looks(table, read)
    refused("cut-off", plain[:-40], "Chunk is too large")
    refused("cut-off-in-points", plain[:80], "Chunk is too large")
    refused("count-large", threeds(mesh(count=9)), "End of file")
    beyond = mesh(BOX).replace(struct.pack("<4H", 0, 2, 3, 7), struct.pack("<4H", 0, 8, 3, 7))
    refused("index-beyond", threeds(beyond), "open edges")
    refused("no-mesh", threeds(light), "no surface")
    refused("nan", threeds(mesh(BOX.mapped(lambda x, y, z: (float("nan") if x else x, y, z)))), "not a finite number")
    refused("bytes-behind", plain + b"\0" * 20, "Chunk is too large")
    refused("not-3ds", b"MM" + b"\xff" * 40, "Chunk is too large")


def add_looks(table, read):
    def material(*more):
        return chunk(0xAFFF, chunk(0xA000, named("red")), chunk(0xA020, chunk(0x0011, b"\xff\0\0")), *more)

    used = chunk(0x4130, named("red"), struct.pack("<H12H", 12, *range(12)))
    read("material", threeds(material(), mesh(faces_more=used)), materials={"red": [1, 0, 0, 1]})
    half = struct.pack("<H6H", 6, *range(6))
    some = chunk(0x4130, named("red"), half)
    read("material-some", threeds(material(), mesh(faces_more=some)), materials={"red": [1, 0, 0, 1]})
    table.beside("3ds/red.png", png(255, 0, 0))
    uvs = [(0.25, 0.75)] * 8
    for name, file in (("picture", "red.png"), ("picture-missing", "gone.png")):
        picture = chunk(0xA200, chunk(0x0030, struct.pack("<H", 100)), chunk(0xA300, named(file)))
        found = {"images": 1, "uvs": [[0.25, 0.75]]}
        facts = {"images": 0, "remarks": [file]} if "missing" in name else found
        read(name, threeds(material(picture), mesh(uvs=uvs, faces_more=used)), **facts)
