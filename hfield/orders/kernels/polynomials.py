"""The functions for lattices over 𝔽_q[t] where numbers are counted by degrees, not by traces."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from hfield.orders.base import Counts

if TYPE_CHECKING:
    from flint import fmpz_mat

    from hfield.orders.base_values import ThetaSeries
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.enumeration import Gram


def theta_series(
    ambient: AlgebraBasis,
    den: int,
    rows: fmpz_mat,
    gram: Gram,
    unit: Any,
    step: Fraction,
    bound: int,
) -> ThetaSeries:
    """Return {ν: r(ν)} for the norms ν of degree at most a bound, from a reduced basis."""
    domain: Any = ambient.domain
    scale = domain.integer(ambient.scale * den**2)
    degree = bound + scale.degree() - unit.degree()
    factor = domain.fraction(unit, scale)
    signs = len(dict.fromkeys([domain.integer(1), domain.integer(-1)]))
    values = Counter(value for _, value in domain.vectors.short_vectors(gram, degree))
    zero = domain.fraction(0)
    counts = {(domain.fraction(x) * factor,): signs * number for x, number in values.items()}
    found = Counts({(zero,): 1, **counts}, 1)
    shown: ThetaSeries = ambient.base.shown_counts(found, step, bound)
    return shown
