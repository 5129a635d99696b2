"""Relations, signs, and words too many."""

from __future__ import annotations

from restitution.language.slip_tables.patterns import ASKING_LINES, CUT, NAME, Cure, Slip, meant

RELATIONS: tuple[Slip, ...] = (
    # relations
    (
        "",
        (
            rf"\b(?:to|from|of|hits|with|along|receives|reaches|,|\()\s*"
            rf"(?P<x>(?:the\s+)?(?:wall|sphere|ball|particle|point))\s+(?=\(|{NAME}\b)"
        ),
        CUT,
    ),
    ("", r"(?P<x>(?P<o>[<>])\s+=)", meant("{o}=")),
    (
        "given show",
        r"(?P<x>(?P<q>[^\s,]+)\s+(?:is\s+|lies\s+)?between\s+(?P<a>[^\s,]+)\s+and\s+(?P<b>[^\s,]+))",
        meant("{a} < {q} < {b}"),
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<body>{NAME})\s+(?:now\s+)?(?:is\s+)?(?:moves|moving|travels|travelling)\b)",
        meant("velocity({body})"),
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<body>{NAME})\s+(?:rests|stops|comes\s+to\s+rest|is\s+brought\s+to\s+rest))\b",
        meant("{body} at rest"),
    ),
    (
        "given show",
        r"(?P<x>\bdon['’]t\s+collide(?:\s+again)?)",
        meant("do not collide again"),
    ),
    ("given show", r"(?P<x>\bdoesn['’]t\s+hit)\b", meant("does not hit")),
    ("given show", r"(?P<x>\bwon['’]t\s+hit)\b", meant("will not hit")),
    ("", r"(?P<x>={2,3})", meant("=")),
    ("", r"(?P<x>=\s*<)", meant("<=")),
    ("", r"(?P<x>=\s*>)", meant(">=")),
    (
        "",
        (
            r"(?P<x>\b(?:is|are)(?:\s+equal)?)\s+(?=(?:not\s+)?(?:perpendicular|parallel|opposite"
            r"|at\s+rest|in\s+the\s+direction))"
        ),
        CUT,
    ),
    ("given show", r"(?P<x>\bis\s+(?:less|smaller)\s+than)\b", meant("<")),
    ("given show", r"(?P<x>\bis\s+(?:greater|more|larger|bigger)\s+than)\b", meant(">")),
    ("given show", r"(?P<x>\b(?:is\s+)?at\s+least)\b", meant(">=")),
    ("given show", r"(?P<x>\b(?:is\s+)?at\s+most)\b", meant("<=")),
    (
        "given show",
        r"(?P<x>\b(?:is|are)\s+(?:perp\w*|at\s+right\s+angles)(?:\s+(?:to|with))?)",
        meant("perpendicular to"),
    ),
    ("given show let", r"(?P<x>\b(?:is\s+equal\s+to|equals?(?:\s+to)?|is))\b", meant("=")),
    (
        "given show",
        (
            r"(?P<x>\bperp\b\.?(?:\s+(?:to|with)\b)?|\bperpendicular\b(?!\s+to\b)(?:\s+with\b)?|[⊥⟂]"
            r"|\bnormal\s+to\b|\bat\s+right\s+angles\s+(?:to|with)\b)"
        ),
        meant("perpendicular to"),
    ),
    (
        "given show",
        r"(?P<x>\bparallel\b(?!\s+to\b)(?:\s+with\b)?|[∥‖]|\|\|)",
        meant("parallel to"),
    ),
    (
        "given show",
        r"(?P<x>\bin\s+(?:the\s+)?(?:same\s+)?direction(?:\s+(?:of|as))?\b)",
        meant("in the direction of"),
    ),
    (
        "given show",
        (
            r"(?P<x>(?:(?:do|does|will|can|cannot|must)\s+)?(?:not\s+)?(?:further\s+|ever\s+)?"
            r"(?:collide|meet)s?\b(?!\s+again)(?:\s+\w+){0,4})"
        ),
        "did you mean 'collide again' or 'do not collide again'?",
    ),
    (
        "given show",
        r"(?P<x>\b(?:will|do|does)\s+(?:(?P<no>not)\s+)?collide\s+again)",
        "did you mean 'collide again' or 'do not collide again'?",
    ),
    # signs, and words too many
    ("", r"(?P<x>[.;?!])\s*$", CUT),
    ("", r"(?P<x>;)", Cure("did you mean ','?", ",", tight=True)),
    (
        ASKING_LINES,
        r"(?P<x>\b(?:the\s+)?(?:(?:exact|possible)\s+)?value\s+of)\b",
        CUT,
    ),
    ("", r"(?P<x>\b(?:the|smooth))\b\s*", CUT),
    (
        "find given unknown show sphere wall event",
        r"(?P<x>\band\b)",
        Cure("did you mean ','?", ",", tight=True),
    ),
)
