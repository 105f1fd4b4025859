"""Finds ArUco markers in images, and their poses from frame to frame.

An unseen marker has no pose here: the server holds the last one for a moment.
"""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

from .camera import Camera
from .edges import refine_corners
from .errors import BadImage, LimitError
from .jpeg import opencv
from .square_pose import PoseChoice, Solution, solve_square
from .values import Corners, Markers, Pose


class _Detector:
    """OpenCV's, whose functions changed with version 4.7."""

    def __init__(self, dictionary: str) -> None:
        aruco = opencv().aruco
        number = getattr(aruco, dictionary, None) if dictionary.startswith("DICT_") else None
        if number is None:
            raise LimitError(f"OpenCV has no marker dictionary {dictionary}")
        self._aruco = aruco
        if hasattr(aruco, "ArucoDetector"):
            self._dictionary = aruco.getPredefinedDictionary(number)
            self._detector: Any = aruco.ArucoDetector(self._dictionary, aruco.DetectorParameters())
        else:
            self._dictionary = aruco.Dictionary_get(number)
            self._parameters = aruco.DetectorParameters_create()
            self._detector = None
        self.bits = int(self._dictionary.markerSize)

    def detect(self, grey: npt.NDArray[np.uint8]) -> List[Tuple[int, npt.NDArray[np.float64]]]:
        if self._detector is not None:
            corners, ids, _ = self._detector.detectMarkers(grey)
        else:
            corners, ids, _ = self._aruco.detectMarkers(grey, self._dictionary, parameters=self._parameters)
        if ids is None:
            return []
        return [(int(i), np.asarray(c, np.float64).reshape(4, 2)) for i, c in zip(np.ravel(ids), corners)]


def _to_grey(image: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    if image.dtype != np.uint8 or image.ndim not in (2, 3) or (image.ndim == 3 and image.shape[2] not in (1, 3)):
        raise BadImage(f"markers are sought in grey or BGR uint8 arrays; this one is {image.dtype} {image.shape}")
    if image.ndim == 2 or image.shape[2] == 1:
        return image.reshape(image.shape[:2])
    cv2 = opencv()
    return np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY))


def _area(corners: npt.NDArray[np.float64]) -> float:
    x, y = corners[:, 0], corners[:, 1]
    return abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2


class MarkerTracker:
    """For one thread at a time. markers: what the server asks for, Session.welcome.markers."""

    def __init__(self, markers: Markers, camera: Camera) -> None:
        if not 0 < markers.length < float("inf"):
            raise LimitError("the marker length must be positive")
        self._markers, self._camera = markers, camera
        self._detector = _Detector(markers.dictionary)
        self._choices: Dict[int, PoseChoice] = {}
        self._images = 0

    def detect(self, image: npt.NDArray[np.uint8]) -> List[Corners]:
        """All markers of interest in a BGR or grey image of the camera's size, repeated ids included."""
        grey = _to_grey(image)
        if grey.shape != (self._camera.height, self._camera.width):
            raise BadImage(f"the image is {grey.shape[1]}x{grey.shape[0]}, "
                           f"the camera {self._camera.width}x{self._camera.height}")
        found = []
        for marker, rough in self._detector.detect(grey):
            if not self._markers.ids or marker in self._markers.ids:
                exact = refine_corners(grey, self._detector.bits, rough)
                found.append(Corners(marker, tuple((float(x), float(y)) for x, y in exact)))
        return found

    def track(self, image: npt.NDArray[np.uint8]) -> List[Pose]:
        """One pose for each marker of interest that is seen, in ascending order of their ids."""
        detected = self.detect(image)
        self._images += 1
        candidates: Dict[int, List[Tuple[float, List[Solution]]]] = {}
        for found in detected:
            corners = np.array(found.pixels)
            solutions = solve_square(corners, found.marker, self._markers.length, self._camera)
            if solutions:
                candidates.setdefault(found.marker, []).append((_area(corners), solutions))
        poses = []
        for marker in sorted(candidates):
            choice = self._choices.setdefault(marker, PoseChoice())
            solutions = self._pick(candidates[marker], choice.previous(self._images))
            poses.append(choice.choose(solutions, self._images))
        return poses

    @staticmethod
    def _pick(candidates: List[Tuple[float, List[Solution]]], last: Optional[Pose]) -> List[Solution]:
        """Of several markers with one id: the one nearest to where it was, or the largest if that is not known."""
        if last is None:
            return max(candidates, key=lambda c: c[0])[1]
        at = np.array(last.translation)
        return min((c[1] for c in candidates),
                   key=lambda s: float(np.linalg.norm(np.array(s[0].pose.translation) - at)))
