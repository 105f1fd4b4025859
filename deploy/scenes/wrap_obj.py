#!/usr/bin/env python3
"""Makes a scene of any Wavefront OBJ: the model in glass or as a mirror on the table of marker 40.

    wrap_obj.py MODEL.obj --material glass|mirror --output SCENE.gltf [--height 0.09]

The model is scaled to the height (metres) and stands on y = 0. The environment map is copied beside
the scene, which may refer to files in its own folder only.
"""

import argparse
import sys
from pathlib import Path

from generator.common import LIFT, copy_environment, glass_material, mirror_material, new_scene
from generator.obj import read_obj


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("input", type=Path, help="Wavefront OBJ file")
    parser.add_argument("--material", choices=("glass", "mirror"), default="glass")
    parser.add_argument("--output", type=Path, required=True, help="glTF file to write")
    parser.add_argument("--height", type=float, default=0.09, help="metres (default 0.09)")
    arguments = parser.parse_args()

    try:
        shape = read_obj(arguments.input, arguments.height)
        arguments.output.parent.mkdir(parents=True, exist_ok=True)
        copy_environment(arguments.output.parent)
    except (OSError, ValueError) as error:
        sys.exit(f"{arguments.input}: {error}")
    scene = new_scene()
    material = (glass_material(scene, arguments.height / 2) if arguments.material == "glass"
                else mirror_material(scene, "mirror", 0.95))
    scene.add(arguments.input.stem, shape, material, translation=[0.0, LIFT, -0.09])
    scene.write(arguments.output)
    print(f"{arguments.output}: {shape.triangles} triangles of {arguments.material}")


if __name__ == "__main__":
    main()
