"""Walls told by other walls, and directions and angles told by walls."""

from __future__ import annotations

from restitution.language.slip_tables.patterns import NAME, Cure, Slip, meant

_WALL = rf"(?:the\s+)?(?:wall\s+)?(?P<w>{NAME})\b"

_ANGLE = r"(?:an\s+(?:acute\s+)?angle\s+(?:of\s+)?)?(?P<a>[^\s,:]+(?:\s*(?:deg(?:rees?)?|°))?)"

_RIGHT = (
    r"(?:perp\w*\s+(?:to|with)|at\s+right\s+angles\s+(?:to|with)|(?<!\bthe )normal(?:ly)?\s+to)"
)

_LEAVES = (
    r"(?:rebounds?|bounces(?:\s+(?:off|back))?|leaves|(?:goes|moves|comes|travels|is\s+moving)"
    r"(?:\s+(?:off|away|back))?)"
)

WALLS: tuple[Slip, ...] = (
    # a wall by another one
    (
        "wall",
        rf"[:,]\s*(?P<x>(?:is\s+)?{_RIGHT}\s+{_WALL})",
        meant("along 1 at 90° from direction({w})"),
    ),
    ("wall", rf"[:,]\s*(?P<x>(?:is\s+)?parallel\s+to\s+{_WALL})", meant("along direction({w})")),
    (
        "wall",
        rf"[:,]\s*(?P<x>(?:is\s+)?(?:(?:inclined\s+)?at|along)\s+{_ANGLE}\s+(?:to|from|with)\s+{_WALL})",
        meant("along 1 at {a} from direction({w})"),
    ),
    (
        "wall",
        r"\balong\s[^,]*?(?P<x>\s+from\s+(?:the\s+)?i)\s*(?:,|$)",
        Cure("leave out 'from i'", ""),
    ),
    # a velocity by a wall
    (
        "sphere",
        (
            rf"\b(?:velocity|speed)\s[^,]*?(?P<x>(?:directly\s+)?{_RIGHT}\s+{_WALL}"
            rf"|(?:directly|straight)\s+(?:towards|at|into|to)\s+(?:the\s+)?(?:wall\s+)?(?P<v>{NAME}))"
        ),
        meant("at 90° to {w}{v}"),
    ),
    (
        "sphere",
        rf"\b(?:velocity|speed)\s[^,]*?(?P<x>parallel\s+to\s+{_WALL})",
        meant("at 0° from direction({w})"),
    ),
    (
        "sphere",
        rf"\b(?:velocity|speed)\s[^,]*?(?P<x>towards\s+{_WALL}\s+at\s+{_ANGLE}(?:\s+to\s+(?:it|(?P=w)))?)\s*(?:,|$)",
        meant("at {a} to {w}"),
    ),
    # an angle of rebound
    (
        "given show",
        rf"(?P<x>(?:the\s+)?(?P<body>{NAME})\s+(?:then\s+)?{_LEAVES}\s+(?:(?:from\s+)?{NAME}\s+)?at\s+{_ANGLE}\s+(?:to|with)\s+{_WALL})",
        meant("angle(velocity({body}), {w}) = {a}"),
    ),
    (
        "given show",
        rf"(?P<x>velocity\s*\(\s*(?P<body>{NAME})\s*\)\s+(?:is\s+)?at\s+{_ANGLE}\s+(?:to|with)\s+{_WALL})",
        meant("angle(velocity({body}), {w}) = {a}"),
    ),
    (
        "given show",
        rf"(?P<x>(?:the\s+)?(?:path|direction(?:\s+of\s+motion)?|motion|velocity)\s+of\s+(?P<body>{NAME})\s+is\s+(?:turned|deflected)\s+(?:through|by))\b",
        meant("deflection({body}) ="),
    ),
    (
        "given show",
        r"(?P<x>(?:the\s+|its\s+)?speed\s+is\s+halved)\b",
        Cure("did you mean {each}?", "speed({sphere}) = 1/2 speed({sphere}, before)"),
    ),
    *(
        (
            "find let",
            rf"(?P<x>(?:the\s+)?angle\s+(?:of\s+(?:rebound|reflection)|at\s+which\s+{NAME}\s+(?:rebounds|leaves)){end})",
            cure,
        )
        for end, cure in (
            (
                rf"(?:\s+(?:from|off|with|to)\s+|\s+){_WALL}",
                Cure("did you mean {each}?", "angle(velocity({sphere}), {w})"),
            ),
            ("", "an angle after an impact is one to the wall, as in 'angle(velocity(P), W)'"),
        )
    ),
    # places
    (
        "event",
        (
            rf"^\s*(?P<body>{NAME})\s+hits\s+(?P<w>{NAME})\b[^,]*?(?P<x>[\s:,]+(?:at\s+right\s+angles"
            r"|perpendicularly|normally|at\s+90\s*(?:°|deg(?:rees?)?))(?:\s+to\s+it)?)\s*(?=,|$)"
        ),
        Cure(
            "how {body} comes is a fact: 'given velocity({body}, before) perpendicular to {w}'",
            "\ngiven velocity({body}, before) perpendicular to {w}",
            tight=True,
        ),
    ),
    (
        "event",
        r"[:,]\s*(?P<x>at\s+(?:the\s+)?(?:point\s+)?(?:\(|[A-Z]))",
        "where an impact is is a fact below it, as in 'given position(P) = (3, 0)'",
    ),
)
