#!/usr/bin/env python3
"""Makes models with looks of their own, and reads exports of them, without anything of Kerf.

own_looks.py make DIR            writes the models into DIR, and prints their names
own_looks.py check DIR OUT NAME...
"""

import base64
import json
import os
import re
import struct
import sys
import urllib.parse
import zlib

import numpy as np

JPEG = base64.b64decode(
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABQODxIPDRQSEBIXFRQYHjIhHhwcHj0sLiQySUBMS0dARkVQWnNiUFVtVk"
    "VGZIhlbXd7gYKBTmCNl4x9lnN+gXz/2wBDARUXFx4aHjshITt8U0ZTfHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHx8"
    "fHx8fHx8fHx8fHx8fHx8fHx8fHx8fHz/wAARCAAQABADASIAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAABAX/xA"
    "AXEAADAQAAAAAAAAAAAAAAAAAAAwRh/8QAFQEBAQAAAAAAAAAAAAAAAAAAAAL/xAAXEQADAQAAAAAAAAAAAAAAAAAA"
    "AwQx/9oADAMBAAIRAxEAPwCKmTCgmTB6ZMHpkwplAirw/9k=")


def png(seed, side=16):
    """A picture of side x side pixels."""
    rows = b"".join(
        b"\0" + bytes(v for x in range(side) for v in (15 * x, 15 * y, 40 * seed % 256))
        for y in range(side))

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def to_linear(c):
    c = np.asarray(c, float)
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


# --- Shapes: positions and triangles, closed --------------------------------------------------


def grid_cube(n):
    index, points, faces = {}, [], []

    def at(p):
        key = tuple(int(v) for v in p)
        if key not in index:
            index[key] = len(points)
            points.append([2 * v / n - 1 for v in key])
        return index[key]
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, n):
            for i in range(n):
                for j in range(n):
                    quad = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        p = [0, 0, 0]
                        p[axis], p[u], p[v] = side, i + di, j + dj
                        quad.append(at(p))
                    a, b, c, d = quad if side else quad[::-1]
                    faces += [(a, b, c), (a, c, d)]
    return np.array(points, float), faces


def box():
    points, faces = grid_cube(3)
    return points * [1, 0.7, 0.5], faces


def ball():
    points, faces = grid_cube(5)
    return points / np.linalg.norm(points, axis=1)[:, None], faces


def ring(n=16, m=8):
    points, faces = [], []
    for i in range(n):
        for j in range(m):
            a, b = 2 * np.pi * i / n, 2 * np.pi * j / m
            r = 1 + 0.4 * np.cos(b)
            points.append([r * np.cos(a), 0.4 * np.sin(b), -r * np.sin(a)])
            p, q = (i + 1) % n, (j + 1) % m
            faces += [(i * m + j, p * m + j, p * m + q), (i * m + j, p * m + q, i * m + q)]
    return np.array(points), faces


SHAPES = {"box": box, "ball": ball, "ring": ring}


class Model:
    """Triangles by their corners: places, texture coordinates, colours, materials."""

    def __init__(self):
        self.places, self.uvs, self.colors, self.names, self.cuts = [], [], [], [], []
        self.materials = {}  # name -> (colour, bytes of the image or None)

    def arrays(self):
        def stacked(values, width):
            none = np.full((3, width), np.nan)
            return np.array([none if v is None else v for v in values], float).reshape(-1, 3, width)
        self.places = np.array(self.places, float).reshape(-1, 3, 3)
        self.uvs, self.colors = stacked(self.uvs, 2), stacked(self.colors, 4)
        self.cuts = np.array(self.cuts, bool)
        return self


# --- Making -----------------------------------------------------------------------------------


def side_of(points, face):
    a, b, c = (points[i] for i in face)
    n = np.cross(b - a, c - a)
    axis = int(np.argmax(np.abs(n)))
    return 2 * axis + int(n[axis] > 0)


def corner_uvs(points, face):
    side = side_of(points, face)
    axes = [(side // 2 + 1) % 3, (side // 2 + 2) % 3]
    return np.array([points[i][axes] * 0.2 + 0.3 + 0.05 * side for i in face])


def vertex_bytes(points):
    """Colours as displays take them, as bytes."""
    low, high = points.min(0), points.max(0)
    return np.round((points - low) / (high - low) * 255).astype(int)


def number(v):
    return repr(float(np.float32(v)))


def write(path, data):
    with open(path, "wb") as out:
        out.write(data if isinstance(data, bytes) else data.encode())


MATERIALS = ["red paint", "blau-grün", "third.one"]
KD = {"red paint": (0.8, 0.1, 0.05), "blau-grün": (0.1, 0.5, 0.6), "third.one": (0.2, 0.2, 0.9)}


def obj_text(points, faces, libraries, material_of, colored):
    shades = vertex_bytes(points) / 255
    lines = ["# made by a test"] + ["mtllib " + name for name in libraries]
    for p, c in zip(points, shades):
        lines.append("v " + " ".join(number(v) for v in [*p, *(c if colored else [])]))
    uvs = [corner_uvs(points, face) for face in faces]
    lines += ["vt " + " ".join(number(v) for v in uv) for corners in uvs for uv in corners]
    last = None
    order = sorted(range(len(faces)), key=lambda t: str(material_of(faces[t])))
    for t in order:
        name = material_of(faces[t])
        if name != last:
            lines.append("usemtl " + name)
            last = name
        lines.append("f " + " ".join("%d/%d" % (v + 1, 3 * t + i + 1) for i, v in enumerate(faces[t])))
    return "\n".join(lines) + "\n"


def mtl_text(names, images):
    lines = []
    for name in names:
        lines += ["newmtl " + name, "Kd %g %g %g" % KD[name], "d 1"]
        if name in images:
            lines.append("map_Kd " + images[name])
    return "\n".join(lines) + "\n"


def make_obj(kind, folder, name, points, faces):
    by_side = lambda face: MATERIALS[side_of(points, face) // 2]
    write(os.path.join(folder, "tile one.png"), png(1))
    write(os.path.join(folder, "tile.jpg"), JPEG)
    libraries, material_of, images = [name + " a.mtl", name + ".mtl"], by_side, {}
    if kind == "textured":
        images = {"red paint": "tile one.png"}
    if kind == "mixed":
        images = {"red paint": "tile.jpg", "third.one": "tile one.png"}
    if kind == "shaded":
        libraries, material_of = [], lambda face: None
    for library, names in zip(libraries, (MATERIALS[:1], MATERIALS[1:])):
        write(os.path.join(folder, library), mtl_text(names, images))
    write(os.path.join(folder, name + ".obj"),
          obj_text(points, faces, libraries, material_of, kind == "shaded"))
    return name + ".obj"


def make_ply(kind, folder, name, points, faces):
    shades = vertex_bytes(points)
    binary = kind == "binary"
    head = ("ply\nformat %s 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
            "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
            "element face %d\nproperty list uchar int vertex_indices\nend_header\n" %
            ("binary_little_endian" if binary else "ascii", len(points), len(faces)))
    data = head.encode()
    for p, c in zip(points, shades):
        data += (struct.pack("<fffBBB", *p, *c) if binary else
                 (" ".join([number(v) for v in p] + [str(v) for v in c]) + "\n").encode())
    for f in faces:
        data += struct.pack("<Biii", 3, *f) if binary else ("3 %d %d %d\n" % tuple(f)).encode()
    write(os.path.join(folder, name + ".ply"), data)
    return name + ".ply"


def make_gltf(kind, folder, name, points, faces):
    """One primitive per material, with vertices of their own."""
    shaded = kind == "shaded"
    blob, views, accessors, primitives = b"", [], [], []

    def view(data):
        nonlocal blob
        blob += b"\0" * (-len(blob) % 4)
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(data)})
        blob += data
        return len(views) - 1

    def accessor(array, kind_of, component, **more):
        accessors.append({"bufferView": view(array.tobytes()), "componentType": component,
                          "count": len(array), "type": kind_of, **more})
        return len(accessors) - 1
    shades = to_linear(vertex_bytes(points) / 255)
    for m, material in enumerate(MATERIALS):
        own = [f for f in faces if side_of(points, f) // 2 == m]
        if not own:
            continue
        place = np.array([points[i] for f in own for i in f], np.float32)
        uv = np.array([u for f in own for u in corner_uvs(points, f)], np.float32)
        uv[:, 1] = 1 - uv[:, 1]
        attributes = {
            "POSITION": accessor(place, "VEC3", 5126, min=place.min(0).tolist(),
                                 max=place.max(0).tolist()),
            "TEXCOORD_0": accessor(uv, "VEC2", 5126)}
        if shaded:
            shade = np.array([[*shades[i], 1] for f in own for i in f], np.float32)
            attributes["COLOR_0"] = accessor(shade, "VEC4", 5126)
        indices = np.arange(len(place), dtype=np.uint32)
        primitives.append({"attributes": attributes, "material": m,
                           "indices": accessor(indices, "SCALAR", 5125)})
    materials = [{"name": n, "pbrMetallicRoughness": {"baseColorFactor": [*KD[n], 1]}}
                 for n in MATERIALS]
    images = []
    for m, picture in ((0, png(3)), (2, JPEG)):
        if kind == "plain":
            continue
        media = "image/png" if picture[:1] == b"\x89" else "image/jpeg"
        if kind == "beside":
            file = "sub folder/%s %d.%s" % (name, m, "png" if m == 0 else "jpg")
            os.makedirs(os.path.join(folder, "sub folder"), exist_ok=True)
            write(os.path.join(folder, file), picture)
            images.append({"uri": urllib.parse.quote(file)})
        elif kind == "within":
            images.append({"uri": "data:" + media + ";base64," + base64.b64encode(picture).decode()})
        else:
            images.append({"bufferView": view(picture), "mimeType": media, "name": "pic %d" % m})
        materials[m]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": len(images) - 1}
    root = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}], "meshes": [{"primitives": primitives}], "materials": materials,
            "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(blob)}]}
    if images:
        root["images"] = images
        root["textures"] = [{"source": i} for i in range(len(images))]
    if kind in ("beside", "within"):
        uri = name + ".bin"
        write(os.path.join(folder, uri), blob)
        root["buffers"][0]["uri"] = urllib.parse.quote(uri)
        write(os.path.join(folder, name + ".gltf"), json.dumps(root))
        return name + ".gltf"
    text = json.dumps(root).encode()
    text += b" " * (-len(text) % 4)
    blob += b"\0" * (-len(blob) % 4)
    write(os.path.join(folder, name + ".glb"),
          struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(blob)) +
          struct.pack("<II", len(text), 0x4E4F534A) + text +
          struct.pack("<II", len(blob), 0x004E4942) + blob)
    return name + ".glb"


KINDS = [(make_obj, "plain"), (make_obj, "textured"), (make_obj, "mixed"), (make_obj, "shaded"),
         (make_gltf, "plain"), (make_gltf, "textured"), (make_gltf, "shaded"),
         (make_gltf, "beside"), (make_gltf, "within"), (make_ply, "text"), (make_ply, "binary")]


def make(folder):
    for shape, build in SHAPES.items():
        points, faces = build()
        points = points.astype(np.float32).astype(float)
        for maker, kind in KINDS:
            name = "%s-%s-%s" % (shape, maker.__name__[5:], kind)
            below = os.path.join(folder, name)
            os.makedirs(below)
            print(os.path.join(name, maker(kind, below, name, points, faces)))


# --- Reading ----------------------------------------------------------------------------------


def image_beside(path, name):
    with open(os.path.join(os.path.dirname(path), name), "rb") as file:
        return file.read()


def read_mtl(path, materials):
    name = None
    for line in open(path, encoding="utf-8"):
        word, _, rest = line.strip().partition(" ")
        if word == "newmtl":
            name = rest
            materials[name] = [np.array([0.6, 0.6, 0.6, 1.0]), None]
        elif word == "Kd":
            materials[name][0][:3] = [float(v) for v in rest.split()]
        elif word == "d":
            materials[name][0][3] = float(rest)
        elif word == "map_Kd":
            materials[name][1] = image_beside(path, rest)


def read_obj(path):
    model, points, shades, uvs = Model(), [], [], []
    material, cut = None, False
    for line in open(path, encoding="utf-8"):
        word, _, rest = line.strip().partition(" ")
        if word == "v":
            numbers = [float(v) for v in rest.split()]
            points.append(numbers[:3])
            shades.append([*to_linear(numbers[3:]), 1] if len(numbers) == 6 else None)
        elif word == "vt":
            uvs.append([float(v) for v in rest.split()[:2]])
        elif word == "mtllib":
            read_mtl(os.path.join(os.path.dirname(path), rest), model.materials)
        elif word == "usemtl":
            material = None if rest == "None" else rest
        elif word == "g":
            cut = rest == "cut"
        elif word == "f":
            corners = [c.split("/") for c in rest.split()]
            v = [int(c[0]) - 1 for c in corners]
            t = [int(c[1]) - 1 if len(c) > 1 and c[1] else -1 for c in corners]
            model.places.append([points[i] for i in v])
            model.uvs.append([uvs[i] for i in t] if t[0] >= 0 else None)
            model.colors.append([shades[i] for i in v] if shades[v[0]] else None)
            model.names.append(material)
            model.cuts.append(cut)
    return model.arrays()


def read_ply(path):
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + 11
    head = data[:end].decode().split("\n")
    rest = data[end:]
    words = rest.split() if "ascii" in head[1] else None
    at = 0
    codes = {"float": "f", "uchar": "B", "int": "i"}

    def take(kind):
        nonlocal at
        if words is not None:
            at += 1
            return float(words[at - 1]) if kind == "float" else int(words[at - 1])
        value, = struct.unpack_from("<" + codes[kind], rest, at)
        at += struct.calcsize(codes[kind])
        return value
    elements, image = [], None
    for line in head:
        word = line.split()
        if line.startswith("comment TextureFile "):
            image = image_beside(path, line[len("comment TextureFile "):])
        elif word[:1] == ["element"]:
            elements.append((word[1], int(word[2]), []))
        elif word[:1] == ["property"]:
            elements[-1][2].append(word[1:])
    rows = {}
    for name, count, properties in elements:
        rows[name] = []
        for _ in range(count):
            row = {}
            for p in properties:
                row[p[-1]] = [take(p[2]) for _ in range(take(p[1]))] if p[0] == "list" else take(p[0])
            rows[name].append(row)
    model = Model()
    model.materials = {None: [np.ones(4), image]}
    vertices = rows["vertex"]
    for face in rows["face"]:
        own = [vertices[i] for i in face["vertex_indices"]]
        model.places.append([[v["x"], v["y"], v["z"]] for v in own])
        model.colors.append([[*to_linear(np.array([v["red"], v["green"], v["blue"]]) / 255), 1]
                             for v in own] if "red" in own[0] else None)
        uv = face.get("texcoord", [])
        model.uvs.append(np.reshape(uv, (3, 2)) if len(uv) == 6 else None)
        model.names.append(None)
        model.cuts.append(face.get("cut", 0) == 1)
    return model.arrays()


def read_gltf(path):
    data = open(path, "rb").read()
    own = None
    if path.endswith(".glb"):
        size, = struct.unpack_from("<I", data, 12)
        root, own = json.loads(data[20:20 + size]), data[28 + size:]
    else:
        root = json.loads(data)

    def content(uri):
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        return image_beside(path, urllib.parse.unquote(uri))
    blobs = [content(b["uri"]) if "uri" in b else own for b in root["buffers"]]

    def view(index):
        v = root["bufferViews"][index]
        start = v.get("byteOffset", 0)
        return blobs[v["buffer"]][start:start + v["byteLength"]]

    def values(index):
        a = root["accessors"][index]
        kind = {5126: np.float32, 5125: np.uint32, 5123: np.uint16}[a["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[a["type"]]
        start = a.get("byteOffset", 0)
        flat = np.frombuffer(view(a["bufferView"])[start:], kind, a["count"] * width)
        return flat.reshape(-1, width).astype(float)
    model = Model()
    for m in root["materials"]:
        pbr = m["pbrMetallicRoughness"]
        image = None
        if "baseColorTexture" in pbr:
            from_ = root["images"][root["textures"][pbr["baseColorTexture"]["index"]]["source"]]
            image = view(from_["bufferView"]) if "bufferView" in from_ else content(from_["uri"])
        model.materials[m["name"]] = [np.array(pbr.get("baseColorFactor", [1] * 4), float), image]
    for mesh in root["meshes"]:
        for p in mesh["primitives"]:
            index = values(p["indices"])[:, 0].astype(int).reshape(-1, 3)
            name = root["materials"][p["material"]]["name"]
            lists = {k: values(v) for k, v in p["attributes"].items()}
            for t in index:
                model.places.append(lists["POSITION"][t])
                uv = lists["TEXCOORD_0"][t] if "TEXCOORD_0" in lists else None
                model.uvs.append(None if uv is None else np.stack([uv[:, 0], 1 - uv[:, 1]], 1))
                model.colors.append(lists["COLOR_0"][t] if "COLOR_0" in lists else None)
                model.names.append(name)
                model.cuts.append(name == "cut")
    return model.arrays()


def read(path):
    return {".obj": read_obj, ".ply": read_ply, ".glb": read_gltf, ".gltf": read_gltf}[
        os.path.splitext(path)[1]](path)


# --- Comparing --------------------------------------------------------------------------------


class Expected:
    """What the model has at places of its surface, on each of its sides there."""

    def __init__(self, model):
        self.model = model
        self.a = model.places[:, 0]
        self.u, self.v = model.places[:, 1] - self.a, model.places[:, 2] - self.a
        n = np.cross(self.u, self.v)
        self.area = np.einsum("ij,ij->i", n, n)
        self.n = n
        self.size = np.ptp(model.places.reshape(-1, 3), axis=0).max()

    def near(self, p, slack):
        """Triangles at which p lies, and the weights of their corners there."""
        d = p - self.a
        w2 = np.einsum("ij,ij->i", np.cross(self.u, d), self.n) / self.area
        w1 = np.einsum("ij,ij->i", np.cross(d, self.v), self.n) / self.area
        w = np.stack([1 - w1 - w2, w1, w2], 1)
        off = np.abs(np.einsum("ij,ij->i", d, self.n)) / np.sqrt(self.area) / self.size
        found = np.nonzero((w.min(1) > -slack) & (off < 0.1 * slack))[0]
        return found, w[found]


def fail(sentence, *figures):
    raise SystemExit("own_looks: " + sentence % figures)


def check_materials(before, after, path):
    """Names, colours and images of all materials that faces have."""
    for name in set(n for n, cut in zip(after.names, after.cuts) if not cut):
        if name in (None, "skin"):
            continue
        if name not in before.materials:
            fail("%s has a material %r of nowhere", path, name)
        old, new = before.materials[name], after.materials[name]
        if not np.allclose(old[0], new[0], atol=1e-6):
            fail("%s: %r is %s, not %s", path, name, new[0], old[0])
        if old[1] != new[1]:
            fail("%s: %r has another image", path, name)


def tint(model, t):
    """The colours of the corners of a triangle, material and all; None for those of a look."""
    own = model.colors[t]
    name = model.names[t]
    if np.isnan(own).any():
        return None if name is None else np.tile(model.materials[name][0], (3, 1))
    return own if name in (None, "skin") else own * model.materials[name][0]


def check_corners(expected, after, path):
    """About a hundred faces of a file."""
    before = expected.model
    is_ply = path.endswith(".ply")
    skin = np.nonzero(~after.cuts)[0]
    for t in skin[::1 + len(skin) // 100]:
        middle, _ = expected.near(after.places[t].mean(0), 0.02)
        if len(middle) == 0:
            continue  # across an edge of a round model
        names = {before.names[i] or "skin" for i in middle}
        if not is_ply and (after.names[t] or "skin") not in names:
            fail("%s: a face of %s has %r", path, names, after.names[t])
        for i in range(3):
            check_corner(expected, after, path, t, i)


def check_corner(expected, after, path, t, i):
    before = expected.model
    found, weights = expected.near(after.places[t][i], 1e-3)
    if len(found) == 0:
        return
    is_ply = path.endswith(".ply")
    same = [k for k, j in enumerate(found) if is_ply or before.names[j] == after.names[t] or
            (before.names[j] is None and after.names[t] == "skin")]
    uvs = [weights[k] @ before.uvs[found[k]] for k in same or range(len(found))]
    if not np.isnan(uvs).any():
        if min(np.abs(uv - after.uvs[t][i]).max() for uv in uvs) > 2e-3:
            fail("%s: a corner at %s has %s, not one of %s", path, after.places[t][i],
                 after.uvs[t][i], uvs)
    tints = [tint(before, found[k]) for k in same or range(len(found))]
    if any(c is None for c in tints):
        return
    wanted = [w @ c for w, c in zip([weights[k] for k in same or range(len(found))], tints)]
    if is_ply and np.ptp(wanted, axis=0).max() > 1e-3:
        return  # vertices have the mean there
    own = after.colors[t][i] if is_ply else tint(after, t)[i]
    if min(np.abs(c - own)[:3].max() for c in wanted) > (8e-3 if is_ply else 2e-3):
        fail("%s: a corner at %s has the colour %s, not one of %s", path, after.places[t][i], own,
             wanted)


def check_whole(before, after, path):
    """The same triangles, numbers to a float's rounding."""
    def keyed(model):
        scale = np.abs(before.places).max()
        keys = {}
        for t, corners in enumerate(np.round(model.places / scale * 1e5).astype(int)):
            rows = [tuple(c) for c in corners]
            first = rows.index(min(rows))
            keys[tuple(rows[first:] + rows[:first])] = (t, first)
        return keys
    old, new = keyed(before), keyed(after)
    if old.keys() != new.keys():
        fail("%s: %d triangles are others than before", path, len(old.keys() ^ new.keys()))
    for key, (t, first) in old.items():
        u, start = new[key]
        a, b = np.roll(before.places[t], -first, 0), np.roll(after.places[u], -start, 0)
        if np.abs(a - b).max() > 2.4e-7 * np.abs(a).max():
            fail("%s: a corner is at %s, not at %s", path, b, a)
        if path.endswith(".ply"):
            continue
        a, b = np.roll(before.uvs[t], -first, 0), np.roll(after.uvs[u], -start, 0)
        if not np.isnan(a).any() and np.abs(a - b).max() > 3e-7:
            fail("%s: a corner has the coordinates %s, not %s", path, b, a)


def check_cut(after, path):
    if not after.cuts.any():
        fail("%s has no faces of the cut", path)
    if path.endswith(".ply"):
        return
    walls = np.nonzero(after.cuts)[0]
    if any(after.names[t] != "cut" for t in walls):
        fail("%s: faces of the cut have another material", path)
    for t in walls:
        a, b, c = after.places[t]
        area = np.linalg.norm(np.cross(b - a, c - a))
        u, v = after.uvs[t][1] - after.uvs[t][0], after.uvs[t][2] - after.uvs[t][0]
        flat = abs(u[0] * v[1] - u[1] * v[0])
        if not abs(flat - area) <= 1e-3 * area + 1e-6:
            fail("%s: a face of the cut of area %g covers %g of its plane", path, area, flat)


def check(folder, out, name):
    before = read(os.path.join(folder, name))
    expected = Expected(before)
    stem = re.sub(r"\W", "_", os.path.splitext(os.path.basename(name))[0])
    for ending in (".obj", ".glb", ".gltf", ".ply"):
        for state in ("whole", "cut"):
            path = os.path.join(out, stem, state, "out" + ending)
            after = read(path)
            if not path.endswith(".ply"):
                check_materials(before, after, path)
            check_corners(expected, after, path)
            if state == "whole":
                check_whole(before, after, path)
            else:
                check_cut(after, path)
    shown = {image for _, image in before.materials.values() if image is not None}
    if len(shown) == 1 and read(os.path.join(out, stem, "whole", "out.ply")).materials[None][1] not in shown:
        fail("%s: its .ply names no image", name)


if __name__ == "__main__":
    if sys.argv[1] == "make":
        make(sys.argv[2])
    else:
        for model in sys.argv[4:]:
            check(sys.argv[2], sys.argv[3], model)
