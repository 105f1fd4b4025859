"""Glass in glass as Cycles needs it: each surface once, with the ratio of the indices at it.

Amalgam's rays carry a list of the solids that they are inside, and so does the scene file: tea that
reaches half way into its tumbler, a bubble with the index of air. Cycles knows only surfaces.
"""

import bmesh
import bpy
from mathutils import Vector

from materials import dielectric

GLASS, TEA = 1.5, 1.33
_HORIZONTAL = Vector((1, 1, 0))


def _edit(thing, change):
    mesh = bmesh.new()
    mesh.from_mesh(thing.data)
    change(mesh)
    mesh.to_mesh(thing.data)
    mesh.free()


def _forget_stored_normals(thing):
    """They are of the faces as imported. Those that vertices share, or do not, are as good."""
    bpy.context.view_layer.objects.active = thing
    bpy.ops.mesh.customdata_custom_splitnormals_clear()
    thing.data.use_auto_smooth = False


def _turn_inside_out(mesh):
    bmesh.ops.reverse_faces(mesh, faces=mesh.faces)


def _hollow(ball, bubble):
    """The bubble's surface becomes one of the ball, whose outside lies in the bubble."""
    bubble.data.materials[0] = ball.data.materials[0]
    _edit(bubble, _turn_inside_out)
    bpy.ops.object.select_all(action="DESELECT")
    for thing in (bubble, ball):
        _forget_stored_normals(thing)
        thing.select_set(True)
    bpy.context.view_layer.objects.active = ball
    bpy.ops.object.join()


def _without_wet_wall(level):
    """Where tea reaches into the glass, the glass's own inner wall is not seen."""

    def change(mesh):
        everything = mesh.faces[:] + mesh.edges[:] + mesh.verts[:]
        bmesh.ops.bisect_plane(mesh, geom=everything, plane_co=(0, 0, level), plane_no=(0, 0, 1))
        wet = [face for face in mesh.faces if face.calc_center_median().z < level and
               (face.normal.z > 0.9 or face.normal.dot(
                   face.calc_center_median() * _HORIZONTAL) < -1e-6)]
        bmesh.ops.delete(mesh, geom=wet, context="FACES")

    return change


def _against_air_on_top(top):
    """The tea's index at its surface, the ratio to the glass's elsewhere. One material, because
    Cycles would not take leaving by a second one for leaving the first one's volume."""

    def index(builder):
        place = builder.add("ShaderNodeNewGeometry").outputs["Position"]
        height = builder.add("ShaderNodeSeparateXYZ", Vector=place).outputs["Z"]
        on_top = builder.add("ShaderNodeMath")
        on_top.operation = "GREATER_THAN"
        builder.tree.links.new(height, on_top.inputs[0])
        on_top.inputs[1].default_value = top - 1e-5
        scaled = builder.add("ShaderNodeMath")
        scaled.operation = "MULTIPLY_ADD"
        builder.tree.links.new(on_top.outputs[0], scaled.inputs[0])
        scaled.inputs[1].default_value = TEA - TEA / GLASS
        scaled.inputs[2].default_value = TEA / GLASS
        return scaled.outputs[0]

    return index


def mend_nested_glass(gltf, straight_shadows):
    objects = bpy.data.objects
    if "bubble" in objects:
        _hollow(objects["glass ball"], objects["bubble"])
    if "tea" not in objects:
        return
    tea, tumbler = objects["tea"], objects["tumbler"]
    definition = next(m for m in gltf["materials"] if m["name"] == "tea")
    level = max(vertex.co.z for vertex in tea.data.vertices)
    bpy.context.view_layer.update()
    top = (tea.matrix_world @ Vector((0, 0, level))).z
    dielectric(bpy.data.materials["tea"], _against_air_on_top(top),
               definition["extensions"]["KHR_materials_volume"], straight_shadows)
    _forget_stored_normals(tumbler)
    _edit(tumbler, _without_wet_wall(level))
