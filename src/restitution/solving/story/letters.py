"""What each letter of a problem may be: a mass, a speed, an acute angle, a coefficient, …

A letter's range follows from the places where it stands, as the page on the statement language
says; a fact such as ``given k > 1`` narrows it, and one such as ``given v < 0`` overrules the
default that letters are positive.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from restitution.expression.evaluate import in_letters, letters_of_vector
from restitution.expression.quantities import KINDS, is_vector_quantity
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Pi,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    is_component,
    is_quantity,
    letters,
    name_of,
    walk,
)
from restitution.oracle.roles import (
    ACUTE,
    COEFFICIENT,
    DIRECTION,
    POSITIVE,
    REAL,
    TO_180,
    Role,
    of_two_angles,
)
from restitution.problem import (
    Aligned,
    Arrival,
    Compare,
    Find,
    Given,
    Impact,
    Let,
    Problem,
    Relation,
    Show,
    Step,
    Unknown,
    once_a_problem,
    trees,
    trees_of_step,
)

TRIGONOMETRIC = frozenset({"sin", "cos", "tan", "cot", "sec", "cosec"})


def roles(problem: Problem) -> dict[str, Role]:
    """The role of every letter of a problem, by its canonical name."""
    return dict(_roles(problem))


@once_a_problem
def _roles(problem: Problem) -> dict[str, Role]:
    names = {letter for tree in trees(problem) for letter in letters(tree)}
    for _, step in problem.steps():
        if isinstance(step, Let):
            names.add(step.letter)
        elif isinstance(step, Unknown):
            names.update(step.letters)
        elif isinstance(step, Find | Show) and step.in_terms_of:
            names.update(step.in_terms_of)
        elif isinstance(step, Impact) and step.e is None:
            names.add("e")
    data = _without_questions(problem)
    of_data = {letter for tree in trees(data) for letter in letters(tree)}
    by_data, by_all = _by_places(data), _by_places(problem)
    roles: dict[str, Role] = {}
    for name in sorted(names):
        role = by_data.get(name) or by_all.get(name, POSITIVE)
        if name in of_data and name not in by_data and role.kind != "angle":
            role = POSITIVE  # a question does not say which sign a letter of the data has
        roles[name] = role
    for _, step in problem.steps():
        match step:
            case Let(letter, Binary("+" | "-" as sign, Letter(one), Letter(other))):
                roles[letter] = of_two_angles(roles[one], sign, roles[other]) or roles[letter]
    return {name: _narrowed(role, name, problem, roles) for name, role in roles.items()}


def _without_questions(problem: Problem) -> Problem:
    """The data of a problem: all but what is asked and what is to be shown."""
    parts = (
        replace(part, steps=tuple(s for s in part.steps if not isinstance(s, Find | Show)))
        for part in problem.parts
    )
    return replace(problem, parts=tuple(parts))


def _by_places(problem: Problem) -> dict[str, Role]:
    """The roles of the letters that stand where something follows for them."""
    used, named = _angles(problem)
    coefficients = _coefficients(problem)
    positive, real = _components(problem)
    measured = _measured(problem)
    # What a letter is let be is measured, whatever is asked of it.
    used -= {step.letter for _, step in problem.steps() if isinstance(step, Let)} & measured.keys()
    return {
        **measured,
        **dict.fromkeys(real, REAL),
        **dict.fromkeys(positive, POSITIVE),
        **{name: measured.get(name, ACUTE) for name in named},
        **dict.fromkeys(used, ACUTE),
        **dict.fromkeys(coefficients, COEFFICIENT),
    }


def is_vector(tree: Expression, walls: frozenset[str] = frozenset()) -> bool:
    """Whether a tree is a vector, as far as its form tells."""
    match tree:
        case Unit() | Pair() | Polar() | Name():
            return True
        case Quantity(kind, arguments):
            if kind == "direction":
                return bool(arguments) and name_of(arguments[0]) in walls
            return is_vector_quantity(tree)
        case Negate(operand):
            return is_vector(operand, walls)
        case Binary(op, left, right):
            if op == "/":
                return is_vector(left, walls)
            return op != "^" and (is_vector(left, walls) or is_vector(right, walls))
    return False


# --- angles -----------------------------------------------------------------------------------


def _angles(problem: Problem) -> tuple[set[str], set[str]]:
    """Letters that are angles: used as directions or under a sine, and those that name one."""
    used: set[str] = set()
    walls = frozenset(wall.name for wall in problem.walls)

    def direction(tree: object) -> None:
        if isinstance(tree, Expression) and not is_vector(tree, walls):
            used.update(_linear_letters(tree))

    lets = {s.letter: s.expression for _, s in problem.steps() if isinstance(s, Let)}
    for tree in trees(problem):
        for node in walk(tree):
            if isinstance(node, Apply) and node.function in TRIGONOMETRIC:
                used.update(_linear_letters(node.argument))
            elif isinstance(node, Polar):
                used.update(_linear_letters(node.angle))
            elif is_component(node):
                direction(node.arguments[1] if len(node.arguments) > 1 else None)
            elif is_quantity(node, "angle"):
                for argument in node.arguments:
                    direction(argument)
    for wall in problem.walls:
        direction(wall.along)
    for _, step in problem.steps():
        if isinstance(step, Impact):
            direction(step.along)
        for relation in _relations(step):
            if isinstance(relation, Aligned):
                direction(relation.left)
                direction(relation.right)
    used = {name for name in used if name not in lets or not is_vector(lets[name], walls)}
    named: set[str] = set()
    while True:
        before = len(named)
        known = used | named
        for name, tree in lets.items():
            if is_angle(tree, known, walls):
                named.add(name)
        for _, step in problem.steps():
            for relation in _relations(step):
                if isinstance(relation, Compare) and any(
                    is_angle(tree, known, walls) for tree in relation.operands
                ):
                    for tree in relation.operands:
                        named.update(_linear_letters(tree))
        if len(named) == before:
            break
    return used, named


def _relations(step: Step) -> Iterator[Relation]:
    if isinstance(step, Given):
        yield from step.relations
    elif isinstance(step, Show) and step.subject is None:
        yield step.relation


def is_angle(tree: Expression, angles: set[str], walls: frozenset[str]) -> bool:
    """Whether a tree is a plain angle: not a ratio of sines, but what one takes the sine of."""
    match tree:
        case Degrees():
            return True
        case Letter(name):
            return name in angles
        case Quantity(kind, arguments):
            if kind == "direction":
                return not (arguments and name_of(arguments[0]) in walls)
            return kind in KINDS and KINDS[kind].nature == "angle"
        case Apply(function):
            return function.startswith("arc")
        case Negate(operand):
            return is_angle(operand, angles, walls)
        case Binary(op, left, right):
            if op in "+-":
                return is_angle(left, angles, walls) or is_angle(right, angles, walls)
            if op == "*":
                return is_angle(left, angles, walls) != is_angle(right, angles, walls)
            if op == "/":
                return is_angle(left, angles, walls) and not is_angle(right, angles, walls)
    return False


def _linear_letters(tree: Expression) -> set[str]:
    """The letters of a sum of angles: α and β in 2α + β − 90°."""
    match tree:
        case Letter(name):
            return {name}
        case Negate(operand):
            return _linear_letters(operand)
        case Binary(op, left, right) if op in "+-":
            return _linear_letters(left) | _linear_letters(right)
        case Binary("*", left, right):
            both = _linear_letters(left) | _linear_letters(right)
            greek = {name for name in both if len(name.split("_")[0]) > 1}
            return greek or (both if len(both) == 1 else set())
        case Binary("/", left, _):
            return _linear_letters(left)
    return set()


# --- other roles ------------------------------------------------------------------------------


def _coefficients(problem: Problem) -> set[str]:
    names = set()
    for _, step in problem.steps():
        if isinstance(step, Impact):
            if step.e is None:
                names.add("e")
            elif isinstance(step.e, Letter):
                names.add(step.e.name)
    return names


def _components(problem: Problem) -> tuple[set[str], set[str]]:
    """Letters in a positive role, and those that are a signed component or coordinate.

    A vector says which of the two a letter is where no vector before it does, in the order of
    `_introductions`: what follows from the data may then be written down without changing them.
    """
    sizes: set[str] = set()
    for values in (
        *((sphere.mass, sphere.radius) for sphere in problem.spheres),
        *((wall.radius,) for wall in problem.walls),
    ):
        for value in values:
            if isinstance(value, Expression):
                sizes.update(letters(value))
    for _, step in problem.steps():
        if isinstance(step, Impact) and step.e is not None and not isinstance(step.e, Letter):
            sizes.update(letters(step.e))
    introduced: set[str] = set()
    signed: set[str] = set()
    for introduction in _introductions(problem):
        positive, real = introduction
        sizes |= positive - introduced
        signed |= real - positive - introduced
        introduced |= positive | real
    return sizes, signed - sizes


def _introductions(problem: Problem) -> Iterator[tuple[set[str], set[str]]]:
    """Letters that are sizes, and those that are components, of all vectors that count alike.

    The velocities of the spheres come first, then where bodies are and what walls run along, and
    last the steps in their order.
    """
    yield _of_vectors(sphere.velocity for sphere in problem.spheres)
    positive, real = _of_vectors(wall.along for wall in problem.walls)
    for sphere in problem.spheres:
        _coordinates(sphere.position, positive, real)
    for wall in problem.walls:
        for place in (wall.through, wall.start, wall.end, wall.centre):
            if isinstance(place, Expression):
                positive.update(letters(place))
    for point in problem.points:
        positive.update(letters(point.position))
    yield positive, real
    for _, step in problem.steps():
        if isinstance(step, Arrival):
            positive, real = set[str](), set[str]()
            _coordinates(step.target, positive, real)
            yield positive, real
        else:
            yield _of_vectors(trees_of_step(step))


def _of_vectors(values: Iterable[object]) -> tuple[set[str], set[str]]:
    """The letters of vectors, and of vectors in what is no vector: sizes, and components."""
    positive: set[str] = set()
    real: set[str] = set()
    for tree in values:
        if not isinstance(tree, Expression):
            continue
        if is_vector(tree) and not has_quantity(tree):
            _vector_letters(tree, positive, real)
        for node in walk(tree):
            if isinstance(node, Pair) and node is not tree:
                _vector_letters(node, positive, real)
            elif isinstance(node, Polar):
                positive.update(letters(node.size))
    return positive, real


def _coordinates(place: object, positive: set[str], real: set[str]) -> None:
    """A coordinate of a sphere, where it is or gets to, may be any number.

    A letter of both coordinates, as in ``(a, 2a)``, measures lengths.
    """
    if isinstance(place, Pair):
        both = letters(place.x) & letters(place.y)
        for part in (place.x, place.y):
            (real if _lone(part) and not both else positive).update(letters(part))


def _vector_letters(tree: Expression, positive: set[str], real: set[str]) -> None:
    sizes, components = letters_of_vector(tree)
    positive |= sizes
    real |= components


def _lone(tree: Expression) -> bool:
    """Whether a tree is a letter, up to a number."""
    match tree:
        case Letter():
            return True
        case Negate(operand):
            return _lone(operand)
        case Binary("*", Number(), right):
            return _lone(right)
        case Binary("/", left, Number()):
            return _lone(left)
    return False


def _measured(problem: Problem) -> dict[str, Role]:
    """Letters that name a quantity have that quantity's range."""
    roles: dict[str, Role] = {}
    walls = frozenset(wall.name for wall in problem.walls)

    def name_it(letter: str, tree: Expression) -> None:
        if isinstance(tree, Negate):
            tree = tree.operand
        if not isinstance(tree, Quantity):
            return
        if tree.kind in ("along", "across", "dot"):
            role = REAL
        elif tree.kind == "direction":
            role = DIRECTION
        elif tree.kind == "deflection":
            role = TO_180
        elif tree.kind == "angle":
            sharp = any(
                name_of(argument) in walls or is_quantity(argument, "line_of_centres")
                for argument in tree.arguments
            )
            role = Role("angle", sp.Integer(0), sp.pi / 2, (True, True)) if sharp else TO_180
        else:
            role = POSITIVE
        old = roles.get(letter)
        if old is None or (old is REAL and role is not REAL):
            roles[letter] = role

    for _, step in problem.steps():
        if isinstance(step, Let):
            name_it(step.letter, step.expression)
        for relation in _relations(step):
            if isinstance(relation, Compare) and set(relation.operators) == {"="}:
                for one in relation.operands:
                    if isinstance(one, Letter):
                        for other in relation.operands:
                            name_it(one.name, other)
    return roles


def _narrowed(role: Role, name: str, problem: Problem, known: Mapping[str, Role]) -> Role:
    """A role with the bounds that the facts of the whole statement put on a letter."""
    for part, step in problem.steps():
        if not isinstance(step, Given) or part.label is not None:
            continue
        role = narrowed_by(role, name, step, known)
    return role


def narrowed_by(role: Role, name: str, step: Given, known: Mapping[str, Role]) -> Role:
    """A role with the numerical bounds of one line of facts.

    A bound below 0 in letters that are ``known`` to be positive lifts the default that a letter
    is positive, as one in numbers does: −u < w.
    """
    for relation in step.relations:
        if not isinstance(relation, Compare):
            continue
        if set(relation.operators) == {"="}:
            if role.kind == "positive" and _is_no_positive_number(name, relation):
                role = REAL
            continue
        for left, op, right in zip(
            relation.operands, relation.operators, relation.operands[1:], strict=False
        ):
            if op == "=":
                continue
            flipped = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}[op]
            for one, sign, other in ((left, op, right), (right, flipped, left)):
                if one != Letter(name):
                    continue
                if _constant(other):
                    role = _bounded(role, in_letters(other), sign)
                elif role.kind == "positive" and _is_negative(other, known):
                    role = replace(role, kind="real", low=None)
    return role


def _is_negative(tree: Expression, known: Mapping[str, Role]) -> bool:
    """Whether a bound is below 0 as its letters are positive, or coefficients: −u, −2r."""
    names = letters(tree)
    if not names or has_quantity(tree) or is_vector(tree) or not names <= known.keys():
        return False
    if any(known[name].kind not in ("positive", "restitution") for name in names):
        return False
    return bool(in_letters(tree, positive=True).is_negative)


def _is_no_positive_number(name: str, relation: Compare) -> bool:
    """Whether a fact equates a letter with a number that is not positive."""
    return Letter(name) in relation.operands and any(
        _constant(tree) and bool(in_letters(tree).is_nonpositive) for tree in relation.operands
    )


def _constant(tree: Expression) -> bool:
    return all(
        isinstance(node, Number | Degrees | Pi | Negate | Binary | Apply) for node in walk(tree)
    )


def _bounded(role: Role, bound: sp.Expr, op: str) -> Role:
    closed = op.endswith("=")
    if role.kind == "restitution":
        # A coefficient outside [0, 1] stays impossible, whatever is said of it.
        if op.startswith("<") and role.high is not None and bool(bound < role.high):
            return replace(role, high=bound, closed=(role.closed[0], closed))
        if op.startswith(">") and role.low is not None and bool(bound > role.low):
            return replace(role, low=bound, closed=(closed, role.closed[1]))
        return role
    if op.startswith("<"):
        role = replace(role, high=bound, closed=(role.closed[0], closed))
        if role.low is not None and bool(bound <= role.low):
            role = replace(role, low=None if role.kind != "angle" else -sp.pi)
    else:
        role = replace(role, low=bound, closed=(closed, role.closed[1]))
        if role.high is not None and bool(bound >= role.high):
            role = replace(role, high=None if role.kind != "angle" else sp.pi)
    return role
