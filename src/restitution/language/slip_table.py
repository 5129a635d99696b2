"""What people write in place of the language: patterns, each with its cure.

A pattern tells where a slip is found, its group ``x`` (else all of it) what is wrong there.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Cure:
    """What to say of a slip, and what to write for its ``x``; both may name groups of the pattern.

    ``tight`` takes the place of the blanks before it too. ``of`` is the group that is written anew.
    ``more`` is what else may be meant; ``{sphere}`` in ``text`` is each of the spheres in turn, or
    all of them ``together``.
    """

    message: str
    text: str
    tight: bool = False
    of: str = "x"
    more: tuple[str, ...] = ()
    together: bool = False


def _meant(text: str, more: str = "") -> Cure:
    return Cure(f"did you mean '{text}'?{more}", text)


def _either(*texts: str) -> Cure:
    listed = " or ".join(f"'{each}'" for each in texts)
    return Cure(f"did you mean {listed}?", texts[0], more=texts[1:])


_CUT = Cure("leave out '{x}'", "")


NAME = r"[A-Z][A-Za-z0-9]*"


_BODY = rf"(?:the\s+)?(?:(?:sphere|ball|particle|wall)\s+)?(?P<body>{NAME})\b"


_KINETIC = r"(?:kinetic\s+energy|KE|K\.E\.|energy)"


_LOST = r"(?:(?:that|which)\s+)?(?:(?:is|was|has\s+been)\s+)?(?:lost|loss)\b"


_BODIES = "sphere wall"


_ASKED = "find show given let"


_STOPS = r"(?:rests|stops|comes\s+to\s+rest|is\s+brought\s+to\s+rest)\b"


_NAMES = rf"{NAME}(?:\s*(?:,|&|\band\b)\s*{NAME})*"


_BALL = r"(?:spheres?|balls?|particles?|disc?s?|disks?|pucks?|marbles?)"


_MANY = (
    r"(?:(?:let|there\s+(?:is|are)|the|[Aa]n?|another|[Tt]wo|[Tt]hree|smooth|uniform|small|identical"
    r"|equal|solid|fixed|vertical|straight)\s+)*"
)


_RESTITUTION = r"coefficient\s+of\s+restitution(?:\s+between\s+\w+\s+and\s+\w+)?"


_AFTER = (
    r"(?:\s+(?:immediately\s+|just\s+)?after(?:wards)?\b(?!\s+(?:each|every|both|all)\b)"
    r"(?:\s+\w+){0,3})"
)


# A size that is a number or a letter, perhaps with its unit; and what stands before a direction.
_SIZE = (
    r"(?P<v>\d[\d.]*(?:/\d+)?(?:\s?[a-z](?![\w/]|\s+s))?|[a-z](?:_?\d)?)"
    r"(?:\s*(?P<unit>m\s*/\s*s|m\s?s\s?\^?-1|ms⁻¹|m\s?s⁻¹|N\s?s))?"
)


_ALONG = (
    r"(?:along|in\s+(?:the\s+)?(?:same\s+)?(?:positive\s+)?direction(?:\s+of)?)(?:\s+the)?"
    r"(?:\s+(?:vector|direction(?:\s+of)?))?"
)


# A wall or a ball is struck in many words.
_STRIKES = (
    r"(?:(?:then|now|next)\s+)?(?:(?:directly|obliquely|also)\s+)?"
    r"(?:collides?\s+(?:(?:directly|obliquely)\s+)?(?:with|into)|collides?|strikes?|struck|hit"
    r"|impacts?(?:\s+(?:on|with))?|bumps?\s+into|(?:bounces?|rebounds?)\s+(?:off|on|against|from)"
    r"|meets?|impinges?\s+on|hits\s+(?:into|against|with|on))"
)


# Lines by their first word (any, where there is none), pattern, and what to say: with a cure where
# that is certain.
SLIPS: tuple[tuple[str, str, Cure | str], ...] = (
    # how a line begins
    # bodies in words
    (
        "other let wall sphere",
        rf"^\s*(?P<x>{_MANY}(?P<k>{_BALL})\s+)(?={NAME}\b)",
        Cure("did you mean 'sphere …'?", "sphere"),
    ),
    (
        "other let wall",
        rf"^\s*(?P<x>{_MANY}(?:walls?|barriers?|cushions?)\s+)(?={NAME}\b)(?<!^wall\s)",
        Cure("did you mean 'wall …'?", "wall"),
    ),
    (
        "other let",
        (
            rf"^\s*(?P<x>(?:let\s+)?(?P<n>{_NAMES})\s+(?:is|are|be)\s+{_MANY}{_BALL}"
            r"(?P<more>\s+(?:of|with|which\s+has))?)\b"
        ),
        Cure("did you mean 'sphere {n}'?", "sphere {n}{more}"),
    ),
    (
        "other let",
        rf"^\s*(?P<x>(?:let\s+)?(?P<n>{_NAMES})\s+(?:is|are|be)\s+{_MANY}walls?)\b",
        _meant("wall {n}"),
    ),
    (
        "other",
        rf"^\s*(?P<x>(?P<n>{_NAMES})\s+(?:has|have|is\s+of|are\s+of)\s+mass(?:es)?(?:\s+of)?)\b",
        _meant("sphere {n}: mass"),
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
            rf"(?=(?:hits|receives|reaches|{_STRIKES})\b)"
        ),
        "it is called by its name, as in 'sphere P: velocity 3i'",
    ),
    ("sphere", r"^\s*sphere(?P<x>)\s*(?::|$)", Cure("a sphere has a name, such as P", " P")),
    ("wall", r"^\s*wall(?P<x>)\s*(?::|$)", Cure("a wall has a name, such as W", " W")),
    (
        "sphere wall point",
        rf"^\s*\w+\s+{_NAMES}\s*:.*[^:,\s](?P<x>\s*[:;,.]+)\s*$",
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
        _meant("find"),
    ),
    ("other", r"^\s*(?P<x>[Ww]hat\s+(?:is|are)\b)", _meant("find")),
    (
        "other",
        rf"^\s*(?P<x>(?P<body>{NAME})\s+(?:then\s+|now\s+)?{_STOPS})",
        _meant("given {body} at rest"),
    ),
    ("other", rf"^\s*(?P<x>{NAME}\s+is\s+(?:deflected|turned)\b.*?)\s*$", _meant("given {x}")),
    (
        "other",
        rf"^\s*{NAME}\s+(?P<x>then|now|next|also)\s+(?:hits|receives|reaches|{_STRIKES})\b",
        _CUT,
    ),
    (
        "other",
        (
            rf"^\s*(?P<x>(?:[Tt]he\s+)?{_RESTITUTION}\s*(?:\be\b)?\s*(?:=|:|is\b)?)"
            r"\s*(?=[\d½¼¾⅓⅔.])"
        ),
        _meant("given e ="),
    ),
    (
        "other",
        (
            r"^\s*(?P<x>(?:[Tt]he\s+)?(?P<fact>(?:(?:final|initial|new|kinetic)\s+)*"
            r"(?:speed|velocity|direction|deflection|energy|impulse|momentum|mass|angle)\b"
            r".*?\b(?:is|equals?)\b.*?))\s*$"
        ),
        _meant("given {fact}"),
    ),
    (
        "other",
        rf"^\s*(?P<x>(?P<b>{NAME})\s+(?:is\s+)?(?:hit|struck)\s+by\s+(?P<a>{NAME}))",
        _meant("{a} hits {b}"),
    ),
    ("event", r"^[^:]*\s(?P<x>again)\s*:", _CUT),
    ("other", r"^\s*(?P<x>//|--|%|\*).*$", Cure("a comment begins with '#'", "#")),
    (
        "other",
        r"^\s*(?P<x>(?:if|where|with|when|assuming|since|because)\b(?:\s+that\b)?)",
        _meant("given"),
    ),
    (
        "other",
        rf"^\s*{NAME}\s+(?P<x>(?:arrives\s+at|comes\s+to(?!\s+rest)|gets\s+to|goes\s+to)\b)",
        _meant("reaches"),
    ),
    ("find show given let", r"^\s*\w+\s*(?P<x>:)", _CUT),
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
        rf"^\s*(?:then\s+)?{NAME}\s+(?P<x>{_STRIKES})\s+(?!.*\bagain\b)(?:the\s+)?\w+",
        _meant("hits"),
    ),
    (
        "event",
        rf"^\s*{NAME}\s+receives\s+(?P<x>(?:an?\s+)?impulse(?:\s+of)?(?:\s+magnitude)?\b)",
        _CUT,
    ),
    (
        "other",
        rf"^\s*{NAME}\s+(?P<x>(?:gets|is\s+given)\b)",
        _meant("receives"),
    ),
    (
        "other",
        r"^\s*(?P<x>(?:[Tt]he\s+)?lines?\s+(?:of\s+cent(?:re|er)s?|joining\s+(?:the(?:ir)?\s+)?cent(?:re|er)s)\b.*?(?:is|:|=))",
        "the line of centres stands on the line of an impact: 'A hits B: along i'",
    ),
    ("other", r"^\s*(?P<x>[Tt]hen|[Nn]ow|[Nn]ext|[Tt]he|[Hh]ence|[Tt]hus|[Aa]lso)\b", _CUT),
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
        _meant("given {x}"),
    ),
    (
        "sphere wall",
        rf"^\s*(?P<x>(?:sphere|wall)\s+)(?={NAME}\s+(?:{_STRIKES}|hits|receives)\b)",
        _CUT,
    ),
    ("let", r"^\s*let\s+\S+\s+(?P<x>be(?:\s+equal\s+to)?|denote|is)\b", _meant("=")),
    (
        "let",
        r"^\s*(?P<x>let\s+(?!\w+\s*(?:=|,|$))(?P<fact>\S.*[=<>].*?))\s*$",
        _meant("given {fact}"),
    ),
    ("given show find", r"^\s*\w+\s+(?P<x>that\b)", _CUT),
    # properties
    ("let", r"(?P<x>,)\s*\w+\s*=", "a line 'let' names one quantity"),
    ("", r"(?:\bmass\b|\bradius\b|=)\s*\d+(?P<x>,)\d", Cure("a decimal point is '.'", ".")),
    ("point", r":\s*(?P<x>[^()\s,]+\s*,\s*[^()\s,]+)\s*$", _meant("({x})")),
    (
        "given let show",
        r"=.*\s(?P<x>find|show|given|let|unknown)\b",
        Cure("'{x}' begins a line of its own", "\n{x}", tight=True),
    ),
    ("given let show", r"(?:\d|%)\s+(?P<x>of)\b", _CUT),
    (
        "given show",
        rf"(?P<x>\b(?P<a>{NAME})\s+will\s+(?:hit|strike|collide\s+with)\s+(?P<b>{NAME})\s+again)",
        _meant("{a} hits {b} again"),
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<a>{NAME})\s+hits\s+(?P<b>{NAME}))\s*(?:,|$)",
        _either("{a} will hit {b}", "{a} hits {b} again"),
    ),
    (
        "find",
        r"(?P<x>\b(?:the\s+)?(?P<q>[a-zα-ω](?:_?\w)?)\s+range)\s*(?:,|$)",
        _meant("range of {q}"),
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<body>{NAME})\s+is\s+(?:deflected|turned)\s+(?:through|by)\b)",
        _meant("deflection({body}) ="),
    ),
    ("event", r"(?P<x>\b(?:perfectly\s+)?elastic)\b", _meant("e = 1")),
    ("event", r"(?P<x>\bperfectly\s+inelastic)\b", _meant("e = 0")),
    (
        "event",
        r"\breceives\s.*\s(?P<x>along|in\s+the\s+direction\s+of)\b",
        _meant("at 0° from"),
    ),
    (
        "find show",
        r"imum\s+of\b.*?\s(?P<x>wrt|with\s+respect\s+to|for|as)\b.*$",
        _meant("over"),
    ),
    (
        "sphere wall event",
        r":.*\s(?P<x>find|show|given|let|unknown)\b",
        Cure("'{x}' begins a line of its own", "\n{x}", tight=True),
    ),
    ("sphere wall event", r"(?P<x><(?P<v>[^<>]*,[^<>]*)>)", _meant("({v})")),
    ("sphere event", r"[ij]\s*(?P<x>,)\s*[-+−]?\s*[\d.]*\s*[a-z]?\s*[ij]\b", _meant("+")),
    (
        "sphere",
        (
            r"\bvelocity\s+(?P<x>(?P<a>[\d.\w]+(?:\s*m)?(?:\s*/\s*s)?)\s*,?\s*"
            r"(?:in\s+)?(?:the\s+)?(?:direction\s+)?(?P<b>\d[\d.]*\s*(?:°|deg(?:rees?)?)))"
        ),
        _meant("{a} at {b}"),
    ),
    (
        "sphere",
        r"[:,]\s*(?P<x>(?:velocity|speed)\s+(?:is\s+|=\s*)?(?:at\s+rest|zero|nil|none))\b",
        _meant("at rest"),
    ),
    ("sphere", r"\bat\s+rest\s+(?P<x>initially|at\s+first|at\s+the\s+start)\b", _CUT),
    (
        "sphere event",
        rf"\b(?:velocity|speed|receives)\s+(?P<x>{_SIZE}\s+{_ALONG}\s*(?P<d>[ij]))\s*(?:,|$)",
        Cure("did you mean {each}?", "{v}{gap}{d} {unit}"),
    ),
    (
        "sphere event",
        rf"\b(?:velocity|speed|receives)\s+(?P<x>{_SIZE}\s+parallel\s+to\s+(?P<d>[ij]))\s*(?:,|$)",
        Cure("did you mean {each}?", "{v}{gap}{d} {unit}", more=("-{v}{gap}{d} {unit}",)),
    ),
    (
        "sphere event",
        (
            rf"\b(?:velocity|speed|receives)\s+{_SIZE}\s+(?P<x>{_ALONG})"
            r"\s*(?=[-\d(]*\s*[\w]*\s*[ij,])"
        ),
        _meant("at 0° from"),
    ),
    *(
        (
            "sphere event",
            (
                rf"\b(?:velocity|speed|receives)\s+(?P<x>{_SIZE}\s+(?:(?:to|towards)\s+the\s+|due\s+|in\s+the\s+)?"
                rf"(?:{words})(?:\s+direction)?)\s*(?:,|$)"
            ),
            Cure("did you mean {each}?", f"{sign}{{v}}{{gap}}{vector} {{unit}}"),
        )
        for words, sign, vector in (
            ("right|east", "", "i"),
            ("left|west", "-", "i"),
            ("north", "", "j"),
            ("south", "-", "j"),
        )
    ),
    (
        "sphere",
        r"\bvelocity\s[^,]*?(?P<x>\b(?:to)?wards?\b[^,]*|\baway\s+from\b[^,]*)",
        "a direction is told by an angle or a vector: 'velocity 3 at 30°', 'velocity -3i'",
    ),
    (
        "sphere event",
        r"(?P<x>\bin\s+(?:the\s+|an?\s+)?(?:(?:same|opposite)\s+)?direction(?:\s+(?:of|to)\b[^,]*)?)",
        "a direction is told by an angle: 'u at 30°', or 'u at 0° from 3i + 4j'",
    ),
    ("", r"(?P<x>\b(?:anticlockwise|counterclockwise|counter-clockwise))\b", _CUT),
    ("", r"(?P<x>\bclockwise)\b", "angles are anticlockwise: write a negative one"),
    ("", r"\bat\s[^,]*(?P<x>\babove)\b", _meant("from")),
    (
        "sphere",
        r"\bat\s+(?P<x>(?P<v>-?[\w.]{1,4}\s*,\s*-?[\w.]{1,4}))\s*(?:,|$)",
        _meant("({v})"),
    ),
    ("event", r"(?P<x>\bat\s+(?:time\s+)?t\s*=)", "a time is a fact: 'given time(1) = …'"),
    ("", r"(?P<x>(?P<a>\w)_\{(?P<b>\d+|\w)\})", _meant("{a}_{b}")),
    (
        "",
        r"(?P<x>\b(?P<q>sin|cos|tan)\s*[-−–]\s?1\b|\binverse\s+(?P<p>sin|cos|tan)\b)",
        _meant("arc{q}{p}"),
    ),
    (
        _BODIES,
        rf"^\s*\w+\s+{NAME}(?:\s*,\s*{NAME})*\s+(?P<x>and)\s+{NAME}",
        Cure("did you mean ','?", ",", tight=True),
    ),
    (
        _BODIES,
        (
            rf"^\s*\w+\s+{NAME}(?:\s*,\s*{NAME})*\s*(?P<x>,?\s*(?:has|have|of|with|is|lies|moves)\b"
            r"|[,;=–-])\s*(?=[a-z])"
        ),
        Cure("expected ':' here", ":", tight=True),
    ),
    (
        _BODIES,
        (
            rf"^\s*\w+\s+{NAME}(?:\s*,\s*{NAME})*\s+"
            r"(?P<x>mass|velocity|speed|at|radius|along|parallel|through|from|circle)\b"
        ),
        Cure("expected ':' before '{x}'", ": {x}", tight=True),
    ),
    (
        "event",
        rf"^\s*{NAME}\s+hits\s+{NAME}\s*:?\s*,?\s*(?P<x>(?:(?:which|that)\s+is\s+)?(?:initially\s+)?at\s+rest)\b",
        "'at rest' stands on the line of a sphere: 'sphere B: at rest'",
    ),
    (
        "event",
        rf"^\s*{NAME}\s+hits\s+{NAME}\s*(?P<x>,?\s*(?:directly|obliquely|head\s*-?\s*on))\b",
        _CUT,
    ),
    (
        "event",
        rf"^\s*{NAME}\s+hits\s+{NAME}\s*:?\s*(?P<x>along\s+(?:the\s+|their\s+)?lines?\s+of\s+cent(?:re|er)s?)(?=\s+\w|\s*[,:])",
        _CUT,
    ),
    (
        "event",
        rf"^\s*{NAME}\s+hits\s+{NAME}\s*(?P<x>,?\s*(?:with|where|when|as|and(?!\s+[A-Z])|at)\b|,(?!\s*[A-Z]))",
        Cure("expected ':' here", ":", tight=True),
    ),
    (
        "event",
        r":.*?[^\s:,]\s+(?P<x>with|where|when)\s+(?=(?:an?\s+|the\s+)?(?:e\b|coefficient|along|offset|line))",
        Cure("did you mean ','?", ",", tight=True),
    ),
    (
        "event",
        rf"^\s*{NAME}\s+hits\s+{NAME}\s+(?P<x>along|e|offset|coefficient|line)\b",
        Cure("expected ':' before '{x}'", ": {x}", tight=True),
    ),
    ("event", r"[:,]\s*(?P<x>e)\s+(?=[\d½¼¾⅓⅔])", _meant("e =")),
    (
        "event",
        r"\balong\b[^,:=]*?(?P<x>\s+(?:e\s*)?(?P<v>\d[\d./]*%?))\s*(?:,|$)",
        Cure("did you mean ', e = {v}'?", ", e = {v}", tight=True),
    ),
    (
        "",
        r"(?<![a-z])(?:[a-z]\s*)?i\s+(?P<x>\d[\d./]*\s*(?:[a-z]\s*)?j)(?!\w)",
        _meant("+ {x}"),
    ),
    ("event", r"[:,]\s*(?P<x>restitution\s*(?:=|is|of)?)\s*(?=[\d½¼¾⅓⅔])", _meant("e =")),
    (
        "event",
        r"[:,]\s*(?P<x>(?:perpendicular\s+)?distance(?:\s+(?:of|is)|\s*=)?)\s*(?=[-+\d(√.a-z])",
        _meant("offset"),
    ),
    (
        "other",
        (
            rf"^\s*(?P<x>(?:[Cc]ollision|[Ii]mpact)\s+(?:between|of)\s+(?P<a>{NAME})\s+"
            rf"(?:and|with)\s+(?P<b>{NAME}))"
        ),
        _meant("{a} hits {b}"),
    ),
    (
        "other",
        (
            r"^\s*(?P<x>(?:[Aa]n\s+)?[Ii]mpulse\s+(?:of\s+)?(?P<v>[^,]+?)\s+(?:is\s+(?:given|applied)\s+to"
            rf"|acts\s+on|on|to)\s+(?P<n>{NAME}))\s*$"
        ),
        _meant("{n} receives {v}"),
    ),
    ("event", r"[:,]\s*(?P<x>(?P<e>e|\d[\d./]*|[½¼¾⅓⅔]))\s*(?:,|$)", _meant("e = {e}")),
    (
        "event",
        r"(?P<x>coefficient(?:\s+of\s+restitution)?\s+(?:is\s+)?(?P<e>[a-z]))\s*(?:,|$)",
        _meant("e = {e}"),
    ),
    (
        "event",
        r"(?P<x>coefficient(?:\s+of\s+restitution)?\s*(?:\be\b)?\s*(?:=|:|is\b|of\b)?)",
        _meant("e ="),
    ),
    ("event", r"\be\s*(?P<x>:|is\b|of\b)", _meant("=")),
    (
        "sphere",
        rf"^\s*\w+\s+{NAME}\s*(?P<x>\((?P<p>[^()]*(?:\([^()]*\)[^()]*)*)\))\s*$",
        Cure("did you mean ': {p}'?", ": {p}", tight=True),
    ),
    (
        "event",
        rf"^\s*{NAME}\s+hits\s+{NAME}\s*(?P<x>\((?P<p>[^()]*(?:\([^()]*\)[^()]*)*)\))\s*$",
        Cure("did you mean ': {p}'?", ": {p}", tight=True),
    ),
    (
        "sphere",
        (
            r":.*?[^\s:,](?<!moving)(?<!moves)(?<!travelling)\s+"
            r"(?P<x>(?:with|and|of|has|having|[-–])(?:\s+an?)?)\s+"
            r"(?=(?:mass|velocity|radius|speed|(?:is\s+)?at\s+rest)\b)"
        ),
        Cure("did you mean ','?", ",", tight=True),
    ),
    (
        "sphere",
        (
            r"(?<=[^\s:,])\s+(?P<x>moving|moves|travelling|stationary|initially|(?:initial\s+)?speed"
            r"|initial\s+velocity)\b"
        ),
        Cure("expected ',' before '{x}'", ", {x}", tight=True),
    ),
    (
        "sphere event",
        r"(?<=[^\s:,])\s+(?P<x>mass|velocity|radius|along|offset|at\s+rest|at(?=\s*\())\b",
        Cure("expected ',' before '{x}'", ", {x}", tight=True),
    ),
    (
        "event",
        r":.*[^\s:,]\s+(?P<x>e)\s*=",
        Cure("expected ',' before '{x}'", ", {x}", tight=True),
    ),
    (
        "event",
        r"\bhits\s+(?P<x>(?:the\s+)?(?:[Ww]all|[Ss]phere|[Bb]all))\s*(?::|$)",
        "expected the name of a sphere or a wall after 'hits'",
    ),
    (
        "event",
        r"(?P<x>along\s+(?:the\s+)?lines?\s+of\s+cent(?:re|er)s?)\s*(?:,|$)",
        "the line of centres is told by its direction, such as along i",
    ),
    (
        "event",
        (
            r"[:,]\s*(?P<x>(?:with\s+)?(?:along\s+)?(?:the\s+)?(?:lines?[\s_]+of[\s_]+cent(?:re|er)s?|parallel\s+to|direction|at)"
            r"(?:\s+(?:is|along|at|parallel\s+to|in\s+the\s+direction(?:\s+of)?)\b|\s*=)?)"
        ),
        _meant("along"),
    ),
    (
        "event",
        r"[:,]\s*(?P<x>mass|velocity|radius)\b",
        "'{x}' stands on the line of a sphere: 'sphere A: {x} …'",
    ),
    (
        "sphere wall",
        r"[:,]\s*(?P<x>e|coefficient(?:\s+of\s+restitution)?)\s*(?:=|is\b|\d|½)",
        "the coefficient of restitution stands on the line of an impact: 'A hits B: e = …'",
    ),
    (
        "sphere wall event",
        r"\b(?:mass|velocity|radius|along|through|offset|from|at)\s*(?P<x>=|:|is\b|of\b)",
        _CUT,
    ),
    ("sphere", r"[:,]\s*(?P<x>[mM]\s*=)", _meant("mass")),
    (
        "sphere",
        (
            r"[:,]\s*(?P<x>(?!velocity\s*[^=\s])(?:[uvUV]\w*|speed|initial\s+(?:velocity|speed)|moving|moves"
            r"|travelling|moving\s+with\s+(?:velocity|speed))(?:\s*=|\b)(?:\s*(?:of|is|with\s+\w+|at(?!\s+rest))\b)?)"
        ),
        _meant("velocity"),
    ),
    ("sphere", r"[:,]\s*(?P<x>[rR]\s*=)", _meant("radius")),
    (
        "sphere",
        r"[:,]\s*(?P<x>(?:(?:is|initially)\s+)+at\s+rest|(?:initially\s+)?(?:rest|stationary|still)\b)",
        _meant("at rest"),
    ),
    ("sphere", r"[:,]\s*(?P<x>(?P<v>\d[\d.]*\s*k?g))\b", Cure("did you mean {each}?", "mass {v}")),
    (
        "sphere",
        (
            r"[:,]\s*(?P<x>(?P<v>\([^()]*[ij]\s*\)(?:\s*m\b[^,]*)?|(?:[-+−]?\s*(?:\d[\d.]*\s*)?(?:[a-hk-z]\s*)?[ij]\b\s*)+"
            r"|(?:\d[\d.]*|[a-z])\s*(?:m\s*/\s*s|ms-1|ms⁻¹)?\s+at\b[^,]*))\s*(?:,|$)"
        ),
        Cure("did you mean {each}?", "velocity {v}"),
    ),
    ("sphere", r"[:,]\s*(?P<x>weight)\b", _meant("mass")),
    ("sphere", r"[:,]\s*(?P<x>position|centre|initially\s+at|starts\s+at)\b", _meant("at")),
    (
        "sphere wall event",
        (
            r"(?P<x>,?\s*(?:(?:where|given(?:\s+that)?|with)\s+)?"
            r"(?P<fact>\b(?:sin|cos|tan)\s*\(?\s*\w+\s*\)?\s*=\s*[^\s,=][^,=]*?))\s*$"
        ),
        Cure("a fact stands on a line of its own: 'given {fact}'", "\ngiven {fact}", tight=True),
    ),
    (
        "sphere wall event",
        r"[,\s]\s*(?P<x>(?:where|given|when)\b|(?:sin|cos|tan)\s*\(?[^=,]*=)",
        "a fact stands on a line of its own: 'given tan(alpha) = 3/4'",
    ),
    (
        "wall",
        r"[:,]\s*(?P<x>(?:parallel\s+to|(?:in\s+(?:the\s+)?)?direction(?:\s+of)?|(?:inclined\s+)?at|angle)\b)",
        _meant("along"),
    ),
    ("wall", r"\balong\s[^,]*?(?P<x>\bto\s+(?:the\s+)?i)\s*(?:,|$)", _CUT),
    ("wall", r"[:,]\s*(?P<x>perp\w*\s+to\s+(?:the\s+)?i)\b", _meant("along j")),
    ("wall", r"[:,]\s*(?P<x>perp\w*\s+to\s+(?:the\s+)?j)\b", _meant("along i")),
    (
        "wall",
        r"[:,]\s*(?P<x>perp\w*(?:\s+to)?)",
        "a wall is told by its own direction, such as 'along j'",
    ),
    ("wall", r"[:,]\s*(?P<x>horizontal)\b", _meant("along i")),
    ("wall", r"[:,]\s*(?P<x>vertical)\b", _meant("along j")),
    (
        "wall",
        r"[:,]\s*(?P<x>y\s*=\s*(?P<c>[^,=xy]+?))\s*(?:,|$)",
        _meant("along i, through (0, {c})"),
    ),
    (
        "wall",
        r"[:,]\s*(?P<x>x\s*=\s*(?P<c>[^,=xy]+?))\s*(?:,|$)",
        _meant("along j, through ({c}, 0)"),
    ),
    ("wall", r":\s*(?P<x>(?:-?\s*\d*\s*[ij]\b|\(|\d+\s*°)[^,]*)", _meant("along {x}")),
    (
        "",
        (
            r"(?:\b(?:to|with|from|off|against|into|hits|reaches|of|on|by|and|between)\s+|[,(]\s*)"
            rf"(?P<x>the\s+(?:[Ww]all|[Ss]phere|[Bb]all|particle))\b(?!\s+(?:\(|{NAME}\b))"
        ),
        "it is called by its name, as in 'wall W: along i'",
    ),
    (
        "sphere event",
        (
            r"(?P<x>\b(?:(?:and\s+)?(?:making|which\s+makes|that\s+makes)\s+(?:an?\s+)?(?:acute\s+)?angle"
            r"(?:\s+of)?|(?:inclined|directed)\s+at))\b"
        ),
        _meant("at"),
    ),
    ("", r"\bat\s[^,]*?(?P<x>\b(?:to|with)\s+(?:the\s+)?horizontal)\b", _meant("from i")),
    ("", r"\bat\s[^,]*?(?P<x>\b(?:to|with)\s+(?:the\s+)?vertical)\b", _meant("from j")),
    (
        "sphere",
        r"(?P<x>\b(?:to|with|from)\s+(?:the\s+|their\s+)?lines?[\s_]of[\s_]cent(?:re|er)s?)\b",
        (
            "the line of centres stands on the line of the impact: with 'A hits B: along i', write "
            "'u at 30° from i'"
        ),
    ),
    # vectors
    ("", r"\bat\s+(?P<x>(?:an?\s+|the\s+)?(?:acute\s+)?angle(?:\s+of)?)(?!\s*\()", _CUT),
    (
        "",
        r"\bat\s(?!right\b)[^,]*?(?P<x>\b(?:to|with)\s+(?:the\s+)?(?:positive\s+)?(?P<d>-?\s*[ij])\b)",
        _meant("from {d}"),
    ),
    ("", rf"\bat\s[^,]*?(?P<x>\b(?:with|against|towards)\s+{_BODY})", _meant("to {body}")),
    *(
        (
            _ASKED,
            (
                rf"(?P<x>\b(?:the\s+)?(?P<q>speed|velocity|direction|energy)\s+of\s+{_BODY}\s+"
                r"(?:immediately\s+|just\s+)?after\s+(?:the\s+|its\s+)?"
                rf"(?:{words})\s+(?:collision|impact|event))"
            ),
            _meant(f"{{q}}({{body}}, {number})"),
        )
        for number, words in enumerate(("first|1st", "second|2nd", "third|3rd"), start=1)
    ),
    (
        _ASKED,
        r"(?P<x>\bafter\s+(?:each|every|both)\b(?:\s+\w+)?)",
        "the speed of A after event 1 is speed(A, 1), after event 2 speed(A, 2)",
    ),
    (
        "find",
        (
            r"(?P<x>\b(?:the\s+)?(?:acute\s+)?angle\s+between\s+(?:the\s+|their\s+)?(?:two\s+)?(?:final\s+)?"
            rf"(?:velocities|directions(?:\s+of\s+motion)?|paths)(?:\s+of\s+{_NAMES})?{_AFTER}?)"
        ),
        Cure(
            "did you mean 'angle(velocity(A), velocity(B))'?",
            "angle(velocity({first}), velocity({second}))",
        ),
    ),
    (
        _ASKED,
        r"(?P<x>\b(?:the\s+)?angle)\b(?!\s*(?:\(|of\b|between\b|turned\b|deflected\b))",
        (
            "an angle is between two directions, as in 'angle(velocity(P), W)'; how far P is "
            "turned is 'deflection(P)'"
        ),
    ),
    (
        _ASKED,
        rf"(?P<x>\b[vV]\s+(?:of|for)\s+{_BODY}\s+and\s+(?:(?:of|for)\s+)?(?P<b>{NAME}))",
        _either("velocity({body}), velocity({b})", "speed({body}), speed({b})"),
    ),
    (
        _ASKED,
        rf"(?P<x>\b(?:the\s+)?path\s+of\s+{_BODY})",
        _meant("velocity({body})"),
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
                rf"(?:both|each|all|the\s+two|the\s+spheres\b)(?:\s+(?:of\s+)?(?:the\s+)?(?:two\s+)?(?:them\b|{_BALL}\b(?!\s+{NAME}\b)))?)"
                rf"{_AFTER}?)"
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
        _ASKED,
        rf"(?P<x>\b[vV]\s*(?:_|\(\s*|(?:of|for)\s+)?{_BODY}\s*\)?)",
        _either("velocity({body})", "speed({body})"),
    ),
    (
        _ASKED,
        rf"(?P<x>\b[uU]\s*(?:_|\(\s*|of\s+)?{_BODY}\s*\)?)",
        _either("velocity({body}, 0)", "speed({body}, 0)"),
    ),
    (_ASKED, rf"(?P<x>\bm(?:_|\s*\(\s*|\s+of\s+){_BODY}\s*\)?)", _meant("mass({body})")),
    (
        _ASKED,
        (
            r"(?P<x>\b(?:the\s+)?(?:final\s+)?(?P<q>speed|velocity|direction|deflection)\b"
            rf"(?!\s*\(|\s*[A-Z]|\s+of\b){_AFTER}?)"
        ),
        Cure("did you mean {each}?", "{q}({sphere})"),
    ),
    (
        _ASKED,
        rf"(?P<x>\b[vV]{_AFTER})",
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
        _meant("given angle(velocity({body}), {w}) = {a}"),
    ),
    (
        "sphere",
        r"\bat\s+rest\s+(?P<x>(?:immediately\s+|just\s+)?after(?:wards)?\b.*?)\s*$",
        "what a sphere does after an event is a fact below that, such as 'given A at rest'",
    ),
    (
        f"other event {_ASKED}",
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
        _ASKED,
        r"(?P<x>\b(?:the\s+)?time\s+(?:between|until|till|to|from|taken|of)\b.*?)\s*$",
        ("the time of event 1 is 'time(1)', and that between events 1 and 2 'time(2) - time(1)'"),
    ),
    (
        _ASKED,
        r"(?P<x>\b(?:the\s+)?(?:point|place)\s+(?:of|where)\b.*?)\s*$",
        (
            "the place of a sphere at event 1 is 'position(P, 1)', and how far it has come "
            "'distance(position(P, 0), position(P, 1))'"
        ),
    ),
    # what is asked, in words
    (
        "find",
        (
            r"^\s*find\s+(?:.*,\s*)?(?P<x>(?P<q>[^\s,][^,]*?)\s+as\s+an?\s+(?P<share>percentage|percent|fraction|proportion)"
            r"\s+of\s+(?:the\s+|its\s+)?(?P<w>(?:(?:initial|original|total)\s+)*"
            rf"{_KINETIC}(?!\s*\()(?:\s+before\b.*)?|(?:initial|original)\s+value))"
        ),
        Cure("a share is a quotient, such as '{q}/energy(0)'", "{q}/energy(0){as_share}"),
    ),
    (
        "find",
        (
            r"^\s*find\s+(?:.*,\s*)?(?P<x>(?P<q>[^\s,][^,]*?)\s+as\s+an?\s+(?P<share>percentage|percent|fraction|proportion)"
            r"\s+of\s+(?:the\s+)?(?P<w>[^\s,][^,]*?))\s*$"
        ),
        Cure("a share is a quotient, such as '{q}/{w}'", "{q}/{w}{as_share}"),
    ),
    (
        "find",
        (
            rf"(?P<x>(?:the\s+|what\s+)?(?:percentages?|%)\s+(?:of\s+)?(?:the\s+)?(?:(?:initial|original|total)\s+)?"
            rf"(?:{_KINETIC}\s+{_LOST}|loss\s+(?:of|in)\s+(?:the\s+)?{_KINETIC})\s+by\s+{_BODY})"
        ),
        _meant("(energy({body}, before) - energy({body}))/energy({body}, before) as a percentage"),
    ),
    ("find", r"[A-Za-z)]\s*(?P<x>%)\s*(?:$|,)", _meant("as a percentage")),
    (
        "find",
        rf"(?P<x>(?:how\s+much\s+(?:of\s+the\s+)?|the\s+amount\s+of\s+)(?:\w+\s+)??{_KINETIC}\s+{_LOST})",
        _meant("energy_lost"),
    ),
    (
        "find",
        (
            rf"(?P<x>(?:the\s+|what\s+)?(?:percentages?|%)\s+(?:of\s+)?(?:the\s+)?(?:(?:initial|original|total)\s+)?"
            rf"(?:{_KINETIC}\s+{_LOST}|loss\s+(?:of|in)\s+(?:the\s+)?{_KINETIC}))"
        ),
        _meant("energy_lost/energy(0) as a percentage"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:what\s+|the\s+)?(?:fraction|proportion)\s+of\s+(?:the\s+)?(?:(?:initial|original|total)\s+)?"
            rf"{_KINETIC}\s+{_LOST})"
        ),
        _meant("energy_lost/energy(0)"),
    ),
    (
        "other given show",
        (
            r"(?P<x>(?P<n>\d[\d.]*\s*(?:%|per\s?cent))\s+of\s+(?:the\s+)?(?:(?:initial|original|total)\s+)*"
            rf"{_KINETIC}\s+is\s+lost)"
        ),
        _meant("energy_lost = {n} of energy(0)"),
    ),
    ("find", r"(?P<x>(?:the\s+)?total\s+momentum)\b", _meant("momentum")),
    (
        _ASKED,
        (
            rf"(?P<x>(?:the\s+)?angle\s+(?:through\s+which\s+|that\s+)?{_BODY}\s+is\s+"
            r"(?:deflected|turned)(?:\s+(?:through|by))?)"
        ),
        _meant("deflection({body})"),
    ),
    (
        _ASKED,
        rf"(?P<x>(?:the\s+)?(?:initial|original)\s+(?:total\s+)?{_KINETIC})(?!\s*(?:of\b|\())",
        _meant("energy(0)"),
    ),
    (_ASKED, r"(?P<x>\|(?P<v>[^|]+)\|)", _meant("abs({v})")),
    (
        _ASKED,
        rf"(?P<x>(?:the\s+)?(?:magnitude|modulus|size)\s+of\s+(?:the\s+)?velocity\s+of\s+{_BODY})",
        _meant("speed({body})"),
    ),
    (
        _ASKED,
        (
            r"(?P<x>(?:the\s+)?(?:magnitude|modulus|size)\s+of\s+(?:the\s+)?"
            r"(?P<v>\w+\([^()]*\)))"
        ),
        _meant("abs({v})"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:the\s+)?velocity\s*(?:of\s+|\(\s*){_BODY}\s*\)?\s+relative\s+to\s+"
            rf"(?P<b>{NAME}))"
        ),
        _meant("velocity({body}) - velocity({b})"),
    ),
    (_ASKED, r"(?P<x>\b(?:the\s+)?components\s+of)\b", _CUT),
    (
        "find",
        r"(?P<x>(?:the\s+)?ratio\s+(?:of\s+)?(?:the\s+)?(?P<a>[^,:]+?)\s*(?::|\bto\b)\s*(?:the\s+)?(?P<b>[^,:]+))$",
        _meant("({a})/({b})"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:the\s+)?{_KINETIC}\s+of\s+{_BODY}\s+(?:immediately\s+|just\s+)?before\b"
            r"(?:\s+(?:the|its|this|impact|collision|it\w*))*)"
        ),
        _meant("energy({body}, before)"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:the\s+)?(?P<q>speed|velocity|direction|energy|momentum)\s+of\s+{_BODY}\s+"
            r"(?:immediately\s+|just\s+)?before\b(?:\s+(?:the|its|this|impact|collision|it\w*))*)"
        ),
        _meant("{q}({body}, before)"),
    ),
    (
        "find",
        (
            rf"(?P<x>(?:(?:final|new|the)\s+)*(?P<q>speed|direction|deflection|energy|momentum|mass)s?"
            rf"\s+(?:of\s+)?{_BODY}\s*(?:\band\b|&)\s*(?:of\s+)?(?P<b>{NAME}))(?!\s*\()"
        ),
        _meant("{q}({body}), {q}({b})"),
    ),
    (
        "find",
        (
            rf"(?P<x>(?:(?:final|new|the)\s+)*velocit(?:y|ies)\s+(?:of\s+)?{_BODY}\s*(?:\band\b|&)\s*(?:of\s+)?"
            rf"(?P<b>{NAME}))(?!\s*\()"
        ),
        _meant("velocity({body}), velocity({b})"),
    ),
    *(
        (
            _ASKED,
            (
                rf"(?P<x>(?:the\s+)?{size}impulse\s+(?:(?:received|experienced)\s+by|(?:acting|exerted)\s+on"
                rf"|given\s+to|imparted\s+to|(?:of|exerted\s+by|from)\s+(?:the\s+\w+|{NAME})\s+on)"
                rf"\s+{_BODY}(?:\s+by\s+(?:the\s+)?\w+)?)"
            ),
            _meant(text),
        )
        for size, text in (
            (r"(?:magnitude|size)\s+of\s+(?:the\s+)?", "abs(impulse({body}))"),
            ("", "impulse({body})"),
        )
    ),
    (
        _ASKED,
        rf"(?P<x>(?:the\s+)?change\s+(?:in|of)\s+(?:the\s+)?momentum\s+(?:of|for)\s+{_BODY})",
        _meant("impulse({body})"),
    ),
    (
        _ASKED,
        (
            r"(?P<x>(?:the\s+)?(?:acute\s+)?angle\s+(?:that\s+|which\s+)?(?:the\s+(?:path|direction\s+of\s+motion"
            rf"|velocity)\s+of\s+)?{_BODY}\s+makes\s+with\s+(?P<b>[^,=]+?)){_AFTER}?\s*(?:$|,|=)"
        ),
        _meant("angle(velocity({body}), {b})"),
    ),
    (
        "given show",
        (
            r"(?P<x>(?:the\s+)?(?:direction(?:\s+of\s+motion)?|path|velocity)\s+of\s+"
            rf"{_BODY}\s+is\s+(?:turned|deflected|changed)\s+(?:through|by))\b"
        ),
        _meant("deflection({body}) ="),
    ),
    *(
        (
            "given show",
            (
                rf"(?P<x>(?:(?:the\s+)?(?:direction(?:\s+of\s+motion)?|path|velocity)\s+of\s+)?{_BODY}"
                rf"\s+(?:is|moves|is\s+moving)\s+(?:off\s+)?(?:{words})\s+to\s+its\s+"
                r"(?:original|initial|previous|first)\s+(?:direction(?:\s+of\s+motion)?|velocity|path))"
            ),
            _meant(f"velocity({{body}}) {relation} velocity({{body}}, 0)"),
        )
        for words, relation in (
            (r"at\s+right\s+angles|perpendicular", "perpendicular to"),
            ("parallel", "parallel to"),
            ("opposite", "opposite to"),
        )
    ),
    (
        "given show other",
        (
            rf"(?P<x>{_BODY}\s+loses\s+(?P<n>\d[\d.]*\s*(?:%|per\s?cent))\s+of\s+its\s+"
            rf"(?:(?:initial|original)\s+)?{_KINETIC})"
        ),
        _meant("energy({body}, before) - energy({body}) = {n} of energy({body}, before)"),
    ),
    *(
        (
            "given show other",
            (
                rf"(?P<x>{_BODY}\s+loses\s+{words}\s+(?:of\s+)?its\s+"
                rf"(?:(?:initial|original)\s+)?{_KINETIC})"
            ),
            _meant(
                f"energy({{body}}, before) - energy({{body}}) = {lost} energy({{body}}, before)"
            ),
        )
        for words, lost in (
            (r"(?P<n>\d+\s*/\s*\d+)", "{n}"),
            (r"(?:one\s+|a\s+)?half", "1/2"),
            (r"(?:one\s+|a\s+)third", "1/3"),
            (r"(?:one\s+|a\s+)quarter", "1/4"),
            (r"two[\s-]thirds", "2/3"),
            (r"three[\s-]quarters", "3/4"),
        )
    ),
    *(
        (
            "given show other",
            (
                rf"(?P<x>{_BODY}\s+loses\s+{words}\s+(?:of\s+)?its\s+(?:(?:initial|original)\s+)?"
                r"speed)"
            ),
            _meant(f"speed({{body}}) = {left} speed({{body}}, before)"),
        )
        for words, left in (
            (r"(?:one\s+|a\s+)?half", "1/2"),
            (r"(?:one\s+|a\s+)third", "2/3"),
            (r"(?:one\s+|a\s+)quarter", "3/4"),
            (r"two[\s-]thirds", "1/3"),
            (r"three[\s-]quarters", "1/4"),
        )
    ),
    (
        "find other",
        rf"(?P<x>velocity\s*\(\s*{_BODY}\s*\)\s+perpendicular\s+to\s+(?:the\s+)?(?P<w>{NAME}))\s*(?:,|$)",
        _meant("across(velocity({body}), {w})"),
    ),
    (
        "find other",
        rf"(?P<x>velocity\s*\(\s*{_BODY}\s*\)\s+parallel\s+to\s+(?:the\s+)?(?P<w>{NAME}))\s*(?:,|$)",
        _meant("along(velocity({body}), {w})"),
    ),
    (
        "find other",
        rf"(?P<x>change\s+(?:in|of)\s+(?:the\s+)?velocity\s+of\s+{_BODY})",
        _meant("velocity({body}) - velocity({body}, before)"),
    ),
    *(
        (
            "given show other",
            (
                rf"(?P<x>{words}\s+(?:of\s+)?(?:the\s+)?(?:(?:initial|original|total)\s+)*{_KINETIC}\s+"
                r"is\s+lost)"
            ),
            _meant(f"energy_lost = {share} energy(0)"),
        )
        for words, share in (
            (r"(?:one\s+|a\s+)?half", "1/2"),
            (r"(?:one\s+|a\s+)third", "1/3"),
            (r"(?:one\s+|a\s+)quarter", "1/4"),
            (r"two[\s-]thirds", "2/3"),
            (r"three[\s-]quarters", "3/4"),
        )
    ),
    *(
        ("given show", rf"(?P<x>\bis\s+(?:{words}))\s+(?!that\b|of\b)", _meant(f"= {factor}"))
        for words, factor in (
            ("twice|double|two\\s+times", "2"),
            ("three\\s+times", "3"),
            ("half", "1/2"),
        )
    ),
    (
        "given show",
        (
            rf"(?P<x>(?:the\s+)?speeds\s+of\s+{_BODY}\s+and\s+(?P<b>{NAME})\s+are\s+(?:equal|the\s+same)"
            rf"|(?P<c>{NAME})\s+and\s+(?P<d>{NAME})\s+have\s+(?:equal\s+speeds?|the\s+same\s+speed))"
        ),
        _meant("speed({body}{c}) = speed({b}{d})"),
    ),
    *(
        (
            "given show",
            (
                rf"(?P<x>(?P<a>{NAME})\s+and\s+(?P<b>{NAME})\s+(?:then\s+|now\s+)?(?:are\s+moving|move|travel)"
                rf"\s+(?:off\s+)?(?:{words}))"
            ),
            _meant(f"velocity({{a}}) {relation} velocity({{b}})"),
        )
        for words, relation in (
            (r"in\s+opposite\s+directions", "opposite to"),
            (r"in\s+the\s+same\s+direction", "in the direction of"),
            (
                r"at\s+right\s+angles(?:\s+to\s+each\s+other)?|in\s+perpendicular\s+directions",
                "perpendicular to",
            ),
            (r"in\s+parallel\s+directions", "parallel to"),
        )
    ),
    (
        "given show",
        rf"(?P<x>(?P<a>{NAME})\s+(?:is\s+moving|moves|is)\s+faster\s+than\s+(?P<b>{NAME}))",
        _meant("speed({a}) > speed({b})"),
    ),
    (
        "given show",
        rf"(?P<x>(?:the\s+)?speed\s+of\s+{_BODY}\s+is\s+halved)\b",
        _meant("speed({body}) = 1/2 speed({body}, before)"),
    ),
    ("find", rf"(?P<x>(?:the\s+)?{_RESTITUTION})", _meant("e")),
    (
        "given show",
        rf"(?P<x>(?:the\s+)?{_RESTITUTION}\s*(?:\be\b)?\s*(?:=|is\b))",
        _meant("e ="),
    ),
    ("find", r"(?P<x>\bpercentages?(?:\s+of)?)\s", "'as a percentage' stands after an item"),
    (
        "find",
        r"(?P<x>(?:what\s+)?fraction\s+of)\b",
        "write a quotient, such as energy_lost/energy(0)",
    ),
    ("find", r"(?P<x>&)", _meant(",")),
    ("find", r",\s*(?P<x>,)", _CUT),
    ("find", r",\s*(?P<x>find)\b", _CUT),
    ("find", r"(?P<x>\bonly)\b", _CUT),
    (
        "find",
        r"(?P<x>\bin)\s+(?P<v>[a-zα-ω](?:_?\w)?(?:\s*(?:,|and)\s*[a-zα-ω](?:_?\w)?)*)\s*$",
        _meant("in terms of"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:total\s+)?(?:{_KINETIC}\s+(?:lost|loss)|loss\s+(?:of|in)\s+(?:the\s+)?"
            rf"(?:total\s+)?{_KINETIC})\s+(?:by|of)\s+{_BODY})"
        ),
        _meant("energy({body}, before) - energy({body})"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:total\s+(?!energy))?{_KINETIC}\s+(?:lost|loss)\b"
            rf"|loss\s+(?:of|in)\s+(?:the\s+)?(?:total\s+)?{_KINETIC})"
        ),
        _meant("energy_lost"),
    ),
    (
        _ASKED,
        rf"(?P<x>(?:kinetic\s+energy|K\.?E\.?)\s*(?:of\s+|\(\s*|_)?{_BODY}\)?)",
        _meant("energy({body})"),
    ),
    (_ASKED, r"(?P<x>\b(?:total\s+)?(?:kinetic\s+energy|K\.?E)\b\.?)", _meant("energy")),
    (
        _ASKED,
        (
            rf"(?P<x>angle\s+(?:of\s+deflection|through\s+which)(?:\s+(?:of|for))?\s+{_BODY}"
            r"(?:\s+is\s+deflected)?)"
        ),
        _meant("deflection({body})"),
    ),
    (
        _ASKED,
        r"(?P<x>angle\s+of\s+deflection|angle\s+(?:turned|deflected)|deflection)(?!\s*\(?\s*[A-Z])",
        Cure("did you mean {each}?", "deflection({sphere})"),
    ),
    (
        _ASKED,
        r"(?P<x>angle\s+between\s+(?:the\s+)?(?P<a>[^,=<>]+?)\s+and\s+(?:the\s+)?(?P<b>[^,=<>]+))",
        _meant("angle({a}, {b})"),
    ),
    (
        _ASKED,
        rf"(?P<x>distance\s+between\s+{_BODY}\s+and\s+(?:the\s+)?(?P<b>{NAME}))",
        _meant("distance({body}, {b})"),
    ),
    (
        _ASKED,
        (
            r"(?P<x>component\s+of\s+(?:the\s+)?(?P<a>[^,=<>]+?)\s+(?:along|parallel\s+to|in\s+the"
            r"\s+direction\s+of)\s+(?:the\s+)?(?P<b>[^,=<>]+))"
        ),
        _meant("along({a}, {b})"),
    ),
    (
        _ASKED,
        r"(?P<x>(?:magnitude|modulus|size)\s+of\s+(?:the\s+)?impulse)\b",
        _meant("impulse"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>initial\s+(?P<q>speed|velocity|direction|energy|momentum)\s*(?:of\s+|\(\s*)?"
            rf"{_BODY}\)?)"
        ),
        _meant("{q}({body}, 0)"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:(?:final|new|the)\s+)*(?P<q>speed|velocity|direction|deflection|energy|impulse"
            rf"|momentum|position|mass)\s*(?:of\s+(?:motion\s+of\s+)?|on\s+|for\s+)?{_BODY}(?!\s*\())"
        ),
        _meant("{q}({body})"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>\b(?P<body>{NAME})['’]s\s+(?:final\s+)?(?P<q>speed|velocity|direction|deflection"
            r"|energy|momentum|position|mass)\b)"
        ),
        _meant("{q}({body})"),
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:immediately\s+|just\s+|straight\s+)?(?:after(?:wards)?|following)\b"
            rf"(?:\s+(?!(?:is|equals?|in|as|and)\b)(?:[a-z]\w*|{NAME}(?=\s*(?:$|[,.])))){{0,3}})"
        ),
        Cure(
            "leave out '{x}': a quantity is the one after the events told so far, "
            "and speed(A, 1) the one after event 1",
            "",
        ),
    ),
    (
        _ASKED,
        r"(?P<x>(?:immediately\s+|just\s+)?before\b(?:\s+\w+){0,3})",
        "before its latest event the speed of A is speed(A, before)",
    ),
    (
        "find",
        (
            r"(?P<x>(?:the\s+)?(?:set|range)\s+of\s+(?:the\s+)?(?:possible\s+)?values\s+(?:of|for)"
            r"|(?:possible\s+)?values\s+(?:of|for)|range\s+for|range\s+of\s+the)"
        ),
        _meant("range of"),
    ),
    (
        "find show",
        (
            r"(?P<x>\b(?:maximum(?!\s+of\b)|max\b\.?(?:imal\b)?|greatest|largest|biggest|highest)"
            r"(?:\s+possible)?(?:\s+value)?(?:\s+of)?)"
        ),
        _meant("maximum of", " It is written 'maximum of Q over X'"),
    ),
    (
        "find show",
        (
            r"(?P<x>\b(?:minimum(?!\s+of\b)|min\b\.?(?:imal\b)?|least|smallest|lowest)"
            r"(?:\s+possible)?(?:\s+value)?(?:\s+of)?)"
        ),
        _meant("minimum of", " It is written 'minimum of Q over X'"),
    ),
    (
        "find show",
        r"(?P<x>\bin\s+(?:the\s+)?(?:terms?\b(?!\s+of\b)|term\s+of)|\binterms\s+of)",
        _meant("in terms of"),
    ),
    (
        "find",
        (
            r"(?P<x>\b(?:as|in)\s+(?:an?\s+)?(?:percentages?|percent|per\s+cent|%)"
            r"(?:\s+(?:form|of\b.*))?)"
        ),
        _meant("as a percentage"),
    ),
    (
        "find",
        (
            r"(?P<x>(?:,\s*)?\b(?:correct\s+)?(?:in|to)\s+(?:degrees|radians|°|m\s*/\s*s|exact\s+form"
            r"|(?:\d|one|two|three)\s*(?:s\.?f\.?|d\.?p\.?|decimal\s+places?|significant\s+figures?"
            r"|sig\.?\s*figs?))(?!\w)[^,]*)"
        ),
        Cure("leave out '{x}': answers come exact and to 3 significant figures", ""),
    ),
    (
        "find",
        (
            r"^(?P<all>\s*(?P<asked>find\b.*?)\s*,?\s*"
            r"\b(?P<x>when|if|where|given(?:\s+that)?|assuming|for\s+which"
            r"|(?:at|for|with)(?=[^(),]*[<>=≤≥][^()]*$))\s+(?P<fact>\S.*?)"
            r"(?P<terms>(?:\s+in\s+terms\s+of\s.*)?))\s*$"
        ),
        Cure(
            "a fact stands on a line of its own before this: 'given {fact}'",
            "given {fact}\n{asked}{terms}",
            of="all",
        ),
    ),
    (
        "find",
        (
            r"^(?P<all>\s*(?P<asked>find\s+range\b.*?)\s+(?P<x>over|as)\s+(?P<letter>\w+)"
            r"(?:\s+var(?:ies|y))?)\s*$"
        ),
        Cure(
            "what varies stands on a line of its own before this: 'unknown {letter}'",
            "unknown {letter}\n{asked}",
            of="all",
        ),
    ),
    # relations
    (
        "",
        (
            rf"\b(?:to|from|of|hits|with|along|receives|reaches|,|\()\s*"
            rf"(?P<x>(?:the\s+)?(?:wall|sphere|ball|particle|point))\s+(?=\(|{NAME}\b)"
        ),
        _CUT,
    ),
    ("", r"(?P<x>(?P<o>[<>])\s+=)", _meant("{o}=")),
    (
        "given show",
        r"(?P<x>(?P<q>[^\s,]+)\s+(?:is\s+|lies\s+)?between\s+(?P<a>[^\s,]+)\s+and\s+(?P<b>[^\s,]+))",
        _meant("{a} < {q} < {b}"),
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<body>{NAME})\s+(?:now\s+)?(?:is\s+)?(?:moves|moving|travels|travelling)\b)",
        _meant("velocity({body})"),
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<body>{NAME})\s+(?:rests|stops|comes\s+to\s+rest|is\s+brought\s+to\s+rest))\b",
        _meant("{body} at rest"),
    ),
    (
        "given show",
        r"(?P<x>\bdon['’]t\s+collide(?:\s+again)?)",
        _meant("do not collide again"),
    ),
    ("given show", r"(?P<x>\bdoesn['’]t\s+hit)\b", _meant("does not hit")),
    ("given show", r"(?P<x>\bwon['’]t\s+hit)\b", _meant("will not hit")),
    ("", r"(?P<x>={2,3})", _meant("=")),
    ("", r"(?P<x>=\s*<)", _meant("<=")),
    ("", r"(?P<x>=\s*>)", _meant(">=")),
    (
        "",
        (
            r"(?P<x>\b(?:is|are)(?:\s+equal)?)\s+(?=(?:not\s+)?(?:perpendicular|parallel|opposite"
            r"|at\s+rest|in\s+the\s+direction))"
        ),
        _CUT,
    ),
    ("given show", r"(?P<x>\bis\s+(?:less|smaller)\s+than)\b", _meant("<")),
    ("given show", r"(?P<x>\bis\s+(?:greater|more|larger|bigger)\s+than)\b", _meant(">")),
    ("given show", r"(?P<x>\b(?:is\s+)?at\s+least)\b", _meant(">=")),
    ("given show", r"(?P<x>\b(?:is\s+)?at\s+most)\b", _meant("<=")),
    (
        "given show",
        r"(?P<x>\b(?:is|are)\s+(?:perp\w*|at\s+right\s+angles)(?:\s+(?:to|with))?)",
        _meant("perpendicular to"),
    ),
    ("given show let", r"(?P<x>\b(?:is\s+equal\s+to|equals?(?:\s+to)?|is))\b", _meant("=")),
    (
        "given show",
        (
            r"(?P<x>\bperp\b\.?(?:\s+(?:to|with)\b)?|\bperpendicular\b(?!\s+to\b)(?:\s+with\b)?|[⊥⟂]"
            r"|\bnormal\s+to\b|\bat\s+right\s+angles\s+(?:to|with)\b)"
        ),
        _meant("perpendicular to"),
    ),
    (
        "given show",
        r"(?P<x>\bparallel\b(?!\s+to\b)(?:\s+with\b)?|[∥‖]|\|\|)",
        _meant("parallel to"),
    ),
    (
        "given show",
        r"(?P<x>\bin\s+(?:the\s+)?(?:same\s+)?direction(?:\s+(?:of|as))?\b)",
        _meant("in the direction of"),
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
    ("", r"(?P<x>[.;?!])\s*$", _CUT),
    ("", r"(?P<x>;)", Cure("did you mean ','?", ",", tight=True)),
    (
        _ASKED,
        r"(?P<x>\b(?:the\s+)?(?:(?:exact|possible)\s+)?value\s+of)\b",
        _CUT,
    ),
    ("", r"(?P<x>\b(?:the|smooth))\b\s*", _CUT),
    (
        "find given unknown show sphere wall event",
        r"(?P<x>\band\b)",
        Cure("did you mean ','?", ",", tight=True),
    ),
)
