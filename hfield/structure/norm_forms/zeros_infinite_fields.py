"""Zero norms over the infinite fields that have a theory of places: ℚ, ℚ(√d), k(t)."""

from collections.abc import Callable

from hfield.errors import UndecidedError
from hfield.factorisation import is_prime
from hfield.product import Constants, Coordinates
from hfield.rings.base import Ring
from hfield.rings.functions import FunctionField
from hfield.rings.integers import QQ
from hfield.rings.quadratic import QuadraticField
from hfield.structure.forms import NormalForm
from hfield.structure.function_fields.conic_bundle import RamifiedError, solve_conic_functions
from hfield.structure.global_field import global_field
from hfield.structure.norm_forms.zero_norm_answer import ZeroNorm, found, none
from hfield.structure.quadratic_fields.conic_quadratic import solve_conic_quadratic
from hfield.structure.quadratic_fields.hilbert_quadratic import pair
from hfield.structure.ramification import ramification
from hfield.structure.rationals.conic_rationals import solve_conic
from hfield.structure.rationals.hilbert_rationals import hilbert_symbol_q, ramified_places_q
from hfield.structure.rationals.rational_embedding import traceless_root_rational

Procedure = Callable[[Ring, Constants, NormalForm], ZeroNorm | None]
_LOCAL = "Hilbert symbols at the places (Voight, Quaternion Algebras, chapter 12)"
_CONIC = "ramified nowhere, so the conic has a point (Hasse and Minkowski), and this is one"


def by_places(ring: Ring, c: Constants, form: NormalForm) -> ZeroNorm | None:
    """Decide by the ramified places; where there are none, solve the conic."""
    try:
        places = ramification(ring, form)
    except UndecidedError:
        partial = _at_small_primes(ring, form)
        if not partial:
            raise
        shown = ", ".join(map(str, partial))
        return none(
            "ramified places",
            f"the algebra is ramified at {shown}, maybe elsewhere too",
            partial,
            _LOCAL,
        )
    if places is None:
        return None
    if places:
        shown = ", ".join(map(str, places))
        reason = (
            f"the algebra is ramified at the places {shown}, so it has no zero divisor even locally"
        )
        return none(
            "ramified places",
            reason,
            places,
            _LOCAL,
        )
    if isinstance(ring, FunctionField):
        return _functions(ring, c)
    if isinstance(ring, QuadraticField):
        return found(ring, c, form.back(_quadratic(ring, form)), "conic", _CONIC)
    x, y, z = (ring(u) for u in solve_conic(form.a, form.b))
    return found(ring, c, form.back((z, x, y, ring.zero)), "conic", _CONIC)


def _at_small_primes(ring: Ring, form: NormalForm) -> tuple[int, ...]:
    """Return the primes below 200 where an algebra over ℚ ramifies; nothing is factored for that."""
    if ring.name != "QQ":
        return ()
    primes = (p for p in range(2, 200) if is_prime(p))
    return tuple(p for p in primes if hilbert_symbol_q(form.a, form.b, p) < 0)


def _quadratic(ring: QuadraticField, form: NormalForm) -> Coordinates:
    """Return an element of norm 0 over ℚ(√d): a square root of d over ℚ less √d, or a point of the conic."""
    (a, s), (b, t) = (pair(ring, x) for x in form.constants)
    if s or t:
        x, y, z = solve_conic_quadratic(ring, form.a, form.b)
        return z, x, y, ring.zero
    if not ramified_places_q(a, b):
        x, y, z = (ring(u) for u in solve_conic(a, b))
        return z, x, y, ring.zero
    root = traceless_root_rational(QQ, Constants(QQ(a), QQ.zero, QQ(b)), QQ(ring.d))
    assert root is not None, "an algebra over ℚ that ℚ(√d) splits contains a square root of d"
    _, x, y, z = (ring(u) for u in root)
    return -ring.gen, x, y, z


def _functions(ring: FunctionField, c: Constants) -> ZeroNorm:
    try:
        w, x, y = solve_conic_functions(ring, c)
    except RamifiedError as error:
        shown = ", ".join(map(str, error.place))
        reason = (
            "all residues are trivial, so the algebra comes from one over QQ, its value at a point of "
            f"the line, and that one is ramified at {shown}"
        )
        return none("specialisation", reason, error.place, "Faddeev's exact sequence")
    return found(
        ring, c, (w, x, y, ring.zero), "conic", "no place is ramified, and this is a zero divisor"
    )


def inseparable(ring: Ring, c: Constants) -> ZeroNorm:
    """Answer for characteristic 2 and t = 0, where the algebra is commutative and N is additive."""
    zero, one = ring.zero, ring.one
    a, _, b = c
    field = global_field(ring)
    if field is not None:
        # x = u² + g·v²: 1, a and b are dependent over the squares
        (u, v), (s, t) = field.square_parts(a), field.square_parts(b)
        q = (u, one, zero, zero) if ring.is_zero(v) else (u * t + s * v, t, v, zero)
        return found(ring, c, q, "squares", "1, a and b are linearly dependent over the squares")
    for square, unit in (
        (a, (one, zero, zero)),
        (b, (zero, one, zero)),
        (a * b, (zero, zero, one)),
    ):
        root = ring.sqrt(square)
        if root is not None:
            reason = f"{ring.text(square)} is a square in {ring.name}"
            return found(ring, c, (root, *unit), "square root", reason)
    raise UndecidedError(
        f"whether 1, a, b, ab are independent over the squares of {ring.name} is not decided"
    )


PROCEDURES: list[tuple[str, Procedure]] = [("ramified places", by_places)]
