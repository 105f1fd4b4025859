"""Sessions with a real server."""

import dataclasses
import os
import socket
import subprocess
import threading
import time

import cv2
import numpy as np
import pytest

import amalgam
import support
from amalgam.amalgam_pb2 import Envelope
from amalgam.framing import encode
from amalgam.square_pose import angle_between

MARKER_CAMERA = amalgam.Camera.from_fov(320, 240)
POSE = support.tilted(35, distance=0.25)


@pytest.fixture(scope="module")
def server():
    with support.serving() as running:
        yield running


@pytest.fixture(scope="module")
def marker_jpeg():
    picture = cv2.cvtColor(support.marker_picture(POSE, MARKER_CAMERA), cv2.COLOR_GRAY2BGR)
    return bytes(cv2.imencode(".jpg", picture)[1])


def connect(server, camera=support.CAMERA, **options):
    return amalgam.connect(server.address, camera=camera, **options)


def test_composites_are_the_native_clients(server, marker_jpeg, tmp_path):
    (tmp_path / "frame.jpg").write_bytes(marker_jpeg)
    subprocess.run([support.BIN / "amalgam-client", "--server", server.address, "--images", tmp_path / "frame.jpg",
                    "--output", tmp_path / "out"], check=True, capture_output=True)
    native = (tmp_path / "out/frame-000001.jpg").read_bytes()
    with connect(server, MARKER_CAMERA) as session:
        for frame in (marker_jpeg, tmp_path / "frame.jpg"):
            composite = session.send(frame)
            assert composite.jpeg == native and native != marker_jpeg
        again = session.send(marker_jpeg, composite.poses)
    assert again.jpeg == native
    assert [p.marker for p in composite.poses] == [40] and not composite.unchanged
    assert composite.image.shape == (240, 320, 3) and composite.image is composite.image
    assert np.abs(composite.image.astype(int) - cv2.imdecode(np.frombuffer(marker_jpeg, np.uint8), 1)).max() > 50
    assert "trace" in composite.stages and any(p.ran for p in composite.passes) and composite.rays["primary"] > 0
    assert 0 < composite.server_ms <= composite.latency_ms


def test_the_server_solves_corners(server, marker_jpeg):
    with connect(server, MARKER_CAMERA, find="corners") as session:
        composite = session.send(marker_jpeg)
        (pose,) = composite.poses
        assert pose.marker == 40 and angle_between(pose, POSE) < np.radians(1)
        assert np.allclose(pose.translation, POSE.translation, atol=1e-3)
    with connect(server, MARKER_CAMERA) as session:
        own = session.send(marker_jpeg)
        assert angle_between(pose, own.poses[0]) < 1e-4  # corners travel as single-precision numbers
        assert np.allclose(pose.translation, own.poses[0].translation, atol=1e-6)


def test_the_server_smooths_the_poses_that_it_solves(server, marker_jpeg):
    moved = support.tilted(35, distance=0.3)
    picture = support.marker_picture(moved, MARKER_CAMERA)
    with connect(server, MARKER_CAMERA, find="corners", smoothing=amalgam.OneEuro(0.5)) as session:
        session.send(marker_jpeg, capture_time=1.0)
        (pose,) = session.send(picture, capture_time=1.05).poses
    assert 0.25 < pose.translation[2] < 0.28  # a first step of the low-pass goes a small part of the way


def test_a_frame_without_markers_comes_back_as_it_was(server):
    with connect(server) as session:
        composite = session.send(support.plain_jpeg())
        assert composite.unchanged and composite.jpeg == support.plain_jpeg()
        array = session.send(np.full((support.HEIGHT, support.WIDTH, 3), 90, np.uint8), [])
        assert abs(int(array.image.mean()) - 90) <= 1
        assert session.counts.sent == session.counts.composited == session.counts.unchanged == 2
        assert session.welcome.markers.ids[0] == session.welcome.markers.world_marker == 40


def test_capture_times_come_back(server):
    with connect(server) as session:
        at = time.monotonic() - 0.5
        composite = session.send(support.plain_jpeg(), [], capture_time=at)
        assert composite.capture_time == pytest.approx(at, abs=1e-6)
        assert 500 <= composite.latency_ms < 5000


def test_rejected_frames_leave_the_session_open(server):
    plain = support.plain_jpeg()
    tables = plain.index(b"\xff\xdb")
    broken = plain[:tables] + plain[plain.index(b"\xff\xc0") :]  # its quantisation tables are missing
    good = amalgam.Pose(40, (0, 0, 0, 1), (0, 0, 1))
    with connect(server) as session:
        with pytest.raises(amalgam.BadImage, match="BAD_IMAGE") as caught:
            session.send(broken, [POSE])
        assert caught.value.frame_id == 1
        assert not session.send(plain, [POSE]).unchanged
        # Our own check would keep these back.
        core = session._session._core
        core.welcome = dataclasses.replace(core.welcome, max_poses=100)
        with pytest.raises(amalgam.TooManyPoses, match="TOO_MANY_POSES"):
            session.send(plain, [good] * 65)
        assert session.send(plain, []).skipped_total == session.counts.rejected == 2


def test_tokens(tmp_path):
    (tmp_path / "tokens").write_text("opensesame\n")
    os.chmod(tmp_path / "tokens", 0o600)
    with support.serving("--token-file", tmp_path / "tokens") as server:
        for token in ("", "wrong"):
            with pytest.raises(amalgam.AuthFailed):
                connect(server, token=token)
        with connect(server, token="opensesame") as session:
            assert session.send(support.plain_jpeg(), []).unchanged


def test_a_full_server_is_busy(tmp_path):
    with support.serving("--max-connections", "1") as server:
        with connect(server):
            with pytest.raises(amalgam.Busy) as caught:
                connect(server)
        assert 0 < caught.value.retry_after <= 60 and "connections" in caught.value.reason
        deadline = time.monotonic() + 10  # the server notices the goodbye in its own time
        while True:
            try:
                with connect(server) as session:
                    assert session.send(support.plain_jpeg(), []).unchanged
                return
            except amalgam.Busy:
                assert time.monotonic() < deadline


def test_a_draining_server_says_so():
    with support.serving() as server, connect(server) as session:
        assert session.send(support.plain_jpeg(), []).unchanged
        server.drain()
        deadline = time.monotonic() + 10
        with pytest.raises(amalgam.Draining) as caught:
            while time.monotonic() < deadline:
                session.send(support.plain_jpeg(), [])
        assert caught.value.deadline == 20
        assert server.process.wait(25) == 0


def test_a_dead_server_ends_the_session():
    with support.serving() as server, connect(server) as session:
        server.process.kill()
        with pytest.raises(amalgam.SessionClosed) as caught:
            while True:
                session.send(support.plain_jpeg(), [])
        assert not isinstance(caught.value, (amalgam.Draining, amalgam.FrameTimeout))
        with pytest.raises(amalgam.SessionClosed):
            session.send(support.plain_jpeg(), [])
    with pytest.raises(amalgam.ConnectFailed):
        connect(server)


def test_encryption(tmp_path):
    subprocess.run(["sh", support.SOURCE / "deploy/make_test_certificate.sh", tmp_path], check=True)
    certificate = tmp_path / "server.crt"
    with support.serving("--tls-certificate", certificate, "--tls-key", tmp_path / "server.key") as server:
        with connect(server, tls=True, ca=certificate) as session:
            assert session.send(support.plain_jpeg(), []).unchanged
        with pytest.raises(amalgam.ConnectFailed, match="certificate"):
            connect(server, tls=True)
        with pytest.raises(amalgam.ConnectFailed, match="127.0.0.2"):  # the certificate is for 127.0.0.1
            amalgam.connect(server.address.replace("127.0.0.1", "127.0.0.2"), camera=support.CAMERA, tls=True,
                            ca=certificate)
        with pytest.raises(amalgam.ConnectFailed):
            connect(server, connect_timeout=2)


def test_environments(server, marker_jpeg):
    dark, bright = (support.plain_jpeg(64, 32, brightness) for brightness in (5, 250))
    with connect(server, MARKER_CAMERA) as session:
        pictures = []
        for light in (dark, bright):
            session.set_environment(light)
            pictures.append(session.send(marker_jpeg, [POSE]).image.astype(int))
        assert np.abs(pictures[0] - pictures[1]).max() > 5
        with pytest.raises(amalgam.LimitError, match="65x32"):
            session.set_environment(dark, fisheye=amalgam.Fisheye(65, 32, 20, 20, 32, 16, 1.5))
        with pytest.raises(amalgam.EnvironmentRejected):  # one a second in the long run
            for _ in range(4):
                session.set_environment(dark, wait=0.05)
        assert session.send(marker_jpeg, [POSE]).frame_id == 3


# --- servers that are not ours ---


class Peer(threading.Thread):
    """Accepts one connection, says some bytes, and keeps silent until it is closed."""

    def __init__(self, said, close=False):
        super().__init__(daemon=True)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.address = "127.0.0.1:%d" % self._listener.getsockname()[1]
        self._said, self._close = said, close
        self.heard = b""
        self.start()

    def run(self):
        connection, _ = self._listener.accept()
        connection.sendall(self._said)
        while not self._close and (data := connection.recv(65536)):
            self.heard += data
        connection.close()


@pytest.mark.parametrize("said, close, error", [
    (b"", True, amalgam.ConnectFailed), (b"", False, amalgam.ConnectFailed),
    (b"HTTP/1.1 400 Bad Request\r\n", False, amalgam.ProtocolViolation)])
def test_what_is_no_server_of_ours(said, close, error):
    begin = time.monotonic()
    with pytest.raises(error):
        connect(Peer(said, close), connect_timeout=0.5)
    assert time.monotonic() - begin < 3


def test_an_unanswered_frame_times_out_and_silence_ends_the_session():
    silent = Envelope.FromString(support.welcome()[4:])
    silent.welcome.limits.idle_timeout_ms = 700
    with connect(Peer(encode(silent))) as session:
        with pytest.raises(amalgam.FrameTimeout):
            session.send(support.plain_jpeg(), [], timeout=0.1)
        with pytest.raises(amalgam.IdleTimeout):
            session.send(support.plain_jpeg(), [])


def test_pings_are_answered_while_the_program_does_something_else():
    peer = Peer(support.welcome() + encode(Envelope(ping={"nonce": 9})))
    with connect(peer):
        deadline = time.monotonic() + 5
        while encode(Envelope(pong={"nonce": 9})) not in peer.heard:
            assert time.monotonic() < deadline
            time.sleep(0.01)


def test_after_close_there_is_no_session(server):
    session = connect(server)
    session.close()
    session.close()
    with pytest.raises(amalgam.SessionClosed):
        session.send(support.plain_jpeg(), [])
