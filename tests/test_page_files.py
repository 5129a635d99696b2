"""The page's own files, as text: nothing stands in them that nothing uses."""

from __future__ import annotations

import posixpath
import re
from importlib.resources import files
from pathlib import Path

PACKAGE = Path(str(files("restitution")))
STATIC = PACKAGE / "web/static"
PLAYER = PACKAGE / "export/player"


def texts(folder: Path, pattern: str, under: str = "") -> dict[str, str]:
    """Files by the path under which they are served."""
    return {
        f"{under}{path.relative_to(folder).as_posix()}": path.read_text(encoding="utf-8")
        for path in sorted(folder.rglob(pattern))
    }


MODULES = {**texts(STATIC, "*.js"), **texts(PLAYER, "*.js", "player/")}
SHEETS = {**texts(STATIC, "*.css"), **texts(PLAYER, "*.css", "player/")}
IMPORT = re.compile(r'^import \{([^}]*)\} from "([^"]+)";', re.MULTILINE)
EXPORT = re.compile(r"^export (?:async )?(?:const|function|class) (\w+)", re.MULTILINE)


def imports(name: str) -> list[tuple[str, str]]:
    """What a module imports: (module, name)."""
    return [
        (posixpath.normpath(posixpath.join(posixpath.dirname(name), where)), each.strip())
        for names, where in IMPORT.findall(MODULES[name])
        for each in names.split(",")
        if each.strip()
    ]


def test_whatever_is_imported_is_exported_and_used():
    for name, text in MODULES.items():
        for module, each in imports(name):
            assert each in EXPORT.findall(MODULES[module]), (name, each)
            used = re.findall(rf"(?:\.\.\.|(?<![\w.])){each}\b", text)
            assert len(used) > 1, (name, each)


def test_whatever_is_exported_is_imported():
    imported = {each for name in MODULES for each in imports(name)}
    # What is fetched when it is first wanted.
    later = {
        *re.findall(r"\(\{ (mount\w+) \}, body", MODULES["solve/main.js"]),
        *re.findall(r"module\.(mount)\(", MODULES["solve/motion.js"]),
    }
    assert len(later) == 4
    for module, text in MODULES.items():
        for name in EXPORT.findall(text):
            assert (module, name) in imported or name in later, (module, name)


def test_every_style_is_of_something():
    """A class or an id that a sheet names is written by a module, a template or a renderer."""
    pages = texts(PACKAGE / "web/templates", "*.html")
    writers = [
        text
        for folder in ("render/document", "export")
        for text in texts(PACKAGE / folder, "*.py").values()
    ]
    written = "\n".join([*MODULES.values(), *pages.values(), *writers])
    words = set(re.findall(r"[A-Za-z][\w-]*", written))
    for sheet, text in SHEETS.items():
        selectors = re.findall(r"([^{};]+)\{", re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL))
        named = {
            each
            for selector in selectors
            if not selector.strip().startswith("@")
            for each in re.findall(r"[.#]([A-Za-z][\w-]*)", selector)
        }
        assert named
        # body0 to body5 are the colours of bodies.
        known = {each for each in named if re.sub(r"^(body)\d$", r"\1", each) in words}
        assert named - known == set(), sheet


def test_every_file_says_what_it_is():
    for name, text in MODULES.items():
        assert text.startswith("// "), name
    for name, text in SHEETS.items():
        assert text.startswith("/* "), name
