"""Which pixels see virtual objects (red) and real mirrors or glass (green): shares of the pixel."""

import bpy
import numpy

from rendering import render, set_up
from truth_scene import is_virtual, meshes, show_virtual


def _glow(name, color):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    emission, output = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    emission.inputs["Color"].default_value = color
    material.node_tree.links.new(emission.outputs["Emission"], output.inputs["Surface"])
    return material


def render_mask(real_specular):
    """The last picture of a scene: its materials are lost. real_specular: names of objects."""
    colors = {"virtual": (1, 0, 0, 1), "specular": (0, 1, 0, 1), "other": (0, 0, 0, 1)}
    glow = {name: _glow(name, color) for name, color in colors.items()}
    for thing in meshes():
        kind = ("virtual" if is_virtual(thing) else
                "specular" if thing.name in real_specular else "other")
        thing.data = thing.data.copy()  # meshes may be shared by virtual and real objects
        for slot in thing.material_slots:
            slot.material = glow[kind]
    bpy.context.scene.world = None
    show_virtual(True)
    set_up(64, False)
    bpy.context.scene.cycles.use_adaptive_sampling = False
    return numpy.rint(255 * numpy.clip(render(1), 0, 1)).astype(numpy.uint8)
