"""Letters as symbols, and hidden unknowns under names that people see."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.expression.enclosed import UndefinedError
from restitution.oracle.roles import POSITIVE, REAL, Role
from restitution.records import dataclass
from restitution.solving.algebra.numbers import FIELD, at, plain_sign, sign_there
from restitution.solving.equations.solution import Branch
from restitution.solving.story.state import Sign

_BEFORE = ("a", "b", "c", "d", "p", "q", "f", "g", "x", "y")


@dataclass
class NamedUnknowns:
    """Letters as symbols, and hidden unknowns as symbols with presentable names.

    What a hidden unknown is worth goes to ``final`` and ``sample`` when it first turns up.
    """

    roles: Mapping[str, Role]
    branch: Branch
    sample: dict[str, Any]
    final: dict[sp.Symbol, sp.Expr]
    taken: set[str]
    names: dict[str, str] = field(default_factory=dict)
    phrases: dict[str, str] = field(default_factory=dict)
    hidden_roles: dict[str, Role] = field(default_factory=dict)

    def letter(self, name: str) -> sp.Expr:
        return self.roles.get(name, POSITIVE).symbol(name)

    def hidden(self, key: str, phrase: str, sign: Sign) -> sp.Expr:
        if key.startswith(("c_", "w_")) and f"_{key}" in self.branch.values:
            return tidy(sp.sympify(self.branch.values[f"_{key}"], strict=True))
        role = POSITIVE if sign == "positive" else REAL
        if key in self.names:
            return role.symbol(self.names[key])
        name = self._name(key)
        self.names[key] = name
        self.taken.add(name)
        self.phrases[name] = phrase
        self.hidden_roles[name] = role
        symbol = role.symbol(name)
        value = self.branch.values.get(f"_{key}")
        known = self.sample.get(f"_{key}")
        if value is not None:
            self.final[symbol] = tidy(sp.sympify(value, strict=True))
            if known is None:
                try:
                    known = at(sp.sympify(value, strict=True), self.sample)
                except (UndefinedError, KeyError, ArithmeticError):
                    known = None
        # What the answers do not depend on may be anything.
        self.sample[name] = known if known is not None else FIELD.number(Fraction(137, 100))
        return symbol

    def seeks_contact(self, number: int, values: Iterable[sp.Expr]) -> bool:
        """Whether the place of an event was found as an unknown of its own."""
        return f"_c_{number}x" in self.branch.values

    def _name(self, key: str) -> str:
        if key.startswith(("m_", "t_")):
            return key
        if key.startswith("u_"):
            free = next((c for c in _BEFORE if c not in self.taken), None)
            if free is not None:
                return free
        return key

    def sign(self, x: sp.Expr, given: Sequence[object] = ()) -> int | None:
        x = sp.sympify(x, strict=True)
        plain = plain_sign(x)
        if plain is not None:
            return plain
        try:
            return sign_there(x, self.sample)
        except (UndefinedError, KeyError, ArithmeticError):
            return None
