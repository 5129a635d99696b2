"""What is not loaded before a question asks for it, and that it comes when somebody does.

Each is looked at in an interpreter of its own, since all is loaded in this one.
"""

from __future__ import annotations

import subprocess
import sys

TENSORS = """
import sys
from restitution.export.algebra import without_tensors
without_tensors()
import sympy
assert sympy.Symbol("x") + 1 - 1 == sympy.Symbol("x")
own = sys.modules["sympy.tensor.tensor"]
assert not hasattr(own, "__path__") and own.__spec__ is None
from sympy.tensor.tensor import TensorHead
assert TensorHead("A", []).name == "A"
"""


def test_tensors_come_when_they_are_asked_for() -> None:
    subprocess.run([sys.executable, "-c", TENSORS], check=True)


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
