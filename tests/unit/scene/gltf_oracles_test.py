#!/usr/bin/env python3
"""Our scenes, compressed by gltf-transform, are read as the same scenes; what Khronos's tool writes
is the oracle. Arguments: amalgam-inspect, the folder deploy/scenes. Ends with 77 (skipped) if there
is no gltf-transform (npm install @gltf-transform/cli) on the path or in AMALGAM_NODE_BIN."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

INSPECT, SCENES = sys.argv[1], Path(sys.argv[2])
TOOL = shutil.which("gltf-transform", path=os.environ.get("AMALGAM_NODE_BIN", "") + os.pathsep
                    + os.environ.get("PATH", ""))


def inspect(path):
    done = subprocess.run([INSPECT, "--json", str(path)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{path}: {done.stderr}")
    return json.loads(done.stdout)


def summary(report):
    """What compression must keep: names, roles and triangles of the nodes."""
    return sorted((node["node"], node["role"], node["triangles"]) for node in report["nodes"])


def main():
    if TOOL is None:
        print("no gltf-transform: skipped")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as holder:
        for name in ("glassware", "complex"):
            expected = summary(inspect(SCENES / f"{name}.gltf"))
            for command in ("copy", "quantize", "meshopt", "draco", "webp"):
                out = Path(holder) / f"{name}-{command}.glb"
                subprocess.run([TOOL, command, str(SCENES / f"{name}.gltf"), str(out)], check=True,
                               capture_output=True)
                shutil.copy(SCENES / "environment.exr", holder)
                found = summary(inspect(out))
                if found != expected:
                    sys.exit(f"{out.name}: {found}\nnot {expected}")
                print(f"{out.name}: as it was")


if __name__ == "__main__":
    main()
