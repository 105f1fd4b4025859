"""A square where the marker lies, to model on. It is not exported: it is left out of renderings."""

import bpy

_NAME = "marker guide"


class AMALGAM_OT_guide(bpy.types.Operator):
    """Show where the marker lies, as wide as its black square; its short side bar points up on the paper"""

    bl_idname = "amalgam.guide"
    bl_label = "Show the marker"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        half = context.scene.amalgam_marker_length / 2
        corners = [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)]
        up = [(0, half, 0), (0, 1.4 * half, 0)]
        mesh = bpy.data.meshes.new(_NAME)
        mesh.from_pydata(corners + up, [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5)], [])
        guide = bpy.data.objects.get(_NAME)
        if guide:
            guide.data = mesh
        else:
            guide = bpy.data.objects.new(_NAME, mesh)
            context.scene.collection.objects.link(guide)
        guide.hide_render, guide.hide_select = True, True
        return {"FINISHED"}


def register():
    bpy.utils.register_class(AMALGAM_OT_guide)


def unregister():
    bpy.utils.unregister_class(AMALGAM_OT_guide)
