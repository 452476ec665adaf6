"""Norm forms that are 0 only at 0: every true fact is shown to the checker, and no false one passes."""

import random
from collections.abc import Iterator
from fractions import Fraction
from itertools import product
from typing import Any

import pytest

from hfield import prove
from hfield.checker.anisotropy import is_certified as certifies
from hfield.checker.rejection import Rejected
from hfield.checker.scalars.quotients import QuotientField
from hfield.checker.scalars.rationals import has_no_rational_root
from hfield.checker.scalars.residues import jacobi
from hfield.core.product import Constants
from hfield.fields.names import ring
from hfield.fields.quadratic_forms import norm_evidence, place, ramified_places, zero_norm
from hfield.fields.quadratic_forms.norm_forms.zero_norms import evidence_at
from tests.checker.ring_data import (
    INFINITY,
    Data,
    data_of,
    ideal,
    number,
    place_data,
    prime,
    read_field,
    real,
    split,
)
from tests.subcases import first_quick, subcases

FIELDS = (
    *("QQ", "QQ(sqrt(2))", "QQ(I)", "QQ(sqrt(-2))", "QQ(sqrt(-3))", "QQ(sqrt(3))", "QQ(sqrt(5))"),
    *("QQ(sqrt(-7))", "QQ(sqrt(-15))", "QQ(sqrt(17))", "QQ(sqrt(-5))", "QQ(sqrt(6))"),
    *("GF(2)(t)", "GF(3)(t)", "GF(4)(t)", "GF(5)(t)", "GF(7)(t)", "GF(8)(t)", "GF(9)(t)", "QQ(x)"),
)


def is_certified(algebra: str, field: str, reason: Any) -> bool:
    return certifies(algebra, data_of(field), reason)


def element(F: Any, rng: random.Random) -> Any:
    """A random nonzero element, small but with denominators."""
    while True:
        if not hasattr(F, "base"):
            x = F(rng.randint(-40, 40)) + (F(rng.randint(-9, 9)) * F.gen if F.gen_name else F.zero)
            x = F.divide(x, F(rng.choice([1, 1, 2, 3, 6, 9])))
        else:
            digits = (-3, 4) if F.characteristic == 0 else None
            x, y = F.zero, F.one
            for _ in range(rng.randint(1, 4)):
                c = rng.randint(*digits) if digits else F.base.random(rng)
                x = x * F.gen + F(c)
            if rng.random() < 0.3:
                y = F.gen + F(rng.randint(0, 1))
            x = F.divide(x, y)
        if not F.is_zero(x):
            return x


def algebras(name: str, many: int) -> Iterator[tuple[Any, Constants, str]]:
    F, rng = ring(name), random.Random(name)
    for _ in range(many):
        t = F.one if F.characteristic == 2 or rng.random() < 0.2 else F.zero
        c = Constants(element(F, rng), t, element(F, rng))
        if F.is_zero(t * t + F(4) * c.a):
            continue
        bracket = "(" if F.is_zero(t) else "["
        yield F, c, f"{bracket}{F.text(c.a)},{F.text(c.b)}|{name})"


def is_finite(v: Any) -> bool:
    """Whether a place is no embedding into ℝ or ℂ."""
    return not str(v).startswith("inf") or hasattr(v, "poly")


@pytest.mark.slow
@subcases("name", FIELDS)
def test_every_division_algebra_is_certified(name: str) -> None:
    seen = 0
    for F, c, algebra in algebras(name, 25):
        answer = zero_norm(F, c)
        if answer.element is None:
            assert norm_evidence(algebra, F, c, answer) is not None, algebra
            seen += 1
    assert seen > 5


@pytest.mark.slow
@subcases("name", FIELDS[:-1])
def test_at_each_ramified_place_and_at_no_other(name: str) -> None:
    """A lattice that shows one algebra to be ramified at a place shows no other to be that is not."""
    shown: dict[str, list[Any]] = {}
    found = list(algebras(name, 12))
    for F, c, algebra in found:
        for v in filter(is_finite, ramified_places(F, c)):
            data = next(evidence_at(F, c, [v]), None)
            assert data is not None, (algebra, v)
            assert is_certified(algebra, name, data)
            shown.setdefault(str(v), []).append(data)
    assert len(shown) > 3
    forged = 0
    for F, c, algebra in found[:8]:
        ramified = set(map(str, ramified_places(F, c)))
        for v in sorted(shown.keys() - ramified)[:10]:
            reused = shown[v][:1] + [
                {**shown[u][0], "place": place_data(name, v)}
                for u in sorted(ramified & shown.keys())[:1]
            ]
            for data in reused:
                assert not is_certified(algebra, name, data), (algebra, data)
                forged += 1
    assert forged > 20


DYADIC = (
    "QQ",
    "QQ(I)",
    "QQ(sqrt(3))",
    "QQ(sqrt(-2))",
    "QQ(sqrt(5))",
    "QQ(sqrt(-3))",
    "QQ(sqrt(17))",
)


@pytest.mark.parametrize("name", first_quick(DYADIC, 1))
def test_all_classes_of_squares_above_2(name: str) -> None:
    """Above 2, inert, ramified and split: (a, b) is certified exactly where the symbol is −1."""
    F = ring(name)
    g = F.gen if F.gen_name else F(7)
    units = [F(n) for n in (1, 3, 5, 2, 6)] + [g, g + 1, g - 3, F(2) * g + 1]
    units = [x for x in units if not F.is_zero(x)]
    counts = {True: 0, False: 0}
    for a, b in product(units, repeat=2):
        c = Constants(a, F.zero, b)
        ramified = set(map(str, ramified_places(F, c)))
        for v in (place(F, text) for text in places_above_2(name)):
            data = next(evidence_at(F, c, [v]), None)
            assert (data is not None) == (str(v) in ramified), (F.text(a), F.text(b), str(v))
            counts[data is not None] += 1
            if data is not None:
                assert is_certified(f"({F.text(a)},{F.text(b)}|{name})", name, data)
    assert min(counts.values()) > 10, counts


def places_above_2(name: str) -> list[str]:
    return ["(2, sqrt(17)-1)", "(2, sqrt(17)-3)"] if "17" in name else ["2"]


@pytest.mark.parametrize("text", ["GF(2)", "GF(4)", "GF(8)", "GF(3)", "GF(7)", "GF(9)"])
def test_quadratic_polynomials_over_finite_fields(text: str) -> None:
    """X² − s·X + n has no root exactly where trying all says so."""
    field = read_field(text)
    elements = list(field.elements())
    for s, n in product(elements, repeat=2):
        values = (field.add(field.mul(x, field.add(x, field.neg(s))), n) for x in elements)
        assert field.is_irreducible(s, n) == (not any(map(field.is_zero, values)))


def test_jacobi_symbols() -> None:
    """They are products of Legendre symbols, which Euler's criterion gives."""
    primes = [3, 5, 7, 11, 13]
    for n, a in product(range(3, 400, 2), range(-30, 31)):
        product_of, rest = 1, n
        for p in [*primes, *range(17, 400, 2)]:
            while rest % p == 0:
                euler = pow(a, (p - 1) // 2, p)
                product_of, rest = product_of * (euler - p if euler == p - 1 else euler), rest // p
        assert jacobi(a, n) == product_of, (a, n)


@pytest.mark.parametrize("text", ["GF(2)", "GF(3)", "GF(4)", "GF(5)"])
def test_residue_fields_are_fields(text: str) -> None:
    """Monic polynomials up to degree 4 (3): those that are no product make a field, the others none."""
    base = read_field(text)
    elements = list(base.elements())
    top = 4 if len(elements) < 4 else 3

    def times(f: Any, g: Any) -> tuple[Any, ...]:
        out = [base.zero] * (len(f) + len(g) - 1)
        for m, u in enumerate(f):
            for n, v in enumerate(g):
                out[m + n] = base.add(out[m + n], base.mul(u, v))
        return tuple(out)

    monic = {d: [(*f, base.one) for f in product(elements, repeat=d)] for d in range(1, top + 1)}
    products = {
        times(f, g)
        for d in monic
        for e in monic
        if d + e <= top
        for f in monic[d]
        for g in monic[e]
    }
    for f in (f for d in monic for f in monic[d]):
        if f in products:
            with pytest.raises(Rejected):
                QuotientField(base, list(f))
        else:
            k = QuotientField(base, list(f))
            if len(f) > 2:
                x = k.generator
                assert k.mul(x, k.inverse(x)) == k.one


H_IN_QQ = {"by": "place", "place": number(2), "u": ["1/2"] * 4, "j": ["1", "1", "0", "0"]}


def test_the_hurwitz_order_shows_hamilton() -> None:
    assert is_certified("(-1,-1|QQ)", "QQ", H_IN_QQ)


@subcases(
    "changes",
    [
        *(
            {"place": number(n)}
            for n in (3, 4, 1, 0, -2, 2.0, "2", "", True, None, [2], 15, 10**2000 - 1)
        ),
        *({"place": {**number(2), key: 1}} for key in ("root", "p", "element", "more")),
        *(
            {"place": place}
            for place in (INFINITY, split(2, 1), ideal(2), prime(0, 1), real(0), {"n": 2})
        ),
        *(
            {"place": place}
            for place in ("2", 2, None, ["2"], "(2)", [number(2)], {}, {"kind": "number"})
        ),
        *(
            {"u": u}
            for u in (
                [],
                ["1"] * 3,
                ["1"] * 5,
                ["1"] * 4,
                ["1", "0", "0", "0"],
                ["1/4"] * 4,
                "1111",
            )
        ),
        *(
            {"u": u}
            for u in (["0", "1", "0", "0"], ["1/2", "1/2", "1/2", "1"], ["1/0"] * 4, [1] * 4, None)
        ),
        *({"j": j} for j in (["1", "0", "0", "0"], ["0"] * 4, ["1/2"] * 4, ["2", "0", "0", "0"])),
        *(
            {"j": j}
            for j in (["1/2", "1/2", "1", "0"], ["1", "1", "0", "x"], ["2", "2", "0", "0", "0"])
        ),
        *(
            {"by": by}
            for by in ("ramified places", "level", "ordering", "specialisation", None, [])
        ),
        *({key: ["2"]} for key in ("places", "lattice", "proof", "at", "form", "kind")),
    ],
)
def test_a_changed_reason_is_none(changes: dict[str, Any]) -> None:
    assert not is_certified("(-1,-1|QQ)", "QQ", {**H_IN_QQ, **changes})


def numbers(*n: Any) -> list[Data]:
    return list(map(number, n))


def splits(*pairs: tuple[Any, Any]) -> list[Data]:
    return [split(n, r) for n, r in pairs]


SIX = [*numbers(9, 15, 21, 33, 6, 12), *splits((3, 0), (15, 6), (15, 9))]
ELSE = [real(0), ideal(7), prime(0, 1), INFINITY, {"kind": "complex", "number": 0}]


@subcases(
    ("field", "good", "bad"),
    [
        ("QQ", numbers(2, 3, 4611686018427387905), [*numbers(4, 6, 1, 0, -3, "3", 3.0, True), split(7, 3)]),
        ("QQ", [], [*ELSE, "3", 3, None, [], {}]),
        ("QQ(sqrt(2))", [*numbers(2, 3, 15), *splits((7, 3), (119, 45))], splits((7, 1), (2, 1), (7, -3))),
        ("QQ(sqrt(2))", splits((7, 4)), splits((7, 10), (14, 4), (3, 1), (7, "3"), (7, 3.0), (7, None))),
        ("QQ(sqrt(2))", [], [*numbers(4, 6, 14), *ELSE, {**split(7, 3), "d": 2}, {"kind": "split", "n": 7}]),
        ("QQ(sqrt(6))", [*numbers(2, 3, 35), split(5, 1)], SIX),
        ("QQ(sqrt(17))", [number(17), *splits((2, 1), (2, 3))], [*numbers(2, 51), *splits((2, 2), (2, 5))]),
        ("QQ(sqrt(17))", [], splits((2, 0), (2, -1))),
        ("QQ(sqrt(5))", numbers(2, 5, 3), [*splits((2, 1), (2, 3)), *numbers(10, 25)]),
        ("QQ(I)", [*numbers(2, 3), split(5, 2)], [*splits((5, 1), (2, 1)), number(1)]),
        (
            "GF(2)(t)",
            [prime(0, 1), INFINITY, prime(1, 1, 1), prime(1, 1, 0, 0, 1)],
            [prime(0, 0, 1), prime(1, 0, 1), prime(1, 0, 1, 0, 1), prime(1), prime(0), prime(), number(2)],
        ),
        (
            "GF(2)(t)",
            [],
            [prime(0, 2), prime(2, 1), prime(-1, 1), prime("0", 1), prime([0], [1]), prime(1, 1, 0)],
        ),
        ("GF(2)(t)", [], [{**INFINITY, "sign": "+"}, {**prime(0, 1), "at": 1}, prime(0, True), "t", "inf"]),
        (
            "GF(9)(t)",
            [prime([0, 0], [1, 0]), prime([0, 2], [1, 0]), INFINITY, prime([0, 2], [0, 0], [1, 0])],
            [prime([1, 0], [0, 0], [1, 0]), prime([2, 2], [0, 0], [1, 0]), prime([0, 1]), real(0), ideal(3)],
        ),
        ("GF(9)(t)", [], [prime(0, 1), prime([0], [1]), prime([0, 0, 0], [1, 0, 0]), prime([0, 3], [1, 0])]),
        ("GF(9)(t)", [], [prime([1, 0], [0, 1]), prime([0, 0], [2, 0])]),
        ("QQ(x)", [], [prime(0, 1), INFINITY, prime(1, 0, 1), number(2)]),
        ("RR", [], [number(2), INFINITY, real(0)]),
        ("CC", [], numbers(2, 3)),
        ("GF(5)", [], numbers(2, 5)),
    ],
)  # fmt: skip
def test_what_is_a_place(field: str, good: list[Any], bad: list[Any]) -> None:
    for data in good:
        assert read_field(field).place(data)
    for data in bad:
        with pytest.raises(Rejected):
            read_field(field).place(data)


def test_what_is_integral_at_a_composite_modulus() -> None:
    for field, at in (
        ("QQ", number(119)),
        ("QQ(sqrt(2))", split(119, 45)),
        ("QQ(sqrt(2))", number(15)),
    ):
        ring_of, n = read_field(field), at["n"]
        v = ring_of.place(at)
        for p in (3, 5, 7, 17):
            integral = v.residue(ring_of.fraction(Fraction(1, p))) is not None
            assert integral == (n % p != 0)
        assert v.residue(ring_of.fraction(Fraction(n, n * n))) is None
    v = read_field("QQ(sqrt(2))").place(split(7, 3))
    x = read_field("QQ(sqrt(2))").read(
        "(3+sqrt(2))/7"
    )  # of norm 1/7: integral at the other ideal only
    y = read_field("QQ(sqrt(2))").read("(3-sqrt(2))/7")
    assert (v.residue(x), v.residue(y)) == (None, pow(6, -1, 7))


def test_levels() -> None:
    """−1 is shown to be no sum of n squares exactly below the level that the rings know."""
    names = [
        "QQ",
        "GF(3)",
        "GF(5)",
        "GF(7)",
        "GF(9)",
        "GF(27)",
        "GF(4)",
        "RR",
        "CC",
        "QQ(x)",
        "GF(7)(t)",
    ]
    roots = [
        d for d in range(-40, 12) if d not in (0, 1, -1) and all(d % (p * p) for p in (2, 3, 5))
    ]
    for name in (*names, "GF(5)(t)", "GF(2)(t)", "QQ(I)", *(f"QQ(sqrt({d}))" for d in roots)):
        level = ring(name).level.value
        assert level is not None
        for n in (1, 2, 3, 4, 5):
            assert read_field(name).level_above(n) == (n < level), (name, n)


@pytest.mark.parametrize(
    "name", ["QQ", "QQ(sqrt(2))", "QQ(I)", "QQ(sqrt(-7))", "GF(9)", "QQ(x)", "GF(5)(t)"]
)
def test_squares(name: str) -> None:
    F, G, rng = ring(name), read_field(name), random.Random(name)
    for _ in range(40):
        x = F.random(rng)
        for y in (x, x * x, x * x * F(2), F.zero - x * x, x * x + F.one):
            assert G.is_square(G.read(F.text(y))) == (F.sqrt(y) is not None), F.text(y)


@pytest.mark.slow
def test_polynomials_without_rational_roots() -> None:
    rng, counts = random.Random(5), {True: 0, False: 0}
    for _ in range(300):
        c = [rng.randint(-12, 12) for _ in range(rng.randint(2, 5))]
        if not c[-1]:
            continue
        candidates = (Fraction(u, v) for u in range(-12, 13) for v in range(1, 13))
        rootless = not any(sum(a * x**n for n, a in enumerate(c)) == 0 for x in candidates)
        assert has_no_rational_root(c) == rootless, c
        counts[rootless] += 1
    assert min(counts.values()) > 50


def test_a_modulus_need_not_be_prime() -> None:
    """(−1, n) has the Jacobi symbol −1 at n = 3·5·7·11·23 (23 times): N(j) = −n, and u² = −1."""
    n = 3 * 5 * 7 * 11 * 23
    reason = {
        "by": "place",
        "place": number(n),
        "u": ["0", "1", "0", "0"],
        "j": ["0", "0", "1", "0"],
    }
    assert jacobi(-1, n) == 1
    assert not is_certified(f"(-1,{n}|QQ)", "QQ", reason)
    assert jacobi(2, n) == -1
    assert is_certified(f"(2,{n}|QQ)", "QQ", reason)
    assert not is_certified(f"(2,{n * n}|QQ)", "QQ", reason)
    assert not is_certified(f"(2,{n * n}|QQ)", "QQ", {**reason, "place": number(n * n)})
    assert is_certified(f"(2,{n * 1_000_003}|QQ)", "QQ", reason)
    assert not is_certified(f"(2,{n * 9}|QQ)", "QQ", reason)
    assert not is_certified(f"(2,{n * 9}|QQ)", "QQ", {**reason, "place": number(n // 3)})
    over = {
        "by": "place",
        "place": number(33),
        "u": ["0", "1", "0", "0"],
        "j": ["0", "0", "1", "0"],
    }
    assert is_certified("(1+2*sqrt(2),33|QQ(sqrt(2)))", "QQ(sqrt(2))", over) == (
        jacobi(-7, 33) == -1
    )


@subcases(
    ("algebra", "field"),
    [
        ("(7,-3|QQ(sqrt(2)))", "QQ(sqrt(2))"),
        ("(-1,-1|QQ(I))", "QQ(I)"),
        ("(-1,-1|QQ(sqrt(-3)))", "QQ(sqrt(-3))"),
        ("(2,7|QQ)", "QQ"),
        ("(-1,-1|GF(3))", "GF(3)"),
        ("(-1,-1|CC)", "CC"),
        ("(-1,1|RR)", "RR"),
        ("(x,1-x|QQ(x))", "QQ(x)"),
        ("[0,t|GF(2)(t))", "GF(2)(t)"),
        ("(t,t+1|GF(2)(t))", "GF(2)(t)"),
        ("(0,-1|QQ)", "QQ"),
        ("(1/0,-1|QQ)", "QQ"),
        ("(a,-1|QQ)", "QQ"),
    ],
)
def test_split_algebras_have_no_reason(algebra: str, field: str) -> None:
    elements = [H_IN_QQ["u"], *(["1" if m == n else "0" for n in range(4)] for m in range(4))]
    places = [*map(number, (2, 3, 5, 7)), INFINITY, prime(0, 1), prime(1, 1), prime(1, 1, 1)]
    places += [split(2, 1), split(7, 3), ideal(2), ideal(2, 1, 1), ideal(2, 0, 1), ideal(7)]
    reasons: list[Any] = [{"by": "ordering"}, {"by": "level"}]
    reasons += [
        {"by": "place", "place": p, "u": u, "j": j}
        for p in places
        for u in elements
        for j in elements
    ]
    reasons += [
        {"by": "specialisation", "at": at, "proof": proof}
        for at in ("0", "1", "2", "-1", "1/2", "inf", "x", "1/0")
        for proof in reasons[:12]
    ]
    for data in reasons:
        assert not is_certified(algebra, field, data), data


def test_specialisations() -> None:
    ordered = {"by": "specialisation", "at": "-3", "proof": {"by": "ordering"}}
    assert is_certified("(x,-2|QQ(x))", "QQ(x)", ordered)
    assert not is_certified("(x,-2|QQ(x))", "QQ(x)", {**ordered, "at": "3"})
    assert not is_certified("(x,-2|QQ(x))", "QQ(x)", {**ordered, "at": "0"})
    assert not is_certified("(1/x,-2|QQ(x))", "QQ(x)", {**ordered, "at": "0"})
    assert not is_certified("(-1,-2|QQ)", "QQ", ordered)
    assert not is_certified("(t,-1|GF(3)(t))", "GF(3)(t)", {**ordered, "at": "1"})
    nested = {**ordered, "proof": ordered}
    assert not is_certified("(x,-2|QQ(x))", "QQ(x)", nested)


@pytest.mark.parametrize("algebra", ["(-pi,-1|RR)", "(-1,-cos(1)|RR)"])
def test_numbers_that_the_checker_does_not_know_have_no_certificate(algebra: str) -> None:
    answer = prove("norm(q) == 0 => q == 0", algebra=algebra)
    assert (answer.verdict, answer.certificate) == ("proved", None)
    assert answer.why_no_certificate is not None


def test_an_unshown_norm_is_not_used(monkeypatch: pytest.MonkeyPatch) -> None:
    """What no certificate can carry is no rule, and the undecided answer says why."""
    monkeypatch.setattr(
        "hfield.fields.quadratic_forms.norm_forms.zero_norms.is_certified", lambda *_: False
    )
    answer = prove("norm(q) == 0 => q == 0", algebra="(3,-5|QQ(I))")
    assert answer.verdict == "undecided"
    assert "not by a reason that a certificate can carry" in "; ".join(answer.decision.tried)


@pytest.mark.parametrize(
    ("field", "p", "d"), [("QQ(I)", 3, -1), ("QQ(sqrt(2))", 5, 2), ("QQ(I)", 7, -1)]
)
def test_polynomials_at_a_prime_that_stays_prime(field: str, p: int, d: int) -> None:
    """The symbol of the norm of the discriminant tells what the field of p² elements does."""
    base = read_field(f"GF({p})")
    k = QuotientField(base, [-d % p, 0, 1])
    v = read_field(field).place(number(p))
    for trace, norm in product(product(range(p), repeat=2), repeat=2):
        assert v.is_irreducible(trace, norm) == k.is_irreducible(
            k.reduce(list(trace)), k.reduce(list(norm))
        )
