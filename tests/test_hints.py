"""Names of other systems: each answers with what to write, and that exists."""

import importlib
import re
import sys

import pytest

import hfield
from hfield import H, QuaternionAlgebra, ring
from hfield.hints import (
    ALGEBRA,
    CLASSES,
    ELEMENT,
    FIELD,
    GROUP,
    IDEAL,
    LATTICE,
    ORDER,
    ForeignName,
)

A = QuaternionAlgebra("QQ", -1, -11)
order = A.maximal_order()
L = A.lattice([2, "i", "j", "k"])
HINTED = [
    (A, ALGEBRA),
    (A.basis[1], ELEMENT),
    (L, LATTICE),
    (order, ORDER),
    (order.left_ideal([2]), IDEAL),
    (order.class_set(), CLASSES),
    (ring("QQ(sqrt(5))"), FIELD),
    (ring("QQ[s]/(s^3-2)"), FIELD),
    (QuaternionAlgebra(6).maximal_order().norm_one_group(), GROUP),
]
FUNCTIONS = {"hilbert_symbol"}  # of hfield
ABOUT = {"L": L, "M": L, "x": A.basis[1], "classes": order.class_set()}


@pytest.mark.parametrize(("thing", "hints"), HINTED, ids=lambda x: type(x).__name__)
def test_every_hint_is_given_and_names_what_there_is(thing, hints):
    for name, hint in hints.items():
        with pytest.raises(AttributeError, match="write " + re.escape(hint)):
            getattr(thing, name)
        assert not hasattr(thing, name)
        assert name not in dir(thing)
        called = set(re.findall(r"([a-z_]+)(?=\()", hint)) - {"len", "list"} - FUNCTIONS
        for one in called:
            assert any(hasattr(other, one) for other, _ in HINTED), (name, hint)


BASES = {
    "definite over ℚ": ("QQ", -1, -11),
    "indefinite over ℚ": ("QQ", -1, 3),
    "definite over ℚ(√5)": ("QQ(sqrt(5))", -1, -1),
    "a Fuchsian group over ℚ(√3)": ("QQ(sqrt(3))", -1, "sqrt(3)"),
    "definite over a cubic field": ("QQ[s]/(s^3-3*s-1)", -1, -1),
    "over a field with a complex place": ("QQ[s]/(s^3-2)", "s", 3),
}


@pytest.mark.parametrize("base", BASES.values(), ids=list(BASES))
def test_hints_name_what_there_is_over_every_base(base):
    """Each name that a hint writes as a call, or after a dot, is an attribute of something over that base."""
    algebra = QuaternionAlgebra(*base)
    maximal = algebra.maximal_order()
    things = [algebra, algebra.basis[1], maximal, maximal.left_ideal([2]), algebra.ring]
    things.append(algebra.lattice([1, "i", "j", "k"]))
    over_q = algebra.ring.name == "QQ"
    if not over_q:
        things += [algebra.ring.unit_group(), algebra.ring.class_group()]
    # class sets are of definite orders; hints mention what those have
    definite = A if over_q else QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    things.append(definite.maximal_order().class_set())
    for thing in things:
        inherited = (vars(cls) for cls in type(thing).__mro__)
        hints = {name: x.hint for own in inherited for name, x in own.items() if is_hint(x)}
        for name, hint in hints.items():
            own = re.match(r"[a-z_]+(?=\(\)|\([a-z]+\)$|$)", hint)
            if own and own[0] not in BUILT_IN:
                assert hasattr(thing, own[0]), (type(thing), name, hint)
            for one in set(re.findall(r"[a-z_]+(?=\()|(?<=[a-z)]\.)[a-z_]+", hint)) - BUILT_IN:
                assert any(hasattr(other, one) for other in things), (type(thing), name, hint)


BUILT_IN = {"len", "list", "hilbert_symbol"}


def is_hint(x):
    return isinstance(x, ForeignName)


def test_what_is_to_be_written_for_functions_of_magma_and_pari_runs():
    from hfield import hilbert_symbol
    from hfield.hints import CALLS

    G = QuaternionAlgebra(6).maximal_order().norm_one_group()
    names = ABOUT | {
        "q": A.basis[1],
        "A": A,
        "B": A,
        "F": "QQ",
        "d": -11,
        "a": 2,
        "b": 3,
        "p": 3,
        "n": 2,
        "k": 4,
    }
    names |= {
        "O": order,
        "O2": order,
        "I": order.left_ideal([2]),
        "J": order.left_ideal([3]),
        "G": G,
    }
    names |= {"QuaternionAlgebra": QuaternionAlgebra, "hilbert_symbol": hilbert_symbol, "H": H}
    names |= dict(zip("ij", A.basis[1:], strict=False))
    names |= {"ring": ring, "elements": [1, "i", "j", "k"]}
    for there, here in CALLS.items():
        x = G.generators[0] if "G." in here else A.basis[1]
        try:
            eval(here, names | {"x": x})
        except Exception as error:
            pytest.fail(f"{there}: {here} raises {error!r}")


def test_what_is_to_be_written_for_functions_that_turn_points_runs():
    import numpy as np

    import rotation
    from rotation.hints import CALLS

    names = {name: getattr(rotation, name) for name in ("Rotation", "align_similarity")}
    r, points = rotation.Rotation.from_euler("xyz", [0.1, 0.2, 0.3]), np.eye(3)
    names |= {"r": r, "s": r, "points": points, "source": points, "target": 2 * points}
    names |= {"m": points, "angles": [1, 2, 3], "v": [1, 2, 3]}
    for there, here in CALLS.items():
        assert eval(here, dict(names)) is not None, there


@pytest.mark.parametrize("hint", ["L & M", "L * x", "L.conjugate() * M", "len(classes)"])
def test_what_is_to_be_written_runs(hint):
    assert any(hint in text for _, hints in HINTED for text in hints.values())
    eval(hint, dict(ABOUT))


IMPORTS = {
    "from": "from hfield import nrd",
    "two names": "from hfield import H, nrd",
    "another name": "from hfield import nrd as n",
    "a module": "import hfield.nrd",
    "importlib": "import importlib; importlib.import_module('hfield.nrd')",
    "a relative import": "import importlib; importlib.import_module('.nrd', 'hfield')",
    "the function": "__import__('hfield', fromlist=['nrd'])",
}


@pytest.mark.parametrize("source", IMPORTS.values(), ids=list(IMPORTS))
def test_an_import_of_a_foreign_name_says_what_to_write(source):
    # ``except ModuleNotFoundError`` around the import of a module, and pytest.importorskip, catch it
    with pytest.raises(ModuleNotFoundError, match=r"hfield has no 'nrd': write q\.norm\(\)"):
        exec(source, {})


def test_to_import_hfield_again_changes_nothing():
    paths, finders = list(hfield.__path__), list(sys.meta_path)
    importlib.reload(hfield)
    assert hfield.__path__ == paths
    assert sys.meta_path == finders
    assert hfield.H is H


def test_other_names_and_other_ways_are_as_usual(monkeypatch):
    with pytest.raises(AttributeError, match="hfield has no 'nrd': write"):
        hfield.nrd  # noqa: B018
    assert not hasattr(hfield, "nrd")
    with pytest.raises(ImportError, match="cannot import name 'nothing_of_ours' from 'hfield'"):
        exec("from hfield import nothing_of_ours", {})
    with pytest.raises(ModuleNotFoundError, match=r"No module named 'hfield\.nothing_of_ours'"):
        exec("import hfield.nothing_of_ours", {})
    names = {}
    exec("from hfield import *", names)
    assert names["H"] is H
    # without the finder the import fails as any other does
    monkeypatch.setattr(sys, "meta_path", [x for x in sys.meta_path if "Foreign" not in repr(x)])
    with pytest.raises(ImportError, match="cannot import name 'nrd' from 'hfield'"):
        exec("from hfield import nrd", {})
