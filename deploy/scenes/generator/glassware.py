"""Glass in glass: a tumbler of tea with a straw, a ball with a bubble; hammered copper; a lamp."""

import math

from .common import LIFT, dielectric_material, new_scene, turn
from .shapes import cone, lathe, plate, sphere

HAMMERED = "hammered.png"

HEIGHT, BOTTOM_RADIUS, TOP_RADIUS = 0.088, 0.026, 0.033  # of the tumbler, metres
WALL, BASE, LEVEL = 0.0024, 0.009, 0.056  # of its side, its bottom; where the tea ends


def _outer_radius(y):
    return BOTTOM_RADIUS + (TOP_RADIUS - BOTTOM_RADIUS) * y / HEIGHT


def tumbler():
    """Closed: up its outside, over a round rim, down its inside."""
    rim = WALL / 2
    top = HEIGHT - rim
    middle = _outer_radius(top) - rim
    arc = [(middle + rim * math.cos(math.pi * k / 8), top + rim * math.sin(math.pi * k / 8))
           for k in range(9)]
    inside = _outer_radius(BASE) - WALL
    return lathe([(0.0, 0.0), (BOTTOM_RADIUS - 0.001, 0.0), None,
                  (BOTTOM_RADIUS, 0.001), (_outer_radius(HEIGHT / 2), HEIGHT / 2), *arc,
                  (_outer_radius(HEIGHT / 2) - WALL, HEIGHT / 2), (inside, BASE + 0.002), None,
                  (inside - 0.002, BASE), (0.0, BASE)], 48)


def tea():
    """Reaches half way into the glass around it: surfaces that touch have no order."""
    half = WALL / 2
    return lathe([(0.0, BASE - 0.002), (_outer_radius(BASE) - half, BASE - 0.002), None,
                  (_outer_radius(LEVEL) - half, LEVEL), None, (0.0, LEVEL)], 48)


def straw():
    """Stands on y = 0 along +Y; as thick as it is, it needs no hole."""
    return lathe([(0.0, 0.0), (0.0028, 0.0), None, (0.0028, 0.118), None, (0.0, 0.118)], 16)


def glassware_scene():
    scene = new_scene()
    place = [0.058, LIFT, -0.085]
    scene.add("tumbler", tumbler(), dielectric_material(scene, "glass", 1.5), translation=place)
    scene.add("tea", tea(), dielectric_material(scene, "tea", 1.33, (0.85, 0.40, 0.10), 0.03),
              translation=place)
    scene.add("straw", straw(), scene.material("straw", (0.72, 0.07, 0.10), roughness=0.4),
              translation=[place[0] - 0.015, LIFT + BASE + 0.002, place[2] + 0.004],
              rotation=[0.0, 0.0, math.sin(-0.14), math.cos(-0.14)])

    ball, middle = sphere(48, 32), [-0.028, 0.028 + LIFT, -0.050]
    scene.add("glass ball", ball, dielectric_material(scene, "green glass", 1.5, (0.75, 0.95, 0.85)),
              translation=middle, scale=[0.028] * 3)
    # An air bubble is a dielectric of index 1.
    scene.add("bubble", ball, dielectric_material(scene, "air", 1.0),
              translation=[middle[0] + 0.004, middle[1] + 0.005, middle[2]], scale=[0.012] * 3)

    copper = scene.material("copper", (0.95, 0.64, 0.54), metallic=1.0, roughness=0.0,
                            normal_texture=scene.texture(HAMMERED))
    scene.add("copper plate", plate(0.11, 0.085, 0.004, 2), copper,
              translation=[-0.078, 0.001 + LIFT, -0.150], rotation=turn(14, 12))

    foot = scene.material("foot", (0.15, 0.15, 0.16), roughness=0.4)
    scene.add("foot", cone(0.018, 0.03, 32), foot, translation=[0.0, LIFT, -0.125])
    glow = scene.material("lamp", (0.2, 0.2, 0.2), emission=(1.0, 0.36, 0.06), extensions={
        "KHR_materials_emissive_strength": {"emissiveStrength": 5.0}})
    scene.add("lamp", ball, glow, translation=[0.0, 0.042 + LIFT, -0.125], scale=[0.016] * 3)
    return scene
