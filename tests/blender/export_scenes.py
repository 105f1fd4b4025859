"""Exports the likeness in many ways, for blender_scene_test.py to look at.

    blender -b --factory-startup --python-exit-code 1 -P export_scenes.py -- ADDON.zip OUTPUT

Writes scenes to the folder OUTPUT, and facts.json: what the add-on said of them. Ends with 77 if the exporter lacks
numpy, which Debian's package of Blender does not bring along.
"""

import contextlib
import importlib
import importlib.util
import json
import pathlib
import shutil
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import likeness  # noqa: E402

ZIP, OUTPUT = sys.argv[sys.argv.index("--") + 1:]
OUT = pathlib.Path(OUTPUT)
FACTS = {"problems": {}}


def _install():
    bpy.ops.preferences.addon_install(filepath=ZIP)
    bpy.ops.preferences.addon_enable(module="amalgam_scene")


def _problems():
    return list(importlib.import_module("amalgam_scene.problems").find(bpy.context))


def _export(name):
    bpy.ops.export_scene.amalgam(filepath=str(OUT / name))


def _export_by_hand(name):
    """As somebody would without the add-on: Blender's exporter, custom properties ticked."""
    bpy.ops.export_scene.gltf(filepath=str(OUT / name), export_format="GLTF_SEPARATE", export_extras=True,
                              use_renderable=True)


def _fresh():
    likeness.build()
    likeness.say_by_panel()


def _by_panel():
    _fresh()
    bpy.ops.mesh.primitive_cube_add()
    bpy.context.object.name = "left out of renderings"
    bpy.context.object.hide_render = True
    FACTS["problems"]["likeness"] = _problems()
    (OUT / "panel").mkdir()
    _export("panel/scene.gltf")
    _export("panel/binary.glb")
    FACTS["environment_after_export"] = bpy.context.scene.amalgam_environment
    bpy.ops.wm.save_as_mainfile(filepath=str(OUT / "saved.blend"))
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.wm.open_mainfile(filepath=str(OUT / "saved.blend"))
    _export("panel/reopened.gltf")


def _turn_into_typed():
    """The forms that people type: text, group, flag, floats."""
    scene, things = bpy.context.scene, bpy.data.objects
    for holder in (scene, *things):
        if "amalgam" in holder:
            del holder["amalgam"]
    scene["amalgam"] = '{"world_marker": 40, "marker_length": 0.05, "environment": "environment.exr"}'
    things["table"]["is_shadow_catcher"] = True
    things["real mirror"]["amalgam"] = '{"role": "real"}'
    things["virtual mirror"]["amalgam"] = {"role": "virtual", "marker": 40.0}
    things["glass sphere"]["a foreign property"] = [1.5, 2.5]


def _typed():
    _fresh()
    _turn_into_typed()
    (OUT / "typed").mkdir()
    shutil.copy(likeness.SCENES / "environment.exr", OUT / "typed")
    _export_by_hand("typed/scene.gltf")
    FACTS["panel_shows_typed"] = {thing.name: thing.amalgam_role for thing in bpy.data.objects}
    FACTS["panel_shows_typed_marker"] = bpy.context.scene.amalgam_world_marker
    # A change in the panel keeps what was typed besides.
    bpy.data.objects["real mirror"].amalgam_marker = 7
    FACTS["typed_and_changed"] = bpy.data.objects["real mirror"]["amalgam"].to_dict()


def _misspelt():
    _fresh()
    things = bpy.data.objects
    bpy.context.scene.amalgam_environment = ""
    things["table"]["rolle"] = "real"
    things["real mirror"]["amalgam_role"] = "real"
    things["glass sphere"]["Marker"] = 40
    things["marble cube"].data["amalgam"] = {"role": "real"}
    _export_by_hand("misspelt.gltf")


def _cycles_flag():
    _fresh()
    table = bpy.data.objects["table"]
    table.amalgam_role = "INHERITED"
    table.is_shadow_catcher = True
    bpy.context.scene.amalgam_environment = ""
    FACTS["problems"]["flag"] = _problems()
    _export("flag.gltf")
    _export_by_hand("flag-by-hand.gltf")
    FACTS["role_after_export"] = table.amalgam_role


def _cube_is_real():
    _fresh()
    bpy.data.objects["marble cube"].amalgam_role = "real"
    _export("panel/cube-real.gltf")


def _markers():
    """One object on another marker; a parent of which two children take the role."""
    _fresh()
    things = bpy.data.objects
    things["marble cube"].amalgam_marker = 23
    parent = things.new("parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.amalgam_role = "real"
    for name in ("mirror sphere", "glass sphere"):
        things[name].amalgam_role = "INHERITED"
        things[name].parent = parent
    FACTS["problems"]["markers"] = _problems()
    _export("panel/markers.gltf")


def _switched_off():
    """What was said stays in the file without the add-on."""
    _fresh()
    bpy.ops.preferences.addon_disable(module="amalgam_scene")
    FACTS["without_addon"] = bpy.data.objects["table"]["amalgam"].to_dict()


def _lamps():
    _fresh()
    bpy.context.scene.amalgam_environment = ""
    for kind, energy in (("SUN", 3.0), ("POINT", 100.0)):
        bpy.ops.object.light_add(type=kind, location=(0, 0, 1))
        bpy.context.object.data.energy = energy
        bpy.context.object.name = kind.lower()
    _export("lamps.gltf")


@contextlib.contextmanager
def _broken(name):
    _fresh()
    yield bpy.context.scene, bpy.data.objects
    bpy.context.view_layer.update()
    FACTS["problems"][name] = _problems()


def _broken_scenes():
    with _broken("no world marker") as (scene, things):
        scene.amalgam_world_marker = -1
        things["table"].amalgam_marker = 5
        things["table"].amalgam_marker = -1
    _export("cleared.gltf")
    with _broken("no light") as (scene, _):
        scene.amalgam_environment = ""
    with _broken("no file") as (scene, _):
        scene.amalgam_environment = "//nowhere.exr"
    with _broken("open glass") as (_, things):
        mesh = things["glass sphere"].data
        mesh.clear_geometry()
        mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [], [(0, 2, 1), (0, 1, 3), (0, 3, 2)])
    with _broken("split, but closed") as (_, things):
        things["glass sphere"].modifiers.new("split", "EDGE_SPLIT").split_angle = 0
    with _broken("thin glass") as (_, things):
        nodes = things["glass sphere"].active_material.node_tree.nodes
        nodes.remove(next(node for node in nodes if node.type == "GROUP"))
    with _broken("far") as (_, things):
        things["marble cube"].location.x = 12
    with _broken("centimetres") as (_, things):
        things["marble cube"].scale = (45, 45, 45)
    with _broken("units") as (scene, _):
        scene.unit_settings.scale_length = 0.01
    with _broken("text") as (_, things):
        things["table"]["amalgam"] = "{'role': 'real'}"
    before = set(OUT.iterdir())
    FACTS["strict"] = list(bpy.ops.export_scene.amalgam(filepath=str(OUT / "strict.gltf"), strict=True))
    FACTS["strict_wrote"] = [path.name for path in set(OUT.iterdir()) - before]


def main():
    if importlib.util.find_spec("numpy") is None:
        sys.exit(77)
    _install()
    for part in (_by_panel, _typed, _misspelt, _cycles_flag, _cube_is_real, _markers, _lamps, _broken_scenes,
                 _switched_off):
        part()
    (OUT / "facts.json").write_text(json.dumps(FACTS, indent=1))


main()
