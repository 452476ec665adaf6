"""Each kind of ring is one module of the checker: all facts about the ring come from there."""

import pytest

from hfield.checker.anisotropy import is_certified
from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import KINDS, read_ring
from hfield.checker.scalars.rationals import Rationals
from hfield.ledger.claim import PANEL
from tests.checker import ring_data as data
from tests.checker.cases import decided
from tests.checker.ring_data import data_of, read_field
from tests.subcases import subcases

NAMES = (
    *(name for name in PANEL if name != "universal"),
    *("QQ[s]/(s^3-2)", "QQ(zeta5)", "QQ(zeta7)+", "QQ(root(2,3))", "QQ(sqrt(2),sqrt(3))"),
    *("ZZ", "RDF", "ZZ/6", "GF(9, x^2+1)", "QQ[x,y]", "GF(5)[x]", "ZZ[a]"),
)


@subcases("name", NAMES)
def test_data_give_the_name_back(name: str) -> None:
    assert read_field(name).name == name
    assert data_of(name)["kind"] in KINDS
    assert read_field(name).words


@subcases("name", NAMES)
def test_what_a_kind_says_of_squares_is_so(name: str) -> None:
    R = read_field(name)
    if R.is_field and R.characteristic != 2:
        for n in range(6):
            assert R.is_square(R.number(n * n))
        below = -R.number(1) if isinstance(R, Rationals) else R.neg(R.one)
        assert R.level_above(1) <= (not R.is_square(below))
    else:
        for n in (1, 2, 5):
            assert not R.level_above(n) or not R.is_field


@pytest.mark.parametrize("name", ["RR", "CC", "GF(5)", "ZZ", "QQ[x,y]", "QQ(x)"])
def test_what_a_kind_does_not_know_is_rejected(name: str) -> None:
    for place in (
        data.number(3),
        data.ideal(3),
        data.prime(0, 1),
        data.INFINITY,
        {"kind": None},
        {},
    ):
        with pytest.raises(Rejected, match="no place of the kind"):
            read_field(name).place(place)
    for place in ("3", 3, None, [data.number(3)]):
        with pytest.raises(
            Rejected, match=r"a place must be an object|no place of the kind 'None'"
        ):
            read_field(name).place(place)


@pytest.mark.parametrize("name", ["QQ", "RR", "GF(5)", "QQ(I)", "ZZ"])
def test_only_functions_have_values(name: str) -> None:
    with pytest.raises(Rejected, match="no values at points"):
        read_field(name).at("1")


def test_functions_over_a_finite_field_have_values_there() -> None:
    base, value = read_field("GF(5)(t)").at("3")
    assert base.name == "GF(5)"
    assert value(read_field("GF(5)(t)").read("(t^2+1)/(t+1)")) == 0
    with pytest.raises(Rejected, match="no value at 4"):
        read_field("GF(5)(t)").at("4")[1](read_field("GF(5)(t)").read("1/(t+1)"))


def test_squares_of_rings_that_are_no_fields_are_not_decided() -> None:
    for name in ("ZZ/6", "QQ[x,y]", "GF(2)(t)"):
        with pytest.raises(Rejected, match="squares"):
            read_field(name).is_square(read_field(name).one)
    assert read_field("GF(2)(t)").is_square(read_field("GF(2)(t)").zero)


def test_the_field_of_fractions() -> None:
    rings = {name: read_field(name) for name in (*NAMES, "GF(5)(x)", "QQ(a)", "QQ[x]")}
    found = {
        (name, field)
        for name, ring in rings.items()
        for field, above in rings.items()
        if above.is_fraction_field_of(ring)
    }
    assert found == {("ZZ", "QQ"), ("GF(5)[x]", "GF(5)(x)"), ("ZZ[a]", "QQ(a)"), ("QQ[x]", "QQ(x)")}


def test_rings_of_one_name_are_one_ring_whenever_they_were_read() -> None:
    ring = read_field("GF(5)[x]")
    for n in range(2, 200):
        read_ring(data.residues(n))
    assert read_field("GF(5)(x)").is_fraction_field_of(ring)
    assert not read_ring(data.functions(data.residues(5), "x")).is_fraction_field_of(ring)


def test_residues() -> None:
    assert read_field("ZZ").maps_modulo(8)
    assert read_field("ZZ/6").maps_modulo(3)
    assert not read_field("ZZ/6").maps_modulo(4)
    assert not any(read_field(name).maps_modulo(3) for name in ("QQ", "GF(9)", "QQ(x)", "ZZ[a]"))


def test_a_kind_joins_by_its_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """ℚ under another name: certificates over it are checked, facts about its norms among them."""
    twin, ring = Rationals(True), {"kind": "the twin of the rationals"}
    twin.name = "Twin"
    proof = decided("p*q == 0 => p == 0 or q == 0", "QQ", "(-1,-3|QQ)")
    own = {**proof, "field": "Twin", "ring": ring, "algebra": "(-1,-3|Twin)"}
    with pytest.raises(Rejected, match="are not known here"):
        check(own)
    monkeypatch.setitem(KINDS, ring["kind"], lambda data, ring: twin)
    assert check(own).verdict == "proved"
    assert is_certified("(-1,-3|Twin)", ring, {"by": "ordering"})
    assert not is_certified("(1,-3|Twin)", ring, {"by": "ordering"})
    with pytest.raises(Rejected, match="the data say Twin, and not 'QQ'"):
        check({**proof, "ring": ring})
