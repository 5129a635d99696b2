"""Dataclasses that cost little: in all that is seen of them they are the standard ones."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import pickle
from collections.abc import Callable
from dataclasses import FrozenInstanceError, field
from typing import Any

import pytest

from restitution import records


def classes(make: Callable[..., Any]) -> dict[str, Any]:
    """The same classes, made by a decorator."""

    @make
    class Plain:
        """Values that may change."""

        a: int
        b: list[int] = field(default_factory=list)

        def __post_init__(self) -> None:
            self.twice = 2 * self.a

    @make(frozen=True)
    class Frozen:
        """One that may not, with a field of no account and one by name only."""

        a: int
        b: tuple[int, ...] = ()
        c: int = field(default=3, compare=False, repr=False, kw_only=True)

    @make(frozen=True, slots=True)
    class Slots:
        """One in slots."""

        a: object

    @make(frozen=True)
    class Empty:
        """One without fields."""

    @make(frozen=True, eq=False)
    class Itself:
        """One that is equal to itself only."""

        a: int

    @make(frozen=True, repr=False)
    class Own:  # noqa: PLW1641
        """One that says by itself what is equal, and what it looks like."""

        a: int

        def __eq__(self, other: object) -> bool:
            return isinstance(other, Own) and abs(self.a) == abs(other.a)

        def __repr__(self) -> str:
            return "own"

    @make(frozen=True)
    class Below(Frozen):  # type: ignore[misc, valid-type]
        """One with the fields of another."""

        d: int = 4

    @make(frozen=True)
    class Hashed:
        """One with a field that is compared and not in the hash."""

        a: list[int] = field(hash=False)
        b: int = 1

    kinds = (Plain, Frozen, Slots, Empty, Itself, Own, Below, Hashed)
    return {kind.__name__: kind for kind in kinds}


CALLS: list[tuple[str, tuple[Any, ...], dict[str, Any]]] = [
    ("Plain", (1,), {}),
    ("Plain", (1, [2]), {}),
    ("Plain", (), {"b": [], "a": 1}),
    ("Plain", (), {}),
    ("Plain", (1, [], 3), {}),
    ("Plain", (1,), {"a": 1}),
    ("Plain", (1,), {"other": 1}),
    ("Frozen", (1,), {}),
    ("Frozen", (1, (2,)), {"c": 5}),
    ("Frozen", (1, (2,), 5), {}),
    ("Slots", ((1, 2),), {}),
    ("Slots", ([],), {}),
    ("Empty", (), {}),
    ("Empty", (1,), {}),
    ("Itself", (1,), {}),
    ("Own", (-1,), {}),
    ("Below", (1, (2,), 6), {"c": 7}),
    ("Hashed", ([1],), {}),
    ("Slots", (float("nan"),), {}),
]


def outcome(work: Callable[[], Any]) -> object:
    """What comes out, or what is complained of."""
    try:
        return work()
    except Exception as error:  # noqa: BLE001 - whatever it is, it has to be the same
        return type(error), str(error).replace("classes.<locals>.", "")


def account(kinds: dict[str, Any], name: str, places: tuple[Any, ...], named: Any) -> list[object]:
    """What is seen of a value, of another like it and of its class."""

    def one(**changed: Any) -> Any:
        return kinds[name](*copy.deepcopy(places), **{**named, **changed})

    if isinstance(made := outcome(one), tuple):
        return [made]
    return [
        repr(made),
        vars(made) if hasattr(made, "__dict__") else None,
        made == one(),
        made != one(),
        made == 1,
        made == outcome(lambda: one(a=100)),
        outcome(lambda: hash(made) == hash(one()) if name != "Itself" else None),
        outcome(lambda: setattr(made, "a", 5)),
        # The standard one complains of another error here, where there are slots.
        name != "Slots" and outcome(lambda: setattr(made, "unknown", 5)),
        outcome(lambda: delattr(made, "a")),
        repr(outcome(lambda: dataclasses.replace(one(), a=7))),
        repr(copy.deepcopy(one())),
        [(each.name, each.kw_only, each.compare) for each in dataclasses.fields(made)],
        kinds[name].__match_args__,
        str(inspect.signature(kinds[name])),
        kinds[name].__init__.__qualname__,
        kinds[name].__doc__,
    ]


@pytest.mark.parametrize("few", [0, 100])
@pytest.mark.parametrize(("name", "places", "named"), CALLS)
def test_record_is_a_dataclass(
    name: str, places: Any, named: Any, few: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(records, "_FEW", few)  # compiled at once, or not at all
    quick = account(classes(records.dataclass), name, places, named)
    assert quick == account(classes(dataclasses.dataclass), name, places, named)


def test_record_is_compiled_after_many_values() -> None:
    kind = classes(records.dataclass)["Frozen"]
    values = [kind(number) for number in range(300)]
    assert values == [kind(number, b=()) for number in range(300)]
    assert inspect.isfunction(vars(kind)["__init__"])


def test_records_in_use_are_compiled_where_there_is_time() -> None:
    kinds = classes(records.dataclass)
    kinds["Frozen"](1)
    records.compile_what_is_used()
    assert inspect.isfunction(vars(kinds["Frozen"])["__init__"])
    assert not inspect.isfunction(vars(kinds["Slots"])["__init__"])
    assert kinds["Frozen"](1, (2,)) == kinds["Frozen"](1, (2,), c=4)


@records.dataclass(frozen=True, slots=True)
class Kept:
    """A value that goes to another process."""

    a: int
    b: tuple[int, ...] = ()


def test_record_goes_to_another_process() -> None:
    back = pickle.loads(pickle.dumps(Kept(1, (2, 3))))
    assert back == Kept(1, (2, 3))
    with pytest.raises(FrozenInstanceError):
        back.a = 2


def test_record_that_holds_itself_is_printed() -> None:
    value = classes(records.dataclass)["Plain"](1)
    value.b.append(value)
    assert repr(value).endswith("Plain(a=1, b=[...])")
