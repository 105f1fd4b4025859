#!/usr/bin/env python3
"""session_cost.py [SCENE...]: what a session costs, as rows of a Markdown table (deploy/SCALING.md has such a table).

For each scene of deploy/scenes a server and amalgam-load: 640 x 480, the marker moving, and as on a tripod. CPU time a
frame, because a busy machine distorts it less than the time that passes; memory between 0 and 8 sessions.
"""

import pathlib
import re
import subprocess
import sys
import time
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parent.parent
BIN = ROOT / "build/bin"
SESSIONS = 8
LOAD = 850.0  # milliseconds a second and core that --max-load gives away


class Server:
    def __init__(self, scene):
        self.process = subprocess.Popen(
            [BIN / "amalgam-server", "--scene", ROOT / f"deploy/scenes/{scene}.gltf", "--listen", "127.0.0.1:0",
             "--admin", "127.0.0.1:0", "--log-level", "error", "--max-load", "0"], stdout=subprocess.PIPE, text=True)
        said = self.process.stdout.readline().split()
        self.address, self.admin = said[2], said[4]

    def __enter__(self):
        return self

    def __exit__(self, *ignored):
        self.process.terminate()
        self.process.communicate(timeout=25)

    def metric(self, name):
        with urllib.request.urlopen(f"http://{self.admin}/metrics", timeout=30) as page:
            return sum(float(value) for value in re.findall(rf"(?m)^{name}(?:{{.*}})? (\S+)", page.read().decode()))

    def load(self, *options):
        subprocess.run([BIN / "amalgam-load", "--server", self.address, *options], check=True, capture_output=True)

    def cpu_ms(self, *options):
        """CPU milliseconds and frames that were rendered; those that newer ones replaced cost nothing."""
        cpu, frames = self.metric("process_cpu_seconds_total"), self.metric("amalgam_frames_sent_total")
        self.load(*options)
        frames = self.metric("amalgam_frames_sent_total") - frames
        return 1000.0 * (self.metric("process_cpu_seconds_total") - cpu), frames

    def mebibytes_a_session(self):
        """While eight are open that stand still, so that each keeps its last frame's paths."""
        before = most = self.metric("process_resident_memory_bytes")
        many = subprocess.Popen([BIN / "amalgam-load", "--server", self.address, "--clients", str(SESSIONS), "--rate",
                                 "1", "--duration", "8"], stdout=subprocess.DEVNULL)
        while many.poll() is None:
            most = max(most, self.metric("process_resident_memory_bytes"))
            time.sleep(0.2)
        return (most - before) / SESSIONS / 2**20


def row(scene):
    with Server(scene) as server:
        server.load("--frames", "3", "--rate", "2", "--moving")  # compiles shaders
        base = server.metric("process_resident_memory_bytes") / 2**20
        memory = server.mebibytes_a_session()
        total, frames = server.cpu_ms("--moving", "--rate", "10", "--duration", "6")
        moving = total / frames
        # The first two frames of a view that stands still cost as much as moving ones.
        total, frames = server.cpu_ms("--rate", "20", "--duration", "6")
        still = (total - 2.0 * moving) / (frames - 2.0)
        print(f"| {scene} | {moving:.0f} | {still:.0f} | {LOAD / moving:.1f} | {LOAD / still:.0f} | {base:.0f} | "
              f"{memory:.0f} |", flush=True)


if __name__ == "__main__":
    print("| scene | CPU ms a frame, moving | on a tripod | frames a second and core, moving | on a tripod | "
          "MiB of a server | MiB a session |\n|---|---|---|---|---|---|---|", flush=True)
    for name in sys.argv[1:] or ("diffuse", "complex", "mirror", "glassware"):
        row(name)
