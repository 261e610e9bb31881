"""Writes small model files as other programs write them into the folder that is named, and
corners.json there: what is right about each of them, worked out without Kerf. A row has

file        its name in the folder
refused     words of the sentence that refuses it; else, of a file that is read:
volume, triangles, pieces, low, high          of the shape, in the file's own numbers
remarks     for each remark words of it; without: there is none
materials   name to base colour (linear) and opacity
images      how many; colors, uvs: all that corners have, each once
unit, up    as kerf inspect guesses them
"""

import json
import pathlib
import sys

import dae
import fbx
import gltf
import msh
import obj
import off
import ply
import stl
import threeds
import vtk
from solids import Table


def main():
    table = Table(pathlib.Path(sys.argv[1]))
    for rows in (obj, ply, stl, off, gltf, dae, fbx, threeds, vtk, msh):
        rows.add_corners(table)
    text = json.dumps(table.rows, indent=1, ensure_ascii=True)
    (table.folder / "corners.json").write_text(text)


main()
