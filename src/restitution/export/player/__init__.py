"""A motion as a page that plays it: inline SVG and one ES module, nothing from elsewhere.

The module is made of those beside this file, which pages of a server load as they are.
"""

from __future__ import annotations

import json
import re
from html import escape
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from restitution.records import dataclass
from restitution.render.page import page

if TYPE_CHECKING:
    from restitution.motion import Run
    from restitution.motion.pieces import Motion
    from restitution.solving.equations.solution import Solution

__all__ = ["Playable", "play", "to_html"]

_PAGE = (
    "html { background: #fff } @media (prefers-color-scheme: dark) "
    "{ html { background: #17181c } } body { margin: 0 }"
)
# The last lines of the module: they start the player of the page.
_START = """
mount(
  document.getElementById("player"),
  JSON.parse(document.getElementById("motion").textContent),
  { page: true },
);
"""
# The modules, each after those that it imports.
_MODULES = (
    *("elements", "controls", "keys", "numbers", "motion", "clock", "picture", "tables"),
    *("transport", "player"),
)
_IMPORT = re.compile(r'^import \{[^}]*\} from "\./\w+\.js";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export (?=(?:class|const|function) )", re.MULTILINE)
_HEIGHT = 720  # pixels that a notebook gives it


@dataclass(frozen=True)
class Playable:
    """A motion, or several to choose from, as data for the player. It shows itself in Jupyter.

    ``data`` is plain (numbers, texts, lists, dictionaries), as `restitution.export.player.data`
    describes it; ``html`` is one page that needs nothing else.
    """

    data: dict[str, Any]

    @property
    def html(self) -> str:
        """The page, to be written into a file."""
        return to_html(self.data)

    def _repr_html_(self) -> str:
        """For Jupyter: the page in a frame of its own, which can touch nothing around it."""
        title = escape(self.data["title"] or "Motion")
        return (
            f'<iframe title="{title}" sandbox="allow-scripts" srcdoc="{escape(self.html)}" '
            f'style="width: 100%; height: {_HEIGHT}px; border: 0"></iframe>'
        )


def play(
    motion: Solution | Motion | Run,
    part: str | None = None,
    *,
    seconds: float | None = None,
    as_: str | None = None,
) -> Playable:
    """The motion of a solved problem (of all its parts, or the one with that label), or another.

    After so many ``seconds`` spent on exact values of a problem, what is left of them is given as
    decimals only, and a note says so. Letters of a problem are at
    representative values, which the page tells. With ``as_``, the id of a mistake such as
    ``restitution-parallel`` or of one of its variants, the motion in its world is played beside it.

    Raises TypeError for anything else, KeyError for a part that is not there, what kept the
    problem from being solved, and UnsupportedError with the reason where no motion can be shown.
    """
    from restitution.export.player.data import of_motion, of_solution
    from restitution.motion import Run
    from restitution.motion.pieces import Motion

    if isinstance(motion, Run):
        return Playable(of_motion(motion.motion()))
    if isinstance(motion, Motion):
        return Playable(of_motion(motion))
    from restitution.solving.equations.solution import Solution  # no algebra for the others

    if not isinstance(motion, Solution):
        raise TypeError(
            f"play takes a Solution, a Motion or a Run, and not {type(motion).__name__}: "
            "restitution.solve(problem) makes one"
        )
    if as_ is not None:
        from restitution.export.player.beside import of_mistake

        return Playable(of_mistake(motion, as_, part, seconds))
    return Playable(of_solution(motion, part, seconds))


def to_html(data: dict[str, Any]) -> str:
    """One page that plays the data: style, module and data stand in it."""
    # In JSON a < can only be within a text, where it may be written so.
    script = json.dumps(data, ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")
    body = (
        '<main id="player"><noscript>This page plays a motion with JavaScript.</noscript></main>\n'
        f'<script type="application/json" id="motion">{script}</script>\n'
        f'<script type="module">\n{module()}{_START}</script>'
    )
    return page(data["title"] or "Motion", _PAGE + source("player.css"), body)


def source(name: str) -> str:
    """The text of a file of the player, such as ``player.css``."""
    return (files(__package__) / name).read_text(encoding="utf-8")


def module() -> str:
    """The modules of the player as one, without what they import from each other."""
    *parts, last = (_IMPORT.sub("", source(f"{name}.js")) for name in _MODULES)
    return "\n".join([*(_EXPORT.sub("", part) for part in parts), last])
