"""Properties of bodies and impacts, in words."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.language.slip_tables.patterns import (
    ALONG,
    BODY_LINES,
    CUT,
    NAME,
    OF_MOTION,
    SIZE,
    VALUE,
    Cure,
    Slip,
    either,
    meant,
)


def _facts_at_events() -> Iterator[Slip]:
    """What is given of the motion on the line of an impact: a line of its own below that."""
    quantities = (
        (rf"(?P<q>{OF_MOTION})\s*=", "{q}"),
        (r"(?:impulse(?:\s+(?:is|of))?|J\s*=)", "impulse"),
    )
    for quantity, name in quantities:
        fact = f"given {name} = {{v}}"
        message = f"what is given of the motion stands on a line of its own: '{fact}'"
        for sign in (":", ","):
            start = rf"(?P<x>\s*{sign}\s*{quantity}\s*(?P<v>{VALUE}?)\s*"
            yield "event", rf"{start})$", Cure(message, f"\n{fact}", tight=True)
            rest = Cure(message, f"{sign} {{r}}\n{fact}", tight=True)
            yield "event", rf"{start},\s*(?P<r>.+))$", rest


_AMOUNT = r"(?:\b(?:mass|radius|velocity|speed|receives|impulse)\b|[=+−-])\s*"
_LETTER_E = r"(?:coefficient(?:\s+of\s+restitution)?\s*(?:is|=)?\s*)?e\b"
_TO_999 = r"[1-9]\d{0,2}"

PROPERTIES: tuple[Slip, ...] = (
    (
        "event",
        rf"^\s*(?P<a>{NAME})\s+hits\s+{NAME}(?P<x>\s*,?\s*(?:and\s+)?then\s+(?:hits\s+)?(?P<b>{NAME}))\s*$",
        Cure("every impact has a line of its own", "\n{a} hits {b}", tight=True),
    ),
    *_facts_at_events(),
    ("let", r"(?P<x>,)\s*\w+\s*=", "a line 'let' names one quantity"),
    # Before three figures a comma may part thousands, or be a decimal point; nobody knows which.
    (
        "",
        rf"{_AMOUNT}(?P<x>(?P<a>{_TO_999}),(?P<b>\d{{3}}))(?!,?\d|\.\d)",
        either("{a}{b}", "{a}.{b}"),
    ),
    (
        "",
        rf"{_AMOUNT}(?P<x>(?P<a>{_TO_999}),(?P<b>\d{{3}})(?:,(?P<c>\d{{3}}))?)(?!,?\d)",
        meant("{a}{b}{c}"),
    ),
    ("", rf"{_AMOUNT}\d+(?P<x>,)\d", Cure("a decimal point is '.'", ".")),
    ("point", r":\s*(?P<x>[^()\s,]+\s*,\s*[^()\s,]+)\s*$", meant("({x})")),
    (
        "given let show",
        r"=.*\s(?P<x>find|show|given|let|unknown)\b",
        Cure("'{x}' begins a line of its own", "\n{x}", tight=True),
    ),
    ("given let show", r"(?:\d|%)\s+(?P<x>of)\b", CUT),
    (
        "given show",
        rf"(?P<x>\b(?P<a>{NAME})\s+will\s+(?:hit|strike|collide\s+with)\s+(?P<b>{NAME})\s+again)",
        meant("{a} hits {b} again"),
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<a>{NAME})\s+hits\s+(?P<b>{NAME}))\s*(?:,|$)",
        either("{a} will hit {b}", "{a} hits {b} again"),
    ),
    (
        "find",
        r"(?P<x>\b(?:the\s+)?(?P<q>[a-zα-ω](?:_?\w)?)\s+range)\s*(?:,|$)",
        meant("range of {q}"),
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<body>{NAME})\s+is\s+(?:deflected|turned)\s+(?:through|by)\b)",
        meant("deflection({body}) ="),
    ),
    ("event", r"(?P<x>\b(?:perfectly\s+)?elastic)\b", meant("e = 1")),
    ("event", r"(?P<x>\bperfectly\s+inelastic)\b", meant("e = 0")),
    (
        "event",
        r"\breceives\s.*\s(?P<x>along|in\s+the\s+direction\s+of)\b",
        meant("at 0° from"),
    ),
    (
        "find show",
        r"imum\s+of\b.*?\s(?P<x>wrt|with\s+respect\s+to|for|as)\b.*$",
        meant("over"),
    ),
    (
        "sphere wall event",
        r":.*\s(?P<x>find|show|given|let|unknown)\b",
        Cure("'{x}' begins a line of its own", "\n{x}", tight=True),
    ),
    ("sphere wall event", r"(?P<x><(?P<v>[^<>]*,[^<>]*)>)", meant("({v})")),
    ("sphere event", r"[ij]\s*(?P<x>,)\s*[-+−]?\s*[\d.]*\s*[a-z]?\s*[ij]\b", meant("+")),
    (
        "sphere",
        (
            r"\bvelocity\s+(?P<x>(?P<a>[\d.\w]+(?:\s*m)?(?:\s*/\s*s)?)\s*,?\s*"
            r"(?:in\s+)?(?:the\s+)?(?:direction\s+)?(?P<b>\d[\d.]*\s*(?:°|deg(?:rees?)?)))"
        ),
        meant("{a} at {b}"),
    ),
    (
        "sphere",
        r"[:,]\s*(?P<x>(?:velocity|speed)\s+(?:is\s+|=\s*)?(?:at\s+rest|zero|nil|none))\b",
        meant("at rest"),
    ),
    ("sphere", r"\bat\s+rest\s+(?P<x>initially|at\s+first|at\s+the\s+start)\b", CUT),
    (
        "sphere event",
        rf"\b(?:velocity|speed|receives)\s+(?P<x>{SIZE}\s+{ALONG}\s*(?P<d>[ij]))\s*(?:,|$)",
        Cure("did you mean {each}?", "{v}{gap}{d} {unit}"),
    ),
    (
        "sphere event",
        rf"\b(?:velocity|speed|receives)\s+(?P<x>{SIZE}\s+parallel\s+to\s+(?P<d>[ij]))\s*(?:,|$)",
        Cure("did you mean {each}?", "{v}{gap}{d} {unit}", more=("-{v}{gap}{d} {unit}",)),
    ),
    (
        "sphere event",
        (
            rf"\b(?:velocity|speed|receives)\s+{SIZE}\s+(?P<x>{ALONG})"
            r"\s*(?=[-\d(]*\s*[\w]*\s*[ij,])"
        ),
        meant("at 0° from"),
    ),
    *(
        (
            "sphere event",
            (
                rf"\b(?:velocity|speed|receives)\s+(?P<x>{SIZE}\s+(?:(?:to|towards)\s+the\s+|due\s+|in\s+the\s+)?"
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
        (
            r"\bvelocity\s[^,]*?(?P<x>\b(?:to)?wards?\b[^,]*|\baway\s+from\b[^,]*"
            r"|\b(?:(?:in\s+)?the\s+)?opposite\b[^,]*)"
        ),
        "a direction is told by an angle or a vector: 'velocity 3 at 30°', 'velocity -3i'",
    ),
    (
        "sphere event",
        r"(?P<x>\bin\s+(?:the\s+|an?\s+)?(?:(?:same|opposite)\s+)?direction(?:\s+(?:of|to)\b[^,]*)?)",
        "a direction is told by an angle: 'u at 30°', or 'u at 0° from 3i + 4j'",
    ),
    ("", r"(?P<x>\b(?:anticlockwise|counterclockwise|counter-clockwise))\b", CUT),
    (
        "",
        r"\bat\s+(?:an\s+angle\s+(?:of\s+)?)?(?P<x>(?P<a>\d[\d.]*\s?°|[a-z]+)\s+clockwise)\b",
        meant("-{a}"),
    ),
    ("", r"(?P<x>\bclockwise)\b", "angles are anticlockwise: write a negative one"),
    ("", r"\bat\s[^,]*(?P<x>\babove)\b", meant("from")),
    (
        "sphere",
        r"\bat\s+(?P<x>(?P<v>-?[\w.]{1,4}\s*,\s*-?[\w.]{1,4}))\s*(?:,|$)",
        meant("({v})"),
    ),
    ("event", r"(?P<x>\bat\s+(?:time\s+)?t\s*=)", "a time is a fact: 'given time(1) = …'"),
    ("", r"(?P<x>(?P<a>\w)_\{(?P<b>\d+|\w)\})", meant("{a}_{b}")),
    (
        "",
        r"(?P<x>\b(?P<q>sin|cos|tan)\s*[-−–]\s?1\b|\binverse\s+(?P<p>sin|cos|tan)\b)",
        meant("arc{q}{p}"),
    ),
    (
        BODY_LINES,
        rf"^\s*\w+\s+{NAME}(?:\s*,\s*{NAME})*\s+(?P<x>and)\s+{NAME}",
        Cure("did you mean ','?", ",", tight=True),
    ),
    (
        BODY_LINES,
        (
            rf"^\s*\w+\s+{NAME}(?:\s*,\s*{NAME})*\s*(?P<x>,?\s*(?:has|have|of|with|is|lies|moves)\b"
            r"|[,;=–-])\s*(?=[a-z])"
        ),
        Cure("expected ':' here", ":", tight=True),
    ),
    (
        BODY_LINES,
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
        CUT,
    ),
    (
        "event",
        rf"^\s*{NAME}\s+hits\s+{NAME}\s*:?\s*(?P<x>along\s+(?:the\s+|their\s+)?lines?\s+of\s+cent(?:re|er)s?)(?=\s+\w|\s*[,:])",
        CUT,
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
    ("event", r"[:,]\s*(?P<x>e)\s+(?=[\d½¼¾⅓⅔])", meant("e =")),
    (
        "event",
        r"\balong\b[^,:=]*?(?P<x>\s+(?:e\s*)?(?P<v>\d[\d./]*%?))\s*(?:,|$)",
        Cure("did you mean ', e = {v}'?", ", e = {v}", tight=True),
    ),
    (
        "",
        r"(?<![a-z])(?:[a-z]\s*)?i\s+(?P<x>\d[\d./]*\s*(?:[a-z]\s*)?j)(?!\w)",
        meant("+ {x}"),
    ),
    ("event", r"[:,]\s*(?P<x>restitution\s*(?:=|is|of)?)\s*(?=[\d½¼¾⅓⅔])", meant("e =")),
    (
        "event",
        (
            r"[:,]\s*(?P<x>(?:(?:perpendicular\s+)?distance|impact\s+parameter)(?:\s+(?:of|is)|\s*=)?)"
            r"\s*(?=[-+\d(√.a-z])"
        ),
        meant("offset"),
    ),
    (
        "other",
        (
            rf"^\s*(?P<x>(?:[Cc]ollision|[Ii]mpact)\s+(?:between|of)\s+(?P<a>{NAME})\s+"
            rf"(?:and|with)\s+(?P<b>{NAME}))"
        ),
        meant("{a} hits {b}"),
    ),
    (
        "other",
        (
            r"^\s*(?P<x>(?:[Aa]n\s+)?[Ii]mpulse\s+(?:of\s+)?(?P<v>[^,]+?)\s+(?:is\s+(?:given|applied)\s+to"
            rf"|acts\s+on|on|to)\s+(?P<n>{NAME}))\s*$"
        ),
        meant("{n} receives {v}"),
    ),
    *(
        (
            "event",
            pattern.format(_LETTER_E),
            Cure("leave out 'e': without a value it is a letter", ""),
        )
        for pattern in (r":\s*(?P<x>{}\s*,)", r"(?P<x>\s*[:,]\s*{})\s*(?:,|$)")
    ),
    ("event", r"[:,]\s*(?P<x>(?P<e>\d[\d./]*|[½¼¾⅓⅔]))\s*(?:,|$)", meant("e = {e}")),
    (
        "event",
        r"(?P<x>coefficient(?:\s+of\s+restitution)?\s+(?:is\s+)?(?P<e>[a-z]))\s*(?:,|$)",
        meant("e = {e}"),
    ),
    (
        "event",
        r"(?P<x>coefficient(?:\s+of\s+restitution)?\s*(?:\be\b)?\s*(?:=|:|is\b|of\b)?)",
        meant("e ="),
    ),
    ("event", r"\be\s*(?P<x>:|is\b|of\b)", meant("=")),
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
        meant("along"),
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
        CUT,
    ),
    ("sphere", r"[:,]\s*(?P<x>[mM]\s*=)", meant("mass")),
    (
        "sphere",
        (
            r"[:,]\s*(?P<x>(?!velocity\s*[^=\s])(?:[uvUV]\w*|speed|initial\s+(?:velocity|speed)|moving|moves"
            r"|travelling|moving\s+with\s+(?:velocity|speed))(?:\s*=|\b)(?:\s*(?:of|is|with\s+\w+|at(?!\s+rest))\b)?)"
        ),
        meant("velocity"),
    ),
    ("sphere", r"[:,]\s*(?P<x>[rR]\s*=)", meant("radius")),
    (
        "sphere",
        r"[:,]\s*(?P<x>(?:(?:is|initially)\s+)+at\s+rest|(?:initially\s+)?(?:rest|stationary|still)\b)",
        meant("at rest"),
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
    ("sphere", r"[:,]\s*(?P<x>weight)\b", meant("mass")),
    ("sphere", r"[:,]\s*(?P<x>position|centre|initially\s+at|starts\s+at)\b", meant("at")),
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
        meant("along"),
    ),
    ("wall", r"\balong\s[^,]*?(?P<x>\bto\s+(?:the\s+)?i)\s*(?:,|$)", CUT),
    # Turned by a right angle, a i + b j is -b i + a j.
    *(
        (
            "wall",
            (
                r"[:,]\s*(?P<x>perp\w*\s+to\s+(?:the\s+)?(?:vector\s+)?\(?\s*"
                rf"{one}(?P<a>[\d./]*)\s*i\s*{other}\s*(?P<b>[\d./]*)\s*j\b\s*\)?)"
            ),
            meant(text),
        )
        for one, other, text in (
            ("", r"\+", "along -{b}i + {a}j"),
            ("", "[-−]", "along {b}i + {a}j"),
            (r"[-−]\s*", r"\+", "along {b}i + {a}j"),
            (r"[-−]\s*", "[-−]", "along -{b}i + {a}j"),
        )
    ),
    ("wall", r"[:,]\s*(?P<x>perp\w*\s+to\s+(?:the\s+)?i)\b", meant("along j")),
    ("wall", r"[:,]\s*(?P<x>perp\w*\s+to\s+(?:the\s+)?j)\b", meant("along i")),
    (
        "wall",
        r"[:,]\s*(?P<x>perp\w*(?:\s+to)?)",
        "a wall is told by its own direction, such as 'along j'",
    ),
    ("wall", r"[:,]\s*(?P<x>horizontal)\b", meant("along i")),
    ("wall", r"[:,]\s*(?P<x>vertical)\b", meant("along j")),
    (
        "wall",
        r"[:,]\s*(?P<x>y\s*=\s*(?P<c>[^,=xy]+?))\s*(?:,|$)",
        meant("along i, through (0, {c})"),
    ),
    (
        "wall",
        r"[:,]\s*(?P<x>x\s*=\s*(?P<c>[^,=xy]+?))\s*(?:,|$)",
        meant("along j, through ({c}, 0)"),
    ),
    ("wall", r":\s*(?P<x>(?:-?\s*\d*\s*[ij]\b|\(|\d+\s*°)[^,]*)", meant("along {x}")),
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
        meant("at"),
    ),
    ("", r"\bat\s[^,]*?(?P<x>\b(?:to|with)\s+(?:the\s+)?horizontal)\b", meant("from i")),
    ("", r"\bat\s[^,]*?(?P<x>\b(?:to|with)\s+(?:the\s+)?vertical)\b", meant("from j")),
    (
        "sphere",
        r"(?P<x>\b(?:to|with|from)\s+(?:the\s+|their\s+)?lines?[\s_]of[\s_]cent(?:re|er)s?)\b",
        (
            "the line of centres stands on the line of the impact: with 'A hits B: along i', write "
            "'u at 30° from i'"
        ),
    ),
)
