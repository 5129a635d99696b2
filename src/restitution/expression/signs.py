"""Signs that a line may have, what pasted ones stand for, and what to write instead of others."""

from __future__ import annotations

SIGNS = {
    "+": "PLUS",
    "-": "MINUS",
    "*": "STAR",
    "**": "POW",
    "^": "POW",
    "/": "SLASH",
    "(": "LPAR",
    ")": "RPAR",
    ",": "COMMA",
    ":": "COLON",
    "=": "EQUAL",
    "<": "ORDER",
    ">": "ORDER",
    "<=": "ORDER",
    ">=": "ORDER",
}

PASTED = {
    **dict.fromkeys("−–‐‑", "-"),
    **dict.fromkeys("×·⋅∙•∗", "*"),
    **dict.fromkeys("÷∕⁄", "/"),
    **dict.fromkeys("≤⩽", "<="),
    **dict.fromkeys("≥⩾", ">="),
}

FRACTIONS = {
    "½": "1/2",
    "⅓": "1/3",
    "⅔": "2/3",
    "¼": "1/4",
    "¾": "3/4",
    "⅕": "1/5",
    "⅖": "2/5",
    "⅗": "3/5",
    "⅘": "4/5",
    "⅙": "1/6",
    "⅚": "5/6",
    "⅐": "1/7",
    "⅛": "1/8",
    "⅜": "3/8",
    "⅝": "5/8",
    "⅞": "7/8",
    "⅑": "1/9",
    "⅒": "1/10",
}

HINTS = {
    **dict.fromkeys("[]{}", "use round brackets"),
    **dict.fromkeys("|‖", "write abs(x) for a size"),
    **dict.fromkeys("'’′", "a letter has no dash: use another letter or a subscript"),
    **dict.fromkeys("°º˚", "a degree sign stands directly after a number"),
    **dict.fromkeys('“”„"‘', "leave out the quotation marks"),
    **dict.fromkeys("≈~", "write = … to 3 s.f."),
    **dict.fromkeys("@∠", "write a vector as u at 30°"),
    "%": "a percent sign stands directly after a number",
    "_": "a subscript follows a letter directly and is digits or one letter",
    "≠": "the relations are =, <, <=, > and >=",
    "!": "the relations are =, <, <=, > and >=",
    "\\": "a backslash stands at the end of a line that goes on in the next",
    ".": "a decimal point stands between digits",
    "#": "a comment cannot stand here",
}

CURES = {**dict.fromkeys("[{", "("), **dict.fromkeys("]}", ")"), **dict.fromkeys('“”„"‘', "")}

LOOK_ALIKES = dict(
    zip(
        "АВЕКМНОРСТУХЅІЈаеорсухѕіј" + "ΑΒΕΖΗΙΚΜΝΟΡΤΥΧο" + "ıȷ",
        "ABEKMHOPCTYXSIJaeopcyxsij" + "ABEZHIKMNOPTYXo" + "ij",
        strict=True,
    )
)
"""Cyrillic and Greek letters, and dotless ones, that look like a Latin letter, which is meant."""

SUBSCRIPT_DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")

SUPERSCRIPT_DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")
