"""Which statements take long with all their laws: `tests/long_statements.txt`, written anew.

    uv run python scripts/long_statements.py

The normal run of the tests looks at some of them (`tests/nights.py`), the nightly one at all.
"""

from __future__ import annotations

import sys
import time
from importlib import import_module
from pathlib import Path

TESTS = Path(__file__).parents[1] / "tests"
LIST = TESTS / "long_statements.txt"
LONG = 0.5
"""Seconds of a processor."""


def main() -> None:
    """Puts each statement to its laws, and keeps the names of those that take long."""
    sys.path.insert(0, str(TESTS))
    statements = import_module("statements")
    import_module("test_statements")  # it loads the laws
    names = []
    for path in statements.FILES:
        start = time.process_time()
        statements.put_to(statements.LAWS, path)
        if time.process_time() - start > LONG:
            names.append(path.stem)
    LIST.write_text("\n".join(sorted(names)) + "\n", encoding="utf-8")
    print(f"{len(names)} of {len(statements.FILES)} take more than {LONG} s")


if __name__ == "__main__":
    main()
