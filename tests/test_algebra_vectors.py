"""Products, conjugates, norms, traces and inverses against PARI and GAP (tests/vectors/README.md)."""

import json
from itertools import groupby
from pathlib import Path
from typing import Any

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.errors import NotInvertibleError
from tests.subcases import first_quick, subcases

CASES = json.loads((Path(__file__).parent / "vectors" / "products.json").read_text())["cases"]
BY_RING = {name: list(cases) for name, cases in groupby(CASES, key=lambda case: case["ring"])}


@pytest.mark.parametrize("part", first_quick(range(3), 1))
@subcases("name", BY_RING)
def test_agrees_with_pari(name: str, part: int) -> None:
    F = ring(name)
    for case in BY_RING[name][part::3]:
        A = QuaternionAlgebra(F, case["a"], case["b"], case["t"])
        p, q = A(*case["p"]), A(*case["q"])
        assert p * q == A(*case["product"]), case
        assert F.equal(p.norm(), F(case["norm_p"])), case
        assert F.equal(p.trace(), F(case["trace_p"])), case
        assert p.conjugate() == A(*case["conj_p"]), case
        if case["inverse_p"] is None:
            with pytest.raises(NotInvertibleError):
                p.inverse()
        else:
            assert p.inverse() == A(*case["inverse_p"]), case
        assert [A(*column) for column in zip(*p.matrix(), strict=True)] == [p * b for b in A.basis]


@pytest.mark.parametrize(
    "name", first_quick(["GF(7)", "GF(9)", "QQ", "GF(4)", "GF(2^8)", "GF(9, x^2+1)", "ZZ/6"], 3)
)
def test_a_batch_does_what_its_elements_do(name: str) -> None:
    F = ring(name)
    constants = {(case["a"], case["b"], case["t"]) for case in BY_RING[name]}
    for a, b, t in sorted(constants):
        A = QuaternionAlgebra(F, a, b, t)
        cases = [c for c in BY_RING[name] if (c["a"], c["b"], c["t"]) == (a, b, t)]

        def column(key: str, cases: list[Any] = cases, F: Any = F, A: Any = A) -> Any:
            return A(*([F(c[key][n]) for c in cases] for n in range(4)))

        p, q = column("p"), column("q")
        assert (p * q == column("product")).all()
        assert (p.conjugate() == column("conj_p")).all()
        assert all(
            F.equal(F.scalar(n), F(c["norm_p"])) for n, c in zip(p.norm(), cases, strict=True)
        )


def test_a_wrong_sign_would_be_seen() -> None:
    """The vectors tell i·j = k from i·j = −k: in the wrong algebra some product differs."""
    wrong = 0
    for case in BY_RING["QQ"]:
        A = QuaternionAlgebra("QQ", case["a"], case["b"], case["t"])
        wrong += A(*case["q"]) * A(*case["p"]) != A(*case["product"])
    assert wrong > 20
