"""Moves a found marker's corners to the intersections of its edges, to a few hundredths of a pixel.

The same as the native client (client/tracking/edge_refinement.h): OpenCV's own refinement ends about an eighth of a pixel
inside, because blur rounds corners off. Here each edge is measured along its length and fitted by a line.
"""

from __future__ import annotations

from typing import List, Optional, Tuple

import numpy as np
import numpy.typing as npt

Points = npt.NDArray[np.float64]
Line = Tuple[Points, Points]  # a point and a direction

_ITERATIONS = 3  # the first guess is off by up to a pixel
_MAX_REACH = 4.0  # pixels to either side of an edge; further is no edge's blur
_STEP = 0.5  # pixels between samples across an edge
_MIN_CONTRAST = 15.0  # grey levels across an edge, of 255
_MIN_POINTS = 4
_MAX_RESIDUAL = 0.5  # pixels; dirt and printing errors are further off


def _grey_at(grey: npt.NDArray[np.uint8], points: Points) -> Points:
    """Bilinear; NaN outside."""
    height, width = grey.shape
    x, y = points[..., 0], points[..., 1]
    inside = (x >= 0) & (y >= 0) & (x < width - 1) & (y < height - 1)
    column, row = np.where(inside, x, 0).astype(int), np.where(inside, y, 0).astype(int)
    fx, fy = x - column, y - row
    upper = grey[row, column] * (1 - fx) + grey[row, column + 1] * fx
    lower = grey[row + 1, column] * (1 - fx) + grey[row + 1, column + 1] * fx
    return np.asarray(np.where(inside, upper * (1 - fy) + lower * fy, np.nan))


def _fit(along: Points, outward: Points) -> Optional[Tuple[float, float]]:
    """outward = offset + slope * along, by least squares."""
    if len(along) < _MIN_POINTS or np.ptp(along) < 1e-6:
        return None
    slope, offset = np.polyfit(along, outward, 1)
    return float(offset), float(slope)


def _measure_edge(grey: npt.NDArray[np.uint8], start: Points, end: Points, reach: float) -> Optional[Line]:
    length = float(np.linalg.norm(end - start))
    if length <= 2 * reach:
        return None
    direction = (end - start) / length
    outside = np.array([direction[1], -direction[0]])  # corners go clockwise on the screen
    # Not near the ends, where the neighbouring edge's blur bends this one's.
    along = np.arange(reach, length - reach, 1.0)
    across = np.arange(-reach, reach + 1e-9, _STEP)
    samples = _grey_at(grey, start + along[:, None, None] * direction + across[None, :, None] * outside)
    increase = np.maximum(np.diff(samples, axis=1), 0)
    total = increase.sum(axis=1)
    good = total >= _MIN_CONTRAST  # False where a sample was outside
    # The centre of mass of the brightness's increase.
    middles = across[1:] - _STEP / 2
    along, outward = along[good], (increase[good] @ middles) / total[good]
    line = _fit(along, outward)
    if line is None:
        return None
    near = np.abs(outward - line[0] - line[1] * along) <= _MAX_RESIDUAL
    line = _fit(along[near], outward[near])
    return None if line is None else (start + line[0] * outside, direction + line[1] * outside)


def _intersection(a: Line, b: Line) -> Optional[Points]:
    cross = a[1][0] * b[1][1] - a[1][1] * b[1][0]
    if abs(cross) < 1e-3:
        return None
    between = b[0] - a[0]
    return np.asarray(a[0] + (between[0] * b[1][1] - between[1] * b[1][0]) / cross * a[1])


def refine_corners(grey: npt.NDArray[np.uint8], bits: int, corners: Points) -> Points:
    """bits: of the marker's pattern along a side, without its border. Corners that cannot be improved stay."""
    refined = np.array(corners, np.float64)
    for _ in range(_ITERATIONS):
        sides = [float(np.linalg.norm(refined[(i + 1) % 4] - refined[i])) for i in range(4)]
        # The bit across an edge is foreshortened as its neighbouring sides are.
        bit = [min(sides[i - 1], sides[(i + 1) % 4]) / (bits + 2) for i in range(4)]
        edges: List[Optional[Line]] = []
        for i in range(4):
            reach = float(np.clip(0.6 * bit[i], 1.0, _MAX_REACH))
            edges.append(_measure_edge(grey, refined[i], refined[(i + 1) % 4], reach))
        for i in range(4):
            before, after = edges[i - 1], edges[i]
            if before is None or after is None:
                continue
            corner = _intersection(before, after)
            furthest = max(1.5, max(bit[i], bit[i - 1]) / 2)
            if corner is not None and np.linalg.norm(corner - corners[i]) <= furthest:
                refined[i] = corner
    return refined
