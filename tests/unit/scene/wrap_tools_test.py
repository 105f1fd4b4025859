#!/usr/bin/env python3
"""The scripts that make scenes of other people's models. Argument: the folder deploy/scenes."""

import base64
import json
import math
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCENES = Path(sys.argv.pop(1))
sys.path.insert(0, str(SCENES))

from generator.obj import _triangles, read_obj  # noqa: E402

POSITIONS = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 2, 0)
MODEL = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
         "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
         "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                        "min": [0, 0, 0], "max": [1, 2, 0]}],
         "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36}]}


def glb(document):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + 36)
            + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", 36, b"BIN\0")
            + POSITIONS)


def area(points, triangles):
    return sum(abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
               for a, b, c in ([points[i] for i in t] for t in triangles))


class Tools(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.addCleanup(self.holder.cleanup)
        self.folder = Path(self.holder.name)

    def run_tool(self, tool, model, *more):
        return subprocess.run([sys.executable, str(SCENES / tool), str(model), "--output",
                               str(self.folder / "out" / "scene.gltf"), *more],
                              capture_output=True, text=True, timeout=60)

    def obj(self, text):
        path = self.folder / "model.obj"
        path.write_text(text)
        return read_obj(path, 1.0)

    def test_glb_is_read(self):
        (self.folder / "model.glb").write_bytes(glb(MODEL))
        done = self.run_tool("wrap_gltf.py", self.folder / "model.glb")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("beside it scene.bin, environment.exr", done.stdout)
        scene = json.loads((self.folder / "out" / "scene.gltf").read_text())
        self.assertEqual(scene["buffers"][0]["uri"], "scene.bin")
        self.assertEqual((self.folder / "out" / "scene.bin").read_bytes(), POSITIONS)

    def test_names_of_our_own_stay_free(self):
        """The model, its buffer and the scene may be called as anything of ours."""
        source = {**MODEL, "buffers": [{"byteLength": 36, "uri": "table.bin"}]}
        (self.folder / "out").mkdir()
        model = self.folder / "out" / "table.gltf"
        model.write_text(json.dumps(source))
        (self.folder / "out" / "table.bin").write_bytes(POSITIONS)
        done = self.run_tool("wrap_gltf.py", model)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("beside it table.bin, environment.exr", done.stdout)
        self.assertEqual(json.loads(model.read_text()), source)
        self.assertEqual((self.folder / "out" / "table.bin").read_bytes(), POSITIONS)
        names = sorted(path.name for path in (self.folder / "out").iterdir())
        self.assertEqual(names, ["environment.exr", "scene.gltf", "table.bin", "table.gltf"])
        scene = json.loads((self.folder / "out" / "scene.gltf").read_text())
        table = scene["buffers"][1]["uri"].removeprefix("data:application/octet-stream;base64,")
        self.assertEqual(len(base64.b64decode(table)), scene["buffers"][1]["byteLength"])

    def test_files_outside_the_folders_are_neither_read_nor_written(self):
        (self.folder / "in").mkdir()
        (self.folder / "secret.bin").write_bytes(POSITIONS)
        (self.folder / "in" / "link").symlink_to(self.folder)
        outside = self.folder / "elsewhere.bin"
        model = self.folder / "in" / "model.gltf"
        for uri in ("../secret.bin", "%2E%2E/secret.bin", str(self.folder / "secret.bin"),
                    "link/secret.bin"):
            model.write_text(json.dumps({**MODEL, "buffers": [{"byteLength": 36, "uri": uri}]}))
            done = self.run_tool("wrap_gltf.py", model)
            self.assertEqual(done.returncode, 1, uri)
            self.assertIn("lies outside its folder", done.stderr)
        # Inside where it is read, outside where it would be written.
        (self.folder / "out" / "sub").symlink_to(self.folder)
        (self.folder / "in" / "sub").mkdir()
        (self.folder / "in" / "sub" / outside.name).write_bytes(POSITIONS)
        model.write_text(json.dumps({**MODEL, "buffers": [
            {"byteLength": 36, "uri": "sub/" + outside.name}]}))
        self.assertEqual(self.run_tool("wrap_gltf.py", model).returncode, 1)
        self.assertFalse(outside.exists())

    def test_loops_of_nodes_are_refused(self):
        for nodes in ([{"mesh": 0, "children": [0]}], [{"children": [1]}, {"children": [0]}]):
            (self.folder / "model.glb").write_bytes(glb({**MODEL, "nodes": nodes}))
            done = self.run_tool("wrap_gltf.py", self.folder / "model.glb")
            self.assertEqual(done.returncode, 1)
            self.assertIn("is its own ancestor", done.stderr)

    def test_errors_are_sentences(self):
        wrong = {**MODEL, "scenes": [{"name": "empty"}]}
        for content, says in ((b"\xff\xfe", "its text is not UTF-8"), (b"{", "no JSON at line 1"),
                              (b"{}", "it has no 'asset'"), (glb(MODEL)[:60], "ends inside a chunk"),
                              (json.dumps(wrong).encode(), "its scene has no nodes")):
            (self.folder / "model.gltf").write_bytes(content)
            done = self.run_tool("wrap_gltf.py", self.folder / "model.gltf")
            self.assertEqual(done.returncode, 1)
            self.assertIn(says, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)

    def test_numbers_that_are_not_finite_are_refused(self):
        for number in ("nan", "inf", "-inf", "1e999"):
            with self.assertRaisesRegex(ValueError, "line 2 .*not finite"):
                self.obj(f"v 0 0 0\nv {number} 1 0\nv 0 1 0\nf 1 2 3\n")

    def test_continued_lines_are_one(self):
        shape = self.obj("v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\nf 1 2 \\\n 3\n")
        self.assertEqual(len(shape.indices), 3)
        with self.assertRaisesRegex(ValueError, "line 2 "):
            self.obj("v 0 0 0\nv 1 \\\nx 0\n")

    def test_concave_polygons_keep_their_area(self):
        arrow = [(0, 0, 0), (2, 1, 0), (0, 2, 0), (1, 1, 0)]
        star = [((1 if i % 2 else 3) * math.cos(i * math.pi / 5),
                 (1 if i % 2 else 3) * math.sin(i * math.pi / 5), 0) for i in range(10)]
        for polygon, expected in ((arrow, 1.0), (star, 5 * 3 * math.sin(math.pi / 5))):
            for turned in range(len(polygon)):
                points = polygon[turned:] + polygon[:turned]
                for way in (points, points[::-1]):
                    triangles = _triangles(way)
                    self.assertEqual(len(triangles), len(polygon) - 2)
                    self.assertAlmostEqual(area(way, triangles), expected)

    def test_all_triangles_face_as_their_polygon(self):
        shape = self.obj("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 4 1 2 3\n")
        for i in range(0, len(shape.indices), 3):
            a, b, c = (shape.positions[k] for k in shape.indices[i:i + 3])
            self.assertGreater((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0)


if __name__ == "__main__":
    unittest.main()
