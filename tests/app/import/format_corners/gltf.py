import base64
import copy
import json
import math
import struct
import urllib.parse

from solids import BOX, TETRAHEDRON, TOUCHING, TWO, png

BYTE, UBYTE, SHORT, USHORT, UINT, FLOAT, DOUBLE = 5120, 5121, 5122, 5123, 5125, 5126, 5130
CODES = {BYTE: "b", UBYTE: "B", SHORT: "h", USHORT: "H", UINT: "I", FLOAT: "f", DOUBLE: "d"}
WIDTHS = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
RED = [1, 0, 0, 1]


class Gltf:
    """A scene of one node with one mesh of one primitive, to be added to."""

    def __init__(self, solid=BOX, indices=USHORT, places=FLOAT, indexed=True, **options):
        self.bytes = b""
        self.json = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {}}]}],
            "accessors": [],
            "bufferViews": [],
        }
        corners = [v for t in solid.triangles() for v in t]
        points = solid.points if indexed else [solid.points[v] for v in corners]
        self.attributes["POSITION"] = self.add(points, places, **options)
        if indexed:
            self.primitive["indices"] = self.add([[v] for v in corners], indices)

    @property
    def primitive(self):
        return self.json["meshes"][0]["primitives"][0]

    @property
    def attributes(self):
        return self.primitive["attributes"]

    @property
    def node(self):
        return self.json["nodes"][0]

    def view(self, data, **more):
        self.bytes += b"\0" * (-len(self.bytes) % 8)
        self.json["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data), **more}
        )
        self.bytes += data
        return len(self.json["bufferViews"]) - 1

    def add(self, items, kind=FLOAT, pad=0, skip=0, normalized=False):
        """Each item with `pad` bytes behind it, the first one behind `skip` bytes."""
        width = len(items[0])
        whole = (lambda n: n) if kind in (FLOAT, DOUBLE) else int
        form = "<" + CODES[kind] * width
        own = b"".join(struct.pack(form, *map(whole, i)) + b"\x7f" * pad for i in items)
        size = struct.calcsize(CODES[kind]) * width + pad
        accessor = {
            "bufferView": self.view(b"\x7f" * skip + own, **({"byteStride": size} if pad else {})),
            "componentType": kind,
            "count": len(items),
            "type": WIDTHS[width],
        }
        if skip:
            accessor["byteOffset"] = skip
        if normalized:
            accessor["normalized"] = True
        self.json["accessors"].append(accessor)
        return len(self.json["accessors"]) - 1

    def set(self, **keys):
        self.json.update(keys)
        return self

    def put(self, **keys):
        self.node.update(keys)
        return self

    def gltf(self, uri=None, length=None):
        data = "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode()
        length = len(self.bytes) if length is None else length
        self.json["buffers"] = [{"uri": data if uri is None else uri, "byteLength": length}]
        return json.dumps(self.json)

    def glb(self, version=2, padding=b" ", length=None, behind=b""):
        self.json["buffers"] = [{"byteLength": len(self.bytes)}]
        text = json.dumps(self.json).encode()
        text += padding * (4 - len(text) % 4)
        self.bytes += b"\0" * (-len(self.bytes) % 4) if padding else b""
        chunks = struct.pack("<I4s", len(text), b"JSON") + text
        chunks += struct.pack("<I4s", len(self.bytes), b"BIN\0") + self.bytes + behind
        total = 12 + len(chunks) if length is None else length
        return struct.pack("<4sII", b"glTF", version, total) + chunks


def add_corners(table):
    add_containers(table)
    add_numbers(table)
    add_scenes(table)
    add_deformed(table)
    add_extensions(table)
    add_looks(table)


def add_containers(table):
    def read(name, content, **facts):
        table.read(f"gltf/{name}", content, BOX, **facts)

    def refused(name, content, *words):
        table.refused(f"gltf/{name}", content, *words)

    read("plain.gltf", Gltf().gltf())
    read("plain.glb", Gltf().glb())
    read("bom.gltf", "\ufeff" + Gltf().gltf())
    read("crlf.gltf", json.dumps(json.loads(Gltf().gltf()), indent=1).replace("\n", "\r\n"))
    read("text.glb", Gltf().gltf())
    read("binary.gltf", Gltf().glb())
    read("unpadded.glb", Gltf().glb(padding=b""))
    read("padded-zeros.glb", Gltf().glb(padding=b"\0"))
    read("length-short.glb", Gltf().glb(length=12))
    read("length-long.glb", Gltf().glb(length=10**6))
    read("more-chunks.glb", Gltf().glb(behind=struct.pack("<I4s", 4, b"ABCD") + b"1234"))
    for name, uri in (("buffer.bin", "buffer.bin"), ("a buffer.bin", "a%20buffer.bin"),
                      ("a buffer.bin", "a buffer.bin"), ("büffer.bin", urllib.parse.quote("büffer.bin")),
                      ("büffer.bin", "büffer.bin"), ("below/deep.bin", "below/deep.bin"),
                      ("buffer.bin", "./buffer.bin")):  # fmt: skip
        own = Gltf()
        table.beside(f"gltf/{name}", own.bytes)
        read(f"uri-{uri.replace('/', '-').replace('%', '')}.gltf", own.gltf(uri))
    plain = Gltf()
    escaped = "data:application/octet-stream," + urllib.parse.quote(plain.bytes)
    read("data-escaped.gltf", plain.gltf(escaped))
    read("data-no-type.gltf", Gltf().gltf().replace("data:application/octet-stream;", "data:;"))
    refused("uri-missing.gltf", Gltf().gltf("nowhere.bin"), "nowhere.bin")
    table.beside("outside.bin", Gltf().bytes)
    refused("uri-outside.gltf", Gltf().gltf("../outside.bin"), "outside.bin")
    table.beside("gltf/short.bin", Gltf().bytes[:-10])
    refused("uri-short.gltf", Gltf().gltf("short.bin"), "ends within")
    refused("data-short.gltf", Gltf().gltf().replace("=", "").replace('"}', '"}')[:-200], "JSON")
    refused("no-buffers.gltf", json.dumps(Gltf().json), "buffer")
    refused("version-1.glb", Gltf().glb(version=1), "version 1")
    refused("version-1.gltf", json.dumps({"asset": {"version": "1.0"}, "meshes": {"a": {}}, "scene": "s",
                                          "scenes": {"s": {"nodes": ["n"]}}}), "version 1")  # fmt: skip
    refused("cut-off.glb", Gltf().glb()[:-10], "ends within")
    refused("head-only.glb", Gltf().glb()[:12], "JSON")
    refused("comments.gltf", "// why\n" + Gltf().gltf(), "JSON")
    refused("empty.gltf", json.dumps({"asset": {"version": "2.0"}}), "no surface")
    refused("utf16.gltf", Gltf().gltf().encode("utf-16"), "UTF-16")


def add_numbers(table):
    def read(name, own, solid=BOX, **facts):
        table.read(f"gltf/{name}.gltf", own.gltf(), solid, **facts)

    def refused(name, own, *words):
        table.refused(f"gltf/{name}.gltf", own.gltf(), *words)

    for kind in (UBYTE, USHORT, UINT):
        read(f"indices-{CODES[kind]}", Gltf(indices=kind))
    need = {"extensionsRequired": ["KHR_mesh_quantization"], "extensionsUsed": ["KHR_mesh_quantization"]}
    for kind, most in ((BYTE, 127), (UBYTE, 255), (SHORT, 32767), (USHORT, 65535)):
        pad = 4 - (3 * struct.calcsize(CODES[kind])) % 4
        raw = Gltf(places=kind, pad=pad).set(**need)
        read(f"quantized-{CODES[kind]}", raw)
        shares = [(x * most, y * most / 2, z * most / 3) for x, y, z in BOX.points]
        own = Gltf().set(**need).put(scale=[1, 2, 3])
        own.attributes["POSITION"] = own.add(shares, kind, pad=pad, normalized=True)
        read(f"normalized-{CODES[kind]}", own)
    read("stride", Gltf(pad=20))
    read("offset", Gltf(skip=16))
    read("stride-offset", Gltf(pad=4, skip=8))
    read("not-indexed", Gltf(indexed=False))
    interleaved = Gltf()
    data = b"".join(struct.pack("<6f", *p, 0, 0, 1) for p in BOX.points)
    view = interleaved.view(data, byteStride=24)
    for name, at in (("POSITION", 0), ("NORMAL", 12)):
        interleaved.json["accessors"].append(
            {"bufferView": view, "byteOffset": at, "componentType": FLOAT, "count": 8, "type": "VEC3"}
        )
        interleaved.attributes[name] = len(interleaved.json["accessors"]) - 1
    read("interleaved", interleaved)
    for name, base in (("sparse", True), ("sparse-zeros", False)):
        own = Gltf(BOX.mapped(lambda x, y, z: (x, y, z if base else 0)))
        accessor = own.json["accessors"][0]
        chosen = [4, 5, 6, 7] if base else list(range(8))
        where = own.view(struct.pack(f"<{len(chosen)}H", *chosen))
        points = BOX.scaled(1, 1, 2).points if base else BOX.points
        what = own.view(b"".join(struct.pack("<3f", *points[v]) for v in chosen))
        accessor["sparse"] = {"count": len(chosen), "values": {"bufferView": what},
                              "indices": {"bufferView": where, "componentType": USHORT}}  # fmt: skip
        if not base:
            del accessor["bufferView"]
        read(name, own, BOX.scaled(1, 1, 2) if base else BOX)
    strip = [0, 2, 1, 3, 5, 7, 4, 6, 0, 2]
    caps = [(0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3)]
    for name, mode, indexed in (("strip", 5, True), ("strip-plain", 5, False)):
        own = Gltf()
        flat = [[v] for t in caps for v in t]
        own.primitive["indices"] = own.add(flat, USHORT)
        points = own.add([BOX.points[v] for v in strip])
        part = {"mode": mode, "attributes": {"POSITION": 0 if indexed else points}}
        if indexed:
            part["indices"] = own.add([[v] for v in strip], UBYTE)
        own.json["meshes"][0]["primitives"].append(part)
        read(name, own)
    for name, indexed in (("fan", True), ("fan-plain", False)):
        own = Gltf(TETRAHEDRON)
        own.primitive["indices"] = own.add([[0], [2], [1]], UBYTE)
        around = [3, 0, 1, 2, 0]
        points = own.add([TETRAHEDRON.points[v] for v in around])
        part = {"mode": 6, "attributes": {"POSITION": 0 if indexed else points}}
        if indexed:
            part["indices"] = own.add([[v] for v in around], UINT)
        own.json["meshes"][0]["primitives"].append(part)
        read(name, own, TETRAHEDRON)
    beside = Gltf()
    for mode in (0, 1, 2, 3):
        beside.json["meshes"][0]["primitives"].append({"mode": mode, "attributes": {"POSITION": 0}})
    read("points-lines", beside)
    more = Gltf()
    more.primitive["indices"] = more.add([[v] for t in BOX.triangles() for v in t] + [[0], [1]], UBYTE)
    read("two-corners-more", more)
    beyond = Gltf()
    beyond.primitive["indices"] = beyond.add([[0], [1], [8]], UBYTE)
    half = Gltf()
    half.primitive["indices"] = half.add([[0.5], [1], [2]], FLOAT)
    refused("index-half", half, "vertex 0.5")
    refused("mesh-half", Gltf().put(mesh=0.5), "mesh", "whole")
    refused("index-beyond", beyond, "vertex 8", "there are 8")
    restart = Gltf()
    restart.primitive["indices"] = restart.add([[0], [1], [65535]], USHORT)
    refused("index-restart", restart, "vertex 65535")
    refused("double", Gltf(places=DOUBLE), "5130")
    flat = Gltf()
    flat.attributes["POSITION"] = flat.add([[x, y] for x, y, _ in BOX.points])
    refused("places-in-two", flat, "VEC2")
    long = Gltf()
    long.json["accessors"][0]["count"] = 10**6
    refused("count-large", long, "ends within")
    wild = Gltf()
    wild.primitive["mode"] = 7
    refused("mode", wild, "mode 7")
    lost = Gltf()
    lost.attributes["POSITION"] = 9
    refused("accessor-beyond", lost, "number 9", "accessors")
    lost = Gltf()
    lost.json["accessors"][0]["bufferView"] = 9
    refused("view-beyond", lost, "number 9", "bufferViews")
    lost = Gltf()
    lost.json["bufferViews"][0]["buffer"] = 9
    refused("buffer-beyond", lost, "buffer")
    refused("nan", Gltf(BOX.mapped(lambda x, y, z: (math.nan if x else x, y, z))), "not a finite number")
    refused("far", Gltf(BOX.moved(1e6)), "32-bit")


def add_scenes(table):
    def read(name, own, solid=BOX, **facts):
        table.read(f"gltf/{name}.glb", own.glb(), solid, **facts)

    def refused(name, own, *words):
        table.refused(f"gltf/{name}.glb", own.glb(), *words)

    double = BOX.scaled(2)
    read("scale", Gltf().put(scale=[2, 2, 2]), double)
    read("translation", Gltf().put(translation=[1, 2, 3]), BOX.moved(1, 2, 3))
    quarter = BOX.mapped(lambda x, y, z: (-y, x, z))
    read("rotation", Gltf().put(rotation=[0, 0, math.sqrt(0.5), math.sqrt(0.5)]), quarter)
    read("rotation-long", Gltf().put(rotation=[0, 0, 3, 3]), quarter)
    matrix = [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]
    read("matrix", Gltf().put(matrix=matrix), quarter.moved(5, 6, 7))
    trs = Gltf().put(translation=[5, 0, 0], rotation=[0, 0, math.sqrt(0.5), math.sqrt(0.5)], scale=[1, 2, 1])
    read("trs", trs, BOX.mapped(lambda x, y, z: (5 - 2 * y, x, z)))
    read("mirrored", Gltf().put(scale=[-1, 1, 1]), BOX.mapped(lambda x, y, z: (-x, y, z)))
    read("mirrored-beside", Gltf().set(nodes=[{"mesh": 0, "scale": [-1, 1, 1]}, {"mesh": 0, "translation": [5, 0, 0]}],
         scenes=[{"nodes": [0, 1]}]), BOX.mapped(lambda x, y, z: (-x, y, z)).with_(BOX.moved(5)))  # fmt: skip
    nested = [{"children": [1], "scale": [2, 2, 2]}, {"children": [2], "translation": [1, 0, 0]}, {"mesh": 0}]
    read("nested", Gltf().set(nodes=nested), double.moved(2))
    read("deep", Gltf().set(nodes=[{"children": [i + 1]} for i in range(300)] + [{"mesh": 0}]))
    other = copy.deepcopy(nested[2])
    read("scene-chosen", Gltf().set(nodes=[{"mesh": 0, "scale": [9, 9, 9]}, other], scene=1,
         scenes=[{"nodes": [0]}, {"nodes": [1]}]))  # fmt: skip
    first = Gltf().set(nodes=[other, {"mesh": 0, "scale": [9, 9, 9]}], scenes=[{"nodes": [0]}, {"nodes": [1]}])
    del first.json["scene"]
    read("scene-not-chosen", first)
    bare = Gltf().set(nodes=[{"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}])
    del bare.json["scene"], bare.json["scenes"]
    read("no-scene", bare, TWO)
    read("mesh-twice", Gltf().set(nodes=[{"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}],
         scenes=[{"nodes": [0, 1]}]), TWO)  # fmt: skip
    read("touching", Gltf().set(nodes=[{"mesh": 0}, {"mesh": 0, "translation": [1, 0, 0]}],
         scenes=[{"nodes": [0, 1]}]), TOUCHING)
    read("camera", Gltf().set(nodes=[{"mesh": 0, "children": [1]}, {"camera": 0}],
         cameras=[{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}]))  # fmt: skip
    read("not-in-scene", Gltf().set(nodes=[{"mesh": 0}, {"mesh": 0, "scale": [9, 9, 9]}]))
    refused("node-twice", Gltf().set(nodes=[{"children": [2]}, {"children": [2]}, {"mesh": 0}],
            scenes=[{"nodes": [0, 1]}]), "node 2", "hangs at two")  # fmt: skip
    refused("node-loop", Gltf().set(nodes=[{"children": [1]}, {"children": [0], "mesh": 0}]), "hangs at two")
    refused("node-beyond", Gltf().set(nodes=[{"children": [7]}]), "number 7", "nodes")
    refused("mesh-beyond", Gltf().put(mesh=7), "number 7", "meshes")
    refused("scene-beyond", Gltf().set(scene=7), "number 7", "scenes")
    refused("matrix-short", Gltf().put(matrix=[1, 0, 0, 0]), "matrix")
    refused("empty-scene", Gltf().set(scenes=[{}]), "no surface")


def add_deformed(table):
    def read(name, own, solid=BOX, **facts):
        table.read(f"gltf/{name}.glb", own.glb(), solid, **facts)

    def skinned(node, joint, kind=UBYTE, weight=FLOAT, inverse=None):
        own = Gltf()
        most = {FLOAT: 1, UBYTE: 255, USHORT: 65535}[weight]
        own.attributes["JOINTS_0"] = own.add([[0, 0, 0, 0]] * 8, kind)
        own.attributes["WEIGHTS_0"] = own.add([[most, 0, 0, 0]] * 8, weight, normalized=weight != FLOAT)
        skin = {"joints": [1]}
        if inverse:
            skin["inverseBindMatrices"] = own.add([inverse])
        own.set(nodes=[{"mesh": 0, "skin": 0, **node}, joint], scenes=[{"nodes": [0, 1]}], skins=[skin])
        return own

    back = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, 0, 0, 1]
    read("skin-node", skinned({"scale": [10, 10, 10]}, {}))
    read("skin-joint", skinned({}, {"translation": [5, 0, 0]}), BOX.moved(5))
    read("skin-scaled", skinned({}, {"scale": [2, 2, 2]}), BOX.scaled(2))
    read("skin-inverse", skinned({}, {"translation": [5, 0, 0]}, inverse=back))
    read("skin-ushort", skinned({}, {"translation": [5, 0, 0]}, USHORT, USHORT), BOX.moved(5))
    read("skin-bytes", skinned({}, {"translation": [5, 0, 0]}, UBYTE, UBYTE), BOX.moved(5))
    lost = skinned({}, {})
    lost.json["scenes"] = [{"nodes": [0]}]
    table.refused("gltf/skin-not-in-scene.glb", lost.glb(), "joint 1")
    for name, node, mesh, share in (("mesh", None, [0.5], 0.5), ("node", [1], [0.5], 1), ("none", None, None, 0)):
        own = Gltf()
        by = own.add([[0, 0, z] for _, _, z in BOX.points])
        own.primitive["targets"] = [{"POSITION": by}]
        if mesh:
            own.json["meshes"][0]["weights"] = mesh
        if node:
            own.put(weights=node)
        read(f"morph-{name}", own, BOX.scaled(1, 1, 1 + share))
    moving = Gltf()
    sampler = {"input": moving.add([[0], [1]]), "output": moving.add([[0, 0, 0], [9, 9, 9]])}
    channel = {"sampler": 0, "target": {"node": 0, "path": "translation"}}
    read("animation", moving.set(animations=[{"samplers": [sampler], "channels": [channel]}]))


def add_extensions(table):
    def needing(name, **keys):
        return Gltf().set(extensionsRequired=[name], extensionsUsed=[name], **keys)

    for name in ("KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_transform",
                 "KHR_materials_transmission", "KHR_lights_punctual", "EXT_texture_webp"):  # fmt: skip
        table.read(f"gltf/needs-{name}.gltf", needing(name).gltf())
    for name in ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing",
                 "KHR_unheard_of", "EXT_mesh_manifold_and_more", "VENDOR_shape"):  # fmt: skip
        table.refused(f"gltf/needs-{name}.gltf", needing(name).gltf(), f"extension {name}")
    used = Gltf().set(extensionsUsed=["KHR_unheard_of"])
    used.node["extensions"] = {"KHR_unheard_of": {}}
    table.read("gltf/uses-unknown.gltf", used.gltf())
    draco = Gltf().set(extensionsUsed=["KHR_draco_mesh_compression"])
    draco.primitive["extensions"] = {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {}}}
    table.refused("gltf/uses-draco.gltf", draco.gltf(), "KHR_draco_mesh_compression")
    many = Gltf().set(extensionsUsed=["EXT_mesh_gpu_instancing"])
    many.node["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": {}}}
    table.refused("gltf/uses-instancing.gltf", many.gltf(), "EXT_mesh_gpu_instancing")
    packed = Gltf().set(extensionsUsed=["EXT_meshopt_compression"])
    packed.json["bufferViews"][0]["extensions"] = {"EXT_meshopt_compression": {"buffer": 0, "byteStride": 12}}
    table.read("gltf/uses-meshopt.gltf", packed.gltf())
    packed.set(extensionsRequired=["EXT_meshopt_compression"])
    table.refused("gltf/packed-meshopt.gltf", packed.gltf(), "EXT_meshopt_compression")


def add_looks(table):
    def read(name, own, **facts):
        table.read(f"gltf/{name}.glb", own.glb(), BOX, **facts)

    def looking(texture=None, image=None, uvs=(FLOAT, False), **keys):
        """With a red material, textured by one picture."""
        own = Gltf()
        kind, normalized = uvs
        most = {FLOAT: 1, UBYTE: 255, USHORT: 65535}[kind]
        own.attributes["TEXCOORD_0"] = own.add([[most, 0]] * 8, kind, normalized=normalized)
        image = {"bufferView": own.view(png(255, 0, 0)), "mimeType": "image/png"} if image is None else image
        base = {"baseColorTexture": {"index": 0, **(texture or {})}}
        own.set(textures=[{"source": 0}], images=[image], materials=[{"name": "röd", "pbrMetallicRoughness": base}])
        own.primitive["material"] = 0
        own.set(**keys)
        return own

    white = [1, 1, 1, 1]
    named = {"röd": white}
    for kind, most, normalized in ((FLOAT, 1, False), (UBYTE, 255, True), (USHORT, 65535, True)):
        for width in (3, 4):
            own = Gltf()
            color = [[most, 0, 0, most][:width]] * 8
            pad = -width * struct.calcsize(CODES[kind]) % 4
            own.attributes["COLOR_0"] = own.add(color, kind, pad=pad, normalized=normalized)
            read(f"colors-{CODES[kind]}{width}", own, colors=[RED])
    colored = Gltf().set(materials=[{"name": "a", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 0.5]}}])
    colored.primitive["material"] = 0
    read("material", colored, materials={"a": [1, 0, 0, 0.5]})
    read("picture-view", looking(), images=1, uvs=[[1, 1]], materials=named)
    data = "data:image/png;base64," + base64.b64encode(png(255, 0, 0)).decode()
    read("picture-data", looking(image={"uri": data}), images=1, materials=named)
    table.beside("gltf/a red.png", png(255, 0, 0))
    read("picture-file", looking(image={"uri": "a%20red.png"}), images=1, materials=named)
    read("uvs-bytes", looking(uvs=(UBYTE, True)), images=1, uvs=[[1, 1]])
    read("uvs-shorts", looking(uvs=(USHORT, True)), images=1, uvs=[[1, 1]])
    moved = {"extensions": {"KHR_texture_transform": {"offset": [0.5, 0.25], "scale": [2, 2]}}}
    read("uvs-moved", looking(moved), images=1, uvs=[[2.5, 0.75]])
    second = looking({"texCoord": 1})
    second.attributes["TEXCOORD_1"] = second.add([[0.5, 0.5]] * 8)
    read("uvs-second", second, images=1, uvs=[[0.5, 0.5]])
    read("picture-missing", looking(image={"uri": "gone.png"}), images=0, materials=named, remarks=["gone.png"])
    read("picture-webp", looking(textures=[{"extensions": {"EXT_texture_webp": {"source": 0}}}]), images=0,
         materials=named, remarks=["PNG"])  # fmt: skip
    lost = looking()
    lost.primitive["material"] = 5
    read("material-beyond", lost, remarks=["number 5 of its materials"])
    read("texture-beyond", looking({"index": 5}), materials=named, images=0, remarks=["number 5 of its textures"])
    read("picture-beyond", looking(textures=[{"source": 5}]), materials=named, images=0,
         remarks=["number 5 of its images"])  # fmt: skip
    old = {"diffuseFactor": [1, 0, 0, 1]}
    gloss = Gltf().set(materials=[{"name": "g", "extensions": {"KHR_materials_pbrSpecularGlossiness": old}}])
    gloss.primitive["material"] = 0
    read("specular-glossiness", gloss, materials={"g": RED})
