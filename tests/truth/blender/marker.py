"""The printed marker whose pose the camera knows: a sheet of paper on the table.

A real camera image always has one, and its paper is the one thing in it whose color is known.
"""

import bpy
import numpy

from surfaces import Nodes

SIDE = 0.05  # metres, of the black square
MARGIN_CELLS = 2  # white, as amalgam-marker prints it
ABOVE_TABLE = 0.0001
PAPER, INK = (0.84, 0.83, 0.80), (0.045, 0.045, 0.047)
# DICT_6X6_250, number 40, seen from above with +y up. 1 is white.
CELLS = ("011001", "000000", "100111", "101000", "101000", "001011")


def _cell_values():
    black_border = numpy.pad([[float(c) for c in row] for row in CELLS], 1)
    return numpy.pad(black_border, MARGIN_CELLS, constant_values=1.0)


def _image():
    values = _cell_values()[::-1]  # Blender's rows begin at the bottom
    image = bpy.data.images.new("marker", *values.shape[::-1], float_buffer=True)
    image.colorspace_settings.name = "Non-Color"
    image.pixels.foreach_set(numpy.repeat(values, 4).astype(numpy.float32))
    image.pack()
    return image


def _material():
    material = bpy.data.materials.new("marker")
    nodes = Nodes(material)
    white = nodes.add("ShaderNodeTexImage", image=_image(), interpolation="Closest")
    color = nodes.ramp(white.outputs["Color"], INK, PAPER)
    diffuse = nodes.add("ShaderNodeBsdfDiffuse", {"Color": color})
    nodes.add("ShaderNodeOutputMaterial", {"Surface": diffuse.outputs["BSDF"]})
    return material


def lay_marker():
    """At the world's origin, which is the marker's centre; Blender's axes are the marker's."""
    cells = len(CELLS) + 2
    half = SIDE / 2 * (cells + 2 * MARGIN_CELLS) / cells
    mesh = bpy.data.meshes.new("marker")
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    mesh.from_pydata([(half * x, half * y, ABOVE_TABLE) for x, y in corners], [], [(0, 1, 2, 3)])
    uv = mesh.uv_layers.new()
    for loop, (x, y) in enumerate(corners):
        uv.data[loop].uv = ((x + 1) / 2, (y + 1) / 2)
    mesh.materials.append(_material())
    sheet = bpy.data.objects.new("marker", mesh)
    sheet["amalgam"] = {"role": "real"}
    bpy.context.scene.collection.objects.link(sheet)
