"""Trees of lines rebuilt, and values that are put in: what is kept is what is worked out anew."""

from __future__ import annotations

import pickle
from fractions import Fraction

import pytest
import sympy as sp

from restitution.exact.symbols import substituted
from restitution.explaining.lines.derivation import Link, Meaning, Relation
from restitution.explaining.lines.notation import read_tree
from restitution.explaining.lines.trees import compounds_rebuilt, exchanged, of_relation, rebuilt
from restitution.expression.tree import Apply, Binary, Expression, Letter, Number
from restitution.planning.routes.choice import gradient
from restitution.planning.writing.desk import chain as chain_of
from restitution.render import layout as lay

TREES = ("2*u*cos(alpha) + 3*v/4", "sqrt(2)*u/3 - 1", "-(a + 2*b)", "u", "along(velocity(A, 1), i)")


@pytest.mark.quick
@pytest.mark.parametrize("text", TREES)
def test_compounds_are_rebuilt_as_all_nodes_are(text: str) -> None:
    def doubled(node: Expression) -> Expression:
        if isinstance(node, Binary | Apply):
            return Binary("*", Number(Fraction(2)), node)
        return node

    tree = read_tree(text, {"A": "sphere"})
    assert compounds_rebuilt(tree, doubled) == rebuilt(tree, doubled)
    assert compounds_rebuilt(tree, lambda node: node) is tree
    assert exchanged(tree, {}) is tree


@pytest.mark.quick
def test_values_are_put_in_at_once() -> None:
    x, y = sp.symbols("x y")
    assert substituted(x + 2 * y, {x: y, y: x}) == y + 2 * x
    assert substituted(sp.sin(x) / x, {sp.sin(x): y}) == y / x
    assert substituted(x, {}) == x


@pytest.mark.quick
def test_sides_of_a_relation() -> None:
    a, b, c = map(Letter, "abc")
    chain = Relation(((Link(a, "=", b), Link(b, "=", c)),))
    assert (chain.sides, chain.whole) == ((a, c), Link(a, "=", c))
    less = Relation(((Link(a, "<", b), Link(b, "=", c)),))
    assert (less.sides, less.whole) == (None, Link(a, "<", c))
    assert Relation(((Link(a, "=", b),), (Link(a, "=", c),))).sides is None
    assert Meaning("a", b).sides is Meaning("a", b).subject is None
    assert chain.subject == Relation(((Link(a, "=", c),),)).subject != less.subject is None


@pytest.mark.quick
def test_relation_of_which_nothing_is_changed_is_the_same() -> None:
    a, b, c = map(Letter, "abc")
    relation = Relation(((Link(a, "=", b, "put"),), (Link(a, "<", Binary("+", b, c)),)))
    assert of_relation(relation, lambda node: node) is relation
    put = of_relation(relation, lambda node: c if node == b else node)
    assert put == Relation(((Link(a, "=", c, "put"),), (Link(a, "<", Binary("+", c, c)),)))


@pytest.mark.quick
def test_chain_that_was_written_before_is_the_same() -> None:
    steps = (Binary("+", Letter("b"), Letter("c")), None), (Letter("d"), "put")
    assert chain_of(Letter("a"), *steps) is chain_of(Letter("a"), *steps)


@pytest.mark.quick
def test_gradient_is_that_at_its_point() -> None:
    x, y, z = sp.symbols("x y z")
    for point in ({x: 2.0, y: 3.0, z: 1.0}, {x: 4.0, y: 1.0, z: 1.0}):
        assert gradient(x**2 * y, point) == {x: 2 * point[x] * point[y], y: point[x] ** 2}
    with pytest.raises(KeyError):
        gradient(x * y, {x: 2.0})


@pytest.mark.quick
def test_layout_keeps_its_hash_in_its_own_process() -> None:
    layout = lay.Sum(
        (("+", lay.Letter("u")), ("-", lay.Fraction(lay.Number("1"), lay.Number("2"))))
    )
    assert hash(layout) == hash(layout)
    again = pickle.loads(pickle.dumps(layout))
    assert again == layout
    assert not hasattr(again, "_hash")
    assert hash(again) == hash(layout)
