"""A derivation as JSON, and back: nothing is lost.

Relations stand as text in the notation of statements, by which they are read again, and beside it
as LaTeX and as MathML.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, get_args, get_type_hints

from restitution.errors import StatementError
from restitution.explaining.lines.derivation import (
    Case,
    Derivation,
    Event,
    Fact,
    ItemEnd,
    Line,
    Link,
    Meaning,
    Move,
    Note,
    Relation,
    Route,
)
from restitution.explaining.lines.layouts import of_relation, of_tree
from restitution.explaining.lines.marks import Mark
from restitution.explaining.lines.notation import (
    read_meaning,
    read_relation,
    write_meaning,
    write_relation,
)
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Letter, Name, Place, walk
from restitution.render import latex, layout, mathml

if TYPE_CHECKING:
    from restitution.explaining.lines.stored import (
        DerivationNoteObject,
        DerivationObject,
        EventObject,
        FactObject,
        ItemEndObject,
        LineObject,
        MarkObject,
        MoveObject,
        RelationObject,
    )

VERSION = 1


def to_json(derivation: Derivation) -> DerivationObject:
    """A derivation as a value of JSON."""
    vectors = frozenset(name for name, meaning in derivation.meanings.items() if meaning.vector)
    return {
        "version": VERSION,
        "names": _names(derivation),
        "events": [_event(event) for event in derivation.events],
        "facts": [_fact(fact, vectors) for fact in derivation.facts],
        "lines": [_line(line, vectors) for line in derivation.lines],
        "items": [_item(item, vectors) for item in derivation.items],
        "cases": [
            {"n": e.number, "line": e.line, "option": e.option, "lines": list(e.lines)}
            for e in derivation.cases
        ],
        "others": [
            {"item": other.item, "moves": [_move(move) for move in other.moves]}
            for other in derivation.others
        ],
        "notes": [_note(note, vectors) for note in derivation.notes],
    }


def _names(derivation: Derivation) -> dict[str, str]:
    """The bodies and points that lines speak of: without them their text cannot be read."""
    walls = {body for e in derivation.events if e.wall for body in e.bodies[1:2]}
    spheres = {body for e in derivation.events for body in e.bodies} - walls
    relations = [
        *(fact.relation for fact in derivation.facts),
        *(line.relation for line in derivation.lines),
        *(item.answer for item in derivation.items),
        *(relation for note in derivation.notes for relation in _relations_of(note)),
    ]
    names = {
        node.name
        for relation in relations
        for tree in trees_of(relation)
        for node in walk(tree)
        if isinstance(node, Name)
    }
    kinds = {**dict.fromkeys(spheres, "sphere"), **dict.fromkeys(walls, "wall")}
    return {name: kinds.get(name, "body") for name in sorted(names | kinds.keys())}


def _event(event: Event) -> EventObject:
    return {
        "n": event.number,
        "kind": event.kind,
        "bodies": list(event.bodies),
        "wall": event.wall,
    }


def _fact(fact: Fact, vectors: frozenset[str]) -> FactObject:
    place = fact.place
    return {
        "id": fact.id,
        "kind": fact.kind,
        "part": fact.part,
        "place": None if place is None else [place.line, place.column],
        **_object(fact.relation, vectors),
    }


def _line(line: Line, vectors: frozenset[str]) -> LineObject:
    return {
        "n": line.number,
        "item": line.item,
        **_move(line.move),
        "premises": list(line.premises),
        **_object(line.relation, vectors),
        "marks": [_mark(mark) for mark in line.marks],
        "shown": line.shown,
    }


def _move(move: Move) -> MoveObject:
    return {
        "move": move.id,
        "record": move.record,
        "event": move.event,
        "bodies": list(move.bodies),
        "eliminated": move.eliminated,
    }


def _mark(mark: Mark) -> MarkObject:
    return {
        "mark": str(mark),
        "kind": mark.kind,
        "number": mark.number,
        "dependent": mark.dependent,
        "star": mark.star,
        "ft": mark.ft,
        "because": mark.because,
        "on": list(mark.on),
    }


def _item(end: ItemEnd, vectors: frozenset[str]) -> ItemEndObject:
    return {
        "item": end.item,
        "line": end.line,
        "part": end.part,
        "printed": end.shown,
        "case": end.case,
        **_object(end.answer, vectors),
    }


def _note(note: Note, vectors: frozenset[str]) -> DerivationNoteObject:
    return {
        "item": note.item,
        "kind": note.kind,
        "place": note.place,
        "part": note.part,
        "reason": note.reason,
        "premises": list(note.premises),
        "claim": None if note.claim is None else _object(note.claim, vectors),
        "instance": [_object(_alone(link), vectors) for link in note.instance],
        "sides": [_object(_alone(side), vectors) for side in note.sides],
        "marks": [_mark(mark) for mark in note.marks],
    }


def _relations_of(note: Note) -> Iterator[Relation]:
    if note.claim is not None:
        yield note.claim
    yield from map(_alone, (*note.instance, *note.sides))


def _alone(link: Link) -> Relation:
    return Relation(((link,),))


def _object(relation: Relation | Meaning, vectors: frozenset[str]) -> RelationObject:
    if isinstance(relation, Meaning):
        own = frozenset((relation.letter,)) if relation.vector else vectors
        formula: layout.Layout = layout.Relation(
            (of_tree(Letter(relation.letter), own), of_tree(relation.quantity)), ("=",)
        )
        text = write_meaning(relation)
    else:
        formula, text = of_relation(relation, vectors), write_relation(relation)
    return {"text": text, "latex": latex.to_latex(formula), "mathml": mathml.to_mathml(formula)}


# --- reading back --------------------------------------------------------------------------------


def from_json(value: Mapping[str, Any]) -> Derivation:
    """The derivation that `to_json` has written.

    Raises StatementError where a field is missing, or says what cannot be.
    """
    try:
        return _Reading(value).derivation()
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise StatementError(f"this is no derivation as JSON: {error!r}") from error


class _Reading:
    """One reading of a value of JSON."""

    def __init__(self, value: Mapping[str, Any]) -> None:
        if value["version"] != VERSION:
            raise ValueError(f"its version is {value['version']}, not {VERSION}")
        self.value = value
        self.names = {_text(name): _text(kind) for name, kind in dict(value["names"]).items()}

    def derivation(self) -> Derivation:
        """The whole."""
        value = self.value
        return Derivation(
            tuple(self._fact(other) for other in value["facts"]),
            tuple(self._line(other) for other in value["lines"]),
            tuple(self._item(other) for other in value["items"]),
            tuple(self._event(other) for other in value["events"]),
            tuple(
                Case(
                    _number(other["n"]),
                    _number(other["line"]),
                    _number(other["option"]),
                    tuple(_number(line) for line in other["lines"]),
                )
                for other in value["cases"]
            ),
            tuple(
                Route(_text(other["item"]), tuple(self._move(move) for move in other["moves"]))
                for other in value["others"]
            ),
            tuple(self._note(other) for other in value.get("notes", ())),
        )

    def _event(self, value: Mapping[str, Any]) -> Event:
        bodies = tuple(_text(other) for other in value["bodies"])
        kind = _one_of(value["kind"], Event, "kind")
        return Event(_number(value["n"]), kind, bodies, _truth(value["wall"]))

    def _fact(self, value: Mapping[str, Any]) -> Fact:
        place = None if value["place"] is None else Place(*map(_number, value["place"]))
        relation = read_relation(value["text"], self.names)
        kind = _one_of(value["kind"], Fact, "kind")
        return Fact(_text(value["id"]), kind, relation, _text_or_none(value["part"]), place)

    def _line(self, value: Mapping[str, Any]) -> Line:
        text = value["text"]
        relation = (
            read_meaning(text, self.names)
            if value["move"] == "let"
            else read_relation(text, self.names)
        )
        return Line(
            _number(value["n"]),
            _text_or_none(value["item"]),
            self._move(value),
            tuple(e if isinstance(e, str) else _number(e) for e in value["premises"]),
            relation,
            tuple(self._mark(other) for other in value["marks"]),
            _one_of(value["shown"], Line, "shown"),
        )

    def _mark(self, value: Mapping[str, Any]) -> Mark:
        return Mark(
            _one_of(value["kind"], Mark, "kind"),
            _number(value["number"]),
            _truth(value["dependent"]),
            _truth(value["star"]),
            _truth(value["ft"]),
            _text(value["because"]),
            tuple(_number(other) for other in value["on"]),
        )

    def _move(self, value: Mapping[str, Any]) -> Move:
        return Move(
            _one_of(value["move"], Move, "id"),
            _text_or_none(value["record"]),
            None if value["event"] is None else _number(value["event"]),
            tuple(_text(other) for other in value["bodies"]),
            _text_or_none(value["eliminated"]),
        )

    def _note(self, value: Mapping[str, Any]) -> Note:
        claim = value["claim"]
        return Note(
            _text(value["item"]),
            _one_of(value["kind"], Note, "kind"),
            _number(value["place"]),
            _text_or_none(value["part"]),
            _text(value["reason"]),
            tuple(e if isinstance(e, str) else _number(e) for e in value["premises"]),
            None if claim is None else read_relation(claim["text"], self.names),
            tuple(self._link(other) for other in value["instance"]),
            tuple(self._link(other) for other in value["sides"]),
            tuple(self._mark(other) for other in value.get("marks", ())),
        )

    def _link(self, value: Mapping[str, Any]) -> Link:
        (link,) = read_relation(value["text"], self.names).only
        return link

    def _item(self, value: Mapping[str, Any]) -> ItemEnd:
        return ItemEnd(
            _text(value["item"]),
            _number(value["line"]),
            read_relation(value["text"], self.names),
            _text_or_none(value["part"]),
            _truth(value["printed"]),
            None if value["case"] is None else _number(value["case"]),
        )


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{value!r} is no text")
    return value


def _text_or_none(value: object) -> str | None:
    return None if value is None else _text(value)


def _number(value: object) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise TypeError(f"{value!r} is no whole number")
    return value


def _truth(value: object) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"{value!r} is neither true nor false")
    return value


def _one_of(value: object, of: type, name: str) -> Any:
    """A value of a field that takes one of several words."""
    allowed = get_args(get_type_hints(of)[name])
    if value not in allowed:
        raise ValueError(f"{value!r} is none of {', '.join(allowed)}")
    return value
