"""What a line declares of its letters: ``let v be the speed of A after, and w that of B``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

from restitution.expression.tree import Expression, Letter, Negate, is_function
from restitution.practice.reading.phrases import read_phrase
from restitution.practice.reading.tokens import Token, Usage
from restitution.practice.script import Declaration
from restitution.problem import Problem

_HAVING = re.compile(
    r"\b([A-Z]\w*)\s+(?:have|has|having|moves?\s+with|moves?\s+at|travels?\s+(?:at|with)|with)\s+"
    r"(?:an?\s+|the\s+|final\s+|new\s+)?(speed|velocity)\s+([A-Za-z](?:_?\w)?)(?![\w(])"
    r"(?:\s*,?\s*(?:and|,)\s*([A-Z]\w*)\s+([A-Za-z](?:_?\w)?)(?![\w(]))?"
)
_THAT_OF = re.compile(r"\b([A-Za-z](?:_?\w)?)\s+(?:=\s*|is\s+|be\s+)?that\s+of\s+([A-Z]\w*)")


class Declarations:
    """The declarations of a line; ``body`` is the sphere that labels the line."""

    def __init__(self, usage: Usage, problem: Problem) -> None:
        self.usage, self.problem = usage, problem
        self.declarations: tuple[Declaration, ...] = ()
        self.body: str | None = None
        self.shared: Token | None = None
        self.bodies = tuple(sphere.name for sphere in problem.spheres)

    def declare_all(self, declared: Sequence[Letter], token: Token) -> None:
        """``v and w = the speeds of A and B``: each letter with its body."""
        words = token.name.split()
        bodies = [word for word in words if word in self.usage.spheres]
        self.shared = token
        if len(declared) > 1 and not bodies and len(declared) == len(self.bodies):
            bodies = list(self.bodies)
            words = [*words, "of", *bodies]
        if len(declared) == 1 or len(bodies) != len(declared):
            self.declare(declared[-1], token)
            return
        for letter, body in zip(declared, bodies):
            kept = [word for word in words if word not in self.usage.spheres or word == body]
            self.declare(letter, replace(token, name=" ".join(kept)))

    def declare(self, letter: Letter, token: Token) -> None:
        """Adds the meaning of a letter given in words."""
        words = token.name
        body = self.body
        if body and not self.usage.spheres & set(words.split()):
            words = f"{words} of {body}"
        meanings = _with_senses(read_phrase(words, self.problem))
        self.add(Declaration(letter.name, meanings, token.text))

    def another(self, letter: Letter, words: AbstractSet[str]) -> bool:
        """A further letter of a phrase: ``let the components after be v and w``."""
        declared = self.declarations
        if self.shared is None or not declared or not words <= {"and", ","}:
            return False
        place = len(declared)
        names = self.usage.spheres & set(self.shared.name.split())
        if names or place >= len(self.bodies):
            return False
        if place == 1:
            first = f"{self.shared.name} of {self.bodies[0]}"
            meanings = _with_senses(read_phrase(first, self.problem))
            self.declarations = (replace(declared[0], meanings=meanings),)
        name = f"{self.shared.name} of {self.bodies[place]}"
        self.declare(letter, replace(self.shared, name=name))
        return True

    def that_of(self, text: str) -> None:
        """``w that of B``: the last declaration once more, for another body."""
        match = _THAT_OF.search(text)
        declared = self.declarations
        if match is None or not declared or self.shared is None:
            return
        if match[2] in self.usage.spheres and match[1] != declared[-1].letter:
            words = [word for word in self.shared.name.split() if word not in self.usage.spheres]
            name = " ".join((*words, "of", match[2]))
            self.declare(Letter(match[1]), replace(self.shared, name=name))

    def having(self, text: str) -> None:
        """``let B have speed p and C q``: letters behind the bodies that have them."""
        when = " after" if re.search(r"\b(after|final|new|rebound)", text) else ""
        for match in _HAVING.finditer(text):
            body, noun, letter, *other = match.groups()
            for name, own in ((body, letter), tuple(other)):
                if name in self.usage.spheres and own and own not in self.usage.letters:
                    words = f"{noun} of {name}{when}"
                    meanings = _with_senses(read_phrase(words, self.problem))
                    self.add(Declaration(own, meanings, match[0]))

    def add(self, declaration: Declaration) -> None:
        """Adds a declaration."""
        self.declarations += (declaration,)


def _with_senses(meanings: Sequence[Expression]) -> tuple[Expression, ...]:
    """The meanings of a declared letter; a speed may be a component of either sense as well.

    Who says *let the speeds after be v and w* goes on with momentum, and with v < 0.
    """
    inside = [meaning.argument for meaning in meanings if is_function(meaning, "abs")]
    signed = (sense for tree in inside for sense in (tree, Negate(tree)))
    return tuple(dict.fromkeys((*meanings, *signed)))
