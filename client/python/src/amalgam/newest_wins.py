"""Sends the frames of a source one after the other, and drops those that are too old to be sent."""

from __future__ import annotations

import asyncio
import time
from collections import deque
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, AsyncIterable, AsyncIterator, Callable, Deque, Iterable, List, Optional, Tuple
from typing import Union

from .errors import FrameRejected, FrameSkipped
from .values import Composite

if TYPE_CHECKING:
    from .aio import AsyncSession, FrameCounts, StreamFrame

_END = object()


@dataclass
class _Captured:
    index: int
    frame: Any
    at: float  # time.monotonic()


@dataclass
class _Sent:
    index: int
    frame_id: int
    answer: "asyncio.Future[Composite]"
    at: float  # time.monotonic()


class _Slot:
    """Holds the one frame that waits to be sent."""

    def __init__(self, newest_wins: bool, counts: FrameCounts) -> None:
        self._newest_wins, self._counts = newest_wins, counts
        self._frame: Optional[_Captured] = None
        self._changed = asyncio.Condition()
        self._ended = False
        self.replaced: List[int] = []

    async def fill(self, frames: Union[Iterable[Any], AsyncIterable[Any]]) -> None:
        try:
            index = 0
            async for frame in _iterate(frames):
                async with self._changed:
                    if not self._newest_wins:
                        await self._changed.wait_for(lambda: self._frame is None)
                    elif self._frame is not None:
                        self.replaced.append(self._frame.index)
                        self._counts.skipped_by_client += 1
                    self._frame = _Captured(index, frame, time.monotonic())
                    self._changed.notify_all()
                index += 1
        finally:
            async with self._changed:
                self._ended = True
                self._changed.notify_all()

    async def take(self) -> Optional[_Captured]:
        """The frame; waits for one. None after the last."""
        async with self._changed:
            await self._changed.wait_for(lambda: self._frame is not None or self._ended)
            frame, self._frame = self._frame, None
            self._changed.notify_all()
            return frame


async def _iterate(frames: Union[Iterable[Any], AsyncIterable[Any]]) -> AsyncIterator[Any]:
    if isinstance(frames, AsyncIterable):
        async for frame in frames:
            yield frame
        return
    # A camera's next picture blocks: it is waited for in a thread.
    iterator = iter(frames)
    while (frame := await asyncio.to_thread(lambda: next(iterator, _END))) is not _END:
        yield frame


async def stream(session: AsyncSession, frames: Union[Iterable[StreamFrame], AsyncIterable[StreamFrame]],
                 newest_wins: bool, in_flight: int,
                 on_rejected: Optional[Callable[[int, FrameRejected], None]]) -> AsyncIterator[Composite]:
    slot = _Slot(newest_wins, session.counts)
    filling = asyncio.create_task(slot.fill(frames))
    taking: Optional["asyncio.Task[Optional[_Captured]]"] = None
    sent: Deque[_Sent] = deque()
    skipped: List[int] = []

    async def outcome(of: _Sent) -> Optional[Composite]:
        try:
            composite = await session.finish(of.frame_id, of.answer, session.frame_timeout, of.at)
        except FrameSkipped:
            skipped.append(of.index)
        except FrameRejected as error:
            if on_rejected is None:
                raise
            on_rejected(of.index, error)
        else:
            skipped.extend(i for i in slot.replaced if i < of.index)
            slot.replaced = [i for i in slot.replaced if i >= of.index]
            found, skipped[:] = tuple(sorted(skipped)), []
            return replace(composite, index=of.index, skipped=found)
        return None

    async def send(captured: _Captured) -> None:
        frame, poses = captured.frame if isinstance(captured.frame, tuple) else (captured.frame, None)
        try:
            begun = await session.begin(frame, poses, None, captured.at)
            sent.append(_Sent(captured.index, *begun, time.monotonic()))
        except FrameRejected as error:  # by our own check
            session.counts.rejected += 1
            if on_rejected is None:
                raise
            on_rejected(captured.index, error)

    try:
        ended = False
        while sent or not ended:
            if taking is None and not ended and len(sent) < in_flight:
                taking = asyncio.create_task(slot.take())
            waits: List["asyncio.Future[Any]"] = [sent[0].answer] if sent else []
            if taking is not None:
                waits.append(taking)
            left = max(0.0, sent[0].at + session.frame_timeout - time.monotonic()) if sent else None
            await asyncio.wait(waits, timeout=left, return_when=asyncio.FIRST_COMPLETED)
            if sent and (sent[0].answer.done() or taking is None or not taking.done()):
                if (composite := await outcome(sent.popleft())) is not None:
                    yield composite
            if taking is not None and taking.done():
                captured, taking = taking.result(), None
                ended = captured is None
                if captured is not None:
                    await send(captured)
        await filling  # raises what the source raised
    finally:
        for task in (filling, taking):
            if task is not None:
                task.cancel()
