"""PNG and OpenEXR files, written by hand so that their bytes depend on no library's version."""

import math
import struct
import zlib


def _stored_zlib(data):
    """A zlib stream of stored blocks."""
    out = bytearray(b"\x78\x01")
    for start in range(0, max(len(data), 1), 65535):
        block = data[start:start + 65535]
        last = start + 65535 >= len(data)
        out += struct.pack("<BHH", last, len(block), len(block) ^ 0xFFFF) + block
    return bytes(out + struct.pack(">I", zlib.adler32(data)))


def _write_png(path, width, color_type, lines, before_data=()):
    """lines: the bytes of each row."""

    def chunk(kind, data):
        check = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)

    header = struct.pack(">IIBBBBB", width, len(lines), 8, color_type, 0, 0, 0)
    pixels = b"".join(b"\0" + line for line in lines)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
                     b"".join(chunk(*one) for one in before_data) +
                     chunk(b"IDAT", _stored_zlib(pixels)) + chunk(b"IEND", b""))


def write_palette_png(path, rows, palette):
    """rows: lists of indices into palette, a list of up to 256 (r, g, b), each 0 .. 255."""
    colors = bytes(c for color in palette for c in color)
    _write_png(path, len(rows[0]), 3, [bytes(row) for row in rows], [(b"PLTE", colors)])


def write_rgb_png(path, rows):
    """rows: lists of (r, g, b), each 0 .. 255."""
    _write_png(path, len(rows[0]), 2, [bytes(c for pixel in row for c in pixel) for row in rows])


def write_half_exr(path, rows):
    """rows: lists of (r, g, b) radiances, top row first. Uncompressed scan lines of half floats."""
    width, height = len(rows[0]), len(rows)

    def attribute(name, kind, data):
        return name + b"\0" + kind + b"\0" + struct.pack("<I", len(data)) + data

    half = 1
    channels = b"".join(name + b"\0" + struct.pack("<IB3xII", half, 0, 1, 1)
                        for name in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = struct.pack("<II", 20000630, 2)
    header += attribute(b"channels", b"chlist", channels)
    header += attribute(b"compression", b"compression", b"\0")
    header += attribute(b"dataWindow", b"box2i", window)
    header += attribute(b"displayWindow", b"box2i", window)
    header += attribute(b"envmap", b"envmap", b"\0")  # latitude-longitude
    header += attribute(b"lineOrder", b"lineOrder", b"\0")
    header += attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1.0))
    header += attribute(b"screenWindowCenter", b"v2f", struct.pack("<ff", 0.0, 0.0))
    header += attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1.0))
    header += b"\0"

    line_bytes = 3 * 2 * width
    first = len(header) + 8 * height
    offsets = b"".join(struct.pack("<Q", first + y * (8 + line_bytes)) for y in range(height))
    lines = []
    for y, row in enumerate(rows):
        values = [pixel[channel] for channel in (2, 1, 0) for pixel in row]
        lines.append(struct.pack("<iI", y, line_bytes) + struct.pack(f"<{len(values)}e", *values))
    path.write_bytes(header + offsets + b"".join(lines))


def equirectangular(width, height, pixel):
    """Rows of pixel(direction): +Z in the middle, +X a quarter to the left, +Y at the top."""
    rows = []
    for j in range(height):
        colatitude = math.pi * (j + 0.5) / height
        row = []
        for i in range(width):
            longitude = (0.5 - (i + 0.5) / width) * 2 * math.pi
            row.append(pixel((math.sin(colatitude) * math.sin(longitude), math.cos(colatitude),
                              math.sin(colatitude) * math.cos(longitude))))
        rows.append(row)
    return rows
