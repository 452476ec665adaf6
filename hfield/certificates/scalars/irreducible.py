"""Irreducibility of integer polynomials over ℚ: modulo a prime, or because no set of roots makes a factor.

The second argument tries everything: a monic factor over ℚ has integer coefficients (Gauss), so the sums of
the k-th powers of its roots are integers; and of every set of some but not all roots one such sum is shown to
be none.
"""

from itertools import product

from hfield.certificates.rejection import Rejected, reject, shown
from hfield.certificates.scalars.finite import Residues
from hfield.certificates.scalars.quotients import Quotient
from hfield.certificates.scalars.root_discs import BITS, Disc, root_discs
from hfield.certificates.work import charge

PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29)
MAX_DEGREE = 14


def check_irreducible(f: list[int], name: str) -> None:
    """Reject a field unless its monic polynomial, low degree first, is shown to be irreducible."""
    if any(_is_irreducible_modulo(p, f) for p in PRIMES):
        return
    n = len(f) - 1
    if n > MAX_DEGREE:
        reject(
            f"that the modulus of {shown(name)} is irreducible is shown up to the degree {MAX_DEGREE} here"
        )
    discs = root_discs(f)
    sums = [[_power(disc, k) for disc in discs] for k in range(1, n + 1)]
    charge(5 * 2**n * n)
    for rest in product((False, True), repeat=n - 1):
        chosen = [0, *(k for k, taken in enumerate(rest, 1) if taken)]
        if len(chosen) < n and not any(_is_no_integer([row[k] for k in chosen]) for row in sums):
            reject(f"the modulus of {shown(name)} may be reducible")


def _is_irreducible_modulo(p: int, f: list[int]) -> bool:
    try:
        Quotient(Residues(p, True, f"GF({p})"), [c % p for c in f])
    except Rejected:  # it is reducible; or there was no work left
        charge(0)
        return False
    return True


def _power(disc: Disc, k: int) -> Disc:
    """Return a disc around the k-th powers of the numbers of a disc."""
    x, y, radius = disc
    re, im, size = 1 << BITS, 0, abs(x) + abs(y) + radius
    bound, error = 1 << BITS, 0
    for _ in range(k):
        # |zw − z'w'| ≤ |z|·|w − w'| + |w'|·|z − z'|, and 2 for what is cut off
        error = (size * error + bound * radius >> BITS) + 4
        re, im = re * x - im * y >> BITS, re * y + im * x >> BITS
        bound = (bound * size >> BITS) + 3
    return re, im, error


def _is_no_integer(terms: list[Disc]) -> bool:
    """Tell whether the sum of numbers in these discs is surely no integer."""
    x, y, error = (sum(column) for column in zip(*terms, strict=True))
    away = min(x % (1 << BITS), -x % (1 << BITS))
    return bool(abs(y) > error or away > error)
