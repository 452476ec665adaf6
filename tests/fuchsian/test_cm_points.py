"""Embeddings in indefinite orders and CM points, against formulas, genera and local obstructions."""

import json
from collections import Counter
from math import gcd, isqrt
from pathlib import Path
from random import Random

import pytest

from hfield import H, IndefiniteError, LatticeError, Order, QuaternionAlgebra, check, ring
from hfield.cli import main
from hfield.core.factorisation import factorise
from tests.subcases import subcases

DISCRIMINANTS = [d for d in range(-3, -40, -1) if d % 4 < 2]


def order(D: int, N: int = 1) -> Order:
    return QuaternionAlgebra.from_ramification("QQ", list(factorise(D))).eichler_order(N)


def class_number(d: int) -> int:
    """Count the reduced forms of discriminant d < 0."""
    forms = 0
    for a in range(1, isqrt(-d // 3) + 1):
        for b in range(-a + 1, a + 1):
            c, rest = divmod(b * b - d, 4 * a)
            if not rest and (c > a or (c == a and b >= 0)) and gcd(a, b, c) == 1:
                forms += 1
    return forms


def eichler_symbol(d: int, p: int) -> int:
    """Return 1 where p divides the conductor, else the Kronecker symbol (d/p)."""
    if d % (p * p) == 0 and d // (p * p) % 4 < 2:
        return 1
    if p == 2:
        return 0 if d % 2 == 0 else 1 if d % 8 == 1 else -1
    return 0 if d % p == 0 else 1 if pow(d, (p - 1) // 2, p) == 1 else -1


def expected_points(D: int, N: int, d: int) -> int:
    """Return the number of CM points by the class number formula, for a squarefree level."""
    count = class_number(d)
    for p in factorise(D) if D > 1 else ():
        count *= 1 - eichler_symbol(d, p)
    for p in factorise(N) if N > 1 else ():
        count *= 1 + eichler_symbol(d, p)
    return count


@subcases("D, N", [(6, 1), (10, 1), (6, 5), (15, 2), (1, 1), (1, 6), (1, 11)])
def test_the_number_of_points_is_that_of_the_formula(D: int, N: int) -> None:
    G = order(D, N).norm_one_group()
    for d in DISCRIMINANTS:
        points = G.cm_points(d)
        assert len(points) == expected_points(D, N, d), d
        for point in points:
            assert point.root**2 == d
            assert point.root.trace() == 0
            assert complex(point).imag > 0
            u = point.stabiliser
            assert u * point.root == point.root * u
            turns = next(n for n in range(1, 7) if u**n in (1, -1))
            assert turns == {-3: 3, -4: 2}.get(d, 1)


def test_points_of_different_orbits_are_not_conjugate() -> None:
    G = order(6, 5).norm_one_group()
    roots = [point.root for point in G.cm_points(-24)]
    pairs = [(x, y) for n, x in enumerate(roots) for y in roots[:n]]
    assert pairs
    assert not any(G.conjugator(x, y) for x, y in pairs)


@subcases("D, N", [(6, 1), (14, 1), (10, 3)])
def test_fixed_points_give_the_genera_of_quotients(D: int, N: int) -> None:
    """2g − 2 = 2·(2g' − 2) + the number of fixed points, against the domain of the larger group."""
    G = order(D, N).norm_one_group()
    whole = D * N
    for m in (m for m in range(2, whole + 1) if whole % m == 0 and gcd(m, whole // m) == 1):
        genus, rest = divmod(2 * G.signature.genus + 2 - len(G.fixed_points(m)), 4)
        assert (rest, genus) == (0, G.quotient(m).signature.genus), m


def narrow_class_number(d: int) -> int:
    """Count the cycles of primitive reduced forms of discriminant d > 0, no square."""
    root = isqrt(d)
    forms = {
        (a, b, (b * b - d) // (4 * a))
        for b in range(1, root + 1)
        for a in (s * n for n in range(1, root + b + 1) for s in (1, -1))
        if (b * b - d) % (4 * a) == 0 and root - b < 2 * abs(a) <= root + b
    }
    left = {f for f in forms if gcd(*f) == 1}
    cycles = 0
    while left:
        f = left.pop()
        cycles += 1
        while True:  # the next form of the cycle
            _, b, c = f
            r = -b % (2 * abs(c))
            r += (root - r) // (2 * abs(c)) * 2 * abs(c)
            f = (c, r, (r * r - d) // (4 * c))
            if f not in left:
                break
            left.discard(f)
    return cycles


@subcases("D, N", [(6, 1), (10, 3), (1, 1), (1, 6)])
def test_the_orbits_of_real_quadratic_orders_are_narrow_classes(D: int, N: int) -> None:
    O, found = order(D, N), 0
    G = O.norm_one_group()
    for d in (5, 8, 12, 13, 20, 24, 29, 45, 60, 136, 145):
        count = narrow_class_number(d)
        for p in factorise(D) if D > 1 else ():
            count *= 1 - eichler_symbol(d, p)
        for p in factorise(N) if N > 1 else ():
            count *= 1 + eichler_symbol(d, p)
        E = O.embeddings(d)
        assert E.orbits == count, d
        for x in E.representatives:
            assert x in O
            assert x.trace() ** 2 - 4 * x.norm() == d
        if 1 < count <= 4:
            first, *others = E.representatives
            assert not any(G.conjugator(first, x) for x in others)
        found += count
    assert found


def test_involutions_permute_the_points() -> None:
    G = order(6).norm_one_group()
    points = G.cm_points(-19)
    images = [G.involution(2, point) for point in points]
    assert Counter(images) == Counter(points)
    assert [G.involution(2, image) for image in images] == list(points)


def test_embeddings_are_elements_of_the_order() -> None:
    rng = Random(1)
    for D, N in ((6, 1), (6, 35), (10, 7), (14, 3), (1, 6)):
        O = order(D, N)
        for d in rng.sample([d for d in range(-120, 120) if d % 4 < 2], 12):
            if d >= 0 and isqrt(d) ** 2 == d:
                continue
            E = O.embeddings(d)
            symbols = [eichler_symbol(d, p) != 1 for p in factorise(D)] if D > 1 else []
            symbols += [eichler_symbol(d, p) != -1 for p in factorise(N)] if N > 1 else []
            assert bool(E) == all(symbols), (D, N, d)  # strong approximation
            if E:
                x = E.element
                assert x in O
                assert x.trace() ** 2 - 4 * x.norm() == d
                assert check(E.certificate).verdict == "proved"
            else:
                assert E.reason
                assert not E.representatives


def test_points_are_moved_into_domains() -> None:
    G = order(6).norm_one_group()
    for D in (G.domain(0.7 + 0.4j), G.domain(G.cm_points(-3)[0])):
        for point in (*G.cm_points(-24), *G.cm_points(-4)):
            there = D.reduce(point)
            v = D.polygon.plane.vector(there.root)
            assert D.polygon.beyond(v if v[0] > 0 else tuple(-c for c in v)) is None
            u = G.conjugator(point.element, there.element)
            assert u is not None
            assert u * point.element == there.element * u
            assert there.stabiliser * there.root == there.root * there.stabiliser
            assert D.reduce(there) == there


def test_points_are_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("points.svg", "points.html"):
        file = str(tmp_path / name)
        assert main(["domain", "6", "--cm", "-24", "--cm", "-19", "-o", file]) == 0
    assert "12 - j + k of -24, at " in capsys.readouterr().out
    text = (tmp_path / "points.svg").read_text(encoding="utf-8")
    assert text.count("<circle cx=") == 2 + 4 + 2  # with the legend
    assert "CM points of discriminant −24" in text
    page = (tmp_path / "points.html").read_text(encoding="utf-8")
    assert '{"name": "\\u221224", "color": "#ffc400", "places": [[' in page
    assert main(["domain", "6", "--cm", "-19", "--format", "json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert [point["discriminant"] for point in data["cm_points"]] == ["-19"] * 4
    assert main(["domain", "6", "--cm", "5"]) == 2
    G = order(6).norm_one_group()
    G.domain().draw(tmp_path / "points.png", points=G.cm_points(-24), depth=0)
    assert (tmp_path / "points.png").stat().st_size > 10_000


def test_what_is_refused() -> None:
    O = order(6)
    for wrong in (-5, 2, 9, 0, "1/2"):
        with pytest.raises(LatticeError, match="is not a discriminant of a quadratic order"):
            O.embeddings(wrong)
    with pytest.raises(LatticeError, match="totally negative"):
        O.norm_one_group().cm_points(5)
    claim = O.embeddings(5).claim_of_orbits()
    assert claim.certificate is None
    assert "negative discriminants only" in str(claim.why_no_certificate)
    with pytest.raises(IndefiniteError, match="infinitely many"):
        len(O.embeddings(-24))


def test_definite_orders_have_representatives() -> None:
    E = H("QQ").hurwitz_order().embeddings(-4)
    assert (len(E), E.orbits, len(E.representatives)) == (6, 1, 1)


def test_the_command(capsys: pytest.CaptureFixture[str], tmp_path) -> None:
    file = tmp_path / "embedding.json"
    assert main(["embed", "6", "-24", "--all", "--certificate", str(file)]) == 0
    assert "orbits" in capsys.readouterr().out
    assert main(["check", str(file)]) == 0
    capsys.readouterr()
    assert main(["embed", "6", "-7"]) == 0
    assert "none: 2 splits" in capsys.readouterr().out
    assert main(["embed", "6", "-5"]) == 2


@subcases(
    "polynomial, prime, coefficients",
    [
        ("s^2-s-1", 2, [(-4, 0), (-3, 0), (-7, 0), (-8, 0), (-11, 0), (-7, 3), (-9, 2)]),
        ("s^2-2", 3, [(-4, 0), (-3, 0), (-7, 0), (-11, 0), (-7, 2), (-5, 2)]),
        ("s^3-s^2-2*s+1", 0, [(-4, 0, 0), (-3, 0, 0), (-7, 0, 0), (-8, 0, 0), (-4, 1, 0)]),
    ],
)
def test_points_over_number_fields_are_classes_of_cm_extensions(
    polynomial: str, prime: int, coefficients: list[tuple[int, ...]]
) -> None:
    """h(S)·Π(1 − (S/P)) points over fields whose totally positive units are squares, against PARI."""
    pari = pytest.importorskip("cypari").pari
    K = ring(f"QQ[s]/({polynomial})")
    places = [*K.real_places()[1:], *(K.primes_above(prime) if prime else ())]
    A = QuaternionAlgebra.from_ramification(K, places)
    G = A.maximal_order().norm_one_group()
    compared = 0
    for c in coefficients:
        d = sum((K(a) * K.gen**n for n, a in enumerate(c)), K(0))
        text = "+".join(f"({a})*s^{n}" for n, a in enumerate(c))
        extension = pari(f"polredbest(rnfequation({polynomial}, x^2-({text})))")
        norm = abs(int(pari(f"norm(Mod({text}, {polynomial}))")))
        try:
            points = G.cm_points(d)
        except LatticeError:
            continue  # no square modulo 4, or not totally negative
        if abs(int(pari.nfdisc(extension))) != int(pari.nfdisc(pari(polynomial))) ** 2 * norm:
            continue  # an order that is not maximal
        count = int(pari(f"bnfinit({extension}, 1).no"))
        for P in K.primes_above(prime) if prime else ():
            above = list(pari(f"idealprimedec(nfinit({extension}), {prime})"))
            count *= 0 if len(above) == 2 else 2 if int(above[0][3]) == 2 * P.f else 1
        assert len(points) == count, c
        compared += 1
    assert compared > 1
