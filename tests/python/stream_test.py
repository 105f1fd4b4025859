"""Several frames at once, and the session for asyncio."""

import asyncio
import threading
import time

import pytest

import amalgam
import support

FRAMES = [support.plain_jpeg(brightness=10 * i) for i in range(20)]


@pytest.fixture(scope="module")
def server():
    with support.serving() as running:
        yield running


def connect(server, **options):
    return amalgam.connect(server.address, camera=support.CAMERA, **options)


def connect_async(server, **options):
    return amalgam.connect_async(server.address, camera=support.CAMERA, **options)


class Held(threading.Thread):
    """A server that answers each frame only when it is told to, with the frame's own picture."""

    def __init__(self):
        import socket
        super().__init__(daemon=True)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.address = "127.0.0.1:%d" % self._listener.getsockname()[1]
        self.arrived = []
        self._changed = threading.Condition()
        self.start()

    def run(self):
        self._connection, _ = self._listener.accept()
        self._connection.sendall(support.welcome())
        data = b""
        while more := self._connection.recv(65536):
            data += more
            while len(data) >= 4 and len(data) >= 4 + int.from_bytes(data[:4], "little"):
                size = int.from_bytes(data[:4], "little")
                envelope = support.Envelope.FromString(data[4 : 4 + size])
                data = data[4 + size :]
                if envelope.HasField("camera_frame"):
                    with self._changed:
                        self.arrived.append(envelope.camera_frame)
                        self._changed.notify_all()
                if envelope.HasField("goodbye"):
                    self._connection.close()
                    return

    def wait_for(self, count):
        with self._changed:
            assert self._changed.wait_for(lambda: len(self.arrived) >= count, 5)

    def answer(self, index):
        frame = self.arrived[index]
        self._connection.sendall(support.composite(frame.frame_id, frame.capture_time_us, frame.jpeg))


def test_all_frames_in_order_when_none_may_be_left_out(server):
    with connect(server) as session:
        composites = list(session.stream(((f, []) for f in FRAMES), newest_wins=False))
        assert [c.index for c in composites] == list(range(20))
        assert [c.jpeg for c in composites] == FRAMES
        assert all(c.skipped == () for c in composites)
        assert session.counts.composited == 20 and session.counts.skipped_by_client == 0


def test_the_newest_frame_replaces_the_one_that_waits():
    held = Held()
    with connect(held) as session:

        def camera():
            yield FRAMES[0], []
            yield FRAMES[1], []
            held.wait_for(2)  # both in flight
            for frame in FRAMES[2:]:
                yield frame, []
            held.answer(0)
            held.wait_for(3)
            held.answer(1)
            held.answer(2)

        composites = list(session.stream(camera()))
        assert [(c.index, c.skipped) for c in composites] == [(0, ()), (1, ()), (19, tuple(range(2, 19)))]
        assert composites[-1].jpeg == FRAMES[19]
        assert session.counts.skipped_by_client == 17 and session.counts.sent == 3


def test_what_the_server_skips_is_reported():
    held = Held()
    with connect(held) as session:

        def camera():
            yield FRAMES[0], []
            yield FRAMES[1], []
            held.wait_for(2)
            held.answer(1)

        (composite,) = session.stream(camera())
        assert (composite.index, composite.skipped) == (1, (0,))
        assert session.counts.skipped_by_server == 1


def test_rejected_frames_of_a_stream(server):
    frames = [(FRAMES[0], []), (b"no picture", []), (support.plain_jpeg(64, 64), []), (FRAMES[1], [])]
    with connect(server) as session:
        rejected = []
        composites = list(session.stream(frames, newest_wins=False, on_rejected=lambda i, e: rejected.append((i, e))))
        assert [c.index for c in composites] == [0, 3]
        assert [(i, type(e)) for i, e in rejected] == [(1, amalgam.BadImage), (2, amalgam.BadImage)]
        with pytest.raises(amalgam.BadImage):
            list(session.stream(frames, newest_wins=False))
        assert session.send(FRAMES[0], []).unchanged


def test_a_source_that_fails_and_a_reader_that_stops(server):
    def camera():
        yield FRAMES[0], []
        raise KeyError("unplugged")

    with connect(server) as session:
        with pytest.raises(KeyError, match="unplugged"):
            list(session.stream(camera(), newest_wins=False))
        for composite in session.stream(((f, []) for f in FRAMES), newest_wins=False):
            break
        assert composite.index == 0
        assert session.send(FRAMES[2], []).jpeg == FRAMES[2]


def test_a_stream_ends_with_its_session():
    with support.serving() as server, connect(server) as session:
        def camera():
            yield FRAMES[0], []
            server.process.kill()
            while True:
                time.sleep(0.01)
                yield FRAMES[1], []

        with pytest.raises(amalgam.SessionClosed):
            list(session.stream(camera()))


def wait_in_a_thread(work):
    """Starts it; the list gets what it raises or returns."""
    outcome = []

    def run():
        try:
            outcome.append(work())
        except BaseException as error:
            outcome.append(error)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    return thread, outcome


def test_close_wakes_whoever_waits_in_another_thread():
    """For an answer, for a frame of the source, and for a frame to be made ready."""
    entered, leave = threading.Semaphore(0), threading.Event()

    def camera():
        entered.release()
        leave.wait(20)
        yield FRAMES[0], []

    held = Held()
    session = connect(held)
    prepare = session._session._prepare

    def slowly(frame, poses, corners):
        if frame is FRAMES[2]:
            entered.release()
            leave.wait(20)
        return prepare(frame, poses, corners)

    session._session._prepare = slowly
    waiting = [wait_in_a_thread(lambda: session.send(FRAMES[1], []))]
    held.wait_for(1)
    waiting += [wait_in_a_thread(lambda: list(session.stream(camera()))),
                wait_in_a_thread(lambda: session.send(FRAMES[2], []))]
    assert entered.acquire(timeout=5) and entered.acquire(timeout=5)
    session.close()
    try:
        for thread, outcome in waiting:
            thread.join(5)
            assert [type(o) for o in outcome] == [amalgam.SessionClosed]
    finally:
        leave.set()
    session.close()


def test_a_frame_of_a_stream_times_out_after_its_time():
    held = Held()
    with connect(held, frame_timeout=1.0) as session:
        started = time.monotonic()
        with pytest.raises(amalgam.FrameTimeout, match="within 1 s"):
            list(session.stream([(FRAMES[0], [])]))
        assert 1.0 <= time.monotonic() - started < 1.9


def test_a_name_that_cannot_be_encoded():
    with pytest.raises(amalgam.ConnectFailed):
        amalgam.connect("a..b:1", camera=support.CAMERA)


# --- asyncio ---


def test_async_sessions_do_the_same(server):
    async def work():
        async with connect_async(server) as session:
            first = await session.send(FRAMES[0], [])
            assert first.unchanged and first.jpeg == FRAMES[0]
            # None of these waits for the other; a newer one may replace an older one.
            several = await asyncio.gather(*(session.send(f, []) for f in FRAMES[:6]), return_exceptions=True)
            assert {type(s) for s in several} <= {amalgam.Composite, amalgam.FrameSkipped}
            for frame, answer in zip(FRAMES, several):
                assert isinstance(answer, amalgam.FrameSkipped) or answer.jpeg == frame

            async def camera():
                for frame in FRAMES[:5]:
                    yield frame, []

            seen = [c.index async for c in session.stream(camera(), newest_wins=False)]
            assert seen == [0, 1, 2, 3, 4]
            with pytest.raises(amalgam.BadImage):
                await session.send(b"no picture", [])
            assert (await session.send(FRAMES[0], [])).unchanged
        with pytest.raises(amalgam.SessionClosed):
            await session.send(FRAMES[0], [])

    asyncio.run(work())


def test_async_sessions_end_the_same(tmp_path):
    (tmp_path / "tokens").write_text("opensesame\n")
    (tmp_path / "tokens").chmod(0o600)

    async def work(server):
        with pytest.raises(amalgam.AuthFailed):
            await connect_async(server, token="wrong").open()
        async with connect_async(server, token="opensesame") as session:
            with pytest.raises(amalgam.Busy):
                await connect_async(server, token="opensesame").open()
            await session.send(FRAMES[0], [])
            server.drain()
            with pytest.raises(amalgam.Draining):
                while True:
                    await session.send(FRAMES[0], [])
            assert session.draining or server.process.wait(25) == 0

    # One: while a session is there, the next one is refused.
    with support.serving("--token-file", tmp_path / "tokens", "--max-connections", "1") as server:
        asyncio.run(work(server))


def test_a_cancelled_send_leaves_the_session_open(server):
    async def work():
        async with connect_async(server) as session:
            sending = asyncio.create_task(session.send(FRAMES[0], []))
            await asyncio.sleep(0)
            sending.cancel()
            with pytest.raises(asyncio.CancelledError):
                await sending
            assert (await session.send(FRAMES[1], [])).jpeg == FRAMES[1]

    asyncio.run(work())
