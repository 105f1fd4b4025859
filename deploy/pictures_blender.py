"""Photographs Blender's window with the add-on: the panel, and the export.

    blender --factory-startup --enable-event-simulate -p 0 0 1120 700 -P pictures_blender.py -- OUTPUT

Writes panel.png, export.png and desk.gltf to the folder OUTPUT. Needs a screen, such as Xvfb's.
"""

import importlib
import pathlib
import shutil
import sys
import traceback

import bpy
from mathutils import Euler, Vector

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path += [str(ROOT / "tests/blender"), str(ROOT / "deploy/blender")]

import likeness  # noqa: E402

OUT = pathlib.Path(sys.argv[sys.argv.index("--") + 1]).resolve()
# As the solid view shows them.
REAL, VIRTUAL = (0.5, 0.55, 0.5, 1), (0.85, 0.6, 0.35, 1)
CUBE = (0.7, 0.2, 0.03, 1)


def _view():
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    return {"window": window, "screen": window.screen, "area": area,
            "region": next(region for region in area.regions if region.type == "WINDOW")}


def _photograph(name):
    # The whole window: what is in front of the view belongs to it.
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=2)
        bpy.ops.screen.screenshot(filepath=str(OUT / name), check_existing=False)


def _choose_our_tab():
    """Blender 3.4 has no call for it, so that the mouse does it. The window's size fixes the fourth tab's place."""
    area = _view()["area"]
    bar = next(region for region in area.regions if region.type == "UI")
    place = {"x": bar.x + bar.width - 10, "y": bar.y + bar.height - 165}
    window = bpy.context.window_manager.windows[0]
    window.event_simulate(type="MOUSEMOVE", value="NOTHING", **place)
    for value in ("PRESS", "RELEASE"):
        window.event_simulate(type="LEFTMOUSE", value=value, **place)


def _look():
    space = _view()["area"].spaces.active
    space.show_region_ui = True
    space.overlay.show_relationship_lines = False
    space.clip_start = 0.001
    space.shading.color_type = "OBJECT"
    for thing in bpy.data.objects:
        thing.color = REAL if thing.name in likeness.REAL else VIRTUAL
    eye = space.region_3d
    eye.view_perspective = "PERSP"
    eye.view_location, eye.view_distance = Vector((0.03, 0.07, 0.03)), 0.62
    eye.view_rotation = Euler((1.05, 0, -0.15)).to_quaternion()


def _build():
    importlib.import_module("amalgam_scene").register()
    with bpy.context.temp_override(**_view()):
        for thing in list(bpy.data.objects):
            bpy.data.objects.remove(thing)
        likeness.shape_all()
        likeness.say_by_panel()
        # The photograph has no mirror.
        bpy.data.objects.remove(bpy.data.objects["real mirror"])
        cube = bpy.data.objects["marble cube"].active_material
        cube.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = CUBE
        # Beside the file, as in a folder of one's own.
        shutil.copy(likeness.SCENES / "environment.exr", OUT)
        bpy.ops.wm.save_as_mainfile(filepath=str(OUT / "desk.blend"))
        bpy.context.scene.amalgam_environment = "//environment.exr"
        bpy.ops.object.select_all(action="DESELECT")
        glass = bpy.data.objects[likeness.GLASS]
        glass.select_set(True)
        bpy.context.view_layer.objects.active = glass
        bpy.ops.amalgam.check()
    _look()


def _export():
    with bpy.context.temp_override(**_view()):
        bpy.ops.export_scene.amalgam(filepath=str(OUT / "desk.gltf"))
        # One mistake, so that the picture shows how it is told.
        nodes = bpy.data.objects[likeness.GLASS].active_material.node_tree.nodes
        nodes.remove(next(node for node in nodes if node.type == "GROUP"))
        bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
        bpy.ops.export_scene.amalgam("INVOKE_DEFAULT", filepath=str(OUT / "desk.gltf"))


# What Blender's window does only between two turns of its loop must be waited for.
STEPS = [_build, _choose_our_tab, lambda: None, lambda: _photograph("panel.png"), _export, lambda: None,
         lambda: _photograph("export.png"), lambda: bpy.ops.wm.quit_blender()]


def _step():
    try:
        STEPS.pop(0)()
    except Exception:
        traceback.print_exc()
        bpy.ops.wm.quit_blender()
    return 0.5 if STEPS else None


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(_step, first_interval=1.0)
