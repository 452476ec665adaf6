"""Rings as data: the names of the document and no others, by the checker and by the package alike."""

import json
import re
from itertools import islice
from pathlib import Path
from typing import Any

import pytest

from hfield.checker import glossary
from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.fields import KINDS, read_ring
from hfield.fields.names import ring, ring_of_data
from tests.checker import ring_data as made
from tests.checker.cases import about_field, certified
from tests.checker.ring_data import Data, data_of
from tests.subcases import subcases

PAGE = (Path(__file__).parents[2] / "docs" / "reference" / "certificates.md").read_text(
    encoding="utf-8"
)
EXAMPLES = [json.loads(line) for line in re.findall(r'^\{"name": .*\}$', PAGE, re.MULTILINE)]
IDENTITY = {"kind": "identity"}


@subcases("example", EXAMPLES)
def test_the_examples_of_the_page(example: dict[str, Any]) -> None:
    name, data = example["name"], example["ring"]
    assert read_ring(data).name == name
    assert ring(name).name == name
    assert ring(name).data == data
    assert ring_of_data(data) is ring(name)
    assert check(
        of_floats(name) if "DF" in name else certified("s*y == y*s", name, "identity", IDENTITY)
    )


def of_floats(name: str) -> dict[str, Any]:
    evidence = {"kind": "witness", "ring": data_of(name), "values": {"s": ["0"]}}
    refuted = {"verdict": "refuted", "evidence": evidence}
    return certified("s == s + 1", name, "floats, exact on small integers", {}) | refuted


def test_the_page_lists_the_kinds() -> None:
    rows = re.findall(
        r"^\| (`[^|]*`) \| [^|]*\|", PAGE.partition("## The first schema")[0], re.MULTILINE
    )
    kinds = {kind for row in rows for kind in re.findall("`([a-z ]+)`", row)}
    assert set(KINDS) <= kinds
    assert {example["ring"]["kind"] for example in EXAMPLES} == set(KINDS)
    pattern = PAGE.partition("regular expression (")[2].split("```")[1]
    assert "".join(pattern.split()) == glossary._CONSTANT.pattern


FIELDS = (
    *("QQ", "QQ(sqrt(2))", "QQ(I)", "QQ(sqrt(17))", "QQ[s]/(s^3-2)", "QQ[s]/(s^2-17)", "QQ(zeta5)"),
    *("QQ(zeta7)+", "QQ(root(2,4))", "GF(2)(t)", "GF(9)(t)", "GF(9, x^2+1)(u)", "GF(3)(x)"),
    *("Frac(GF(5)[zeta5])", "Frac(GF(3)[inf])", "QQ[zeta5]/(zeta5^2+1)"),
)


@subcases("name", FIELDS)
def test_completions_are_called_alike(name: str) -> None:
    K, known = ring(name), 0
    for v in islice(K.places(), 14):
        F = K.completion(v)
        assert F.data is not None
        if F.data["kind"] != "completion":  # ℝ and ℂ are called by their names
            assert F in (ring("RR"), ring("CC"))
            continue
        assert ring(F.name).data == F.data
        place = F.data["place"]
        if place["kind"] == "complex" or "/" in "".join(map(str, place.get("element") or [])):
            with pytest.raises(Rejected, match=r"no place of the kind 'complex'|not integral"):
                read_ring(F.data)
        else:
            assert read_ring(F.data).name == F.name
            known += 1
    assert known > 6


def test_no_two_rings_have_one_name() -> None:
    """Of the rings that differ in one thing of their data; what is the same ring is written in one way."""
    T = made.functions(made.finite(3), "t")
    mod_2, F_2 = made.residues(2), made.finite(2)
    cube, deep = made.generated([-2, 0, 0, 1]), made.functions(made.finite(3), "inf")
    rings: list[Data] = [
        *(made.QQ, made.ZZ, made.RR, made.CC, made.RDF, T, deep, cube),
        *(made.residues(n) for n in (2, 3, 7, 9)),
        *(made.finite(p) for p in (2, 3, 7)),
        *(made.finite(3, 2, f) for f in ([2, 2, 1], [1, 0, 1], [2, 1, 1])),
        *(made.finite(2, n) for n in (13, 14)),
        *(made.finite(2, 13, [*f, *[0] * 7, 1]) for f in ([1, 1, 1, 0, 0, 1], [1, 0, 1, 0, 1, 1])),
        *(made.quadratic(d) for d in (-1, 2, -2)),
        *(made.multiquadratic(*d) for d in ((2, 3), (3, 2), (2, -1), (2, 3, 5))),
        *(made.generated(f, s) for f in ([-2, 0, 1], [1, 0, 1], ["-1/2", 0, 1]) for s in ("s", "a", "zeta5")),
        *(made.root_field(a, n) for a, n in ((2, 3), (2, 4), (-2, 3), ("1/2", 3), ("3/2", 3))),
        *(made.cyclotomic(n, real) for n, real in ((5, False), (5, True), (7, True), (10, False))),
        *(made.functions(base, s) for base in (made.QQ, F_2, mod_2) for s in ("t", "pi")),
        *(made.functions(made.finite(3, 2, f), "t") for f in ([2, 2, 1], [1, 0, 1])),
        *(made.polynomials(base, *s) for base in (made.QQ, made.ZZ, F_2) for s in ("t", "xy", "yx")),
        *(made.polynomials(base, "pi") for base in (made.QQ, made.ZZ)),
        *(made.completion(made.QQ, made.number(p)) for p in (2, 3)),
        *(made.completion(made.quadratic(2), made.number(p)) for p in (2, 3)),
        *(made.completion(made.quadratic(2), made.split(7, r)) for r in (3, 4)),
        made.completion(made.quadratic(-1), made.split(5, 2)),
        made.completion(made.quadratic(2), made.real(0)),
        *(made.completion(cube, made.ideal(p, *g)) for p, g in ((7, ()), (5, (2, 1, 0)), (5, (4, 3, 1)))),
        made.completion(cube, made.real(0)),
        *(made.completion(field, v) for field in (T, deep) for v in (made.INFINITY, made.prime(0, 1))),
        made.completion(T, made.prime(1, 1)),
    ]  # fmt: skip
    called = [read_ring(data).name for data in rings]
    assert len(set(called)) == len(called)
    for data, name in zip(rings, called, strict=True):
        if data not in NOT_OF_THE_PACKAGE:
            assert ring(name).name == name
            assert ring(name).data == data


# The package has functions over GF(2), and not over ℤ/2.
NOT_OF_THE_PACKAGE = [made.functions(made.residues(2), s) for s in ("t", "pi")]


@pytest.mark.parametrize(
    "name",
    ["GF(9, x^2+1)", "QQ(I)_(5, I-2)", "QQ[s]/(s^3-2)_(2, s)", "Frac(QQ[pi])", "GF(4)(t)_inf"],
)
def test_the_name_is_the_one_that_is_written(name: str) -> None:
    """Another text, be it that of the same ring, is not."""
    data = certified("s*y == y*s", name, "identity", IDENTITY)
    assert check(data).field == name
    others = {
        name + " ",
        " " + name,
        name.lower(),
        name.replace("x^2+1", "x^2 + 1"),
        name.replace("^", "**"),
    }
    others |= {
        name.replace(", ", ","),
        name.replace(", ", ",  "),
        name.replace("-", "\u2212"),
        f"({name})",
    }
    others |= {
        name.replace("(", "( "),
        name.replace("I-2", "-2+I"),
        name.replace("Frac(QQ[pi])", "QQ(pi)"),
    }
    for other in sorted(others - {name}):
        for algebra in (data["algebra"], f"(-1,-1|{other})"):
            with pytest.raises(Rejected, match="the data say"):
                check({**data, "field": other, "algebra": algebra})
        with pytest.raises(Rejected, match="is none over"):
            check({**data, "algebra": f"(-1,-1|{other})"})


def test_a_false_modulus_is_not_that_of_the_name() -> None:
    """What is said of GF(9) where x² = x + 1 is not shown where x² = −1, whatever the file calls it."""
    said = certified("x**2 == x + 1", "GF(9)", "identity", IDENTITY)
    assert check(said).words == "the field with 9 elements, x a root of x^2+2*x+2"
    for modulus, why in (
        ([1, 0, 1], "the data say GF.9, x.2.1., and not 'GF.9.'"),
        ([2, 1, 1], "the data say GF.9, x.2.x.2., and not 'GF.9.'"),
        ([2, 0, 1], "is reducible"),
        ([2, 2, 4], "is monic, of the degree 2, reduced modulo 3"),
        ([2, 5, 1], "is monic, of the degree 2, reduced modulo 3"),
        (["2", 2, 1], "a coefficient must be an integer"),
        (None, "has to say its modulus"),
    ):
        with pytest.raises(Rejected, match=why):
            check({**said, "ring": made.finite(3, 2, modulus)})
    with pytest.raises(Rejected, match="expanding"):
        check(about_field(said, made.finite(3, 2, [1, 0, 1])))


def test_fractions_are_in_lowest_terms() -> None:
    data = data_of("QQ[s]/(s^2-1/2)")
    assert data["modulus"] == ["-1/2", 0, 1]
    for other in (
        "-2/4",
        "-1/2 ",
        "+1/2",
        "-0.5",
        "1/-2",
        -0.5,
        "-1//2",
        ["-1/2"],
        {"n": -1},
        None,
    ):
        with pytest.raises(Rejected, match="a coefficient must be an integer"):
            read_ring({**data, "modulus": [other, 0, 1]})
    for whole in ("0", "0/1", "0/5", False):
        with pytest.raises(Rejected, match="a coefficient must be an integer"):
            read_ring({**data, "modulus": ["-1/2", whole, 1]})


def test_every_key_of_the_data_is_needed_and_no_other() -> None:
    for example in EXAMPLES:
        data = example["ring"]
        for key in data:
            with pytest.raises(Rejected, match=r"lacks the key|the kind of a ring must be a text"):
                read_ring({k: v for k, v in data.items() if k != key})
            with pytest.raises(Rejected):
                read_ring({**data, key: True})
        with pytest.raises(Rejected, match="unknown key 'name'"):
            read_ring({**data, "name": example["name"]})
        place = data.get("place", {})
        for key in place:
            with pytest.raises(
                Rejected, match=r"lacks the key|no place of the kind|must be an integer"
            ):
                read_ring({**data, "place": {k: v for k, v in place.items() if k != key}})
        if place:
            with pytest.raises(Rejected, match="unknown key 'name'"):
                read_ring({**data, "place": {**place, "name": "v"}})


# --- the first schema -----------------------------------------------------------------------------


def first(data: dict[str, Any], evidence: Any = None) -> dict[str, Any]:
    """Return a certificate of the first schema, in which evidence has names."""
    old = {key: value for key, value in data.items() if key != "ring"}
    return {**old, "schema": "hfield-cert/1", "evidence": evidence or data["evidence"]}


SPELLED = (
    "QQ",
    "ZZ",
    "RR",
    "CC",
    "ZZ/100",
    "GF(2)",
    "GF(9)",
    "GF(256)",
    "GF(251)",
    "GF(169)(t)",
    "QQ(x)",
    "QQ(t)",
)
SPELLED += ("GF(2)(t)", "QQ(I)", "QQ(sqrt(-7))", "QQ(sqrt(97))", "QQ(sqrt(-95))")  # fmt: skip


@subcases("name", SPELLED)
def test_names_of_the_table_are_read(name: str) -> None:
    data = certified("s*y == y*s", name, "identity", IDENTITY)
    assert check(first(data)) == check(data)


OTHERS = (
    *("GF(3^2)", "GF( 9)", "GF(9, x^2+1)", "GF(257)", "GF(9)(x)", "ZZ/101", "ZZ/1", "QQ(sqrt(-1))"),
    *("QQ(sqrt(8))", "QQ(sqrt(101))", "QQ(y)", "QQ(zeta5)", "QQ[s]/(s^3-2)", "Qp(5)", "ZZ[x]", "Q"),
    *("ℚ", "QQ ", ""),
    "Frac(QQ[t])",
)  # fmt: skip


@subcases("name", OTHERS)
def test_other_names_are_not_and_there_is_a_way(name: str) -> None:
    data = {
        **certified("s*y == y*s", "QQ", "identity", IDENTITY),
        "field": name,
        "algebra": f"(-1,-1|{name})",
    }
    with pytest.raises(
        Rejected, match=r"is no name that is read in a certificate hfield-cert/1; `hfield upgrade`"
    ):
        check(first(data))
    witness = {"kind": "witness", "field": name, "values": {}}
    refuted = {**certified("1 == 2", "QQ", "identity", witness), "verdict": "refuted"}
    with pytest.raises(Rejected, match="is no name that is read in a certificate hfield-cert/1"):
        check(first(refuted))


def test_all_of_the_first_schema_is_read() -> None:
    witness = {"kind": "witness", "field": "GF(3)", "values": {"s": ["2"]}}
    over = {"kind": "over", "field": "GF(3)", "evidence": witness}
    data = {**certified("not-everywhere{s == 1}", None, "witness", over)}
    assert check(first(data)).verdict == "proved"
    named = certified("over{GF(4); x**2 == x + 1}", None, "identity", IDENTITY)
    assert check(first(named, IDENTITY)).verdict == "proved"
    with pytest.raises(Rejected, match="does not hold by expanding"):
        check(first({**named, "statement": "over{GF(4); x**2 == x}"}, IDENTITY))
    with pytest.raises(Rejected, match="is no name that is read"):
        check(first({**named, "statement": "over{GF(2^2); x**2 == x + 1}"}, IDENTITY))
    place = {
        "kind": "anisotropic",
        "by": "place",
        "place": "2",
        "u": ["1/2"] * 4,
        "j": ["1", "1", "0", "0"],
    }
    division = certified("division", "QQ", "anisotropic norm", place)
    assert check(first(division)).verdict == "proved"
    for bad in ("(2)", "2 ", "x", "٢", "-2", 2, None, {"kind": "number", "n": 2, "more": 1}):
        with pytest.raises(Rejected):
            check(first(division, {**place, "place": bad}))
    for bad in ("4", "1", "0"):
        with pytest.raises(Rejected, match=r"is not a place|must be at least 2"):
            check(first(division, {**place, "place": bad}))
    special = {"kind": "anisotropic", "by": "specialisation", "at": "-1"}
    special["proof"] = {
        "by": "place",
        "place": "3",
        "u": ["0", "1", "0", "0"],
        "j": ["0", "0", "1", "0"],
    }
    there = certified("division", "QQ(x)", "anisotropic norm", special)
    with pytest.raises(Rejected, match=r"has a root among the residues|has not the valuation"):
        check(first(there))  # H(Q) splits at 3: the place is read, over ℚ and not over ℚ(x)


def test_the_two_schemas_are_not_mixed() -> None:
    data = certified("s*y == y*s", "QQ", "identity", IDENTITY)
    with pytest.raises(Rejected, match="lacks the key 'ring'"):
        check({**first(data), "schema": "hfield-cert/2"})
    with pytest.raises(Rejected, match="unknown key 'ring'"):
        check({**data, "schema": "hfield-cert/1"})
    witness = {"kind": "witness", "values": {}}
    refuted = {**certified("1 == 2", "QQ", "identity", witness), "verdict": "refuted"}
    for own, field in (({"field": "QQ"}, "ring"), ({"ring": made.QQ, "field": "QQ"}, "field")):
        with pytest.raises(
            Rejected, match=f"the key '{field}'|unknown key '{field}'|unknown key 'field'"
        ):
            check({**refuted, "evidence": {**witness, **own}})
    both = first(refuted, {**witness, "ring": {"kind": "complexes"}, "field": "QQ"})
    assert check(both).field == "QQ"
    deep: Any = {"kind": "witness", "field": "QQ", "values": {}}
    for _ in range(130):
        deep = {"kind": "part", "part": 0, "evidence": deep}
    with pytest.raises(Rejected, match="the evidence nests too deeply"):
        check(first({**data, "statement": "every{1 == 2}"}, deep))
