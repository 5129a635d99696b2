"""What the processes begin with. Importing it is work, and is meant to be: it is imported once, in
the process that all others are forked from, so that each of them finds libraries loaded and the
algebra's first steps taken. A question seen for the first time is answered thrice as fast.
"""

from __future__ import annotations

import gc

from restitution import examples
from restitution.export.working import shown
from restitution.garbage import collect_seldom
from restitution.language import parse
from restitution.oracle.decision import limit_memory
from restitution.solving import solve

# Megabytes: a question that takes more is undecided, long before the process has to end.
limit_memory(1024)

# Walls, spheres, and letters: between them they use nearly everything.
for _name in ("corner", "two-spheres-with-vectors", "wall-in-letters"):
    shown(solve(parse(examples.text(_name))))

# What was made so far stays: no need to look through it again for garbage.
gc.collect()
gc.freeze()
collect_seldom()
