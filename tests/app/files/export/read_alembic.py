"""Reads an Alembic cache that Kerf wrote, with nothing of Kerf, and prints what it tells.

  read_alembic.py FILE.abc

The layout is that of Ogawa files as Alembic 1.8 reads them.
"""
import json
import struct
import sys

import numpy as np

DATA = 1 << 63
KINDS = {0: "u1", 1: "u1", 5: "<u4", 6: "<i4", 10: "<f4", 11: "<f8"}


class Words:
    """What stands in a list of headers, one after the other."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, count):
        self.at += count
        assert self.at <= len(self.data)
        return self.data[self.at - count:self.at]

    def number(self):
        return struct.unpack("<I", self.take(4))[0]

    def text(self):
        return self.take(self.number()).decode()

    def more(self):
        return self.at < len(self.data)


class Archive:
    def __init__(self, path):
        with open(path, "rb") as file:
            self.bytes = file.read()
        assert self.bytes[:8] == b"Ogawa\xff\0\1"
        root = self.group(struct.unpack_from("<Q", self.bytes, 8)[0])
        assert self.data(root[0]) == bytes(4) and struct.unpack("<i", self.data(root[1]))[0] > 9999
        self.metadata = self.data(root[3]).decode()
        times = Words(self.data(root[4]))
        assert times.number() == 1 and times.take(20) == struct.pack("<dId", 1, 1, 0)
        self.samples = times.number()
        interval = struct.unpack("<d", times.take(8))[0]
        self.even = interval < sys.float_info.max / 32
        told = np.frombuffer(times.take(8 * times.number()), "<f8")
        self.times = told[0] + interval * np.arange(self.samples) if self.even else told
        assert len(self.times) == self.samples
        assert not times.more()
        self.values, self.schemas = {}, {}
        self.read_object("", root[2])

    def words(self, place):
        size = struct.unpack_from("<Q", self.bytes, place)[0]
        return size, place + 8

    def group(self, place):
        if place == 0:
            return []
        count, start = self.words(place)
        return struct.unpack_from(f"<{count}Q", self.bytes, start)

    def data(self, place):
        assert place & DATA
        if place == DATA:
            return b""
        size, start = self.words(place - DATA)
        return self.bytes[start:start + size]

    def read_object(self, path, place):
        properties, *children, headers = self.group(place)
        self.read_compound(path, properties)
        words = Words(self.data(headers)[:-32])
        for child in children:
            name = path + "/" + words.text()
            assert words.take(1) == b"\xff"
            self.schemas[name] = words.text()
            self.read_object(name, child)
        assert not words.more()

    def read_compound(self, path, place):
        if place == 0:
            return
        *members, headers = self.group(place)
        words = Words(self.data(headers))
        for member in members:
            kind = words.number()
            assert kind >> 20 == 0xff and kind >> 2 & 3 == 2
            if kind & 3 == 0:
                name = path + "/" + words.text()
                words.text()
                self.read_compound(name, member)
                continue
            count = words.number()
            assert words.number() == 1 and kind & 0x100
            name = path + "/" + words.text()
            words.text()
            samples = self.group(member)[::2 if kind & 3 == 2 else 1]
            assert len(samples) == (1 if kind & 0xc00 else count)
            samples = list(samples) * (count if kind & 0xc00 else 1)
            numbers = kind >> 12 & 0xff
            self.values[name] = [
                np.frombuffer(self.data(s)[16:], KINDS[kind >> 4 & 15]).reshape(-1, numbers)
                for s in samples]
        assert not words.more()


def figures(archive):
    body = next(name for name in archive.schemas if name.endswith("Shape"))
    geometry = body + "/.geom/"
    value = {name[len(geometry):]: values for name, values in archive.values.items()
             if name.startswith(geometry)}
    count = len(value["P"])
    volumes, worst, against = [], [], []
    for i in range(count):
        points = value["P"][i].astype(float)
        faces = value[".faceIndices"][i].reshape(-1, 3)
        assert np.all(value[".faceCounts"][i] == 3) and len(value[".faceCounts"][i]) == len(faces)
        a, b, c = (points[faces[:, k]] for k in (2, 1, 0))  # clockwise in the file
        volumes.append(float(np.sum(np.cross(a, b) * c)) / 6)
        normals = value["N/.vals"][i][value["N/.indices"][i][:, 0]].reshape(-1, 3, 3)
        across = np.cross(b - a, c - a)
        against.append(int(np.sum(np.einsum("fkx,fx->fk", normals, across) < 0)))
        assert np.allclose(value[".selfBnds"][i], [[*points.min(0), *points.max(0)]])
        worst.append(0)
        if i > 0 and np.array_equal(faces, value[".faceIndices"][i - 1].reshape(-1, 3)):
            moved = (points - value["P"][i - 1]) / (archive.times[i] - archive.times[i - 1])
            worst[i] = float(np.abs(moved - value[".velocities"][i]).max())
    sets = {name.rsplit("/", 1)[1]: [len(v) for v in archive.values[name + "/.faceset/.faces"]]
            for name in archive.schemas if name.startswith(body + "/")}
    last = archive.values[body + "/cut/.faceset/.faces"][-1][:, 0]
    colors = value[".arbGeomParams/Cd/.vals"][-1][
        value[".arbGeomParams/Cd/.indices"][-1][:, 0]].reshape(-1, 3, 4)
    return {
        "samples": count,
        "even": bool(archive.even),
        "times": archive.times.tolist(),
        "origin": archive.values[body.rsplit("/", 1)[0] + "/.xform/.vals"][0][0].tolist(),
        "faces": [len(v) // 3 for v in value[".faceIndices"]],
        "volumes": volumes,
        "sets": sets,
        "against_normals": against,
        "velocity_errors": worst,
        "fall": float(value[".velocities"][-1][:, 1].min()),
        "cut_color": colors[last].reshape(-1, 4).mean(0).tolist(),
        "metadata": archive.metadata,
    }


print(json.dumps(figures(Archive(sys.argv[1]))))
