#!/usr/bin/env python3
"""Hangs a bar that is cut halfway across, with fine and with graded walls: how far it sags, and how
far the slit opens. One JSON object a line.

usage: bench/graded_sag.py BUILD CELLS STEPS slit|tip      such as: build 6 40 slit

slit: the blade goes half through the bar. tip: its tip stays inside while it goes right across.
"""

import json
import pathlib
import sys

SIZE = (0.1, 0.3, 0.1)  # [m]
RATIOS = (1, 3)
LOOKS, LOOK = 9, 40  # so many steps each: it hangs still then


def hang(kind, cells, steps, ratio):
    points, triangles = bodies.box(SIZE, (cells, 3 * cells, cells))
    sim = bodies.simulate(points, triangles, params={
        "time_step": 0.005, "youngs_modulus": 1e5, "density": 1000, "air_drag": 20, "friction": 0,
        "floor": None, "gravity": [0, 0, 0], "wall_coarsening": ratio})
    sim.pin(low=np.array([-1, SIZE[1] / 2 - 1e-4, -1]), high=np.array([1, 1, 1]))
    if kind == "slit":
        a, b, way = [-.12, .0311, .08], [.12, .0293, .08], [0, 0, -.084]
    else:
        a, b, way = [-.09, .0311, .12], [-.09, .0293, -.003], [.18, 0, 0]
    sim.move_blade(a, b)
    sim.step()
    sim.sweep(np.add(a, way), np.add(b, way), steps)
    sim.lift_blade()
    sim.step()
    sim.set("gravity", [0, -9.81, 0])
    mesh, rest = sim.mesh, sim.mesh.rest_positions
    copies = {}
    for vertex, place in enumerate(np.round(rest, 9)):
        copies.setdefault(tuple(place), []).append(vertex)
    pairs = np.array([c[:2] for c in copies.values() if len(c) > 1])
    sim.step(LOOKS * LOOK)
    now = sim.positions
    low = np.isclose(rest[:, 1], -SIZE[1] / 2, rtol=0, atol=1e-6)
    gaps = np.linalg.norm(now[pairs[:, 0]] - now[pairs[:, 1]], axis=1)
    return {"kind": kind, "cells": cells, "steps": steps, "ratio": ratio,
            "wall_triangles": int(np.sum(mesh.cut)), "sag": float(np.mean((rest - now)[low, 1])),
            "opening": float(np.max(gaps))}


def main():
    for ratio in RATIOS:
        print(json.dumps(hang(sys.argv[4], int(sys.argv[2]), int(sys.argv[3]), ratio)), flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 5 or sys.argv[4] not in ("slit", "tip"):
        sys.exit(__doc__)
    sys.path[:0] = [str(pathlib.Path(sys.argv[1]).resolve() / "python"),
                    str(pathlib.Path(__file__).resolve().parent)]
    import numpy as np
    from lab import bodies
    main()
