"""The two possible poses of a flat square marker, and the choice between them over frames.

With little perspective, a tilted square and its mirror image about the line of sight look the same. IPPE [Collins &
Bartoli 2014] gives both. The choice is the native client's (tracking/pose_disambiguation.h).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import List, Optional, Sequence

import numpy as np
import numpy.typing as npt

from .camera import Camera
from .jpeg import opencv
from .values import Pose

_CLEAR_RATIO = 2.0  # second error / first error
_OVERWHELMING_RATIO = 10.0  # switches at once
_FRAMES_TO_SWITCH = 3  # successive, clear but not overwhelming
_MAX_AGE = 30  # images: a second at 30 Hz
_NUDGE = 1e-3  # pixels, see solve_square()
_MAX_OFF_PIXEL = 1e-3  # pixels by which an undistorted corner, distorted again, may miss


@dataclass(frozen=True)
class Solution:
    pose: Pose
    error: float  # root mean square of the errors of the corners' coordinates, pixels without distortion


def _quaternion(m: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """x y z w of a rotation matrix: the largest component first, so that nothing is divided by almost 0."""
    squares = np.array([1 + m[0, 0] - m[1, 1] - m[2, 2], 1 - m[0, 0] + m[1, 1] - m[2, 2],
                        1 - m[0, 0] - m[1, 1] + m[2, 2], 1 + m[0, 0] + m[1, 1] + m[2, 2]])
    xy, xz, yz = m[1, 0] + m[0, 1], m[0, 2] + m[2, 0], m[2, 1] + m[1, 2]
    wx, wy, wz = m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]
    rows = np.array([[squares[0], xy, xz, wx], [xy, squares[1], yz, wy],
                     [xz, yz, squares[2], wz], [wx, wy, wz, squares[3]]])
    row = rows[int(np.argmax(squares))]
    return np.asarray(row / np.linalg.norm(row))


def _ideal_pixels(corners: npt.NDArray[np.float64], camera: Camera) -> Optional[npt.NDArray[np.float64]]:
    """Undistorted; None where the lens model cannot be inverted."""
    if not any(camera.distortion):
        return np.array(corners)
    cv2, k, d = opencv(), camera.matrix(), camera.coefficients()
    criteria = (cv2.TERM_CRITERIA_COUNT + cv2.TERM_CRITERIA_EPS, 100, 1e-10)
    flat = cv2.undistortPointsIter(corners.reshape(-1, 1, 2), k, d, None, None, criteria).reshape(-1, 2)
    if not np.isfinite(flat).all():
        return None
    directions = np.column_stack([flat, np.ones(len(flat))])
    again = cv2.projectPoints(directions, np.zeros(3), np.zeros(3), k, d)[0].reshape(-1, 2)
    if not np.abs(again - corners).max() <= _MAX_OFF_PIXEL:
        return None
    return np.asarray(flat * [camera.fx, camera.fy] + [camera.cx, camera.cy])


def _solve_ideal(corners: npt.NDArray[np.float64], marker: int, length: float, camera: Camera) -> List[Solution]:
    cv2, half = opencv(), 0.5 * length
    square = np.array([[-half, half, 0], [half, half, 0], [half, -half, 0], [-half, -half, 0]])
    try:
        _, rotations, translations, errors = cv2.solvePnPGeneric(
            square, corners.reshape(-1, 1, 2), camera.matrix(), None, flags=cv2.SOLVEPNP_IPPE_SQUARE)
    except cv2.error:
        return []  # corners that are no quadrilateral
    solutions = []
    for turn, shift, error in zip(rotations, translations, np.ravel(errors)):
        matrix, translation = cv2.Rodrigues(turn)[0], shift.ravel()
        # Longer vectors come from a division by almost 0, see solve_square().
        is_turn = np.linalg.norm(turn) <= math.pi + 1e-6
        sound = is_turn and np.isfinite(matrix).all() and math.isfinite(error) and translation[2] > 0
        # Paper is printed on one side.
        if sound and matrix[:, 2] @ translation < 0:
            x, y, z, w = map(float, _quaternion(matrix))
            tx, ty, tz = map(float, translation)
            solutions.append(Solution(Pose(marker, (x, y, z, w), (tx, ty, tz)), float(error)))
    return sorted(solutions, key=lambda s: s.error)


def solve_square(corners: npt.NDArray[np.float64], marker: int, length: float, camera: Camera) -> List[Solution]:
    """None, one or two solutions, the better one first. corners: as Corners.pixels; length in metres."""
    ideal = _ideal_pixels(np.asarray(corners, np.float64), camera)
    if ideal is None:
        return []
    solutions = _solve_ideal(ideal, marker, length, camera)
    if len(solutions) < 2:
        # A marker that faces the camera exactly is a turn by pi, where OpenCV divides by (almost) 0: the right
        # solution is missing, or both are. A nudge far below what a corner is known to gets it out of there.
        ideal[0, 0] += _NUDGE
        nudged = _solve_ideal(ideal, marker, length, camera)
        solutions = nudged if len(nudged) > len(solutions) else solutions
    return solutions


def angle_between(a: Pose, b: Pose) -> float:
    """Radians, 0 to pi."""
    (ax, ay, az, aw), (bx, by, bz, bw) = a.rotation, b.rotation
    cosine = ax * bx + ay * by + az * bz + aw * bw
    sine = math.hypot(aw * bx - ax * bw - ay * bz + az * by, aw * by - ay * bw - az * bx + ax * bz,
                      aw * bz - az * bw - ax * by + ay * bx)
    return 2 * math.atan2(sine, abs(cosine))


class PoseChoice:
    """Serves one marker.

    Without a previous pose it takes the solution with the smaller error. With one it takes the solution nearest to
    it, unless the other is clearly better: less than half its error in several successive frames, or less than a
    tenth in one.
    """

    def __init__(self) -> None:
        self._previous: Optional[Pose] = None
        self._previous_image = 0
        self._against = 0

    def previous(self, image: int) -> Optional[Pose]:
        return self._previous if image - self._previous_image <= _MAX_AGE else None

    def choose(self, solutions: Sequence[Solution], image: int) -> Pose:
        """solutions: at least one, the better one first. image counts images, not detections."""
        chosen, last = solutions[0], self.previous(image)
        if last is None or len(solutions) < 2:
            self._against = 0  # a frame without the choice does not contradict either
        else:
            first, second = solutions[0], solutions[1]
            nearer = angle_between(last, first.pose) <= angle_between(last, second.pose)
            clear = second.error > _CLEAR_RATIO * first.error
            overwhelming = second.error > _OVERWHELMING_RATIO * first.error
            self._against = self._against + 1 if not nearer and clear else 0
            if not nearer and not overwhelming and self._against < _FRAMES_TO_SWITCH:
                chosen = second
        if chosen is solutions[0] and self._against >= _FRAMES_TO_SWITCH:
            self._against = 0
        self._previous, self._previous_image = chosen.pose, image
        return chosen.pose
