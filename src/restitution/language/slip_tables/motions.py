"""How a body moves after an impact, and what is compared of two, in words."""

from __future__ import annotations

from restitution.language.slip_tables.patterns import (
    AFTER,
    ASKING_LINES,
    BODY,
    KINETIC,
    NAME,
    SIZE,
    Cure,
    Slip,
    meant,
)

_CENTRES = r"(?:the\s+)?lines?[\s_]of[\s_]cent(?:re|er)s"
_AT = (
    r"at\s+(?:an?\s+(?:acute\s+)?angle\s+(?:of\s+)?)?"
    r"(?P<a>(?!right\b|rest\b|speed\b)[^\s,][^,]*?)\s+(?:to|with)"
)
_MOVES = r"(?:(?:now|then)\s+)?(?:is\s+)?(?:moves|moving|travels|travelling)"
_MAKES = (
    r"makes\s+(?:an?\s+(?:acute\s+)?angle\s+(?:of\s+)?)?(?P<a>[^\s,][^,]*?)"
    r"(?:\s+(?:with|to))"
)
_GOES = (
    r"(?:(?:now|then)\s+)?(?:(?:is\s+)?(?:moves?|moving|travels?|travelling|goes|going)"
    r"(?:\s+(?:off|away|back))?|(?:rebounds|bounces(?:\s+(?:off|back))?|leaves)"
    rf"(?:\s+(?:from\s+|off\s+)?(?:the\s+)?(?:wall\s+)?{NAME})?)"
)
_VALUE = r"(?:[\d(√]|sqrt\b|[a-z](?![a-z]))(?:(?!\s+(?:at|to|in|along|and)\b)[^,])*?"
_TIMES = {
    "halved": "1/2 ",
    "doubled": "2 ",
    "trebled": "3 ",
    "tripled": "3 ",
    "quadrupled": "4 ",
    "unchanged": "",
    r"reduced\s+(?:by|to)\s+(?:a\s+)?half": "1/2 ",
}
_PATH = r"(?:the\s+)?(?:path|direction(?:\s+of\s+motion)?|velocity)\s+of\s+"
_ITEM = r"(?:\w+\([^()]*\)|\w+)"

MOTIONS: tuple[Slip, ...] = (
    *(
        (
            lines,
            (
                rf"{start}(?P<x>{BODY}\s+(?:{_GOES}\s+(?:with|at)\s+(?:a\s+)?speed|has\s+(?:a\s+)?speed)"
                rf"\s+(?:of\s+|=\s*)?(?P<v>{_VALUE}){AFTER}?)\s*$"
            ),
            meant(f"{fact}speed({{body}}) = {{v}}"),
        )
        for lines, start, fact in (("given show", "", ""), ("other", r"^\s*", "given "))
    ),
    *(
        (
            "given show",
            rf"(?P<x>(?:{of}\s+of\s+{BODY}|(?P<own>{NAME})['’]s\s+{of})\s+is\s+{words}{AFTER}?)\s*$",
            meant(f"{quantity}({{body}}{{own}}) = {times}{quantity}({{body}}{{own}}, before)"),
        )
        for quantity, of in (
            ("speed", r"(?:the\s+)?speed"),
            ("energy", rf"(?:the\s+)?{KINETIC}"),
        )
        for words, times in _TIMES.items()
    ),
    (
        "given show",
        (
            rf"(?P<x>(?:the\s+)?(?:total\s+)?{KINETIC}\s+is\s+"
            rf"(?:halved|reduced\s+(?:by|to)\s+(?:a\s+)?half){AFTER}?)\s*$"
        ),
        meant("energy_lost = 1/2 energy(0)"),
    ),
    *(
        (
            lines,
            rf"{start}(?P<x>{words}\s+{to})",
            meant(f"{fact}angle(velocity({{body}}), {d}) = {{a}}"),
        )
        for lines, start, fact in (("given show", "", ""), ("other", r"^\s*", "given "))
        for words in (
            rf"(?:{_PATH})?\b(?P<body>{NAME})\s+{_MOVES}\s+{_AT}",
            rf"{_PATH}(?P<body>{NAME})\s+(?:is\s+)?{_AT}",
            rf"(?:{_PATH}|velocity\()(?P<body>{NAME})\)?\s+{_MAKES}",
        )
        for to, d in (
            (_CENTRES, "line_of_centres"),
            (rf"(?:the\s+)?(?:wall\s+)?(?P<d>-?[ij]\b|{NAME})", "{d}"),
        )
    ),
    (
        "given show",
        (
            rf"^\s*\w+\s+(?P<x>(?P<p>{_ITEM})\s*:\s*(?P<q>{_ITEM})\s*=\s*"
            r"(?P<m>[\w.√]+)\s*:\s*(?P<n>[\w.√]+))"
        ),
        meant("{p}/{q} = {m}/{n}"),
    ),
    (
        "given show",
        (
            rf"\b(?P<q>speed|velocity|energy)\s*(?:of\s+|\(\s*){BODY}[^,]*?"
            r"(?P<x>\bits\s+(?:original|initial|previous)\s+(?:speed|velocity|(?:kinetic\s+)?energy))"
        ),
        meant("{q}({body}, 0)"),
    ),
    (
        "given show",
        (
            r"(?P<x>(?:\b(?:cannot|can\s+not|can['’]t|does\s+not|doesn['’]t|must\s+not|never)\s+exceeds?"
            r"|\bis\s+(?:not|no|never)\s+(?:more|greater|larger)\s+than))\b"
        ),
        meant("<="),
    ),
    ("given show", r"(?P<x>\bis\s+(?:not|no|never)\s+(?:less|smaller)\s+than)\b", meant(">=")),
    ("given show", r"(?P<x>\bexceeds)\b", meant(">")),
    ("given show let", r"(?P<x>\b(?:a\s+)?right\s+angle)\b", meant("90°")),
    (
        "given",
        r"^\s*given\s+(?P<x>(?P<q>\w+)\s+is\s+(?:an\s+)?acute(?:\s+angle)?)\s*$",
        meant("0° < {q} < 90°"),
    ),
    (
        "given",
        r"^\s*given\s+(?P<x>(?P<q>\w+)\s+is\s+(?:an\s+)?obtuse(?:\s+angle)?)\s*$",
        meant("90° < {q} < 180°"),
    ),
    (
        "show",
        r"[<>=≤≥][^<>=≤≥,]*?(?P<x>\s+and\s+)(?:that\s+)?(?=[^<>=≤≥,]+[<>=≤≥])",
        Cure("one relation is shown on a line", "\nshow ", tight=True),
    ),
    *(
        (
            ASKING_LINES,
            (
                rf"(?P<x>{size}(?:the\s+)?impulse\s+(?:that\s+|which\s+)?"
                rf"(?:sphere\s+)?{NAME}\s+(?:exerts|gives|has)\s+(?:on|to)\s+{BODY})"
            ),
            meant(impulse),
        )
        for size, impulse in (
            (r"(?:the\s+)?(?:magnitude|size)\s+of\s+", "impulse"),
            ("", "impulse({body})"),
        )
    ),
    (
        "find show",
        r"imum\s+of\b.*?\s(?P<x>as\s+(?P<l>[^\s,]+)\s+varies)\b",
        meant("over {l}"),
    ),
    (
        "sphere",
        (
            rf"\b(?:velocity|speed)\s+(?P<x>{SIZE}\s+(?:perpendicular|normal|at\s+right\s+angles)\s+to\s+"
            r"(?:the\s+)?(?P<d>-?[ij]\b))"
        ),
        meant("{v} at 90° from {d}"),
    ),
    (
        "event",
        rf"(?P<x>{_CENTRES}\s+(?:is\s+)?at\s+(?P<a>[^\s,][^,]*?)\s+(?:to|from)\s+(?:the\s+)?i)\b",
        meant("along {a}"),
    ),
    (
        "event",
        r"\balong\s+[^\s,]+(?P<x>\s+(?:to|from)\s+(?:the\s+)?i)\b",
        Cure("leave out '{x}': a direction is told by its angle from i", ""),
    ),
    (
        "event",
        r"\balong\s+(?P<x>(?P<a>[^\s,]+)\s+from\s+(?:the\s+)?(?P<d>-i|-?j))\b",
        meant("1 at {a} from {d}"),
    ),
    ("other", r"^\s*(?P<x>[Ss]tate|[Ww]rite|[Ee]xpress)\b", meant("find")),
)
