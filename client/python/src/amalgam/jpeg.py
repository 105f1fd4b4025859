"""JPEG: what can be sent unchanged, encoding and decoding."""

from __future__ import annotations

import os
import pathlib
from typing import Any, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import limits
from .errors import BadImage

Frame = Union["npt.NDArray[np.uint8]", bytes, bytearray, memoryview, str, "os.PathLike[str]"]

# Poses and field headers share the message with the image.
_MESSAGE_OVERHEAD = 16 * 1024
_LUMA_SAMPLINGS = (0x11, 0x21, 0x22)


def opencv() -> Any:
    """The module cv2, which only images and markers need."""
    try:
        import cv2
    except ImportError:
        raise ImportError("amalgam needs OpenCV for this; on Debian: apt install python3-opencv, "
                          "elsewhere: pip install opencv-contrib-python") from None
    return cv2


def _baseline_header(data: bytes) -> Optional[bytes]:
    """The body of the SOF0 segment; None if the frame is of another kind."""
    if data[:2] != b"\xff\xd8":
        return None
    at = 2
    while at + 4 <= len(data):
        marker = data[at + 1]
        if data[at] != 0xFF or marker in (0x00, 0xFF):
            at += 1  # a fill byte, or a stray one, which decoders skip
            continue
        length = int.from_bytes(data[at + 2 : at + 4], "big")
        if length < 2 or at + 2 + length > len(data) or marker == 0xDA:
            return None
        if marker == 0xC0:
            return data[at + 4 : at + 2 + length]
        if 0xC1 <= marker <= 0xCF and marker not in (0xC4, 0xCC):
            return None
        at += 2 + length
    return None


def sendable_size(data: bytes) -> Optional[Tuple[int, int]]:
    """Width and height of a JPEG that a server accepts; None for others. Reads headers only."""
    if len(data) + _MESSAGE_OVERHEAD > limits.MAX_CAMERA_FRAME_BYTES:
        return None
    header = _baseline_header(data)
    if header is None or len(header) < 6 or header[0] != 8:
        return None
    components = header[5]
    if len(header) < 6 + 3 * components:
        return None
    sampling = [header[6 + 3 * i + 1] for i in range(components)]
    colored = components == 3 and sampling[0] in _LUMA_SAMPLINGS and sampling[1] == sampling[2] == 0x11
    if components != 1 and not colored:
        return None
    return int.from_bytes(header[3:5], "big"), int.from_bytes(header[1:3], "big")


def encode_jpeg(image: npt.NDArray[np.uint8], quality: int) -> bytes:
    cv2 = opencv()
    is_picture = image.dtype == np.uint8 and image.size > 0 and (
        image.ndim == 2 or (image.ndim == 3 and image.shape[2] in (1, 3)))
    if not is_picture:
        raise BadImage(f"an image must be a uint8 array, grey or BGR; this one is {image.dtype} {image.shape}")
    _, data = cv2.imencode(".jpg", np.ascontiguousarray(image), [cv2.IMWRITE_JPEG_QUALITY, quality])
    return bytes(data)


def decode_image(data: bytes) -> npt.NDArray[np.uint8]:
    """As BGR. Ignores orientation tags, because the server does too and markers must match its pixels."""
    cv2 = opencv()
    image: Optional[npt.NDArray[np.uint8]] = None
    if data:
        flags = cv2.IMREAD_COLOR | cv2.IMREAD_IGNORE_ORIENTATION
        image = cv2.imdecode(np.frombuffer(data, np.uint8), flags)
    if image is None:
        raise BadImage("these bytes are no image")
    return image


def to_jpeg(frame: Frame, quality: int) -> bytes:
    """What is sent for a frame: a baseline JPEG as it is, anything else encoded."""
    if isinstance(frame, np.ndarray):
        return encode_jpeg(frame, quality)
    if isinstance(frame, (bytes, bytearray, memoryview)):
        data = bytes(frame)
    else:
        data = pathlib.Path(frame).read_bytes()
    return data if sendable_size(data) else encode_jpeg(decode_image(data), quality)
