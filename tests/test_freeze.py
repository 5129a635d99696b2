"""Workings are kept as they are printed, and a change of one is shown."""

from __future__ import annotations

from pathlib import Path

import freeze_workings
import pytest

NAME = "027-wall-direct"


def test_what_is_frozen_is_what_is_printed_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert freeze_workings.main(["freeze", str(tmp_path), NAME]) == 0
    kept = sorted(each.suffix for each in tmp_path.iterdir())
    assert kept == [".html", ".json", ".md", ".tex", ".txt", ".typ"]
    assert freeze_workings.main(["compare", str(tmp_path), NAME]) == 0
    assert capsys.readouterr().out == ""


def test_a_difference_is_shown_in_the_forms_that_are_wanted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    freeze_workings.main(["freeze", str(tmp_path), NAME])
    (text,) = tmp_path.glob("*.txt")
    text.write_text(text.read_text(encoding="utf-8").replace("M1", "B1", 1), encoding="utf-8")
    assert freeze_workings.main(["compare", str(tmp_path), "--forms", "json", NAME]) == 0
    assert freeze_workings.main(["compare", str(tmp_path), NAME]) == 1
    shown = capsys.readouterr().out
    assert "\n-" in shown and "\n+" in shown and "M1" in shown
