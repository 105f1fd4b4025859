"""The two environments that the truth test adds: a clear and an overcast sky, by formula.

Latitude-longitude as the server reads it: image centre +Z, left quarter +X, top row +Y.
    python3 environments.py FOLDER
"""

import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "deploy/scenes"))

from generator.images import equirectangular, write_half_exr  # noqa: E402

WIDTH, HEIGHT = 128, 64
GROUND = (0.24, 0.21, 0.17)
SUN_DIRECTION = (0.55, 0.75, 0.36)  # from the right, so that its shadows differ from the room's
# Larger than the real one, at the same irradiance: a path tracer finds it through glass by chance.
SUN_RADIUS_DEGREES = 5.0
SUN_RADIANCE = (330.0, 305.0, 265.0)


def _mix(a, b, t):
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def _sunny(direction):
    height = direction[1]
    if height < 0:
        return GROUND
    sky = _mix((0.85, 0.90, 0.98), (0.22, 0.42, 0.88), math.sqrt(height))
    length = math.sqrt(sum(c * c for c in SUN_DIRECTION))
    cosine = sum(a * b for a, b in zip(direction, SUN_DIRECTION)) / length
    angle = math.degrees(math.acos(max(-1.0, min(1.0, cosine))))
    # The rim is as wide as a texel.
    disc = max(0.0, min(1.0, (SUN_RADIUS_DEGREES + 1.4 - angle) / 2.8))
    return tuple(c + disc * s for c, s in zip(sky, SUN_RADIANCE))


def _overcast(direction):
    """CIE's overcast sky: three times as bright at the zenith as at the horizon."""
    if direction[1] < 0:
        return GROUND
    return tuple(c * (1 + 2 * direction[1]) / 3 for c in (1.00, 1.03, 1.08))


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    write_half_exr(folder / "sunny.exr", equirectangular(WIDTH, HEIGHT, _sunny))
    write_half_exr(folder / "overcast.exr", equirectangular(WIDTH, HEIGHT, _overcast))
