"""A law of impact that is altered: the world of a mistake, told and solved like the true one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Alteration:
    """Equations that hold at an impact in place of laws, in the language of statements.

    The templates speak as those of principles do: F and S are the first and the second body (S the
    wall), X a body, 0 the stage before and 1 the one after. ``replaces`` are the laws that do not
    hold any more.
    """

    id: str
    where: Literal["wall", "spheres", "impact"]
    replaces: tuple[Literal["momentum", "restitution", "unchanged"], ...]
    equations: tuple[str, ...]
