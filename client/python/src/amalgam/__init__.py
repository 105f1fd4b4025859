"""Client of the Amalgam mixed-reality rendering server.

    with amalgam.connect("host:7447", camera=amalgam.Camera.from_fov(640, 480)) as session:
        composite = session.send("frame.jpg")
        cv2.imshow("composite", composite.image)
"""

from typing import Callable, ParamSpec

from .aio import AsyncSession, FrameCounts
from .camera import Camera
from .environment import Fisheye
from .errors import (AmalgamError, AuthFailed, AuthTimeout, BadHello, BadImage, Busy, ConnectFailed, Draining,
                     EnvironmentRejected, FrameRejected, FrameSkipped, FrameTimeout, IdleTimeout, LimitError,
                     PoseRejected, ProtocolError, ProtocolViolation, ServerFailure, SessionClosed, SlowReader,
                     SlowSender, TooManyPoses, UnexpectedMessage, UnknownMessage, Unsupported, UnsupportedVersion)
from .markers import MarkerTracker
from .session import Session
from .values import Composite, Corners, Markers, OneEuro, Pass, Pose, Welcome

_P = ParamSpec("_P")


def _opened(make: Callable[_P, AsyncSession]) -> Callable[_P, Session]:
    def connect(*args: _P.args, **options: _P.kwargs) -> Session:
        return Session(make(*args, **options))

    connect.__doc__ = AsyncSession.__doc__
    return connect


# async with connect_async(server, camera=...) as session
connect_async = AsyncSession
# with connect(server, camera=...) as session; the same options
connect = _opened(AsyncSession)

__all__ = [
    "AmalgamError", "AsyncSession", "AuthFailed", "AuthTimeout", "BadHello", "BadImage", "Busy", "Camera", "Composite",
    "ConnectFailed", "Corners", "Draining", "EnvironmentRejected", "Fisheye", "FrameCounts", "FrameRejected",
    "FrameSkipped", "FrameTimeout", "IdleTimeout", "LimitError", "MarkerTracker", "Markers", "OneEuro", "Pass", "Pose",
    "PoseRejected", "ProtocolError", "ProtocolViolation", "ServerFailure", "Session", "SessionClosed", "SlowReader",
    "SlowSender", "TooManyPoses", "UnexpectedMessage", "UnknownMessage", "Unsupported", "UnsupportedVersion",
    "Welcome", "connect", "connect_async",
]
