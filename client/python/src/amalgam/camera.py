"""The camera that takes the frames: OpenCV's pinhole model with its lens distortion."""

from __future__ import annotations

import math
import os
import pathlib
from dataclasses import dataclass, replace
from typing import Any, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import amalgam_pb2 as pb
from . import limits
from .errors import LimitError
from .jpeg import opencv

_MATRIX_NAMES = ("camera_matrix", "cameraMatrix", "CameraMatrix", "Camera_Matrix", "mtx", "K")
_DISTORTION_NAMES = ("distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "dist_coeffs", "dist_coeff",
                     "dist", "D")


@dataclass(frozen=True)
class Camera:
    """Pixel (0, 0) is the centre of the top left pixel."""

    width: int
    height: int
    fx: float
    fy: float
    cx: float
    cy: float
    # k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4; missing ones at the end are 0.
    distortion: Tuple[float, ...] = ()

    @staticmethod
    def from_fov(width: int, height: int, horizontal_degrees: float = 60.0) -> Camera:
        """A guess for an unknown lens: square pixels, no distortion."""
        if not 0 < horizontal_degrees < 180:
            raise LimitError("a field of view is above 0 and below 180 degrees")
        focal = width / 2 / math.tan(math.radians(horizontal_degrees) / 2)
        return Camera(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)

    @staticmethod
    def from_file(file: Union[str, "os.PathLike[str]"], size: Optional[Tuple[int, int]] = None) -> Camera:
        """From a calibration as OpenCV (YAML, XML, JSON), ROS or Kalibr (pinhole-radtan) writes it.

        size: width and height of the frames, if they are not the calibration's; scales it. Raises LimitError with
        one line if the file cannot be used.
        """
        # OpenCV 4.6 raises some of its errors inside a SystemError.
        try:
            return _read(pathlib.Path(file), size)
        except (OSError, UnicodeDecodeError, opencv().error, SystemError) as error:
            raise LimitError(f"calibration {file}: cannot be read ({str(error).splitlines()[0]})") from None
        except LimitError as error:
            raise LimitError(f"calibration {file}: {error}") from None

    def scaled_to(self, width: int, height: int) -> Camera:
        scale_x, scale_y = width / self.width, height / self.height
        if abs(self.height * scale_x - height) > 1:
            raise LimitError(f"is for {self.width}x{self.height}, and {width}x{height} is a crop of that")
        # Lengths scale about the image's corner, half a pixel before the first pixel's centre.
        return replace(self, width=width, height=height, fx=self.fx * scale_x, fy=self.fy * scale_y,
                       cx=(self.cx + 0.5) * scale_x - 0.5, cy=(self.cy + 0.5) * scale_y - 0.5)

    def check(self) -> None:
        """Raises LimitError for a camera that no server takes."""
        if not (1 <= self.width <= limits.MAX_SIDE and 1 <= self.height <= limits.MAX_SIDE):
            raise LimitError(f"image size {self.width}x{self.height} is not within 1x1 and 2048x2048")
        if not all(limits.MIN_FOCAL_LENGTH <= f <= limits.MAX_FOCAL_LENGTH for f in (self.fx, self.fy)):
            raise LimitError("focal length is not within 1 and 1e6 pixels")
        if not (abs(self.cx) <= 10 * self.width and abs(self.cy) <= 10 * self.height):
            raise LimitError("principal point is not within ten image sides")
        if len(self.distortion) > limits.MAX_DISTORTION:
            raise LimitError("more than 12 distortion coefficients")
        if not all(map(math.isfinite, self.distortion)):
            raise LimitError("a distortion coefficient is not finite")

    def matrix(self) -> npt.NDArray[np.float64]:
        return np.array([[self.fx, 0, self.cx], [0, self.fy, self.cy], [0, 0, 1]], np.float64)

    def coefficients(self) -> npt.NDArray[np.float64]:
        """All 12, for OpenCV, which does not take any number of them."""
        return np.array([*self.distortion, *[0.0] * (limits.MAX_DISTORTION - len(self.distortion))], np.float64)

    def to_message(self) -> pb.Camera:
        return pb.Camera(width=self.width, height=self.height, fx=self.fx, fy=self.fy, cx=self.cx, cy=self.cy,
                         distortion=self.distortion)


def _numbers(node: Any) -> List[float]:
    """Of a matrix, a list, or a map with the list `data`."""
    if node.isMap():
        node = node.getNode("data")
    if node.isSeq():
        return [v for i in range(node.size()) for v in _numbers(node.at(i))]
    return [node.real()] if node.isReal() or node.isInt() else []


def _first(root: Any, names: Sequence[str]) -> Any:
    nodes = [root.getNode(name) for name in names]
    return next((node for node in nodes if not node.empty()), nodes[0])


@dataclass(frozen=True)
class _Calibration:
    """What a file says, whoever wrote it."""

    size: Optional[Tuple[int, int]]
    focal: Tuple[float, float]
    centre: Tuple[float, float]
    distortion: List[float]


def _read_kalibr(root: Any) -> _Calibration:
    if not root.getNode("cam1").empty():
        raise LimitError("is a Kalibr file of several cameras; keep one of them")
    camera = root.getNode("cam0")
    models = [camera.getNode(name) for name in ("camera_model", "distortion_model")]
    names = [model.string() if model.isString() else "none" for model in models]
    if names != ["pinhole", "radtan"]:
        raise LimitError(f"is a Kalibr file of model {'-'.join(names)}; only pinhole-radtan is supported")
    intrinsics = _numbers(camera.getNode("intrinsics"))
    distortion = _numbers(camera.getNode("distortion_coeffs"))
    if len(intrinsics) != 4 or len(distortion) != 4:
        raise LimitError("is a Kalibr file without 4 intrinsics and 4 distortion_coeffs")
    size = _numbers(camera.getNode("resolution"))
    fx, fy, cx, cy = intrinsics
    return _Calibration((int(size[0]), int(size[1])) if len(size) == 2 else None, (fx, fy), (cx, cy), distortion)


def _read_flat(root: Any) -> _Calibration:
    matrix = _numbers(_first(root, _MATRIX_NAMES))
    if len(matrix) != 9:
        raise LimitError("has no 3x3 camera_matrix")
    if any(matrix[i] != 0 for i in (1, 3, 6, 7)) or matrix[8] != 1:
        raise LimitError("the camera matrix is not of the form [fx 0 cx; 0 fy cy; 0 0 1]")
    fisheye = root.getNode("fisheye_model")
    if fisheye.isInt() and fisheye.real() != 0:
        raise LimitError("the fisheye lens model is not supported")
    model = root.getNode("distortion_model")
    if model.isString() and model.string() not in ("", "plumb_bob", "rational_polynomial"):
        raise LimitError(f"the distortion model {model.string()} is not supported")
    distortion_node = _first(root, _DISTORTION_NAMES)
    if distortion_node.empty():
        raise LimitError("has no distortion_coefficients")
    distortion = _numbers(distortion_node)
    sides = [_numbers(_first(root, names)) for names in (("image_width", "width"), ("image_height", "height"))]
    size = (int(sides[0][0]), int(sides[1][0])) if sides[0] and sides[1] else None
    return _Calibration(size, (matrix[0], matrix[4]), (matrix[2], matrix[5]), distortion)


def _read(file: pathlib.Path, size: Optional[Tuple[int, int]]) -> Camera:
    cv2 = opencv()
    text = file.read_text()
    if not text.lstrip().startswith(("%YAML", "{", "<?xml")):
        # ROS and Kalibr leave out the head that OpenCV asks for. What rostopic echo prints ends in a line ---, or has
        # further messages behind it.
        begin = text.find("\n") if text.startswith("---") else 0
        text = "%YAML:1.0\n---\n" + text[begin:].split("\n---")[0] + "\n"
    storage = cv2.FileStorage(text, cv2.FILE_STORAGE_READ | cv2.FILE_STORAGE_MEMORY)
    root = storage.root()
    read = _read_kalibr(root) if root.getNode("cam0").isMap() else _read_flat(root)
    if any(read.distortion[limits.MAX_DISTORTION :]):
        raise LimitError("a tilted sensor (distortion coefficients 13 and 14) is not supported")
    own = read.size or size
    if own is None:
        raise LimitError("does not say its image's size; pass size=(width, height)")
    camera = Camera(*own, *read.focal, *read.centre, tuple(read.distortion[: limits.MAX_DISTORTION]))
    camera = camera.scaled_to(*size) if size and size != own else camera
    camera.check()
    return camera
