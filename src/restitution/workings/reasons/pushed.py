"""Why a component after an impact has its sense: the sphere had none, and was pushed."""

from __future__ import annotations

from restitution.explaining.lines.derivation import Derivation, Fact, Line, Meaning
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import Name, Pair, Quantity, is_zero
from restitution.workings.naming.quantities import Naming


def pushed_away(derivation: Derivation, naming: Naming, line: Line, fact: Fact) -> Sentence | None:
    """That a sphere without a component along the line of centres is pushed away from the other.

    None where a root is rejected by more than the velocity before, and what the letter is.
    """
    _, *rest = line.premises
    cited = derivation.lines_in(rest)
    lets = [own.relation for own in cited if isinstance(own.relation, Meaning)]
    if len(lets) != len(cited):
        return None
    (link,) = fact.relation.only
    for let in lets:
        match let.quantity, link.left:
            case (
                Quantity("along", (Quantity("velocity", (Name(body),), int(number)), _)),
                Quantity("velocity", (Name(own),)),
            ) if own == body and number in naming.events:
                others = [other for other in naming.events[number].bodies if other != body]
                rested = (
                    isinstance(link.right, Pair) and is_zero(link.right.x) and is_zero(link.right.y)
                )
                name = "derived.pushed-from-rest" if rested else "derived.pushed"
                return say(name, body=body, other=others[0])
    return None


__all__ = ["pushed_away"]
