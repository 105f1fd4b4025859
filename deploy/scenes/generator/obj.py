"""Reads the geometry of a Wavefront OBJ: positions, normals, faces of any number of corners."""

import math

from .shapes import Shape


def read_obj(path, height):
    """A Shape of the given height on y = 0, centred in x and z. ValueError if there is none."""
    positions, normals, faces = [], [], []
    with open(path, encoding="utf-8", errors="replace") as file:
        for number, line in enumerate(file, 1):
            words = line.split()
            try:
                if words[:1] == ["v"]:
                    positions.append(tuple(float(x) for x in words[1:4]))
                elif words[:1] == ["vn"]:
                    normals.append(tuple(float(x) for x in words[1:4]))
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
        for k in range(1, len(face) - 1):
            corners = face[0][0], face[k][0], face[k + 1][0]
            a, b, c = (positions[i] for i in corners)
            e, f = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
            area = (e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0])
            for corner in corners:
                for i in range(3):
                    sums[corner][i] += area[i]
    return [_normalized(s) for s in sums]


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
        for k in range(1, len(corners) - 1):
            shape.indices += [corners[0], corners[k], corners[k + 1]]
    return shape
