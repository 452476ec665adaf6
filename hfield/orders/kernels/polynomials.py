"""Functions for lattices over 𝔽_q[t] that differ because elements are ordered by degree, not by trace."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from hfield.orders.base import Counts

if TYPE_CHECKING:
    from flint import fmpz_mat, fq_default_poly

    from hfield.orders.base_values import BaseNumber, Integer, IntegerMatrix, ThetaSeries
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.enumeration import Gram


def class_forms(
    ambient: AlgebraBasis, grams: list[fmpz_mat], norm: BaseNumber, units: Sequence[BaseNumber]
) -> list[fmpz_mat]:
    """Return the forms unchanged: only degrees are compared, and units and ν do not change the comparison."""
    return grams


def has_norm(ambient: AlgebraBasis, den: Integer, row: IntegerMatrix, norm: BaseNumber) -> bool:
    """Return True: in degree 1 the value of the form is the norm."""
    return True


def least_products(
    vectors: Sequence[tuple[int, list[int]]], forms: Sequence[fmpz_mat]
) -> Sequence[int]:
    """Return the indices of all vectors: no vector is preferred."""
    return range(len(vectors))


def theta_series(
    ambient: AlgebraBasis,
    den: int,
    rows: fmpz_mat,
    gram: Gram,
    unit: fq_default_poly,
    step: Fraction,
    bound: int,
) -> ThetaSeries:
    """Return {ν: r(ν)} for the norms ν of degree at most a bound, from a reduced basis."""
    domain = ambient.domain
    scale = domain.integer(ambient.scale * den**2)
    degree = bound + int(domain.length(scale) - domain.length(unit))
    signs = len(dict.fromkeys([domain.integer(1), domain.integer(-1)]))
    values = Counter(value for _, value in domain.vectors.short_vectors(gram, degree))
    counts: dict[tuple[Integer, ...], int]
    counts = {(x * unit,): signs * number for x, number in values.items()}
    found = Counts({(domain.integer(0),): 1, **counts}, scale)
    return ambient.base.shown_counts(found, step, bound)
