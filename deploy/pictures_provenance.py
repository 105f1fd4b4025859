#!/usr/bin/env python3
"""Paints provenance.exr (amalgam-render --dump): where each pixel's light comes from, by colour.

    pictures_provenance.py PROVENANCE.exr PICTURE.ppm
    pictures_provenance.py --legend       prints "#rrggbb what it is", a line a source

Each pixel is the mean of the sources' colours by their shares. Reads what our own writer writes:
32-bit float channels, ZIP compression, rows from the top.
"""

import struct
import sys
import zlib

SOURCES = {
    "raster": ((235, 235, 235), "drawn by the rasteriser"),
    "camera_lookup": ((60, 160, 75), "camera image, looked up"),
    "traced_virtual": ((240, 140, 40), "virtual surface, traced"),
    "modelled_real": ((210, 50, 60), "real surface, as modelled"),
    "environment": ((60, 120, 215), "environment"),
    "cut_off": ((230, 80, 220), "environment, ray cut off"),
}
ROWS_IN_A_BLOCK = 16


def attributes(data):
    """({name: value}, where they end)."""
    found, at = {}, 8

    def word(at):
        end = data.index(0, at)
        return data[at:end].decode(), end + 1

    while data[at]:
        name, at = word(at)
        _, at = word(at)
        size = struct.unpack_from("<I", data, at)[0]
        found[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    return found, at + 1


def channel_names(value):
    names, at = [], 0
    while value[at]:
        end = value.index(0, at)
        names.append(value[at:end].decode())
        if struct.unpack_from("<I", value, end + 1)[0] != 2:
            raise ValueError("a channel is not of 32-bit floats")
        at = end + 17
    return names


def unpacked(block, size):
    """OpenEXR's ZIP: differences of bytes, the even ones before the odd ones."""
    if len(block) == size:
        return block
    coded = bytearray(zlib.decompress(block))
    for i in range(1, len(coded)):
        coded[i] = (coded[i - 1] + coded[i] - 128) & 255
    plain = bytearray(len(coded))
    half = (len(coded) + 1) // 2
    plain[0::2], plain[1::2] = coded[:half], coded[half:]
    return plain


def rows_of(data):
    """For each row, from the top: {channel: floats}."""
    header, at = attributes(data)
    if header["compression"] != b"\x03":
        raise ValueError("not ZIP compressed")
    names = channel_names(header["channels"])
    left, top, right, bottom = struct.unpack("<4i", header["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    for block in range(-(-height // ROWS_IN_A_BLOCK)):
        start = struct.unpack_from("<Q", data, at + 8 * block)[0]
        size = struct.unpack_from("<I", data, start + 4)[0]
        count = min(ROWS_IN_A_BLOCK, height - block * ROWS_IN_A_BLOCK)
        plain = unpacked(data[start + 8:start + 8 + size], 4 * width * len(names) * count)
        for row in range(count):
            first = 4 * width * len(names) * row
            yield {name: struct.unpack_from(f"<{width}f", plain, first + 4 * width * i)
                   for i, name in enumerate(names)}


def painted(row):
    pixels = bytearray()
    for x in range(len(next(iter(row.values())))):
        shares = {name: row[name][x] for name in SOURCES}
        total = sum(shares.values())
        for channel in range(3):
            color = sum(share * SOURCES[name][0][channel] for name, share in shares.items())
            pixels.append(round(color / total) if total > 0 else 0)
    return pixels


def main():
    if sys.argv[1:] == ["--legend"]:
        for color, text in SOURCES.values():
            print("#%02x%02x%02x" % color, text)
        return
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    with open(sys.argv[1], "rb") as file:
        rows = [painted(row) for row in rows_of(file.read())]
    with open(sys.argv[2], "wb") as file:
        file.write(f"P6 {len(rows[0]) // 3} {len(rows)} 255\n".encode() + b"".join(rows))


if __name__ == "__main__":
    main()
