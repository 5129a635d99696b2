"""Words of mechanics for which the model has no place: each is answered by one sentence.

They are looked for only where a line cannot be read; the reference lists what is outside.
"""

from __future__ import annotations

import re
from functools import cache

from restitution.errors import StatementError
from restitution.expression.source import Source

# What people write, and what to say: what the model is, and what to do instead.
_TABLE: tuple[tuple[str, str], ...] = (
    (
        r"inclined\s+planes?|inclines?|slopes?|sloping|hills?|ramps?",
        (
            "there is no slope here, as everything moves on a horizontal table; a plane that is "
            "struck is a wall, such as 'wall W: along 30°'"
        ),
    ),
    (
        (
            r"gravity|gravitational|g[-\s]?fields?|weightless|vertical\s+plane|heights?|free\s+fall"
            r"|falls?|falling|fell|dropped|drops|projectiles?"
            r"|trajectory|vertically|upwards?|downwards?"
        ),
        (
            "there is no gravity here, as everything moves on a horizontal table seen from above; "
            "give the velocity just before an impact, and a floor that is struck is a wall"
        ),
    ),
    (
        (
            r"frictional|friction|rough|roughness|(?:air\s+)?resistance|resistive|viscous|decelerat\w+"
            r"|retardation|slows(?:\s+down)?|slowing"
        ),
        (
            "there is no friction here, as table, walls and spheres are smooth and a velocity "
            "changes at events alone; give the velocity just before an impact"
        ),
    ),
    (
        (
            r"(?:(?:light|elastic|inelastic|inextensible)\s+)*(?:strings?|springs?|rods?|ropes?)"
            r"|tension|taut|slack|inextensible|pulleys?|hinged?|tethered"
        ),
        (
            "there are no strings, springs and rods here; the jerk of a string is told as an "
            "impulse, such as 'A receives 2i'"
        ),
    ),
    (
        (
            r"coalesces?|coalescing|coalesced|(?:sticks?|stuck|join(?:s|ed)?|moves?|stay)\s+together"
            r"|merges?|merged|embedded|embeds"
        ),
        (
            "two spheres stay two here; with e = 0 they have one velocity along the line of "
            "centres after the impact"
        ),
    ),
    (
        (
            r"spins?|spinning|rotat\w+|rolls?|rolling|angular\s+\w+|moments?\s+of\s+inertia|torque"
            r"|topspin|backspin|tangential"
        ),
        "nothing turns here, as smooth spheres take no spin from an impact; leave it out",
    ),
    (
        (
            r"averaged?(?:\s+force)?|(?:mean\s+|contact\s+)?forces?|contact\s+time"
            r"|duration(?:\s+of\s+(?:contact|impact))?"
        ),
        (
            "there are no averages here, as an impact takes no time; ask for the impulse, which is "
            "an average force times its duration"
        ),
    ),
    (
        r"accelerat\w+",
        (
            "nothing accelerates here, as a velocity changes at events alone; a blow from outside "
            "is told as 'A receives 2i'"
        ),
    ),
    (
        r"explod\w+|explosions?",
        "there are no explosions here; a blow to each body is told as 'A receives 2i'",
    ),
)


@cache
def _patterns() -> tuple[tuple[re.Pattern[str], str], ...]:
    """The table, compiled when the first mistake is met."""
    return tuple(
        (re.compile(rf"(?<![\w'’])(?:{words})(?![\w'’])"), message) for words, message in _TABLE
    )


def outside(source: Source) -> StatementError | None:
    """The error for a line that cannot be read, if a word in it is outside the model."""
    text = source.plain
    start = len(text) - len(text.lstrip())
    text = text[:start] + text[start : start + 1].lower() + text[start + 1 :]  # ``Gravity = …``
    matches = [
        (match, message) for pattern, message in _patterns() if (match := pattern.search(text))
    ]
    if not matches:
        return None
    match, message = min(matches, key=lambda entry: entry[0].start())
    typed = " ".join(source.text[match.start() : match.end()].split())
    return source.error(f"'{typed}' is outside the model: {message}", match.start())
