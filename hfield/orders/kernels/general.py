"""The functions for lattices over any base, of rank 4n over ℤ."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from operator import mul
from typing import TYPE_CHECKING

from flint import fmpz, fmpz_mat

from hfield.errors import TooLargeError
from hfield.orders import enumeration
from hfield.orders.base import Counts
from hfield.orders.base_values import BaseIdeal, BaseNumber, Integer, IntegerMatrix, ThetaSeries
from hfield.orders.domains import domain_of
from hfield.orders.hermite import divided, hermite, stacked, tuples

if TYPE_CHECKING:
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.lattice_values import LatticeValue

MAX_COUNTED = 2 * 10**6
"""The largest number of elements that are counted."""


def first_order(ambient: AlgebraBasis) -> tuple[int, fmpz_mat]:
    """Return rows over a denominator that span an order, from which a maximal one is made.

    They are 1, r·I, s·J and rs·IJ, with numbers r and s that make constants integral.
    """
    a, t, b = ambient.constants
    integer = ambient.domain.integer
    r, s = (integer(ambient.base.coordinate_rows(x).numer_denom()[1]) for x in ([a, t], [b]))
    scales = [c for c in (1, r, s, r * s) for _ in range(ambient.degree)]
    size = range(ambient.size)
    rows = [[c * int(m == k) for m in size] for k, c in enumerate(scales)]
    return 1, ambient.domain.matrix(rows)


def norm(ambient: AlgebraBasis, forms: Sequence[fmpz_mat], content: fmpz, den: int) -> BaseIdeal:
    """Return the ideal that norms generate, by the forms of their coordinates on a basis."""
    size, domain = range(ambient.size), ambient.domain
    squares = domain.matrix([[f[k, k] // domain.form_factor for f in forms] for k in size])
    grams = list(map(domain.polar, forms))
    entries = squares.entries()
    for table in ambient.base_multiplications[1:]:
        entries += (squares * table).entries()
    # tr(x·conj(y)) is the norm of a sum less two norms; these are stable under the integers
    entries += [g[pair] for pair in ambient.pairs for g in grams]
    found: BaseIdeal = ambient.base.ideal_spanned(entries, ambient.scale * den * den)
    return found


def content(gram: fmpz_mat) -> fmpz:
    """Return the gcd of the values of the form of a matrix, over ℤ of half the diagonal and the rest."""
    size, domain = range(gram.ncols()), domain_of(gram)
    values = [gram[k, k] // domain.form_factor for k in size]
    pairs = domain.polar(gram)
    return domain.content(values + [pairs[m, n] for n in size for m in range(n)])


def volume(ambient: AlgebraBasis, matrix: fmpz_mat, den: int) -> BaseIdeal:
    """Return the index ideal of a lattice, in Hermite form over ``den``, in that of 1, I, J, IJ.

    Where the first coordinates are 0 the next ones are an ideal; the index is the product of the four.
    """
    base, n, size = ambient.base, ambient.degree, ambient.size
    rows = matrix.tolist()
    blocks = ([x for row in rows[k : k + n] for x in row[k : k + n]] for k in range(0, size, n))
    found: BaseIdeal = base.one
    for block in blocks:
        found = found * base.ideal_spanned(block, den)
    return found


def class_forms(
    ambient: AlgebraBasis, grams: Sequence[fmpz_mat], norm: BaseNumber, units: Sequence[BaseNumber]
) -> list[fmpz_mat]:
    """Return multiples of Tr(u·N(x)/ν), one for each unit u, by one factor, from the forms of N(x)."""
    base, domain = ambient.base, ambient.domain
    traces = [[base.trace(u * w / norm) for w in base.integral_basis] for u in units]
    whole = domain.fraction_matrix(traces).numer_denom()[0].tolist()
    forms = []
    for line in whole:
        form = grams[0] * line[0]
        for gram, c in zip(grams[1:], line[1:], strict=True):
            form += gram * c
        forms.append(form)
    content = domain.content([c for form in forms for c in form.entries()])
    return [divided(form, content) for form in forms]


def index(lattice: LatticeValue, other: LatticeValue) -> BaseIdeal:
    """Return the index ideal of the other lattice in this one, the ratio of the volumes."""
    found: BaseIdeal = other.volume / lattice.volume
    return found


def ideal_multiples(
    ambient: AlgebraBasis, rows: fmpz_mat, ideal: BaseIdeal
) -> tuple[int, fmpz_mat]:
    """Return the given rows times a basis of an ideal of the base, over a denominator."""
    den, table = ambient.base.ideal_rows(ideal)
    return den, stacked(*(ambient.times_scalar(rows, c) for c in table))


def order_rows(lattice: LatticeValue, pairs: fmpz_mat) -> tuple[int, fmpz_mat]:
    """Return rows over a denominator that span ``L·conj(L)/N(L)``.

    ``pairs`` are the products of pairs of the basis (:meth:`AlgebraBasis.norm_products`): with the norms and
    traces, which generate N(L), they span L·conj(L).
    """
    ambient, norm = lattice.ambient, lattice.norm
    below, table = ambient.base.ideal_rows(norm)
    whole = ambient.scale * ambient.conjugate_scale * lattice.den * lattice.den
    common = ambient.domain.lcm(below, whole)
    numbers = ambient.domain.matrix(table) * ambient.integers
    rows = stacked(pairs * (common // whole), numbers * (common // below))
    found = hermite(common, rows)
    assert found is not None, "the products with one conjugate have full rank"
    below, multiples = ideal_multiples(ambient, found[1], ambient.base.inverse(norm))
    return below * found[0], multiples


def is_locally_principal(ideal: LatticeValue, order: LatticeValue) -> bool:
    """Return whether the index of an ideal in its order is the square of its norm."""
    index = volume(ideal.ambient, ideal.matrix, ideal.den)
    whole = volume(order.ambient, order.matrix, order.den)
    return bool(index == ideal.norm * ideal.norm * whole)


def has_norm(ambient: AlgebraBasis, den: Integer, row: IntegerMatrix, norm: BaseNumber) -> bool:
    """Return whether a row over ``den`` has a norm ν, where Tr(N(x)/ν) is the degree of the field."""
    x = row * ambient.domain.fraction(1, den)
    return bool(ambient.norm(x.entries()) == norm)


def least_products(
    vectors: Sequence[tuple[int, list[int]]], forms: Sequence[fmpz_mat]
) -> Sequence[int]:
    """Return which vectors have the least sorted absolute inner products with the others.

    Each has the number of its form; vectors of one form follow each other, in the order of the forms.
    """
    products: list[list[fmpz]] = []
    for number, form in enumerate(forms):
        some = [vector for n, vector in vectors if n == number]
        if some:
            rows = fmpz_mat(some)
            table = (rows * form * rows.transpose()).tolist()
            products += [sorted(map(abs, row)) for row in table]
    first = min(products)
    return [k for k, numbers in enumerate(products) if numbers == first]


def combination(x: Sequence[int], columns: Sequence[Sequence[int]]) -> tuple[int, ...]:
    """Return a combination of the rows of a matrix with these columns."""
    return tuple(sum(map(mul, x, column)) for column in columns)


def theta_series(
    ambient: AlgebraBasis,
    den: int,
    rows: fmpz_mat,
    gram: enumeration.Gram,
    unit: fmpz,
    step: Fraction,
    bound: int,
) -> ThetaSeries:
    """Return how many combinations of rows over ``den`` have each norm of trace at most ``bound·step``.

    ``gram`` is the matrix of ``Tr(tr(x·conj(y)))``, scaled, over a unit. Raises :class:`TooLargeError`.
    """
    length = int(2 * bound * step * (ambient.scale * den**2) / int(unit))
    if (estimate := enumeration.volume(gram, length, len(gram))) > 4 * MAX_COUNTED:
        raise TooLargeError(
            f"about {estimate:.0e} elements have norms of trace at most {bound * step}, and at most "
            f"{MAX_COUNTED} are counted; expected a smaller bound"
        )
    forms = [tuples(form) for form in ambient.grams(rows)]
    counts = Counter({(0,) * len(forms): 1})
    for number, (x, _) in enumerate(enumeration.short_vectors(gram, length), 1):
        if number > MAX_COUNTED // 2:
            raise TooLargeError(
                f"more than {MAX_COUNTED} elements have norms of trace at most {bound * step}"
            )
        places = [(k, c) for k, c in enumerate(x) if c]
        values = (sum(c * d * form[k][m] for k, c in places for m, d in places) for form in forms)
        counts[tuple(values)] += 2
    below = 2 * ambient.scale * den**2
    found: ThetaSeries = ambient.base.shown_counts(Counts(counts, below), step, bound)
    return found
