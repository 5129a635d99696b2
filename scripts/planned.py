"""Which statements of the examples and tests have a plan: `tests/planned.txt`, compared or kept.

    uv run python scripts/planned.py           # what has changed since the list was written
    uv run python scripts/planned.py --write   # and writes it anew

A line is the name of a statement, with ``refused`` behind it where the follower does not accept
its working.
"""

from __future__ import annotations

import sys
from pathlib import Path

import restitution.examples
from restitution.errors import RestitutionError
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.planning.writing.desk import NotPlannedError
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles

TESTS = Path(__file__).parents[1] / "tests"
LIST = TESTS / "planned.txt"


def statements() -> dict[str, Path]:
    """The examples that ship, and the questions of the tests, by name."""
    examples = Path(restitution.examples.__file__).parent.glob("*.impact")
    return {each.stem: each for each in sorted((*examples, *TESTS.glob("questions/*.impact")))}


def listed() -> dict[str, bool]:
    """The statements that have a plan by the list, and whether it is accepted."""
    lines = filter(None, map(str.strip, LIST.read_text(encoding="utf-8").splitlines()))
    return {each.split()[0]: not each.endswith(" refused") for each in lines}


def planned(path: Path) -> tuple[Solution, Derivation] | None:
    """The solution of a statement and its working; None where there is no plan for it."""
    try:
        solution = solve(parse(path.read_text(encoding="utf-8")))
        return solution, plan(solution)
    except (NotPlannedError, RestitutionError):
        return None


def accepted(solution: Solution, derivation: Derivation) -> bool:
    """Whether the follower finds nothing to complain of."""
    return not follow(derivation, Oracle(roles(solution.problem)))


def main() -> None:
    """Compares the list with what is planned now."""
    now: dict[str, bool] = {}
    for name, path in statements().items():
        made = planned(path)
        if made is not None:
            now[name] = accepted(*made)
    before = listed() if LIST.exists() else {}
    for name in sorted(before.keys() | now.keys()):
        if before.get(name) != now.get(name):
            words = {None: "not planned", False: "refused", True: "accepted"}
            print(f"{name}: {words[before.get(name)]} before, now {words[now.get(name)]}")
    print(f"{len(now)} planned, {sum(now.values())} of them accepted")
    if "--write" in sys.argv:
        lines = [name if good else f"{name} refused" for name, good in sorted(now.items())]
        LIST.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
