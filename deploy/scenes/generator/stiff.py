"""Scenes on which a ray tracer's error falls slowly: mirrors that face each other, stacks of glass,
glass in glass, a lens. Each at 1 mm, 1 m and 1 km, with vertices of that size, because a number
that is fixed in metres shows as a difference between the three.

SIZE is the side of each scene's cube above the real ground; lengths below are shares of it.
"""

import math

from .common import dielectric_material
from .gltf_writer import GltfWriter
from .images import equirectangular, write_half_exr
from .shapes import Shape, box, quad, sphere

SIZES = (("1mm", 0.001), ("1m", 1.0), ("1km", 1000.0))
REFLECTANCES = ("0.5", "0.8", "0.9", "0.95", "0.99", "0.999")
SHEETS = (2, 4, 8, 16, 32, 64)
INDICES = ("1.0001", "2.42")

ENVIRONMENT = "soft.exr"
LIFT = 0.002  # above the ground: of faces that lie in each other, none is the nearest
GROUND = 3.0  # side of the real ground
GAP, MIRROR_DEPTH = 0.02, 0.005  # between the mirrors of a corridor; of a mirror
GLOW = (0.4, 0.5, 0.3)  # radiance that fills an endless corridor, whatever its reflectance
PITCH = 0.008  # from sheet to sheet of a stack; half of it is glass
RADIUS, HEIGHT = 0.3, 0.4  # of a ball, and of its middle above the ground


def soft_environment(width, height):
    """Rows of (r, g, b). Each channel changes from 0.2 to 2 across the sphere, along its own axis:
    a ray's light tells its direction, and a branch that is cut off errs by at most 1.8."""
    axes = [(0.8, 0.6, 0.0), (-0.48, 0.6, 0.64), (0.0, -0.28, -0.96)]
    return equirectangular(width, height, lambda d: tuple(
        1.1 + 0.9 * sum(a * b for a, b in zip(d, axis)) for axis in axes))


def _marker_length(size):
    """A twentieth of the scene, as far as markers of that size are allowed."""
    return min(max(0.05 * size, 1e-4), 2.0)


def _scene(size):
    scene = GltfWriter({"world_marker": 40, "dictionary": "DICT_6X6_250",
                        "marker_length": _marker_length(size), "environment": ENVIRONMENT})
    ground = scene.material("ground", (0.55, 0.5, 0.45), roughness=1.0)
    scene.add("ground", _without_uvs(quad(GROUND * size, GROUND * size)), ground, role="real")
    return scene


def _without_uvs(shape):
    shape.uvs = []  # no texture reads them
    return shape


def _boxes(size, boxes):
    """One shape of axis-aligned boxes, each (low, high)."""
    shape = Shape()
    for low, high in boxes:
        one, first = box(), len(shape.positions)
        shape.positions += [tuple(size * (low[k] + (p[k] + (0.0 if k == 1 else 0.5)) *
                                          (high[k] - low[k])) for k in range(3))
                            for p in one.positions]
        shape.normals += one.normals
        shape.indices += [first + i for i in one.indices]
    return shape


def _ball(size):
    shape = _without_uvs(sphere(32, 32))
    shape.positions = [tuple(RADIUS * size * c for c in p) for p in shape.positions]
    return shape


def corridor(size, reflectance):
    """Two square mirrors that face each other along z, fifty times as wide as their gap.

    What a mirror does not reflect it absorbs, and it shines as much as it absorbs (Kirchhoff): after
    n mirrors a ray has collected GLOW (1 - reflectance^n)."""
    scene = _scene(size)
    inner, outer = GAP / 2, GAP / 2 + MIRROR_DEPTH
    material = scene.material("mirror", (reflectance,) * 3, metallic=1.0, roughness=0.0,
                              emission=[c * (1.0 - reflectance) for c in GLOW])
    for name, low, high in (("front mirror", inner, outer), ("back mirror", -outer, -inner)):
        scene.add(name, _boxes(size, [((-0.5, LIFT, low), (0.5, 1.0 + LIFT, high))]), material)
    return scene


def stack(size, sheets):
    """Sheets of glass one behind the other along -z, from z = 0 on, with as much air between."""
    scene = _scene(size)
    places = [((-0.45, LIFT, -(i + 0.5) * PITCH), (0.45, 0.9 + LIFT, -i * PITCH))
              for i in range(sheets)]
    glass = dielectric_material(scene, "glass", 1.5, thickness=0.5 * PITCH * size)
    scene.add("sheets", _boxes(size, places), glass)
    return scene


def ball(size, index):
    scene = _scene(size)
    scene.add("ball", _ball(size), dielectric_material(scene, "glass", index, thickness=size),
              translation=[0.0, HEIGHT * size, 0.0])
    return scene


def nested(size):
    """Glass around a liquid around a bubble, each off the middle of the one around it."""
    scene, shape = _scene(size), _ball(size)
    for name, index, scale, middle in (("glass", 1.5, 1.0, (0.0, HEIGHT, 0.0)),
                                       ("liquid", 1.33, 0.72, (0.02, HEIGHT - 0.03, 0.01)),
                                       ("bubble", 1.0, 0.36, (-0.03, HEIGHT + 0.02, 0.03))):
        scene.add(name, shape, dielectric_material(scene, name, index, thickness=size),
                  translation=[c * size for c in middle], scale=[scale] * 3)
    return scene


def lens(size):
    """A flattened ball. Its curvature radius is RADIUS / 0.6, and its focal length about as long,
    so that it turns the picture of the ground behind it upside down."""
    scene = _scene(size)
    scene.add("lens", _ball(size), dielectric_material(scene, "glass", 1.5, thickness=size),
              translation=[0.0, HEIGHT * size, 0.0], scale=[1.0, 1.0, 0.6])
    return scene


def write_stiff_scenes(folder):
    """Scenes that differ in materials or transforms alone share one .bin file."""
    folder.mkdir(parents=True, exist_ok=True)
    write_half_exr(folder / ENVIRONMENT, soft_environment(64, 32))
    for name, size in SIZES:
        for text in REFLECTANCES:
            corridor(size, float(text)).write(folder / f"corridor-{text}-{name}.gltf",
                                              f"corridor-{name}")
        for sheets in SHEETS:
            stack(size, sheets).write(folder / f"stack-{sheets}-{name}.gltf")
        for text in INDICES:
            ball(size, float(text)).write(folder / f"ball-{text}-{name}.gltf", f"ball-{name}")
        nested(size).write(folder / f"nested-{name}.gltf", f"ball-{name}")
        lens(size).write(folder / f"lens-{name}.gltf", f"ball-{name}")
