"""The environment map: a light room with two windows and the sun through a third, scene-linear.

Latitude-longitude as the server reads it: image centre +Z (towards the viewer), left quarter +X,
right quarter -X, top row +Y.
"""

import math

from .images import equirectangular

# Where the sun stands: left of the viewer, a little to his side, so that shadows fall to the right
# and slightly to the back.
SUN_DIRECTION = (-0.72, 0.95, 0.30)
SUN_RADIUS_DEGREES = 4.0
SUN_RADIANCE = (480.0, 442.0, 384.0)  # about 7 over its disc: a little more than all the rest


def _normalize(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def _smooth(low, high, x):
    t = max(0.0, min(1.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def _mix(a, b, t):
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def _window(longitude, latitude, at, width, bottom, top):
    """1 inside a window of four panes, degrees."""
    x = (longitude - at + 180) % 360 - 180
    half = width / 2
    inside = (_smooth(-half - 1, -half + 1, x) * (1 - _smooth(half - 1, half + 1, x)) *
              _smooth(bottom - 1, bottom + 1, latitude) * (1 - _smooth(top - 1, top + 1, latitude)))
    bar = min(abs(x), abs(latitude - (bottom + top) / 2))
    return inside * _smooth(0.5, 1.5, bar)


def radiance(direction):
    """Radiance that arrives from a unit direction."""
    x, y, z = direction
    latitude = math.degrees(math.asin(max(-1.0, min(1.0, y))))
    longitude = math.degrees(math.atan2(x, z))

    floor = _mix((0.20, 0.17, 0.14), (0.30, 0.27, 0.24), _smooth(-90, -10, latitude))
    wall = _mix((0.36, 0.34, 0.31), (0.52, 0.51, 0.50), _smooth(-5, 40, latitude))
    ceiling = _mix((0.55, 0.56, 0.58), (0.80, 0.83, 0.88), _smooth(45, 90, latitude))
    color = _mix(floor, wall, _smooth(-8, -4, latitude))
    color = _mix(color, ceiling, _smooth(38, 44, latitude))
    # Slow change around the room: brighter on the side of the windows.
    around = 1.0 + 0.18 * math.cos(math.radians(longitude + 65))
    color = tuple(c * around for c in color)

    for at, width, bottom, top, light in ((-35.0, 26.0, 4.0, 34.0, (3.4, 3.8, 4.3)),
                                          (-110.0, 26.0, 4.0, 34.0, (3.0, 3.4, 4.0)),
                                          (120.0, 18.0, 6.0, 30.0, (1.6, 1.7, 1.8))):
        color = _mix(color, light, _window(longitude, latitude, at, width, bottom, top))
    return color


def room(width, height):
    """Rows of (r, g, b), the sun's disc with a soft rim."""
    sun = _normalize(SUN_DIRECTION)

    def pixel(d):
        angle = math.degrees(math.acos(max(-1.0, min(1.0, sum(a * b for a, b in zip(d, sun))))))
        disc = 1 - _smooth(SUN_RADIUS_DEGREES - 0.7, SUN_RADIUS_DEGREES + 0.7, angle)
        color = radiance(d)
        return tuple(c + disc * s for c, s in zip(color, SUN_RADIANCE))

    return equirectangular(width, height, pixel)
