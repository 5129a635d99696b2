"""The page: ``restitution serve``, or an ASGI application for a server of one's own.

Forms, routes and words; no physics, no algebra. Whatever is heavy is done in `pool`'s processes.
"""

from __future__ import annotations

from restitution.web.app import create_app
from restitution.web.settings import Settings

__all__ = ["Settings", "create_app"]
