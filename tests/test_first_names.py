"""Packages are called by what they do; modules still answer to the names that they had first."""

import pickle
from importlib import import_module
from pkgutil import iter_modules

import pytest

import restitution as r
from restitution.first_names import FIRST_NAMES


def test_no_package_bears_the_name_of_a_public_function():
    packages = {module.name for module in iter_modules(r.__path__) if module.ispkg}
    assert packages & set(r.__all__) == set()


@pytest.mark.parametrize(("first", "now"), FIRST_NAMES.items())
def test_a_first_name_gives_the_same_module(first, now):
    module = import_module(now)
    assert import_module(first) is module
    assert module.__spec__.name == module.__name__ == now


def test_modules_inside_are_the_same_as_well():
    assert import_module("restitution.solve.story") is import_module("restitution.solving.story")


def test_an_error_under_a_first_name_is_caught_as_what_it_is_now():
    with pytest.raises(ModuleNotFoundError, match=r"restitution\.solving\.nothing"):
        import_module("restitution.solve.nothing")


def test_functions_stay_functions():
    import_module("restitution.solve")
    import_module("restitution.draw")
    import_module("restitution.explain")
    assert callable(r.solve)
    assert callable(r.draw)
    assert callable(r.explain)
    assert pickle.loads(pickle.dumps(r.solve)) is r.solve
