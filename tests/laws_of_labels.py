"""Laws of labels: in the simplest form, and with the letters of the working."""

from __future__ import annotations

import re
from pathlib import Path

from statements import EXAMPLES, explained, law, solved

from restitution.drawing import figure, scenes
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.solving import Solution
from restitution.staging.values import motion

LET = re.compile(r"Let ([^.]+?) be the components? of the velocit(?:y|ies) of (\w+)(?: and (\w+))?")


def check_forms(solution: Solution, statement: str) -> None:
    """Labels of all pictures of a solution are in lowest form."""
    typed = set(re.findall(r"\d+", statement))
    whole = figure(solution)
    for scene in (*scenes(solution), *([whole] if whole is not None else [])):
        for label in scene.labels:
            shown = to_text(label.content)
            if "𝐢" in shown or "𝐣" in shown:  # a vector as it is given
                continue
            long = [each for each in re.findall(r"\d+", shown) if len(each) >= 4]
            assert not set(long) - typed, shown
            assert "√(" not in shown, shown  # a root of a sum, or of a root
            assert not re.search(r"− ?\(.*°|°.*− ?\(|−−|^−\d", shown), shown
            # Numbers of degrees are worked out: no 180° − 30°.
            assert len(re.findall(r"\d+°", shown)) <= 1, shown
            assert not re.search(r"√.*(sin|cos)|(sin|cos).*(sin|cos)", shown), shown


def check_letters(solution: Solution, working: str) -> None:
    """A letter that the working brings in for a component names the same one in the figure."""
    owners: dict[str, set[str]] = {}
    for letters, *bodies in LET.findall(" ".join(working.split())):
        for letter, body in zip(letters.split(" and "), bodies, strict=False):
            owners.setdefault(letter, set()).add(body)
    for part in solution.parts.values():
        for branch in part.branches:
            for (_, body), each in motion(solution, part, branch).model.components.items():
                letter = to_text(lay.from_sympy(each.symbol))
                assert body in owners.get(letter, {body}), (letter, owners)


@law(EXAMPLES)
def labels_are_in_lowest_form(path: Path) -> None:
    check_forms(solved(path), path.read_text(encoding="utf-8"))


@law(EXAMPLES)
def letters_of_components_are_those_of_the_working(path: Path) -> None:
    check_letters(solved(path), str(explained(path)))
