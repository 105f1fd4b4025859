"""What all scenes share: the marker they stand on, the real table, the materials."""

import math
from pathlib import Path

from .gltf_writer import GltfWriter
from .shapes import quad

# Metres above the table: of faces that lie in each other, none is well defined as the nearest.
LIFT = 0.0002


def new_scene(environment="environment.exr"):
    """A scene on marker 40 with the real table, whose top is y = 0."""
    scene = GltfWriter({"world_marker": 40, "dictionary": "DICT_6X6_250", "marker_length": 0.05,
                        "environment": environment})
    table = scene.material("table", (0.60, 0.59, 0.57), roughness=0.9)
    scene.add("table", quad(1.2, 0.9, center=(-0.05, -0.05)), table, role="real")
    return scene


def copy_environment(folder):
    """Copies our environment map beside a scene. Another one of that name is not replaced."""
    ours = (Path(__file__).resolve().parent.parent / "environment.exr").read_bytes()
    target = folder / "environment.exr"
    if target.exists() and target.read_bytes() != ours:
        raise ValueError(f"{target} is another environment map; choose an empty folder")
    target.write_bytes(ours)


def mirror_material(scene, name, reflectance):
    return scene.material(name, (reflectance,) * 3, metallic=1.0, roughness=0.0)


def glass_material(scene, thickness):
    return scene.material("glass", (1.0, 1.0, 1.0), roughness=0.0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1.0},
        "KHR_materials_ior": {"ior": 1.5},
        "KHR_materials_volume": {"thicknessFactor": thickness, "attenuationDistance": 0.1,
                                 "attenuationColor": [0.80, 0.94, 0.92]},
    })


def dielectric_material(scene, name, ior, color=None, distance=0.1, thickness=0.05):
    """Solid glass, a liquid or air. color: what is left of white light after this distance."""
    volume = {"thicknessFactor": thickness}
    if color is not None:
        volume.update(attenuationDistance=distance, attenuationColor=list(color))
    return scene.material(name, (1.0, 1.0, 1.0), roughness=0.0, extensions={
        "KHR_materials_transmission": {"transmissionFactor": 1.0},
        "KHR_materials_ior": {"ior": ior},
        "KHR_materials_volume": volume,
    })


def turn(degrees, lean=0.0):
    """Quaternion x y z w: turned about +Y, leaning back (its top away from its front, +Z)."""
    half_turn, half_lean = math.radians(degrees) / 2, -math.radians(lean) / 2
    return [math.cos(half_turn) * math.sin(half_lean), math.sin(half_turn) * math.cos(half_lean),
            -math.sin(half_turn) * math.sin(half_lean), math.cos(half_turn) * math.cos(half_lean)]