#!/usr/bin/env python3
"""blender_scene_test.py INSPECT RENDER SOURCE: scenes made in Blender are what Amalgam takes them for.

Blender builds the complex scene's likeness with the add-on of deploy/blender, and with custom properties typed by hand,
and exports it; amalgam-inspect and amalgam-render judge the files. Ends with 77 (skipped) where there is no Blender.
"""

import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

INSPECT, RENDER, SOURCE = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
HERE = pathlib.Path(__file__).resolve().parent
# What decides on roles and materials; times and paths are not in it.
COMPARED = ("world", "nodes", "materials", "environment", "lights", "warnings", "notes", "left_out")

SKIPPED = 77


def skip(reason):
    print(f"Skipped\n{reason}", flush=True)
    sys.exit(SKIPPED)


def pack_addon(path):
    folder = SOURCE / "deploy/blender"
    with zipfile.ZipFile(path, "w") as packed:
        for file in sorted(folder.glob("amalgam_scene/*.py")):
            packed.write(file, file.relative_to(folder))


def export_all(out):
    addon = out / "amalgam_scene.zip"
    pack_addon(addon)
    # A user's own add-ons and settings are neither read nor changed.
    own = dict(os.environ, BLENDER_USER_CONFIG=str(out / "config"), BLENDER_USER_SCRIPTS=str(out / "scripts"))
    # Blender takes the modules of the first python3 on the path. Its own distribution's stands beside it.
    own["PATH"] = os.pathsep.join((os.path.dirname(shutil.which("blender")), own["PATH"]))
    for folder in ("config", "scripts", "exported"):
        (out / folder).mkdir()
    done = subprocess.run(
        ["blender", "-b", "--factory-startup", "--python-exit-code", "1", "-P", HERE / "export_scenes.py", "--", addon,
         out / "exported"], env=own, capture_output=True, text=True)
    if done.returncode == SKIPPED:
        skip("Blender's glTF exporter needs numpy (package python3-numpy)")
    if done.returncode != 0:
        sys.exit(done.stdout[-4000:] + done.stderr[-4000:])
    return out / "exported"


def write_pose(path):
    """camera_from_marker as OpenCV has it, of a camera 0.25 m above the desk and 0.35 m before the marker."""
    down, before, above = math.radians(30), 0.35, 0.25
    s, c = math.sin(down), math.cos(down)
    # A turn about x alone: the camera's z, forward, is (0, c, -s) in the marker's frame.
    angle = math.pi / 2 + down
    rotation = [math.sin(angle / 2), 0, 0, math.cos(angle / 2)]
    translation = [0, c * above - s * before, c * before + s * above]
    path.write_text(json.dumps({"poses": [{"marker": 40, "rotation": rotation, "translation": translation}]}))


class BlenderScenes(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        out = pathlib.Path(cls.folder.name)
        cls.scenes = export_all(out)
        cls.facts = json.loads((cls.scenes / "facts.json").read_text())
        cls.pose = out / "pose.json"
        write_pose(cls.pose)

    def inspect(self, name):
        done = subprocess.run([INSPECT, "--json", self.scenes / name], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, f"{name}: {done.stderr}")
        return json.loads(done.stdout)

    def judged(self, name):
        report = self.inspect(name)
        return {key: report[key] for key in COMPARED}

    def roles(self, name):
        return {node["node"]: node["role"] for node in self.inspect(name)["nodes"]}

    def pixels(self, scene):
        done = subprocess.run(
            [RENDER, "--scene", scene, "--poses", self.pose, "--size", "320x240", "--renderer", "raytrace", "--json",
             "--output", self.scenes / "composite.png"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["pixels"]

    def test_the_panel_says_roles_markers_and_materials(self):
        report = self.inspect("panel/scene.gltf")
        self.assertEqual(report["warnings"] + report["notes"], [])
        self.assertEqual(report["world"], {"marker": 40, "dictionary": "DICT_6X6_250", "marker_length": 0.05})
        kinds = {node["node"]: (node["role"], report["materials"][node["material"]]["kind"])
                 for node in report["nodes"]}
        # Neither the guide, which shows where the marker lies, nor what is left out of renderings is among them.
        self.assertEqual(kinds, {
            "table": ("real", "diffuse"), "real mirror": ("real", "mirror"), "virtual mirror": ("virtual", "mirror"),
            "marble cube": ("virtual", "diffuse"), "mirror sphere": ("virtual", "mirror"),
            "glass sphere": ("virtual", "dielectric")})
        glass = next(m for m in report["materials"] if m["kind"] == "dielectric")
        self.assertEqual((glass["ior"], glass["thin"]), (1.5, False))
        self.assertEqual(report["environment"]["width"], 256)

    def test_binary_and_reopened_files_say_the_same(self):
        expected = self.judged("panel/scene.gltf")
        self.assertEqual(self.judged("panel/binary.glb"), expected)
        self.assertEqual(self.judged("panel/reopened.gltf"), expected)

    def test_typed_properties_say_the_same(self):
        self.assertEqual(self.judged("typed/scene.gltf"), self.judged("panel/scene.gltf"))

    def test_the_panel_shows_what_was_typed(self):
        self.assertEqual(self.facts["panel_shows_typed"]["real mirror"], "real")
        self.assertEqual(self.facts["panel_shows_typed"]["virtual mirror"], "virtual")
        self.assertEqual(self.facts["panel_shows_typed_marker"], 40)
        self.assertEqual(self.facts["typed_and_changed"], {"role": "real", "marker": 7})

    def test_misspelt_properties_are_named(self):
        warnings = self.inspect("misspelt.gltf")["warnings"]
        for name in ("rolle", "amalgam_role", "Marker"):
            self.assertTrue(any(f".extras.{name}: is not read" in line for line in warnings), f"{name}: {warnings}")
        self.assertTrue(any("meshes[" in line and "only at nodes" in line for line in warnings), warnings)

    def test_cycles_flag_is_exported_by_the_addon_only(self):
        self.assertEqual(self.roles("flag.gltf")["table"], "real")
        self.assertEqual(self.roles("flag-by-hand.gltf")["table"], "virtual")
        self.assertEqual(self.facts["role_after_export"], "INHERITED")

    def test_markers_and_inherited_roles(self):
        nodes = {node["node"]: (node["role"], node["marker"]) for node in self.inspect("panel/markers.gltf")["nodes"]}
        self.assertEqual(nodes, {
            "table": ("real", 40), "real mirror": ("real", 40), "virtual mirror": ("virtual", 40),
            "marble cube": ("virtual", 23), "mirror sphere": ("real", 40), "glass sphere": ("real", 40)})
        self.assertEqual(self.facts["problems"]["markers"], [])

    def test_a_field_set_to_minus_one_says_nothing(self):
        report = self.inspect("cleared.gltf")
        self.assertEqual(report["world"]["marker"], 0)
        self.assertEqual({node["marker"] for node in report["nodes"]}, {0})

    def test_the_file_keeps_its_roles_without_the_addon(self):
        self.assertEqual(self.facts["without_addon"], {"role": "real"})

    def test_lamps_have_radiometric_units(self):
        lights = {light["source"]: light["intensity"] for light in self.inspect("lamps.gltf")["lights"]}
        for name, expected in (("sun", 3.0), ("point", 100 / (4 * math.pi))):
            for channel in lights[name]:
                self.assertAlmostEqual(channel, expected, places=4)

    def test_the_likeness_covers_the_pixels_of_the_original(self):
        original = self.pixels(SOURCE / "deploy/scenes/complex.gltf")
        likeness = self.pixels(self.scenes / "panel/scene.gltf")
        self.assertGreater(original["specular"], 1000)
        for kind in ("virtual", "specular"):
            # The spheres have other facets: less than a hundredth of their pixels are at the rim.
            self.assertLess(abs(likeness[kind] - original[kind]), 0.01 * original[kind], f"{kind}: {likeness}")
        real_cube = self.pixels(self.scenes / "panel/cube-real.gltf")
        self.assertLess(real_cube["virtual"], 0.97 * likeness["virtual"])

    def test_problems_are_said_in_words(self):
        said = self.facts["problems"]
        self.assertEqual(said["likeness"], [])
        self.assertEqual(said["split, but closed"], [])
        expected = {
            "no world marker": "No world marker", "no light": "No light", "no file": "nowhere.exr is not there",
            "open glass": "glass sphere: solid glass must be closed", "thin glass": "glass sphere: thin glass",
            "far": "marble cube: 12 m from its marker", "centimetres": "marble cube: ",
            "units": "The unit scale is 0.01", "text": "table: its custom property 'amalgam' is no JSON",
        }
        for case, words in expected.items():
            self.assertTrue(any(words in line for line in said[case]), f"{case}: {said[case]}")
            # One mistake is not told as many.
            self.assertEqual(len(said[case]), 1, f"{case}: {said[case]}")
        self.assertTrue(any("table: a shadow catcher" in line for line in said["flag"]), said["flag"])

    def test_strict_export_writes_nothing_if_something_is_wrong(self):
        self.assertEqual((self.facts["strict"], self.facts["strict_wrote"]), (["CANCELLED"], []))

    def test_exporting_changes_nothing(self):
        self.assertTrue(self.facts["environment_after_export"].endswith("deploy/scenes/environment.exr"))


if __name__ == "__main__":
    if shutil.which("blender") is None:
        skip("Blender is not installed")
    unittest.main(argv=sys.argv[:1], verbosity=2)
