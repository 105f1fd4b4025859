"""The surroundings of the scene: a picture and the lens that took it."""

from __future__ import annotations

import math
import os
import pathlib
from dataclasses import dataclass
from typing import Optional, Tuple, Union

from . import amalgam_pb2 as pb
from . import limits
from .errors import LimitError
from .jpeg import decode_image, encode_jpeg, opencv, sendable_size

_QUALITY = 95  # light is extracted from it: artefacts would become lamps


@dataclass(frozen=True)
class Fisheye:
    """An equidistant lens, r = f * angle, for an image of exactly this size."""

    width: int
    height: int
    fx: float  # pixels for each radian
    fy: float
    cx: float
    cy: float
    max_angle: float  # radians from the axis; further out the image shows nothing
    # Unit quaternion x y z w. This one looks straight up, the image's top towards the marker's top.
    world_from_fisheye: Tuple[float, float, float, float] = (0.0, math.sqrt(0.5), math.sqrt(0.5), 0.0)

    def check(self) -> None:
        if not all(limits.MIN_FOCAL_LENGTH <= f <= limits.MAX_FOCAL_LENGTH for f in (self.fx, self.fy)):
            raise LimitError("focal length is not within 1 and 1e6 pixels for each radian")
        if not (abs(self.cx) <= 10 * self.width and abs(self.cy) <= 10 * self.height):
            raise LimitError("principal point is not within ten image sides")
        if not 0 < self.max_angle <= math.pi:
            raise LimitError("max_angle is above 0 and at most pi")
        if not abs(math.hypot(*self.world_from_fisheye) - 1) <= limits.MAX_OFF_UNIT:
            raise LimitError("world_from_fisheye is no unit quaternion")

    def to_message(self) -> pb.Fisheye:
        x, y, z, w = self.world_from_fisheye
        return pb.Fisheye(width=self.width, height=self.height, fx=self.fx, fy=self.fy, cx=self.cx, cy=self.cy,
                          max_angle=self.max_angle, world_from_fisheye=pb.Quaternion(x=x, y=y, z=z, w=w))


def make_environment(image: Union[bytes, str, "os.PathLike[str]"], fisheye: Optional[Fisheye],
                     own: bool) -> pb.Environment:
    """image: a JPEG that a server accepts is sent as it is; others are scaled down if necessary and encoded."""
    data = bytes(image) if isinstance(image, (bytes, bytearray)) else pathlib.Path(image).read_bytes()
    size = sendable_size(data)
    if size is None or max(size) > limits.MAX_SIDE:
        pixels = decode_image(data)
        height, width = pixels.shape[:2]
        scale = min(1.0, limits.MAX_SIDE / max(height, width))
        size = (max(1, round(width * scale)), max(1, round(height * scale)))
        if scale < 1:
            cv2 = opencv()
            pixels = cv2.resize(pixels, size, interpolation=cv2.INTER_AREA)
        data = encode_jpeg(pixels, _QUALITY)
    environment = pb.Environment(image=data, own=own)
    if fisheye is not None:
        fisheye.check()
        if (fisheye.width, fisheye.height) != size:
            raise LimitError(f"the lens is for {fisheye.width}x{fisheye.height}, the image is {size[0]}x{size[1]}")
        environment.fisheye.CopyFrom(fisheye.to_message())
    return environment
