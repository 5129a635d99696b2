"""Letters for components, the same in all parts, and what a statement already uses."""

from __future__ import annotations

from restitution.expression.tree import Letter, Name, Unit, is_quantity, walk
from restitution.problem import Find, Impact, Let, Part, Problem, Show, trees

# Letters for unknown components, in the order in which textbooks take them.
_COMPONENTS = ("v", "w", "x", "z", "q", "s", "f", "g", "h", "b", "c", "d", "l", "n", "y", "p")


def protected_letters(part: Part) -> frozenset[str]:
    """Letters that the answers of a part are to be written in."""
    names: set[str] = set()
    for step in part.steps:
        if isinstance(step, Find | Show) and step.in_terms_of:
            names |= set(step.in_terms_of)
    return frozenset(names)


def letters_in_use(problem: Problem) -> set[str]:
    """The letters that the problem uses, and those that could be taken for something else."""
    names = {"e", "i", "j"}
    for tree in trees(problem):
        for node in walk(tree):
            if isinstance(node, Letter):
                names.add(node.name.partition("_")[0])
    for _, step in problem.steps():
        if isinstance(step, Let):
            # Beside a speed V that is named a component v would be taken for that.
            names |= {step.letter, step.letter.lower()}
    return names


def allocated_letters(problem: Problem, taken: set[str]) -> dict[tuple[int, str], str]:
    """A letter for each component that an impact changes, the same in all parts."""
    spheres = {sphere.name for sphere in problem.spheres}
    given = _named_by_let(problem, spheres)
    impacts = [(n, event) for n, event in enumerate(problem.events, 1) if isinstance(event, Impact)]
    struck = [(n, tuple(b for b in (e.first, e.second) if b in spheres)) for n, e in impacts]
    of_spheres = [impact for impact in struck if len(impact[1]) > 1]
    pool = [c for c in _COMPONENTS if c not in taken]
    names: dict[tuple[int, str], str] = dict(given)
    if len(of_spheres) > 1:
        # The same two letters at every impact of two spheres, with its number among all impacts;
        # those that meet again have each its own, whichever of them strikes then.
        orders = {number: order for order, (number, _) in enumerate(impacts, 1)}
        first_time: dict[frozenset[str], tuple[str, ...]] = {}
        for number, bodies in of_spheres:
            pair = first_time.setdefault(frozenset(bodies), bodies)
            for letter, body in zip(pool[:2], pair, strict=False):
                names.setdefault((number, body), f"{letter}_{orders[number]}")
        del pool[:2]
    free = (c for c in pool if c not in names.values())
    for number, bodies in (*of_spheres, *(impact for impact in struck if len(impact[1]) < 2)):
        for body in bodies:
            if (number, body) not in names:
                plain = f"v_{number}" if len(bodies) == 1 else f"{body.lower()}_{number}"
                names[number, body] = next(free, plain)
    return names


def _named_by_let(problem: Problem, spheres: set[str]) -> dict[tuple[int, str], str]:
    """Components that the statement names itself: ``let v = along(velocity(A), i)``."""
    letters_by_component: dict[tuple[int, str], str] = {}
    latest: dict[str, tuple[int, Impact]] = {}
    for step, number, _ in problem.timeline():
        if isinstance(step, Impact):
            for body in (step.first, step.second):
                latest[body] = number, step
        elif isinstance(step, Let):
            tree = step.expression
            if not is_quantity(tree, "along"):
                continue
            inner, axis = tree.arguments
            if (
                is_quantity(inner, "velocity")
                and inner.stage is None
                and isinstance(inner.arguments[0], Name)
                and isinstance(axis, Unit)
                and inner.arguments[0].name in latest
            ):
                body = inner.arguments[0].name
                event, impact = latest[body]
                if impact.along == axis and (event, body) not in letters_by_component:
                    letters_by_component[event, body] = step.letter
    return letters_by_component
