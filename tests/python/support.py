"""What several tests use: a server, hand-made messages, and pictures."""

import contextlib
import os
import pathlib
import signal
import subprocess

import cv2
import numpy as np

import amalgam
from amalgam.amalgam_pb2 import Envelope, Error, Limits, Markers
from amalgam.framing import encode

SOURCE = pathlib.Path(os.environ["AMALGAM_SOURCE"])
BIN = pathlib.Path(os.environ["AMALGAM_BIN"])
WIDTH, HEIGHT = 160, 120
CAMERA = amalgam.Camera.from_fov(WIDTH, HEIGHT)
MARKERS = amalgam.Markers("DICT_6X6_250", 0.05, 40, (40, 23))


class Server:
    """amalgam-server on a free port. Everything is traced, so that no OpenGL is needed."""

    def __init__(self, *options):
        self.process = subprocess.Popen(
            [BIN / "amalgam-server", "--scene", SOURCE / "deploy/scenes/diffuse.gltf", "--renderer", "raytrace",
             "--listen", "127.0.0.1:0", "--admin", "127.0.0.1:0", "--log-level", "off", "--threads", "1", *options],
            stdout=subprocess.PIPE, text=True)
        said = self.process.stdout.readline().split()
        assert said[:2] == ["listening", "on"], said
        self.address = said[2]

    def drain(self):
        self.process.send_signal(signal.SIGTERM)

    def stop(self):
        self.process.kill()
        self.process.communicate(timeout=25)


@contextlib.contextmanager
def serving(*options):
    server = Server(*options)
    try:
        yield server
    finally:
        server.stop()


def plain_jpeg(width=WIDTH, height=HEIGHT, brightness=120):
    """A picture without any marker."""
    picture = np.full((height, width, 3), brightness, np.uint8)
    return bytes(cv2.imencode(".jpg", picture)[1])


def dictionary():
    """OpenCV's before 4.7 and since."""
    get = getattr(cv2.aruco, "Dictionary_get", None) or cv2.aruco.getPredefinedDictionary
    return get(cv2.aruco.DICT_6X6_250)


def marker_picture(pose, camera, marker=40, length=0.05, samples=8):
    """A printed marker as a camera without distortion sees it: the plane's picture, warped and averaged down."""
    side = 400
    draw = getattr(cv2.aruco, "drawMarker", None) or cv2.aruco.generateImageMarker
    paper = np.full((2 * side, 2 * side), 230, np.uint8)
    paper[side // 2 : side // 2 + side, side // 2 : side // 2 + side] = np.maximum(
        draw(dictionary(), marker, side), 20)
    k = camera.matrix()
    scale = length / side  # paper's pixels to metres, y up; its pixel 0 is half a pixel inside
    to_plane = np.array([[scale, 0, (0.5 - side) * scale], [0, -scale, (side - 0.5) * scale], [0, 0, 1]])
    turn = rotation_matrix(pose)
    to_camera = np.column_stack([turn[:, 0], turn[:, 1], pose.translation])
    # Into an image that is larger on each axis, then averaged: a pixel's area, as a sensor has it.
    larger = np.array([[samples, 0, (samples - 1) / 2], [0, samples, (samples - 1) / 2], [0, 0, 1]])
    size = (camera.width * samples, camera.height * samples)
    big = cv2.warpPerspective(paper, larger @ k @ to_camera @ to_plane, size, flags=cv2.INTER_LINEAR,
                              borderValue=230)
    return cv2.resize(big, (camera.width, camera.height), interpolation=cv2.INTER_AREA)


def rotation_matrix(pose):
    x, y, z, w = pose.rotation
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def tilted(degrees, distance=0.4, turned=20.0, marker=40):
    """A pose whose marker faces the camera but for a tilt, turned about the line of sight."""
    facing = np.array([1.0, 0, 0, 0])  # half a turn about x: its z towards the camera
    tilt = np.array([np.sin(np.radians(degrees) / 2), 0, 0, np.cos(np.radians(degrees) / 2)])
    turn = np.array([0, 0, np.sin(np.radians(turned) / 2), np.cos(np.radians(turned) / 2)])
    rotation = _times(turn, _times(tilt, facing))
    return amalgam.Pose(marker, tuple(map(float, rotation)), (0.01, -0.005, distance))


def _times(a, b):
    (ax, ay, az, aw), (bx, by, bz, bw) = a, b
    return np.array([aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
                     aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz])


# --- messages of a server ---


def welcome():
    envelope = Envelope()
    envelope.welcome.session = 12
    envelope.welcome.limits.CopyFrom(Limits(max_message_bytes=4 << 20, max_poses=64, ping_interval_ms=1000,
                                            idle_timeout_ms=5000))
    envelope.welcome.markers.CopyFrom(Markers(dictionary="DICT_6X6_250", length=0.05, world_marker=40, ids=[40, 23]))
    return encode(envelope)


def composite(frame_id, capture_time_us=0, jpeg=b"\xff\xd8\xff\xd9"):
    envelope = Envelope()
    envelope.composite.frame_id = frame_id
    envelope.composite.capture_time_us = capture_time_us
    envelope.composite.jpeg = jpeg
    envelope.composite.stages.add(name="trace", milliseconds=12.5)
    return encode(envelope)


def error(code, frame_id=0, closes=False):
    return encode(Envelope(error=Error(code=Error.Code.Value(code), text="why", frame_id=frame_id, closes=closes)))
