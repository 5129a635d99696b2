"""Ranges over open lines of centres: a few lines that stand for all that there can be.

Whether a letter may have a value rests on some line of centres with which the story is possible.
Lines are chosen, along the approach first, until it is proved that one of them serves wherever any
does. What is sought is then one of several solutions without an unknown line.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import chain

import sympy as sp

from restitution.oracle import (
    FALSE,
    All,
    BeyondError,
    Formula,
    Oracle,
    Some,
    Verdict,
    as_number,
    joined,
    letters_of,
)
from restitution.solving.algebra.systems import Root
from restitution.solving.equations.part import Outcome
from restitution.solving.equations.setting import Trial
from restitution.solving.story.admission import Admission
from restitution.solving.story.impacts import SLOPE

_MOST_LINES = 6

Line = Mapping[sp.Symbol, sp.Expr]
"""A value for each slope of an open line of centres."""


def with_lines_chosen(outcome: Outcome) -> Outcome:
    """What solving gave, each solution with lines that serve in place of open ones.

    A solution without open lines, or with such that no few are proved to serve, stays as it is.
    """
    chosen = (_with_lines(outcome, trial) for trial in outcome.trials)
    return replace(outcome, trials=tuple(chain.from_iterable(chosen)))


def open_slopes(outcome: Outcome) -> set[str]:
    """The slopes that stand in what solutions ask of their letters."""
    return {
        name
        for trial in outcome.trials
        if trial.admission is not None
        for demand in trial.admission.demands
        for name in letters_of(demand.formula)
        if name.startswith(SLOPE)
    }


def _with_lines(outcome: Outcome, trial: Trial) -> list[Trial]:
    admission = trial.admission
    if admission is None or not trial.samples:
        return [trial]
    slopes = [
        role.symbol(name)
        for name, role in sorted(admission.roles.items())
        if name.startswith(SLOPE) and name not in trial.root.values
    ]
    every = _asked(admission)
    line: Line = dict.fromkeys(slopes, sp.Integer(0))
    chosen: list[Trial] = []
    if not slopes or every is None:
        return [trial]
    for _ in range(_MOST_LINES):
        along = _along(outcome, trial, line)
        if along.samples and along.admission is not None and _asked(along.admission) is not None:
            chosen.append(along)
        verdict = _one_serves(admission, every, chosen, slopes)
        if verdict:
            return chosen
        if verdict.witness is None:
            break
        line = {slope: as_number(verdict.witness.get(slope.name, 0)) for slope in slopes}
        if not all(value.is_Rational for value in line.values()):
            break
    return [trial]


def _along(outcome: Outcome, trial: Trial, line: Line) -> Trial:
    """A solution with numbers for its slopes."""
    put, root = dict(line), trial.root
    values = {name: value.xreplace(put) for name, value in root.values.items()}
    angles = {name: (c.xreplace(put), s.xreplace(put)) for name, (c, s) in root.angles.items()}
    own = {symbol.name: value for symbol, value in line.items()}
    return outcome.setting.try_out(Root({**values, **own}, angles, root.leftover), outcome.letters)


def _one_serves(
    admission: Admission, every: Formula, chosen: Sequence[Trial], slopes: Sequence[sp.Symbol]
) -> Verdict:
    """Whether one of the lines chosen is possible wherever any line is."""
    claim = Some(tuple(_asked(along.admission) or FALSE for along in chosen if along.admission))
    names = {slope.name for slope in slopes}
    parts = every.parts if isinstance(every, All) else (every,)
    of_letters = tuple(part for part in parts if not letters_of(part) & names)
    try:
        if chosen and Oracle(admission.roles, of_letters).proves(claim):
            return Verdict("proved", "decision")
        return Oracle(admission.roles, (every,)).decide(claim)
    except BeyondError:
        return Verdict("undecided", "undecided")


def _asked(admission: Admission) -> Formula | None:
    """All that a solution asks of the letters; None where the formulas do not say it."""
    if admission.equations or admission.assumed:
        return None
    return joined(dict.fromkeys(demand.formula for demand in admission.demands))
