#!/usr/bin/env python3
"""Writes the scenes that come with Amalgam, their textures and their environment maps.

    generate_scenes.py [--output DIR]      default: the folder of this script

The same bytes each time. complex.gltf is the complex scene of Celarek's thesis: 4,006 triangles.
"""

import argparse
from pathlib import Path

from generator.common import LIFT, glass_material, mirror_material, new_scene, turn
from generator.glassware import HAMMERED, glassware_scene
from generator.hammered import hammered
from generator.images import write_half_exr, write_palette_png, write_rgb_png
from generator.marble import marble
from generator.room import room
from generator.shapes import box, cone, sphere, torus
from generator.stiff import write_stiff_scenes

MARBLE = "marble.png"


def marble_material(scene):
    return scene.material("marble", (1.0, 1.0, 1.0), roughness=0.35, texture=scene.texture(MARBLE))


def complex_scene():
    """Marker 40 at the origin, the viewer at +Z looks down on it; mirrors stand at the back."""
    scene = new_scene()
    a_box, ball = box(), sphere(32, 32)
    # Mirrors lean back like pictures on an easel: the camera looks down, and upright ones would
    # show it the desk alone. The glass stands half on a marker of the photograph that the demo
    # uses, to refract it.
    scene.add("real mirror", a_box, mirror_material(scene, "real mirror", 0.9), role="real",
              translation=[-0.120, 0.0015 + LIFT, -0.150], rotation=turn(18, 14),
              scale=[0.16, 0.13, 0.006])
    scene.add("virtual mirror", a_box, mirror_material(scene, "virtual mirror", 0.95),
              translation=[0.090, 0.0015 + LIFT, -0.150], rotation=turn(-24, 14),
              scale=[0.15, 0.12, 0.006])
    scene.add("marble cube", a_box, marble_material(scene),
              translation=[-0.018, LIFT, -0.066], rotation=turn(28), scale=[0.045] * 3)
    scene.add("mirror sphere", ball, mirror_material(scene, "chrome", 0.95),
              translation=[-0.098, 0.032 + LIFT, -0.078], scale=[0.032] * 3)
    scene.add("glass sphere", ball, glass_material(scene, 0.066),
              translation=[0.052, 0.033 + LIFT, -0.086], scale=[0.033] * 3)
    return scene


def diffuse_scene():
    scene = new_scene()
    scene.add("marble cube", box(), marble_material(scene),
              translation=[-0.075, LIFT, -0.06], rotation=turn(25), scale=[0.045] * 3)
    scene.add("red sphere", sphere(32, 32),
              scene.material("red", (0.70, 0.08, 0.06), roughness=0.3),
              translation=[0.0, 0.03 + LIFT, -0.10], scale=[0.03] * 3)
    scene.add("green torus", torus(0.028, 0.011, 32, 16),
              scene.material("green", (0.10, 0.45, 0.14), roughness=0.6),
              translation=[0.075, LIFT, -0.055])
    scene.add("blue cone", cone(0.025, 0.07, 32),
              scene.material("blue", (0.08, 0.16, 0.60), roughness=0.5),
              translation=[0.075, LIFT, -0.145])
    return scene


def mirror_scene():
    scene = new_scene()
    a_box = box()
    scene.add("virtual mirror", a_box, mirror_material(scene, "mirror", 0.95),
              translation=[0.095, LIFT, -0.185], rotation=turn(-22), scale=[0.15, 0.11, 0.006])
    scene.add("mirror sphere", sphere(32, 32), mirror_material(scene, "chrome", 0.95),
              translation=[-0.078, 0.032 + LIFT, -0.055], scale=[0.032] * 3)
    gold = scene.material("gold", (1.0, 0.77, 0.34), metallic=1.0, roughness=0.0)
    scene.add("gold cube", a_box, gold, translation=[0.0, LIFT, -0.09], rotation=turn(28),
              scale=[0.04] * 3)
    return scene


def markers_scene():
    """Each object stands on a marker of its own and goes where that goes."""
    scene = new_scene()
    scene.add("marble cube", box(), marble_material(scene),
              translation=[0.0, LIFT, 0.0], rotation=turn(20), scale=[0.045] * 3)
    scene.add("mirror sphere", sphere(32, 32), mirror_material(scene, "chrome", 0.95), marker=62,
              translation=[0.0, 0.03 + LIFT, 0.0], scale=[0.03] * 3)
    scene.add("blue cone", cone(0.025, 0.07, 32), marker=98,
              material=scene.material("blue", (0.08, 0.16, 0.60), roughness=0.5),
              translation=[0.0, LIFT, 0.0])
    return scene


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=Path(__file__).resolve().parent,
                        help="folder to write to (default: where this script is)")
    output = parser.parse_args().output
    output.mkdir(parents=True, exist_ok=True)
    for name, scene in (("complex", complex_scene()), ("diffuse", diffuse_scene()),
                        ("mirror", mirror_scene()), ("glassware", glassware_scene()),
                        ("markers", markers_scene())):
        scene.write(output / f"{name}.gltf")
    write_palette_png(output / MARBLE, *marble(128))
    write_rgb_png(output / HAMMERED, hammered(96))
    write_half_exr(output / "environment.exr", room(256, 128))
    write_stiff_scenes(output / "stiff")


if __name__ == "__main__":
    main()
