"""What is asked, in words."""

from __future__ import annotations

from restitution.language.slip_tables.patterns import (
    AFTER,
    ASKING_LINES,
    BODY,
    CUT,
    KINETIC,
    LOST,
    NAME,
    RESTITUTION,
    STRIKES,
    Cure,
    Slip,
    either,
    meant,
)

_STRIKES_OR_REACHES = rf"(?:hits|reaches|arrives\s+at|{STRIKES})"

_THE_IMPACT = r"(?:\s+(?:the\s+)?(?:impact|collision))?"
_UNITS = (
    r"(?:[ck]?m\s*/\s*(?:s|h)|[ck]?m\s?s\s?\^?\(?-1\)?|[ck]?m\s?s⁻¹|km\s*/?\s*h|mph|k?J|joules"
    r"|N\s?s|SI)"
)

ASKED: tuple[Slip, ...] = (
    (
        "find",
        rf"(?P<x>(?:,\s*)?\bin\s+{_UNITS}(?!\w)(?:\s+units)?)",
        Cure("leave out '{x}': answers are in SI units", ""),
    ),
    (
        "find",
        (
            r"^\s*find\s+(?:.*,\s*)?(?P<x>(?P<q>[^\s,][^,]*?)\s+as\s+an?\s+(?P<share>percentage|percent|fraction|proportion)"
            r"\s+of\s+(?:the\s+|its\s+)?(?P<w>(?:(?:initial|original|total)\s+)*"
            rf"{KINETIC}(?!\s*\()(?:\s+before\b.*)?|(?:initial|original)\s+value))"
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
            rf"(?:{KINETIC}\s+{LOST}|loss\s+(?:of|in)\s+(?:the\s+)?{KINETIC})\s+by\s+{BODY})"
        ),
        meant("(energy({body}, before) - energy({body}))/energy({body}, before) as a percentage"),
    ),
    ("find", r"[A-Za-z)]\s*(?P<x>%)\s*(?:$|,)", meant("as a percentage")),
    (
        "find",
        rf"(?P<x>(?:how\s+much\s+(?:of\s+the\s+)?|the\s+amount\s+of\s+)(?:\w+\s+)??{KINETIC}\s+{LOST})",
        meant("energy_lost"),
    ),
    (
        "find",
        (
            rf"(?P<x>(?:the\s+|what\s+)?(?:percentages?|%)\s+(?:of\s+)?(?:the\s+)?(?:(?:initial|original|total)\s+)?"
            rf"(?:{KINETIC}\s+{LOST}|loss\s+(?:of|in)\s+(?:the\s+)?{KINETIC}))"
        ),
        meant("energy_lost/energy(0) as a percentage"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>(?:what\s+|the\s+)?(?:fraction|proportion)\s+of\s+(?:the\s+)?(?:(?:initial|original|total)\s+)?"
            rf"{KINETIC}\s+{LOST})"
        ),
        meant("energy_lost/energy(0)"),
    ),
    (
        "other given show",
        (
            r"(?P<x>(?P<n>\d[\d.]*\s*(?:%|per\s?cent)|\d+/\d+)\s+of\s+(?:the\s+)?(?:(?:initial|original|total)\s+)*"
            rf"{KINETIC}\s+is\s+lost)"
        ),
        meant("energy_lost = {n} of energy(0)"),
    ),
    (
        ASKING_LINES,
        rf"(?P<x>(?:the\s+)?total\s+(?:linear\s+)?momentum\s+before{_THE_IMPACT})\s*(?:,|$)",
        meant("momentum(0)"),
    ),
    (
        ASKING_LINES,
        rf"(?P<x>(?:the\s+)?total\s+(?:linear\s+)?momentum(?:\s+after{_THE_IMPACT})?)\s*(?:,|$)",
        meant("momentum"),
    ),
    ("find", r"(?P<x>(?:the\s+)?total\s+momentum)\b", meant("momentum")),
    (
        "given let show other",
        r"(?P<x>(?:that\s+)?(?:(?:total|linear)\s+)*momentum\s+is\s+conserved|\bmomentum\s+conserved)\b",
        "momentum is conserved wherever two spheres collide: this line can be left out",
    ),
    (
        "given show other",
        (
            r"(?P<x>\b(?:they|(?:the\s+)?(?:two\s+)?(?:spheres|balls|particles))\s+(?:(?:are\s+)?mov\w+|travel|go|separate)"
            rf"(?:\s+off)?\s+at\s+right\s+angles(?:\s+to\s+(?:each\s+other|one\s+another))?(?:\s+after(?:wards\b|{_THE_IMPACT}))?)"
        ),
        Cure("did you mean {each}?", "angle(velocity({first}), velocity({second})) = 90°"),
    ),
    (
        ASKING_LINES,
        (
            r"(?P<x>(?:the\s+)?angle\s+(?:through|by)\s+which\s+(?:it|the\s+(?:sphere|ball|particle))\s+is\s+"
            r"(?:deflected|turned))"
        ),
        Cure("did you mean {each}?", "deflection({sphere})"),
    ),
    *(
        (
            ASKING_LINES,
            rf"(?P<x>(?:the\s+)?ratio\s+of\s+(?:the(?:ir)?\s+)?(?:{words})(?:\s+after{_THE_IMPACT})?)\s*(?:,|$)",
            Cure("did you mean {each}?", f"{quantity}({{first}})/{quantity}({{second}})"),
        )
        for words, quantity in ((r"kinetic\s+energies|KEs", "energy"), ("speeds", "speed"))
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>(?:the\s+)?angle\s+(?:through\s+which\s+|that\s+)?{BODY}\s+is\s+"
            r"(?:deflected|turned)(?:\s+(?:through|by))?)"
        ),
        meant("deflection({body})"),
    ),
    (
        ASKING_LINES,
        rf"(?P<x>(?:the\s+)?(?:initial|original)\s+(?:total\s+)?{KINETIC})(?!\s*(?:of\b|\())",
        meant("energy(0)"),
    ),
    (ASKING_LINES, r"(?P<x>\|(?P<v>[^|]+)\|)", meant("abs({v})")),
    (
        ASKING_LINES,
        rf"(?P<x>(?:the\s+)?(?:magnitude|modulus|size)\s+of\s+(?:the\s+)?velocity\s+of\s+{BODY})",
        meant("speed({body})"),
    ),
    (
        ASKING_LINES,
        (
            r"(?P<x>(?:the\s+)?(?:magnitude|modulus|size)\s+of\s+(?:the\s+)?"
            r"(?P<v>\w+\([^()]*\)))"
        ),
        meant("abs({v})"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>(?:the\s+)?velocity\s*(?:of\s+|\(\s*){BODY}\s*\)?\s+relative\s+to\s+"
            rf"(?P<b>{NAME}))"
        ),
        meant("velocity({body}) - velocity({b})"),
    ),
    (ASKING_LINES, r"(?P<x>\b(?:the\s+)?components\s+of)\b", CUT),
    (
        "find",
        r"(?P<x>(?:the\s+)?ratio\s+(?:of\s+)?(?:the\s+)?(?P<a>(?:\([^()]*\)|[^,:()])+?)\s*(?::|\bto\b)\s*(?:the\s+)?(?P<b>(?:\([^()]*\)|[^,:()])+))$",
        meant("({a})/({b})"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>(?:the\s+)?{KINETIC}\s+of\s+{BODY}\s+(?:immediately\s+|just\s+)?before\b"
            r"(?:\s+(?:the|its|this|impact|collision|it\w*))*)"
        ),
        meant("energy({body}, before)"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>(?:the\s+)?(?P<q>speed|velocity|direction|energy|momentum)\s+of\s+{BODY}\s+"
            r"(?:immediately\s+|just\s+)?before\b(?:\s+(?:the|its|this|impact|collision|it\w*))*)"
        ),
        meant("{q}({body}, before)"),
    ),
    (
        "find",
        (
            rf"(?P<x>(?:(?:final|new|the)\s+)*(?P<q>speed|direction|deflection|energy|momentum|mass)s?"
            rf"\s+(?:of\s+)?{BODY}\s*(?:\band\b|&)\s*(?:of\s+)?(?P<b>{NAME}))(?!\s*\()"
        ),
        meant("{q}({body}), {q}({b})"),
    ),
    (
        "find",
        (
            rf"(?P<x>(?:(?:final|new|the)\s+)*velocit(?:y|ies)\s+(?:of\s+)?{BODY}\s*(?:\band\b|&)\s*(?:of\s+)?"
            rf"(?P<b>{NAME}))(?!\s*\()"
        ),
        meant("velocity({body}), velocity({b})"),
    ),
    *(
        (
            ASKING_LINES,
            (
                rf"(?P<x>(?:the\s+)?{size}impulse\s+(?:(?:received|experienced)\s+by|(?:acting|exerted)\s+on"
                rf"|given\s+to|imparted\s+to|(?:of|exerted\s+by|from)\s+(?:the\s+\w+|{NAME})\s+on)"
                rf"\s+{BODY}(?:\s+by\s+(?:the\s+)?\w+)?)"
            ),
            meant(text),
        )
        for size, text in (
            (r"(?:magnitude|size)\s+of\s+(?:the\s+)?", "abs(impulse({body}))"),
            ("", "impulse({body})"),
        )
    ),
    (
        ASKING_LINES,
        rf"(?P<x>(?:the\s+)?change\s+(?:in|of)\s+(?:the\s+)?momentum\s+(?:of|for)\s+{BODY})",
        meant("impulse({body})"),
    ),
    (
        ASKING_LINES,
        (
            r"(?P<x>(?:the\s+)?(?:acute\s+)?angle\s+(?:that\s+|which\s+)?(?:the\s+(?:path|direction\s+of\s+motion"
            rf"|velocity)\s+of\s+)?{BODY}\s+makes\s+with\s+(?P<b>[^,=]+?)){AFTER}?\s*(?:$|,|=)"
        ),
        meant("angle(velocity({body}), {b})"),
    ),
    (
        "given show",
        (
            r"(?P<x>(?:the\s+)?(?:direction(?:\s+of\s+motion)?|path|velocity)\s+of\s+"
            rf"{BODY}\s+is\s+(?:turned|deflected|changed)\s+(?:through|by))\b"
        ),
        meant("deflection({body}) ="),
    ),
    *(
        (
            "given show",
            (
                rf"(?P<x>(?:(?:the\s+)?(?:direction(?:\s+of\s+motion)?|path|velocity)\s+of\s+)?{BODY}"
                rf"\s+(?:is|moves|is\s+moving)\s+(?:off\s+)?(?:{words})\s+to\s+its\s+"
                r"(?:original|initial|previous|first)\s+(?:direction(?:\s+of\s+motion)?|velocity|path))"
            ),
            meant(f"velocity({{body}}) {relation} velocity({{body}}, 0)"),
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
            rf"(?P<x>{BODY}\s+loses\s+(?P<n>\d[\d.]*\s*(?:%|per\s?cent))\s+of\s+its\s+"
            rf"(?:(?:initial|original)\s+)?{KINETIC})"
        ),
        meant("energy({body}, before) - energy({body}) = {n} of energy({body}, before)"),
    ),
    (
        "given show other",
        (
            rf"(?P<x>{BODY}\s+loses\s+(?P<n>\d[\d.]*(?:\s*/\s*\d+)?)\s*(?:J|joules?)\s+of\s+"
            rf"(?:its\s+)?{KINETIC})"
        ),
        meant("energy({body}, before) - energy({body}) = {n}"),
    ),
    *(
        (
            "given show other",
            (
                rf"(?P<x>{BODY}\s+loses\s+{words}\s+(?:of\s+)?its\s+"
                rf"(?:(?:initial|original)\s+)?{KINETIC})"
            ),
            meant(f"energy({{body}}, before) - energy({{body}}) = {lost} energy({{body}}, before)"),
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
                rf"(?P<x>{BODY}\s+loses\s+{words}\s+(?:of\s+)?its\s+(?:(?:initial|original)\s+)?"
                r"speed)"
            ),
            meant(f"speed({{body}}) = {left} speed({{body}}, before)"),
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
        rf"(?P<x>velocity\s*\(\s*{BODY}\s*\)\s+perpendicular\s+to\s+(?:the\s+)?(?P<w>{NAME}))\s*(?:,|$)",
        meant("across(velocity({body}), {w})"),
    ),
    (
        "find other",
        rf"(?P<x>velocity\s*\(\s*{BODY}\s*\)\s+parallel\s+to\s+(?:the\s+)?(?P<w>{NAME}))\s*(?:,|$)",
        meant("along(velocity({body}), {w})"),
    ),
    (
        "find other",
        rf"(?P<x>change\s+(?:in|of)\s+(?:the\s+)?velocity\s+of\s+{BODY})",
        meant("velocity({body}) - velocity({body}, before)"),
    ),
    *(
        (
            "given show other",
            (
                rf"(?P<x>{words}\s+(?:of\s+)?(?:the\s+)?(?:(?:initial|original|total)\s+)*{KINETIC}\s+"
                r"is\s+lost)"
            ),
            meant(f"energy_lost = {share} energy(0)"),
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
        ("given show", rf"(?P<x>\bis\s+(?:{words}))\s+(?!that\b|of\b)", meant(f"= {factor}"))
        for words, factor in (
            ("twice|double|two\\s+times", "2"),
            ("three\\s+times", "3"),
            ("half", "1/2"),
        )
    ),
    (
        "given show",
        (
            rf"(?P<x>(?:the\s+)?speeds\s+of\s+{BODY}\s+and\s+(?P<b>{NAME})\s+are\s+(?:equal|the\s+same)"
            rf"|(?P<c>{NAME})\s+and\s+(?P<d>{NAME})\s+have\s+(?:equal\s+speeds?|the\s+same\s+speed))"
        ),
        meant("speed({body}{c}) = speed({b}{d})"),
    ),
    *(
        (
            "given show",
            (
                rf"(?P<x>(?P<a>{NAME})\s+and\s+(?P<b>{NAME})\s+(?:then\s+|now\s+)?(?:are\s+moving|move|travel)"
                rf"\s+(?:off\s+)?(?:{words}))"
            ),
            meant(f"velocity({{a}}) {relation} velocity({{b}})"),
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
        meant("speed({a}) > speed({b})"),
    ),
    ("find", rf"(?P<x>(?:the\s+)?{RESTITUTION})", meant("e")),
    (
        "given show",
        rf"(?P<x>(?:the\s+)?{RESTITUTION}\s*(?:\be\b)?\s*(?:=|is\b))",
        meant("e ="),
    ),
    ("find", r"(?P<x>\bpercentages?(?:\s+of)?)\s", "'as a percentage' stands after an item"),
    (
        "find",
        r"(?P<x>(?:what\s+)?fraction\s+of)\b",
        "write a quotient, such as energy_lost/energy(0)",
    ),
    ("find", r"(?P<x>&)", meant(",")),
    ("find", r",\s*(?P<x>,)", CUT),
    ("find", r",\s*(?P<x>find)\b", CUT),
    ("find", r"(?P<x>\bonly)\b", CUT),
    (
        "find",
        r"(?P<x>\bin)\s+(?P<v>[a-zα-ω](?:_?\w)?(?:\s*(?:,|and)\s*[a-zα-ω](?:_?\w)?)*)\s*$",
        meant("in terms of"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>(?:total\s+)?(?:{KINETIC}\s+(?:lost|loss)|loss\s+(?:of|in)\s+(?:the\s+)?"
            rf"(?:total\s+)?{KINETIC})\s+(?:by|of)\s+{BODY})"
        ),
        meant("energy({body}, before) - energy({body})"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>total\s+(?!energy_){KINETIC}\s+(?:lost|loss)\b(?:\s+altogether)?"
            rf"|total\s+loss\s+(?:of|in)\s+(?:the\s+)?{KINETIC})"
        ),
        either("energy_lost", "total_energy_lost"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>(?:total\s+(?!energy))?{KINETIC}\s+(?:lost|loss)\b"
            rf"|loss\s+(?:of|in)\s+(?:the\s+)?(?:total\s+)?{KINETIC})"
        ),
        meant("energy_lost"),
    ),
    (
        ASKING_LINES,
        rf"(?P<x>(?:kinetic\s+energy|K\.?E\.?)\s*(?:of\s+|\(\s*|_)?{BODY}\)?)",
        meant("energy({body})"),
    ),
    (ASKING_LINES, r"(?P<x>\b(?:total\s+)?(?:kinetic\s+energy|K\.?E)\b\.?)", meant("energy")),
    (
        ASKING_LINES,
        (
            rf"(?P<x>angle\s+(?:of\s+deflection|through\s+which)(?:\s+(?:of|for))?\s+{BODY}"
            r"(?:\s+is\s+deflected)?)"
        ),
        meant("deflection({body})"),
    ),
    (
        ASKING_LINES,
        r"(?P<x>angle\s+of\s+deflection|angle\s+(?:turned|deflected)|deflection)(?!\s*\(?\s*[A-Z])",
        Cure("did you mean {each}?", "deflection({sphere})"),
    ),
    (
        ASKING_LINES,
        (
            r"(?P<x>(?:the\s+)?(?:acute\s+)?angle\s+between\s+(?:the\s+)?"
            r"(?P<a>(?:\([^()]*\)|[^,=<>()])+?)\s+and\s+(?:the\s+)?(?P<b>(?:\([^()]*\)|[^,=<>()])+))"
        ),
        meant("angle({a}, {b})"),
    ),
    *(
        (
            ASKING_LINES,
            rf"(?P<x>(?:the\s+)?distance\s+(?:between|of|from)\s+{BODY}\s+(?:and|from|to)\s+{end})",
            meant(f"distance({{body}}, {text})"),
        )
        for end, text in (
            (r"(?:the\s+)?(?:[Oo]rigin\b|O(?=\s*(?:,|$|\(0)))(?:\s*\(0,\s*0\))?", "(0, 0)"),
            (r"(?P<b>\([^()]*\))", "{b}"),
            (rf"(?:the\s+)?(?:point\s+|corner\s+|sphere\s+|ball\s+)?(?P<b>{NAME})\b", "{b}"),
        )
    ),
    (
        ASKING_LINES,
        (
            r"(?P<x>component\s+of\s+(?:the\s+)?(?P<a>[^,=<>]+?)\s+(?:along|parallel\s+to|in\s+the"
            r"\s+direction\s+of)\s+(?:the\s+)?(?P<b>[^,=<>]+))"
        ),
        meant("along({a}, {b})"),
    ),
    (
        ASKING_LINES,
        r"(?P<x>(?:magnitude|modulus|size)\s+of\s+(?:the\s+)?impulse)\b",
        meant("impulse"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>initial\s+(?P<q>speed|velocity|direction|energy|momentum)\s*(?:of\s+|\(\s*)?"
            rf"{BODY}\)?)"
        ),
        meant("{q}({body}, 0)"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>(?:(?:final|new|the)\s+)*(?P<q>speed|velocity|direction|deflection|energy|impulse"
            rf"|momentum|position|mass)\s*(?:of\s+(?:motion\s+of\s+)?|on\s+|for\s+)?{BODY}(?!\s*\())"
        ),
        meant("{q}({body})"),
    ),
    (
        ASKING_LINES,
        (
            rf"(?P<x>\b(?P<body>{NAME})['’]s\s+(?:final\s+)?(?P<q>speed|velocity|direction|deflection"
            r"|energy|momentum|position|mass)\b)"
        ),
        meant("{q}({body})"),
    ),
    (
        ASKING_LINES,
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
        ASKING_LINES,
        r"(?P<x>(?:immediately\s+|just\s+)?before\b(?:\s+\w+){0,3})",
        "before its latest event the speed of A is speed(A, before)",
    ),
    (
        "find",
        (
            r"(?P<x>(?:the\s+)?(?:set|range)\s+of\s+(?:the\s+)?(?:possible\s+)?values\s+(?:of|for)"
            r"|(?:possible\s+)?values\s+(?:of|for)|range\s+for|range\s+of\s+the)"
        ),
        meant("range of"),
    ),
    (
        "find show",
        (
            r"(?P<x>\b(?:maximum(?!\s+of\b)|max\b\.?(?:imal\b)?|greatest|largest|biggest|highest)"
            r"(?:\s+possible)?(?:\s+value)?(?:\s+of)?)"
        ),
        meant("maximum of", " It is written 'maximum of Q over X'"),
    ),
    (
        "find show",
        (
            r"(?P<x>\b(?:minimum(?!\s+of\b)|min\b\.?(?:imal\b)?|least|smallest|lowest)"
            r"(?:\s+possible)?(?:\s+value)?(?:\s+of)?)"
        ),
        meant("minimum of", " It is written 'minimum of Q over X'"),
    ),
    (
        "find show",
        (
            r"\bin\s+terms\s+of\b.*?(?P<x>\b(?:sin|cos|tan)(?:\s*(?:\^\s*2|²))?"
            r"\s*(?:\(\s*(?P<v>[a-zα-ω]\w*)\s*\)|(?<=\s)(?P<w>[a-zα-ω]\w*)))"
        ),
        Cure("an answer in terms of {x} is asked in terms of the letter in it: '{v}{w}'", "{v}{w}"),
    ),
    (
        "find show",
        r"(?P<x>\bin\s+(?:the\s+)?(?:terms?\b(?!\s+of\b)|term\s+of)|\binterms\s+of)",
        meant("in terms of"),
    ),
    (
        "find",
        (
            r"(?P<x>\b(?:as|in)\s+(?:an?\s+)?(?:percentages?|percent|per\s+cent|%)"
            r"(?:\s+(?:form|of\b.*))?)"
        ),
        meant("as a percentage"),
    ),
    (
        "find",
        (
            r"(?P<x>(?:,\s*)?\b(?:correct\s+)?(?:in|to)\s+(?:degrees|radians|°|exact\s+form"
            r"|(?:\d|one|two|three)\s*(?:s\.?f\.?|d\.?p\.?|decimal\s+places?|significant\s+figures?"
            r"|sig\.?\s*figs?))(?!\w)[^,]*)"
        ),
        Cure("leave out '{x}': answers come exact and to 3 significant figures", ""),
    ),
    (
        "find",
        (
            r"^(?P<all>\s*(?P<asked>find\s+range\b.*?)\s*,?\s*\b(?P<x>such\s+that|so\s+that|if|for\s+which)\s+"
            rf"(?:the\s+\w+\s+)?(?P<body>{NAME})\s+(?:then\s+|will\s+|also\s+)?{_STRIKES_OR_REACHES}\s+"
            rf"(?:the\s+)?(?:wall\s+)?(?P<w>{NAME}))\s*$"
        ),
        Cure(
            "what happens stands on a line of its own before this: '{body} hits {w}'",
            "{body} hits {w}\n{asked}",
            of="all",
        ),
    ),
    (
        "find",
        rf"(?P<x>\s+(?:when|as|where)\s+(?:it|{NAME})\s+(?:then\s+)?{_STRIKES_OR_REACHES}\s+(?:the\s+)?(?:wall\s+)?{NAME})\s*(?:,|$)",
        Cure("leave out '{x}': a quantity is the one after the events told so far", "", tight=True),
    ),
    (
        "find",
        (
            r"^(?P<all>\s*(?P<asked>find\b.*?)\s*,?\s*"
            r"\b(?P<x>when|if|where|given(?:\s+that)?|assuming|for\s+which|such\s+that"
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
)
