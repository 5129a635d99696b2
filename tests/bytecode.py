"""Compiled modules are kept, whatever the environment says.

Many tests begin processes. Each of them would compile the package anew, which takes as long as
what it is begun for; and the assertions of all tests would be rewritten at the start of each run.
"""

from __future__ import annotations

import os
import sys

sys.dont_write_bytecode = False
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
