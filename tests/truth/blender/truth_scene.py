"""A scene of ours in Blender: geometry by Blender's importer, whose axes are OpenCV's on a marker
(x, y, z) = glTF's (x, -z, y); roles, camera and environment by our own conventions."""

import json
import math
import pathlib

import addon_utils
import bpy
import numpy
from mathutils import Matrix, Quaternion, Vector

from marker import lay_marker
from materials import build_materials
from nested import mend_nested_glass
from surfaces import dress_table

# Blender 3.4's importer still uses the name, which numpy has dropped.
numpy.bool = bool

# OpenCV's camera looks along +z with y down, Blender's along -z with y up.
_OPENCV_FROM_BLENDER_CAMERA = Matrix.Diagonal((1, -1, -1, 1))


def load(path, surface, straight_shadows):
    """path: of the glTF file."""
    path = pathlib.Path(path)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon_utils.enable("io_scene_gltf2")
    bpy.ops.import_scene.gltf(filepath=str(path))
    gltf = json.loads(path.read_text())
    build_materials(gltf, path.parent, straight_shadows)
    mend_nested_glass(gltf, straight_shadows)
    dress_table(surface)
    lay_marker()


def is_virtual(thing):
    """Children inherit; what says nothing is virtual."""
    while thing is not None:
        role = thing.get("amalgam", {}).get("role")
        if role is not None:
            return role == "virtual"
        thing = thing.parent
    return True


def meshes():
    return [thing for thing in bpy.data.objects if thing.type == "MESH"]


def show_virtual(shown):
    for thing in meshes():
        thing.hide_render = is_virtual(thing) and not shown


def place_camera(camera):
    """camera: of cases.json. Pixel (0, 0) is the centre of the top left one."""
    data = bpy.data.cameras.new("camera")
    width, height = camera["width"], camera["height"]
    data.sensor_fit = "HORIZONTAL"
    data.sensor_width = 36.0
    data.lens = camera["focal"] * data.sensor_width / width
    data.shift_x = ((width - 1) / 2 - camera["cx"]) / width
    data.shift_y = (camera["cy"] - (height - 1) / 2) / width
    data.clip_start, data.clip_end = 1e-3, 100.0
    x, y, z, w = camera["pose"]["rotation"]
    camera_from_marker = (Matrix.Translation(Vector(camera["pose"]["translation"])) @
                          Quaternion((w, x, y, z)).normalized().to_matrix().to_4x4())
    thing = bpy.data.objects.new("camera", data)
    thing.matrix_world = camera_from_marker.inverted() @ _OPENCV_FROM_BLENDER_CAMERA
    scene = bpy.context.scene
    scene.collection.objects.link(thing)
    scene.camera = thing
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100


def light_by(environment):
    """Cycles' map has +X at its centre; ours glTF's +Z, which is -Y here: a quarter turn."""
    world = bpy.data.worlds.new("environment")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    nodes.clear()
    place = nodes.new("ShaderNodeTexCoord")
    turn = nodes.new("ShaderNodeMapping")
    turn.inputs["Rotation"].default_value = (0, 0, math.pi / 2)
    texture = nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(str(environment), check_existing=False)
    background = nodes.new("ShaderNodeBackground")
    output = nodes.new("ShaderNodeOutputWorld")
    links.new(place.outputs["Generated"], turn.inputs["Vector"])
    links.new(turn.outputs["Vector"], texture.inputs["Vector"])
    links.new(texture.outputs["Color"], background.inputs["Color"])
    links.new(background.outputs["Background"], output.inputs["Surface"])
    world.cycles.sampling_method = "MANUAL"
    # As wide as the widest of our maps. Blender's own choice takes 4 s a picture.
    world.cycles.sample_map_resolution = 256


def hide_lamps():
    """Surfaces that glow stay visible, but do not light others: Amalgam's do not either."""
    for thing in meshes():
        for slot in thing.material_slots:
            shader = slot.material.node_tree.nodes.get("Principled BSDF")
            if shader and shader.inputs["Emission Strength"].default_value > 1:
                thing.visible_diffuse = False
