"""Renders cases of cases.json and writes the pictures that the test compares.

    blender -b --factory-startup -P make_truth.py -- OUTPUT SAMPLES ENVIRONMENTS CASES

OUTPUT: a folder. ENVIRONMENTS, CASES: names with commas between them, or "all".
"""

import json
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import numpy  # noqa: E402

import response  # noqa: E402
import truth_scene  # noqa: E402
from mask import render_mask  # noqa: E402
from rendering import render, set_up  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[3]
TRANSPORTS = {"full": True, "direct": False}


def _two_seeds(samples, full_transport):
    """Two pictures of half the samples each: the mean is the picture, the difference its noise."""
    set_up(samples // 2, full_transport)
    return [render(seed) for seed in (1, 2)]


def _mean(pictures):
    return sum(pictures) / len(pictures)


def _noise(pictures, gain, curve):
    """How far the mean of two pictures may be from the endless one: |a - b| / 2, in 1/255."""
    a, b = (response.develop(p, gain, curve).astype(numpy.float32) for p in pictures)
    return numpy.abs(a - b) / 2


def _render_pair(samples, transport, folder, name, notes):
    # Caustics alone need all samples.
    full, few = TRANSPORTS[transport], samples // 4
    truth_scene.show_virtual(False)
    camera = _two_seeds(few, full)
    truth_scene.show_virtual(True)
    truth = _two_seeds(samples if full else few, full)
    for curve in response.RESPONSES:
        gain = response.exposure(_mean(camera), curve)
        before = response.develop(_mean(camera), gain, curve)
        after = response.develop(_mean(truth), gain, curve)
        changed = numpy.abs(before.astype(int) - after.astype(int)).max(axis=2) > 2
        noise = _noise(truth, gain, curve)[changed]
        key = f"{name}-{transport}-{curve}"
        response.write_png(folder / f"{key}-camera.png", before)
        response.write_png(folder / f"{key}-truth.png", after)
        notes[key] = {"mean": round(float(noise.mean()), 3),
                      "percentile_95": round(float(numpy.percentile(noise, 95)), 2)}


def _real_mirrors(gltf):
    specular = {i for i, m in enumerate(gltf["materials"])
                if m["pbrMetallicRoughness"].get("metallicFactor", 1) >= 0.5}
    return {node["name"] for node in gltf["nodes"] if "mesh" in node and any(
        p["material"] in specular for p in gltf["meshes"][node["mesh"]]["primitives"])}


def _render_case(case, settings, environment, samples, folder):
    path = ROOT / f"deploy/scenes/{case['scene']}.gltf"
    name = f"{case['name']}-{environment}"
    notes_path = folder / "noise.json"
    notes = json.loads(notes_path.read_text()) if notes_path.exists() else {}
    for transport, full in TRANSPORTS.items():
        start = time.monotonic()
        truth_scene.load(path, case["surface"], straight_shadows=not full)
        truth_scene.place_camera(settings["camera"])
        truth_scene.light_by(ROOT / settings["environments"][environment])
        if not full:
            truth_scene.hide_lamps()
        _render_pair(samples, transport, folder, name, notes)
        print(f"truth: {name} {transport} {time.monotonic() - start:.0f} s", flush=True)
    mask = render_mask(_real_mirrors(json.loads(path.read_text())))
    response.write_png(folder / f"{case['name']}-mask.png", mask)
    notes_path.write_text(json.dumps(notes, indent=1, sort_keys=True) + "\n")


def _chosen(names, argument):
    return [name for name in names if argument == "all" or name in argument.split(",")]


def main():
    output, samples, environments, cases = sys.argv[sys.argv.index("--") + 1:]
    folder = pathlib.Path(output)
    folder.mkdir(parents=True, exist_ok=True)
    settings = json.loads((ROOT / "tests/truth/cases.json").read_text())
    by_name = {case["name"]: case for case in settings["cases"]}
    for environment in _chosen(settings["environments"], environments):
        for name in _chosen(by_name, cases):
            _render_case(by_name[name], settings, environment, int(samples), folder)


main()
