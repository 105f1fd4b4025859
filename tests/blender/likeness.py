"""The complex scene's likeness, modelled in Blender.

Places and sizes are read from deploy/scenes/complex.gltf, whose boxes stand on their origin and whose spheres have a
radius of 1; the shapes are Blender's own.
"""

import json
import pathlib

import bpy
from mathutils import Matrix, Quaternion, Vector

SCENES = pathlib.Path(__file__).resolve().parents[2] / "deploy/scenes"
REAL = ("table", "real mirror")
MIRRORS = ("real mirror", "virtual mirror", "mirror sphere")
GLASS = "glass sphere"


def _z_up(v):
    return Vector((v[0], -v[2], v[1]))


def _shape(name):
    if "sphere" in name:
        bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32)
        bpy.ops.object.shade_smooth()
    elif name == "table":
        bpy.ops.mesh.primitive_plane_add(size=1)
        bpy.context.object.data.transform(Matrix.Diagonal((1.2, 0.9, 1, 1)) @ Matrix.Translation((-1 / 24, 1 / 18, 0)))
    else:
        bpy.ops.mesh.primitive_cube_add(size=1)
        bpy.context.object.data.transform(Matrix.Translation((0, 0, 0.5)))
    thing = bpy.context.object
    thing.name = name
    return thing


def _place(thing, node):
    thing.location = _z_up(node.get("translation", (0, 0, 0)))
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    thing.rotation_mode = "QUATERNION"
    thing.rotation_quaternion = Quaternion((w, x, -z, y))
    sx, sy, sz = node.get("scale", (1, 1, 1))
    thing.scale = (sx, sz, sy)


def build():
    """An empty file with the shapes in place: no roles, markers or materials but plain ones."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    shape_all()


def shape_all():
    for node in json.loads((SCENES / "complex.gltf").read_text())["nodes"]:
        thing = _shape(node["name"])
        _place(thing, node)
        material = bpy.data.materials.new(node["name"])
        material.use_nodes = True
        thing.data.materials.append(material)


def say_by_panel():
    """Roles, markers and materials as the add-on's panel sets them."""
    scene = bpy.context.scene
    scene.amalgam_world_marker = 40
    scene.amalgam_dictionary = "DICT_6X6_250"
    scene.amalgam_marker_length = 0.05
    scene.amalgam_environment = str(SCENES / "environment.exr")
    for thing in bpy.data.objects:
        thing.amalgam_role = "real" if thing.name in REAL else "virtual"
    for name in (*MIRRORS, GLASS):
        bpy.context.view_layer.objects.active = bpy.data.objects[name]
        made = bpy.ops.amalgam.glass() if name == GLASS else bpy.ops.amalgam.mirror()
        assert made == {"FINISHED"}
    bpy.ops.amalgam.guide()
