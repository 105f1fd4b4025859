"""The protocol without input and output: bytes and wishes in, bytes and events out.

Sessions move the bytes. This decides what they mean: it answers pings, checks limits before anything is queued, and
accounts for every frame.
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import Dict, List, Optional, Sequence, Tuple, Union

from . import amalgam_pb2 as pb
from . import errors, limits
from .camera import Camera
from .framing import Decoder, encode
from .jpeg import sendable_size
from .values import Composite, Corners, OneEuro, Pose, Welcome


@dataclass(frozen=True)
class Welcomed:
    welcome: Welcome


@dataclass(frozen=True)
class Answered:
    """A frame's composite. skipped: earlier frames that will never be answered."""

    composite: Composite
    skipped: Tuple[int, ...]


@dataclass(frozen=True)
class Rejected:
    """A frame or, with the id 0, something else cannot be used. The session goes on."""

    frame_id: int
    error: errors.AmalgamError


@dataclass(frozen=True)
class DrainingBegan:
    error: errors.Draining


@dataclass(frozen=True)
class Ended:
    """Nothing follows. unanswered: frames that will never be answered."""

    error: errors.AmalgamError
    unanswered: Tuple[int, ...]


Event = Union[Welcomed, Answered, Rejected, DrainingBegan, Ended]


class State(enum.Enum):
    AWAITING_WELCOME = enum.auto()
    RUNNING = enum.auto()
    DRAINING = enum.auto()
    ENDED = enum.auto()


def make_hello(camera: Camera, token: str, jpeg_quality: int, smoothing: Optional[OneEuro]) -> pb.Hello:
    """Raises LimitError for what the server would refuse."""
    camera.check()
    if len(token.encode()) > limits.MAX_TOKEN_BYTES:
        raise errors.LimitError(f"a token has at most {limits.MAX_TOKEN_BYTES} bytes")
    if not 0 <= jpeg_quality <= limits.MAX_JPEG_QUALITY:
        raise errors.LimitError("jpeg_quality is 1 to 100, or 0 for the server's choice")
    hello = pb.Hello(version=limits.PROTOCOL_VERSION, token=token, camera=camera.to_message(),
                     jpeg_quality=jpeg_quality)
    if smoothing is not None:
        smoothing.check()
        hello.smoothing.CopyFrom(pb.OneEuro(min_cutoff=smoothing.min_cutoff, beta=smoothing.beta))
    return hello


class Conversation:
    """One session. Its first bytes, the Hello, are there from the beginning."""

    def __init__(self, hello: pb.Hello) -> None:
        self._hello = hello
        self._decoder = Decoder()
        self._out: List[bytes] = [encode(pb.Envelope(hello=hello))]
        self._open: Dict[int, List[errors.FrameRejected]] = {}  # ids in the order of sending; warnings
        self._next_id = 1
        self._draining: Optional[errors.Draining] = None
        self._end: Optional[errors.AmalgamError] = None
        self.state = State.AWAITING_WELCOME
        self.welcome: Optional[Welcome] = None

    # --- what goes out ---

    def take_output(self) -> bytes:
        """The bytes to be sent now."""
        out, self._out = b"".join(self._out), []
        return out

    def check_open(self) -> None:
        """Raises what ended the session, or Draining, if no more frames are taken."""
        if self._end is not None:
            raise self._end
        if self._draining is not None:
            raise self._draining

    def send_frame(self, jpeg: bytes, poses: Sequence[Pose], corners: Sequence[Corners], capture_time_us: int) -> int:
        """Queues a frame and returns its id. Raises LimitError or FrameRejected for one that is against the limits."""
        self.check_open()
        most = self.welcome.max_poses if self.welcome else limits.MAX_POSES
        if len(poses) + len(corners) > most:
            raise errors.TooManyPoses(f"{len(poses) + len(corners)} poses and corners; at most {most} are allowed")
        for pose in poses:
            pose.check()
        for found in corners:
            found.check()
        size, camera = sendable_size(jpeg), self._hello.camera
        if size is None:
            raise errors.BadImage("not a baseline JPEG (grey, 4:2:0, 4:2:2 or 4:4:4) of less than 4 MiB")
        if size != (camera.width, camera.height):
            raise errors.BadImage(f"the image is {size[0]}x{size[1]}, the camera {camera.width}x{camera.height}")
        if not 0 <= capture_time_us < 2**64:
            raise errors.LimitError("a capture time is not negative and below 2^64 microseconds")
        frame_id = self._next_id
        message = encode(pb.Envelope(camera_frame=pb.CameraFrame(
            frame_id=frame_id, capture_time_us=capture_time_us, poses=[p.to_message() for p in poses], jpeg=jpeg,
            corners=[c.to_message() for c in corners])))
        self._queue_image(message)
        self._next_id += 1
        self._open[frame_id] = []
        return frame_id

    def send_environment(self, environment: pb.Environment) -> None:
        self.check_open()
        if sendable_size(environment.image) is None:
            raise errors.EnvironmentRejected("not a baseline JPEG of less than 4 MiB")
        if max(sendable_size(environment.image) or ()) > limits.MAX_SIDE:
            raise errors.EnvironmentRejected("the image is larger than 2048 x 2048")
        self._queue_image(encode(pb.Envelope(environment=environment)))

    def say_goodbye(self) -> None:
        if self.state is not State.ENDED:
            self._out.append(encode(pb.Envelope(goodbye=pb.Goodbye())))

    def _queue_image(self, message: bytes) -> None:
        most = self.welcome.max_message_bytes if self.welcome else limits.MAX_CAMERA_FRAME_BYTES
        if len(message) - limits.LENGTH_BYTES > most:
            raise errors.LimitError(f"a message of {len(message)} bytes; at most {most} are allowed")
        self._out.append(message)

    # --- what comes in ---

    def receive(self, data: bytes, now_us: int) -> List[Event]:
        """The events of some bytes that came. now_us: of the clock of the capture times, microseconds."""
        events: List[Event] = []
        if self.state is State.ENDED:
            return events
        try:
            for envelope in self._decoder.feed(data):
                self._visit(envelope, now_us, events)
                if self._end is not None:
                    break
        except errors.ProtocolViolation as violation:
            events.append(self._ended(violation))
        return events

    def lost(self, why: errors.AmalgamError) -> List[Event]:
        """The connection closed, or broke, or was given up."""
        return [] if self.state is State.ENDED else [self._ended(self._draining or why)]

    def _ended(self, error: errors.AmalgamError) -> Ended:
        self.state, self._end = State.ENDED, error
        unanswered, self._open, self._out = tuple(self._open), {}, []
        return Ended(error, unanswered)

    def _visit(self, envelope: pb.Envelope, now_us: int, events: List[Event]) -> None:
        body = envelope.WhichOneof("body")
        if body == "ping":
            # The output is taken after each receive(): what came in one is owed no more answers than this.
            if len(self._out) < 32:
                self._out.append(encode(pb.Envelope(pong=pb.Pong(nonce=envelope.ping.nonce))))
        elif body == "pong":
            pass
        elif body == "welcome":
            if self.state is not State.AWAITING_WELCOME:
                raise errors.ProtocolViolation("the server sent a second welcome")
            self.state = State.RUNNING
            self.welcome = Welcome.from_message(envelope.welcome)
            events.append(Welcomed(self.welcome))
        elif body == "composite":
            self._on_composite(envelope.composite, now_us, events)
        elif body == "error":
            events.append(self._on_error(envelope.error))
        elif body == "busy":
            events.append(self._ended(errors.Busy(envelope.busy.reason, envelope.busy.retry_after_ms / 1000)))
        elif body == "draining":
            if self._draining is None:
                self.state = State.DRAINING
                self._draining = errors.Draining(envelope.draining.deadline_ms / 1000)
                events.append(DrainingBegan(self._draining))
        else:
            raise errors.ProtocolViolation(f"the server sent a {body}, which servers do not send")

    def _on_composite(self, message: pb.Composite, now_us: int, events: List[Event]) -> None:
        if self.welcome is None:
            raise errors.ProtocolViolation("the server sent a composite before its welcome")
        if message.frame_id not in self._open:
            return  # answered before, or rejected
        # Composites keep the order of their frames: earlier open ones will never be answered.
        order = list(self._open)
        skipped = tuple(order[: order.index(message.frame_id)])
        warnings = self._open.pop(message.frame_id)
        for frame_id in skipped:
            del self._open[frame_id]
        events.append(Answered(Composite.from_message(message, now_us, warnings), skipped))

    def _on_error(self, error: pb.Error) -> Event:
        name = pb.Error.Code.Name(error.code) if error.code in pb.Error.Code.values() else f"code {error.code}"
        text = f"{name}: {error.text}" if error.text else name
        if error.closes:
            return self._ended(errors.CLOSING.get(name, errors.SessionClosed)(text))
        if name == "BAD_ENVIRONMENT":
            return Rejected(0, errors.EnvironmentRejected(text))
        rejection = errors.REJECTING.get(name, errors.FrameRejected)(text, error.frame_id)
        if isinstance(rejection, errors.PoseRejected):
            self._open.get(error.frame_id, []).append(rejection)  # its composite still comes
            return Rejected(0, rejection)
        self._open.pop(error.frame_id, None)
        return Rejected(error.frame_id, rejection)
