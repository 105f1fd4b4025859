"""What is probably wrong with a scene, in words. amalgam-inspect finds more, in the exported file."""

import pathlib

import bmesh
import bpy
from mathutils import Vector

from . import materials, own_block, properties

# Metres. Farther off or larger, and the scene was probably not modelled in metres.
_FAR, _LARGE, _SMALL = 5.0, 20.0, 0.001

# What the last check found, for the panel; None before the first one.
found = None


def exported(scene):
    """Objects that become nodes with a surface."""
    surfaces = {"MESH", "CURVE", "SURFACE", "META", "FONT"}
    return [o for o in scene.objects if o.type in surfaces and not o.hide_render]


def environment_file(scene):
    """Where the scene's environment is on this disk, or None."""
    name = scene.amalgam_environment
    return pathlib.Path(bpy.path.abspath(name)) if name else None


def becomes_real(thing):
    """Cycles' flag, which Blender does not export, says the same as our role."""
    return getattr(thing, "is_shadow_catcher", False) and "role" not in own_block.read(thing)


def _is_closed(thing, depsgraph):
    evaluated = thing.evaluated_get(depsgraph)
    shape = bmesh.new()
    shape.from_mesh(evaluated.to_mesh())
    # Seams of the texture or of flat shading are drawn apart, but are closed all the same.
    bmesh.ops.remove_doubles(shape, verts=shape.verts, dist=1e-7)
    closed = bool(shape.edges) and all(len(edge.link_faces) == 2 for edge in shape.edges)
    shape.free()
    evaluated.to_mesh_clear()
    return closed


def _scene_problems(scene):
    if scene.amalgam_world_marker == properties.NO_MARKER:
        yield "No world marker: the scene will stand on marker 0."
    if scene.unit_settings.system != "NONE" and abs(scene.unit_settings.scale_length - 1) > 1e-6:
        yield (f"The unit scale is {scene.unit_settings.scale_length:g}: glTF has metres, and takes each of Blender's "
               "units for one.")
    if not exported(scene):
        yield "There is no object to export."
    environment = environment_file(scene)
    if environment and not environment.is_file():
        yield f"The environment {environment.name} is not there; it is left out."
    has_lamp = any(o.type == "LIGHT" and o.data.type in ("POINT", "SUN", "SPOT") and not o.hide_render
                   for o in scene.objects)
    if not environment and not has_lamp:
        yield "No light: add an environment, or a sun, point or spot light."
    for lamp in scene.objects:
        if lamp.type == "LIGHT" and lamp.data.type == "AREA" and not lamp.hide_render:
            yield f"{lamp.name}: glTF has no area lights; it is left out."
    world = scene.world
    if not environment and world and world.node_tree and \
            any(node.type == "TEX_ENVIRONMENT" for node in world.node_tree.nodes):
        yield "The world's picture is not exported: choose it as the scene's environment in the panel Amalgam."


def _corners(thing):
    return [thing.matrix_world @ Vector(corner) for corner in thing.bound_box]


def _object_problems(thing, depsgraph):
    if becomes_real(thing):
        yield f"{thing.name}: a shadow catcher, exported as real."
    if thing.amalgam_marker != properties.NO_MARKER and thing.parent:
        yield f"{thing.name}: has a marker of its own; its parent's place does not count."
    corners = _corners(thing)
    size = max((max(c[i] for c in corners) - min(c[i] for c in corners)) for i in range(3))
    nearest = Vector(max(min(c[i] for c in corners), -max(c[i] for c in corners), 0) for i in range(3)).length
    if nearest > _FAR:
        yield f"{thing.name}: {nearest:.3g} m from its marker. Is it modelled in metres, about the origin?"
    elif size > _LARGE or size < _SMALL:
        yield f"{thing.name}: {size:.3g} m large. Is it modelled in metres?"
    kinds = {materials.kind_of(slot.material) for slot in thing.material_slots if slot.material}
    if not kinds & {"solid glass", "thin glass"} or thing.type != "MESH":
        return
    closed = _is_closed(thing, depsgraph)
    if "solid glass" in kinds and not closed:
        yield f"{thing.name}: solid glass must be closed; its mesh has holes, or faces within."
    flat = min(thing.dimensions) <= 0.1 * max(thing.dimensions)
    if "thin glass" in kinds and closed and not flat:
        yield f"{thing.name}: thin glass, light goes through without bending. 'Solid glass' makes it a body."


def _typed_problems(holder):
    if not own_block.is_readable(holder):
        yield f"{holder.name}: its custom property 'amalgam' is no JSON object, such as {{\"role\": \"real\"}}."


def find(context):
    """A list of sentences, empty if nothing seems wrong."""
    global found
    scene = context.scene
    depsgraph = context.evaluated_depsgraph_get()
    problems = [*_typed_problems(scene), *_scene_problems(scene)]
    for thing in exported(scene):
        problems += [*_typed_problems(thing), *_object_problems(thing, depsgraph)]
    found = problems
    return problems


class AMALGAM_OT_check(bpy.types.Operator):
    """Look for what is probably wrong with the scene"""

    bl_idname = "amalgam.check"
    bl_label = "Check"

    def execute(self, context):
        for problem in find(context):
            self.report({"WARNING"}, problem)
        return {"FINISHED"}


def register():
    bpy.utils.register_class(AMALGAM_OT_check)


def unregister():
    bpy.utils.unregister_class(AMALGAM_OT_check)
