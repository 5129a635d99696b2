"""One solve for all who ask the same: at the same time, or soon after."""

from __future__ import annotations

import asyncio
from collections import OrderedDict
from collections.abc import Awaitable, Callable, Hashable

from restitution.records import dataclass
from restitution.web.work import Payload


@dataclass
class _Shared:
    task: asyncio.Task[Payload]
    waiting: int = 0


class Replies:
    """Replies that are kept, as long as they have room in so many bytes. Lost without harm."""

    def __init__(self, room: int) -> None:
        self._room = room
        self._taken = 0
        self._kept: OrderedDict[Hashable, Payload] = OrderedDict()
        self._under_way: dict[Hashable, _Shared] = {}

    async def get(self, key: Hashable, make: Callable[[], Awaitable[Payload]]) -> Payload:
        """The reply to a question; when nobody waits for it any more, its work is cancelled."""
        if key in self._kept:
            self._kept.move_to_end(key)
            return self._kept[key]
        shared = self._under_way.get(key)
        if shared is None:
            shared = _Shared(asyncio.ensure_future(self._make(key, make)))
            self._under_way[key] = shared
        shared.waiting += 1
        try:
            return await asyncio.shield(shared.task)
        finally:
            shared.waiting -= 1
            if not shared.waiting and not shared.task.done():
                if self._under_way.get(key) is shared:
                    del self._under_way[key]
                shared.task.cancel()

    async def _make(self, key: Hashable, make: Callable[[], Awaitable[Payload]]) -> Payload:
        mine = asyncio.current_task()
        try:
            reply = await make()
        finally:
            shared = self._under_way.get(key)
            if shared is not None and shared.task is mine:
                del self._under_way[key]
        if not reply.tired and not reply.fault:
            self._keep(key, reply)
        return reply

    def _keep(self, key: Hashable, reply: Payload) -> None:
        self._kept[key] = reply
        self._taken += len(reply.content)
        while self._taken > self._room:
            _, oldest = self._kept.popitem(last=False)
            self._taken -= len(oldest.content)
