"""Dear certificates about fields, groups of units and class sets: of large discriminant or level."""

import json
from collections.abc import Callable
from typing import Any

from hfield import QuaternionAlgebra, ring
from hfield.orders import certificates
from tests.adversary.hostile.writing import Hostile


def class_group(d: int) -> str:
    return json.dumps(ring(f"QQ(sqrt(-{d}))").class_group().certificate)


def unit_group(d: int) -> str:
    return json.dumps(ring(f"QQ(sqrt({d}))").unit_group().certificate)


def norm_one_group(level: int) -> str:
    order = QuaternionAlgebra("QQ", 1, 1).eichler_order(level)
    return json.dumps(order.norm_one_group().certificate)


def dirichlet_domain(level: int) -> str:
    order = QuaternionAlgebra("QQ", 1, 1).eichler_order(level)
    return json.dumps(order.norm_one_group().domain().certificate)


def embedding_orbits(conductor: int) -> str:
    order = QuaternionAlgebra(6).maximal_order()
    return json.dumps(order.embeddings(-24 * conductor**2).claim_of_orbits().certificate)


def group_over_integers(p: int, whole: bool = True) -> str:
    A = QuaternionAlgebra.from_text("(-1,sqrt(5)|QQ(sqrt(5)))")
    group = A.eichler_order(A.ring.primes_above(p)[0]).norm_one_group()
    return json.dumps((group if whole else group.domain()).certificate)


def domain_over_integers(p: int) -> str:
    return group_over_integers(p, whole=False)


def ideal_classes(p: int) -> str:
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    return json.dumps(A.eichler_order(A.ring.primes_above(p)[0]).class_set().certificate)


def newforms(p: int) -> str:
    classes = QuaternionAlgebra(p).maximal_order().class_set()
    return json.dumps(classes.claim_of_newforms(norm=2).certificate)


def weighted_newforms(weight: int) -> str:
    classes = QuaternionAlgebra(2).eichler_order(3).class_set()
    return json.dumps(classes.claim_of_newforms(weight, 5).certificate)


def repeated_newform(count: int) -> str:
    data = QuaternionAlgebra(11).eichler_order(3).class_set().claim_of_newforms(norm=2).certificate
    assert data is not None
    start, _, orbit = data["statement"].rstrip("}").rpartition("; ")
    data["statement"] = f"{start}; {'|'.join([orbit] * count)}}}"
    data["evidence"]["orbits"] *= count
    return json.dumps(data)


def over_zz(answer: Callable[[Any, Any, Any], Any]) -> Callable[[int], str]:
    """Return certificates about an Eichler order over the integers of ℚ(√5), an ideal and a moved order."""

    def make(p: int) -> str:
        A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
        order, x = A.eichler_order(A.ring.primes_above(p)[0]), A(1, 2, 0, 1)
        moved = (x * order * x.inverse()).left_order()
        return json.dumps(answer(order, list(order.class_set())[-1], moved).certificate)

    return make


def over_polynomials(answer: Callable[[Any, Any, Any], Any]) -> Callable[[int], str]:
    """Return certificates about an Eichler order over 𝔽₃[t] of level t^d, an ideal and a moved order."""

    def make(d: int) -> str:
        A = QuaternionAlgebra.from_ramification("GF(3)(t)", ["t+1", "inf"])
        order, x = A.eichler_order(f"t^{d}"), A(1, 2, 0, 1)
        moved = (x * order * x.inverse()).left_order()
        ideal = order.ideals_of_norm("t-1")[0]
        return json.dumps(answer(order, ideal, moved).certificate)

    return make


FILES: dict[str, Hostile] = {
    "class-group: a large discriminant": (class_group, 5, 40_031),
    "unit-group: a large discriminant": (unit_group, 2, 9_973),
    "norm-one-group: a large level": (norm_one_group, 2, 100),
    "dirichlet-domain: a large level": (dirichlet_domain, 2, 100),
    "embedding-orbits: a large discriminant": (embedding_orbits, 1, 101),
    "norm-one-group-over-integers: a large level": (group_over_integers, 11, 199),
    "dirichlet-domain-over-integers: a large level": (domain_over_integers, 11, 199),
    "ideal-classes: a large level": (ideal_classes, 11, 401),
    "newforms: a large level": (newforms, 11, 677),
    "newforms: a large weight": (weighted_newforms, 4, 30),
    "newforms: an orbit many times": (repeated_newform, 1, 3_000),
    "newforms-over-integers: a large level": (
        over_zz(lambda order, *_: order.class_set().claim_of_newforms()),
        31,
        401,
    ),
    "order-over-integers: a large level": (over_zz(lambda order, *_: order.claim), 11, 401),
    "ideal-over-integers: a large level": (
        over_zz(lambda _, ideal, __: ideal.claim),
        11,
        401,
    ),
    "unit-index: a large level": (
        over_zz(lambda order, *_: certificates.of_unit_index(order.value, order.unit_index())),
        11,
        401,
    ),
    "equivalent-over-integers: a large level": (
        over_zz(lambda _, ideal, __: ideal.is_principal().claim),
        31,
        401,
    ),
    "order-over-polynomials: a large level": (
        over_polynomials(lambda order, *_: order.claim),
        1,
        60,
    ),
    "ideal-over-polynomials: a large level": (
        over_polynomials(lambda _, ideal, __: ideal.claim),
        1,
        60,
    ),
    "unit-index-over-polynomials: a large level": (
        over_polynomials(
            lambda order, *_: certificates.of_unit_index(order.value, order.unit_index())
        ),
        1,
        60,
    ),
    "class-set-over-polynomials: a large level": (
        over_polynomials(lambda order, *_: order.class_set().claim),
        1,
        4,
    ),
    "equivalent-over-polynomials: a large level": (
        over_polynomials(lambda _, ideal, __: ideal.is_principal().claim),
        1,
        12,
    ),
    "isomorphic-over-polynomials: a large level": (
        over_polynomials(lambda order, ideal, _: order.isomorphism(ideal.left_order()).claim),
        2,
        6,
    ),
    "isomorphic-over-integers: a large level": (
        over_zz(lambda order, _, moved: order.isomorphism(moved).claim),
        11,
        401,
    ),
}
