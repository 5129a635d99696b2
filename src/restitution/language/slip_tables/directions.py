"""Vectors, and directions in words."""

from __future__ import annotations

from restitution.language.slip_tables.patterns import (
    AFTER,
    ASKING_LINES,
    BALL,
    BODY,
    CUT,
    NAME,
    NAMES,
    Cure,
    Slip,
    either,
    meant,
)

DIRECTIONS: tuple[Slip, ...] = (
    # vectors
    ("", r"\bat\s+(?P<x>(?:an?\s+|the\s+)?(?:acute\s+)?angle(?:\s+of)?)(?!\s*\()", CUT),
    (
        "",
        r"\bat\s(?!right\b)[^,]*?(?P<x>\b(?:to|with)\s+(?:the\s+)?(?:positive\s+)?(?P<d>-?\s*[ij])\b)",
        meant("from {d}"),
    ),
    ("", rf"\bat\s[^,]*?(?P<x>\b(?:with|against|towards)\s+{BODY})", meant("to {body}")),
    *(
        (
            ASKING_LINES,
            (
                rf"(?P<x>\b(?:the\s+)?(?P<q>speed|velocity|direction|energy)\s+of\s+{BODY}\s+"
                r"(?:immediately\s+|just\s+)?after\s+(?:the\s+|its\s+)?"
                rf"(?:{words})\s+(?:collision|impact|event))"
            ),
            meant(f"{{q}}({{body}}, {number})"),
        )
        for number, words in enumerate(("first|1st", "second|2nd", "third|3rd"), start=1)
    ),
    (
        ASKING_LINES,
        r"(?P<x>\bafter\s+(?:each|every|both)\b(?:\s+\w+)?)",
        "the speed of A after event 1 is speed(A, 1), after event 2 speed(A, 2)",
    ),
    (
        "find",
        (
            r"(?P<x>\b(?:the\s+)?(?:acute\s+)?angle\s+between\s+(?:the\s+|their\s+)?(?:two\s+)?(?:final\s+)?"
            rf"(?:velocities|directions(?:\s+of\s+motion)?|paths)(?:\s+of\s+{NAMES})?{AFTER}?)"
        ),
        Cure(
            "did you mean 'angle(velocity(A), velocity(B))'?",
            "angle(velocity({first}), velocity({second}))",
        ),
    ),
    (
        ASKING_LINES,
        r"(?P<x>\b(?:the\s+)?angle)\b(?!\s*(?:\(|of\b|between\b|turned\b|deflected\b))",
        (
            "an angle is between two directions, as in 'angle(velocity(P), W)'; how far P is "
            "turned is 'deflection(P)'"
        ),
    ),
    (
        ASKING_LINES,
        rf"(?P<x>\b[vV]\s+(?:of|for)\s+{BODY}\s+and\s+(?:(?:of|for)\s+)?(?P<b>{NAME}))",
        either("velocity({body}), velocity({b})", "speed({body}), speed({b})"),
    ),
    (
        ASKING_LINES,
        rf"(?P<x>\b(?:the\s+)?path\s+of\s+{BODY})",
        meant("velocity({body})"),
    ),
    (
        "given show",
        r"(?P<x>\bthere\s+(?:are|is|will\s+be)\s+no\s+(?:more|further)\s+(?:collisions?|impacts?))",
        "name the two, as in 'A and B do not collide again'",
    ),
    *(
        (
            "find",
            (
                rf"(?P<x>\b(?:the\s+)?(?:(?:final|new)\s+)?(?:{plural}(?!\s*\(|\s+of\b|\s*[A-Z])|(?:{one}|{plural})\s+of\s+"
                rf"(?:both|each|all|the\s+two|the\s+spheres\b)(?:\s+(?:of\s+)?(?:the\s+)?(?:two\s+)?(?:them\b|{BALL}\b(?!\s+{NAME}\b)))?)"
                rf"{AFTER}?)"
            ),
            Cure("did you mean {each}?", f"{one}({{sphere}})", together=True),
        )
        for one, plural in (
            ("velocity", "velocities"),
            ("speed", "speeds"),
            ("direction", "directions"),
            ("deflection", "deflections"),
        )
    ),
    (
        ASKING_LINES,
        rf"(?P<x>\b[vV]\s*(?:_|\(\s*|(?:of|for)\s+)?{BODY}\s*\)?)",
        either("velocity({body})", "speed({body})"),
    ),
    (
        ASKING_LINES,
        rf"(?P<x>\b[uU]\s*(?:_|\(\s*|of\s+)?{BODY}\s*\)?)",
        either("velocity({body}, 0)", "speed({body}, 0)"),
    ),
    (ASKING_LINES, rf"(?P<x>\bm(?:_|\s*\(\s*|\s+of\s+){BODY}\s*\)?)", meant("mass({body})")),
    (
        ASKING_LINES,
        (
            r"(?P<x>\b(?:the\s+)?(?:final\s+)?(?P<q>speed|velocity|direction|deflection)\b"
            rf"(?!\s*\(|\s*[A-Z]|\s+of\b){AFTER}?)"
        ),
        Cure("did you mean {each}?", "{q}({sphere})"),
    ),
    (
        ASKING_LINES,
        rf"(?P<x>\b[vV]{AFTER})",
        Cure("did you mean {each}?", "velocity({sphere})"),
    ),
    # directions that are told otherwise
    (
        "sphere",
        (
            r"\bat\s+(?P<x>(?P<a>[^\s,]+)\s+(?:to|from|with)\s+(?:the\s+)?normal"
            rf"(?:\s+(?:to|of)\s+(?:the\s+)?(?:wall\s+)?(?P<w>{NAME})))"
        ),
        Cure(
            "an angle is one to the wall, 90° less that to its normal: did you mean "
            "'90° - {a} to {w}'?",
            "90° - {a} to {w}",
        ),
    ),
    (
        ASKING_LINES,
        (
            r"(?:,|\band\b|\bwith\b|\bto\b)\s*"
            rf"(?P<x>(?:the\s+)?normal(?:\s+(?:to|of)\s+{BODY})?)(?=\s*(?:[),=<>]|$))"
        ),
        Cure(
            "an angle to a wall is 90° less that to its normal, which is 'line_of_centres'",
            "line_of_centres",
        ),
    ),
    (
        "",
        r"(?P<x>\b(?:the\s+)?normal)\b(?!\s+to\b\s*[^\sA-Z])",
        (
            "an angle is one to the wall itself, 90° less that to its normal, as in "
            "'angle(velocity(P), W)'"
        ),
    ),
    (
        "",
        (
            r"(?P<x>\b(?:on\s+a\s+)?bearings?|\b(?:due\s+)?(?:[Nn]orth|[Ss]outh)(?:-?(?:[Ee]ast|[Ww]est)"
            r")?|\b(?:due\s+)?(?:[Ee]ast|[Ww]est))\b"
        ),
        (
            "directions are told by i and j: with i to the east and j to the north a bearing of "
            "060° is the direction at 30°"
        ),
    ),
    (
        "wall",
        r":\s*(?:through|from)\s+[^,()]+?(?P<x>\s*(?:,|\band\b))\s*(?:through\s+)?[A-Z(]",
        (
            "a wall from one point to another is told as 'from F to G', one without ends by its "
            "direction, such as 'along 2i + j, through F'"
        ),
    ),
    (
        "wall",
        r":\s*(?P<x>[^:]*[xy][^:]*=.*?)\s*$",
        (
            "a wall is told by its direction and a point of it: x + 2y = 4 is 'along 2i - j, "
            "through (4, 0)'"
        ),
    ),
    (
        "event",
        rf"^\s*{NAME}\s+hits\s+{NAME}\s*(?P<x>(?:,|&|\band\b)\s*{NAME})\b",
        "an impact is one of two bodies; where a sphere strikes two at once is not answered",
    ),
    (
        "other",
        (
            rf"^\s*(?P<x>(?P<body>{NAME})\s+(?:then\s+)?(?:rebounds|bounces\s+(?:off|back)|leaves"
            rf"|(?:goes|moves|comes|travels)(?:\s+(?:off|away|back))?)"
            rf"(?:\s+(?:from\s+)?(?:the\s+)?(?:wall\s+)?{NAME})?\s+"
            rf"at\s+(?P<a>[^,]+?)\s+to\s+(?:the\s+)?(?:wall\s+)?(?P<w>{NAME}))\s*$"
        ),
        meant("given angle(velocity({body}), {w}) = {a}"),
    ),
    (
        "sphere",
        r"\bat\s+rest\s+(?P<x>(?:immediately\s+|just\s+)?after(?:wards)?\b.*?)\s*$",
        "what a sphere does after an event is a fact below that, such as 'given A at rest'",
    ),
    (
        f"other event {ASKING_LINES}",
        (
            rf"(?P<x>\b{NAME}\s+(?:changes|reverses|has\s+changed|is\s+reversed)\b.*?\bdirection\b"
            r"|(?:(?:the\s+)?(?:direction(?:\s+of\s+motion)?|motion|path)\s+of\s+)?"
            rf"\b{NAME}\s+(?:is|has\s+been)\s+reversed\b)"
        ),
        (
            "whether a sphere goes back along the line of centres is told by its component, as in "
            "'given along(velocity(A), i) < 0'; straight back is 'velocity(A) opposite to "
            "velocity(A, 0)'"
        ),
    ),
    (
        ASKING_LINES,
        r"(?P<x>\b(?:the\s+)?time\s+(?:between|until|till|to|from|taken|of)\b.*?)\s*$",
        ("the time of event 1 is 'time(1)', and that between events 1 and 2 'time(2) - time(1)'"),
    ),
    (
        ASKING_LINES,
        r"(?P<x>\b(?:the\s+)?(?:point|place)\s+(?:of|where)\b.*?)\s*$",
        (
            "the place of a sphere at event 1 is 'position(P, 1)', and how far it has come "
            "'distance(position(P, 0), position(P, 1))'"
        ),
    ),
)
