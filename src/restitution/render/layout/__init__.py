"""How mathematics is laid out, as data: no output format, no algebra.

The nodes are few and frozen. Builders (`product`, `power`, `function`, …) put brackets where the
meaning needs them, so that every renderer can print a node without looking at its surroundings.
`from_sympy` chooses the order of factors and terms that textbooks use.
"""

from __future__ import annotations

from restitution.render.layout.algebra import (
    LONG_SURD,
    cost_key,
    decimal_number,
    from_sympy,
    vector,
)
from restitution.render.layout.answers import (
    display,
    display_named,
    display_point,
    display_set,
    display_vector,
)
from restitution.render.layout.builders import (
    bracketed,
    fraction,
    function,
    letter,
    negative,
    power,
    product,
    root,
    split_sign,
    total,
)
from restitution.render.layout.nodes import (
    LONGEST,
    ONE,
    SIGNS,
    ZERO_VECTOR,
    Bold,
    Brackets,
    Coordinates,
    Degrees,
    Fraction,
    Function,
    Layout,
    Letter,
    Number,
    Percent,
    Phrase,
    Power,
    Product,
    Relation,
    Root,
    Sum,
    Words,
)
from restitution.render.layout.ranges import from_set
from restitution.render.layout.sides import as_layout, equation, relation
from restitution.render.layout.statements import EventNames, from_tree

__all__ = [
    "LONGEST",
    "LONG_SURD",
    "ONE",
    "SIGNS",
    "ZERO_VECTOR",
    "Bold",
    "Brackets",
    "Coordinates",
    "Degrees",
    "EventNames",
    "Fraction",
    "Function",
    "Layout",
    "Letter",
    "Number",
    "Percent",
    "Phrase",
    "Power",
    "Product",
    "Relation",
    "Root",
    "Sum",
    "Words",
    "as_layout",
    "bracketed",
    "cost_key",
    "decimal_number",
    "display",
    "display_named",
    "display_point",
    "display_set",
    "display_vector",
    "equation",
    "fraction",
    "from_set",
    "from_sympy",
    "from_tree",
    "function",
    "letter",
    "negative",
    "power",
    "product",
    "relation",
    "root",
    "split_sign",
    "total",
    "vector",
]
