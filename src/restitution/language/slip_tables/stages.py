"""What is asked of one impact of several, of a motion from start to end, or of a wall."""

from __future__ import annotations

from restitution.language.slip_tables.patterns import (
    ASKING_LINES,
    BODY,
    KINETIC,
    NAME,
    STRIKES,
    Cure,
    Slip,
    meant,
)

_ORDINALS = (("first|1st", 1), ("second|2nd", 2), ("third|3rd", 3), ("fourth|4th", 4))

_IMPACT = r"(?:collision|impact|bounce|event)"

_SOON = r"(?:immediately\s+|just\s+)?"

STAGES: tuple[Slip, ...] = (
    # one impact of several
    *(
        slip
        for words, number in _ORDINALS
        for slip in (
            (
                ASKING_LINES,
                (
                    rf"(?P<x>(?:the\s+)?(?:{KINETIC}\s+(?:lost|loss)|loss\s+(?:of|in)\s+(?:the\s+)?{KINETIC}|energy_lost)"
                    rf"\s+(?:in|at|by|during)\s+(?:the\s+)?(?:{words})\s+{_IMPACT})"
                ),
                meant(f"energy_lost({number})"),
            ),
            (
                ASKING_LINES,
                (
                    r"(?P<x>(?:the\s+)?(?:(?:magnitude|size)\s+of\s+(?:the\s+)?)?impulse"
                    rf"\s+(?:in|at|of|from|during)\s+(?:the\s+)?(?:{words})\s+{_IMPACT})"
                ),
                meant(f"impulse({number})"),
            ),
            (
                ASKING_LINES,
                (
                    r"(?P<x>(?:the\s+)?(?P<q>speed|velocity|direction)"
                    rf"(?:\s+(?:of\s+)?(?:the\s+)?(?:ball|sphere|particle))?\s+{_SOON}after\s+(?:the\s+|its\s+)?(?:{words})\s+{_IMPACT})"
                ),
                Cure("did you mean {each}?", f"{{q}}({{sphere}}, {number})"),
            ),
            (
                ASKING_LINES,
                (
                    r"(?P<x>(?:the\s+)?time\s+(?:until|till|to|of|at)\s+(?:the\s+)?"
                    rf"(?:{words})\s+{_IMPACT})"
                ),
                meant(f"time({number})"),
            ),
        )
    ),
    (
        ASKING_LINES,
        r"(?P<x>(?:the\s+)?time\s+between\s+(?:the\s+)?(?:two\s+|first\s+(?:and|two)\s+(?:second\s+)?)?(?:impacts|collisions|bounces))",
        meant("time(2) - time(1)"),
    ),
    # how a body comes
    (
        ASKING_LINES,
        rf"(?P<x>(?:the\s+)?speed\s+(?:with|at)\s+which\s+{BODY}\s+(?:hits|{STRIKES})(?:\s+(?:the\s+)?(?:wall\s+)?(?:{NAME}\b)?)?)",
        meant("speed({body}, before)"),
    ),
    # the whole of a motion
    (
        ASKING_LINES,
        (
            r"(?P<x>(?:the\s+)?(?:acute\s+)?angle\s+between\s+(?:the\s+|its\s+)?(?:initial|original|first)\s+and\s+"
            rf"(?:the\s+|its\s+)?final\s+(?:velocities|directions(?:\s+of\s+motion)?|paths)\s+of\s+{BODY})"
        ),
        meant("angle(velocity({body}, 0), velocity({body}))"),
    ),
    (
        ASKING_LINES,
        (
            r"(?P<x>(?:the\s+)?angle\s+(?:through|by)\s+which\s+(?:the\s+(?:path|motion|velocity|direction(?:\s+of\s+motion)?)"
            rf"\s+of\s+)?{BODY}\s+is\s+(?:deflected|turned|changed)(?:\s+(?:by|through)\s+the\s+{_IMPACT})?)"
        ),
        meant("deflection({body})"),
    ),
    (
        ASKING_LINES,
        r"(?P<x>(?:the\s+)?(?:total\s+)?distance\s+(?:travelled|moved|covered|that)\b[^,]*)",
        (
            "a distance is one between two places: 'distance(position(P, 0), position(P, 1))' from "
            "the start to event 1; a path is the sum of such"
        ),
    ),
    (
        ASKING_LINES,
        r"(?P<x>(?:the\s+)?(?:total|whole)\s+time(?:\s+taken)?(?:\s+(?:from|until|for)\b[^,]*)?)\s*(?:,|$)",
        "the time of event 2, from the start, is 'time(2)'",
    ),
    (
        ASKING_LINES,
        rf"(?P<x>(?:the\s+)?(?:coordinates|position\s+vector|place)\s+of\s+{BODY})",
        meant("position({body})"),
    ),
    # a wall
    (
        ASKING_LINES,
        (
            r"(?P<x>(?:an?\s+|the\s+)?(?:unit\s+)?(?:vector|direction)\s+(?:that\s+is\s+)?(?:parallel\s+to|along|of)\s+"
            rf"(?:the\s+)?wall\s+(?P<w>{NAME}))"
        ),
        meant("direction({w})"),
    ),
    (
        ASKING_LINES,
        rf"(?P<x>(?:an?\s+|the\s+)?(?:unit\s+)?vector\s+(?:that\s+is\s+)?(?:parallel\s+to|along)\s+(?P<w>{NAME}))",
        meant("direction({w})"),
    ),
    # the form of an answer
    (
        "find",
        r"(?P<x>,?\s*\bin\s+(?:the\s+)?(?:form|terms\s+of)\s+\w*\s*\*?\s*\w?\s*i\s*[-+]\s*\w*\s*\*?\s*\w?\s*j\b)",
        Cure("leave out '{x}': a velocity is answered by its components", "", tight=True),
    ),
)
