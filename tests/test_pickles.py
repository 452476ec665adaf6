"""Pickles and copies of public objects, fresh and with every cache filled."""

import copy
import functools
import pickle
from collections.abc import Callable
from contextlib import suppress

import flint
import pytest

import rotation
from hfield import GF, QQ, ClassSet, H, Order, QuaternionAlgebra, prove, ring
from hfield.errors import HFieldError
from hfield.fuchsian.group import NormOneGroup

PICKLED: list[Callable[[object], object]] = [
    lambda x: pickle.loads(pickle.dumps(x)),
    copy.deepcopy,
    copy.copy,
]


@functools.cache
def classes() -> ClassSet:
    return QuaternionAlgebra(37).maximal_order().class_set()


@functools.cache
def group() -> NormOneGroup:
    return QuaternionAlgebra(6).maximal_order().norm_one_group()


def over(base: str, *constants: object) -> Order:
    return QuaternionAlgebra(base, *constants).maximal_order()


def over_polynomials() -> Order:
    return QuaternionAlgebra.from_ramification("GF(3)(t)", ["t", "inf"]).maximal_order()


OBJECTS: dict[str, Callable[[], object]] = {
    "a class set": classes,
    "a class set over a field": lambda: over("QQ(sqrt(5))", -1, -1).class_set(),
    "a class set over polynomials": lambda: over_polynomials().class_set(),
    "a newform": lambda: classes().newforms()[0],
    "a rational newform": lambda: classes().rational_newforms()[0],
    "a group": group,
    "a domain": lambda: group().domain(),
    "a CM point": lambda: group().cm_points(-24)[0],
    "embeddings": lambda: over("QQ", -1, -11).embeddings(-4),
    "embeddings in an indefinite order": lambda: over("QQ", 3, -1).embeddings(-24),
    "an ideal": lambda: over("QQ", -1, -11).left_ideal([3, "1 + i"]),
    "a class group": lambda: ring("QQ(sqrt(-23))").class_group(),
    "a unit group": lambda: ring("QQ(sqrt(5))").unit_group(),
    "a splitting over GF(9)": lambda: H(GF(9)).split(),
    "units": lambda: H(GF(3)).units(),
    "the group of units": lambda: H(GF(3)).unit_group(),
    "a conjugacy class": lambda: H(GF(3)).conjugacy_classes()[-1],
    "an ideal of a finite algebra": lambda: H(GF(3)).left_ideals()[1],
    "subalgebras over GF(4)": lambda: H(GF(4)).subalgebras(dimension=2),
    "automorphisms over GF(2)": lambda: H(GF(2)).automorphism_group(),
    "an answer": lambda: prove("p*q == q*p", field=GF(3)),
    "a polynomial": lambda: H(QQ)(1, 2, 3, 0).minimal_polynomial(),
    "roots": lambda: H(QQ).polynomials()("x^2 + 1").roots(),
    "an element over GF(9)": lambda: H(GF(9))(1, "x", 0, 2),
    "symbols": lambda: H(QQ).unknowns("p"),
    "rotations": lambda: rotation.Rotation.random(3, seed=1),
}
"""Objects that store, or cache, values of flint; and others."""


def fill(x: object) -> None:
    """Compute every cached property of an object."""
    for cls in type(x).__mro__:
        for name, attribute in vars(cls).items():
            if isinstance(attribute, functools.cached_property):
                with suppress(HFieldError, AttributeError):
                    getattr(x, name)


@pytest.mark.parametrize("name", OBJECTS)
def test_objects_pickle_in_every_state(name: str) -> None:
    x = OBJECTS[name]()
    for state in ("fresh", "filled"):
        if state == "filled":
            fill(x)
        for again in PICKLED:
            found = again(x)
            assert type(found) is type(x)
            assert repr(found) == repr(x)


def test_pickles_compute_what_their_originals_do() -> None:
    for x in (group(), group().domain(), group().cm_points(-24)[0]):
        assert pickle.loads(pickle.dumps(x)) == x
    found = pickle.loads(pickle.dumps(classes()))
    assert list(found) == list(classes())
    assert found.brandt_matrix(2) == classes().brandt_matrix(2)
    units = H(GF(3)).units()
    assert list(pickle.loads(pickle.dumps(units))) == list(units)


def values_of_flint() -> list[object]:
    large = flint.fmpz_mod_ctx(10**30 + 57)
    field, two = flint.fq_default_ctx(3, 2, "x"), flint.fq_default_ctx(2, 100, "y")
    half = flint.fmpq(1, 2)
    several = [
        flint.fmpz_mpoly_ctx.get(("x", "y"), "degrevlex"),
        flint.fmpq_mpoly_ctx.get(("x", "y"), "lex"),
        flint.nmod_mpoly_ctx.get(("x", "y"), 7, "lex"),
        flint.fmpz_mod_mpoly_ctx.get(("x", "y"), 101, "deglex"),
    ]
    return [
        *(x**2 * y - 3 * x + 5 for x, y in (context.gens() for context in several)),
        flint.fmpz_mat([[1, -(2**80)], [3, 4]]), flint.fmpz_mat(0, 4),
        flint.fmpq_mat(1, 2, [1, half]), flint.fmpq_mat(0, 3),
        flint.fmpz_poly([]), flint.fmpz_poly([1, 2]), flint.fmpq_poly([1, half]),
        flint.nmod(2**63, 2**64 - 1), flint.nmod_poly([1, 2], 7), flint.nmod_mat([[1, 2]], 7),
        large(3), large(0), flint.fmpz_mod_poly_ctx(large)([1, 2, -1]),
        field, two, field(0), field(1), field.gen(), two.gen() ** 77,
        flint.fq_default_poly_ctx(field)([1, field.gen()]),
    ]  # fmt: skip


def test_values_of_flint() -> None:
    for x in values_of_flint():
        for again in PICKLED:
            found = again(x)
            assert type(found) is type(x)
            assert found == x
    for ball in (flint.arb(2).sqrt(), flint.arb(0, 1), flint.arb("nan")):
        assert repr(pickle.loads(pickle.dumps(ball))) == repr(ball)
