#!/usr/bin/env python3
"""Makes a scene of any glTF model: it stands on the table of marker 40.

    wrap_gltf.py MODEL --output SCENE.gltf [--height 0.14] [--upside-down]

The model is scaled to the height (metres) and stands on y = 0, behind the marker. Its buffers and
pictures and the environment map are copied beside the scene, which may refer to files in its own
folder only. The table is in the scene's own file.
"""

import argparse
import base64
import json
import math
import sys
from pathlib import Path
from urllib.parse import unquote

from generator.common import LIFT, copy_environment, new_scene
from generator.gltf_reader import read_model

PLACE = (0.0, -0.09)  # x and z of the model's middle, metres
COLLECTIONS = {"buffers": "buffer", "bufferViews": "bufferView", "accessors": "accessors",
               "materials": "material", "meshes": "mesh", "nodes": "nodes"}


def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def matrix_of(node):
    if "matrix" in node:
        return [[node["matrix"][4 * j + i] for j in range(4)] for i in range(4)]
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    s, t = node.get("scale", (1, 1, 1)), node.get("translation", (0, 0, 0))
    turned = ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
              (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
              (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))
    rows = [[turned[i][j] * s[j] for j in range(3)] + [t[i]] for i in range(3)]
    return rows + [[0, 0, 0, 1]]


def bounds(document, roots):
    """The corners of a box around all that is drawn, by what the accessors state."""
    identity = [[float(i == j) for j in range(4)] for i in range(4)]
    waiting, low, high = [(root, identity) for root in roots], [math.inf] * 3, [-math.inf] * 3
    seen = set()
    while waiting:
        index, parent = waiting.pop()
        if index in seen:
            raise ValueError(f"node {index} is its own ancestor or has two parents")
        seen.add(index)
        node = document["nodes"][index]
        here = multiply(parent, matrix_of(node))
        waiting += [(child, here) for child in node.get("children", ())]
        for primitive in document["meshes"][node["mesh"]]["primitives"] if "mesh" in node else ():
            if "POSITION" not in primitive["attributes"]:
                continue
            accessor = document["accessors"][primitive["attributes"]["POSITION"]]
            if "min" not in accessor or "max" not in accessor:
                raise ValueError("a mesh has no bounds (min and max of its positions)")
            for corner in range(8):
                p = [accessor["max" if corner >> i & 1 else "min"][i] for i in range(3)] + [1]
                for i in range(3):
                    value = sum(here[i][k] * p[k] for k in range(4))
                    low[i], high[i] = min(low[i], value), max(high[i], value)
    return low, high


def stand(document, roots, height, upside_down):
    """Adds a node that puts the model in its place; returns its index."""
    low, high = bounds(document, roots)
    if not high[1] > low[1]:
        raise ValueError("the model has no height")
    scale = height / (high[1] - low[1])
    x, z = (-(low[i] + high[i]) / 2 * scale for i in (0, 2))
    y = (high[1] if upside_down else -low[1]) * scale
    node = {"name": "placed", "children": list(roots), "scale": [scale] * 3,
            "translation": [PLACE[0] + x, y + LIFT, PLACE[1] + (-z if upside_down else z)]}
    if upside_down:
        node["rotation"] = [1.0, 0.0, 0.0, 0.0]
    document["nodes"].append(node)
    return len(document["nodes"]) - 1


def append(document, table):
    """Adds another document's contents; returns the indices of its nodes."""
    first = {name: len(document.get(name, ())) for name in COLLECTIONS}
    for view in table["bufferViews"]:
        view["buffer"] += first["buffers"]
    for accessor in table["accessors"]:
        accessor["bufferView"] += first["bufferViews"]
    for mesh in table["meshes"]:
        for primitive in mesh["primitives"]:
            primitive["indices"] += first["accessors"]
            primitive["material"] += first["materials"]
            for name in primitive["attributes"]:
                primitive["attributes"][name] += first["accessors"]
    for node in table["nodes"]:
        node["mesh"] += first["meshes"]
    for name in COLLECTIONS:
        document.setdefault(name, []).extend(table[name])
    return list(range(first["nodes"], len(document["nodes"])))


def inside(folder, name):
    """The path of a file in a folder; a model's files may lie nowhere else."""
    path = folder / name
    if not path.resolve().is_relative_to(folder.resolve()):
        raise ValueError(f"its file '{name}' lies outside its folder")
    return path


def table_scene():
    """The document of a scene with the real table alone, its bytes within."""
    scene = new_scene()
    data = base64.b64encode(scene.data).decode("ascii")
    return scene.document("table", f"data:application/octet-stream;base64,{data}")


def copy_files(document, source, target):
    """Gives the names of the files."""
    names = []
    for item in document.get("buffers", []) + document.get("images", []):
        uri = item.get("uri", "data:")
        if uri.startswith("data:"):
            continue
        name = unquote(uri)
        data = inside(source, name).read_bytes()
        destination = inside(target, name)
        destination.parent.mkdir(parents=True, exist_ok=True)
        destination.write_bytes(data)
        names.append(name)
    return names


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("input", type=Path, help="glTF file (.gltf or .glb)")
    parser.add_argument("--output", type=Path, required=True, help="glTF file to write")
    parser.add_argument("--height", type=float, default=0.14, help="metres (default 0.14)")
    parser.add_argument("--upside-down", action="store_true", help="turn the model over")
    arguments = parser.parse_args()

    folder = arguments.output.parent
    folder.mkdir(parents=True, exist_ok=True)
    try:
        document, binary = read_model(arguments.input)
        if not document.get("scenes"):
            raise ValueError("has no scene")
        scene = document["scenes"][document.get("scene", 0)]
        if not scene.get("nodes"):
            raise ValueError("its scene has no nodes")
        copy_environment(folder)
        placed = stand(document, scene["nodes"], arguments.height, arguments.upside_down)
        written = copy_files(document, arguments.input.parent, folder)
        if binary is not None:
            name = arguments.output.stem + ".bin"
            (folder / name).write_bytes(binary)
            document["buffers"][0]["uri"] = name
            written.append(name)
    except (OSError, ValueError) as error:
        sys.exit(f"{arguments.input}: {error}")
    except (LookupError, TypeError) as error:
        sys.exit(f"{arguments.input}: is damaged: there is no {error}")

    table = table_scene()
    scene["nodes"] = [placed, *append(document, table)]
    scene["extras"] = table["scenes"][0]["extras"]
    arguments.output.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    print(f"{arguments.output}: {len(document.get('meshes', ()))} meshes on marker 40; beside it "
          + ", ".join([*dict.fromkeys(written), "environment.exr"]))


if __name__ == "__main__":
    main()
