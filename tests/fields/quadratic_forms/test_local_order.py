"""Over a completion two quaternions show the norm to have no zero, or a plane shows that it has one."""

from itertools import islice
from random import Random

import pytest

from hfield import ring
from hfield.core.product import Constants, conjugate, multiply, norm, trace
from hfield.errors import UndecidedError
from hfield.fields.quadratic_forms.global_field import known_field
from hfield.fields.quadratic_forms.normal_forms import discriminant, normal_form
from tests.subcases import subcases
from tests.thorough import quick_part

FIELDS = (
    "QQ", "QQ(sqrt(2))", "QQ(I)", "QQ(sqrt(-3))", "QQ(sqrt(5))", "QQ(sqrt(-7))", "QQ(sqrt(3))",
    "GF(3)(t)", "GF(9)(t)", "GF(2)(t)", "GF(4)(t)",
)  # fmt: skip


@pytest.mark.slow
@subcases("name", FIELDS)
def test_a_plane_with_a_zero_exactly_where_the_symbol_is_1(name):
    F, rng = ring(name), Random(5)
    field, t = known_field(F), F(F.characteristic == 2)
    places = [v for v in islice(F.places(), 7) if field.residues(v) is not None]
    seen = set()
    for _ in quick_part(range(8)):
        a, b = (F.random(rng) * F(rng.choice((1, 2, 3, 4, 7, 8, 45))) for _ in range(2))
        c = Constants(a, t, b)
        if F.is_zero(discriminant(F, c)):
            continue
        ramified = field.ramified(normal_form(F, c))
        for v in places:
            plane = field.hyperbolic_plane(c, v)
            assert (plane is None) == (v in ramified) == (field.unit_and_prime(c, v) is not None)
            seen.add(plane is None)
            if plane is not None:
                check_plane(F, field.residues(v), c, plane)
    assert seen == {True, False}


def check_plane(F, place, c, plane):
    """N(X·q + Y·u) = N(q)·X² + T·XY + N(u)·Y² has the discriminant T²·(1 − 4y), and the prime divides y."""
    q, u = (tuple(F(x) for x in v) for v in plane)
    T = trace(c, multiply(c, q, conjugate(c, u)))
    both = norm(c, q) * norm(c, u)
    assert not F.is_zero(T)
    assert F.is_zero(both) or place.valuation(both) > 2 * place.valuation(T)


@pytest.mark.parametrize("name", ["GF(2)((t))", "GF(2)(t)_(t^2+t+1)"])
def test_elements_are_norms_from_inseparable_extensions(name):
    """In characteristic 2 every x is w² + s·r² for an s that is not a square."""
    F, rng = ring(name), Random(2)
    field, s = known_field(F), F("t")
    for _ in range(5):
        x = F.random(rng)
        w, r = field.as_norm(x, s)
        assert w * w + s * r * r == x
    for inexact in ((F("1 + O(t^3)"), s), (s, F("1 + O(t^3)"))):
        with pytest.raises(UndecidedError, match="known exactly"):
            field.as_norm(*inexact)
