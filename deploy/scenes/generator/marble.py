"""A procedural marble as a palette picture: veins of turbulence by integer-hashed value noise."""


def _hash(x, y):
    h = (x * 374761393 + y * 668265263) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((h ^ (h >> 16)) & 0xFFFF) / 65535.0


def _noise(x, y, period):
    """Value noise that repeats after period cells, so that the texture tiles."""
    x0, y0 = int(x), int(y)
    fx, fy = x - x0, y - y0
    fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
    corner = [[_hash((x0 + i) % period + 57 * period, (y0 + j) % period) for i in (0, 1)]
              for j in (0, 1)]
    top = corner[0][0] + (corner[0][1] - corner[0][0]) * fx
    bottom = corner[1][0] + (corner[1][1] - corner[1][0]) * fx
    return top + (bottom - top) * fy


def marble(size, levels=64):
    """Returns (rows of palette indices, palette of sRGB bytes)."""
    palette = []
    for i in range(levels):
        t = i / (levels - 1)  # 0: in a vein, 1: clear stone
        palette.append(tuple(round(a + (b - a) * t) for a, b in ((96, 236), (92, 231), (104, 222))))
    rows = []
    for j in range(size):
        row = []
        for i in range(size):
            u, v = i / size, j / size
            turbulence, amplitude, cells = 0.0, 0.5, 4
            for _ in range(5):
                turbulence += amplitude * abs(2 * _noise(u * cells, v * cells, cells) - 1)
                amplitude, cells = amplitude / 2, cells * 2
            phase = (2 * u + v + 1.6 * turbulence) * 2
            ridge = abs(2 * (phase - int(phase)) - 1)  # 0 along the veins
            value = min(1.0, (ridge * 1.6) ** 0.7) * (0.82 + 0.18 * (1 - turbulence))
            row.append(max(0, min(levels - 1, int(value * levels))))
        rows.append(row)
    return rows, palette
