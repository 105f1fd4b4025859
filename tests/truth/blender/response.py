"""A camera's response: from radiance to 8-bit sRGB. Our own step, not Blender's view transforms."""

import struct
import zlib

import numpy


def _linear(radiance):
    return numpy.clip(radiance, 0.0, 1.0)


def _reinhard(radiance):
    radiance = numpy.maximum(radiance, 0.0)
    return radiance / (1.0 + radiance)


# What the camera's own exposure control makes of the median luminance, before the curve.
RESPONSES = {"linear": (_linear, 0.28), "reinhard": (_reinhard, 0.45)}


def exposure(camera, response):
    """Of the picture without virtual objects; that with them is taken with the same."""
    luminance = camera @ numpy.array([0.2126, 0.7152, 0.0722], dtype=numpy.float32)
    return RESPONSES[response][1] / float(numpy.median(luminance))


def develop(radiance, gain, response):
    display = RESPONSES[response][0](radiance * gain)
    encoded = numpy.where(display <= 0.0031308, 12.92 * display,
                          1.055 * numpy.power(numpy.maximum(display, 1e-9), 1 / 2.4) - 0.055)
    return numpy.rint(255.0 * encoded).astype(numpy.uint8)


def write_png(path, pixels):
    """8-bit RGB. Each row is stored as the difference to the one above: half the bytes."""
    height, width, _ = pixels.shape

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    above = numpy.vstack([numpy.zeros((1, width, 3), numpy.uint8), pixels[:-1]])
    rows = (pixels - above).reshape(height, -1)
    data = b"".join(b"\2" + row.tobytes() for row in rows)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" +
                     chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(data, 9)) + chunk(b"IEND", b""))
