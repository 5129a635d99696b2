"""The output of the command that docs/experiment.md shows is what it prints."""

from __future__ import annotations

import re
import shlex
from itertools import pairwise
from pathlib import Path

from commands import run

PAGE = Path(__file__).parents[1] / "docs" / "experiment.md"
TEXT = PAGE.read_text("utf-8")
BLOCKS = [*re.finditer(r"^```(\w+)\n(.*?)^```$", TEXT, re.M | re.S)]


def test_worked_set_is_its_file():
    data = (PAGE.parent / "examples" / "angles.csv").read_text("utf-8")
    assert ("text", data) in [(match[1], match[2]) for match in BLOCKS]


def test_output_is_that_of_the_command(monkeypatch):
    monkeypatch.chdir(PAGE.parent / "examples")
    shown = 0
    for command, output in pairwise(BLOCKS):
        between = TEXT[command.end() : output.start()].strip()
        if (command[1], output[1], between) != ("sh", "text", ""):
            continue
        program, *arguments = shlex.split(command[2])
        assert program == "restitution"
        status, printed, _ = run(*arguments)
        assert status == 0
        assert printed == output[2]
        shown += 1
    assert shown == 1
