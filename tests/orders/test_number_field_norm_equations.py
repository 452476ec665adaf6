"""Embeddings of quadratic orders and elements of given norm, over number fields, against enumeration."""

import pytest

from hfield import IndefiniteError, LatticeError, QuaternionAlgebra, TooLargeError, ring
from hfield.orders import quadratic_orders, short_elements
from hfield.orders.kernels import general


def elements_of_norm(O, n):
    found = short_elements.rows_of_norm(O.value, O.value.ambient.base.inside(n))
    both = (sign * O.value.ambient.quaternion(row.entries()) for row in found for sign in (1, -1))
    return set(both)


@pytest.mark.parametrize(
    "name", ["(-1,-1|QQ(sqrt(5)))", "(-1,-1|QQ(sqrt(2)))", "(-1,-3|QQ(sqrt(10)))"]
)
def test_embeddings(name: str) -> None:
    A = QuaternionAlgebra(name)
    K = A.ring
    P = next(P for P in K.primes_above(5) if P not in A.ramified_places())
    for O in (A.eichler_order([(P, 1)]), A.order(["i", "j"])):
        for d, t in ((-3, 1), (-4, 0), (-12, 0)):
            found = O.embeddings(d)
            n = K(t * t - d) / 4
            every = {x for x in elements_of_norm(O, n) if x.trace() == t}
            optimal = {x for x in every if not _lies_in_a_larger_order(O, x, d)}
            assert set(found.elements) == optimal
            assert bool(found) == (found.element is not None) == bool(optimal)
            assert 0 <= found.orbits <= len(found)
            if found:
                assert found.element**2 - t * found.element + n == 0


def _lies_in_a_larger_order(O, x, d) -> bool:
    """Tell whether (x − c)/π is in O for all 1/π in P⁻¹, for some c modulo P."""
    K = O.algebra.ring
    for P, _ in K.ideal(d).factorisation():
        base = O.value.ambient.base
        inverses = (K.ideal(P) ** -1).basis
        for c in map(base.outside, base.residues(base.prime(P))):
            if all((x - c) * y in O for y in inverses):
                return True
    return False


def test_icosians_of_order_3_4_and_10() -> None:
    A = QuaternionAlgebra("(-1,-1|QQ(sqrt(5)))")
    s = A.ring.gen
    O = A.maximal_order()
    numbers = [O.embeddings(d) for d in (-3, -4, -(5 + s) / 2, -(5 - s) / 2)]
    assert [len(x) for x in numbers] == [20, 30, 12, 12]
    assert [x.orbits for x in numbers] == [1, 1, 1, 1]
    for wrong in (3, -5, s, 0, A.ring(-3) / 4):
        with pytest.raises(LatticeError, match="not a discriminant"):
            O.embeddings(wrong)
    with pytest.raises(IndefiniteError):
        QuaternionAlgebra("(-1,3|QQ(sqrt(5)))").maximal_order().embeddings(-3)


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["(-1,-1|QQ(sqrt(2)))", "(-1,-3|QQ(sqrt(10)))", "(-1,-1|QQ(sqrt(5)))"]
)
def test_norms_small_and_large(name: str) -> None:
    A = QuaternionAlgebra(name)
    K = A.ring
    M = A.maximal_order()
    small = [K(a) + b * K.gen for a, b in ((2, 1), (3, 0))]
    for O in (M, A.order([2 * x for x in M.basis]), A.order(["i", "j"])):
        for n in small:
            x = O.represent_integer(n)
            places = O.value.ambient.base.field.real_places()
            positive = all(v.sign(O.value.ambient.base.inside(n)) > 0 for v in places)
            assert (x is not None) == (positive and bool(elements_of_norm(O, n)))
            assert x is None or (x in O and x.norm() == n)
            obstructed = any(
                quadratic_orders.is_obstructed(
                    O.value,
                    O.value.ambient.base.prime(P),
                    O.value.ambient.base.inside(n),
                )
                for P, _ in O.discriminant().factorisation()
            )
            assert x is None or not obstructed
    for n in (10**9 + 7, 10**6 * 31 * (12 + K.gen)):
        x = M.represent_integer(n)
        assert x in M
        assert x.norm() == n
    twice = A.order([2 * x for x in M.basis])  # ℤ_K + 2M: no norm has the valuation 1
    assert twice.represent_integer((10**20 + K.gen) * (2 if K.discriminant() == 5 else 1)) is None
    assert M.represent_integer(0) == 0
    assert M.represent_integer(K(1) / 2) is None
    assert M.represent_integer(-1) is None


def test_what_a_prime_forbids() -> None:
    A = QuaternionAlgebra("(-1,-1|QQ(sqrt(17)))")
    M = A.maximal_order()
    O = A.order([8 * x for x in M.basis])  # ℤ_K + 8M: odd norms are 1 modulo 8
    prime = O.value.ambient.base.prime(A.ring.primes_above(2)[0])
    for n, forbidden in ((1, False), (4, False), (5, True), (9, False)):
        assert (
            quadratic_orders.is_obstructed(O.value, prime, O.value.ambient.base.inside(n))
            == forbidden
        )


def test_short_elements_and_units() -> None:
    A = QuaternionAlgebra("(-1,-1|QQ(sqrt(3)))")
    O = A.eichler_order(A.ring.primes_above(11)[0])
    units = O.units()
    assert len(units) == O.unit_index()
    assert all(u in O and u.inverse() in O for u in units)
    assert len({O.right_ideal([u]) for u in units}) == 1
    I = O.ideals_of_norm(5)[0]
    short = I.shortest()

    def trace(n):
        return O.value.ambient.base.inside(n).trace()

    least = {trace(x.norm()) for x in short}
    assert len(least) == 1
    assert all(x in I and -x in short for x in short)
    basis = I.reduced_basis()
    assert A.lattice(basis) == I
    assert min(least) == min(trace(q.norm()) for q in basis)
    for n in (5, 10 + 5 * A.ring.gen):
        assert set(I.elements_of_norm(n)) == {x for x in elements_of_norm(I, n) if x in I}
    assert I.elements_of_norm(-1) == I.elements_of_norm(A.ring.gen) == ()
    assert I.elements_of_norm(0) == (A(0),)


@pytest.mark.parametrize("d", [5, 2, 13, 17])
def test_theta_series_of_one_class(d: int) -> None:
    """r(ν) = r(1)·σ(ν): elements generate ideals of norm ν, up to units of norm 1 (Voight, ch. 26)."""
    K = ring(f"QQ(sqrt({d}))")
    O = QuaternionAlgebra.from_ramification(K, K.real_places()).maximal_order()
    series = O.theta_series(7)
    assert series.pop(K.zero) == 1
    for x, count in series.items():
        sigma = 1
        for P, e in K.ideal(x).factorisation():
            sigma *= sum(int(P.p**P.f) ** k for k in range(e + 1))
        assert count == len(O.elements_of_norm(1)) * sigma
    halves = (
        K(n) / 2 + K.gen * m / 2 for n in range(1, 8) for m in range(-7, 8) if m * m * d < n * n
    )
    assert list(map(K.trace, series)) == sorted(map(K.trace, series))
    assert set(series) == {x for x in halves if x in K.ideal(1)}


def test_theta_series_of_lattices(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of an order with several classes, and an ideal of it, elements of norm ν are listed one by one."""
    A = QuaternionAlgebra("(-1,-3|QQ(sqrt(10)))")
    O = A.maximal_order()
    for L in (O, O.left_ideal([3, "1 + i + j"])):
        for x, count in L.theta_series(6).items():
            assert len(L.elements_of_norm(x)) == count
    with pytest.raises(IndefiniteError):
        QuaternionAlgebra("(-1,3|QQ(sqrt(5)))").maximal_order().theta_series(3)
    monkeypatch.setattr(general, "MAX_COUNTED", 4)
    with pytest.raises(TooLargeError, match="more than 4 elements have norms of trace at most 6"):
        O.theta_series(6)
