"""Writes the page of the objects of JSON: ``uv run python scripts/api_objects.py``.

They are the TypedDicts of the package, each field with its type and the text that stands under it.
"""

from __future__ import annotations

import ast
import inspect
import itertools
import types
import typing
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, Literal, get_args, get_origin, get_type_hints, is_typeddict

from restitution.explaining.lines import stored
from restitution.export import objects
from restitution.practice.marking import objects as marking

ROOT = Path(__file__).parent.parent
PAGE = ROOT / "docs/api-objects.md"
MODULES = (objects, stored, marking)
TITLES = ("Answers, pieces, pictures and pages", "The working as data", "Marking")
INTRODUCTION = """# The objects of the API

Every object that [the page's API](api.md) and `--format json` write, with the type of each field. \
`scripts/api_objects.py` writes this page from the types in the code, and the tests hold what is \
sent against the same types.

A field has a value of JSON: *text*, *number*, *whole number*, *true or false*, a list, or an \
object of another table. "any" is a tree of elements where the text says so, and else plain data.
"""
NAMES = {
    str: "text",
    int: "whole number",
    float: "number",
    bool: "true or false",
    type(None): "null",
    Any: "any",
}
_PLURALS = {str: "texts", int: "whole numbers", float: "numbers"}


def page() -> str:
    """The page as it has to be."""
    sections = [
        f"## {title}\n\n" + "\n".join(_section(each) for each in _objects(module))
        for module, title in zip(MODULES, TITLES, strict=True)
    ]
    return "\n".join([INTRODUCTION, *sections])


def _objects(module: types.ModuleType) -> list[type]:
    """The objects of a module, in the order in which they stand there."""
    own = [each for each in vars(module).values() if is_typeddict(each)]
    return [
        each
        for each in own
        if each.__module__ == module.__name__ and not each.__name__.startswith("_")
    ]


def _section(of: type) -> str:
    rows = "\n".join(f"| `{name}` | {_type(hint)} | {text} |" for name, hint, text in _fields(of))
    words = inspect.cleandoc(of.__doc__ or "").replace("``", "`").replace("\n", " ")
    return f"### {of.__name__}\n\n{words}\n\n| field | type | |\n|---|---|---|\n{rows}\n"


def _fields(of: type) -> Iterator[tuple[str, Any, str]]:
    """Name, type and text of each field: those of a base first."""
    texts = _texts(of.__name__)
    for name, hint in get_type_hints(of).items():
        yield name, hint, texts.get(name, "").replace("``", "`").replace("|", "\\|")


@cache
def _classes() -> dict[str, ast.ClassDef]:
    """All classes of the modules, as they are written: a TypedDict does not know its bases."""
    return {
        node.name: node
        for module in MODULES
        for node in ast.parse(inspect.getsource(module)).body
        if isinstance(node, ast.ClassDef)
    }


def _texts(name: str) -> dict[str, str]:
    """The texts that stand under the fields of a class and of its bases, by name."""
    written = _classes().get(name)
    if written is None:
        return {}
    texts: dict[str, str] = {}
    for base in written.bases:
        if isinstance(base, ast.Name):
            texts |= _texts(base.id)
    for field, text in itertools.pairwise(written.body):
        match field, text:
            case (
                ast.AnnAssign(target=ast.Name(id=own)),
                ast.Expr(value=ast.Constant(value=str(words))),
            ):
                texts[own] = " ".join(words.split())
    return texts


def _type(hint: Any) -> str:
    if hint in NAMES:
        return NAMES[hint]
    if is_typeddict(hint):
        return f"[{hint.__name__}](#{hint.__name__.lower()})"
    origin, own = get_origin(hint), get_args(hint)
    if origin in (typing.Union, types.UnionType):
        return " or ".join(_type(each) for each in own)
    if origin is Literal:
        return ", ".join(f"`{each}`" for each in own)
    if origin is list:
        return f"list of {_PLURALS.get(own[0]) or _type(own[0])}"
    if origin is dict:
        return f"object: {_type(own[1])} by name"
    raise TypeError(f"no words for {hint!r}")


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
