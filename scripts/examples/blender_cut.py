"""Makes an animation in Blender of the meshes that a replay wrote, and renders it.

  kerf replay SESSION --out DIR --sequence 4 --meshes glb
  blender -b --python blender_cut.py -- DIR/sequence cut.blend [FRAMES] [--slower N] [--size WxH]
          [--samples N]

A cut changes the triangles, so each mesh is an object of its own, which is seen in its frames
alone. `cut.blend` has them all, with a floor, a camera and lights, to go on with in Blender. With a
folder FRAMES they are rendered into it as PNG, by Cycles on the processor.
"""
import argparse
import json
import math
import pathlib
import sys

import bpy
import numpy
from mathutils import Vector

RATE = 24  # frames a second

# The glTF importer of Blender in Debian 12 uses a name that NumPy there no longer has.
if "bool" not in vars(numpy):
    numpy.bool = bool


def read_arguments():
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    parser = argparse.ArgumentParser(prog="blender -b --python blender_cut.py --")
    parser.add_argument("sequence", type=pathlib.Path)
    parser.add_argument("blend", type=pathlib.Path)
    parser.add_argument("frames", type=pathlib.Path, nargs="?")
    parser.add_argument("--slower", type=float, default=1)
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--samples", type=int, default=32)
    return parser.parse_args(words)


def import_step(path):
    """The meshes of a file, as objects in a collection of their own."""
    known = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=str(path))
    made = [thing for thing in bpy.data.objects if thing not in known]
    return [thing for thing in made if thing.type == "MESH"]


def show_only(meshes, first, last):
    """Keys of visibility: seen from the first frame until before the last one."""
    for mesh in meshes:
        for frame, hidden in ((0, True), (first, False), (last, True)):
            mesh.hide_viewport = mesh.hide_render = hidden
            mesh.keyframe_insert("hide_viewport", frame=frame)
            mesh.keyframe_insert("hide_render", frame=frame)


def share_materials():
    """Each file brings its own; those of one name become one, to be changed in one place."""
    first = {}
    for material in list(bpy.data.materials):
        name = material.name.partition(".0")[0]
        if name in first:
            material.user_remap(first[name])
            bpy.data.materials.remove(material)
        else:
            first[name] = material
    for material in first.values():
        if material.use_nodes and "Principled BSDF" in material.node_tree.nodes:
            shader = material.node_tree.nodes["Principled BSDF"].inputs
            shader["Roughness"].default_value = 0.35


def bounds_of(meshes):
    corners = [mesh.matrix_world @ Vector(corner) for mesh in meshes for corner in mesh.bound_box]
    low = Vector(min(corner[i] for corner in corners) for i in range(3))
    high = Vector(max(corner[i] for corner in corners) for i in range(3))
    return low, high


def set_stage(meshes):
    """A floor below all, a camera that sees all, a lamp and a sky."""
    low, high = bounds_of(meshes)
    middle, size = (low + high) / 2, (high - low).length
    bpy.ops.mesh.primitive_plane_add(size=20 * size, location=(middle.x, middle.y, low.z))
    ground = bpy.data.materials.new("floor")
    ground.diffuse_color = (0.5, 0.5, 0.52, 1)
    bpy.context.object.data.materials.append(ground)

    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = middle + Vector((1.0, -1.2, 0.65)).normalized() * 1.45 * size
    camera.rotation_euler = (middle - camera.location).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(camera)
    bpy.context.scene.camera = camera

    lamp = bpy.data.objects.new("lamp", bpy.data.lights.new("lamp", "AREA"))
    lamp.location = middle + Vector((-1.2, -0.8, 2)) * size
    lamp.rotation_euler = (middle - lamp.location).to_track_quat("-Z", "Y").to_euler()
    lamp.data.size = 1.5 * size
    lamp.data.energy = 150 * size * size
    bpy.context.collection.objects.link(lamp)

    world = bpy.context.scene.world or bpy.data.worlds.new("world")
    bpy.context.scene.world = world
    world.use_nodes = True
    sky = world.node_tree.nodes["Background"].inputs
    sky["Color"].default_value = (0.6, 0.7, 0.9, 1)
    sky["Strength"].default_value = 0.5


def main():
    arguments = read_arguments()
    lists = sorted(arguments.sequence.glob("sequence.gl*.series"))
    if not lists:
        sys.exit(f"{arguments.sequence} holds no glTF: replay with --sequence EVERY --meshes glb")
    steps = json.loads(lists[0].read_text())["files"]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene

    frame_of = [1 + round(step["time"] * RATE * arguments.slower) for step in steps]
    frame_of.append(frame_of[-1] + 1)
    everything = []
    for number, step in enumerate(steps):
        if frame_of[number] == frame_of[number + 1]:
            continue  # the next one is in the same frame
        meshes = import_step(arguments.sequence / step["name"])
        show_only(meshes, frame_of[number], frame_of[number + 1])
        everything += meshes
    share_materials()
    set_stage(everything)

    scene.frame_start, scene.frame_end = 1, frame_of[-1] - 1
    scene.render.fps = RATE
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = arguments.samples
    scene.cycles.use_denoising = False  # Blender of Debian 12 is built without
    width, height = arguments.size.split("x")
    scene.render.resolution_x, scene.render.resolution_y = int(width), int(height)
    bpy.ops.wm.save_as_mainfile(filepath=str(arguments.blend.resolve()))
    if arguments.frames:
        scene.render.filepath = str(arguments.frames.resolve()) + "/"
        bpy.ops.render.render(animation=True)


main()
