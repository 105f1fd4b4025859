"""The examples, as a user runs them."""

import csv
import subprocess
import sys

import cv2
import numpy as np
import pytest

import amalgam
import support

EXAMPLES = support.SOURCE / "client/python/examples"
CAMERA = amalgam.Camera.from_fov(320, 240)


@pytest.fixture(scope="module")
def server():
    with support.serving() as running:
        yield running


def run(example, *options):
    return subprocess.run([sys.executable, EXAMPLES / example, *map(str, options)], capture_output=True, text=True,
                          timeout=60)


def write_pictures(folder):
    folder.mkdir()
    marker = cv2.cvtColor(support.marker_picture(support.tilted(35, distance=0.25), CAMERA), cv2.COLOR_GRAY2BGR)
    cv2.imwrite(str(folder / "a.jpg"), marker)
    cv2.imwrite(str(folder / "b.png"), cv2.resize(marker, (640, 480)))
    cv2.imwrite(str(folder / "c.jpg"), np.full((240, 320, 3), 90, np.uint8))
    return marker


def test_composite_folder(server, tmp_path):
    marker = write_pictures(tmp_path / "in")
    done = run("composite_folder.py", tmp_path / "in", tmp_path / "out", "--server", server.address)
    assert done.returncode == 0, done.stderr
    assert "3 of 3" in done.stdout and "c.jpg: no marker was found" in done.stderr
    for name in ("a.jpg", "b.jpg"):
        composite = cv2.imread(str(tmp_path / "out" / name))
        assert composite.shape == (240, 320, 3)
        assert np.abs(composite.astype(int) - marker).max() > 50
    assert (tmp_path / "out/c.jpg").read_bytes() == (tmp_path / "in/c.jpg").read_bytes()


def test_composite_folder_skips_what_it_cannot_read(server, tmp_path):
    write_pictures(tmp_path / "in")
    (tmp_path / "in/0.jpg").write_bytes(b"no picture")
    done = run("composite_folder.py", tmp_path / "in", tmp_path / "out", "--server", server.address)
    assert done.returncode == 1 and "3 of 4" in done.stdout and "0.jpg: skipped" in done.stderr
    assert not (tmp_path / "out/0.jpg").exists()


def test_composite_folder_loses_no_composite_to_another(server, tmp_path):
    marker = write_pictures(tmp_path / "in")
    cv2.imwrite(str(tmp_path / "in/a.png"), marker)
    done = run("composite_folder.py", tmp_path / "in", tmp_path / "out", "--server", server.address)
    assert done.returncode == 2 and "a.jpg and a.png would both become a.jpg" in done.stderr
    assert not (tmp_path / "out").exists()


def test_composite_folder_without_anything_to_do(server, tmp_path):
    (tmp_path / "in").mkdir()
    for address in (server.address, "127.0.0.1:1"):
        done = run("composite_folder.py", tmp_path / "in", tmp_path / "out", "--server", address)
        assert done.returncode == 2 and len(done.stderr.splitlines()) == 1
        (tmp_path / "in/a.png").write_bytes(bytes(cv2.imencode(".png", np.zeros((120, 160), np.uint8))[1]))


def test_latency_plot(server, tmp_path):
    write_pictures(tmp_path / "in")
    done = run("latency_plot.py", tmp_path / "in/a.jpg", "--server", server.address, "--frames", 3, "--output",
               tmp_path / "plot.png")
    assert done.returncode == 0, done.stderr
    with open(tmp_path / "plot.csv") as file:
        rows = list(csv.DictReader(file))
    assert [row["frame"] for row in rows] == ["0", "1", "2"]
    assert all(float(row["trace_ms"]) > 0 and float(row["latency_ms"]) >= float(row["server_ms"]) for row in rows)
    assert (tmp_path / "plot.png").exists() or "matplotlib is missing" in done.stderr
