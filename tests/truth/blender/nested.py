"""Glass in glass as Cycles needs it: each surface once, with the ratio of the indices at it.

Amalgam's rays carry a list of the solids that they are inside, and so does the scene file: tea that
reaches half way into its tumbler, a bubble with the index of air. Cycles knows only surfaces.
"""

import bmesh
import bpy

from materials import dielectric

GLASS, TEA = 1.5, 1.33


def _edit(thing, change):
    mesh = bmesh.new()
    mesh.from_mesh(thing.data)
    change(mesh)
    mesh.to_mesh(thing.data)
    mesh.free()


def _turn_inside_out(mesh):
    bmesh.ops.reverse_faces(mesh, faces=mesh.faces)


def _hollow(ball, bubble):
    """The bubble's surface becomes one of the ball, whose outside lies in the bubble."""
    bubble.data.materials[0] = ball.data.materials[0]
    _edit(bubble, _turn_inside_out)
    bpy.ops.object.select_all(action="DESELECT")
    for thing in (bubble, ball):
        thing.data.use_auto_smooth = False  # the stored normals still point the other way
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


from mathutils import Vector  # noqa: E402

_HORIZONTAL = Vector((1, 1, 0))


def mend_nested_glass(gltf, straight_shadows):
    objects = bpy.data.objects
    if "bubble" in objects:
        _hollow(objects["glass ball"], objects["bubble"])
    if "tea" not in objects:
        return
    tea, tumbler = objects["tea"], objects["tumbler"]
    volume = next(m for m in gltf["materials"] if m["name"] == "tea")["extensions"][
        "KHR_materials_volume"]
    wetted = bpy.data.materials.new("tea at glass")
    dielectric(wetted, TEA / GLASS, volume, straight_shadows)
    tea.data.materials.append(wetted)
    for polygon in tea.data.polygons:
        polygon.material_index = 0 if polygon.normal.z > 0.9 else 1
    level = max(vertex.co.z for vertex in tea.data.vertices)
    tumbler.data.use_auto_smooth = True
    _edit(tumbler, _without_wet_wall(level))
