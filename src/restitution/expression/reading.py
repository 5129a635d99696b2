"""Text to expression trees: the scanner, lark's LALR parser, and the building of the tree."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import field
from fractions import Fraction
from functools import cache
from typing import Any

from lark import Lark, Token, Tree, UnexpectedToken

from restitution.counting import listed
from restitution.errors import StatementError
from restitution.expression.grammar import EXPRESSION
from restitution.expression.lexer import Scan, scan, unit_refused
from restitution.expression.limits import MAX_DIGITS, MAX_LINE_LENGTH, MAX_TREE_DEPTH
from restitution.expression.measured import NOWHERE, Slot, product_with, without_units
from restitution.expression.parsers import make_parser
from restitution.expression.quantities import KINDS
from restitution.expression.source import Source
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Degrees,
    Expression,
    Letter,
    Measured,
    Name,
    Negate,
    Number,
    Pair,
    Pi,
    Place,
    Polar,
    Quantity,
    Stage,
    Unit,
    has_quantity,
    is_binary,
    letters,
)
from restitution.expression.words import (
    EVENT_WORDS,
    LINE_WORDS,
    MEANT,
    PROPERTY_WORDS,
    WORDS,
    guess,
    meant_name,
    near,
    unknown_name,
)
from restitution.expression.writing import write_expression
from restitution.mending import Fix, Note
from restitution.records import dataclass


@dataclass(frozen=True)
class Span:
    """Something read, with the first and the last token it was read from."""

    value: Any
    first: Token
    last: Token
    depth: int = 1

    @property
    def place(self) -> Place:
        """Where it begins."""
        return Place(self.first.line or 1, self.first.column or 1)


@dataclass(frozen=True)
class Reading:
    """One reading of a line: what was scanned, and the warnings met on the way.

    ``events`` have been told before it.
    """

    scan: Scan
    events: int = 0
    warnings: list[Note] = field(default_factory=list)

    def text(self, first: Token, last: Token) -> str:
        """The text from one token to another, as typed."""
        return self.scan.source.text[first.start_pos or 0 : last.end_pos or 0].strip()

    def fix(self, first: Token, last: Token, text: str, label: str = "") -> Fix:
        """The cure that puts a text in the place of the tokens from one to another."""
        return self.scan.source.fix(first.start_pos or 0, last.end_pos or 0, text, label)

    def error(self, message: str, place: Place, *fixes: Fix) -> StatementError:
        """A mistake at a place, and what would cure it."""
        mistake = StatementError(message, place.line, place.column)
        mistake.fixes = fixes
        return mistake


Builder = Callable[[Reading, Tree[Token], list[Span]], Any]


def read_expression(
    text: str,
    *,
    names: AbstractSet[str] | Mapping[str, str] = frozenset(),
    line: int = 1,
    column: int = 1,
) -> Expression:
    """The expression that a text says.

    ``names`` are the declared spheres, walls and points (or a mapping of each to ``"sphere"``,
    ``"wall"`` or ``"point"``); ``line`` and ``column`` say where the text begins, for messages.
    Raises StatementError, with line and column, where the text is not an expression.

    >>> read_expression("1/2u") == read_expression("(1/2) * u")
    True
    """
    kinds = names if isinstance(names, Mapping) else dict.fromkeys(names, "body")
    if len(text) > MAX_LINE_LENGTH:
        raise StatementError(
            f"the text is too long: at most {MAX_LINE_LENGTH} characters", line, column
        )
    source = Source(text, ((0, line, column),))
    reading = Reading(scan(source, kinds))
    span = parse_tokens(expression_parser(), reading, BUILDERS)
    return without_units(span.value, NOWHERE, _no_unit, {})


def read_number(text: str) -> Expression:
    """The number that a text in SymPy's syntax says, with its powers and inverse functions.

    >>> read_number("atan(1/2)**2") == read_expression("arctan(1/2)^2")
    True
    """
    own = re.sub(r"\ba(?=(?:sin|cos|tan)\()", "arc", text)
    return read_expression(own.replace("**", "^"))


def _no_unit(measured: Measured, slot: Slot) -> Expression:
    """A unit of one letter as the letter that it is where nothing tells what is measured."""
    if len(measured.unit) > 1:
        _, _, line, end = measured.stretch
        raise StatementError(unit_refused(measured.unit), line, end - len(measured.unit))
    return product_with(measured.operand, Letter(measured.unit, place=measured.place))


@cache
def expression_parser() -> Lark:
    """The parser of expressions, made at first use."""
    return make_parser(EXPRESSION, "expression")


def parse_tokens(parser: Lark, reading: Reading, builders: Mapping[str, Builder]) -> Span:
    """What a line of tokens says. Raises StatementError with what was expected where."""
    mistake: StatementError | None = None
    try:
        tree: Any = parser.parse(reading.scan.tokens)
    except UnexpectedToken as error:
        mistake = _explain(reading, error)
    if mistake is not None:
        # Raised here it holds nothing of the parser, and goes from process to process.
        raise mistake
    return _fold(reading, tree, builders)


def _fold(reading: Reading, tree: Any, builders: Mapping[str, Builder]) -> Span:
    """Builds the value of each node from those below it; a loop, for trees may be deep."""
    done: list[Span] = []
    pending: list[tuple[Any, bool]] = [(tree, False)]
    while pending:
        node, ready = pending.pop()
        if isinstance(node, Token):
            done.append(Span(_leaf(reading, node), node, node))
        elif not ready:
            pending.append((node, True))
            pending.extend((child, False) for child in reversed(node.children))
        else:
            count = len(node.children)
            spans = done[len(done) - count :]
            del done[len(done) - count :]
            depth = 1 + max(span.depth for span in spans)
            if depth > MAX_TREE_DEPTH:
                raise reading.error(
                    "the expression is too long or nested too deeply: at most "
                    f"{MAX_TREE_DEPTH} operations one upon another",
                    spans[0].place,
                )
            value = builders[node.data](reading, node, spans)
            done.append(Span(value, spans[0].first, spans[-1].last, depth))
    return done[0]


def _leaf(reading: Reading, token: Token) -> Any:
    """The value of a token: an expression where it is one, else the token itself."""
    place = Place(token.line or 1, token.column or 1)
    text = str(token)
    match token.type:
        case "NUMBER" | "COEFFICIENT":
            if text.endswith("%"):
                return Number(Fraction(text[:-1]) / 100, place=place)
            return Number(Fraction(text), place=place)
        case "DEGREES":
            return Degrees(Fraction(text), place=place)
        case "FRACTION":
            above, below = (Number(Fraction(part), place=place) for part in text.split("/"))
            return Binary("/", above, below, place=place)
        case "PI":
            return Pi(place=place)
        case "LETTER":
            return Letter(text, place=place)
        case "UNIT":
            return Unit("i" if text == "i" else "j", place=place)
        case "NAME":
            return Name(text, place=place)
        case "QUANTITY":
            if not KINDS[text].stands_alone:
                raise StatementError(
                    f"'{text}' needs brackets: {KINDS[text].usage}", place.line, place.column
                )
            return _written_out(reading, Quantity(text, place=place))
    return token


# --- building ---------------------------------------------------------------------------------


def _binary(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    left, sign, right = spans
    signs: dict[str, Any] = {"PLUS": "+", "MINUS": "-", "STAR": "*", "SLASH": "/", "POW": "^"}
    return Binary(signs[sign.value.type], left.value, right.value, place=left.place)


def _quotient(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    """A quotient; of two numbers with a degree sign behind them, it is one angle: ``90/2°``."""
    above, below = node.children[0], node.children[2]
    left, right = spans[0], spans[2]
    if isinstance(right.value, Number | Degrees) and right.value.value == 0:
        raise reading.error("division by zero", right.place)
    degrees = _first_degrees(below)
    if degrees is None:
        return _binary(reading, node, spans)
    if isinstance(above, Token) and _is_a_count(above) and below is degrees:
        value = left.value.value / right.value.value
        if max(len(str(value.numerator)), len(str(value.denominator))) > MAX_DIGITS:
            raise reading.error(f"a number has at most {MAX_DIGITS} digits", left.place)
        return Degrees(value, place=left.place)
    over, under = reading.text(left.first, left.last), reading.text(right.first, right.last)
    raise reading.error(
        f"'{over}/{under}' can be misunderstood: to divide by the angle, write {over}/({under}); "
        "only a number over a number of degrees, such as 90/2°, is one angle",
        left.place,
    )


def _is_a_count(token: Token) -> bool:
    return token.type == "NUMBER" and not token.endswith("%")


def _first_degrees(node: Any) -> Token | None:
    """The number of degrees with which a factor begins, signs apart, outside brackets."""
    while isinstance(node, Tree) and node.data in ("negate", "positive", "binary"):
        node = node.children[0] if node.data == "binary" else node.children[1]
    return node if isinstance(node, Token) and node.type == "DEGREES" else None


def _implicit(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    left, gap, right = spans
    product = Binary("*", left.value, right.value, place=left.place)
    below = node.children[0]
    if (
        isinstance(below, Tree)
        and below.data == "quotient"
        and gap.value == ""
        and isinstance(left.value, Binary)
        and letters(left.value) | _quantities(left.value)
    ):
        typed = reading.text(left.first, right.last)
        quotient = left.value
        other = Binary("/", quotient.left, Binary("*", quotient.right, right.value))
        message = (
            f"'{typed}' was read as ({write_expression(quotient)}) {_bracketed(right.value)}; "
            f"if you mean all of it below the line, write {write_expression(other)}"
        )
        fix = reading.fix(left.first, right.last, write_expression(other))
        reading.warnings.append(Note(message, left.place.line, left.place.column, (fix,)))
    bare = node.children[2]
    if (
        isinstance(below, Tree)
        and below.data == "bare"
        and below.children[0] != "√"
        and isinstance(below.children[1], Token)
        and below.children[1].type == "NUMBER"
        and isinstance(bare, Tree)
        and bare.data == "group"
    ):
        message = (
            f"'{reading.text(left.first, right.last)}' was read as "
            f"{write_expression(product)}; a function without brackets takes one factor"
        )
        reading.warnings.append(Note(message, left.place.line, left.place.column))
    return product


def _bracketed(tree: Expression) -> str:
    text = write_expression(tree)
    return f"({text})" if is_binary(tree, "+", "-") else text


def _quantities(tree: Expression) -> frozenset[str]:
    return frozenset(("quantity",)) if has_quantity(tree) else frozenset()


def _negate(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    return Negate(spans[1].value, place=spans[0].place)


def _second(reading: Reading, node: Tree[Token], spans: list[Span]) -> Any:
    return spans[1].value


def _pair(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    return Pair(spans[1].value, spans[3].value, place=spans[0].place)


def _apply(reading: Reading, token: Token, argument: Expression) -> Expression:
    place = Place(token.line or 1, token.column or 1)
    function, _, power = str(token).partition("^")
    applied = Apply("sqrt" if function == "√" else function, argument, place=place)
    if not power:
        return applied
    return Binary("^", applied, Number(Fraction(power), place=place), place=place)


def _call(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    return _apply(reading, spans[0].value, spans[2].value)


def _bare(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    return _apply(reading, spans[0].value, spans[1].value)


def _multiple(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    number, symbol = spans[0], spans[1].value
    if len(spans) == 4:
        symbol = Binary("^", symbol, spans[3].value, place=spans[1].place)
    return Binary("*", number.value, symbol, place=number.place)


def _polar(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    size, angle = spans[0], spans[2]
    if isinstance(angle.value, Pair):
        begin, end = size.last.end_pos or 0, spans[1].first.start_pos or 0
        raise reading.error(
            "expected an angle after 'at' (a place, at (x, y), stands after a comma)",
            angle.place,
            reading.scan.source.fix(begin, end, ", ", "Put in ','"),
        )
    origin = wall = None
    if len(spans) == 5:
        if spans[3].value.type == "FROM":
            origin = spans[4].value
        else:
            wall = spans[4].value
    return Polar(size.value, angle.value, origin, wall, place=size.place)


def _before(reading: Reading, node: Tree[Token], spans: list[Span]) -> str:
    return "before"


def _at_time(reading: Reading, node: Tree[Token], spans: list[Span]) -> AtTime:
    return AtTime(spans[1].value)


def _quantity(reading: Reading, node: Tree[Token], spans: list[Span]) -> Expression:
    kind = str(spans[0].value)
    record = KINDS[kind]
    place = spans[0].place
    given = spans[2:-1:2]
    last = given[-1].value
    stage: Stage = None
    if last == "before" or isinstance(last, AtTime):
        stage = last
        given = given[:-1]
    elif (
        record.staged
        and isinstance(last, Number)
        and last.value.denominator == 1
        and "%" not in str(given[-1].last)
        and "." not in reading.text(given[-1].first, given[-1].last)
    ):
        if last.value > 10**6:
            raise reading.error("there is no such event", given[-1].place)
        stage = int(last.value)
        given = given[:-1]
    for span in given:
        if span.value == "before" or isinstance(span.value, AtTime):
            raise reading.error("a stage stands last, after what it is the stage of", span.place)
    fewest, most = record.arguments
    if not fewest <= len(given) <= most:
        raise reading.error(f"'{kind}' is written {record.usage}", place)
    if record.stage_needed and stage is None:
        raise reading.error(f"'{kind}' is written {record.usage}", place)
    if stage == "before" and not (record.before and given):
        raise reading.error(f"'{kind}' takes no 'before': it is written {record.usage}", place)
    if isinstance(stage, AtTime) and not record.at_time:
        raise reading.error(f"'{kind}' takes no time: it is written {record.usage}", place)
    arguments = tuple(span.value for span in given)
    return _written_out(reading, Quantity(kind, arguments, stage, place=place))


def _written_out(reading: Reading, quantity: Quantity) -> Expression:
    """A quantity, or what it is by its definition."""
    record, place = KINDS[quantity.kind], quantity.place or Place(1, 1)
    defined = record.written_out(quantity.arguments, quantity.stage, reading.events)
    if defined is None:
        return quantity
    if record.of_an_event and quantity.stage == 0:
        raise reading.error(f"events are numbered from 1: there is no {quantity.kind} at 0", place)
    if record.of_an_event and quantity.stage is None and not (quantity.arguments or reading.events):
        raise reading.error("no event is told before this line", place)
    return _at(defined, place)


def _at(tree: Expression, place: Place) -> Expression:
    """A tree that stands at a place; names have their own."""
    match tree:
        case Binary(op, left, right):
            return Binary(op, _at(left, place), _at(right, place), place=place)
        case Apply(function, argument):
            return Apply(function, _at(argument, place), place=place)
        case Negate(operand):
            return Negate(_at(operand, place), place=place)
        case Quantity(kind, arguments, stage) if tree.place is None:
            inner = tuple(_at(argument, place) for argument in arguments)
            return Quantity(kind, inner, stage, place=place)
    return tree


def _measured(reading: Reading, node: Tree[Token], spans: list[Span]) -> Any:
    value, unit = spans
    source = reading.scan.source
    begin, end = value.last.end_pos or 0, unit.last.end_pos or 0
    stretch = source.stretch(begin, end)
    return Measured(value.value, str(unit.value), stretch, place=value.place)


BUILDERS: Mapping[str, Builder] = {
    "measured": _measured,
    "binary": _binary,
    "quotient": _quotient,
    "implicit": _implicit,
    "negate": _negate,
    "positive": _second,
    "group": _second,
    "pair": _pair,
    "call": _call,
    "bare": _bare,
    "multiple": _multiple,
    "polar": _polar,
    "before": _before,
    "at_time": _at_time,
    "quantity": _quantity,
}


# --- what was expected ------------------------------------------------------------------------

_AFTER = {
    "SPHERE": "the name of a sphere: a capital, then letters or digits,",
    "WALL": "the name of a wall: a capital, then letters or digits,",
    "POINT": "the name of a point: a capital, then letters or digits,",
    "MASS": "a mass",
    "VELOCITY": "a vector",
    "ALONG": "a vector or an angle",
    "AT": "an angle or a point",
    "RADIUS": "a length",
    "OFFSET": "a length",
    "THROUGH": "a point",
    "FROM": "a point or a vector",
    "CIRCLE": "'centre'",
    "CENTRE": "a point",
    "HITS": "the name of a sphere or a wall",
    "RECEIVES": "an impulse, as a vector,",
    "REACHES": "a point or a wall",
    "LET": "a letter",
    "GIVEN": "a relation",
    "UNKNOWN": "a letter",
    "FIND": "what is to be found",
    "SHOW": "a relation",
    "IN_TERMS_OF": "a letter",
    "EQUAL": "a value",
    "ORDER": "a value",
    "ALIGN": "a direction",
    "AND": "the name of a sphere",
}

_NAMES_OF_TOKENS = {
    "RPAR": "')'",
    "COMMA": "','",
    "COLON": "':'",
    "EQUAL": "'='",
    "LETTER": "a letter",
    "NAME": "a declared name",
    "CENTRE": "'centre'",
    "OVER": "'over'",
    "TO": "'to'",
    "AGAIN": "'again'",
    "COLLIDE_AGAIN": "'collide again' or 'do not collide again'",
    "AND": "'and'",
    "HITS": "'hits'",
    "LPAR": "'('",
    "$END": "the end of the line",
}


def _explain(reading: Reading, error: UnexpectedToken) -> StatementError:
    """The mistake in a line: what was expected, what stands there, what was probably meant."""
    tokens = reading.scan.tokens
    token = error.token
    expected = set(error.accepts or error.expected)
    ended = token.type == "$END"
    index = len(tokens) if ended else next(k for k, other in enumerate(tokens) if other is token)
    # A product that was left out is no thing to point at: what follows it is.
    if token.type == "IMPLICIT":
        token = tokens[index + 1]
    previous = tokens[index - 1] if index else None
    if not expected:
        # The whole is read, and lark tells nothing of what might still follow.
        expected = {"$END"} if previous is None or previous.type == "FIGURES" else {"$END", "PLUS"}
    source = reading.scan.source
    if ended:
        end = (previous.end_pos or 0) if previous is not None else len(source.text)
        place = source.place(end)
    else:
        place = Place(token.line or 1, token.column or 1)
    typed = "" if ended else reading.text(token, token)
    run = None if ended else _run_at(reading, token)
    meant = _meant(reading, run or typed, token, previous, expected)
    if meant:
        message, instead = meant
        begin = _run_start(reading, token) if run else token.start_pos or 0
        end = begin + len(run) if run else token.end_pos or 0
        fixes = [source.fix(begin, end, instead)] if instead else []
        return reading.error(message, source.place(begin), *fixes)
    message = f"expected {_wanted(expected, previous)}"
    if previous is not None:
        message += f" after '{reading.text(previous, previous) or previous}'"
    if not ended:
        message += f", not '{typed}'"
    before = _run_at(reading, previous) if previous is not None else None
    for word in (run, before):
        if word:
            message += f" ('{word}' was read as {' '.join(word)})"
            break
    return reading.error(message, place)


def _run_at(reading: Reading, token: Token) -> str | None:
    for start, run in reading.scan.runs:
        if start <= (token.start_pos or 0) < start + len(run):
            return run
    return None


def _run_start(reading: Reading, token: Token) -> int:
    at = token.start_pos or 0
    for start, run in reading.scan.runs:
        if start <= at < start + len(run):
            return start
    return at


def _meant(
    reading: Reading, word: str, token: Token, previous: Token | None, expected: set[str]
) -> tuple[str, str | None] | None:
    """What to say where a word was probably meant to be another, and which."""
    if not word or not word.replace("_", "").isalnum() or not word[0].isalpha():
        return None
    names = reading.scan.names
    if previous is not None and previous.type in ("SPHERE", "WALL", "POINT"):
        return None
    if previous is None and word != word.lower() and word.lower() in LINE_WORDS:
        return f"unknown word '{word}': did you mean '{word.lower()}'?", word.lower()
    named = word[0].isupper() or word.capitalize() in names
    if token.type == "LETTER" and "NAME" in expected and named:
        return unknown_name(word, names), meant_name(word, names)
    if expected & {"MASS", "THROUGH", "OFFSET"} and "NUMBER" not in expected:
        meant = near(word, [word for word in PROPERTY_WORDS if word.upper() in expected])
        return _unknown(word, meant, "property")
    if previous is None and "FIND" in expected:
        meant = MEANT.get(word)
        if meant is None and word not in WORDS:
            meant = near(word, LINE_WORDS) or guess(word)
        return _unknown(word, meant) if meant and meant != word else None
    if token.type in ("WORD", "LETTER") and "HITS" in expected:
        meant = near(word, EVENT_WORDS)
        return _unknown(word, meant) if meant else None
    if token.type == "WORD" or (len(word) > 2 and word not in WORDS and token.type == "LETTER"):
        meant = guess(word) if len(word) > 2 else None
        if meant:
            return _unknown(word, meant)
    return None


def _unknown(word: str, meant: str | None, what: str = "word") -> tuple[str, str | None]:
    return f"unknown {what} '{word}'" + (f": did you mean '{meant}'?" if meant else ""), meant


def _wanted(expected: set[str], previous: Token | None) -> str:
    if previous is None and "FIND" in expected:
        return (
            "a line that begins with title, sphere, wall, point, let, given, unknown, find, "
            "show, part or the name of a sphere"
        )
    if "NUMBER" in expected:
        return _AFTER.get(previous.type, "a number, a letter or '('") if previous else "a value"
    if (
        previous is not None
        and previous.type in _AFTER
        and expected <= {"NAME", "LETTER", "CENTRE"}
    ):
        return _AFTER[previous.type]
    if expected & {"MASS", "THROUGH", "OFFSET"}:
        return "a property"
    named = [text for kind, text in _NAMES_OF_TOKENS.items() if kind in expected]
    if "ORDER" in expected and "$END" not in expected:
        named.insert(0, "a relation (=, <, perpendicular to, …)")
        named = [symbol for symbol in named if symbol != "'='"]
    elif "PLUS" in expected:
        named.insert(0, "an operator")
    return listed(named, "or") or "something else"
