"""Reads glTF models, .gltf and .glb, with the bytes of a GLB as a file of its own."""

import json
import struct


def read_model(path):
    """(document, bytes of the GLB's binary chunk or None). OSError or ValueError with one line."""
    data = path.read_bytes()
    if not data.startswith(b"glTF"):
        return parse(data), None
    if len(data) < 20:
        raise ValueError("ends inside its header")
    version, = struct.unpack_from("<I", data, 4)
    if version != 2:
        raise ValueError(f"is GLB version {version}; only 2 is known")
    chunks, at = {}, 12
    while at + 8 <= len(data):
        length, kind = struct.unpack_from("<I4s", data, at)
        if at + 8 + length > len(data):
            raise ValueError("ends inside a chunk")
        chunks.setdefault(kind, data[at + 8:at + 8 + length])
        at += 8 + length + -length % 4
    if b"JSON" not in chunks:
        raise ValueError("has no JSON")
    return parse(chunks[b"JSON"]), chunks.get(b"BIN\0")


def parse(data):
    try:
        document = json.loads(data.decode("utf-8-sig"))
    except UnicodeDecodeError:
        raise ValueError("is no glTF file: its text is not UTF-8") from None
    except json.JSONDecodeError as error:
        raise ValueError(f"is no glTF file: no JSON at line {error.lineno}") from None
    if not isinstance(document, dict) or "asset" not in document:
        raise ValueError("is no glTF file: it has no 'asset'")
    return document
