"""Triangle meshes by formula: positions, unit normals, texture coordinates. Metres, +Y up."""

import math


class Shape:
    def __init__(self):
        self.positions, self.normals, self.uvs, self.indices = [], [], [], []

    def vertex(self, position, normal, uv):
        self.positions.append(position)
        self.normals.append(normal)
        self.uvs.append(uv)
        return len(self.positions) - 1

    @property
    def triangles(self):
        return len(self.indices) // 3


def quad(width, depth, center=(0.0, 0.0)):
    """A horizontal rectangle at y = 0, seen from above. 2 triangles."""
    shape = Shape()
    for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
        x, z = center[0] + (u - 0.5) * width, center[1] + (v - 0.5) * depth
        shape.vertex((x, 0.0, z), (0.0, 1.0, 0.0), (float(u), float(v)))
    shape.indices = [0, 3, 2, 0, 2, 1]
    return shape


def box():
    """The unit cube standing on y = 0, centred in x and z. 12 triangles, flat normals."""
    shape = Shape()
    for axis in range(3):
        for sign in (-1.0, 1.0):
            normal = [0.0, 0.0, 0.0]
            normal[axis] = sign
            # Tangents so that (s, t, normal) is right-handed.
            s_axis, t_axis = (axis + 1) % 3, (axis + 2) % 3
            if sign < 0:
                s_axis, t_axis = t_axis, s_axis
            corners = []
            for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
                p = [0.0, 0.0, 0.0]
                p[axis], p[s_axis], p[t_axis] = sign / 2, s - 0.5, t - 0.5
                p[1] += 0.5
                corners.append(shape.vertex(tuple(p), tuple(normal), (float(s), 1.0 - t)))
            a, b, c, d = corners
            shape.indices += [a, b, c, a, c, d]
    return shape


def sphere(segments, rings):
    """The unit sphere around the origin: 2 segments (rings - 1) triangles."""
    shape = Shape()
    for j in range(rings + 1):
        v = j / rings
        y, r = math.cos(math.pi * v), math.sin(math.pi * v)
        if j in (0, rings):
            y, r = round(y), 0.0
        for i in range(segments + 1):
            angle = 2 * math.pi * (i % segments) / segments  # the seam closes exactly
            p = (r * math.sin(angle), y, r * math.cos(angle))
            shape.vertex(p, p, (i / segments, v))
    row = segments + 1
    for j in range(rings):
        for i in range(segments):
            a, b = j * row + i, (j + 1) * row + i
            if j > 0:
                shape.indices += [a, b, a + 1]
            if j < rings - 1:
                shape.indices += [a + 1, b, b + 1]
    return shape


def torus(major, minor, segments, sides):
    """A ring lying on y = 0. 2 segments sides triangles."""
    shape = Shape()
    for i in range(segments + 1):
        a = 2 * math.pi * (i % segments) / segments
        for j in range(sides + 1):
            b = 2 * math.pi * (j % sides) / sides
            normal = (math.cos(b) * math.sin(a), math.sin(b), math.cos(b) * math.cos(a))
            r = major + minor * math.cos(b)
            shape.vertex((r * math.sin(a), minor + minor * math.sin(b), r * math.cos(a)), normal,
                         (i / segments, j / sides))
    row = sides + 1
    for i in range(segments):
        for j in range(sides):
            p, q = i * row + j, (i + 1) * row + j
            shape.indices += [p, q, q + 1, p, q + 1, p + 1]
    return shape


def cone(radius, height, segments):
    """A cone standing on y = 0 with its base. 2 segments triangles."""
    shape = Shape()
    slant = math.hypot(radius, height)
    for i in range(segments):
        a, b = (2 * math.pi * k / segments for k in (i, (i + 1) % segments))
        middle = 2 * math.pi * (i + 0.5) / segments

        def side(angle):
            out = height / slant
            return (out * math.sin(angle), radius / slant, out * math.cos(angle))

        p, q = ((radius * math.sin(t), 0.0, radius * math.cos(t)) for t in (a, b))
        down = (0.0, -1.0, 0.0)
        shape.indices += [
            shape.vertex(p, side(a), (i / segments, 1.0)),
            shape.vertex(q, side(b), ((i + 1) / segments, 1.0)),
            shape.vertex((0.0, height, 0.0), side(middle), ((i + 0.5) / segments, 0.0)),
            shape.vertex(q, down, (1.0, 1.0)),
            shape.vertex(p, down, (0.0, 1.0)),
            shape.vertex((0.0, 0.0, 0.0), down, (0.5, 0.5)),
        ]
    return shape


def lathe(profile, segments):
    """The outline turned about the y axis, closed if it begins and ends on the axis.

    profile: (radius, height) from the bottom around to where it ends, the inside on the left of the
    way; None between two points begins a new smooth stretch, so that there is an edge.
    """
    shape = Shape()
    stretch = []
    for point in [*profile, None]:
        if point is not None:
            stretch.append(point)
            continue
        _turn_stretch(shape, stretch, segments)
        stretch = stretch[-1:]
    return shape


def _turn_stretch(shape, points, segments):
    def outward(a, b):
        dr, dy = b[0] - a[0], b[1] - a[1]
        length = math.hypot(dr, dy)
        return dy / length, -dr / length

    row = segments + 1
    first = len(shape.positions)
    for j, (r, y) in enumerate(points):
        sides = ([outward(points[j - 1], points[j])] if j > 0 else []) + \
                ([outward(points[j], points[j + 1])] if j + 1 < len(points) else [])
        nr, ny = (sum(side[i] for side in sides) for i in (0, 1))
        length = math.hypot(nr, ny)
        for i in range(row):
            a = 2 * math.pi * (i % segments) / segments
            shape.vertex((r * math.sin(a), y, r * math.cos(a)),
                         (nr / length * math.sin(a), ny / length, nr / length * math.cos(a)),
                         (i / segments, j / (len(points) - 1)))
    for j in range(len(points) - 1):
        for i in range(segments):
            a, b = first + j * row + i, first + (j + 1) * row + i
            if points[j][0] > 0:
                shape.indices += [a, a + 1, b + 1]
            if points[j + 1][0] > 0:
                shape.indices += [a, b + 1, b]


def plate(width, height, depth, repeat):
    """A box standing on y = 0 whose front, towards +Z, shows a texture repeat times each way."""
    shape = box()
    shape.positions = [(x * width, y * height, z * depth) for x, y, z in shape.positions]
    shape.uvs = [(u * repeat, v * repeat) for u, v in shape.uvs]
    return shape
