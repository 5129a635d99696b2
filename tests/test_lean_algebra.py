"""SymPy loaded as far as the work needs it: its names are the same, and the rest comes when asked.

Each is looked at in an interpreter of its own, since SymPy is loaded whole in this one.
"""

from __future__ import annotations

import subprocess
import sys

import pytest

BEGIN = """
import sys
from restitution.export.algebra import load_algebra
load_algebra()
import sympy
def loaded(name):
    return f"sympy.{name}" in sys.modules
assert loaded("polys") and not loaded("geometry") and not loaded("solvers")
"""

NAMES = """
import ast
from pathlib import Path
rest = next(each for each in sys.meta_path if type(each).__name__ == "_Rest")
exported = [
    (alias.asname or alias.name)
    for node in ast.parse(Path(sympy.__file__).read_text()).body
    if isinstance(node, ast.ImportFrom) and node.level == 1
    for alias in node.names
]
rest._waiting = False
lean = {name: getattr(sympy, name) for name in exported if hasattr(sympy, name)}
rest._waiting = True
table = set(sys.modules["sympy.core.evalf"].evalf_table)
assert len(lean) > 600
assert callable(sympy.solve) and loaded("geometry")
assert [name for name, value in lean.items() if getattr(sympy, name) is not value] == []
assert set(sys.modules["sympy.core.evalf"].evalf_table) == table
"""

PACKAGE = """
import sympy.geometry
assert sympy.geometry.Point is sympy.Point and loaded("solvers")
assert sympy.geometry.__spec__.origin
"""

STAR = """
from sympy import *
x = Symbol("x")
assert solve(x**2 - 4) == [-2, 2] and Point(1, 2).x == 1
"""

TENSORS = """
from sympy.tensor.tensor import TensorHead
assert TensorHead("A", []).name == "A"
"""

ABSENT = """
try:
    sympy.no_such_name
except AttributeError as error:
    assert "no_such_name" in str(error) and loaded("solvers")
else:
    raise AssertionError
assert sympy.__version__
"""


CODES = {"names": NAMES, "package": PACKAGE, "star": STAR, "tensors": TENSORS, "absent": ABSENT}


@pytest.mark.parametrize("name", CODES)
def test_rest_of_the_algebra_comes_when_it_is_asked_for(name: str) -> None:
    code = CODES[name]
    subprocess.run([sys.executable, "-c", BEGIN + code], check=True)


WORK = """
from restitution import examples, explain, parse, solve
print(explain(solve(parse(examples.text(sys.argv[1])))))
"""


@pytest.mark.parametrize("name", ["corner", "never-steeper"])
def test_working_is_the_same_with_what_is_loaded(name: str) -> None:
    lean, whole = (
        subprocess.run(
            [sys.executable, "-c", begin + WORK, name], check=True, capture_output=True
        ).stdout
        for begin in (BEGIN, "import sys, sympy")
    )
    assert lean == whole
    assert lean


PREPARED = """
import sys
from restitution.export.job import prepare
prepare()
assert "restitution.planning.planner" in sys.modules
seldom = ("planning.shows.forward", "planning.inequalities.extrema", "solving.equations.clash",
          "explaining.following.tracing", "render.document.html", "solving.story.alteration")
assert [name for name in seldom if f"restitution.{name}" in sys.modules] == []
"""


def test_what_few_questions_need_is_loaded_for_them_alone() -> None:
    subprocess.run([sys.executable, "-c", PREPARED], check=True)
