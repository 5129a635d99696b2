"""Letters and hidden unknowns of a story: as symbols, as values, or as numbers."""

from __future__ import annotations

import random
from collections import ChainMap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field

import sympy as sp

from restitution.exact.symbols import expression_of, symbol_names
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.expression.evaluate import Angle, Scalar, Symbolic, Value
from restitution.oracle import Formula, Oracle, Relation
from restitution.oracle.roles import POSITIVE, REAL, Role
from restitution.records import dataclass
from restitution.solving.algebra.numbers import Sample, plain_sign, sample, sign_at
from restitution.solving.story.admission import formula_of
from restitution.solving.story.conditions import AnyOf, Condition
from restitution.solving.story.contacts import rests_on
from restitution.solving.story.state import Sign, State

SYMBOLIC = Symbolic()


@dataclass
class Letters:
    """Letters and hidden unknowns as symbols, or as values where they are known."""

    roles: Mapping[str, Role]
    values: Mapping[str, sp.Expr] = field(default_factory=dict)
    angles: Mapping[str, tuple[sp.Expr, sp.Expr]] = field(default_factory=dict)
    samples: Sequence[Sample] = ()
    phrases: dict[str, str] = field(default_factory=dict)
    hidden_roles: dict[str, Role] = field(default_factory=dict)
    ground: Oracle | None = None
    assumed: list[Formula] = field(default_factory=list)
    undecided: list[sp.Expr] = field(default_factory=list)
    sought: frozenset[str] | None = None  # letters on which places of contact are not to rest

    def letter(self, name: str) -> Value:
        if name in self.angles:
            c, s = self.angles[name]
            return Angle(c, s, lambda: self.values[name])
        if name in self.values:
            return self.values[name]
        return self.roles.get(name, POSITIVE).symbol(name)

    def hidden(self, key: str, phrase: str, sign: Sign) -> sp.Expr:
        name = f"_{key}"
        self.phrases[name] = phrase
        self.hidden_roles[name] = POSITIVE if sign == "positive" else REAL
        if name in self.values:
            return self.values[name]
        return self.hidden_roles[name].symbol(name)

    def all_roles(self) -> dict[str, Role]:
        return {**self.roles, **self.hidden_roles}

    @property
    def certain(self) -> bool:
        """Whether all signs that a telling rests on are proved."""
        return not self.undecided and not self.assumed

    def seeks_contact(self, number: int, values: Iterable[sp.Expr]) -> bool:
        """Whether the place of an event is an unknown of its own; once found, it is known."""
        if f"_c_{number}x" in self.values:
            return True
        return self.sought is not None and rests_on(values, self.sought)

    def proved_sign(self, x: sp.Expr, given: Sequence[Condition | AnyOf] = ()) -> int | None:
        """The sign of an expression that is proved where conditions hold; else None."""
        plain = plain_sign(x)
        if plain is not None:
            return plain
        if self.ground is None:
            self.ground = Oracle(ChainMap(dict(self.roles), self.hidden_roles))
        proved = self.ground.sign(x)
        if proved is None and given:
            facts = [formula_of(condition) for condition in given]
            proved = self.ground.with_facts(dict.fromkeys(facts)).sign(x)
        return proved

    def sign(self, x: sp.Expr, given: Sequence[Condition | AnyOf] = ()) -> int | None:
        """The sign of an expression where conditions hold; None where it depends on the letters.

        One that is seen at usual values, but is not proved for all, is among ``assumed``; what
        has different signs is among ``undecided``.
        """
        x = sp.sympify(x, strict=True)
        proved = self.proved_sign(x, given)
        if proved is not None:
            return proved
        points: Iterable[Sample] = self.samples
        if not points:
            rng = random.Random(7)
            names = sorted(symbol_names(x))
            known = self.all_roles()
            points = [sample(names, known, rng) for _ in range(8)]
        usual = sign_at(x, points)
        if usual is None:
            self.undecided.append(x)
        else:
            self.assumed.append(Relation(usual * x, ">") if usual else Relation(x, "="))
        return usual


@dataclass
class Numbers:
    """Letters and hidden unknowns as numbers."""

    values: Mapping[str, Enclosed]

    def letter(self, name: str) -> Enclosed:
        if name not in self.values:
            raise UndefinedError(name)
        return self.values[name]

    def hidden(self, key: str, phrase: str, sign: Sign) -> Enclosed:
        name = f"_{key}"
        if name not in self.values:
            raise UndefinedError(name)
        return self.values[name]

    def sign(self, x: Enclosed, given: Sequence[Condition | AnyOf] = ()) -> int:
        return Enclosed.of(x).sign


def proved_sign(state: State, x: Scalar) -> int | None:
    """The sign of a scalar where it is certain: nothing is taken for granted by that."""
    unknowns = state.unknowns
    if not isinstance(unknowns, Letters):
        return state.sign(x)
    return unknowns.proved_sign(expression_of(x), state.conditions)
