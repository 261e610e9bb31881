"""Reads a mesh that Kerf wrote with its quantities, with nothing of Kerf, and prints what it tells.

  read_mesh.py FILE.vtp|ply|glb|gltf
"""
import base64
import json
import struct
import sys
import xml.etree.ElementTree

import numpy as np

NUMPY = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "UInt8": "u1"}
PLY = {"float": "<f4", "double": "<f8", "int": "<i4", "uchar": "u1"}


def read_vtp(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    assert root.attrib["type"] == "PolyData" and root.attrib["header_type"] == "UInt64"
    piece = root.find("PolyData/Piece")

    def array(place, name):
        node = next(n for n in piece.findall(place + "/DataArray") if n.attrib["Name"] == name)
        data = base64.b64decode(node.text, validate=True)
        assert struct.unpack("<Q", data[:8])[0] == len(data) - 8
        values = np.frombuffer(data[8:], NUMPY[node.attrib["type"]])
        return values.reshape(-1, 3) if node.attrib["NumberOfComponents"] == "3" else values

    faces = array("Polys", "connectivity").reshape(-1, 3)
    assert np.array_equal(array("Polys", "offsets"), 3 * np.arange(1, len(faces) + 1))
    points = array("Points", "Points")
    assert len(points) == int(piece.attrib["NumberOfPoints"])
    assert len(faces) == int(piece.attrib["NumberOfPolys"])
    assert np.allclose(np.linalg.norm(array("PointData", "Normals"), axis=1), 1, atol=1e-5)
    return (points, faces, array("CellData", "piece"), array("CellData", "cut"),
            array("CellData", "strain"), array("CellData", "piece_volume"),
            array("PointData", "velocity"))


def read_ply(path):
    with open(path, "rb") as file:
        text, body = file.read().split(b"end_header\n", 1)
    fields, counts, element = {}, {}, ""
    for line in text.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element] = int(words[2])
            fields[element] = []
        elif words[0] == "property" and words[1] == "list":
            assert words[4] == "vertex_indices"
            fields[element] += [("corners_count", "u1"), ("corners", "<i4", 3)]
        elif words[0] == "property":
            fields[element].append((words[2], PLY[words[1]]))
    vertices = np.frombuffer(body, np.dtype(fields["vertex"]), counts["vertex"])
    faces = np.frombuffer(body, np.dtype(fields["face"]), counts["face"], vertices.nbytes)
    assert (faces["corners_count"] == 3).all()
    assert len(body) == vertices.nbytes + faces.nbytes
    points = np.stack([vertices[axis] for axis in "xyz"], 1)
    velocity = np.stack([vertices["v" + axis] for axis in "xyz"], 1)
    return (points, faces["corners"], faces["piece"], faces["cut"], faces["strain"],
            faces["piece_volume"], velocity)


def chunks_of(path):
    """The JSON of a glTF file and its buffer."""
    with open(path, "rb") as file:
        data = file.read()
    if path.endswith(".gltf"):
        tree = json.loads(data)
        return tree, base64.b64decode(tree["buffers"][0]["uri"].split(",", 1)[1])
    magic, version, length = struct.unpack_from("<4sII", data)
    assert magic == b"glTF" and version == 2 and length == len(data)
    size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + size]), data[28 + size:]


def read_gltf(path):
    tree, buffer = chunks_of(path)

    def array(number):
        accessor = tree["accessors"][number]
        view = tree["bufferViews"][accessor["bufferView"]]
        kind = {5126: "<f4", 5125: "<u4"}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor["type"]]
        values = np.frombuffer(buffer, kind, accessor["count"] * width, view["byteOffset"])
        return values.reshape(-1, width) if width > 1 else values

    parts = []
    start = 0
    for number, node in enumerate(tree["nodes"]):
        for primitive in tree["meshes"][node["mesh"]]["primitives"]:
            attributes = primitive["attributes"]
            points = array(attributes["POSITION"])
            faces = array(primitive["indices"]).reshape(-1, 3).astype(int)
            cut = tree["materials"][primitive["material"]]["name"] == "cut"
            strain = array(attributes["_STRAIN"])
            assert len(strain) == len(points) == len(array(attributes["_VELOCITY"]))
            parts.append((points, faces + start, np.full(len(faces), number),
                          np.full(len(faces), cut), strain[faces].max(axis=1),
                          np.full(len(faces), node["extras"]["volume"]),
                          array(attributes["_VELOCITY"])))
            start += len(points)
    return tuple(np.concatenate(column) for column in zip(*parts))


def main():
    path = sys.argv[1]
    read = {"vtp": read_vtp, "ply": read_ply, "glb": read_gltf, "gltf": read_gltf}
    points, faces, piece, cut, strain, volume, velocity = read[path.rsplit(".", 1)[1]](path)
    a, b, c = (points[faces[:, i]].astype(float) for i in range(3))
    tetrahedra = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    numbers = sorted(set(piece.tolist()))
    for number in numbers:
        assert len(set(volume[piece == number].tolist())) == 1
    print(json.dumps({
        "volumes": [float(volume[piece == n][0]) for n in numbers],
        "measured_volumes": [float(tetrahedra[piece == n].sum()) for n in numbers],
        "cut_faces": int(np.count_nonzero(cut)),
        "mean_velocity": velocity.mean(axis=0).tolist(),
        "most_strain": float(strain.max()),
    }))


main()
