"""Names of other systems: each answers with what to write, and that exists."""

import re

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.hints import ALGEBRA, CLASSES, ELEMENT, FIELD, GROUP, IDEAL, LATTICE, ORDER

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


@pytest.mark.parametrize("hint", ["L & M", "L * x", "L.conjugate() * M", "len(classes)"])
def test_what_is_to_be_written_runs(hint):
    assert any(hint in text for _, hints in HINTED for text in hints.values())
    eval(hint, dict(ABOUT))
