"""File > Export > Amalgam scene: Blender's own glTF exporter with the options that Amalgam needs."""

import contextlib
import pathlib
import shutil

import bpy
from bpy_extras.io_utils import ExportHelper

from . import own_block, problems
from .problem_list import list_problems

_OPTIONS = {
    "export_extras": True,  # our roles and markers
    "export_yup": True,
    "export_apply": True,  # modifiers
    "export_lights": True,
    "export_cameras": False,
    "export_animations": False,
    "export_skins": False,
    "export_morph": False,
    "export_tangents": False,  # the server makes its own
    "use_renderable": True,
    "use_active_scene": True,
    # Watts as radiometry has them, which go with the radiance of an environment map. Blender 3.6 renamed the option.
    "convert_lighting_mode": "COMPAT",
    "export_import_convert_lighting_mode": "COMPAT",
}


def _write_gltf(path):
    known = bpy.ops.export_scene.gltf.get_rna_type().properties.keys()
    options = {name: value for name, value in _OPTIONS.items() if name in known}
    is_binary = path.suffix.lower() == ".glb"
    bpy.ops.export_scene.gltf(filepath=str(path), export_format="GLB" if is_binary else "GLTF_SEPARATE", **options)


def _copy_beside(file, folder):
    target = folder / file.name
    if not (target.exists() and target.samefile(file)):
        shutil.copyfile(file, target)


@contextlib.contextmanager
def _as_exported(scene, folder):
    """The scene as the file must say it: the environment beside it, Cycles' shadow catchers as real."""
    kept = own_block.read(scene).get("environment")
    file = problems.environment_file(scene)
    catchers = [thing for thing in problems.exported(scene) if problems.becomes_real(thing)]
    is_there = bool(file) and file.is_file()
    try:
        if file:
            own_block.write(scene, "environment", file.name if is_there else None)
        if is_there:
            _copy_beside(file, folder)
        for thing in catchers:
            own_block.write(thing, "role", "real")
        yield
    finally:
        if file:
            own_block.write(scene, "environment", kept)
        for thing in catchers:
            own_block.write(thing, "role", None)


class EXPORT_SCENE_OT_amalgam(bpy.types.Operator, ExportHelper):
    """Write the scene as glTF with its roles and markers, and say what is probably wrong with it"""

    bl_idname = "export_scene.amalgam"
    bl_label = "Export for Amalgam"

    filename_ext = ".gltf"
    check_extension = None  # .glb is right too
    filter_glob: bpy.props.StringProperty(default="*.gltf;*.glb", options={"HIDDEN"})
    strict: bpy.props.BoolProperty(
        name="Only if nothing seems wrong", default=False, description="Write no file if the check finds a problem")

    def draw(self, context):
        self.layout.label(text="A name ending with .glb makes one file")
        self.layout.prop(self, "strict")
        list_problems(self.layout.column(), context)

    def invoke(self, context, event):
        problems.find(context)
        return super().invoke(context, event)

    def execute(self, context):
        path = pathlib.Path(bpy.path.abspath(self.filepath))
        if path.suffix.lower() not in (".gltf", ".glb"):
            path = path.with_name(path.name + self.filename_ext)
        wrong = problems.find(context)
        for problem in wrong:
            self.report({"WARNING"}, problem)
        if wrong and self.strict:
            self.report({"WARNING"}, "Nothing was written")
            return {"CANCELLED"}
        with _as_exported(context.scene, path.parent):
            _write_gltf(path)
        self.report({"INFO"}, f"Wrote {path}")
        return {"FINISHED"}


def _menu(menu, _):
    menu.layout.operator(EXPORT_SCENE_OT_amalgam.bl_idname, text="Amalgam scene (.gltf/.glb)")


def register():
    bpy.utils.register_class(EXPORT_SCENE_OT_amalgam)
    bpy.types.TOPBAR_MT_file_export.append(_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(_menu)
    bpy.utils.unregister_class(EXPORT_SCENE_OT_amalgam)
