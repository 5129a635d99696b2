"""What must hold for the files of the project, whatever they say."""

from __future__ import annotations

import ast
import re
import shutil
import subprocess
import tomllib
from collections.abc import Iterator
from importlib.metadata import metadata
from pathlib import Path

import pytest

import restitution

ROOT = Path(__file__).resolve().parent.parent
SOURCES = sorted((ROOT / "src").rglob("*.py"))
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))

# Put together here, so that this file does not name them either.
REGISTRIES = [
    ".".join(parts)
    for parts in (
        ("pypi", "org"),
        ("files", "pythonhosted", "org"),
        ("registry", "npmjs", "org"),
        ("registry", "yarnpkg", "com"),
        ("cdn", "jsdelivr", "net"),
        ("unpkg", "com"),
        ("cdnjs", "cloudflare", "com"),
        ("crates", "io"),
        ("proxy", "golang", "org"),
        ("conda", "anaconda", "org"),
    )
]


def tracked_files() -> list[Path]:
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("not a checkout")
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    if listed.returncode:
        pytest.skip("not a checkout that git reads")
    return [path for name in listed.stdout.split("\0") if name and (path := ROOT / name).is_file()]


def test_no_file_names_a_host_of_packages():
    """What is fetched, and from where, is decided by the machine that fetches."""
    named = re.compile("|".join(map(re.escape, REGISTRIES)).encode(), re.IGNORECASE)
    found = [path for path in tracked_files() if named.search(path.read_bytes())]
    assert found == []


def test_files_are_text_in_utf8_with_unix_lines():
    suffixes = {".py", ".pyi", ".md", ".toml", ".impact", ".html", ".css", ".js"}
    for path in tracked_files():
        if path.suffix in suffixes:
            assert "\r" not in path.read_bytes().decode("utf-8"), path


def test_one_version():
    assert restitution.__version__ == PYPROJECT["project"]["version"]
    assert metadata("restitution")["Version"] == restitution.__version__


def test_changelog_tells_of_this_version():
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    headings = re.findall(r"^## (\S+)", changelog, re.MULTILINE)
    assert headings and (headings[0] == "Unreleased" or headings[0] == restitution.__version__)


def test_every_dependency_is_pinned_for_development():
    """Whoever clones the project gets the versions it was tested with."""
    pinned = {
        re.split(r"[=\[ ;]", line)[0].lower()
        for line in PYPROJECT["tool"]["uv"]["constraint-dependencies"]
    }
    groups = PYPROJECT["dependency-groups"]["dev"]
    extras = PYPROJECT["project"].get("optional-dependencies", {}).values()
    wanted = [*PYPROJECT["project"]["dependencies"], *groups]
    wanted += [each for extra in extras for each in extra]
    names = {re.split(r"[<>=~!\[ ;]", each)[0].lower() for each in wanted if isinstance(each, str)}
    assert names - pinned - {"restitution"} == set()


CALLS = re.compile(r"\b(?:eval|exec|compile|sympify|S|parse_expr|parse_latex)\b")


@pytest.mark.parametrize(
    "path",
    [path for path in SOURCES if CALLS.search(path.read_text(encoding="utf-8"))],
    ids=lambda path: str(path.relative_to(ROOT / "src")),
)
def test_nothing_executes_text(path):
    """A user's text is read by a grammar: SymPy's readers of text execute it."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.Call):
            continue
        where = f"{path.name}, line {node.lineno}"
        method = isinstance(node.func, ast.Attribute)
        name = node.func.attr if method else getattr(node.func, "id", "")
        assert name not in {"parse_expr", "parse_latex"}, where
        assert method or name not in {"eval", "exec", "compile"}, where
        if name in {"sympify", "S"}:
            strict = any(
                each.arg == "strict" and getattr(each.value, "value", None) is True
                for each in node.keywords
            )
            numbers = all(isinstance(getattr(x, "value", None), int | float) for x in node.args)
            assert strict or numbers, f"{where}: sympify without strict=True"


def test_contributing_names_files_that_are_there():
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    named = re.findall(r"`((?:src|tests|scripts|benchmarks)/[\w/.]+)`", text)
    assert len(named) > 20
    assert [each for each in named if not (ROOT / each).exists()] == []


# Words that say how a value came about, or that it is one of several, but not what it is.
NO_NAMES = {"each", "told", "found", "said", "laid", "made", "way"}
FORBIDDEN = re.compile(rf"\b_?(?:{'|'.join(NO_NAMES)})\b")
SPOKEN = re.compile(r"\"\"\".*?\"\"\"", re.DOTALL)


def names_given(tree: ast.AST) -> Iterator[tuple[str, int]]:
    """The names that a module gives: to values, arguments, functions and classes."""
    for node in ast.walk(tree):
        match node:
            case ast.Name(name, ast.Store()) | ast.arg(name):
                yield name, node.lineno
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                yield name, node.lineno
            case ast.MatchAs(name=str(name)) | ast.MatchStar(name=str(name)):
                yield name, node.lineno
            case ast.ExceptHandler(name=str(name)) | ast.alias(asname=str(name)):
                yield name, node.lineno


def test_values_are_called_by_what_they_are():
    wrong = []
    for path in SOURCES:
        text = path.read_text(encoding="utf-8")
        wrong += [str(path.relative_to(ROOT))] if "each" in path.stem.split("_") else []
        if path.name == "objects.py" or not FORBIDDEN.search(SPOKEN.sub("", text)):
            continue  # what the API replies keeps its names
        wrong += [
            f"{path.relative_to(ROOT)}:{line}: {name}"
            for name, line in names_given(ast.parse(text))
            if name.removeprefix("_") in NO_NAMES or "each" in name.split("_")
        ]
    assert wrong == []


# What has a function of its own is not written out: `unsigned` and `negated`, `is_quantity`,
# `is_binary` and `is_function` of a tree, `line` and `fact` of what is cited.
WRITTEN_OUT = re.compile(
    r"isinstance\(([\w.]+), (?:Quantity|Binary|Apply)\) and \1\.(?:kind|op|function) == "
    r"|([\w.]+)\.operand if isinstance\(\2, Negate\) else (?:\2\b|Negate)"
    r"|derivation\.(?:line|fact)\((\w+)\) if isinstance\(\3, "
)
WHERE_THEY_STAND = {"expression/tree.py", "explaining/lines/derivation.py"}


def test_what_has_a_function_is_not_written_out():
    package = ROOT / "src" / "restitution"
    wrong = [
        f"{path.relative_to(package)}: {match.group()}"
        for path in SOURCES
        if str(path.relative_to(package)) not in WHERE_THEY_STAND
        for match in WRITTEN_OUT.finditer(path.read_text(encoding="utf-8"))
    ]
    assert wrong == []


def imports_of(path: Path, modules: set[str]) -> set[str]:
    """The modules that one imports, also where only type checkers or a function see it."""
    imported = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            imported |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            inside = {f"{node.module}.{alias.name}" for alias in node.names}
            imported |= inside & modules or {node.module}
    return imported & modules


def test_no_modules_import_each_other():
    """Imports go one way between modules too, not only between packages."""
    package = ROOT / "src" / "restitution"
    modules = {
        ".".join(path.relative_to(ROOT / "src").with_suffix("").parts).removesuffix(
            ".__init__"
        ): path
        for path in sorted(package.rglob("*.py"))
    }
    # The front door names everything that it offers, for type checkers.
    graph = {
        name: imports_of(path, set(modules)) - {name, "restitution"}
        for name, path in modules.items()
        if name != "restitution"
    }
    while without := {name for name, imported in graph.items() if not imported & graph.keys()}:
        graph = {name: imported for name, imported in graph.items() if name not in without}
    while unused := graph.keys() - set().union(*graph.values()):
        graph = {name: imported for name, imported in graph.items() if name not in unused}
    assert sorted(graph) == [], "these import each other, or stand between such"
