"""The radiance of a white straw in water under an even sky of radiance 1, by Cycles.

    blender -b --factory-startup -P straw.py -- SAMPLES

The figures are kept in tests/unit/trace/interface_radiance_test.cpp: the straw's top seen from above,
and its side seen at 45 degrees. "one": light that the straw scatters once; "full": any number of times.
"""

import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import bpy  # noqa: E402
from mathutils import Vector  # noqa: E402

from materials import dielectric  # noqa: E402
from rendering import render, set_up  # noqa: E402

INDEX = 1.33


def _box(name, low, high, material):
    bpy.ops.mesh.primitive_cube_add(size=1.0)
    thing = bpy.context.object
    thing.name = name
    thing.location = (Vector(low) + Vector(high)) / 2
    thing.scale = Vector(high) - Vector(low)
    thing.data.materials.append(material)


def _white():
    material = bpy.data.materials.new("white")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (1, 1, 1, 1)
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs["BSDF"], output.inputs["Surface"])
    return material


def _look(eye, target):
    data = bpy.data.cameras.new("camera")
    data.angle = 0.004
    thing = bpy.data.objects.new("camera", data)
    thing.location = eye
    thing.rotation_euler = (Vector(target) - Vector(eye)).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(thing)
    bpy.context.scene.camera = thing
    bpy.context.scene.render.resolution_x = bpy.context.scene.render.resolution_y = 8


def main():
    samples = int(sys.argv[sys.argv.index("--") + 1])
    bpy.ops.wm.read_factory_settings(use_empty=True)
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
    water = bpy.data.materials.new("water")
    dielectric(water, INDEX, {}, straight_shadows=False)
    _box("water", (-1, -1, -1), (1, 1, 0), water)
    _box("straw", (-0.05, -0.05, -0.8), (0.05, 0.05, -0.2), _white())
    slant = math.radians(45)
    within = math.asin(math.sin(slant) / INDEX)
    meets = Vector((0.05 + 0.4 * math.tan(within), 0.01, 0))
    views = {"top": ((0.01, 0.01, 2), (0.01, 0.01, 0)),
             "side": (meets + 2 * Vector((math.sin(slant), 0, math.cos(slant))), meets)}
    for name, (eye, target) in views.items():
        _look(eye, target)
        for kind, bounces in (("one", 1), ("full", 12)):
            set_up(samples, True)
            bpy.context.scene.cycles.diffuse_bounces = bounces
            bpy.context.scene.cycles.adaptive_threshold = 0.002
            a, b = render(1), render(2)
            print(f"straw: {name} {kind} {(a.mean() + b.mean()) / 2:.4f} +- "
                  f"{abs(a.mean() - b.mean()) / 2:.4f}", flush=True)


main()
