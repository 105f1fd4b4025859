"""The tab "Amalgam" of the 3D view's side bar."""

import textwrap

import bpy

from . import materials, problems


class _Panel:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Amalgam"

    @property
    def column(self):
        self.layout.use_property_split = True
        self.layout.use_property_decorate = False
        return self.layout.column()


class AMALGAM_PT_scene(_Panel, bpy.types.Panel):
    bl_label = "Scene"

    def draw(self, context):
        column = self.column
        for field in ("world_marker", "dictionary", "marker_length", "environment"):
            column.prop(context.scene, f"amalgam_{field}")
        column.operator("amalgam.guide")


class _ObjectPanel(_Panel):
    @classmethod
    def poll(cls, context):
        return context.object is not None


class AMALGAM_PT_object(_ObjectPanel, bpy.types.Panel):
    bl_label = "Object"

    def draw(self, context):
        column = self.column
        column.label(text=context.object.name, icon="OBJECT_DATA")
        column.prop(context.object, "amalgam_role")
        column.prop(context.object, "amalgam_marker")


class AMALGAM_PT_material(_ObjectPanel, bpy.types.Panel):
    bl_label = "Material"

    def draw(self, context):
        column = self.column
        material = context.object.active_material
        if material:
            column.label(text=f"{material.name}: {materials.kind_of(material)}", icon="MATERIAL")
        row = column.row()
        row.operator("amalgam.glass")
        row.operator("amalgam.mirror")


class AMALGAM_PT_export(_Panel, bpy.types.Panel):
    bl_label = "Export"

    def draw(self, context):
        column = self.column
        column.operator("amalgam.check")
        column.operator("export_scene.amalgam", text="Export for Amalgam...")
        if problems.found == []:
            column.label(text="Nothing seems wrong", icon="CHECKMARK")
        # Labels do not wrap by themselves; a letter is about 7 pixels wide.
        width = max(int(context.region.width / (7 * context.preferences.system.ui_scale)), 20)
        for problem in problems.found or ():
            lines = textwrap.wrap(problem, width)
            column.label(text=lines[0], icon="ERROR")
            for line in lines[1:]:
                column.label(text=line, icon="BLANK1")


_CLASSES = (AMALGAM_PT_scene, AMALGAM_PT_object, AMALGAM_PT_material, AMALGAM_PT_export)


def register():
    for made in _CLASSES:
        bpy.utils.register_class(made)


def unregister():
    for made in _CLASSES:
        bpy.utils.unregister_class(made)
