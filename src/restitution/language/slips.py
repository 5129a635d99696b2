"""What people write in place of what the language says: consulted only where a line is no line.

Each slip is a pattern and what is probably meant. A pattern tells where the slip is found, its
group ``x`` (else all of it) what is wrong there.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

from restitution.errors import StatementError
from restitution.expression.lexer import Source
from restitution.expression.words import LINE_WORDS
from restitution.language.outside import outside

_NAME = r"[A-Z][A-Za-z0-9]*"
_BODY = rf"(?:the\s+)?(?:(?:sphere|ball|particle|wall)\s+)?(?P<body>{_NAME})\b"
_KINETIC = r"(?:kinetic\s+energy|KE|K\.E\.|energy)"
_CUT = "leave out '{x}'"

_BODIES = "sphere wall"
_ASKED = "find show given let"

# A wall or a ball is struck in many words.
_STRIKES = (
    r"(?:(?:then|now|next)\s+)?(?:(?:directly|obliquely|also)\s+)?"
    r"(?:collides?\s+(?:(?:directly|obliquely)\s+)?(?:with|into)|collides?|strikes?|struck|hit"
    r"|impacts?(?:\s+(?:on|with))?|bumps?\s+into|(?:bounces?|rebounds?)\s+(?:off|on|against|from)"
    r"|meets?|impinges?\s+on|hits\s+(?:into|against|with|on))"
)

# Lines by their first word (any, where there is none), pattern, and what to say.
_TABLE: tuple[tuple[str, str, str], ...] = (
    # how a line begins
    (
        "other",
        rf"^\s*(?P<x>(?P<b>{_NAME})\s+(?:is\s+)?(?:hit|struck)\s+by\s+(?P<a>{_NAME}))",
        "did you mean '{a} hits {b}'?",
    ),
    ("event", r"^[^:]*\s(?P<x>again)\s*:", _CUT),
    ("other", r"^\s*(?P<x>//|--|%|\*).*$", "a comment begins with '#'"),
    (
        "other",
        r"^\s*(?P<x>(?:if|where|with|when|assuming|since|because)\b(?:\s+that\b)?)",
        "did you mean 'given'?",
    ),
    (
        "other",
        rf"^\s*{_NAME}\s+(?P<x>(?:arrives\s+at|comes\s+to|gets\s+to|goes\s+to)\b)",
        "did you mean 'reaches'?",
    ),
    ("find show given let", r"^\s*\w+\s*(?P<x>:)", _CUT),
    (
        "other",
        r"^\s*(?P<x>\(?(?P<label>[a-z]|[ivx]{2,4}|\d)[).](?!\d))",
        "a part begins with a line 'part {label}'",
    ),
    (
        "other",
        rf"^\s*{_NAME}\s+and\s+{_NAME}\s+(?P<x>(?:will\s+)?collide)(?!\s+again)\b",
        "did you mean 'A hits B'?",
    ),
    (
        "other event",
        rf"^\s*(?:then\s+)?{_NAME}\s+(?P<x>{_STRIKES})\s+(?!.*\bagain\b)(?:the\s+)?\w+",
        "did you mean 'hits'?",
    ),
    (
        "event",
        rf"^\s*{_NAME}\s+receives\s+(?P<x>(?:an?\s+)?impulse(?:\s+of)?(?:\s+magnitude)?\b)",
        _CUT,
    ),
    (
        "other",
        rf"^\s*{_NAME}\s+(?P<x>(?:gets|is\s+given)\b)",
        "did you mean 'receives'?",
    ),
    ("other", r"^\s*(?P<x>[Tt]hen|[Nn]ow|[Nn]ext|[Tt]he|[Hh]ence|[Tt]hus|[Aa]lso)\b", _CUT),
    ("other", rf"^\s*(?P<x>{_NAME}(?:\s*,\s*{_NAME})*)\s*:", "did you mean 'sphere {x}: …'?"),
    ("event", r"^\s*(?P<x>.*\bagain\b.*?)\s*$", "a fact is 'given {x}'; an event has no 'again'"),
    (
        "other",
        (
            r"^\s*(?P<x>[^=<>≤≥:\s][^=<>≤≥:]*(?:[=<>≤≥]\s*\S|\bcollide\s+again|\bat\s+rest\b"
            r"|\bdo\s+not\s+collide|\bdoes\s+not\s+hit"
            r"|\bhit(?:s)?\b.*\bagain|\bwill\s+(?:not\s+)?hit\b"
            r"|\b(?:perpendicular|parallel|opposite)\s+to\b).*?)\s*$"
        ),
        "did you mean 'given {x}'?",
    ),
    (
        "sphere wall",
        rf"^\s*(?P<x>(?:sphere|wall)\s+)(?={_NAME}\s+(?:{_STRIKES}|hits|receives)\b)",
        _CUT,
    ),
    ("let", r"^\s*let\s+\S+\s+(?P<x>be(?:\s+equal\s+to)?|denote|is)\b", "did you mean '='?"),
    (
        "let",
        r"^\s*(?P<x>let\s+(?!\w+\s*(?:=|,|$))(?P<fact>\S.*[=<>].*?))\s*$",
        "did you mean 'given {fact}'?",
    ),
    ("given show find", r"^\s*\w+\s+(?P<x>that\b)", _CUT),
    # properties
    ("let", r"(?P<x>,)\s*\w+\s*=", "a line 'let' names one quantity"),
    ("", r"(?:\bmass\b|\bradius\b|=)\s*\d+(?P<x>,)\d", "a decimal point is '.'"),
    ("point", r":\s*(?P<x>[^()\s,]+\s*,\s*[^()\s,]+)\s*$", "did you mean '({x})'?"),
    (
        "given let show",
        r"=.*\s(?P<x>find|show|given|let|unknown)\b",
        "'{x}' begins a line of its own",
    ),
    ("given let show", r"(?:\d|%)\s+(?P<x>of)\b", _CUT),
    (
        "given show",
        rf"(?P<x>\b(?P<body>{_NAME})\s+is\s+(?:deflected|turned)\s+(?:through|by)\b)",
        "did you mean 'deflection({body}) ='?",
    ),
    ("event", r"(?P<x>\b(?:perfectly\s+)?elastic)\b", "did you mean 'e = 1'?"),
    ("event", r"(?P<x>\bperfectly\s+inelastic)\b", "did you mean 'e = 0'?"),
    (
        "event",
        r"\breceives\s.*\s(?P<x>along|in\s+the\s+direction\s+of)\b",
        "did you mean 'at 0° from'?",
    ),
    (
        "find show",
        r"imum\s+of\b.*?\s(?P<x>wrt|with\s+respect\s+to|for|as)\b.*$",
        "did you mean 'over'?",
    ),
    (
        "sphere wall event",
        r":.*\s(?P<x>find|show|given|let|unknown)\b",
        "'{x}' begins a line of its own",
    ),
    ("sphere wall event", r"(?P<x><(?P<v>[^<>]*,[^<>]*)>)", "did you mean '({v})'?"),
    ("sphere event", r"[ij]\s*(?P<x>,)\s*[-+−]?\s*[\d.]*\s*[a-z]?\s*[ij]\b", "did you mean '+'?"),
    (
        "sphere",
        r"\bvelocity\s+(?P<x>(?P<a>[\d.\w]+)\s*,?\s*(?P<b>\d[\d.]*\s*(?:°|deg)))",
        "did you mean '{a} at {b}'?",
    ),
    (
        "sphere event",
        r"(?P<x>\bin\s+(?:the\s+)?(?:same\s+)?direction(?:\s+of)?)\b",
        "a direction is told by an angle: 'u at 30°', or 'u at 0° from 3i + 4j'",
    ),
    ("", r"(?P<x>\b(?:anticlockwise|counterclockwise|counter-clockwise))\b", _CUT),
    ("", r"(?P<x>\bclockwise)\b", "angles are anticlockwise: write a negative one"),
    ("", r"\bat\s[^,]*(?P<x>\babove)\b", "did you mean 'from'?"),
    (
        "sphere",
        r"\bat\s+(?P<x>(?P<v>-?[\w.]{1,4}\s*,\s*-?[\w.]{1,4}))\s*(?:,|$)",
        "did you mean '({v})'?",
    ),
    ("event", r"(?P<x>\bat\s+(?:time\s+)?t\s*=)", "a time is a fact: 'given time(1) = …'"),
    ("", r"(?P<x>(?P<a>\w)_\{(?P<b>\d+|\w)\})", "did you mean '{a}_{b}'?"),
    (
        "",
        r"(?P<x>\b(?P<q>sin|cos|tan)\s*[-−–]\s?1\b|\binverse\s+(?P<p>sin|cos|tan)\b)",
        "did you mean 'arc{q}{p}'?",
    ),
    (
        _BODIES,
        rf"^\s*\w+\s+{_NAME}(?:\s*,\s*{_NAME})*\s+(?P<x>and)\s+{_NAME}",
        "did you mean ','?",
    ),
    (
        _BODIES,
        (
            rf"^\s*\w+\s+{_NAME}(?:\s*,\s*{_NAME})*\s*(?P<x>,?\s*(?:has|have|of|with|is|lies|moves)\b"
            r"|[,;=–-])\s*(?=[a-z])"
        ),
        "expected ':' here",
    ),
    (
        _BODIES,
        (
            rf"^\s*\w+\s+{_NAME}(?:\s*,\s*{_NAME})*\s+"
            r"(?P<x>mass|velocity|speed|at|radius|along|parallel|through|from|circle)\b"
        ),
        "expected ':' before '{x}'",
    ),
    (
        "event",
        rf"^\s*{_NAME}\s+hits\s+{_NAME}\s*(?P<x>,?\s*(?:with|where|and|at)\b|,)",
        "expected ':' here",
    ),
    (
        "event",
        rf"^\s*{_NAME}\s+hits\s+{_NAME}\s+(?P<x>along|e|offset|coefficient|line)\b",
        "expected ':' before '{x}'",
    ),
    (
        "event",
        r"(?P<x>coefficient(?:\s+of\s+restitution)?\s*(?:\be\b)?\s*(?:=|:|is\b|of\b)?)",
        "did you mean 'e ='?",
    ),
    ("event", r"\be\s*(?P<x>:|is\b|of\b)", "did you mean '='?"),
    ("event", r":.*[^\s:,]\s+(?P<x>e)\s*=", "expected ',' before '{x}'"),
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
        "did you mean 'along'?",
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
    ("sphere", r"[:,]\s*(?P<x>[mM]\s*=)", "did you mean 'mass'?"),
    (
        "sphere",
        (
            r"[:,]\s*(?P<x>(?!velocity\s*[^=\s])(?:[uvUV]\w*|speed|initial\s+(?:velocity|speed)|moving|moves"
            r"|travelling|moving\s+with\s+(?:velocity|speed))(?:\s*=|\b)(?:\s*(?:of|is|with\s+\w+)\b)?)"
        ),
        "did you mean 'velocity'?",
    ),
    ("sphere", r"[:,]\s*(?P<x>[rR]\s*=)", "did you mean 'radius'?"),
    (
        "sphere",
        r"[:,]\s*(?P<x>(?:(?:is|initially)\s+)+at\s+rest|(?:initially\s+)?(?:rest|stationary|still)\b)",
        "did you mean 'at rest'?",
    ),
    ("sphere", r"[:,]\s*(?P<x>weight)\b", "did you mean 'mass'?"),
    ("sphere", r"[:,]\s*(?P<x>position|centre|initially\s+at|starts\s+at)\b", "did you mean 'at'?"),
    (
        "sphere wall event",
        r"[,\s]\s*(?P<x>(?:where|given|when)\b|(?:sin|cos|tan)\s*\(?[^=,]*=)",
        "a fact stands on a line of its own: 'given tan(alpha) = 3/4'",
    ),
    (
        "wall",
        r"[:,]\s*(?P<x>(?:parallel\s+to|(?:in\s+the\s+)?direction(?:\s+of)?|(?:inclined\s+)?at|angle)\b)",
        "did you mean 'along'?",
    ),
    (
        "wall",
        r"[:,]\s*(?P<x>perp\w*(?:\s+to)?)",
        "a wall is told by its own direction, such as 'along j'",
    ),
    ("wall", r"[:,]\s*(?P<x>horizontal)\b", "did you mean 'along i'?"),
    ("wall", r"[:,]\s*(?P<x>vertical)\b", "did you mean 'along j'?"),
    (
        "wall",
        r"[:,]\s*(?P<x>y\s*=\s*(?P<c>[^,=xy]+?))\s*(?:,|$)",
        "did you mean 'along i, through (0, {c})'?",
    ),
    (
        "wall",
        r"[:,]\s*(?P<x>x\s*=\s*(?P<c>[^,=xy]+?))\s*(?:,|$)",
        "did you mean 'along j, through ({c}, 0)'?",
    ),
    ("wall", r":\s*(?P<x>(?:-?\s*\d*\s*[ij]\b|\(|\d+\s*°)[^,]*)", "did you mean 'along {x}'?"),
    # vectors
    ("", r"\bat\s+(?P<x>(?:an?\s+|the\s+)?(?:acute\s+)?angle(?:\s+of)?)(?!\s*\()", _CUT),
    (
        "",
        r"\bat\s(?!right\b)[^,]*?(?P<x>\b(?:to|with)\s+(?:the\s+)?(?:positive\s+)?(?P<d>-?\s*[ij])\b)",
        "did you mean 'from {d}'?",
    ),
    ("", rf"\bat\s[^,]*?(?P<x>\b(?:with|against|towards)\s+{_BODY})", "did you mean 'to {body}'?"),
    # what is asked, in words
    ("find", r"(?P<x>\bpercentages?(?:\s+of)?)\s", "'as a percentage' stands after an item"),
    (
        "find",
        r"(?P<x>(?:what\s+)?fraction\s+of)\b",
        "write a quotient, such as energy_lost/energy(0)",
    ),
    ("find", r"(?P<x>&)", "did you mean ','?"),
    ("find", r",\s*(?P<x>,)", _CUT),
    ("find", r"(?P<x>\bonly)\b", _CUT),
    (
        "find",
        r"(?P<x>\bin)\s+(?P<v>[a-zα-ω](?:_?\w)?(?:\s*(?:,|and)\s*[a-zα-ω](?:_?\w)?)*)\s*$",
        "did you mean 'in terms of'?",
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:total\s+)?(?:{_KINETIC}\s+(?:lost|loss)|loss\s+(?:of|in)\s+(?:the\s+)?"
            rf"(?:total\s+)?{_KINETIC})\s+(?:by|of)\s+{_BODY})"
        ),
        "did you mean 'energy({body}, before) - energy({body})'?",
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:total\s+(?!energy))?{_KINETIC}\s+(?:lost|loss)\b"
            rf"|loss\s+(?:of|in)\s+(?:the\s+)?(?:total\s+)?{_KINETIC})"
        ),
        "did you mean 'energy_lost'?",
    ),
    (
        _ASKED,
        rf"(?P<x>(?:kinetic\s+energy|K\.?E\.?)\s*(?:of\s+|\(\s*|_)?{_BODY}\)?)",
        "did you mean 'energy({body})'?",
    ),
    (_ASKED, r"(?P<x>\b(?:total\s+)?(?:kinetic\s+energy|K\.?E)\b\.?)", "did you mean 'energy'?"),
    (
        _ASKED,
        (
            rf"(?P<x>angle\s+(?:of\s+deflection|through\s+which)(?:\s+(?:of|for))?\s+{_BODY}"
            r"(?:\s+is\s+deflected)?)"
        ),
        "did you mean 'deflection({body})'?",
    ),
    (
        _ASKED,
        r"(?P<x>angle\s+of\s+deflection|angle\s+(?:turned|deflected)|deflection)(?!\s*\(\s*[A-Z])",
        "did you mean 'deflection(A)'?",
    ),
    (
        _ASKED,
        r"(?P<x>angle\s+between\s+(?:the\s+)?(?P<a>[^,=<>]+?)\s+and\s+(?:the\s+)?(?P<b>[^,=<>]+))",
        "did you mean 'angle({a}, {b})'?",
    ),
    (
        _ASKED,
        rf"(?P<x>distance\s+between\s+{_BODY}\s+and\s+(?:the\s+)?(?P<b>{_NAME}))",
        "did you mean 'distance({body}, {b})'?",
    ),
    (
        _ASKED,
        (
            r"(?P<x>component\s+of\s+(?:the\s+)?(?P<a>[^,=<>]+?)\s+(?:along|parallel\s+to|in\s+the"
            r"\s+direction\s+of)\s+(?:the\s+)?(?P<b>[^,=<>]+))"
        ),
        "did you mean 'along({a}, {b})'?",
    ),
    (
        _ASKED,
        r"(?P<x>(?:magnitude|modulus|size)\s+of\s+(?:the\s+)?impulse)\b",
        "did you mean 'impulse'?",
    ),
    (
        _ASKED,
        (
            rf"(?P<x>initial\s+(?P<q>speed|velocity|direction|energy|momentum)\s*(?:of\s+|\(\s*)?"
            rf"{_BODY}\)?)"
        ),
        "did you mean '{q}({body}, 0)'?",
    ),
    (
        _ASKED,
        (
            rf"(?P<x>(?:(?:final|new|the)\s+)*(?P<q>speed|velocity|direction|deflection|energy|impulse"
            rf"|momentum|position|mass)\s*(?:of\s+(?:motion\s+of\s+)?|on\s+|for\s+)?{_BODY}(?!\s*\())"
        ),
        "did you mean '{q}({body})'?",
    ),
    (
        _ASKED,
        (
            rf"(?P<x>\b(?P<body>{_NAME})['’]s\s+(?:final\s+)?(?P<q>speed|velocity|direction|deflection"
            r"|energy|momentum|position|mass)\b)"
        ),
        "did you mean '{q}({body})'?",
    ),
    (
        _ASKED,
        r"(?P<x>(?:immediately\s+|just\s+|straight\s+)?(?:after|following)\b(?:\s+\w+){0,3})",
        (
            "leave out '{x}': a quantity is the one after the events told so far, "
            "and speed(A, 1) the one after event 1"
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
        "did you mean 'range of'?",
    ),
    (
        "find show",
        (
            r"(?P<x>\b(?:maximum(?!\s+of\b)|max\b\.?(?:imal\b)?|greatest|largest|biggest|highest)"
            r"(?:\s+possible)?(?:\s+value)?(?:\s+of)?)"
        ),
        "did you mean 'maximum of'? It is written 'maximum of Q over X'",
    ),
    (
        "find show",
        (
            r"(?P<x>\b(?:minimum(?!\s+of\b)|min\b\.?(?:imal\b)?|least|smallest|lowest)"
            r"(?:\s+possible)?(?:\s+value)?(?:\s+of)?)"
        ),
        "did you mean 'minimum of'? It is written 'minimum of Q over X'",
    ),
    (
        "find show",
        r"(?P<x>\bin\s+(?:the\s+)?(?:terms?\b(?!\s+of\b)|term\s+of)|\binterms\s+of)",
        "did you mean 'in terms of'?",
    ),
    (
        "find",
        (
            r"(?P<x>\b(?:as|in)\s+(?:an?\s+)?(?:percentages?|percent|per\s+cent|%)"
            r"(?:\s+(?:form|of\b.*))?)"
        ),
        "did you mean 'as a percentage'?",
    ),
    (
        "find",
        (
            r"(?P<x>(?:,\s*)?\b(?:correct\s+)?(?:in|to)\s+(?:degrees|radians|°|\d\s*(?:s\.?f\.?|d\.?p\.?)|m\s*/\s*s|exact"
            r"\s+form)\b.*)"
        ),
        "leave out '{x}': answers come exact and to 3 significant figures",
    ),
    (
        "find",
        r"(?P<x>\b(?:when|if|where|given|assuming|for\s+which)\b)",
        "a fact stands on a line of its own before this: 'given …'",
    ),
    # relations
    (
        "",
        (
            rf"\b(?:to|from|of|hits|with|along|receives|reaches|,|\()\s*"
            rf"(?P<x>(?:the\s+)?(?:wall|sphere|ball|particle|point))\s+(?=\(|{_NAME}\b)"
        ),
        _CUT,
    ),
    ("", r"(?P<x>(?P<o>[<>])\s+=)", "did you mean '{o}='?"),
    (
        "given show",
        r"(?P<x>(?P<q>[^\s,]+)\s+(?:is\s+|lies\s+)?between\s+(?P<a>[^\s,]+)\s+and\s+(?P<b>[^\s,]+))",
        "did you mean '{a} < {q} < {b}'?",
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<body>{_NAME})\s+(?:now\s+)?(?:is\s+)?(?:moves|moving|travels|travelling)\b)",
        "did you mean 'velocity({body})'?",
    ),
    (
        "given show",
        rf"(?P<x>\b(?P<body>{_NAME})\s+(?:rests|stops|comes\s+to\s+rest|is\s+brought\s+to\s+rest))\b",
        "did you mean '{body} at rest'?",
    ),
    (
        "given show",
        r"(?P<x>\bdon['’]t\s+collide(?:\s+again)?)",
        "did you mean 'do not collide again'?",
    ),
    ("given show", r"(?P<x>\bdoesn['’]t\s+hit)\b", "did you mean 'does not hit'?"),
    ("given show", r"(?P<x>\bwon['’]t\s+hit)\b", "did you mean 'will not hit'?"),
    ("", r"(?P<x>={2,3})", "did you mean '='?"),
    ("", r"(?P<x>=\s*<)", "did you mean '<='?"),
    ("", r"(?P<x>=\s*>)", "did you mean '>='?"),
    (
        "",
        (
            r"(?P<x>\b(?:is|are)(?:\s+equal)?)\s+(?=(?:not\s+)?(?:perpendicular|parallel|opposite"
            r"|at\s+rest|in\s+the\s+direction))"
        ),
        _CUT,
    ),
    ("given show", r"(?P<x>\bis\s+(?:less|smaller)\s+than)\b", "did you mean '<'?"),
    ("given show", r"(?P<x>\bis\s+(?:greater|more|larger|bigger)\s+than)\b", "did you mean '>'?"),
    ("given show", r"(?P<x>\b(?:is\s+)?at\s+least)\b", "did you mean '>='?"),
    ("given show", r"(?P<x>\b(?:is\s+)?at\s+most)\b", "did you mean '<='?"),
    (
        "given show",
        r"(?P<x>\b(?:is|are)\s+(?:perp\w*|at\s+right\s+angles)(?:\s+(?:to|with))?)",
        "did you mean 'perpendicular to'?",
    ),
    ("given show let", r"(?P<x>\b(?:is\s+equal\s+to|equals?(?:\s+to)?|is))\b", "did you mean '='?"),
    (
        "given show",
        (
            r"(?P<x>\bperp\b\.?(?:\s+(?:to|with)\b)?|\bperpendicular\b(?!\s+to\b)(?:\s+with\b)?|[⊥⟂]"
            r"|\bnormal\s+to\b|\bat\s+right\s+angles\s+(?:to|with)\b)"
        ),
        "did you mean 'perpendicular to'?",
    ),
    (
        "given show",
        r"(?P<x>\bparallel\b(?!\s+to\b)(?:\s+with\b)?|[∥‖]|\|\|)",
        "did you mean 'parallel to'?",
    ),
    (
        "given show",
        r"(?P<x>\bin\s+(?:the\s+)?(?:same\s+)?direction(?:\s+(?:of|as))?\b)",
        "did you mean 'in the direction of'?",
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
    ("", r"(?P<x>;)", "did you mean ','?"),
    ("", r"(?P<x>\b(?:the|smooth))\b\s*", _CUT),
    ("find given unknown show sphere wall event", r"(?P<x>\band\b)", "did you mean ','?"),
)


@dataclass(frozen=True)
class _Slip:
    lines: frozenset[str]
    pattern: re.Pattern[str]
    said: str


@cache
def _slips() -> tuple[_Slip, ...]:
    """The table, compiled when the first mistake is met: most statements have none."""
    return tuple(
        _Slip(frozenset(lines.split()), re.compile(pattern), said)
        for lines, pattern, said in _TABLE
    )


_EVENT = re.compile(rf"\s*{_NAME}\s+(?:hits|receives|reaches)\b")
_SHOWN = 60
_LONGEST = 300  # what people write in one line; a longer one is not searched


def with_guess(source: Source, word: str, mistake: StatementError) -> StatementError:
    """The mistake in a line, told by what was probably meant where that is known.

    ``word`` is the first word of the line. A slip counts only where the mistake was met, a word
    that is outside the model wherever it stands.
    """
    if beyond := outside(source):
        return beyond
    kind = "event" if _EVENT.match(source.plain) else word if word in LINE_WORDS else "other"
    start_of_line = source.place(len(source.text) - len(source.text.lstrip()))
    if (mistake.line, mistake.column) == (start_of_line.line, start_of_line.column) and (
        mistake.message.endswith(tuple(f"did you mean '{each}'?" for each in LINE_WORDS))
    ):
        return mistake  # the first word is known already
    for slip, match in _found(source, kind):
        span = "x" if "x" in slip.pattern.groupindex else 0
        start, end = match.span(span)
        first, last = source.place(match.start()), source.place(match.end())
        at = (mistake.line, mistake.column)
        if (first.line, first.column) <= at <= (last.line, last.column):
            parts = {
                name: _short(source.text[slice(*match.span(name))]) if match[name] else ""
                for name in slip.pattern.groupindex
            }
            place = source.place(start)
            typed = _short(source.text[start:end])
            said = slip.said.format(**{**parts, "x": typed})
            return StatementError(f"cannot read '{typed}': {said}", place.line, place.column)
    return mistake


def _found(source: Source, kind: str) -> Iterator[tuple[_Slip, re.Match[str]]]:
    if len(source.plain) > _LONGEST:
        return
    for slip in _slips():
        if not slip.lines or kind in slip.lines:
            for match in slip.pattern.finditer(source.plain):
                yield slip, match


def _short(text: str) -> str:
    text = " ".join(text.split())
    return text if len(text) <= _SHOWN else text[: _SHOWN - 1] + "…"
