"""Finding i and j of one division algebra inside an isomorphic one.

The element I with the square of i is a pure quaternion of given norm, a zero of a form in four
variables: over ℚ it is found directly; elsewhere one coordinate runs through small values until the
conic that is left has a point. The element J that goes with it is ``(m + n·I)·v`` for one v
that anticommutes with I, and a point on a conic gives m and n.
"""

import itertools
from collections.abc import Iterator
from typing import Any

from hfield.errors import UndecidedError
from hfield.product import Constants, Coordinates, multiply, norm
from hfield.rings.base import Ring
from hfield.rings.functions import FunctionField
from hfield.rings.quadratic import QuadraticField
from hfield.structure.bundle import solve_ternary
from hfield.structure.centre import basis_of
from hfield.structure.forms import NormalForm, discriminant, normal_form
from hfield.structure.integers import fraction
from hfield.structure.minimise import RamifiedError
from hfield.structure.places import ramification
from hfield.structure.qforms import isotropic_vector
from hfield.structure.zero import zero_norm

TRIALS = 300


def embed_generator(ring: Ring, c: Constants, other: Constants) -> tuple[Coordinates, Coordinates]:
    """Return the images of i and j under some isomorphism of division algebras, known to exist.

    Raises :class:`UndecidedError` when none was found in bounded time.
    """
    source, target = normal_form(ring, c), normal_form(ring, other)
    middle = ring.one if target.kind == "artin-schreier" else ring.zero
    inner = Constants(target.a, middle, target.b)
    big_i = _generator(ring, source.a, target)
    big_j = _companion(ring, inner, Constants(source.a, middle, source.b), big_i)
    # back from the normal forms: i of c is a combination of e and the normal i
    one = basis_of(ring)[0]
    i_in_normal = source.forth(basis_of(ring)[1])
    image = [i_in_normal[0] * x + i_in_normal[1] * y for x, y in zip(one, big_i, strict=True)]
    return target.back((image[0], image[1], image[2], image[3])), target.back(big_j)


def conic_point(ring: Ring, c: Constants) -> tuple[Any, Any, Any]:
    """Return ``(w, x, y)`` ≠ 0 with ``w² + t·wx − a·x² − b·y² = 0`` for a split algebra.

    A zero divisor q gives the plane q·A of elements of norm 0, which meets ⟨e, i, j⟩.
    """
    q = zero_norm(ring, c).element
    assert q is not None, "the algebra is split"
    products = [
        p for p in (multiply(c, q, u) for u in basis_of(ring)) if not all(map(ring.is_zero, p))
    ]
    for p, r in itertools.combinations([*products, products[0]], 2):
        w, x, y, z = (s * r[3] - t * p[3] for s, t in zip(p, r, strict=True))
        if not all(map(ring.is_zero, (w, x, y))):
            assert ring.is_zero(norm(c, (w, x, y, z)))
            return w, x, y
    w, x, y, _ = products[0]
    return w, x, y


def _generator(ring: Ring, a: Any, target: NormalForm) -> Coordinates:
    """Return an element of (target.a, target.b) with the minimal polynomial of i."""
    p, q = target.constants
    zero = ring.zero
    if target.kind == "artin-schreier":
        assert isinstance(ring, FunctionField)
        return _artin_schreier_generator(ring, a, p, q)
    if ring.name == "QQ":
        solution = isotropic_vector([fraction(x) for x in (p, q, zero - p * q, zero - a)])
        assert solution is not None, "the fields that embed in isomorphic algebras are the same"
        x, y, z, r = (ring(u) for u in solution)
        scale = ring.inverse(r)
        return zero, x * scale, y * scale, z * scale
    if ring.name == "RR":
        root = ring.sqrt(ring.divide(a, p))
        return zero, root, zero, zero
    for z in itertools.islice(_small(ring), TRIALS):
        rest = a + p * q * (z * z)
        if ring.is_zero(rest):
            return zero, zero, zero, z
        c = Constants(p * rest, zero, q * rest)
        if not ramification(ring, normal_form(ring, c)) and zero_norm(ring, c):
            # p·rest·x² + q·rest·y² = w², so p·(rest·x/w)² + q·(rest·y/w)² = rest
            w, x, y = conic_point(ring, c)
            scale = ring.divide(rest, w)
            return zero, x * scale, y * scale, z
    raise UndecidedError(
        f"an embedding exists, but none was found over {ring.name} with small coordinates"
    )


def _artin_schreier_generator(ring: FunctionField, a: Any, p: Any, q: Any) -> Coordinates:
    """Return ``x + i + y·j + z·k`` of norm a: for a fixed z a conic in x, y and a common denominator."""
    one, zero = ring.one, ring.zero
    for z in itertools.islice(_small(ring), TRIALS):
        form = (one, q, a + p + q * p * (z * z), q * z, one, zero)
        if ring.is_zero(q * z * z + one):
            continue
        try:
            x, y, w = solve_ternary(ring, form)
        except RamifiedError:
            continue
        scale = ring.inverse(w)
        return x * scale, one, y * scale, z
    raise UndecidedError(
        f"an embedding exists, but none was found over {ring.name} with small coordinates"
    )


def _companion(ring: Ring, inner: Constants, source: Constants, i: Coordinates) -> Coordinates:
    """Return J with ``J·I = (t − I)·J`` and ``J² = source.b``."""
    for p in basis_of(ring)[1:]:
        left, right = multiply(inner, i, p), multiply(inner, p, i)
        w, x, y, z = (s - t for s, t in zip(left, right, strict=True))
        v = (w, x, y, z)
        if not all(map(ring.is_zero, v)):
            break
    square = multiply(inner, v, v)[0]
    ratio = ring.divide(source.b, square)
    m, n, r = conic_point(ring, Constants(source.a, source.t, ratio))
    scale = ring.inverse(r)
    factor = [scale * (n * x) for x in i]
    factor[0] = factor[0] + scale * m
    return multiply(inner, (factor[0], factor[1], factor[2], factor[3]), v)


def _small(ring: Ring) -> Iterator[Any]:
    """Run through small elements of a quadratic or a function field, 0 first, with small denominators."""
    for size in itertools.count():
        numbers = range(-size, size + 1)
        if isinstance(ring, QuadraticField):
            pairs = [(u, v) for u in numbers for v in numbers if max(abs(u), abs(v)) == size]
            tops = [ring(u) + ring(v) * ring.gen for u, v in pairs]
            bottoms = [ring(n) for n in range(1, size + 2)]
        elif isinstance(ring, FunctionField):
            digits = (
                [ring(u) for u in numbers]
                if ring.base.order is None
                else list(_constants(ring, size + 2))
            )
            degree = min(size, 3)
            tops = [
                sum((x * ring.power(ring.gen, n) for n, x in enumerate(rest)), first)
                for first, *rest in itertools.product(digits, repeat=degree + 1)
            ]
            bottoms = [ring.one, ring.gen, ring.gen + ring.one][: size + 1]
        else:
            raise UndecidedError(
                f"isomorphisms of division algebras over {ring.name} are not constructed"
            )
        yield from (ring.divide(x, y) for y in bottoms for x in tops)


def _constants(ring: FunctionField, count: int) -> Iterator[Any]:
    return (ring.constant(x) for x in itertools.islice(ring.base.elements(), count))


__all__ = ["conic_point", "discriminant", "embed_generator"]
