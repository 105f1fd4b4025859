"""What goes in and comes out, as plain values."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Dict, List, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from . import amalgam_pb2 as pb
from . import limits
from .errors import FrameRejected, LimitError
from .jpeg import decode_image

Image = npt.NDArray[np.uint8]


@dataclass(frozen=True)
class Pose:
    """camera_from_marker, in OpenCV's camera frame: x right, y down, z forward."""

    marker: int
    rotation: Tuple[float, float, float, float]  # unit quaternion x y z w
    translation: Tuple[float, float, float]  # metres

    def check(self) -> None:
        """Raises LimitError for a pose that the server would reject."""
        if not all(math.isfinite(v) for v in (*self.rotation, *self.translation)):
            raise LimitError(f"the pose of marker {self.marker} is not finite")
        if abs(math.hypot(*self.rotation) - 1) > limits.MAX_OFF_UNIT:
            raise LimitError(f"the rotation of marker {self.marker} is no unit quaternion")
        if max(abs(v) for v in self.translation) > limits.MAX_POSE_COORDINATE:
            raise LimitError(f"marker {self.marker} is more than {limits.MAX_POSE_COORDINATE:g} m away")

    def to_message(self) -> pb.Pose:
        (x, y, z, w), t = self.rotation, self.translation
        return pb.Pose(marker=self.marker, rotation=pb.Quaternion(x=x, y=y, z=z, w=w),
                       translation=pb.Vector3(x=t[0], y=t[1], z=t[2]))

    @staticmethod
    def from_message(message: pb.Pose) -> Pose:
        r, t = message.rotation, message.translation
        return Pose(message.marker, (r.x, r.y, r.z, r.w), (t.x, t.y, t.z))


@dataclass(frozen=True)
class Corners:
    """A found marker, for the server to solve its pose.

    pixels: of the printed marker's top left, top right, bottom right and bottom left corner.
    """

    marker: int
    pixels: Tuple[Tuple[float, float], ...]

    def check(self) -> None:
        if len(self.pixels) != 4 or not all(len(p) == 2 and all(map(math.isfinite, p)) for p in self.pixels):
            raise LimitError(f"marker {self.marker} needs four corners of two finite numbers")

    def to_message(self) -> pb.MarkerCorners:
        return pb.MarkerCorners(marker=self.marker, pixels=[v for p in self.pixels for v in p])


@dataclass(frozen=True)
class OneEuro:
    """Smoothing of the poses that the server solves from corners."""

    min_cutoff: float  # Hz, above 0
    beta: float = 0.0  # Hz for each m/s and each rad/s

    def check(self) -> None:
        if not (0 < self.min_cutoff <= limits.MAX_SMOOTHING and 0 <= self.beta <= limits.MAX_SMOOTHING):
            raise LimitError("smoothing needs a min_cutoff above 0 and a beta of 0 or more, both at most 1e6")


@dataclass(frozen=True)
class Markers:
    """What the server asks its clients to look for."""

    dictionary: str  # OpenCV's name
    length: float  # metres, side of the black square
    world_marker: int
    ids: Tuple[int, ...]


@dataclass(frozen=True)
class Welcome:
    session: int
    max_message_bytes: int
    max_poses: int
    ping_interval: float  # seconds
    idle_timeout: float  # seconds
    markers: Markers

    @staticmethod
    def from_message(message: pb.Welcome) -> Welcome:
        limit, markers = message.limits, message.markers
        return Welcome(
            session=message.session,
            max_message_bytes=limit.max_message_bytes or limits.MAX_CAMERA_FRAME_BYTES,
            max_poses=limit.max_poses or limits.MAX_POSES,
            ping_interval=limit.ping_interval_ms / 1000,
            idle_timeout=limit.idle_timeout_ms / 1000 or limits.IDLE_TIMEOUT,
            markers=Markers(markers.dictionary, markers.length, markers.world_marker, tuple(markers.ids)))


@dataclass(frozen=True)
class Pass:
    """A pass of the renderer: whether it ran, or why not."""

    name: str
    ran: bool
    reason: str


@dataclass(frozen=True)
class Composite:
    """A frame with the virtual objects in it; PROTOCOL.md says what each number means."""

    frame_id: int
    capture_time: float  # seconds of the clock that the frame's capture_time was of
    latency_ms: float  # from the capture to the arrival of this composite
    server_ms: float  # of that, spent by the server
    jpeg: bytes
    unchanged: bool  # jpeg is the frame's own, byte for byte
    poses: Tuple[Pose, ...]
    stages: Dict[str, float]  # milliseconds
    passes: Tuple[Pass, ...]
    rays: Dict[str, int]
    pixels: Dict[str, int]
    nonfinite: int
    skipped_total: int  # frames of this session that the server will never answer, so far
    quality: Optional[pb.Quality] = None
    truncation_bound: Optional[Tuple[float, float]] = None  # mean, worst
    warnings: Tuple[FrameRejected, ...] = ()
    # Of stream(): the frame's place in the source, and the places of those skipped right before it.
    index: Optional[int] = None
    skipped: Tuple[int, ...] = field(default=())

    @cached_property
    def image(self) -> Image:
        """The composite as a BGR array; decoded when it is first asked for."""
        return decode_image(self.jpeg)

    @staticmethod
    def from_message(message: pb.Composite, now_us: int, warnings: Sequence[FrameRejected]) -> Composite:
        bound = message.truncation_bound
        return Composite(
            frame_id=message.frame_id,
            capture_time=message.capture_time_us / 1e6,
            latency_ms=(now_us - message.capture_time_us) / 1000,
            server_ms=message.server_ms,
            jpeg=message.jpeg,
            unchanged=message.unchanged,
            poses=tuple(Pose.from_message(p) for p in message.poses),
            stages={s.name: s.milliseconds for s in message.stages},
            passes=tuple(Pass(p.name, p.ran, p.reason) for p in message.passes),
            rays=_numbers(message.rays),
            pixels=_numbers(message.pixels),
            nonfinite=message.nonfinite,
            skipped_total=message.skipped,
            quality=message.quality if message.HasField("quality") else None,
            truncation_bound=(bound.mean, bound.worst) if message.HasField("truncation_bound") else None,
            warnings=tuple(warnings))


def _numbers(message: pb.Rays | pb.Pixels) -> Dict[str, int]:
    names: List[str] = [f.name for f in message.DESCRIPTOR.fields]
    return {name: int(getattr(message, name)) for name in names}
