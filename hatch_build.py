"""Makes what the package ships and nobody writes: a font, and the tables of its parsers.

The font is for mathematics on the page: a part of the STIX Two Math of ziamath. The whole is
1.5 MB; what the package's MathML can hold is a tenth of that. It comes under the SIL Open Font
License, which stands in its name table and is kept there.

The tables spare each start the making of parsers. They are made by the package itself, of its
grammars as they stand.
"""

from __future__ import annotations

import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

FONT = "src/restitution/web/static/fonts/stix-two-math.woff2"
TABLE = "src/restitution/expression/tables/{}.table"

CHARACTERS = (
    "".join(map(chr, range(0x20, 0x7F)))
    + "\N{NO-BREAK SPACE}°±·×÷¼½¾²³¹⅓⅔⅕⅖⅗⅘⅙⅚⅛⅜⅝⅞′″–—‘’“”…"
    + "⁰⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉"
    + "".join(map(chr, range(0x391, 0x3CA)))  # Greek
    + "ϑϕϖϱϵ"
    + "−∓√∞∝∠∥⊥∴∵≈≠≡≤≥→⇒∈∪∩"
    + "⁡⁢⁣⁤"  # what is applied, multiplied, listed and added unseen
    + "".join(map(chr, range(0x1D400, 0x1D434)))  # bold letters
    + "".join(map(chr, range(0x1D434, 0x1D455)))  # italic letters, h apart
    + "ℎ"
    + "".join(map(chr, range(0x1D456, 0x1D468)))
    + "".join(map(chr, range(0x1D6E2, 0x1D71C)))  # italic Greek
    + "".join(map(chr, range(0x1D7CE, 0x1D7D8)))  # bold digits
)
"""What MathML of this package may show. A letter in ``mi`` is shown as an italic one."""


class CustomBuildHook(BuildHookInterface[Any]):
    """Called by hatchling for a wheel, editable or not."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Write everything where the package finds it."""
        made = {FONT: font(), **tables(Path(self.root) / "src")}
        for name, content in made.items():
            target = Path(self.root) / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)


def font() -> bytes:
    """The font as WOFF2, the same bytes for the same versions of what makes it."""
    from io import BytesIO

    from fontTools import subset
    from fontTools.ttLib import TTFont

    options = subset.Options()
    options.flavor = "woff2"
    options.layout_features = []
    options.name_IDs = ["*"]
    options.recalc_timestamp = False
    whole = TTFont(_source(), recalcTimestamp=False)
    subsetter = subset.Subsetter(options)
    subsetter.populate(text=CHARACTERS)
    subsetter.subset(whole)
    written = BytesIO()
    whole.flavor = "woff2"
    whole.save(written)
    return written.getvalue()


def _source() -> Path:
    found = find_spec("ziamath")
    assert found is not None
    assert found.origin is not None
    return Path(found.origin).parent / "fonts" / "STIXTwoMath-Regular.ttf"


def tables(source: Path) -> dict[str, bytes]:
    """The tables of all parsers of the package that lies in a folder, by their paths."""
    sys.path.insert(0, str(source))
    try:
        from restitution.expression.grammar import EXPRESSION
        from restitution.expression.parsers import saved
        from restitution.language.grammar import STATEMENT
    finally:
        sys.path.remove(str(source))
    return {
        TABLE.format("expression"): saved(EXPRESSION, "expression"),
        TABLE.format("line"): saved(STATEMENT, "line"),
    }
