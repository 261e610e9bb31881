#!/usr/bin/env python3
"""Makes the studios that bodies reflect: 256x128 panoramas in Radiance's .hdr format.

    assets/environments/make_environments.py

Writes studio-dark.hdr and studio-bright.hdr beside itself. Needs the standard library alone.
"""
import math
from pathlib import Path

WIDTH, HEIGHT = 256, 128


def smooth(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def mixed(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def unit(v):
    size = math.sqrt(sum(x * x for x in v))
    return tuple(x / size for x in v)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Softbox:
    """A rectangular lamp, seen from the middle of the studio under half angles wide and high."""

    def __init__(self, towards, wide, high, color, soft=0.05):
        self.z = unit(towards)
        side = (self.z[2], 0.0, -self.z[0])
        self.x = unit(side)
        self.y = (self.z[1] * self.x[2] - self.z[2] * self.x[1],
                  self.z[2] * self.x[0] - self.z[0] * self.x[2],
                  self.z[0] * self.x[1] - self.z[1] * self.x[0])
        self.wide, self.high, self.color, self.soft = wide, high, color, soft

    def light(self, d):
        if dot(d, self.z) <= 0:
            return (0.0, 0.0, 0.0)
        x = abs(math.atan2(dot(d, self.x), dot(d, self.z)))
        y = abs(math.atan2(dot(d, self.y), dot(d, self.z)))
        cover = (1 - smooth(self.wide - self.soft, self.wide + self.soft, x)) * \
                (1 - smooth(self.high - self.soft, self.high + self.soft, y))
        return tuple(c * cover for c in self.color)


class Studio:
    def __init__(self, ground, horizon, zenith, lamps):
        self.ground, self.horizon, self.zenith, self.lamps = ground, horizon, zenith, lamps

    def light(self, d):
        if d[1] < 0:
            color = mixed(self.horizon, self.ground, smooth(0.0, 0.30, -d[1]))
        else:
            color = mixed(self.horizon, self.zenith, smooth(0.0, 0.75, d[1]))
        for lamp in self.lamps:
            color = tuple(a + b for a, b in zip(color, lamp.light(d)))
        return color


KEY = (-0.18, 0.86, 0.48)  # as in render/passes/frame.cpp

DARK = Studio((0.075, 0.062, 0.058), (0.15, 0.18, 0.24), (0.15, 0.20, 0.32), [
    Softbox(KEY, 0.34, 0.34, (1.8, 1.65, 1.4), 0.10),
    Softbox((0.90, 0.22, -0.42), 0.15, 0.70, (1.6, 1.6, 1.65)),
    Softbox((-0.95, 0.30, -0.05), 0.30, 0.42, (0.75, 0.68, 0.58), 0.08),
    Softbox((0.35, 0.12, 0.95), 0.55, 0.20, (0.20, 0.23, 0.29), 0.15),
])
BRIGHT = Studio((0.22, 0.21, 0.20), (0.40, 0.42, 0.46), (0.28, 0.32, 0.40), [
    Softbox(KEY, 0.36, 0.36, (2.0, 1.9, 1.75), 0.10),
    Softbox((0.90, 0.22, -0.42), 0.18, 0.70, (1.8, 1.9, 2.1)),
    Softbox((-0.95, 0.30, -0.05), 0.32, 0.44, (0.9, 0.87, 0.84), 0.08),
])


def direction(column, row):
    """Of the middle of a pixel; the middle of the picture looks along -z, up is +y."""
    around = (column + 0.5) / WIDTH * 2 * math.pi
    down = (row + 0.5) / HEIGHT * math.pi
    return (-math.sin(around) * math.sin(down), math.cos(down), math.cos(around) * math.sin(down))


def rgbe(color):
    largest = max(color)
    if largest < 1e-32:
        return bytes(4)
    mantissa, exponent = math.frexp(largest)
    scale = mantissa * 256 / largest
    return bytes([int(c * scale) for c in color] + [exponent + 128])


def write(studio, file):
    pixels = b"".join(rgbe(studio.light(direction(x, y)))
                      for y in range(HEIGHT) for x in range(WIDTH))
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {HEIGHT} +X {WIDTH}\n"
    file.write_bytes(head.encode() + pixels)


if __name__ == "__main__":
    here = Path(__file__).parent
    write(DARK, here / "studio-dark.hdr")
    write(BRIGHT, here / "studio-bright.hdr")
