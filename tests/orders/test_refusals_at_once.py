"""Enumerations estimate before they start: too large a one is refused at once, with its limit."""

import re

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.errors import TooLargeError
from hfield.orders import enumeration

K = ring("QQ(sqrt(5))")
BASES = {
    "O": QuaternionAlgebra(11).maximal_order(),
    "OK": QuaternionAlgebra(K, -1, -1).maximal_order(),
    "G": QuaternionAlgebra(6).maximal_order().norm_one_group(),
    "C": QuaternionAlgebra(11).maximal_order().class_set(),
    "CN": QuaternionAlgebra(11).eichler_order(9).class_set(),
    "CK": QuaternionAlgebra(K, -1, -1).maximal_order().class_set(),
    "E": QuaternionAlgebra(K, -1, -1).eichler_order(10007),
}
TOO_LARGE = [
    "C.brandt_matrix(10**6 + 3)", "C.neighbours(10**9 + 7)", "C.neighbours_of(0, 10**9 + 7)",
    "C.hecke_polynomial(10**6 + 3)", "CN.brandt_matrix(3**30)", "C.theta_series(0, 1, 10**6)",
    "O.theta_series(10**6)", "O.elements_of_norm(10**6)", "O.ideals_of_norm(10**6 + 3)",
    "O.ternary_theta_series(10**7)", "O.embeddings(-10**9)", "O.suborders(1009)",
    "OK.theta_series(10**4)", "OK.elements_of_norm(10**3)", "OK.ideals_of_norm(10**6 + 3)",
    "CK.brandt_matrix(10**6 + 3)", "E.class_set()", "G.traces(10**9)", "G.geodesics(40)",
]  # fmt: skip


@pytest.mark.parametrize("text", TOO_LARGE)
def test_refused_before_anything_is_enumerated(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The refusal names numbers, and comes before the first short vector or neighbour."""
    BASES["E"].mass()
    for name in ("C", "CN"):  # neighbours at the least prime serve all others
        assert BASES[name].neighbours(2)
        assert BASES[name].exchanged(11)

    def started(*_: object) -> object:
        raise AssertionError("the enumeration was started")

    monkeypatch.setattr(enumeration, "_heads", started)
    for name in ("C", "CN"):
        monkeypatch.setattr(BASES[name]._classes, "classes_inside", started)
    with pytest.raises(TooLargeError) as error:
        eval(text, dict(BASES))
    assert re.search(r"\d", str(error.value))


def test_estimates_are_about_the_numbers() -> None:
    """The volume of an ellipsoid is about the number of its points, in dimensions 2 to 8."""
    for n in range(2, 9):
        gram = [[2 * int(i == j) for j in range(n)] for i in range(n)]
        bound = 200 if n < 4 else 16
        count = 1 + 2 * sum(1 for _ in enumeration.short_vectors(gram, bound))
        assert 0.5 < enumeration.volume(gram, bound, n) / count < 2
