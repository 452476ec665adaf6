"""``QQ[s]/(s-c)``, the number field of degree 1, as data of a ring, and certificates over it."""

import json
from fractions import Fraction
from typing import Any

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.checker.check import check
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.number_fields import NumberField

K = ring("QQ[s]/(s-3)")
A = QuaternionAlgebra(K, -1, -11)
ORDER = A.maximal_order()
IDEAL = ORDER.left_ideal([K.gen, "1+j"])
CONJUGATOR = A("1+i")
CONJUGATE = A.order_from_basis([CONJUGATOR * x / CONJUGATOR for x in ORDER.basis])
GROUP = QuaternionAlgebra(K, 3, -1).maximal_order().norm_one_group()
CERTIFIED: dict[str, Any] = {
    "order": ORDER,
    "Eichler order": A.eichler_order(3),
    "class set": A.eichler_order(3).class_set(),
    "ideal": IDEAL,
    "no generator": IDEAL.is_principal(),
    "equivalence": IDEAL.equivalence(IDEAL * CONJUGATOR),
    "isomorphism": ORDER.isomorphism(CONJUGATE),
    "group": GROUP,
    "domain": GROUP.domain(),
    "class group": K.class_group(),
    "unit group": K.unit_group(),
}


@pytest.mark.parametrize("name", CERTIFIED)
def test_certificates_are_accepted(name: str) -> None:
    data = json.loads(json.dumps(CERTIFIED[name].certificate))
    assert data["ring"] == {"kind": "number field", "modulus": [-3, 1], "variable": "s"}
    found = check(data)
    assert found.verdict == ("refuted" if name == "no generator" else "proved")


@pytest.mark.parametrize(("old", "new"), [("; 11}", "; 22}"), ("1/2,0,0,1/2", "1/2,0,0,0")])
def test_false_statements_are_rejected(old: str, new: str) -> None:
    data = dict(ORDER.certificate)
    assert old in data["statement"]
    data["statement"] = data["statement"].replace(old, new)
    with pytest.raises(Rejected):
        check(data)


def test_the_number_of_classes_is_checked() -> None:
    C = A.eichler_order(3).class_set()
    data = json.loads(json.dumps(C.certificate).replace(f"; {len(C)}}}", f"; {len(C) - 1}}}"))
    data["evidence"]["classes"].pop()
    with pytest.raises(Rejected, match="mass"):
        check(data)


@pytest.mark.parametrize("modulus", [[1], [], [0, 2], [1, 0]])
def test_a_modulus_is_monic_and_of_degree_at_least_one(modulus: list[int]) -> None:
    data = dict(ORDER.certificate)
    data["ring"] = {**data["ring"], "modulus": modulus}
    with pytest.raises(Rejected, match=r"modulus|monic"):
        check(data)


def test_the_generator_is_its_rational_number() -> None:
    """The root of s − 3 is 3, in the product and in the checker."""
    assert ORDER.left_ideal([K.gen, "1+j"]) == ORDER.left_ideal([3, "1+j"])
    field = NumberField("QQ[s]/(s-3)", [Fraction(-3), Fraction(1)], ("name", "s"), "s")
    assert field.generator == field.number(3)
    assert field.mul(field.generator, field.inverse(field.generator)) == field.one
