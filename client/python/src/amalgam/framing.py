"""Bytes to messages and back: a 4-byte little-endian length, then an Envelope with exactly one body.

A message's size is checked by its length and its first byte, before its other bytes are kept.
"""

from __future__ import annotations

from typing import Iterator, Tuple

from google.protobuf.message import DecodeError

from . import limits
from .amalgam_pb2 import Envelope
from .errors import ProtocolViolation

_BODIES = {field.number: field.name for field in Envelope.DESCRIPTOR.fields}
_LENGTH_DELIMITED = 2


def encode(envelope: Envelope) -> bytes:
    body: bytes = envelope.SerializeToString()
    return len(body).to_bytes(limits.LENGTH_BYTES, "little") + body


def _varint(data: memoryview, at: int) -> Tuple[int, int]:
    """The number at a position, and the position behind it."""
    value = 0
    for shift in range(0, 64, 7):
        if at >= len(data):
            break
        byte = data[at]
        at += 1
        value |= (byte & 0x7F) << shift
        if byte < 0x80:
            return value, at
    raise ProtocolViolation("the server sent a message that is cut off")


def count_bodies(data: memoryview) -> int:
    """How many of an Envelope's known fields follow each other. Parsers would keep the last one silently."""
    at, bodies = 0, 0
    while at < len(data):
        tag, at = _varint(data, at)
        field, kind = tag >> 3, tag & 7
        bodies += field in _BODIES
        if kind == 0:
            _, at = _varint(data, at)
        elif kind == _LENGTH_DELIMITED:
            size, at = _varint(data, at)
            at += size
        elif kind in (1, 5):
            at += 8 if kind == 1 else 4
        else:
            raise ProtocolViolation("the server sent bytes that are no Envelope")
    if at != len(data):
        raise ProtocolViolation("the server sent a message that is cut off")
    return bodies


class Decoder:
    """Takes bytes as they come and yields whole messages. After it has raised it is of no more use."""

    def __init__(self) -> None:
        self._buffer = bytearray()

    @property
    def buffered(self) -> int:
        return len(self._buffer)

    def feed(self, data: bytes) -> Iterator[Envelope]:
        self._buffer += data
        while len(self._buffer) > limits.LENGTH_BYTES:
            size = int.from_bytes(self._buffer[: limits.LENGTH_BYTES], "little")
            self._check_size(size, self._buffer[limits.LENGTH_BYTES])
            end = limits.LENGTH_BYTES + size
            if len(self._buffer) < end:
                return
            message = bytes(self._buffer[limits.LENGTH_BYTES : end])
            del self._buffer[:end]
            yield self._parse(message)
        if len(self._buffer) == limits.LENGTH_BYTES and not any(self._buffer):
            raise ProtocolViolation("the server sent a message of no bytes")

    @staticmethod
    def _check_size(size: int, first: int) -> None:
        body = _BODIES.get(first >> 3)
        if size == 0 or body is None or first & 7 != _LENGTH_DELIMITED:
            raise ProtocolViolation("the server sent a message of an unknown kind")
        limit = limits.MAX_COMPOSITE_BYTES if body == "composite" else limits.MAX_CONTROL_BYTES
        if size > limit:
            raise ProtocolViolation(f"the server sent a {body} of {size} bytes; at most {limit} are allowed")

    @staticmethod
    def _parse(message: bytes) -> Envelope:
        if count_bodies(memoryview(message)) != 1:
            raise ProtocolViolation("the server sent a message with two bodies")
        envelope = Envelope()
        try:
            # Some versions stop at a stray end of a group, with a warning and not an error.
            whole = envelope.MergeFromString(message) == len(message)
        except DecodeError:
            whole = False
        if not whole:
            raise ProtocolViolation("the server sent bytes that are no Envelope")
        return envelope
