"""Names and data of rings, judged by prover, checker and an independent reader of docs/reference/rings.md.

scripts/try_names.py judges as many as one likes.
"""

import json
from dataclasses import replace
from random import Random
from typing import Any

import pytest

from hfield.checker.scalars.fields import read_ring
from hfield.errors import HFieldError
from hfield.fields.names import ring
from tests.adversary.names import pari, some_data
from tests.adversary.names.arithmetic import real_roots
from tests.adversary.names.campaign import (
    Outcome,
    judge_data,
    judge_name,
    judge_name_of,
    run_data,
    run_names,
)
from tests.adversary.names.facts import facts
from tests.adversary.names.numbers import Data, modulus_of
from tests.adversary.names.places import NUMBER_FIELDS
from tests.adversary.names.reader import read
from tests.adversary.names.voices import checker_contradicts, prover_contradicts
from tests.subcases import slow, subcases
from tests.thorough import cases

# Names that once meant one field to the prover, another to the checker or to a reader; or a ring by mistake.
MEAN = {
    "QQ(zeta_8)": "QQ(zeta8)", "QQ(ζ₈)": "QQ(zeta8)", "ℚ(ζ_8)": "QQ(zeta8)", "QQ(zeta(8))": "QQ(zeta8)",
    "QQ(sqrt2)": "QQ(sqrt(2))", "QQ(sqrt8)": "QQ(sqrt(2))", "ℚ(√2)": "QQ(sqrt(2))", "QQ(√ 8)": "QQ(sqrt(2))",
    "QQ(2·√3)": "QQ(sqrt(3))", "QQ(zeta_5)": "QQ(zeta5)", "QQ(p)": "QQ(p)",
    "Frac(QQ[zeta5])": "Frac(QQ[zeta5])",
    "Frac(ZZ[pi])": "Frac(QQ[pi])", "Frac(GF(9)[t])": "GF(9)(t)",
    "Frac(GF(9)[pi])_(pi)": "Frac(GF(9)[pi])_(pi)",
    "Frac(GF(3)[inf])_inf": "Frac(GF(3)[inf])_inf", "Frac(GF(3)[inf])_oo": "Frac(GF(3)[inf])_inf",
    "Frac(GF(3)[inf])_(inf)": "Frac(GF(3)[inf])_(inf)", "Frac(GF(3)[infty])_infty": "Frac(GF(3)[infty])_inf",
    "QQ_5": "Qp(5)", "QQ_(5)": "Qp(5)", "ℚ₅": "Qp(5)", "QQ_inf": "RR", "QQ(sqrt(2))_inf-": "QQ(sqrt(2))_inf-",
    "QQ(I)_(5, I-2)": "QQ(I)_(5, I-2)", "QQ[s]/(s^3-2)_(2, s)": "QQ[s]/(s^3-2)_(2, s)",
    "QQ(sqrt(-1),sqrt(-2))": "QQ(sqrt(-2),I)", "GF(9, 1*x^0+0*x+1*x^2)": "GF(9, x^2+1)",
    "ZZ/2^33": "ZZ/8589934592", "GF(10^9+7)": "GF(1000000007)", "GF(2^8)": "GF(256)", "GF(2⁸)": "GF(256)",
    "QQ[π]": "QQ[pi]", "QQ[α]": "QQ[alpha]", " Q Q ": "QQ", "QQ(sqrt 2)": "QQ(sqrt(2))",
}  # fmt: skip
REFUSED = (
    *("GF(3)((inf))", "GF(3)(inf)", "GF(3)(inf)_inf", "GF(3)(inf)_(inf)", "QQ[zeta5]", "QQ[ζ₅]", "QQ(ω)"),
    *("QQ(e)", "QQ(i)", "QQ(j)", "QQ(k)", "QQ[I]", "QQ(E)", "QQ(pi)", "QQ(alpha)", "QQ(oo)", "QQ(GF9)"),
    *("QQ(Qp)", "QQ(and)", "QQ(norm)", "QQ(x,norm)", "Frac(QQ[e])", "QQ(sqrt2_)", "QQ(sqrtx)", "QQ(zeta5x)"),
    *("QQ(√x)", "QQ(√½)", "QQ(√ζ5)", "QQ(é)", "QQ(х)", "ZZ[x₁2]", "QQ[x²]", "QQ[a√]", "QQ_٥", "QQ(zeta٥)"),
    *("GF(2³3)", "ZZ/2¹0", "ZZ/1 0", "QQ(sqrt 2 3)", "QQ(x y)", "QQ[s]/(s³3-2)", "QQ(zeta5)_(5"),
    *("QQ[s]/(s^3-2)_5, s+2", "QQ_-5", "QQ(sqrt(2))_inf", "Qp(5)_5", "GF(3)(t)_inf_inf"),
)  # fmt: skip
CHUNKS = range(cases(5))


@subcases("text", MEAN)
def test_what_names_mean(text: str) -> None:
    out = Outcome()
    judge_name(text, out)
    assert out.complaints == []
    assert ring(text).name == MEAN[text]


@subcases("text", REFUSED)
def test_what_is_no_name(text: str) -> None:
    out = Outcome()
    judge_name(text, out)
    assert (out.complaints, out.tally) == ([], {"refused": 1})
    with pytest.raises(HFieldError):
        ring(text)


@pytest.mark.parametrize("chunk", CHUNKS)
def test_names_mean_one_thing(chunk: int) -> None:
    out = run_names(500, 7_000 + chunk)
    assert out.complaints == []
    assert out.tally["read alike"] > 100
    assert out.tally["refused"] > 100
    assert out.tally["rings asked about"] > 70


@pytest.mark.slow
@pytest.mark.parametrize("chunk", CHUNKS)
def test_data_have_one_name_and_come_back(chunk: int) -> None:
    out = run_data(300, 7_100 + chunk)
    assert out.complaints == []
    assert out.tally["went there and back"] > 250
    assert out.tally["rejected"] > 50


@pytest.mark.parametrize(
    "kind",
    [
        *(some_data.finite, some_data.quadratic, slow(some_data.multiquadratic)),
        *(slow(some_data.number_field), slow(some_data.root_field), slow(some_data.cyclotomic)),
        *(slow(some_data.functions), slow(some_data.completion)),
    ],
)
def test_pari_says_the_same(kind: Any) -> None:
    """Prover and checker, and the facts that they are judged by, against PARI."""
    pari.pari()
    rng, seen = Random(1), 0
    while seen < 25:
        data: Data = kind(rng)
        field = data.get("of", data)
        if field["kind"] in NUMBER_FIELDS and len(modulus_of(field)) > 6:
            continue  # PARI takes long for symbols at 2
        seen += 1
        known, squares = facts(data), pari.squares(data)
        assert [b for a, b in zip(known.squares, squares, strict=True) if a is not None] == [
            a for a in known.squares if a is not None
        ], data
        known = replace(known, squares=squares)
        assert [*prover_contradicts(ring(read_ring(data).name), known)] == [], data
        assert [*checker_contradicts(read_ring(data), known)] == [], data
        if data.get("place", {}).get("kind") in ("prime ideal", "split"):
            assert pari.residues(data) == known.residues, data
        if field["kind"] in NUMBER_FIELDS:
            assert pari.real_places(field) == len(real_roots(modulus_of(field))), data


# One field and another that its name might be taken for; the judge has to tell them apart.
ANOTHER = [
    ("QQ(zeta8)", "Frac(QQ[zeta8])"), ("QQ(sqrt(2))", "QQ(sqrt(3))"), ("GF(9)", "GF(9, x^2+1)"),
    ("GF(7)", "GF(49)"), ("QQ[s]/(s^3-2)", "QQ[s]/(s^3-3)"), ("QQ(zeta5)", "QQ(zeta10)"), ("QQ", "RR"),
    ("QQ(I)_(5, I-2)", "QQ(I)_(5, I-3)"), ("GF(3)((t))", "GF(3)(t)_inf"), ("Qp(5)", "Qp(3)"),
    ("GF(3)(t)_(t^2+1)", "GF(3)(t)_(t^2+t+2)"), ("QQ(zeta7)+_inf0", "QQ(zeta7)+_inf2"), ("ZZ/8", "ZZ/16"),
    ("QQ[s]/(s^3-2)_(5, 2+s)", "QQ[s]/(s^3-2)_(5, 4+3*s+s^2)"), ("QQ(root(2,3))", "QQ(root(2,6))"),
]  # fmt: skip


@subcases(("name", "other"), ANOTHER)
def test_the_judge_sees(name: str, other: str) -> None:
    for one, two in ((name, other), (other, name)):
        known = facts(read(one))
        for contradicts, R in (
            (prover_contradicts, ring(two)),
            (checker_contradicts, read_ring(read(two))),
        ):
            try:
                said = [*contradicts(R, known)]
            except Exception as error:  # a constant that means nothing in the other field
                said = [str(error)]
            assert said, (one, two)


def test_the_judge_sees_names_that_collide() -> None:
    data = read("QQ(sqrt(2))")
    out = Outcome(names={"QQ(sqrt(2))": json.dumps({"kind": "another"})})
    assert judge_name_of(data, out, near=False)
    assert len(out.complaints) == 1
    out = Outcome()
    judge_data(data, ring("QQ(sqrt(3))"), out, "√3 for √2")
    assert "the prover says" in out.complaints[0]
