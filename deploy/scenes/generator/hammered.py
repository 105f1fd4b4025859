"""The normal texture of hammered metal: round dents, side by side, that repeat."""

import math

# Centres and radii in parts of the texture's side, found by hand: they cover it without a pattern
# that the eye finds at once.
DENTS = ((0.14, 0.17, 0.21), (0.47, 0.09, 0.19), (0.80, 0.21, 0.22), (0.30, 0.44, 0.20),
         (0.63, 0.46, 0.21), (0.95, 0.55, 0.18), (0.10, 0.73, 0.21), (0.44, 0.77, 0.20),
         (0.76, 0.80, 0.20))
DEPTH = 0.11  # of a dent, in parts of its radius


def _slope(u, v):
    """The deepest dent's slope at a point, along u and v."""
    deepest, slope = 0.0, (0.0, 0.0)
    for x, y, radius in DENTS:
        du, dv = (u - x + 0.5) % 1 - 0.5, (v - y + 0.5) % 1 - 0.5
        q = 1 - (du * du + dv * dv) / (radius * radius)
        if q > 0 and DEPTH * radius * q * q > deepest:
            deepest = DEPTH * radius * q * q
            factor = 4 * DEPTH * q / radius  # of height = -depth radius (1 - r^2)^2
            slope = (factor * du, factor * dv)
    return slope


def hammered(size):
    """Rows of (r, g, b) as glTF wants them: x along +u, y against +v, z out of the surface."""
    rows = []
    for j in range(size):
        row = []
        for i in range(size):
            du, dv = _slope((i + 0.5) / size, (j + 0.5) / size)
            normal = (-du, dv, 1.0)
            length = math.sqrt(sum(c * c for c in normal))
            row.append(tuple(round((c / length * 0.5 + 0.5) * 255) for c in normal))
        rows.append(row)
    return rows
