"""The tab "Amalgam" of the 3D view's side bar."""

import bpy

from . import materials
from .problem_list import list_problems


class _Panel:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Amalgam"

    @property
    def column(self):
        self.layout.use_property_decorate = False
        return self.layout.column()


class AMALGAM_PT_scene(_Panel, bpy.types.Panel):
    bl_label = "Scene"

    def draw(self, context):
        column = self.column
        # The bar is narrow: numbers have their names within, the others none or above.
        column.prop(context.scene, "amalgam_world_marker")
        column.prop(context.scene, "amalgam_marker_length")
        column.prop(context.scene, "amalgam_dictionary", text="")
        column.label(text="Environment")
        column.prop(context.scene, "amalgam_environment", text="")
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
        list_problems(column, context)


_CLASSES = (AMALGAM_PT_scene, AMALGAM_PT_object, AMALGAM_PT_material, AMALGAM_PT_export)


def register():
    for made in _CLASSES:
        bpy.utils.register_class(made)


def unregister():
    for made in _CLASSES:
        bpy.utils.unregister_class(made)
