"""A law of impact that is altered: the world of a mistake, told and solved like the true one."""

from __future__ import annotations

from typing import Literal

from restitution.records import dataclass

LawName = Literal["momentum", "restitution", "unchanged"]
Where = Literal["wall", "spheres", "impact"]


@dataclass(frozen=True)
class AlteredLaw:
    """An equation that holds at an impact in place of a law, in the language of statements.

    It speaks as the templates of principles do: F and S are the first and the second body (S the
    wall), 0 is the stage before the event, 1 the one after. ``body`` is the sphere whose component
    across the line of centres it is about, where the law is ``unchanged``.
    """

    law: LawName
    template: str
    body: Literal["F", "S"] | None = None


@dataclass(frozen=True)
class AlteredResult:
    """What stands in place of a quantity that is asked for, or given: ``quantity = template``.

    With X in it there is one for each sphere of the event. ``sense``, where it is not empty, is a
    scalar that is not negative where this can be meant.
    """

    quantity: str
    template: str
    sense: str = ""


@dataclass(frozen=True)
class Alteration:
    """One way in which a mistake alters the laws of an impact, or a result.

    ``id`` is that of the mistake with a number: ``momentum-sign/2``. Laws that ``laws`` does not
    replace hold on. ``senses`` are scalars that are not negative where the signs that are put in
    by hand are those of the components: elsewhere nobody would make this mistake. ``solvable``
    tells whether an altered world has values by square roots; of others only lines are known.
    ``words`` say what this variant does, where the mistake has several.
    """

    id: str
    where: Where
    laws: tuple[AlteredLaw, ...] = ()
    results: tuple[AlteredResult, ...] = ()
    senses: tuple[str, ...] = ()
    solvable: bool = True
    words: str = ""

    @property
    def mistake(self) -> str:
        """The id of the mistake of which this is a variant."""
        return self.id.partition("/")[0]
