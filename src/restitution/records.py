"""Dataclasses that cost little to define.

``dataclass`` here is `dataclasses.dataclass` in all that can be seen of a class. The standard one
compiles six functions for each class, which takes longer than loading the rest of its module; a
command has hundreds of them and makes few values of most. Here ``__init__`` is compiled for classes
of many values, and the other functions are made without compiling anything.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import MISSING, Field, FrozenInstanceError, fields
from functools import partial
from operator import attrgetter
from reprlib import recursive_repr
from types import MethodType
from typing import TYPE_CHECKING, Any

__all__ = ["compared", "compile_what_is_used", "dataclass"]

_KNOWN = {"frozen", "slots", "eq", "repr"}

_FEW = 40
"""Values of one class for which setting fields one by one takes no longer than compiling."""


def _quickly(kind: type[Any] | None = None, /, **options: bool) -> Any:
    """A class as a dataclass; without one, what makes one of a class."""
    if kind is None:
        return lambda named: _quickly(named, **options)
    inherits = any(hasattr(base, "__dataclass_fields__") for base in kind.mro())
    if options.keys() - _KNOWN or inherits or _has_own_hash(kind):
        # That goes into what is compiled.
        return dataclasses.dataclass(kind, **options)
    frozen, slots = options.get("frozen", False), options.get("slots", False)
    has_equality, has_repr = options.get("eq", True), options.get("repr", True)
    own = dict(vars(kind))
    kind = dataclasses.dataclass(kind, init=False, repr=False, eq=False, slots=slots)
    params: Any = vars(kind)["__dataclass_params__"]
    params.init, params.repr, params.eq, params.frozen = True, has_repr, has_equality, frozen
    added: dict[str, Any] = {}
    if "__init__" not in own:
        added["__init__"] = _Beginning(kind, own, frozen)
    if has_repr and "__repr__" not in own:
        added["__repr__"] = _repr_of(kind)
    if has_equality:
        if "__eq__" not in own:
            added["__eq__"] = _equality_of(kind)
        # Python itself takes the hash from a class that says what is equal.
        if own.get("__hash__") is None and ("__hash__" not in own or "__eq__" in own):
            added["__hash__"] = _hash_of(kind) if frozen else None
    if frozen:
        added["__setattr__"], added["__delattr__"] = _guards_of(kind)
        if slots and "__getstate__" not in own:
            added["__getstate__"], added["__setstate__"] = _state, _restore
    for name, value in added.items():
        setattr(kind, name, value)
    return kind


def _has_own_hash(kind: type[Any]) -> bool:
    """Whether a field is in the hash and not compared, or the other way round."""
    own = [value for value in vars(kind).values() if isinstance(value, Field)]
    return any(field.hash is not None for field in own)


class _Beginning:
    """The ``__init__`` of a class, compiled when so many values are made that this is worth it.

    Until then the fields are set one by one. What is compiled takes this place, and complains of
    arguments that do not fit.
    """

    def __init__(self, kind: type[Any], own: dict[str, Any], frozen: bool) -> None:
        self._kind, self._frozen = kind, frozen
        self._set: Callable[[Any, str, Any], None] = object.__setattr__ if frozen else setattr
        self._has_more = hasattr(kind, "__post_init__")
        kept = {"__annotations__", "__module__", *own.get("__annotations__", ())}
        self._own = {name: value for name, value in own.items() if name in kept}
        if self._has_more:
            self._own["__post_init__"] = getattr(kind, "__post_init__")  # noqa: B009
        all_ = list(vars(kind)["__dataclass_fields__"].values())
        self._names = [field.name for field in all_]
        self._by_place = [field.name for field in all_ if not field.kw_only]
        self._values = {f.name: f.default for f in all_ if f.default is not MISSING}
        self._factories = {
            f.name: f.default_factory for f in all_ if f.default_factory is not MISSING
        }
        plain = len(fields(kind)) == len(all_) and all(field.init for field in all_)
        self._most = self._left = _FEW if plain else 0
        _WAITING.append(self)

    def __get__(self, value: Any, kind: type[Any] | None = None) -> Any:
        if value is None or not self._left:
            begin = self.compiled()
            return begin if value is None else MethodType(begin, value)
        self._left -= 1
        return partial(self._one_by_one, value)

    def _one_by_one(self, value: Any, /, *places: Any, **named: Any) -> None:
        content = self._values | dict(zip(self._by_place, places)) | named
        for name, make in self._factories.items():
            if name not in content:
                content[name] = make()
        if (
            len(places) > len(self._by_place)
            or not named.keys().isdisjoint(self._by_place[: len(places)])
            or content.keys() != set(self._names)
        ):
            self.compiled()(value, *places, **named)
            return
        for name in self._names:
            self._set(value, name, content[name])
        if self._has_more:
            value.__post_init__()

    def is_in_use(self) -> bool:
        """Whether there were values, and nothing is compiled."""
        return self._left < self._most and vars(self._kind)["__init__"] is self

    def compiled(self) -> Callable[..., None]:
        """The function, which takes this place."""
        like: type[Any] = type(self._kind.__name__, (), {**self._own, "__doc__": ""})
        compiled = dataclasses.dataclass(like, frozen=self._frozen, repr=False, eq=False)
        begin: Any = vars(compiled)["__init__"]
        begin.__qualname__ = f"{self._kind.__qualname__}.__init__"
        setattr(self._kind, "__init__", begin)  # noqa: B010 - mypy takes it for that of an object
        return begin  # type: ignore[no-any-return]


def compile_what_is_used() -> None:
    """Compile what makes values of the classes that had any: for a process that has the time."""
    for begin in _WAITING:
        if begin.is_in_use():
            begin.compiled()


_WAITING: list[_Beginning] = []


def _repr_of(kind: type[Any]) -> Callable[[Any], str]:
    names = [field.name for field in fields(kind) if field.repr]

    @recursive_repr()
    def shown(value: Any) -> str:
        inside = ", ".join([f"{name}={getattr(value, name)!r}" for name in names])
        return f"{value.__class__.__qualname__}({inside})"

    return shown


def compared(kind: type[Any]) -> Callable[[Any], Any]:
    """What is compared of a value of a dataclass: its fields, or its field where it has one."""
    names = [field.name for field in fields(kind) if field.compare]
    return attrgetter(*names) if names else lambda value: ()


def _equality_of(kind: type[Any]) -> Callable[[Any, Any], Any]:
    get = compared(kind)

    def same(value: Any, other: Any) -> Any:
        if other.__class__ is not value.__class__:
            return NotImplemented
        own, others = get(value), get(other)
        return own is others or own == others

    return same


def _hash_of(kind: type[Any]) -> Callable[[Any], int]:
    get = compared(kind)
    return lambda value: hash(get(value))


def _guards_of(
    kind: type[Any],
) -> tuple[Callable[[Any, str, Any], None], Callable[[Any, str], None]]:
    """What keeps fields of a frozen class as they are; a class below it may have others."""
    names = {field.name for field in fields(kind)}

    def set_(value: Any, name: str, new: Any) -> None:
        if type(value) is kind or name in names:
            raise FrozenInstanceError(f"cannot assign to field {name!r}")
        super(kind, value).__setattr__(name, new)

    def delete(value: Any, name: str) -> None:
        if type(value) is kind or name in names:
            raise FrozenInstanceError(f"cannot delete field {name!r}")
        super(kind, value).__delattr__(name)

    return set_, delete


def _state(value: Any) -> list[Any]:
    return [getattr(value, field.name) for field in fields(value)]


def _restore(value: Any, state: list[Any]) -> None:
    for field, content in zip(fields(value), state):
        object.__setattr__(value, field.name, content)


if TYPE_CHECKING:
    from dataclasses import dataclass
else:
    dataclass = _quickly
