"""A session for asyncio. amalgam.connect() wraps it for everybody else."""

from __future__ import annotations

import asyncio
import contextlib
import ssl
import time
from dataclasses import dataclass
from types import TracebackType
from typing import Any, AsyncIterable, AsyncIterator, Callable, Dict, Iterable, List, Literal, Optional
from typing import Sequence, Tuple, Type, Union

from . import conversation as core
from . import errors, limits
from .address import Path, parse_address, tls_context
from .camera import Camera
from .environment import Fisheye, make_environment
from .jpeg import Frame, decode_image, to_jpeg
from .markers import MarkerTracker
from .newest_wins import stream
from .values import Composite, Corners, OneEuro, Pose, Welcome

_READ_BYTES = 64 * 1024

StreamFrame = Union[Frame, Tuple[Frame, Optional[Sequence[Pose]]]]


def _now_us() -> int:
    return time.monotonic_ns() // 1000


@dataclass
class FrameCounts:
    """What became of the frames of a session."""

    sent: int = 0
    composited: int = 0
    unchanged: int = 0  # of the composited: came back byte for byte
    skipped_by_client: int = 0  # replaced by a newer frame before they were sent
    skipped_by_server: int = 0  # never answered, although a later one was
    rejected: int = 0
    lost: int = 0  # unanswered when the session ended


class AsyncSession:
    """One session, from open() to close(); a broken one is not reconnected.

    server: HOST:PORT. camera: of the size of all frames. token: if the server asks for one. tls: True, or a context
    of your own; ca: PEM file of the certificates that are trusted with it. jpeg_quality: of composites, 1 to 100, or 0
    for the server's choice. camera_quality: of frames that have to be encoded. find: what send() does with a frame
    that comes without poses and corners: looks for markers and sends their "poses", or their "corners" for the server
    to solve (smoothed, with smoothing), or "nothing". Times in seconds: connect_timeout until the Welcome,
    frame_timeout from a frame's sending to its answer.
    """

    def __init__(self, server: str, *, camera: Camera, token: str = "", tls: Union[bool, ssl.SSLContext] = False,
                 ca: Optional[Path] = None, jpeg_quality: int = 0, camera_quality: int = 92,
                 find: Literal["poses", "corners", "nothing"] = "poses", smoothing: Optional[OneEuro] = None,
                 connect_timeout: float = 5.0, frame_timeout: float = 10.0) -> None:
        if find not in ("poses", "corners", "nothing"):
            raise errors.LimitError(f"find is poses, corners or nothing, and not {find!r}")
        self._address = parse_address(server)
        self._tls = tls_context(tls, ca)
        self._core = core.Conversation(core.make_hello(camera, token, jpeg_quality, smoothing))
        self._camera, self._camera_quality, self._find = camera, camera_quality, find
        self._connect_timeout, self.frame_timeout = connect_timeout, frame_timeout
        self._answers: Dict[int, "asyncio.Future[Composite]"] = {}
        self._environment: Optional["asyncio.Future[None]"] = None
        self._preparing = asyncio.Lock()
        self._tracker: Optional[MarkerTracker] = None
        self.counts = FrameCounts()
        # Complaints of the server that belong to no call that waits for one.
        self.warnings: List[errors.AmalgamError] = []

    # --- opening and closing ---

    async def open(self) -> None:
        host, port = self._address
        until = time.monotonic() + self._connect_timeout
        where = f"{host}:{port}"
        try:
            self._reader, self._writer = await asyncio.wait_for(
                asyncio.open_connection(host, port, ssl=self._tls, limit=_READ_BYTES), self._connect_timeout)
        except asyncio.TimeoutError:
            raise errors.ConnectFailed(f"{where}: no connection in time") from None
        except (OSError, UnicodeError) as error:  # UnicodeError: a name with an empty label, as "a..b"
            raise errors.ConnectFailed(f"{where}: {error}") from error
        self._welcomed: "asyncio.Future[Welcome]" = asyncio.get_running_loop().create_future()
        self._flush()
        self._reading = asyncio.create_task(self._read())
        try:
            await asyncio.wait_for(asyncio.shield(self._welcomed), max(until - time.monotonic(), 0.001))
        except asyncio.TimeoutError:
            await self._abort()
            raise errors.ConnectFailed(f"{where}: no welcome in time") from None
        except errors.SessionClosed as error:
            await self._abort()
            # Not refused with a reason: closed, silent, or no server of ours.
            if type(error) is errors.SessionClosed:
                raise errors.ConnectFailed(f"{where}: {error}") from None
            raise
        except BaseException:
            await self._abort()
            raise

    async def close(self) -> None:
        """Says goodbye. Frames that are not answered yet will not be."""
        if self._core.state is not core.State.ENDED:
            self._core.say_goodbye()
            self._flush()
            await asyncio.wait([self._reading], timeout=limits.LINGER)
        await self._abort()

    async def __aenter__(self) -> AsyncSession:
        await self.open()
        return self

    async def __aexit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                        trace: Optional[TracebackType]) -> None:
        await self.close()

    async def _abort(self) -> None:
        self._reading.cancel()
        await asyncio.wait([self._reading])
        self._dispatch(self._core.lost(errors.SessionClosed("the session was closed")))
        # asyncio's TLS transport forgets its protocol when it is closed twice, and fails then.
        with contextlib.suppress(AttributeError):
            self._writer.transport.abort()

    # --- what a user asks for ---

    @property
    def welcome(self) -> Welcome:
        """What the server said about itself: its limits, and the markers to look for."""
        if self._core.welcome is None:
            raise errors.SessionClosed("the session is not open")
        return self._core.welcome

    @property
    def draining(self) -> bool:
        """Whether the server has said that it is about to end."""
        return self._core.state is core.State.DRAINING

    async def send(self, frame: Frame, poses: Optional[Sequence[Pose]] = None, *,
                   corners: Optional[Sequence[Corners]] = None, capture_time: Optional[float] = None,
                   timeout: Optional[float] = None) -> Composite:
        """Sends one frame and waits for its composite.

        frame: a BGR array, the bytes of a JPEG, or a path. poses or corners: of its markers; without both, they are
        looked for as the session's `find` says. capture_time: seconds of time.monotonic(); now, if left out.
        Raises FrameRejected, FrameSkipped or FrameTimeout, after which the session goes on, or SessionClosed.
        """
        limit = self.frame_timeout if timeout is None else timeout
        frame_id, answer = await self.begin(frame, poses, corners, capture_time)
        return await self.finish(frame_id, answer, limit)

    async def begin(self, frame: Frame, poses: Optional[Sequence[Pose]], corners: Optional[Sequence[Corners]],
                    capture_time: Optional[float]) -> Tuple[int, "asyncio.Future[Composite]"]:
        """Sends a frame. Returns its id and its answer to come."""
        capture_time_us = _now_us() if capture_time is None else round(capture_time * 1e6)
        self._core.check_open()
        # In a thread, so that pings are answered meanwhile; one at a time, because the tracker remembers.
        async with self._preparing:
            prepared = await asyncio.to_thread(self._prepare, frame, poses, corners)
        frame_id = self._core.send_frame(*prepared, capture_time_us)
        answer: "asyncio.Future[Composite]" = asyncio.get_running_loop().create_future()
        self._answers[frame_id] = answer
        self.counts.sent += 1
        self._flush()
        return frame_id, answer

    async def finish(self, frame_id: int, answer: "asyncio.Future[Composite]", timeout: float,
                     sent_at: Optional[float] = None) -> Composite:
        """sent_at: time.monotonic() from which the timeout counts; now, if left out."""
        left = timeout if sent_at is None else max(0.0, sent_at + timeout - time.monotonic())
        try:
            return await asyncio.wait_for(answer, left)
        except asyncio.TimeoutError:
            raise errors.FrameTimeout(f"frame {frame_id} was not answered within {timeout:g} s") from None
        finally:
            self._answers.pop(frame_id, None)

    def stream(self, frames: Union[Iterable[StreamFrame], AsyncIterable[StreamFrame]], *, newest_wins: bool = True,
               in_flight: int = 2,
               on_rejected: Optional[Callable[[int, errors.FrameRejected], None]] = None) -> AsyncIterator[Composite]:
        """Sends frames as they come and yields their composites, in order.

        frames: frames as for send(), or pairs of a frame and its poses. newest_wins: while in_flight frames are
        unanswered, a newer frame replaces the one that waits, as live cameras need it. False: the source waits until
        each frame is answered, because a server too keeps only the newest of several.
        Composite.index says which frame it is of, and Composite.skipped which ones were left out right before it.
        on_rejected(index, error) is called for a rejected frame; without it, the error is raised.
        """
        return stream(self, frames, newest_wins, in_flight if newest_wins else 1, on_rejected)

    async def set_environment(self, image: Union[bytes, Path], *, fisheye: Optional[Fisheye] = None, own: bool = False,
                              wait: float = 0.5) -> None:
        """Lights the scene by a picture of the surroundings: equirectangular, or through a fish-eye lens.

        own: for this session only. A server answers only unusable pictures: waits so many seconds for that, and
        raises EnvironmentRejected. A later complaint is added to `warnings`.
        """
        message = await asyncio.to_thread(make_environment, image, fisheye, own)
        self._core.send_environment(message)
        self._environment = asyncio.get_running_loop().create_future()
        self._flush()
        try:
            await asyncio.wait_for(self._environment, wait)
        except asyncio.TimeoutError:
            pass
        finally:
            self._environment = None

    # --- the machinery ---

    def _prepare(self, frame: Frame, poses: Optional[Sequence[Pose]], corners: Optional[Sequence[Corners]]) -> \
            Tuple[bytes, Sequence[Pose], Sequence[Corners]]:
        jpeg = to_jpeg(frame, self._camera_quality)
        if poses is not None or corners is not None or self._find == "nothing":
            return jpeg, poses or (), corners or ()
        if self._tracker is None:
            self._tracker = MarkerTracker(self.welcome.markers, self._camera)
        # In the pixels that the server will see.
        image = decode_image(jpeg)
        if self._find == "corners":
            return jpeg, (), self._tracker.detect(image)[: limits.MAX_POSES]
        return jpeg, self._tracker.track(image)[: limits.MAX_POSES], ()

    def _flush(self) -> None:
        data = self._core.take_output()
        if data and not self._writer.is_closing():
            self._writer.write(data)

    async def _read(self) -> None:
        why: errors.AmalgamError = errors.SessionClosed("the server closed the connection")
        try:
            while self._core.state is not core.State.ENDED:
                patience = self._core.welcome.idle_timeout if self._core.welcome else limits.IDLE_TIMEOUT
                data = await asyncio.wait_for(self._reader.read(_READ_BYTES), patience)
                if not data:
                    break
                self._dispatch(self._core.receive(data, _now_us()))
                self._flush()
        except asyncio.TimeoutError:
            why = errors.IdleTimeout("the server has fallen silent")
        except OSError as error:
            why = errors.SessionClosed(f"the connection broke: {error}")
        self._dispatch(self._core.lost(why))
        self._writer.close()

    def _dispatch(self, events: Sequence[core.Event]) -> None:
        for event in events:
            if isinstance(event, core.Welcomed):
                self._welcomed.set_result(event.welcome)
            elif isinstance(event, core.Answered):
                self.counts.composited += 1
                self.counts.unchanged += event.composite.unchanged
                self.counts.skipped_by_server += len(event.skipped)
                for frame_id in event.skipped:
                    self._settle(frame_id, errors.FrameSkipped(frame_id))
                self._settle(event.composite.frame_id, event.composite)
            elif isinstance(event, core.Rejected):
                self._on_rejected(event)
            elif isinstance(event, core.Ended):
                self.counts.lost += len(event.unanswered)
                for frame_id in event.unanswered:
                    self._settle(frame_id, event.error)
                _fail(self._welcomed, event.error)
                if self._environment is not None:
                    _fail(self._environment, event.error)

    def _on_rejected(self, event: core.Rejected) -> None:
        if isinstance(event.error, errors.EnvironmentRejected) and self._environment is not None:
            _fail(self._environment, event.error)
        elif event.frame_id:
            self.counts.rejected += 1
            self._settle(event.frame_id, event.error)
        elif not isinstance(event.error, errors.PoseRejected):  # that is in its composite
            self.warnings.append(event.error)

    def _settle(self, frame_id: int, outcome: Union[Composite, errors.AmalgamError]) -> None:
        answer = self._answers.pop(frame_id, None)
        if answer is None or answer.done():
            return  # nobody waits for it any more
        if isinstance(outcome, Composite):
            answer.set_result(outcome)
        else:
            _fail(answer, outcome)


def _fail(future: "asyncio.Future[Any]", error: errors.AmalgamError) -> None:
    if not future.done():
        future.set_exception(error)
        future.exception()  # nobody may be waiting for it, which is no fault
