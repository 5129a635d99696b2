"""Bodies in words, at the beginning of a line."""

from __future__ import annotations

from restitution.language.slip_tables.patterns import (
    BALL,
    CUT,
    MANY,
    NAME,
    NAMES,
    RESTITUTION,
    STOPS,
    STRIKES,
    Cure,
    Slip,
    meant,
)

BODIES: tuple[Slip, ...] = (
    (
        "other let wall sphere",
        rf"^\s*(?P<x>{MANY}(?P<k>{BALL})\s+)(?={NAME}\b)",
        Cure("did you mean 'sphere …'?", "sphere"),
    ),
    (
        "other let wall",
        rf"^\s*(?P<x>{MANY}(?:walls?|barriers?|cushions?)\s+)(?={NAME}\b)(?<!^wall\s)",
        Cure("did you mean 'wall …'?", "wall"),
    ),
    (
        "other let",
        (
            rf"^\s*(?P<x>(?:let\s+)?(?P<n>{NAMES})\s+(?:is|are|be)\s+{MANY}{BALL}"
            r"(?P<more>\s+(?:of|with|which\s+has))?)\b"
        ),
        Cure("did you mean 'sphere {n}'?", "sphere {n}{more}"),
    ),
    (
        "other let",
        rf"^\s*(?P<x>(?:let\s+)?(?P<n>{NAMES})\s+(?:is|are|be)\s+{MANY}walls?)\b",
        meant("wall {n}"),
    ),
    (
        "other",
        rf"^\s*(?P<x>(?P<n>{NAMES})\s+(?:has|have|is\s+of|are\s+of)\s+mass(?:es)?(?:\s+of)?)\b",
        meant("sphere {n}: mass"),
    ),
    (
        "other",
        (
            rf"^\s*(?P<x>(?P<n>{NAME})\s+(?:(?:initially|now|then)\s+)?"
            r"(?:has|is\s+(?:moving|travelling)(?:\s+with)?|(?:moves|travels)(?:\s+with)?)\s+"
            r"(?:an?\s+)?(?:initial\s+)?(?P<q>velocity|speed)(?:\s+of)?)\b"
        ),
        Cure(
            "did you mean 'sphere {n}: velocity …', at the start, or 'given {q}({n}) = …'?",
            "sphere {n}: velocity",
            more=("given {q}({n}) =",),
        ),
    ),
    (
        "other sphere",
        (
            r"^\s*(?P<x>[Ii]t|(?:[Tt]he\s+)?(?:sphere|ball|particle))\s+(?:then\s+|now\s+)?"
            rf"(?=(?:hits|receives|reaches|{STRIKES})\b)"
        ),
        "it is called by its name, as in 'sphere P: velocity 3i'",
    ),
    ("sphere", r"^\s*sphere(?P<x>)\s*(?::|$)", Cure("a sphere has a name, such as P", " P")),
    ("wall", r"^\s*wall(?P<x>)\s*(?::|$)", Cure("a wall has a name, such as W", " W")),
    (
        "sphere wall point",
        rf"^\s*\w+\s+{NAMES}\s*:.*[^:,\s](?P<x>\s*[:;,.]+)\s*$",
        Cure("leave out '{x}' at the end", ""),
    ),
    (
        "sphere wall point",
        rf"^\s*\w+\s+{NAME}(?:\s*,\s*{NAME})*\s+[a-z][^:]*[^:,\s](?P<x>\s*:+)\s*$",
        Cure("leave out '{x}' at the end", ""),
    ),
    ("other", rf"^\s*(?P<x>{NAME})\s*:\s*\(", Cure("did you mean 'point {x}: …'?", "point {x}")),
    (
        "other",
        rf"^\s*(?P<x>{NAME})\s*:\s*(?:along|parallel|through|from)\b",
        Cure("did you mean 'wall {x}: …'?", "wall {x}"),
    ),
    (
        "other",
        r"^\s*(?P<x>[Ww]ork\s+out|[Ww]rite\s+down|[Ff]ind\s+out|[Ss]olve\s+for|[Gg]ive)\b",
        meant("find"),
    ),
    ("other", r"^\s*(?P<x>[Ww]hat\s+(?:is|are)\b)", meant("find")),
    (
        "other",
        rf"^\s*(?P<x>(?P<body>{NAME})\s+(?:then\s+|now\s+)?{STOPS})",
        meant("given {body} at rest"),
    ),
    ("other", rf"^\s*(?P<x>{NAME}\s+is\s+(?:deflected|turned)\b.*?)\s*$", meant("given {x}")),
    (
        "other",
        rf"^\s*{NAME}\s+(?P<x>then|now|next|also)\s+(?:hits|receives|reaches|{STRIKES})\b",
        CUT,
    ),
    (
        "other",
        (
            rf"^\s*(?P<x>(?:[Tt]he\s+)?{RESTITUTION}\s*(?:\be\b)?\s*(?:=|:|is\b)?)"
            r"\s*(?=[\d½¼¾⅓⅔.])"
        ),
        meant("given e ="),
    ),
    (
        "other",
        (
            r"^\s*(?P<x>(?:[Tt]he\s+)?(?P<fact>(?:(?:final|initial|new|kinetic)\s+)*"
            r"(?:speed|velocity|direction|deflection|energy|impulse|momentum|mass|angle)\b"
            r".*?\b(?:is|equals?)\b.*?))\s*$"
        ),
        meant("given {fact}"),
    ),
    (
        "other",
        rf"^\s*(?P<x>(?P<b>{NAME})\s+(?:is\s+)?(?:hit|struck)\s+by\s+(?P<a>{NAME}))",
        meant("{a} hits {b}"),
    ),
    ("event", r"^[^:]*\s(?P<x>again)\s*:", CUT),
    ("other", r"^\s*(?P<x>//|--|%|\*).*$", Cure("a comment begins with '#'", "#")),
    (
        "other",
        r"^\s*(?P<x>(?:if|where|with|when|assuming|since|because)\b(?:\s+that\b)?)",
        meant("given"),
    ),
    (
        "other",
        rf"^\s*{NAME}\s+(?P<x>(?:arrives\s+at|comes\s+to(?!\s+rest)|gets\s+to|goes\s+to)\b)",
        meant("reaches"),
    ),
    ("find show given let", r"^\s*\w+\s*(?P<x>:)", CUT),
    (
        "other",
        r"^\s*(?P<x>\(?(?P<label>[a-z]|[ivx]{2,4}|\d)[).](?!\d)).*$",
        Cure("a part begins with a line 'part {label}'", "part {label}\n"),
    ),
    (
        "other",
        (
            rf"^\s*(?P<all>(?P<a>{NAME})\s+and\s+(?P<b>{NAME})\s+(?P<x>(?:will\s+|then\s+)?collide)"
            r"(?!\s+again)\b(?:\s+(?:directly|obliquely))?).*$"
        ),
        Cure("did you mean '{a} hits {b}'?", "{a} hits {b}", of="all"),
    ),
    (
        "other event",
        rf"^\s*(?:then\s+)?{NAME}\s+(?P<x>{STRIKES})\s+(?!.*\bagain\b)(?:the\s+)?\w+",
        meant("hits"),
    ),
    (
        "event",
        rf"^\s*{NAME}\s+receives\s+(?P<x>(?:an?\s+)?impulse(?:\s+of)?(?:\s+magnitude)?\b)",
        CUT,
    ),
    (
        "other",
        rf"^\s*{NAME}\s+(?P<x>(?:gets|is\s+given)\b)",
        meant("receives"),
    ),
    (
        "other",
        r"^\s*(?P<x>(?:[Tt]he\s+)?lines?\s+(?:of\s+cent(?:re|er)s?|joining\s+(?:the(?:ir)?\s+)?cent(?:re|er)s)\b.*?(?:is|:|=))",
        "the line of centres stands on the line of an impact: 'A hits B: along i'",
    ),
    ("other", r"^\s*(?P<x>[Tt]hen|[Nn]ow|[Nn]ext|[Tt]he|[Hh]ence|[Tt]hus|[Aa]lso)\b", CUT),
    (
        "other",
        rf"^\s*(?P<x>{NAME}(?:\s*,\s*{NAME})*)\s*:",
        Cure("did you mean 'sphere {x}: …'?", "sphere {x}"),
    ),
    (
        "event",
        r"^\s*(?P<x>.*\bagain\b.*?)\s*$",
        Cure("a fact is 'given {x}'; an event has no 'again'", "given {x}"),
    ),
    (
        "other",
        (
            r"^\s*(?P<x>[^=<>≤≥:\s][^=<>≤≥:]*(?:[=<>≤≥]\s*\S|\bcollide\s+again|\bat\s+rest\b"
            r"|\bdo\s+not\s+collide|\bdoes\s+not\s+hit"
            r"|\bhit(?:s)?\b.*\bagain|\bwill\s+(?:not\s+)?hit\b"
            r"|\b(?:perpendicular|parallel|opposite)\s+to\b).*?)\s*$"
        ),
        meant("given {x}"),
    ),
    (
        "sphere wall",
        rf"^\s*(?P<x>(?:sphere|wall)\s+)(?={NAME}\s+(?:{STRIKES}|hits|receives)\b)",
        CUT,
    ),
    ("let", r"^\s*let\s+\S+\s+(?P<x>be(?:\s+equal\s+to)?|denote|is)\b", meant("=")),
    (
        "let",
        r"^\s*(?P<x>let\s+(?!\w+\s*(?:=|,|$))(?P<fact>\S.*[=<>].*?))\s*$",
        meant("given {fact}"),
    ),
    ("given show find", r"^\s*\w+\s+(?P<x>that\b)", CUT),
)
