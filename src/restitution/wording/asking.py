"""Items as noun phrases, those of one kind together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

from restitution.expression.quantities import dimension_of_any
from restitution.expression.tree import (
    Expression,
    Letter,
    Quantity,
    has_quantity,
    is_quantity,
    letters,
    name_of,
)
from restitution.problem import (
    Compare,
    Extremum,
    Find,
    Given,
    Impact,
    Item,
    Problem,
    Range,
    Show,
    Value,
)
from restitution.render import layout as lay
from restitution.wording import values
from restitution.wording.clauses import bounds, clause, to_figures
from restitution.wording.formulas import noun_phrase
from restitution.wording.formulas import plain as sayable
from restitution.wording.noun_phrases import Noun, kinds_of, of_bodies
from restitution.wording.nouns import line, phrase, share
from restitution.wording.scene import Scene
from restitution.wording.structure import Emphasis, Words
from restitution.wording.words import listed, words


class Group(NamedTuple):
    """Items that are told together, and how many they are: the speeds of A and B."""

    words: Words
    items: int = 1


def groups(scene: Scene, find: Find) -> list[Group]:
    """The items of a line, with those of one kind together."""
    plain = find.in_terms_of is not None
    nouns = [_item(scene, item, plain) for item in find.items]
    out: list[Group] = []
    while nouns:
        taken = _alike(nouns)
        out.append(Group(_together(nouns[:taken]), taken))
        nouns = nouns[taken:]
    return out


def names_of(scene: Scene, ask: Find | Show) -> list[Words]:
    """Each item of a line by itself: ``the speed of A``; what is to be shown as a clause."""
    if isinstance(ask, Show):
        return [_shown(scene, ask)]
    return [_together([_item(scene, item, True)]) for item in ask.items]


def in_terms(find: Find | Show) -> Words:
    """``in terms of u and e``, or nothing."""
    if not find.in_terms_of:
        return ()
    return words("in terms of ", listed([lay.letter(letter) for letter in find.in_terms_of]))


def shown(scene: Scene, show: Show) -> Words:
    """What is to be shown: ``show that P is at rest immediately after the impact``."""
    terms = words(", ", in_terms(show), ",") if show.in_terms_of else words()
    return words("show", terms, " that ", _shown(scene, show))


def _shown(scene: Scene, show: Show) -> Words:
    match show.subject, show.relation:
        case Extremum() as extreme, Compare((_, value), _, figures):
            dimension = dimension_of_any((extreme.expression,))
            greatest = values.value(scene.style, value, dimension)
            noun = _extreme(scene, extreme)
            return words(noun.head, " is ", greatest, to_figures(figures), _where(noun))
        case Range(subject), Compare() as chain if has_quantity(subject):
            limits = bounds(scene, chain, subject)
            only = words(" can have any value that is ", limits, ", and no other")
            named = noun_phrase(scene, subject)
            if named.where:
                return words(named.head, only, _where(named))
            return words(named.words(), only)
        case Range(subject), chain:
            noun = _range(scene, subject)
            return words(noun.words(), " is given by ", clause(scene, chain))
    return clause(scene, show.relation)


# --- items ----------------------------------------------------------------------------------------


def _item(scene: Scene, item: Item, plain: bool) -> Noun:
    match item:
        case Range(expression):
            noun = _range(scene, expression)
        case Extremum():
            corresponding = words(", and the corresponding value of ", phrase(scene, item.over))
            extreme = _extreme(scene, item)
            noun = replace(extreme, head=words(extreme.head, corresponding))
        case Value(expression):
            if item.percentage and sayable(scene, expression):
                shared = share(scene, expression)
                if shared is not None:
                    return shared
            noun = _value(scene, expression, plain)
    return _percentage(noun) if item.percentage else noun


def _percentage(noun: Noun) -> Noun:
    first = noun.head[0]
    if isinstance(first, str) and first.startswith("the fraction of "):
        return Noun(
            words("the percentage of ", first.removeprefix("the fraction of "), noun.head[1:]),
            noun.when,
        )
    if noun.where:
        return replace(noun, head=words(noun.head, " as a percentage"))
    return Noun(words(noun.words(), " (as a percentage)"))


def _value(scene: Scene, tree: Expression, plain: bool) -> Noun:
    if not has_quantity(tree):
        shown = values.layout_of(tree)
        if plain or (
            not isinstance(tree, Letter) and _open_coefficients(scene.problem) - letters(tree)
        ):
            return Noun(words(shown))
        return Noun(words("the value of ", shown), (), "value")
    if is_quantity(tree, "direction"):
        name = name_of(tree.arguments[0]) or ""
        if scene.is_wall(name):
            return Noun(words("a vector parallel to ", Emphasis(name)))
        return line(scene, Quantity("velocity", tree.arguments, tree.stage))
    noun = noun_phrase(scene, tree)
    if noun.where and not plain and not values.is_vector(tree):
        return replace(noun, head=words("the value of ", noun.head))
    return noun


def _open_coefficients(problem: Problem) -> frozenset[str]:
    """Coefficients that no fact tells and nobody asks for: a value may hold them."""
    letters_of = {
        name
        for event in problem.events
        if isinstance(event, Impact)
        for name in letters(event.e or Letter("e"))
    }
    for part, step in problem.steps():
        if isinstance(step, Find):
            letters_of -= {
                item.expression.name
                for item in step.items
                if isinstance(item, Value) and isinstance(item.expression, Letter)
            }
        elif isinstance(step, Given) and part.label is None:
            letters_of -= {
                relation.operands[0].name
                for relation in step.relations
                if isinstance(relation, Compare) and isinstance(relation.operands[0], Letter)
            }
    return frozenset(letters_of)


def _where(noun: Noun) -> Words:
    """What letters denote, behind a comma."""
    return words(", ", noun.where) if noun.where else ()


def _range(scene: Scene, tree: Expression) -> Noun:
    noun = noun_phrase(scene, tree)
    lead = "the range of possible values of "
    if noun.where:
        return replace(noun, head=words(lead, noun.head))
    return Noun(words(lead, noun.words()))


def _extreme(scene: Scene, item: Extremum) -> Noun:
    degree = "greatest" if item.kind == "maximum" else "least"
    noun = noun_phrase(scene, item.expression)
    subject = noun.head if noun.where else noun.words()
    of = words(f"the {degree} possible value of ", subject)
    return Noun(words(of, " as ", phrase(scene, item.over), " varies"), where=noun.where)


# --- several at once ------------------------------------------------------------------------------


def _alike(nouns: Sequence[Noun]) -> int:
    """How many at the beginning can be told together: of one kind, or of one body."""
    first = nouns[0]
    same_kind = same_body = 1
    for noun in nouns[1:]:
        if not first.kind or noun.kind != first.kind or noun.when != first.when:
            break
        same_kind += 1
    for noun in nouns[1:]:
        if not (_plain(first) and _plain(noun)):
            break
        if noun.body != first.body or noun.when != first.when:
            break
        same_body += 1
    return max(same_kind, same_body)


def _plain(one: Noun) -> bool:
    """Whether it is *the speed of A* or the like, with nothing behind."""
    return bool(one.kind and one.body) and not one.tail and not _is_direction(one)


def _is_direction(one: Noun) -> bool:
    return one.kind.endswith("direction")


def _together(nouns: Sequence[Noun]) -> Words:
    first = nouns[0]
    bodies = [noun.body for noun in nouns]
    if len(nouns) == 1:
        head = first.head
    elif first.kind == "value":
        head = words("the values of ", listed([noun.head[1:] for noun in nouns]))
    elif first.tail:
        head = words("the components of ", of_bodies("velocity", bodies), first.tail)
    elif all(noun.kind == first.kind for noun in nouns):
        head = of_bodies(first.kind, bodies)
    else:
        head = kinds_of([noun.kind for noun in nouns], first.body)
    asked = words(head, " ", first.when) if first.when else head
    if first.where:
        return words(asked, _where(first))
    if _is_direction(first):
        return words(asked, " (from ", values.EAST, ", anticlockwise positive)")
    return asked
