#!/usr/bin/env python3
"""Cuts a sphere by a plane with VTK's vtkClipClosedSurface, both halves with caps, beside our
cutter with graded walls: CPU time on one thread, the median of five.

usage: bench/vtk_plane_cut.py BUILD     (needs Debian's python3-vtk9)

Runs BUILD/kerf_plane_bench, which writes the spheres and times ours, and prints its lines with
VTK's figures added. The volumes of the halves must agree.
"""

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

REPEATS = 5
SAME_VOLUME = 1e-6  # relative


def read_body(path):
    """The surface of an OBJ file in doubles, which VTK's own reader rounds to floats."""
    points, faces = [], []
    for line in pathlib.Path(path).read_text().splitlines():
        kind, *words = line.split()
        (points if kind == "v" else faces).append([float(word) for word in words])
    where = vtk.vtkPoints()
    where.SetData(numpy_to_vtk(np.array(points), deep=True))
    polygons = vtk.vtkCellArray()
    corners = np.array(faces, np.int64) - 1
    offsets = np.arange(0, corners.size + 1, 3)
    polygons.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                     numpy_to_vtkIdTypeArray(corners.ravel(), deep=True))
    body = vtk.vtkPolyData()
    body.SetPoints(where)
    body.SetPolys(polygons)
    return body


def half(body, point, normal):
    """What lies on the side to which the normal points, and the CPU milliseconds it took."""
    plane = vtk.vtkPlane()
    plane.SetOrigin(*point)
    plane.SetNormal(*normal)
    planes = vtk.vtkPlaneCollection()
    planes.AddItem(plane)
    clip = vtk.vtkClipClosedSurface()
    clip.SetInputData(body)
    clip.SetClippingPlanes(planes)
    start = time.process_time()
    clip.Update()
    return clip.GetOutput(), 1e3 * (time.process_time() - start)


def volume(surface):
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.Update()
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    corners = vtk_to_numpy(triangles.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[corners[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def cut(body, point, normal):
    """Both halves: their volumes, ascending, and the CPU milliseconds."""
    halves = [half(body, point, sign * np.array(normal)) for sign in (1, -1)]
    return sorted(volume(surface) for surface, _ in halves), sum(time for _, time in halves)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    vtk.vtkSMPTools.SetBackend("Sequential")
    with tempfile.TemporaryDirectory() as folder:
        output = subprocess.run([pathlib.Path(sys.argv[1]) / "kerf_plane_bench", folder],
                                stdout=subprocess.PIPE, check=True, text=True).stdout
        for line in map(json.loads, output.splitlines()):
            body = read_body(line.pop("body"))
            runs = [cut(body, line["point"], line["normal"]) for _ in range(REPEATS)]
            apart = max(abs(a / b - 1) for a, b in zip(runs[0][0], line["volumes"]))
            if not apart < SAME_VOLUME:
                sys.exit(f"{line['name']}: the halves have different volumes, by {apart:.1e}")
            theirs = statistics.median(milliseconds for _, milliseconds in runs)
            print(json.dumps({**line, "theirs": theirs, "peer": "VTK vtkClipClosedSurface, twice",
                              "ratio": theirs / line["ours"], "apart": apart}), flush=True)


if __name__ == "__main__":
    main()
