"""Why a norm form is 0 only at 0: an ordering, the level of the field, or a place.

At a place with residues of another characteristic than 2, say that u has odd order there and v is
a unit that is no square among the residues, for two of a, b, −ab up to squares. The norm form is then
that of (u, v), (w² − v·x²) − u·(y² − v·z²), and where it is 0 all of w, x, y, z could be divided by the
prime for ever. Over ℚ₂ all cases modulo 16 are tried.
"""

import re
from fractions import Fraction
from itertools import product
from typing import Any

from hfield.certificates.evaluate import Evaluator, Quaternion, RingScalars
from hfield.certificates.facts import is_ordered, is_square, level_above
from hfield.certificates.language import walk
from hfield.certificates.rejection import reject, shown, texts
from hfield.certificates.scalars.finite import is_prime
from hfield.certificates.scalars.functions import Functions, dense
from hfield.certificates.scalars.numbers import QQ, Rationals, Surds
from hfield.certificates.scalars.ring import Ring
from hfield.certificates.statement import read_setting
from hfield.certificates.work import charge

PRECISION = 40
MAX_PRIME = 10**12
BY = ("ordering", "level", "ramified places", "specialisation")

Constants = tuple[Any, Any, Any]


def anisotropic(field: Ring, c: Constants, data: Any, algebra: str) -> tuple[str, ...]:
    """Prove that the norm of the algebra (a, t, b) is 0 only at 0.

    Returns () where this is verified. Where the places are of a kind that is not, the fact itself is
    returned: it has to stand among what the certificate assumes.
    """
    by = data["by"]
    places = texts(data.get("places", []), "places")
    if by not in BY or (by in BY[:2] and places) or len(places) > 20:
        reject("the reason for the norm form is of no known kind")
    if not field.is_field or field.order is not None or field.name in ("RDF", "CC"):
        reject(f"over {field.name} no norm form is 0 only at 0")
    if field.characteristic == 2:
        return _cited(field, c, by, places, algebra)
    a, t, b = c
    # Completing the square: the norm form is that of d = t² + 4a and b.
    d = field.add(field.mul(t, t), field.mul(field.number(4), a))
    if field.is_zero(d) or field.is_zero(b):
        reject("the algebra is degenerate")
    if by == "ordering":
        signs = zip(field.signs(d), field.signs(b), strict=True)
        if not is_ordered(field) or (-1, -1) not in signs:
            reject("the constants are not both negative in an ordering that is known here")
        return ()
    if by == "level":
        minus_one, minus_four = field.number(-1), field.number(-4)
        hamilton = field.equal(d, minus_four) and field.equal(b, minus_one)
        if not hamilton or not level_above(field, 2):
            reject("−1 may be a sum of two squares, or this is not H(F)")
        return ()
    if _is_verified(field, d, b, places):
        return ()
    if isinstance(field, Rationals) or field.name == "RR":
        reject("the norm form may be 0 somewhere else than at 0")
    return _cited(field, c, by, places, algebra)


def cited_for_norm(algebra: str, field: str, by: str, places: list[str]) -> tuple[str, ...]:
    """Return what a certificate has to assume for this reason. Raises :class:`Rejected`."""
    setting = read_setting(algebra, field)
    ring = setting.field
    assert ring is not None
    constants: dict[Any, Any] = {}
    for tree in setting.constants:
        constants |= {
            node: ring.constant(node) for node in walk(tree) if node[0] in ("name", "call")
        }
    evaluator = Evaluator(RingScalars(ring), setting.constants, constants)
    a, t, b = (evaluator.term(tree)[0] for tree in setting.constants)
    return anisotropic(ring, (a, t, b), {"by": by, "places": places}, algebra)


def _cited(field: Ring, c: Constants, by: str, places: list[str], algebra: str) -> tuple[str, ...]:
    """Return the fact as one that is cited, unless a small element shows that it is false."""
    trees = (("name", "a"), ("name", "t"), ("name", "b"))
    evaluator = Evaluator(RingScalars(field), trees, dict(zip(trees, c, strict=True)))
    units = (field.zero, field.one, field.number(-1))
    for q in product(units, repeat=4):
        if not all(map(field.is_zero, q)) and field.is_zero(evaluator.norm(Quaternion(q))):
            reject("the norm form is 0 at an element with coordinates 0, 1, −1")
    at = ", ".join(re.sub(r"\s", "", place) for place in places)
    return (f"the norm form of {''.join(algebra.split())} is 0 only at 0 ({by}: {shown(at, 100)})",)


def _is_verified(field: Ring, a: Any, b: Any, places: list[str]) -> bool:
    if isinstance(field, Rationals):
        return any(_rational_place(a, b, _prime(p)) for p in places)
    if isinstance(field, Surds):
        return any(_quadratic_place(field, a, b, p) for p in places)
    if isinstance(field, Functions):
        if all(
            len(x[0]) == 1 and x[0][0][0] == (0,) and x[1] == field.polynomials.one for x in (a, b)
        ):
            # constants: the lowest coefficients of a zero would be a zero over the base
            u, v = a[0][0][1], b[0][0][1]
            return field.base is QQ and any(_rational_place(u, v, _prime(p)) for p in places)
        return any(_function_place(field, a, b, p) for p in places)
    return False


def _prime(text: str) -> int:
    """Read a prime number; 0 for any other text."""
    if not (text.isascii() and text.isdigit() and len(text) < 25):
        return 0
    return int(text) if is_prime(int(text)) else 0


def _squarefree_at(x: Fraction, p: int) -> tuple[int, int]:
    """Return (order, integer) of x at p, the integer being x without p up to squares."""
    n, order = x.numerator * x.denominator, 0
    while n % p == 0:
        n, order = n // p, order + 1
    return order, n


def _rational_place(a: Fraction, b: Fraction, p: int) -> bool:
    """Prove that the norm form of (a, b) is 0 only at 0 in ℚ_p."""
    if p == 0:
        return False
    found = [_squarefree_at(x, p) for x in (a, b, -a * b)]
    if p > 2:
        return any(
            m % 2 and n % 2 == 0 and pow(v, (p - 1) // 2, p) == p - 1
            for m, _ in found
            for n, v in found
        )
    # The orders of a, b, −ab are all even, or two are odd: then take one of these and the even one.
    found.sort(key=lambda x: x[0] % 2)
    (n, v), (m, u) = found[:2]
    charge(200_000)
    s, t = u * (1 + m % 2) % 16, v * (1 + n % 2) % 16
    return all(
        (w * w - s * x * x - t * y * y + s * t * z * z) % 16
        for w, x, y, z in product(range(16), repeat=4)
        if (w | x | y | z) & 1
    )


def _quadratic_place(field: Surds, a: Any, b: Any, place: str) -> bool:
    """Prove it at a prime of ℚ(√d): ``(p, sqrt(d)-r)`` that splits, or ``p`` that does not."""
    d = field.d
    text = "".join(place.split())
    m = re.fullmatch(r"\(([0-9]{1,13}),(?:sqrt\(-?[0-9]+\)|I)-([0-9]{1,13})\)", text)
    if d is None:
        return False
    if m is not None:
        p = _prime(m[1])
        root = None if not p or p > MAX_PRIME else _root(d, int(m[2]), p)
        if root is None:
            return False
        u, v = _image(a, root, p), _image(b, root, p)
        return u is not None and v is not None and _rational_place(u, v, p)
    p = _prime(text)
    if p < 3 or p > MAX_PRIME or (d % p and pow(d, (p - 1) // 2, p) == 1):
        return False
    minus_ab = field.neg(field.mul(a, b))
    found = [_order(x, d, p) for x in (a, b, minus_ab)]
    return any(m % 2 and n % 2 == 0 and not square for m, _ in found for n, square in found)


def _pair(x: Any) -> tuple[Fraction, Fraction]:
    values = dict(x)
    u = values.pop((), Fraction(0))
    return u, next(iter(values.values()), Fraction(0))


def _root(d: int, start: int, p: int) -> int | None:
    """Return r with r² ≡ d modulo p^PRECISION that begins like ``start`` (modulo p, or modulo 4)."""
    if p > 2:
        r, q = start % p, p
        if (r * r - d) % p or not d % p:
            return None
        for _ in range(6):
            q = q * q
            r = (r - (r * r - d) * pow(2 * r, -1, q)) % q
        return r
    if d % 8 != 1 or start % 2 == 0:
        return None
    r = start % 4
    for n in range(3, PRECISION + 20):
        if (r * r - d) % 2 ** (n + 1):
            r += 2 ** (n - 1)
        if (r * r - d) % 2 ** (n + 1):
            return None
    return r


def _image(x: Any, root: int, p: int) -> Fraction | None:
    """Return a rational number that is the image of x in ℚ_p up to squares."""
    u, v = _pair(x)
    below = u.denominator * v.denominator
    n = (u * below).numerator + (v * below).numerator * root
    modulus = p**PRECISION
    order, rest = 0, n
    while rest % p == 0 and order < PRECISION // 2:
        rest, order = rest // p, order + 1
    if order >= PRECISION // 2:
        return None
    return Fraction(n % modulus) * below


def _order(x: Any, d: int, p: int) -> tuple[int, bool]:
    """Return the order at the one prime above p, and whether the unit that is left is a square."""
    u, v = _pair(x)
    below = u.denominator * v.denominator
    s, t = (u * below * below).numerator, (v * below * below).numerator  # times a square
    order, inert = 0, d % p != 0
    while s % p == 0 and t % p == 0:
        s, t = s // p, t // p
        if inert:
            order += 1
        else:  # p is (√d)² times the inverse of the unit d/p
            s, t, order = s * (d // p), t * (d // p), order + 2
    if inert:  # in GF(p²) exactly the elements with a square norm are squares
        residue = s * s - d * t * t
    elif s % p:
        residue = s
    else:
        residue, order = t, order + 1
    return order, pow(residue, (p - 1) // 2, p) == 1


def _function_place(field: Functions, a: Any, b: Any, place: str) -> bool:
    """Prove it at an irreducible polynomial, or at infinity (``inf``)."""
    found = []
    values = (a, b, field.neg(field.mul(a, b)))
    if place.strip() == "inf":
        for x in values:
            (m, c), (n, e) = x[0][-1], x[1][-1]
            found.append((n[0] - m[0], is_square(field.base, field.base.mul(c, e))))
    else:
        prime = field.read(place)
        if prime[1] != field.polynomials.one or not prime[0] or prime[0][-1][0][0] not in (1, 2):
            return False
        for x in values:
            residue = _residue(field, field.polynomials.mul(*x), prime[0])
            if residue is None:
                return False
            found.append(residue)
    return any(m % 2 and n % 2 == 0 and not square for m, _ in found for n, square in found)


def _residue(field: Functions, f: Any, prime: Any) -> tuple[int, bool] | None:
    """Return the order of f and whether what is left is a square modulo a prime of degree 1 or 2."""
    base, order = field.base, 0
    rest_of_f, divisor = dense(f, base), dense(prime, base)
    while True:
        quotient, rest = field.divided(rest_of_f, divisor)
        if rest:
            break
        rest_of_f, order = quotient, order + 1
    rest = [*rest, *[base.zero] * (len(divisor) - 1 - len(rest))]
    if len(divisor) == 2:
        return order, is_square(base, rest[0])
    # Modulo t² + c1·t + c0 the elements are u + v·√D with D = c1² − 4·c0 and t = (√D − c1)/2.
    lead = base.inverse(divisor[2])
    c0, c1 = (base.mul(c, lead) for c in divisor[:2])
    discriminant = base.add(base.mul(c1, c1), base.neg(base.mul(base.number(4), c0)))
    if is_square(base, discriminant):
        return None
    half = base.inverse(base.number(2))
    v = base.mul(rest[1], half)
    u = base.add(rest[0], base.neg(base.mul(v, c1)))
    norm = base.add(base.mul(u, u), base.neg(base.mul(discriminant, base.mul(v, v))))
    if base.order is not None:  # in GF(q²) exactly the elements with a square norm are squares
        return order, is_square(base, norm)
    if not is_square(base, norm):
        return order, False
    return (
        None
        if not base.is_zero(v)
        else (order, is_square(base, u) or is_square(base, base.mul(u, discriminant)))
    )
