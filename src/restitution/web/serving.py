"""Running the page on this machine."""

from __future__ import annotations

import uvicorn

from restitution.web.app import create_app
from restitution.web.settings import Settings


def serve(host: str, port: int, settings: Settings) -> None:
    """Serve the page until the process is told to end."""
    uvicorn.run(create_app(settings), host=host, port=port, log_level="warning")
