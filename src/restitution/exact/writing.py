"""Plain SymPy syntax with the names that letters have in the contract."""

from __future__ import annotations

import re
from typing import Any

import sympy
from sympy import Symbol


def sympy_text(expression: Any) -> str:
    """Plain SymPy syntax with canonical letters: Greek by name (``lambda_``), ``e_1``."""
    if not isinstance(expression, sympy.Basic):
        return str(expression)
    names = {}
    for letter in expression.free_symbols:
        name = canonical_name(letter.name) if isinstance(letter, Symbol) else str(letter)
        if isinstance(letter, Symbol) and name != letter.name:
            names[letter] = name
    return str(_Printer({"order": None}, names).doprint(expression))


def canonical_name(name: str) -> str:
    """The name of a letter in the contract: ``lambda_``, ``mu_``, ``nu_``, ``xi_``, ``e_1``."""
    if name in ("lambda", "mu", "nu", "xi"):
        return name + "_"
    plain = re.fullmatch(r"([A-Za-z]+)(\d+)", name)
    return f"{plain[1]}_{plain[2]}" if plain else name


class _Printer(sympy.StrPrinter):  # type: ignore[misc]
    """SymPy's own text, with letters under their canonical names."""

    def __init__(self, settings: dict[str, Any], names: dict[Symbol, str]) -> None:
        super().__init__(settings)
        self._names = names

    def _print_Symbol(self, expr: Symbol) -> str:
        return self._names.get(expr, str(expr.name))
