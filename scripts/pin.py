"""Write the exact versions of all that is installed into pyproject.toml.

    uv run python scripts/pin.py             keep today's versions, pin what is new
    uv run python scripts/pin.py --upgrade   take the newest versions that fit

The versions stand under ``[tool.uv]`` as ``constraint-dependencies``, and once more as
``build-constraint-dependencies`` for what builds the package: everyone who clones the project gets
the same, while those who install the package are held to its ranges only. The lock file is not
kept, as it names the host that the packages came from.
"""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

PYPROJECT = Path(__file__).resolve().parent.parent / "pyproject.toml"
TABLE = "[tool.uv]\n"
PINS = re.compile(r"^(?:build-)?constraint-dependencies = \[\n(?:.*\n)*?\]\n", re.MULTILINE)


def main(arguments: list[str]) -> None:
    """Pin; the file is restored if no set of versions can be found."""
    before = PYPROJECT.read_text(encoding="utf-8")
    upgrade = "--upgrade" in arguments
    try:
        if upgrade:
            PYPROJECT.write_text(PINS.sub("", before), encoding="utf-8")
        uv("lock", *(["--upgrade"] if upgrade else []))
        everything = exported("--all-extras", "--all-groups")
        building = exported("--only-group", "build")
        after = with_pins(PYPROJECT.read_text(encoding="utf-8"), everything, building)
    except BaseException:
        PYPROJECT.write_text(before, encoding="utf-8")
        raise
    PYPROJECT.write_text(after, encoding="utf-8")
    uv("lock")


def exported(*which: str) -> list[str]:
    """What is needed, with its version, a line each."""
    return uv(
        *("export", *which, "--no-hashes", "--no-annotate"),
        *("--no-header", "--no-emit-project", "--format", "requirements.txt"),
    ).splitlines()


def with_pins(pyproject: str, everything: list[str], building: list[str]) -> str:
    """The text of pyproject.toml with these pins instead of those it has."""
    pins = ""
    for kind, requirements in (("", everything), ("build-", building)):
        names = sorted(line.strip() for line in requirements if "==" in line)
        quoted = [line.replace('"', "'") for line in names]
        lines = "".join(f'    "{line}",\n' for line in quoted)
        pins += f"{kind}constraint-dependencies = [\n{lines}]\n"
    head, table, tail = PINS.sub("", pyproject).partition(TABLE)
    if not table:
        raise SystemExit(f"{PYPROJECT.name} has no line {TABLE.strip()}")
    return head + table + pins + tail


def uv(*arguments: str) -> str:
    """What a uv command prints on standard output."""
    done = subprocess.run(
        ["uv", *arguments], cwd=PYPROJECT.parent, check=True, capture_output=True, text=True
    )
    return done.stdout


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except subprocess.CalledProcessError as error:
        sys.exit(error.stderr)
