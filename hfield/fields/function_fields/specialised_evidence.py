"""Evidence that an algebra over ℚ(x) is a division algebra: a value of the variable at which it is one."""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from typing import Any

from hfield.errors import UndecidedError
from hfield.fields.rationals.symbols import hilbert_symbol_q, ramified_places_q
from hfield.primality import primes
from hfield.product import Constants
from hfield.rings.integers import QQ
from hfield.rings.whole_numbers import square_class
from hfield.structure.forms import discriminant, normal_form
from hfield.structure.global_field import known_field

POINTS, FEW = 400, 5  # values tried for a specialisation; those at which all primes are looked for
SMALL = list(primes(1_000))

Evidence = Mapping[str, Any]


def specialised_evidence(c: Constants) -> Iterator[Evidence]:
    """Yield values of the variable at which an algebra over ℚ(x) becomes a division algebra over ℚ.

    There are infinitely many if it is one itself: ℚ is Brauer–Hilbertian (Fein, Saltman and Schacher, *Trans.
    Amer. Math. Soc.* 334 (1992)). At most of them a small prime is ramified.
    """
    for n in range(POINTS):
        point = QQ((n + 1) // 2 * (-1) ** n)
        if any(x.den(point) == 0 for x in c):
            continue
        special = Constants(*(x.num(point) / x.den(point) for x in c))
        if not discriminant(special):
            continue
        proof = _rational(special, every=n < FEW)
        if proof is not None:
            yield {"by": "specialisation", "at": QQ.text(point), "proof": proof}


def _rational(c: Constants, every: bool) -> Evidence | None:
    """Return evidence over ℚ; from small primes alone, or from ``every`` prime if these can be found."""
    form = normal_form(QQ, c)
    if form.a < 0 and form.b < 0:
        return {"by": "ordering"}
    whole = square_class(form.a) * square_class(form.b)
    primes: Iterable[Any] = (
        p for p in SMALL if (p == 2 or whole % p == 0) and hilbert_symbol_q(form.a, form.b, p) < 0
    )
    if every:
        with suppress(UndecidedError):
            primes = ramified_places_q(form.a, form.b)
    return next(known_field(QQ).evidence(c, primes), None)
