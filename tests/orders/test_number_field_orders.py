"""Orders and ideals over the integers of number fields: identities, brute force over residue fields."""

import pickle
from collections import Counter
from collections.abc import Iterator
from itertools import product
from random import Random

import flint
import pytest

from hfield import LatticeError, QuaternionAlgebra, ring
from hfield.errors import TooLargeError
from hfield.orders.generated_orders import checked_ring
from hfield.orders.lattice import Lattice, Order
from hfield.orders.orders_at_primes import OrderAtPrime
from tests.subcases import first_quick, share_quick
from tests.thorough import part

# class numbers 1 and more, algebras ramified at finite places and not; the last with a generator of K that is
# no integer
ALGEBRAS = ["(-1,-1|QQ(sqrt(5)))", "(-1,-3|QQ(sqrt(10)))", "(2,5|QQ(sqrt(-5)))",
            "(-1,-1|QQ[s]/(s^3-s^2-2*s+1))", "(-3,7|QQ(sqrt(-23)))",
            "(-1,-1|QQ[s]/(s^4-s^3-3*s^2+s+1))", "(8+3*s,4+7*s|QQ[s]/(2*s^2-3))"]  # fmt: skip


def split_primes(A, *numbers):
    ramified = A.ramified_places()
    return [P for p in numbers for P in A.ring.primes_above(p) if P not in ramified]


@pytest.mark.parametrize("name", share_quick(ALGEBRAS, 3))
def test_eichler_orders(name: str) -> None:
    A = QuaternionAlgebra(name)
    M = A.maximal_order()
    P, Q = split_primes(A, 2, 3, 5, 7, 11)[:2]
    O = A.eichler_order([(P, 3), (Q, 1)])
    assert checked_ring(O.value) == O.value
    assert M >= O
    assert M.index(O) == O.level == A.ring.ideal(P) ** 3 * A.ring.ideal(Q)
    assert O.discriminant() == M.discriminant() * O.level
    assert O.norm_of_discriminant() == O.discriminant().norm()
    assert (O.local_index(P), O.local_index(Q)) == (3, 1)
    assert O.eichler_symbol(P) == O.eichler_symbol(Q) == 1
    assert O.is_eichler()
    assert not O.is_maximal()
    larger = O.maximal_overorder()
    assert larger.is_maximal()
    assert larger >= O
    assert O == A.eichler_order(O.level)


def test_levels_where_residues_are_fractions_in_the_generator() -> None:
    A = QuaternionAlgebra("(8+3*s,4+7*s|QQ[s]/(2*s^2-3))")
    for level in (7, 7 * 11**2):
        assert A.maximal_order() >= A.eichler_order(level)


@pytest.mark.parametrize("name", first_quick(part(ALGEBRAS, 2), 1))
def test_ideals_of_prime_norm_are_all_of_them(name: str) -> None:
    """Against all right ideals x·O + P·O with x modulo P, for orders of every Eichler symbol."""
    A = QuaternionAlgebra(name)
    P = min(A.ring.primes_above(2), key=lambda P: P.p**P.f)
    orders = [A.maximal_order(), A.order([x * 2 for x in A.maximal_order().basis])]
    if P in split_primes(A, 2):
        orders += [A.eichler_order([(P, 1)]), A.eichler_order([(P, 2)])]
    for O, e in product(orders, (1, 2) if P.p**P.f < 8 else (1,)):
        found = O.ideals_of_norm(A.ring.ideal(P) ** e, side="right")
        assert len(found) == len(set(found))
        for I in found[::e]:
            assert I.norm() == A.ring.ideal(P) ** e
            assert I.right_order() == O
            assert I.is_invertible()
        if P.p**P.f == 2:
            assert set(found) == by_brute_force(O, P, e)


def by_brute_force(O: Order, P: object, e: int) -> set:
    A = O.algebra
    prime = A.ring.ideal(P) ** e
    rows = flint.fmpz_mat([[int(c) for c in O.coordinates(x)] for x in (O * prime).basis]).hnf()
    diagonal = [range(int(rows[n, n])) for n in range(rows.nrows())]
    out = set()
    for c in product(*diagonal):
        x = sum((n * q for n, q in zip(c, O.basis, strict=True)), A(0))
        I = O.right_ideal([x, *(prime * O).basis])
        if I.norm() == prime and O.index(I) == prime**2:
            out.add(I)
    return out


# --- above and below -------------------------------------------------------------------------------


def lattices_of_index(O: Order, P: object, k: int) -> Iterator[Lattice]:
    """All lattices of index Pᵏ in O, for P of norm 2, by Hermite forms over the integers."""
    A = O.algebra
    at = OrderAtPrime(O.value, O.value.ambient.base.prime(P))
    basis = [O.value.ambient.quaternion(x.entries()) for x in at.basis_modulo_prime]
    below = (O * A.ring.ideal(P) ** k).basis
    for powers in product(range(k + 1), repeat=4):
        if sum(powers) != k:
            continue
        places = [(r, c) for r in range(4) for c in range(r + 1, 4)]
        for entries in product(*(range(2 ** powers[c]) for _, c in places)):
            rows = [2 ** powers[r] * q for r, q in enumerate(basis)]
            for (r, c), x in zip(places, entries, strict=True):
                rows[r] = rows[r] + x * basis[c]
            yield A.lattice([*rows, *below])


def is_ring(L: Lattice) -> bool:
    return 1 in L and L * L == L


def test_suborders_are_all_lattices_that_are_rings() -> None:
    A = QuaternionAlgebra("(-1,-3|QQ(sqrt(-7)))")
    P = A.ring.primes_above(2)[0]
    assert P not in A.ramified_places()
    for O in (A.maximal_order(), A.eichler_order([(P, 2)])):
        for k in (1, 2):
            found = O.suborders(P, k)
            assert len(found) == len(set(found))
            assert set(found) == {L for L in lattices_of_index(O, P, k) if is_ring(L)}
            assert all(O.index(L) == A.ring.ideal(P) ** k for L in found)


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["(-1,-3|QQ(sqrt(-7)))", "(-1,-1|QQ(sqrt(2)))", "(-1,5|QQ(sqrt(-7)))"]
)
def test_overorders_and_what_is_gorenstein_or_bass(name: str) -> None:
    A = QuaternionAlgebra(name)
    P = A.ring.primes_above(2)[0]
    M = A.maximal_order()
    below = [M.suborders(P, k) for k in range(4)]
    symbols = set()
    for k, orders in enumerate(below):
        twice = [A.order((M * A.ring.ideal(P)).basis)] if k == 3 else []
        for O in orders[:: len(orders) // 4 + 1] + twice:
            above = [O.overorders(P, n) for n in range(k + 1)]
            for n, larger in enumerate(above):
                assert all(O in X.suborders(P, n) for X in larger[:1])
                assert {X for X in below[k - n] if X >= O} <= set(larger)
                assert set(larger) <= {X for X in larger if is_ring(X) and O <= X}
            assert O.overorders(P, O.local_index(P) + 1) == []
            assert O.is_gorenstein() == O.dual().is_invertible()
            assert O.is_bass() == all(X.is_gorenstein() for larger in above for X in larger)
            G, f = O.gorenstein_closure(), O.conductor()
            assert G.is_gorenstein()
            assert is_ring(G)
            assert A.lattice([*(G * f).basis, 1]) == O
            assert O.discriminant() == G.discriminant() * f**3
            symbols.add((O.eichler_symbol(P), O.is_bass(), O.is_gorenstein()))
    assert len(symbols) > 4


@pytest.mark.parametrize("name", ALGEBRAS)
def test_duals(name: str) -> None:
    A = QuaternionAlgebra(name)
    O = A.maximal_order()
    dual = O.dual()
    n = O.value.ambient.degree
    traces = [(x * y).trace() for x in dual.basis[: 2 * n] for y in O.basis]
    assert all(x in A.ring.ideal(1) for x in traces if x)
    assert dual.dual() == O
    assert dual.index(O) == O.discriminant() ** 2
    I = O.right_ideal([3, A(1, 1, 0, 1)])
    assert I.dual().dual() == I
    assert I.dual().left_order() == O


# --- ideals ----------------------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize("name", ALGEBRAS)
def test_connecting_and_two_sided_ideals(name: str) -> None:
    A = QuaternionAlgebra(name)
    P, Q = split_primes(A, 2, 3, 5, 7, 11)[:2]
    for O in (A.maximal_order(), A.eichler_order([(P, 2)])):
        for prime in (P, Q, *(R for R, _ in A.maximal_order().discriminant().factorisation())):
            W = O.two_sided_prime(prime)
            e = max(O.discriminant().valuation(prime), 1)
            assert W.left_order() == W.right_order() == O
            assert W * W == O * A.ring.ideal(prime) ** (
                e if e > 1 or O.eichler_symbol(prime) else 2
            )
            I = O.ideals_of_norm(A.ring.ideal(prime))[-1]
            other = I.right_order()
            J = O.connecting_ideal(other)
            assert J.left_order() == O
            assert J.right_order() == other
            assert J.is_integral()
            assert J.primitive_part() == (J, A.ring.ideal(1))
            assert (J * A.ring.ideal(Q)).primitive_part() == (J, A.ring.ideal(Q))
            assert J.inverse() * J == other
            if A.ring.degree > 2:
                continue
            far = other.ideals_of_norm(A.ring.ideal(prime))[0].right_order()
            J = O.connecting_ideal(far)
            assert (J.left_order(), J.right_order()) == (O, far)
            assert J.inverse() * J == far
    with pytest.raises(LatticeError, match="one level"):
        A.maximal_order().connecting_ideal(A.eichler_order([(P, 1)]))


@pytest.mark.parametrize("name", ALGEBRAS)
def test_ideals_that_are_not_invertible(name: str) -> None:
    A = QuaternionAlgebra(name)
    M = A.maximal_order()
    O = A.order([2 * x for x in M.basis])  # ℤ_K + 2M
    I = O.left_ideal([2 * x for x in M.basis])
    assert O.conductor() == A.ring.ideal(2)
    assert not I.is_invertible()
    assert I.left_order() == M
    assert I.order == O
    with pytest.raises(LatticeError, match="not invertible"):
        I.inverse()
    x = A(3, 1, 0, 0)
    J = O.left_ideal([x])
    assert J.is_invertible()
    assert J * J.inverse() == O
    assert J.right_order() == x.inverse() * O * x
    assert (J.left_order(), J.side, (J * x).left_order()) == (O, "left", O)
    assert J.conjugate().side == "right"
    assert J + J == J & J == J


def test_what_is_refused() -> None:
    A = QuaternionAlgebra("(-1,-3|QQ(sqrt(10)))")
    K = A.ring
    three = K.primes_above(3)[0]
    with pytest.raises(LatticeError, match="in common"):
        A.eichler_order([(three, 1)])
    with pytest.raises(LatticeError, match="in common"):
        A.eichler_order(6)
    with pytest.raises(LatticeError, match="ideal of integers as the level"):
        A.eichler_order(K.ideal(K(1) / 2))
    with pytest.raises(LatticeError, match="not a pair"):
        A.eichler_order([(three, -1)])
    with pytest.raises(LatticeError, match="not a prime ideal"):
        A.maximal_order().local_index(6)
    with pytest.raises(LatticeError, match="rank 2"):
        A.order(["i"])
    with pytest.raises(LatticeError, match="not both integers"):
        A.order(["1/2*i", "j"])
    B = QuaternionAlgebra("(-1,-1|QQ(sqrt(10)))")
    with pytest.raises(LatticeError, match="generate no order"):
        B.order(["i", "3/5*i + 4/5*j"])
    with pytest.raises(LatticeError, match="ideal of integers"):
        A.maximal_order().ideals_of_norm(K(1) / 2)
    O = A.order(["i", "j"])
    assert not O.is_maximal()
    assert "times ideal" in O.is_maximal().reason
    assert O.maximal_overorder().is_maximal() == True  # noqa: E712
    with pytest.raises(LatticeError, match="two-sided"):
        A.order(["2*i", "2*j"]).two_sided_prime(K.primes_above(2)[0])


@pytest.mark.slow
def test_maximal_orders_have_the_discriminants_of_pari() -> None:
    pari = pytest.importorskip("cypari", reason="cypari is not installed (extra 'oracles')").pari
    pari.allocatemem(10**9, silent=True)
    rng, compared = Random(5), 0
    for f in ("s^2-5", "s^2-10", "s^2+23", "s^3-s^2-2*s+1", "s^4-s^3-3*s^2+s+1"):
        K = ring(f"QQ[s]/({f})")
        for _ in range(3):
            a, b = (K(rng.randint(1, 9)) + K.gen * rng.randint(-9, 9) for _ in range(2))
            numbers = ",".join(f"Mod({K.text(x)},{f})" for x in (a, b)).replace("s", "y")
            try:
                theirs = pari(f"alginit(nfinit({f.replace('s', 'y')}),[{numbers}])")
            except Exception:  # PARI takes no slot that is a square
                continue
            # the form of the trace of left multiplications, over ℤ: twice the reduced trace
            N = QuaternionAlgebra(K, a, b).maximal_order().norm_of_discriminant()
            assert (
                abs(int(pari.algdisc(theirs))) == 2 ** (4 * K.degree) * K.discriminant() ** 4 * N**2
            )
            compared += 1
    assert compared > 8


def test_what_is_pickled_comes_back() -> None:
    O = QuaternionAlgebra("(-1,-3|QQ(sqrt(10)))").eichler_order(7)
    I = O.right_ideal([3, "1 + i"])
    for L in (O, I, O + I, I.conjugate()):
        other = pickle.loads(pickle.dumps(L))
        assert (type(other), other) == (type(L), L)
    assert pickle.loads(pickle.dumps(I)).order == O


@pytest.mark.parametrize("name", ALGEBRAS)
def test_bases_coordinates_and_two_sided_ideals(name: str) -> None:
    A = QuaternionAlgebra(name)
    O = A.eichler_order(split_primes(A, 2, 3, 5, 7, 11)[0])
    den, rows = O.hnf
    n = len(rows)
    assert n == 4 * A.ring.degree
    assert all(rows[r][c] == 0 for r in range(n) for c in range(r))
    assert all(0 <= rows[r][c] < rows[c][c] for c in range(n) for r in range(c))
    assert A.lattice(O.basis[::-1]).hnf == (den, rows)
    x = A(2, 1, 0, 3)
    assert sum((q * c for q, c in zip(O.basis, O.coordinates(x), strict=True)), A(0)) == x
    T = O.two_sided_ideal([x * den])
    assert O * T == T * O == T
    assert x * den in T


@pytest.mark.parametrize(("name", "bound"), [("QQ(sqrt(5))", 10), ("QQ(zeta7)+", 12)])
def test_ternary_theta_series_count_elements(name: str, bound: int) -> None:
    A, seen = QuaternionAlgebra(name, -1, -1), set()
    for O in (A.maximal_order(), A.order(["i", "j"])):
        around = A.lattice([1, *(2 * q for q in O.basis)])
        short = around.elements_of_norm_at_most(bound)
        found = Counter(x.norm() for x in short if x.trace() == 0)
        assert O.ternary_theta_series(bound) == found
        seen |= set(found)
    assert len(seen) > 2


def test_random_ideals_have_cyclic_quotients() -> None:
    A = QuaternionAlgebra("QQ(sqrt(5))", -1, -1)
    O, K = A.eichler_order(3), A.ring
    P = K.primes_above(11)[0]
    assert len({O.random_ideal(P, seed=n) for n in range(100)}) == 12
    norm = K.ideal(11) ** 2 * 2**3
    for side in ("left", "right"):
        for seed in range(2):
            I = O.random_ideal(norm, side, seed)
            assert (I.side, I.order, I.norm(), I.primitive_part()[1]) == (side, O, norm, 1)
            assert I.is_invertible()
            assert I == O.random_ideal(norm, side, seed)
    with pytest.raises(LatticeError, match="divides both"):
        O.random_ideal(3)


def test_long_primes() -> None:
    """As over ℤ: residues are of any size."""
    p = 10**40 + 121
    A = QuaternionAlgebra("QQ[s]/(s^2-5)", -1, -1)
    P = A.ring.primes_above(p)[0]
    O, prime = A.maximal_order(), A.ring.ideal(P)
    I = O.random_ideal(prime**2, seed=1)
    assert (I.norm(), I.is_invertible(), I.primitive_part()[1]) == (prime**2, True, 1)
    J = O.connecting_ideal(I.right_order())
    assert (J.left_order(), J.right_order()) == (O, I.right_order())
    E = A.eichler_order([(P, 2)])
    assert (E.level, E.eichler_symbol(P), E.is_eichler()) == (prime**2, 1, True)
    assert E.maximal_overorder().is_maximal()
    third = A.order([q * p for q in O.basis])
    assert (third.conductor(), third.gorenstein_closure()) == (A.ring.ideal(p), O)
    with pytest.raises(TooLargeError):
        O.ideals_of_norm(prime)
