"""The session for programs without asyncio: the same one, on an event loop in a thread of its own.

The thread answers the server's pings while the program does something else.
"""

from __future__ import annotations

import asyncio
import concurrent.futures
import threading
from types import TracebackType
from typing import Any, Callable, Coroutine, Iterable, Iterator, List, Optional, Sequence, Type, TypeVar, Union

from .address import Path
from .aio import AsyncSession, FrameCounts, StreamFrame
from .environment import Fisheye
from .errors import AmalgamError, FrameRejected
from .jpeg import Frame
from .values import Composite, Corners, Pose, Welcome

T = TypeVar("T")


class Session:
    """An open session; see AsyncSession for what its functions do. Of use to several threads at once."""

    def __init__(self, session: AsyncSession) -> None:
        self._session = session
        self._loop = asyncio.new_event_loop()
        self._lock = threading.Lock()
        self._ended = False  # nothing is given to the loop any more
        self._thread = threading.Thread(target=self._loop.run_forever, name="amalgam", daemon=True)
        self._thread.start()
        try:
            self._run(session.open())
        except BaseException:
            self._end_thread()
            raise

    def __enter__(self) -> Session:
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self.close()

    def close(self) -> None:
        """Says goodbye. A second time it does nothing. What other threads wait for raises SessionClosed."""
        if not self._ended:
            try:
                self._run(self._session.close())
            finally:
                self._end_thread()

    @property
    def welcome(self) -> Welcome:
        return self._session.welcome

    @property
    def counts(self) -> FrameCounts:
        return self._session.counts

    @property
    def warnings(self) -> List[AmalgamError]:
        return self._session.warnings

    @property
    def draining(self) -> bool:
        return self._session.draining

    def send(self, frame: Frame, poses: Optional[Sequence[Pose]] = None, *,
             corners: Optional[Sequence[Corners]] = None, capture_time: Optional[float] = None,
             timeout: Optional[float] = None) -> Composite:
        return self._run(self._session.send(frame, poses, corners=corners, capture_time=capture_time, timeout=timeout))

    def stream(self, frames: Iterable[StreamFrame], *, newest_wins: bool = True, in_flight: int = 2,
               on_rejected: Optional[Callable[[int, FrameRejected], None]] = None) -> Iterator[Composite]:
        """As AsyncSession.stream(). The source is asked for its frames in another thread."""
        composites = self._session.stream(frames, newest_wins=newest_wins, in_flight=in_flight,
                                          on_rejected=on_rejected)

        async def following() -> Optional[Composite]:
            return await anext(composites, None)

        async def end() -> None:
            await composites.aclose()  # type: ignore[attr-defined]

        try:
            while (composite := self._run(following())) is not None:
                yield composite
        finally:
            if not self._ended:
                self._run(end())

    def set_environment(self, image: Union[bytes, Path], *, fisheye: Optional[Fisheye] = None, own: bool = False,
                        wait: float = 0.5) -> None:
        self._run(self._session.set_environment(image, fisheye=fisheye, own=own, wait=wait))

    def _run(self, work: Coroutine[Any, Any, T]) -> T:
        with self._lock:
            if self._ended:
                work.close()
                self._session._core.check_open()  # raises what ended the session
            future = asyncio.run_coroutine_threadsafe(work, self._loop)
        try:
            return future.result()
        except concurrent.futures.CancelledError:  # by close(), in another thread
            self._session._core.check_open()
            raise
        except BaseException:
            future.cancel()
            raise

    def _end_thread(self) -> None:
        with self._lock:
            if self._ended:
                return
            self._ended = True
        # A loop that merely stops would leave whoever waits for its tasks waiting for ever.
        asyncio.run_coroutine_threadsafe(_cancel_all(), self._loop).result()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()


async def _cancel_all() -> None:
    others = asyncio.all_tasks() - {asyncio.current_task()}
    for task in others:
        task.cancel()
    await asyncio.gather(*others, return_exceptions=True)
    await asyncio.get_running_loop().shutdown_asyncgens()
