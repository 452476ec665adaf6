"""The protocol of a global field: who has one, and that a kind is found by its class alone."""

from itertools import islice
from math import prod

import pytest

from hfield.core.product import Constants
from hfield.errors import UndecidedError
from hfield.fields.base.ring import Ring
from hfield.fields.names import ring
from hfield.fields.quadratic_forms import hilbert_symbol, is_isomorphic, ramified_places, zero_norm
from hfield.fields.quadratic_forms.global_field import GlobalField, global_field, known_field
from hfield.fields.rationals.ring import Rationals
from tests.subcases import subcases

FIELDS = [
    "QQ",
    "QQ(I)",
    "QQ(sqrt(5))",
    "QQ(sqrt(-7))",
    "QQ[s]/(s^3-2)",
    "GF(3)(t)",
    "GF(4)(t)",
    "QQ(x)",
]


# A completion has one place, and functions in several variables have residues: no lists of places.
OTHERS = ["Qp(5)", "QQ(sqrt(2))_inf-", "QQ(x,y)"]


@subcases("name", [*FIELDS, *OTHERS])
def test_fields_with_places_have_an_arithmetic(name):
    F = ring(name)
    field = global_field(F)
    assert isinstance(field, GlobalField)
    assert field.ring == F
    assert field.splits_if_unramified == (name not in ("QQ(x)", "QQ(x,y)"))


@pytest.mark.parametrize("name", ["ZZ", "ZZ/6", "GF(7)", "GF(9)", "RR", "CC", "RDF", "QQ[x]"])
def test_other_rings_have_none(name):
    F = ring(name)
    assert global_field(F) is None
    with pytest.raises(UndecidedError, match="has no places"):
        known_field(F)
    with pytest.raises(UndecidedError, match="not a global field"):
        F.places()


def test_every_kind_is_tried_above():
    tried = {ring(name).theory for name in (*FIELDS, *OTHERS)}
    kinds, found = [Ring], set()
    for kind in kinds:
        kinds += kind.__subclasses__()
        if kind.theory and kind.__module__.startswith("hfield."):
            found.add(kind.theory)
    assert tried == found


@pytest.mark.parametrize("name", FIELDS[:-1])
def test_listed_places_read_back_and_symbols_agree_with_ramification(name):
    F, field = ring(name), known_field(ring(name))
    a, b = (F.gen, F.gen + 1) if F.characteristic else (F(-1), F(-3))
    t = F.one if F.characteristic == 2 else F.zero
    ramified = ramified_places(F, Constants(a, t, b))
    listed = list(islice(F.places(), 30))
    assert set(ramified) <= set(listed)
    symbols = []
    for v in listed:
        assert field.read_place(str(v)) == v
        symbols.append(hilbert_symbol(F.text(a), F.text(b), v) if name == "QQ" else _at(F, a, b, v))
        assert symbols[-1] == (-1 if v in ramified else 1)
    assert prod(symbols) == 1


def _at(F, a, b, v):
    return hilbert_symbol(F(a), F(b), v)


class Renamed(Rationals):
    """ℚ under another name: what follows must ask the class and not the name."""

    name = "the rationals"


def test_a_kind_is_known_by_its_class_and_not_by_its_name():
    F = Renamed()
    division, split = (Constants(F(a), F(0), F(b)) for a, b in ((-1, -3), (6, -2)))
    assert ramified_places(F, division) == (3, "inf")
    assert zero_norm(F, division).element is None
    assert zero_norm(F, split).method in ("search", "conic")
    assert is_isomorphic(F, division, Constants(F(-3), F(0), F(-1)))
    assert next(F.places()) == "inf"
