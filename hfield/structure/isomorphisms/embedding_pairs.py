"""Finding i and j of one algebra inside an isomorphic one, without splitting either.

Over the real and complex numbers by square roots; elsewhere as the field knows how (`GlobalField.embed`).
"""

import itertools

from hfield.product import Constants, Coordinates
from hfield.rings.base import Ring
from hfield.structure.forms import normal_form
from hfield.structure.global_field import known_field
from hfield.structure.linear_algebra.centre import basis_of


def embed_generator(ring: Ring, c: Constants, other: Constants) -> tuple[Coordinates, Coordinates]:
    """Return the images of i and j under some isomorphism, known to exist.

    Raises :class:`UndecidedError` when none was found in bounded time.
    """
    source, target = normal_form(ring, c), normal_form(ring, other)
    middle = ring.one if target.kind == "artin-schreier" else ring.zero
    inner, outer = (Constants(f.a, middle, f.b) for f in (target, source))
    if ring.closure is not None:
        i, j = _closed(ring, outer, inner)
    else:
        i, j = known_field(ring).embed(outer, inner)
    # back from the normal forms: i of c is a combination of e and the normal i
    one, given, _, _ = basis_of(ring)
    scalar, factor, _, _ = source.forth(given)
    w, x, y, z = (scalar * u + factor * v for u, v in zip(one, i, strict=True))
    return target.back((w, x, y, z)), target.back(j)


def _closed(ring: Ring, outer: Constants, inner: Constants) -> tuple[Coordinates, Coordinates]:
    """Scale two of i, j, k over the real or complex numbers: those whose squares have the right signs."""
    o, e = ring.zero, ring.one
    units = [(o, e, o, o), (o, o, e, o), (o, o, o, e)]
    squares = (inner.a, inner.b, -inner.a * inner.b)
    for m, n in itertools.permutations(range(3), 2):
        ratios = ring.divide(outer.a, squares[m]), ring.divide(outer.b, squares[n])
        if ring.closure == "algebraically closed" or all(ring.sign(x) > 0 for x in ratios):
            r, s = map(ring.sqrt, ratios)
            i, j = ([x * u for u in units[n]] for x, n in ((r, m), (s, n)))
            return (i[0], i[1], i[2], i[3]), (j[0], j[1], j[2], j[3])
    raise AssertionError("isomorphic real algebras have squares of the same signs")
