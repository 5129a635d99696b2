"""Statements that come with the package, named for what they show.

Each is a file ``NAME.impact`` in the statement language. At its end stand its answers, found
by hand or taken from published work, one comment line for each item in the order asked:
``#= ITEM -> ANSWER`` (``;`` between several admissible solutions), ``#! rejected: …`` for a
root that cannot be, and ``# source: …``.
"""

from __future__ import annotations

from difflib import get_close_matches
from importlib.resources import files

from restitution.errors import StatementError

_SUFFIX = ".impact"


def names() -> tuple[str, ...]:
    """The names of all examples, in alphabetical order."""
    files_ = (file.name for file in files(__name__).iterdir())
    return tuple(sorted(name.removesuffix(_SUFFIX) for name in files_ if name.endswith(_SUFFIX)))


def text(name: str) -> str:
    """The statement of the example ``name``, with or without ``.impact``.

    Raises StatementError, with the nearest name, where there is no such example.
    """
    wanted = name.removesuffix(_SUFFIX)
    # Looked up in the list, never joined to a path: a name such as "../x" opens nothing.
    known = names()
    if wanted not in known:
        raise StatementError(_unknown(wanted, known))
    return files(__name__).joinpath(wanted + _SUFFIX).read_text(encoding="utf-8")


def title(name: str) -> str:
    """What the example ``name`` shows, in a few words."""
    lines = text(name).splitlines()
    return next((line[6:].strip() for line in lines if line.startswith("title ")), name)


def statement(name: str) -> str:
    """The example ``name`` without its answers and their source."""
    lines = text(name).splitlines()
    kept = [line for line in lines if not line.startswith(("#=", "#!", "# source:"))]
    return "\n".join(kept).strip() + "\n"


def _unknown(wanted: str, known: tuple[str, ...]) -> str:
    folded = wanted.strip().lower().replace("_", "-").replace(" ", "-")
    near = get_close_matches(folded, known, n=1, cutoff=0.5)
    if not near and folded:
        near = [name for name in known if folded in name][:1]
    shown = wanted if len(wanted) <= 60 else wanted[:60] + "…"
    hint = f"; did you mean {near[0]}?" if near else "; `restitution examples` lists them all"
    return f"there is no example named {shown!r}{hint}"
