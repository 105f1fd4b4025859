"""Reads the geometry of a Wavefront OBJ: positions, normals, faces of any number of corners."""

import math

from .shapes import Shape


def read_obj(path, height):
    """A Shape of the given height on y = 0, centred in x and z. ValueError if there is none."""
    positions, normals, faces = [], [], []
    with open(path, encoding="utf-8", errors="replace") as file:
        for number, line in _whole_lines(file):
            words = line.split()
            try:
                if words[:1] == ["v"]:
                    positions.append(_finite(words[1:4]))
                elif words[:1] == ["vn"]:
                    normals.append(_finite(words[1:4]))
                elif words[:1] == ["f"]:
                    counts = len(positions), len(normals)
                    faces.append([_corner(word, *counts) for word in words[1:]])
            except (ValueError, IndexError) as error:
                raise ValueError(f"line {number} is not understood: {error}") from None
    if not positions or not faces:
        raise ValueError("no faces")
    if any(len(p) != 3 for p in positions):
        raise ValueError("a vertex has fewer than 3 coordinates")
    positions = _placed(positions, height)
    if not normals or any(corner[1] is None for face in faces for corner in face):
        normals = _smooth_normals(positions, faces)
        faces = [[(p, p) for p, _ in face] for face in faces]
    return _indexed(positions, normals, faces)


def _whole_lines(file):
    """Lines with their numbers; a backslash at the end continues a line on the next one."""
    begun, first = "", 0
    for number, line in enumerate(file, 1):
        first = first if begun else number
        begun += line.rstrip("\r\n")
        if begun.endswith("\\"):
            begun = begun[:-1] + " "
            continue
        yield first, begun
        begun = ""
    if begun:
        yield first, begun


def _finite(words):
    numbers = tuple(float(x) for x in words)
    if not all(math.isfinite(x) for x in numbers):
        raise ValueError("a number is not finite")
    return numbers


def _corner(word, positions, normals):
    """(position, normal or None) of "7", "7/1", "7//3", "7/1/3"; negative: from the end."""
    parts = word.split("/")

    def resolve(text, count):
        index = int(text)
        index = index - 1 if index > 0 else count + index
        if not 0 <= index < count:
            raise IndexError(f"there is no element {text}")
        return index

    has_normal = len(parts) > 2 and parts[2]
    return resolve(parts[0], positions), resolve(parts[2], normals) if has_normal else None


def _placed(positions, height):
    low = [min(p[i] for p in positions) for i in range(3)]
    high = [max(p[i] for p in positions) for i in range(3)]
    if not high[1] > low[1]:
        raise ValueError("the model has no height")
    scale = height / (high[1] - low[1])
    origin = ((low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2)
    return [tuple((c - o) * scale for c, o in zip(p, origin)) for p in positions]


def _normalized(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v) if length > 0 else (0.0, 1.0, 0.0)


def _smooth_normals(positions, faces):
    """Area-weighted means of the faces around each position."""
    sums = [[0.0, 0.0, 0.0] for _ in positions]
    for face in faces:
        for triangle in _triangles([positions[p] for p, _ in face]):
            corners = [face[k][0] for k in triangle]
            a, b, c = (positions[i] for i in corners)
            e, f = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
            area = (e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0])
            for corner in corners:
                for i in range(3):
                    sums[corner][i] += area[i]
    return [_normalized(s) for s in sums]


def _triangles(points):
    """Triples of indices that fill a polygon, concave ones too: its ears are cut off one by one
    (Meisters 1975), in the plane of the largest part of its area."""
    count = len(points)
    if count <= 3:
        return [(0, 1, 2)] if count == 3 else []
    area = [sum(points[i - 1][(a + 1) % 3] * points[i][(a + 2) % 3]
                - points[i - 1][(a + 2) % 3] * points[i][(a + 1) % 3] for i in range(count))
            for a in range(3)]
    axis = max(range(3), key=lambda a: abs(area[a]))
    sign = 1 if area[axis] >= 0 else -1
    flat = [(p[(axis + 1) % 3], sign * p[(axis + 2) % 3]) for p in points]

    def cross(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    def is_ear(left, k):
        i, j, n = (left[(k + d) % len(left)] for d in (-1, 0, 1))
        a, b, c = flat[i], flat[j], flat[n]
        if cross(a, b, c) <= 0:
            return False
        return not any(min(cross(a, b, flat[m]), cross(b, c, flat[m]), cross(c, a, flat[m])) >= 0
                       for m in left if flat[m] not in (a, b, c))

    left, triangles = list(range(count)), []
    while len(left) > 3:
        ear = next((k for k in range(1, len(left)) if is_ear(left, k)),
                   0 if is_ear(left, 0) else 1)  # without an ear it crosses itself: any will do
        triangles.append((left[ear - 1], left[ear], left[(ear + 1) % len(left)]))
        del left[ear]
    return triangles + [tuple(left)]


def _indexed(positions, normals, faces):
    shape = Shape()
    seen = {}

    def vertex(corner):
        if corner not in seen:
            shape.positions.append(positions[corner[0]])
            shape.normals.append(_normalized(normals[corner[1]]))
            seen[corner] = len(shape.positions) - 1
        return seen[corner]

    for face in faces:
        corners = [vertex(corner) for corner in face]
        for triangle in _triangles([positions[p] for p, _ in face]):
            shape.indices += [corners[k] for k in triangle]
    return shape
