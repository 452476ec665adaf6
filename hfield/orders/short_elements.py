"""The norm on a lattice of a totally definite algebra: short elements, elements of given norm, theta series.

For totally positive c the form Tr(c·N(x)) is positive definite over ℤ. An element of norm ν has the value n =
[K : ℚ] in the form with c = 1/ν. By the inequality of arithmetic and geometric means this is the least value
for all x ≠ 0 with N(x)/ν integral. So equivalences, generators and units are vectors of least possible
length. An enumeration finds them or proves that there are none (J. Voight, *Quaternion Algebras*, section
17.6; M. Kirschmer and J. Voight, *SIAM J. Comput.* 39, 2010). All computations use integers.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction

from flint import fmpq, fmpq_mat, fmpz, fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.errors import IndefiniteError, TooLargeError, shorten
from hfield.fields.base.flint_types import Rational
from hfield.orders import hermite
from hfield.orders.base_values import BaseNumber, ThetaSeries
from hfield.orders.basis import AlgebraBasis
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.validation import natural

Row = tuple[int, ...]
MAX_LISTED = 10**6
"""The largest number of vectors in a list."""


def expect_definite(ambient: AlgebraBasis, what: str) -> None:
    """Raise :class:`IndefiniteError` unless the algebra is totally definite."""
    if ambient.definite:
        return
    raise IndefiniteError(
        f"{shorten(ambient.algebra)} {ambient.base.why_indefinite}, so infinitely many elements may have "
        f"one norm: {what} needs {ambient.base.definite_algebra}"
    )


# --- one lattice, its form Tr(N(x)) ----------------------------------------------------------------


def up_to(lattice: LatticeValue, bound: int) -> Iterator[tuple[Row, int]]:
    """Yield one of ±x for each x ≠ 0 with Tr(N(x)) ≤ ``bound``·content, and the integer Tr(N(x))/content.

    Elements are rows over the denominator of the lattice.
    """
    rows, gram = lattice.reduced
    columns = list(zip(*hermite.tuples(rows), strict=True))
    combination, domain = lattice.ambient.kernels.combination, lattice.ambient.domain
    for x, value in domain.vectors.short_vectors(gram, domain.form_factor * bound):
        yield combination(x, columns), value // domain.form_factor


def least_norm(lattice: LatticeValue) -> int:
    """Return the least Tr(N(x)) for x ≠ 0, as a multiple of the content (over ℤ, of the norm)."""
    domain = lattice.ambient.domain
    least: int = domain.vectors.least_vectors(lattice.reduced[1])[0] // domain.form_factor
    return least


def shortest(lattice: LatticeValue) -> tuple[Quaternion, ...]:
    """Return all x ≠ 0 with the least Tr(N(x)), both x and −x."""
    rows, gram = lattice.reduced
    vectors = lattice.ambient.domain.vectors
    found = (hermite.combination(x, rows) for x in vectors.least_vectors(gram)[1])
    return _signed(lattice, found)


def multiple_of_content(lattice: LatticeValue, n: Rational) -> fmpq:
    """Return a rational number as a multiple of the content of Tr(N(x))."""
    ambient, domain = lattice.ambient, lattice.ambient.domain
    return domain.as_fraction(n) * domain.fraction(ambient.scale * lattice.den**2, lattice.content)


def of_norm(lattice: LatticeValue, norm: BaseNumber) -> tuple[Quaternion, ...]:
    """Return all elements with a given norm, a number of the field. Raises :class:`TooLargeError`."""
    base = lattice.ambient.base
    if not norm:
        return (lattice.element([0] * lattice.ambient.size),)
    if not base.is_totally_positive(norm):
        return ()
    form = form_of_norm(lattice, norm)
    if form is None:
        return ()
    found = _rows(lattice, norm, form, "elements of norm at most")
    return _signed(lattice, (hermite.tuples(row)[0] for row in found))


Form = tuple[list[list[int]], fmpz_mat, int]


def form_of_norm(lattice: LatticeValue, norm: BaseNumber) -> Form | None:
    """Return a multiple of Tr(N(x)/ν) on a reduced basis, the basis as rows over the denominator, and a
    value.

    The value is that of the elements with N(x) = ν; None if there are none.
    """
    ambient = lattice.ambient
    rational = ambient.base.as_rational(norm)
    if rational is not None:  # the form is a multiple of Tr(N(x))
        rows, gram = lattice.reduced
        domain = ambient.domain
        length = multiple_of_content(lattice, rational) * (domain.form_factor * ambient.degree)
        return (gram, rows, domain.numerator(length)) if domain.denominator(length) == 1 else None
    gram, basis, den = reduced(ambient, lattice.rows, 1 / norm)
    return gram, (basis * lattice.den).numer_denom()[0], 2 * ambient.degree * den


def _rows(
    lattice: LatticeValue, norm: BaseNumber, form: Form, expected: str | None = None
) -> Iterator[fmpz_mat]:
    gram, basis, length = form
    ambient, domain = lattice.ambient, lattice.ambient.domain
    has_norm = ambient.kernels.has_norm
    for x in domain.vectors.vectors_of_length(gram, length, expected):
        row = domain.matrix(1, len(x), x) * basis
        if has_norm(ambient, lattice.den, row, norm):
            yield row


def first_of_norm(lattice: LatticeValue, norm: BaseNumber) -> fmpz_mat | None:
    """Return an element with a given totally positive norm, as a row over the denominator, or None."""
    form = form_of_norm(lattice, norm)
    if form is None:
        return None
    gram, basis, length = form
    ambient, domain = lattice.ambient, lattice.ambient.domain
    for n in range(len(gram)):  # in a reduced basis a vector of least length is usually there
        if gram[n][n] == length:
            row = domain.matrix([basis.tolist()[n]])
            if ambient.kernels.has_norm(ambient, lattice.den, row, norm):
                return row
    return next(_rows(lattice, norm, form), None)


def element_of_norms(lattice: LatticeValue, norms: Sequence[BaseNumber]) -> Quaternion | None:
    """Return an element with one of these norms in a definite algebra, or None if there is none."""
    for x in norms:
        row = first_of_norm(lattice, x)
        if row is not None:
            return lattice.element(hermite.tuples(row)[0])
    return None


def rows_of_norm(lattice: LatticeValue, norm: BaseNumber) -> Iterator[fmpq_mat]:
    """Yield one of ±x for each x with a given totally positive norm."""
    form = form_of_norm(lattice, norm)
    if form is not None:
        below = lattice.ambient.domain.fraction(1, lattice.den)
        yield from (row * below for row in _rows(lattice, norm, form))


def of_norm_at_most(lattice: LatticeValue, n: object) -> tuple[Quaternion, ...]:
    """Return all x, including 0, with Tr(N(x)) at most a rational number, ascending. Raises
    :class:`TooLargeError`.

    Over polynomials the number is a bound for the degree of N(x).
    """
    base, domain = lattice.ambient.base, lattice.ambient.domain
    bound = base.norm_bound(lattice, n)
    if bound < 0:
        return ()
    found = _signed(lattice, (row for row, _ in up_to(lattice, bound)))
    zero = lattice.element([0] * lattice.ambient.size)
    return (zero, *sorted(found, key=lambda q: domain.length(base.trace(base.inside(q.norm())))))


def _signed(lattice: LatticeValue, rows: Iterable[Row]) -> tuple[Quaternion, ...]:
    """Return the elements of some rows and their negatives, in a fixed order."""
    both: list[Row] = []
    for row in rows:
        both += dict.fromkeys((row, tuple(-x for x in row)))
        if len(both) > MAX_LISTED:
            raise TooLargeError(
                f"more than {MAX_LISTED} elements have so small a norm; theta_series(n) counts them"
            )
    key = lattice.ambient.domain.sort_key
    return tuple(lattice.element(row) for row in sorted(both, key=key, reverse=True))


def theta_series(lattice: LatticeValue, n: object) -> ThetaSeries:
    """Return the number of elements of each norm. Raises :class:`TooLargeError`.

    Over ℤ it is the list [r(0), …, r(n)], where r(m) belongs to the norm ``m·norm``. Over other bases it is
    {ν: r(ν)}: for the norms of trace at most n, ordered by trace, or over polynomials for those of degree at
    most n, ordered by degree.
    """
    bound, ambient = natural(n, "a theta series goes up to"), lattice.ambient
    step, (rows, gram) = ambient.base.theta_step(lattice), lattice.reduced
    return ambient.kernels.theta_series(
        ambient, lattice.den, rows, gram, lattice.content, step, bound
    )


def ternary_theta_series(order: LatticeValue, n: object) -> ThetaSeries:
    """Return the theta series of the elements of trace 0 in R + 2O, where R is the ring of integers of the
    base.
    """
    bound, ambient = natural(n, "a theta series goes up to"), order.ambient
    den, rows, gram = order.reduced_ternary
    unit = fmpz(ambient.scale * den**2)
    return ambient.kernels.theta_series(ambient, den, rows, gram, unit, Fraction(1), bound)


def ternary_rows(order: LatticeValue) -> fmpq_mat:
    """Return a basis of the lattice of elements 2x − tr(x), of rank 3n over ℤ."""
    den, rows, _ = order.ternary
    return rows * fmpq(1, den)


# --- rows of any rank, other forms -----------------------------------------------------------------


def reduced(
    ambient: AlgebraBasis, rows: fmpq_mat, c: BaseNumber
) -> tuple[list[list[int]], fmpq_mat, int]:
    """Return a multiple of ``Tr(c·tr(x·conj(y)))`` on a reduced basis, the basis, and the factor.

    ``rows`` are a basis of a lattice of any rank.
    """
    whole, den = (rows * ambient.form(c) * rows.transpose()).numer_denom()
    gram, change = whole.lll(transform=True, rep="gram")
    return [list(map(int, row)) for row in gram.tolist()], change * rows, int(den)
