"""The words before lines of angles: how a body turns, and by which identity."""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.data.paths_and_lines import degrees_of, turn_of_line
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Event,
    Fact,
    Line,
    Link,
    Meaning,
    Relation,
    equality,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    Unit,
    is_binary,
    is_quantity,
    is_zero,
    walk,
)
from restitution.render import layout as lay
from restitution.workings.leads.lines_around import LinesAround
from restitution.workings.naming.angles_by_signs import signs_behind
from restitution.workings.reasons.pythagoras import pythagoras

BY = {
    "pythagoras": "derived.pythagoras",
    "double-angle": "derived.double-angle",
    "half-angle": "derived.half-angle",
    "sum-of-angles": "derived.sum-of-angles",
    "complement": "derived.complement",
}
# How an angle is made of two to the line of centres, and what is said of it.
_TANGENTS = {"sum": "derived.tangent-of-sum", "difference": "derived.tangent-of-difference"}
_TURNED = {
    "difference": "turned.on",
    "rest-of-sum": "turned.back",
    "straight": "turned.straight",
}
_OR_ACROSS = {"difference": "turned.on-or-across", "rest-of-sum": "turned.back-or-across"}
# The same by the sign of the component after the impact.
_TURNED_AS = {"difference": "turned.on-as", "rest-of-sum": "turned.back-by"}
_OR_ACROSS_AS = {
    "difference": "turned.on-or-across-as",
    "rest-of-sum": "turned.back-or-across-by",
}
_BESIDE = {
    "square": "between.beside-same",
    "square-and-more": "between.beside-opposite",
}
_BETWEEN = {
    "sum": "between.opposite-sides",
    "difference": "between.one-side",
    "rest-of-sum": "between.opposite-senses",
    "rest-of-difference": "between.both-opposite",
    "square": "between.square-same",
    "square-and-more": "between.square-opposite",
    "straight": "between.right",
}

# Two that both move along the line of centres, by the angle between them.
_ALONG_BOTH: dict[Expression, SentenceId] = {
    Degrees(Fraction(0)): "between.along-same",
    STRAIGHT_ANGLE: "between.along-opposite",
}

_ALONG_BOTH_AS: dict[Expression, SentenceId] = {
    Degrees(Fraction(0)): "between.along-same-as",
    STRAIGHT_ANGLE: "between.along-opposite-as",
}

# On which side of a wall, as it is given, a body leaves it: by the sign before its angle to it.
_SIDES_OF_WALLS: dict[str, SentenceId] = {
    "+": "from-wall.anticlockwise",
    "-": "from-wall.clockwise",
}


def _is_of_the_rest(base: Line | Fact, line: Line) -> bool:
    """Whether the double angle is only that of a tangent of what is left of a right angle.

    From tan(90° − 2α) comes 1/tan 2α.
    """
    if not isinstance(base.relation, Relation) or not isinstance(line.relation, Relation):
        return False
    before, after = (
        {
            node
            for tree in trees_of(statement.relation)
            for node in walk(tree)
            if isinstance(node, Apply)
        }
        for statement in (base, line)
    )
    rests = {
        node.argument.right
        for node in before
        if isinstance(node.argument, Binary)
        and (node.argument.op, node.argument.left) == ("-", RIGHT_ANGLE)
    }
    return (
        bool(rests)
        and {
            node.argument
            for node in after
            if node.argument not in {function.argument for function in before}
        }
        <= rests
    )


def _has_threefold(statement: Line | Fact) -> bool:
    """Whether a line has a ratio of three times an angle, or of a third of one."""
    if not isinstance(statement.relation, Relation):
        return False
    three = Number(Fraction(3))
    arguments = (
        node.argument
        for tree in trees_of(statement.relation)
        for node in walk(tree)
        if isinstance(node, Apply)
    )
    return any(isinstance(x, Binary) and three in (x.left, x.right) for x in arguments)


_OF_A_PRODUCT = {
    "<": "turned.obtuse",
    ">": "turned.acute",
    "<=": "turned.not-acute",
    ">=": "turned.not-obtuse",
}
_OF_A_COMPONENT = {
    "<": "turned.negative",
    ">": "turned.positive",
    "<=": "turned.not-positive",
    ">=": "turned.not-negative",
}


class TurnLeads(LinesAround):
    """The words before angles of deflection, angles that are the same, and identities."""

    def _by_signs(self, line: Line) -> Sentence | None:
        """The signs of components, or of a scalar product, by which right angles bound an angle."""
        signs = signs_behind(self._derivation, line)
        if not signs:
            return None
        (first, order), *_ = signs
        if first.kind == "dot":
            return say(_OF_A_PRODUCT[order])
        components = tuple(
            say(
                _OF_A_COMPONENT[sign],
                axis=self._naming.layout(component.arguments[1]),
            )
            for component, sign in sorted(signs, key=lambda own: repr(own[0].arguments[1]))
        )
        velocity = self._naming.layout(first.arguments[0])
        return say("turned.signs", velocity=velocity, components=components)

    def _identity(self, line: Line) -> str:
        """The name of an identity: of a tangent that of a sum, or of a difference."""
        name = BY[line.move.record or ""]
        named = self._angles_given(line) or self._angles_named(line)
        base = next(filter(None, map(self._cited, line.premises)), named)
        if line.move.record == "double-angle" and base is not None:
            if _is_of_the_rest(base, line):
                return BY["complement"]
            if _has_threefold(base) or _has_threefold(line):
                return "derived.multiple-angle"
            return _of_a_sum(base) or name
        if line.move.record != "sum-of-angles":
            return name
        assert isinstance(line.relation, Relation)
        link = line.relation.options[0][0]
        base = line if base is None else base
        nodes = (*walk(link.left), *walk(link.right))
        ratios = {e.function for e in nodes if isinstance(e, Apply)} - {"sqrt"}
        if not ratios <= {"tan", "cot"} or "tan" not in ratios:
            return _of_differences(base, name)
        sides: tuple[Expression, ...]
        if isinstance(link.left, Apply) and is_binary(link.left.argument, "+", "-"):
            sides = (link.left,)
        elif isinstance(base.relation, Relation):
            whole = base.relation.options[0][0]
            sides = (whole.right, whole.left)
        else:
            sides = (base.relation.quantity,)
        for side in sides:
            side = side.argument if isinstance(side, Apply) else side
            form = _form_of(side) if is_binary(side, "+", "-") else ""
            if form in _TANGENTS:
                return _TANGENTS[form]
        return name

    def _by_the_half(self, line: Line) -> Sentence | None:
        """The formula by which sine and cosine of an angle make the tangent of its half."""
        base = next(filter(None, map(self._cited, line.premises)), None)
        if line.move.record != "half-angle" or base is None or isinstance(base.relation, Meaning):
            return None
        assert isinstance(line.relation, Relation)
        match line.relation.only[0].left:
            case Apply("tan", Binary("/", Letter() as whole, _)) as half:
                pass
            case _:
                return self._by_its_half(line, base)
        sine, cosine = Apply("sin", whole), Apply("cos", whole)
        if not {sine, cosine} <= {node for side in trees_of(base.relation) for node in walk(side)}:
            return None
        right = Binary("/", sine, Binary("+", Number(Fraction(1)), cosine))
        formula = self._naming.relation(equality(half, right))
        return say("derived.by-formula", formula=formula)

    def _by_its_half(self, line: Line, base: Line) -> Sentence | None:
        """The formula for the tangent of an angle by the letter for that of its half."""
        assert isinstance(base.relation, Relation)
        sides = (base.relation.only[0].left, base.relation.only[-1].right)
        nodes = {node for side in sides for node in walk(side) if isinstance(node, Apply)}
        for cited in map(self._cited, line.premises):
            let = None if cited is None else cited.relation
            if isinstance(let, Meaning) and isinstance(let.quantity, Apply):
                wholes = [node for node in nodes - {let.quantity} if node.function != "sqrt"]
                if [node.function for node in wholes] != ["tan"]:
                    return None
                one, two = (Number(Fraction(n)) for n in (1, 2))
                t = Letter(let.letter)
                below = Binary("-", one, Binary("^", t, two))
                link = Link(wholes[0], "=", Binary("/", Binary("*", two, t), below))
                formula = self._naming.relation(Relation(((link,),)))
                return say("derived.by-formula", formula=formula)
        return None

    def _by_squares(self, line: Line) -> Sentence | None:
        """The identity of sine and cosine, for the one angle to which it is applied."""
        own = pythagoras(self._derivation, line) if line.move.record == "pythagoras" else None
        return None if own is None else say("derived.as", reasons=(self._naming.relation(own),))

    def _angles_given(self, line: Line) -> Fact | None:
        """The given sum or difference of angles of which a line is the tangent."""
        for fact in self._derivation.facts_in(line.premises):
            if fact.kind == "given" and len(fact.relation.options) == 1:
                match fact.relation.only:
                    case (Link(Binary("+" | "-"), "=") | Link(_, "=", Binary("+" | "-")),):
                        return fact
                    case (Link(Apply("tan", Binary("+" | "-")), "="),):
                        return fact
                    case (Link(left, "=", right),) if line.move.record == "double-angle":
                        if isinstance(left, Binary) or isinstance(right, Binary):
                            return fact
        return None

    def _angles_named(self, line: Line) -> Fact | None:
        """The sum or difference of angles that the statement calls by a letter."""
        for ref in line.premises:
            fact = self._derivation.fact(ref)
            if fact is not None and fact.id.partition(" ")[0] == "let":
                match fact.relation.only:
                    case (Link(Binary("+" | "-"), "="),):
                        return fact
        return None

    def _turned(self, line: Line) -> Sentence | None:
        """How an angle is made of two others; None of a line that makes none."""
        if line.move.record == "tan-from-axis":
            return self._came_along(line)
        event = self._naming.events.get(line.move.event or 0)
        if line.move.record not in ("sum", "difference") or event is None:
            return None
        assert isinstance(line.relation, Relation)
        first = line.relation.options[0][0]
        if is_quantity(first.left, "energy_lost"):
            return None
        body = line.move.bodies[0]
        if self._by_directions(line):
            # From i the direction after is the angle itself, whatever that is a sum of.
            is_angle = self._sense_before(line) == Unit("i") or not isinstance(first.right, Binary)
            came = self._came_along(line) if is_angle else None
            return came or say("turned.directions", body=body)
        same = self._same(first)
        if same is not None:
            return same
        if event.wall:
            to_a_wall = self._to_a_wall(line, first.left, event)
            if to_a_wall is not None:
                return to_a_wall
            name = "turned-wall.sum"
            if line.move.record == "difference":
                straight = first.right == STRAIGHT_ANGLE
                name = "turned-wall.straight" if straight else "turned-wall.along"
                rebounds = self._given_to_rebound(event.number) if straight else None
                if rebounds is not None:
                    slots = {"body": body, "wall": event.bodies[1], "bound": rebounds}
                    return say("turned-wall.straight-as", **slots)
            return say(name, body=body, wall=event.bodies[1])
        cited = self._derivation.lines_in(line.premises)
        named = [line.relation for line in cited if isinstance(line.relation, Meaning)]
        for node in (*walk(first.left), *walk(first.right)):
            if isinstance(node, Letter) and node.name in self._naming.meanings:
                named.append(self._naming.meanings[node.name])
        for meaning in named:
            match meaning.quantity:
                case Quantity("angle", (Quantity("velocity"), Unit() as axis)):
                    return self._pushed(line, axis)
        form = self._form_of(first)
        alone = len(line.move.bodies) == 1
        if not alone:
            standing = self._standing(line)
            still, mover = standing.get("along"), standing.get("across")
            if form == "straight" and first.right in _ALONG_BOTH:
                signs = (self._sign_after(line, body) for body in line.move.bodies)
                reasons = tuple(sign for sign in signs if sign is not None)
                if reasons:
                    name = _ALONG_BOTH_AS[first.right]
                    return say(name, bodies=line.move.bodies, reasons=reasons)
                return say(_ALONG_BOTH[first.right], bodies=line.move.bodies)
            if still is not None and form in _BESIDE:
                (other,) = (body for body in line.move.bodies if body != still)
                return say(_BESIDE[form], one=still, other=other)
            if form == "straight" and still and mover and still != mover:
                return say("between.right-of", one=mover, other=still)
            one = self._on_the_line(line)
            if one is not None and not isinstance(first.right, Binary | Degrees):
                rested = self.tells_of_rest(one, line.move.event or 0, line)
                return say(
                    "derived.along-centres-from-rest" if rested else "between.line", body=one
                )
            match first.right:
                case Binary("-", left, _) if one is not None and left == STRAIGHT_ANGLE:
                    (other,) = (body for body in line.move.bodies if body != one)
                    return say("between.line-back", one=one, other=other)
            return say(_BETWEEN[form], bodies=line.move.bodies)
        sign = self._sign_after(line, body)
        if form in _OR_ACROSS and (at := self._reasons.right_angle_among(line)) is not None:
            where = self._naming.relation(at)
            if sign is not None:
                return say(_OR_ACROSS_AS[form], body=body, at=where, reason=sign)
            return say(_OR_ACROSS[form], body=body, at=where)
        if form == "square":
            name = "turned.square" if self._ends_square(line) else "turned.from-square"
            return say(name, body=body)
        turn = self._turn_too_wide(line, first) if form == "rest-of-sum" else None
        if turn is not None:
            return say("turned.back-as", body=body, turn=self._naming.layout(turn))
        if sign is not None and form in _TURNED_AS:
            return say(_TURNED_AS[form], body=body, reason=sign)
        if form == "straight" and first.right == Degrees(Fraction(0)):
            return say("turned.straight-on", body=body)
        return say(_TURNED[form], body=body) if form in _TURNED else None

    def _sign_after(self, line: Line, body: str) -> Sentence | lay.Layout | None:
        """The sign of the component of a body along the line of centres, by the line that has it.

        It is said by which bound it is so. None where no line above has it.
        """
        event = line.move.event or 0
        for own in reversed(self._derivation.lines):
            if own.number >= line.number or not isinstance(own.relation, Relation):
                continue
            first, value = own.relation.options[0][0], own.relation.options[0][-1].right
            if len(own.relation.options) > 1 or not self._is_along(first.left, body, event):
                continue
            known = self._reasons.sign_of(value, line)
            if known is None:
                continue
            zero = Number(Fraction(0))
            sign = self._naming.relation(Relation(((Link(first.left, known[0], zero),),)))
            if known[1] is None:
                return sign
            return say("turned.sign", sign=sign, bound=self._naming.relation(known[1]))
        return None

    def _is_along(self, tree: Expression, body: str, event: int) -> bool:
        """Whether a quantity, or its letter, is a component along the line of centres after it."""
        if isinstance(tree, Letter) and tree.name in self._naming.meanings:
            tree = self._naming.meanings[tree.name].quantity
        match tree:
            case Quantity("along", (Quantity("velocity", (Name(name),), int(stage)), axis)):
                own = self._naming.event_of_axis(axis)
                return (name, stage) == (body, event) and own is not None and own.number == event
        return False

    def _to_a_wall(self, line: Line, angle: Expression, event: Event) -> Sentence | None:
        """How the angle of a path to a wall after an impact is known, by another such angle.

        None where it is by the deflection that is given, not by e = 1.
        """
        match angle:
            case Quantity("angle", (Quantity("velocity"), Name(wall))):
                pass
            case Quantity("direction"):
                return self._from_a_wall(line, *event.bodies)
            case _:
                return None
        body, own = event.bodies
        if wall == own:
            kept = f"e {event.number}" in line.premises
            return say("kept.angle", body=body, wall=own) if kept else None
        between = self._between_walls(line, own, wall)
        if between is None:
            return say("next-wall.angle", next=wall, wall=own)
        names = {"next": wall, "wall": own, "angle": self._corner(own, wall, between)}
        if any(STRAIGHT_ANGLE in walk(tree) for tree in trees_of(line.relation)):
            return say("next-wall.corner", **names)
        assert isinstance(line.relation, Relation)
        # Of the angles that three lines make with each other the sum of two is an exterior angle.
        match line.relation.only[0].right:
            case Binary("+"):
                return say("next-wall.exterior", **names)
            case Binary("-", _, Degrees()):
                return say("next-wall.exterior-before", **names)
        return say("next-wall.between", **names)

    def _corner(self, one: str, other: str, between: Expression) -> lay.Layout:
        """The angle at which two walls meet, as it comes of those that are told from **i**."""
        layout = self._naming.layout(between)
        turns = (self._turn_of_wall(one), self._turn_of_wall(other))
        match sorted(e.value for e in turns if isinstance(e, Degrees)), between:
            case [less, more], Degrees(angle) if angle != RIGHT_ANGLE.value:
                gap: Expression = Degrees(more)
                if less:
                    gap = Binary("-", gap, Degrees(less))
                tree = gap if angle == more - less else Binary("-", STRAIGHT_ANGLE, gap)
                if tree != between and degrees_of(tree) == angle:
                    return lay.Relation((self._naming.layout(tree), layout), ("=",))
        return layout

    def _from_a_wall(self, line: Line, body: str, wall: str) -> Sentence | None:
        """At which angle the wall is from which a direction is worked out; None without one."""
        turn = self._turn_of_wall(wall)
        if turn is None:
            return None
        slots = {"angle": self._naming.layout(turn), "axis": self._naming.layout(Unit("i"))}
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0].right:
            case Binary("+" | "-" as sign, own, _) if own == turn:
                return say(_SIDES_OF_WALLS[sign], wall=wall, body=body, **slots)
        if any(turn in walk(tree) for tree in trees_of(line.relation)):
            return say("from-wall.direction", wall=wall, **slots)
        return say("from-wall.direction-back", wall=wall, body=body, **slots)

    def _turn_of_wall(self, name: str) -> Expression | None:
        """The angle from **i** at which a wall is, where that is told."""
        wall = self._derivation.fact(f"wall {name}")
        match None if wall is None else wall.relation.only[-1].right:
            case Unit(axis):
                return RIGHT_ANGLE if axis == "j" else Degrees(Fraction(0))
        return turn_of_line(wall)

    def _between_walls(self, line: Line, *walls: str) -> Degrees | None:
        """The angle at which two walls meet, or its rest of 180°, as a line has it."""
        here, there = map(self._turn_of_wall, walls)
        if not (isinstance(here, Degrees) and isinstance(there, Degrees)):
            return None
        turn = (here.value - there.value) % STRAIGHT_ANGLE.value
        nodes = [node for tree in trees_of(line.relation) for node in walk(tree)]
        ends = (Degrees(turn), Degrees(STRAIGHT_ANGLE.value - turn))
        return max((e for e in ends if e in nodes), key=lambda end: end.value, default=None)

    def kept_speed(self, line: Line, event: Event | None) -> Sentence | None:
        """That a body keeps its speed at a wall with e = 1; None of another line."""
        if line.move.record != "speed" or event is None or not event.wall:
            return None
        if f"e {event.number}" not in line.premises:
            return None
        body, wall = event.bodies
        return say("derived-speed.kept", body=body, wall=wall)

    def _pushed(self, line: Line, axis: Unit) -> Sentence:
        """That a body turns through the difference of its angles to **i** or **j**.

        With the impulse that turns it, where its velocity after the impact is still to come: then
        the line rests on the velocity of what it meets, and says the later angle by the earlier.
        """
        body, *others = line.move.bodies
        event = self._naming.events[line.move.event or 0]
        if others:
            axis_ = self._naming.layout(axis)
            return say("between.from", bodies=line.move.bodies, axis=axis_)
        names = {"body": body, "axis": self._naming.layout(axis)}
        met = {f"velocity {other}" for other in event.bodies if other != body}
        assert isinstance(line.relation, Relation)
        later = line.relation.options[0][0]
        if not isinstance(later.left, Letter) or met.isdisjoint(map(str, line.premises)):
            return say("turned.from", **names)
        if is_binary(later.right, "-"):
            return say("turned.pushed-towards", **names)
        return say("turned.pushed-away", back=self._naming.layout(Negate(axis)), **names)

    def _by_directions(self, line: Line) -> bool:
        """Whether a deflection is made of directions alone: one of the data, one that stands."""
        stands = False
        for ref in line.premises:
            own = self._derivation.line(ref)
            fact = self._derivation.fact(ref)
            match fact.relation if fact is not None else None if own is None else own.relation:
                case Relation(((Link(Quantity("direction"), "="), *_),)):
                    stands = True
                case Relation(((Link(Letter(name), "="), *_),)) if own is not None:
                    meaning = self._naming.meanings.get(name)
                    if meaning is None and own.move.id == "inverse":
                        continue  # the direction of the data, which is a letter
                    if meaning is None or _kind_of(meaning.quantity) != "direction":
                        return False
                    stands = True
                case Meaning() | Relation(((Link(Quantity("velocity"), "="), *_),)):
                    pass
                case _:
                    return False
        return stands

    def _turn_too_wide(self, line: Line, link: Link) -> Expression | None:
        """The given deflection, where a body that keeps its sense is turned through less."""
        for fact in self._derivation.facts_in(line.premises):
            match fact.relation.options[0][0]:
                case Link(Quantity("deflection"), "=", Degrees(value) as turn):
                    pass
                case _:
                    continue
            degrees = [e.value for e in walk(link.right) if isinstance(e, Degrees)]
            if sorted(degrees)[-1:] != [180] or value not in degrees or len(degrees) != 3:
                return None
            degrees.remove(value)
            first = min(degrees)
            return turn if value >= max(first, 90 - first) else None
        return None

    def _given_to_rebound(self, event: int) -> lay.Layout | None:
        """The given bound by which the coefficient of a wall, which is a letter, is not zero."""
        fact = self._derivation.fact(f"e {event}")
        letter = None if fact is None else fact.relation.only[0].right
        for range_fact in self._derivation.facts if isinstance(letter, Letter) else ():
            for link in range_fact.relation.options[0] if range_fact.kind == "range" else ():
                for own in (link, Link(link.right, FLIPPED.get(link.sign, link.sign), link.left)):
                    if own.left == letter and own.sign == ">" and is_zero(own.right):
                        return self._naming.relation(Relation(((own,),)))
        return None

    def _meant(self, letter: str) -> Expression | None:
        """What a letter of the working, or of the question, stands for."""
        meaning = self._naming.meanings.get(letter)
        if meaning is not None:
            return meaning.quantity
        fact = self._derivation.fact(f"let {letter}")
        return None if fact is None else fact.relation.only[0].left

    def _same(self, link: Link) -> Sentence | None:
        """That an angle to a wall, or to an axis, is the one from **i** that has a letter."""
        angles = [
            quantity
            for side in (link.left, link.right)
            for node in walk(side)
            if isinstance(node, Letter) and (quantity := self._meant(node.name)) is not None
        ]
        angles += [side for side in (link.left, link.right) if isinstance(side, Quantity)]
        match angles:
            case [
                Quantity("angle", (one, Quantity("line_of_centres"))),
                Quantity("angle", (other, Name(wall))),
            ] if one == other:
                return say("same.parallel", wall=wall)
            case [one, other] if "direction" in (_kind_of(one), _kind_of(other)):
                pass
            case _:
                return None
        walls = [
            side
            for angle in angles
            if is_quantity(angle, "angle")
            for side in angle.arguments
            if isinstance(side, Name)
        ]
        moving = [
            side
            for angle in angles
            for side in (angle.arguments if isinstance(angle, Quantity) else ())
            if isinstance(side, Quantity)
        ]
        if any(side.kind == "line_of_centres" for side in moving):
            velocity, axis = (self._naming.layout(e) for e in (moving[0], Unit("i")))
            return say("same.line", velocity=velocity, axis=axis)
        if not walls and moving:
            velocity, axis = (self._naming.layout(e) for e in (moving[0], Unit("j")))
            return say("same.angle", velocity=velocity, axis=axis)
        if not walls:
            return None
        return say("same.wall", wall=walls[0].name, axis=self._naming.layout(Unit("i")))

    def _form_of(self, link: Link) -> str:
        """How an angle is made of two to the line of centres, of which a line may give one."""
        if isinstance(link.left, Binary):
            return _form_of(link.left)
        meaning = (
            self._naming.meanings.get(link.left.name) if isinstance(link.left, Letter) else None
        )
        match None if meaning is None else meaning.quantity:
            case Quantity("angle", (Quantity("velocity"), Quantity("line_of_centres"))):
                form = _form_of(link.right)
                return "difference" if form == "sum" else form
        return _form_of(link.right)


def _sums_in(base: Line | Fact) -> set[tuple[str, str]]:
    """The functions of sums of angles in a line, each with the sign of its sum."""
    if not isinstance(base.relation, Relation):
        return set()
    return {
        (node.function, node.argument.op)
        for tree in trees_of(base.relation)
        for node in walk(tree)
        if isinstance(node, Apply) and isinstance(node.argument, Binary)
        if node.function in ("sin", "cos", "tan") and node.argument.op in ("+", "-")
    }


def _of_a_sum(base: Line | Fact) -> str | None:
    """The name of the identity by which a sum of angles in a line is opened; None without one."""
    sums = _sums_in(base)
    if len(sums) == 1 and (("tan", "+") in sums or ("tan", "-") in sums):
        ((_, sign),) = sums
        return _TANGENTS["sum" if sign == "+" else "difference"]
    return _of_differences(base, BY["sum-of-angles"]) if sums else None


def _of_differences(base: Line | Fact, name: str) -> str:
    """The name of the identity of a sum of angles; of a difference, where all in it are that."""
    signs = {sign for _, sign in _sums_in(base)}
    return "derived.difference-of-angles" if signs == {"-"} else name


def _kind_of(angle: Expression) -> str:
    return angle.kind if isinstance(angle, Quantity) else ""


def _form_of(angle: Expression) -> str:
    """The form in which an angle is written by others."""
    straight, right = STRAIGHT_ANGLE, RIGHT_ANGLE
    match angle:
        case Degrees():
            return "straight"
        case Binary("+" | "-" as sign, left, other) if right in (left, other):
            return "square" if sign == "-" else "square-and-more"
        case Binary("+", Binary("-", left, _), _) if left == straight:
            return "rest-of-difference"
        case Binary("+"):
            return "sum"
        case Binary("-", Binary("-", left, _), _) if left == straight:
            return "rest-of-sum"
    return "difference"
