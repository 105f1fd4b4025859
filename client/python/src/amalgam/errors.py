"""What can go wrong, as exceptions.

AmalgamError
  LimitError           checked before sending; nothing was sent
  ConnectFailed        no session: unreachable, not in time, or a certificate that is not trusted
  Busy                 no session now; try again after retry_after seconds
  FrameRejected        no composite for this frame; the session goes on
  FrameSkipped         a newer frame of this session replaced it
  FrameTimeout         no answer in time; the session goes on
  EnvironmentRejected  the light stays as it was; the session goes on
  SessionClosed        the session is over
    Draining           because the server is about to end
    ProtocolViolation  because the server sent what no server sends
    (and one for each error code that closes)
"""

from __future__ import annotations

from typing import Dict, Type


class AmalgamError(Exception):
    """Anything that this package raises of its own."""


class LimitError(AmalgamError, ValueError):
    """A value that the protocol does not allow."""


class ConnectFailed(AmalgamError, ConnectionError):
    """There is no session with the server."""


class Busy(AmalgamError):
    """The server cannot take this session now."""

    def __init__(self, reason: str, retry_after: float):
        super().__init__(f"the server is busy: {reason} (retry after {retry_after:g} s)")
        self.reason = reason
        self.retry_after = retry_after


class FrameRejected(AmalgamError):
    """There is no composite for a frame."""

    def __init__(self, text: str, frame_id: int = 0):
        super().__init__(text)
        self.frame_id = frame_id


class BadImage(FrameRejected):
    """The JPEG cannot be used."""


class TooManyPoses(FrameRejected):
    """More poses than a frame may have."""


class PoseRejected(FrameRejected):
    """A pose was unusable. Never raised: the frame is rendered, and Composite.warnings has this."""


class Unsupported(FrameRejected):
    """The server does not implement a message."""


class FrameSkipped(AmalgamError):
    """A newer frame replaced this one before it was rendered, or its composite before it was sent."""

    def __init__(self, frame_id: int):
        super().__init__(f"frame {frame_id} was replaced by a newer one")
        self.frame_id = frame_id


class FrameTimeout(AmalgamError, TimeoutError):
    """A frame was not answered in time."""


class EnvironmentRejected(AmalgamError):
    """An environment cannot be used, or may not be set now or by this client."""


class SessionClosed(AmalgamError):
    """The session is over; nothing more can be sent."""


class Draining(SessionClosed):
    """The server is about to end: go elsewhere, or reconnect after `deadline` seconds."""

    def __init__(self, deadline: float):
        super().__init__(f"the server is about to end, within {deadline:g} s")
        self.deadline = deadline


class ProtocolViolation(SessionClosed):
    """The server sent no valid message."""


class ProtocolError(SessionClosed):
    """The server found that this client sent no valid message."""


class UnsupportedVersion(SessionClosed):
    """The server speaks another version."""


class UnknownMessage(SessionClosed):
    """The server does not know a message."""


class UnexpectedMessage(SessionClosed):
    """A message at the wrong time."""


class AuthFailed(SessionClosed):
    """The token is wrong or missing."""


class AuthTimeout(SessionClosed):
    """The server got no complete Hello in time."""


class SlowSender(SessionClosed):
    """A message reached the server too slowly."""


class SlowReader(SessionClosed):
    """Composites were not taken."""


class IdleTimeout(SessionClosed):
    """One side has heard nothing of the other for too long."""


class BadHello(SessionClosed):
    """A camera, size or quality that the server cannot render with."""


class ServerFailure(SessionClosed):
    """The server's fault."""


# By Error.Code's names, those that close the session.
CLOSING: Dict[str, Type[SessionClosed]] = {
    "PROTOCOL_ERROR": ProtocolError,
    "UNSUPPORTED_VERSION": UnsupportedVersion,
    "UNKNOWN_MESSAGE": UnknownMessage,
    "UNEXPECTED_MESSAGE": UnexpectedMessage,
    "AUTH_FAILED": AuthFailed,
    "AUTH_TIMEOUT": AuthTimeout,
    "SLOW_SENDER": SlowSender,
    "SLOW_READER": SlowReader,
    "IDLE_TIMEOUT": IdleTimeout,
    "BAD_HELLO": BadHello,
    "INTERNAL": ServerFailure,
}

# Those of a frame, which the session survives.
REJECTING: Dict[str, Type[FrameRejected]] = {
    "POSE_REJECTED": PoseRejected,
    "BAD_IMAGE": BadImage,
    "TOO_MANY_POSES": TooManyPoses,
    "UNSUPPORTED": Unsupported,
}
