"""Closed geodesics against class numbers, conjugacy against brute force, fundamental units against Pell."""

import math
import random
from itertools import pairwise

import pytest

from hfield import QuaternionAlgebra, ring
from hfield.core.factorisation import factorise
from hfield.errors import LatticeError, TooLargeError
from hfield.orders.linear_algebra_mod_p import kronecker


def group(D: int, N: int = 1):
    if D == 1:
        return QuaternionAlgebra("QQ", 1, 1).eichler_order(N).norm_one_group()
    A = QuaternionAlgebra.from_ramification("QQ", list(factorise(D)))
    return A.eichler_order(N).norm_one_group()


def narrow_class_number(d: int) -> int:
    """Cycles of reduced primitive forms (a, b, c) of the discriminant d > 0."""
    root = math.isqrt(d)
    forms = {
        (a, b, (b * b - d) // (4 * a))
        for b in range(1, root + 1)
        for a in range(-root - b, root + b + 1)
        if a and (b * b - d) % (4 * a) == 0 and abs(root - 2 * abs(a)) < b + (2 * abs(a) <= root)
    }
    forms = {f for f in forms if math.gcd(*f) == 1 and is_reduced(f, d)}
    count = 0
    while forms:
        count += 1
        start = f = next(iter(forms))
        while True:
            forms.discard(f)
            _, b, c = (
                f  # the form that comes next: (c, b', …) with b' = −b modulo 2c, as large as reduced
            )
            top = root if abs(c) <= root else abs(c)
            e = top - (top + b) % (2 * abs(c))
            f = (c, e, (e * e - d) // (4 * c))
            if f == start:
                break
    return count


def is_reduced(f: tuple[int, int, int], d: int) -> bool:
    a, b, _ = f
    return b > 0 and b * b < d and (2 * abs(a) - b) ** 2 < d < (2 * abs(a) + b) ** 2


def classes_of_trace(D: int, t: int) -> int:
    """Conjugacy classes of trace t in a maximal order, by optimal embeddings (Voight, 30.4.7 and 31.1.9)."""
    found = 0
    for f in range(1, t):
        d, rest = divmod(t * t - 4, f * f)
        if rest or d % 4 > 1:
            continue
        local = [
            0 if d % (p * p) == 0 and (d // (p * p)) % 4 < 2 else 1 - kronecker(d, p)
            for p in factorise(D)
        ]
        found += narrow_class_number(d) * math.prod(local)
    return found


@pytest.mark.parametrize("D", [6, 10, 14, 22])
def test_geodesics_are_counted_by_class_numbers(D: int) -> None:
    G, most = group(D), 9
    found = dict.fromkeys(range(3, most + 1), 0)
    for length, g in G.geodesics(2 * math.acosh(most / 2) + 1e-9):
        g = g if g.trace() > 0 else -g
        assert length == pytest.approx(2 * math.acosh(int(g.trace()) / 2))
        both = 1 if G.conjugator(g, g.conjugate()) is not None else 2  # two directions, or one
        power = g
        while (t := int(power.trace())) <= most:
            found[t] += both
            power *= g
    assert found == {t: classes_of_trace(D, t) for t in found}
    assert G.systole == pytest.approx(G.geodesics(5)[0].length)


def test_hurwitz_group() -> None:
    """The shortest geodesics of the triangle group (2, 3, 7); the first is 2·arccosh(½ + cos(2π/7))."""
    K = ring("QQ[s]/(s^3+s^2-2*s-1)")
    G = QuaternionAlgebra.from_ramification(K, K.real_places()[:2]).maximal_order().norm_one_group()
    found = G.geodesics(2)
    assert [round(g.length, 4) for g in found] == [0.984, 1.736]
    assert (
        G.systole
        == found[0].length
        == pytest.approx(2 * math.acosh(0.5 + math.cos(2 * math.pi / 7)))
    )
    x, y = found[0].element, found[1].element
    assert G.conjugator(x, y) is None
    for _, g in found:
        assert G.fundamental_unit(g**3) in (g, -g, g.conjugate(), -g.conjugate())


@pytest.mark.parametrize(("D", "N"), [(6, 1), (10, 3), (1, 11)])
def test_conjugacy(D: int, N: int) -> None:
    """Conjugates by random words are found; elliptic elements too."""
    G = group(D, N)
    rng = random.Random(D)
    letters = [n for m in range(1, len(G.generators) + 1) for n in (m, -m)]
    done = 0
    while done < 20:
        x, u = (G.evaluate(tuple(rng.choices(letters, k=rng.randrange(1, 6)))) for _ in range(2))
        if abs(x.trace()) == 2:
            continue
        y = u * x * u.conjugate()
        found = G.conjugator(x, y)
        assert found * x == y * found
        assert found in G.order
        assert found.norm() == 1
        assert G.conjugator(x, -y) is None or x.trace() == 0
        done += 1


def test_embeddings_up_to_conjugacy() -> None:
    """Those of ℤ[i] in a maximal order of discriminant 6: two, with both signs, for two elliptic points."""
    G = group(6)
    halves = [g for g in G.generators if g.trace() == 0]
    signed = [*halves, *(-g for g in halves)]
    classes: list = []
    for g in signed:
        if all(G.conjugator(g, c) is None for c in classes):
            classes.append(g)
    assert len(classes) == 4 - 2 * (len(halves) < 2)


@pytest.mark.parametrize(("a", "pell"), [(3, (2, 1)), (7, (8, 3)), (23, (24, 5))])
def test_fundamental_units(a: int, pell: tuple[int, int]) -> None:
    """In (a, −1|ℚ) that of i is the least solution of x² − a·y² = 1, where ℤ[√a] embeds optimally."""
    A = QuaternionAlgebra("QQ", a, -1)
    u = A.maximal_order().norm_one_group().fundamental_unit("i")
    x, y = pell
    assert u in (A(x, y, 0, 0), A(x, -y, 0, 0))
    # conjugate embeddings have conjugate units, and a power of it gives it back
    G = A.maximal_order().norm_one_group()
    assert G.fundamental_unit(u * u * u) in (u, u.conjugate())


def test_what_has_no_axis() -> None:
    G = group(1)
    A = G.order.algebra
    assert G.conjugator(2, 2) == 1
    assert G.conjugator(2, "1 + i") is None
    with pytest.raises(LatticeError, match="no axis"):
        G.fundamental_unit("i*j")
    with pytest.raises(LatticeError, match="parabolic"):
        G.conjugator(1 + A("i + k"), 1 - A("i + k"))
    with pytest.raises(LatticeError, match="cusps"):
        G.fundamental_unit("i")
    with pytest.raises(LatticeError, match="cusps"):
        G.geodesics(1)
    with pytest.raises(TooLargeError, match="choose a smaller length"):
        group(6).geodesics(30)


def test_lengths_ascend() -> None:
    found = group(15).geodesics(5)
    assert all(x.length <= y.length for x, y in pairwise(found))
    assert len({g.element for g in found}) == len(found)
