"""Who may connect and for how long: nobody keeps others out by asking for nothing.

A connection *owes* a request from its beginning, and after each reply, until one has come in whole.
It has so many seconds for it. Where there are too many connections, those that owe go first, the
longest owing before others; so a class behind one address is served while somebody holds hundreds
of connections open.
"""

from __future__ import annotations

import json
import math
from asyncio import TimerHandle
from collections.abc import Callable, Mapping, Sequence
from typing import Any, ClassVar

import h11
from starlette.responses import JSONResponse
from starlette.types import ASGIApp
from uvicorn.protocols.http.h11_impl import H11Protocol

from restitution.web.safety import guarded

_AFTERWARDS = "2"
"""Seconds after which to come again, for whom there is no place."""

_TURNED_AWAY = 100
"""Connections at once that are told so."""


def _error(kind: str, message: str) -> Mapping[str, Any]:
    return {"error": {"kind": kind, "message": message}}


_NO_PLACE: ASGIApp = guarded(
    JSONResponse(
        _error("busy", "too many are connected from your address; please ask again"),
        503,
        {"Retry-After": _AFTERWARDS, "Connection": "close"},
    ),
    (),
)

_LATE = (
    b"HTTP/1.1 408 Request Timeout\r\nContent-Type: application/json\r\nConnection: close\r\n\r\n"
    + json.dumps(_error("too slow", "the request did not come in whole")).encode()
)


class Connection(H11Protocol):
    """One connection, as uvicorn serves it, with a place at a ``Door``."""

    door: ClassVar[Door]

    def __init__(self, *arguments: Any, **named: Any) -> None:
        super().__init__(*arguments, **named)
        self.owes = False
        self._unread = math.inf
        self._timer: TimerHandle

    @property
    def address(self) -> str:
        """The address of the client."""
        return self.client[0] if self.client else ""

    @property
    def idle(self) -> bool:
        """Whether nothing is lost when it ends."""
        return not self.transport.get_write_buffer_size()

    def end(self) -> None:
        """End it at once."""
        self.transport.abort()

    def connection_made(self, transport: Any) -> None:
        super().connection_made(transport)
        if not self.door.enter(self):
            self.app = _NO_PLACE
        self._look()

    def data_received(self, data: bytes) -> None:
        super().data_received(data)
        self._look()

    def on_response_complete(self) -> None:
        super().on_response_complete()
        self._look()

    def connection_lost(self, exc: Exception | None) -> None:
        super().connection_lost(exc)
        self._timer.cancel()
        self.door.leave(self)

    def _look(self) -> None:
        """See whether a request is owed now."""
        owed = self.owes
        answering = not getattr(self.cycle, "response_complete", True)
        self.owes = not answering or self.conn.their_state is h11.SEND_BODY
        if self.owes and not owed:
            self._unread = math.inf
            self._wait()
            self.door.owing(self)
        elif owed and not self.owes:
            self._timer.cancel()
            self.door.paid(self)

    def _wait(self) -> None:
        self._timer = self.loop.call_later(self.door.patience, self._be_late)

    def _be_late(self) -> None:
        unread = self.transport.get_write_buffer_size()
        if 0 < unread < self._unread:
            self._unread = unread  # one who reads the last reply, however slowly
            self._wait()
        elif self.conn.their_state is h11.IDLE and self.conn.trailing_data[0] and not unread:
            self.transport.write(_LATE)
            self.transport.close()
        else:
            self.end()


class _Places:
    """Places for ``most`` connections."""

    def __init__(self, most: int) -> None:
        self._most = most
        self.taken: set[Connection] = set()
        self.owing: dict[Connection, None] = {}  # the one that owes for the longest comes first

    def room(self, leave: Callable[[Connection], None]) -> bool:
        """Whether there is room for one more; an idle one may ``leave`` for it."""
        if len(self.taken) < self._most:
            return True
        idle = next((connection for connection in self.owing if connection.idle), None)
        if idle is None:
            return False
        idle.end()
        leave(idle)
        return True


class Door:
    """The connections of a server: ``per_address`` of one address at most, and ``most`` in all.

    ``patience`` is for how many seconds a request may be owed.
    """

    def __init__(self, per_address: int, most: int, patience: float) -> None:
        self.patience = patience
        self._per_address = per_address
        self._all = _Places(most)
        self._of: dict[str, _Places] = {}
        self._turned: dict[Connection, None] = {}

    def enter(self, connection: Connection) -> bool:
        """Whether there is room for a connection; an idle one may have to go for it."""
        own = self._of.get(connection.address) or _Places(self._per_address)
        if own.room(self.leave) and self._all.room(self.leave):
            self._of[connection.address] = own
            for places in (own, self._all):
                places.taken.add(connection)
            return True
        self._turned[connection] = None
        if len(self._turned) > _TURNED_AWAY:
            next(iter(self._turned)).end()
        return False

    def leave(self, connection: Connection) -> None:
        """Forget a connection that has ended."""
        self._turned.pop(connection, None)
        for places in self._places(connection):
            places.taken.remove(connection)
            places.owing.pop(connection, None)
        own = self._of.get(connection.address)
        if own is not None and not own.taken:
            del self._of[connection.address]

    def owing(self, connection: Connection) -> None:
        """Note that a connection owes a request from now on."""
        for places in self._places(connection):
            places.owing[connection] = None

    def paid(self, connection: Connection) -> None:
        """Note that the request of a connection has come in whole."""
        for places in self._places(connection):
            places.owing.pop(connection, None)

    def _places(self, connection: Connection) -> Sequence[_Places]:
        """The places that a connection takes."""
        if connection not in self._all.taken:
            return ()
        return self._all, self._of[connection.address]


def at(door: Door) -> type[Connection]:
    """The kind of connection for the server behind a door."""

    class Here(Connection):
        pass

    Here.door = door
    return Here
