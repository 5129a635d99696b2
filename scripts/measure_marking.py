"""The marker against scripts marked by hand: ``python scripts/measure_marking.py --help``."""

from __future__ import annotations

import runpy
from pathlib import Path

if __name__ == "__main__":
    tests = Path(__file__).resolve().parents[1] / "tests"
    runpy.run_path(str(tests / "measure_marking.py"), run_name="__main__")
