"""What the processes begin with: to be imported where they come from."""

from __future__ import annotations

import restitution.explain
import restitution.explain.typst
import restitution.export.sheet
import restitution.export.working
import restitution.solve
import restitution.web.work  # noqa: F401
