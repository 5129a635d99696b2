"""The package's front door: light, lazy, and the same whatever was imported first."""

from __future__ import annotations

import ast
import itertools
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

import restitution

HEAVY = ("sympy", "lark", "numpy", "typer", "rich", "ziamath", "mpmath", "numba")
COMPILED = ("numba", "llvmlite", "pyarrow", "distributed")
NAMESAKES = ("impact", "solve", "explain")


def run(code: str) -> str:
    """What a fresh interpreter prints."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code],
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_import_loads_nothing_heavy():
    assert run(f"import sys, restitution; print([m for m in {HEAVY} if m in sys.modules])") == "[]"


def test_naming_what_is_offered_loads_nothing_heavy():
    code = f"import sys, restitution as r; dir(r); r.__version__; r.Sphere('A'); r.Vector(1, 2);\
    print([m for m in {HEAVY} if m in sys.modules])"
    assert run(code) == "[]"


THROW = """
P = r.Sphere("P", mass=1, position=(1, 1), velocity=(1, 2))
found = r.simulate(r.Table.box(4, 3, [P], e="1/2"), impacts=3)
"""
STATEMENT = r"""
text = "sphere P: velocity i\nwall W: along j\nP hits W: e = 1\nfind velocity(P)"
"""


@pytest.mark.parametrize(
    ("code", "unused"),
    [
        ("import restitution.motion", HEAVY),
        (f"{THROW}r.play(found).html", ("sympy", "numpy", *COMPILED)),
        ("r.Gas.fluid(50, 0.2, seed=1).run(impacts=100)", ("sympy", *COMPILED)),
        (f"{STATEMENT}r.play(r.solve(r.parse(text))).html", COMPILED),
    ],
    ids=["motion", "few", "gas", "player"],
)
def test_motion_loads_what_it_needs(code, unused):
    told = f"import sys; print([m for m in {unused} if m in sys.modules])"
    assert run(f"import restitution as r\n{code}\n{told}") == "[]"


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are no copies here")
@pytest.mark.parametrize("module", sorted(set(restitution._MODULE_OF_NAME.values())))
def test_every_name_is_there(outcomes, module):
    """A process for each module: no name rests on what another has loaded."""
    assert set(offered(module)) <= set(dir(restitution))
    assert outcomes[named(module)] == "good"


def test_the_version_is_there():
    assert "__version__" in dir(restitution)
    assert sorted([*restitution._MODULE_OF_NAME, "__version__"]) == sorted(restitution.__all__)


def test_unknown_name():
    with pytest.raises(AttributeError, match="no attribute 'colour'"):
        _ = restitution.colour


BEFORE = [
    "import restitution",
    "import restitution.{0}",
    "import restitution.{0} as module",
    "from restitution.{0} import {0} as again",
    "import importlib; importlib.import_module('restitution.{0}')",
    "from restitution import {0}",
    "from restitution import *",
    "import restitution; restitution.{0}; import restitution.{0}",
]


def looked_up(name: str, before: str) -> str:
    return f"""{before.format(name)}
import importlib, pickle, sys, types
import restitution as r
from restitution import {name} as found
assert isinstance(r.{name}, types.FunctionType), r.{name}
assert found is r.{name}
module = importlib.import_module("restitution.{name}")
assert isinstance(module, types.ModuleType) and module.{name} is found
assert pickle.loads(pickle.dumps(found)) is found
print("good")"""


def imported(order: tuple[str, ...]) -> str:
    imports = "; ".join(f"import restitution.{name}" for name in order)
    names = ", ".join(f"type(restitution.{name}).__name__" for name in NAMESAKES)
    return f"{imports}; print({{{names}}})"


def offered(module: str) -> list[str]:
    return [name for name, own in restitution._MODULE_OF_NAME.items() if own == module]


def named(module: str) -> str:
    wanted = ", ".join(f"r.{name}" for name in offered(module))
    return f"""import restitution as r, types
assert not any(isinstance(one, types.ModuleType) for one in [{wanted}])
print("good")"""


ORDERS = list(itertools.permutations(NAMESAKES))
# The normal run looks at each way to import, and at each function; the nightly one at all pairs.
PAIRS = [
    pytest.param(name, before, marks=() if (n + k) % len(NAMESAKES) == 0 else pytest.mark.nightly)
    for n, name in enumerate(NAMESAKES)
    for k, before in enumerate(BEFORE)
]
FORKING = """\
import io, json, os, sys, traceback, warnings
import lark, mpmath, numpy, sympy
for line in sys.stdin:
    code = json.loads(line)
    end, beginning = os.pipe()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore") # numpy has threads, none of which is at work
        child = os.fork()
    if not child:
        os.dup2(beginning, 1)
        os.dup2(beginning, 2)
        warnings.simplefilter("error")
        try:
            exec(code, {"__name__": "__main__"})
        except BaseException:
            traceback.print_exc()
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)
    os.close(beginning)
    with os.fdopen(end) as file:
        print(json.dumps(file.read().strip()), flush=True)
    os.waitpid(child, 0)
    assert not [name for name in sys.modules if name.startswith("restitution")]
"""


class Outcomes(dict[str, str]):
    """What pieces of code print in processes that have loaded nothing of this package.

    Each process is a copy of one that has the libraries, as these take most of the time.
    """

    def __init__(self) -> None:
        self.parent = subprocess.Popen(
            [sys.executable, "-c", FORKING],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            bufsize=1,
        )

    def __missing__(self, code: str) -> str:
        assert self.parent.stdin is not None and self.parent.stdout is not None
        self.parent.stdin.write(json.dumps(code) + "\n")
        self[code] = json.loads(self.parent.stdout.readline())
        return self[code]

    def close(self) -> None:
        self.parent.communicate()


@pytest.fixture(scope="module")
def outcomes():
    """What each piece of code prints, asked when a test wants to know."""
    every = Outcomes()
    yield every
    every.close()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are no copies here")
@pytest.mark.parametrize(("name", "before"), PAIRS)
def test_function_is_not_hidden_by_the_module_of_its_name(outcomes, name, before):
    assert outcomes[looked_up(name, before)] == "good"


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are no copies here")
@pytest.mark.parametrize(
    "order",
    [ORDERS[0], ORDERS[-1], *(pytest.param(o, marks=pytest.mark.nightly) for o in ORDERS[1:-1])],
)
def test_functions_in_every_order_of_import(outcomes, order):
    assert outcomes[imported(order)] == "{'function'}"


def test_what_type_checkers_see_is_what_is_offered():
    """The imports under TYPE_CHECKING, the table of names and ``__all__`` say the same."""
    tree = ast.parse(Path(restitution.__file__).read_text(encoding="utf-8"))
    seen = {
        alias.name: node.module
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module and "restitution." in node.module
        for alias in node.names
    }
    offered = {name: f"restitution.{module}" for name, module in table().items()}
    assert seen == offered
    assert sorted([*offered, "__version__"]) == sorted(restitution.__all__)


def table() -> dict[str, str]:
    return restitution._MODULE_OF_NAME


def test_modules_that_moved_answer_to_their_first_names() -> None:
    import restitution.batch.ensemble
    import restitution.gas
    import restitution.motion.ensemble
    import restitution.motion.gas

    first, now = restitution.motion.ensemble, restitution.batch.ensemble
    assert first.EnsembleInterrupt is now.EnsembleInterrupt
    assert restitution.motion.gas.write is restitution.gas.write
