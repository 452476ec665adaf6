"""Names of fields of functions on circles, such as ``QQ(cos(t),sin(t))``, and the fields with these names."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from hfield.errors import HFieldError, RingError, shorten
from hfield.fields.algebraic.ring import RR
from hfield.fields.base.ring import Ring, shared
from hfield.fields.base.variables import variables
from hfield.fields.circles import ring
from hfield.fields.circles.angles import PI, angle_of, angle_text
from hfield.fields.circles.real import RealCircles
from hfield.fields.circles.ring import Angles
from hfield.fields.finite.ring import PrimeField
from hfield.fields.rationals.ring import QQ


def build(base: Ring, angles: Angles, plain: tuple[str, ...]) -> Ring:
    """Return the field of functions on circles over QQ, a number field, RR or GF(p)."""
    if base == RR:
        return shared(RealCircles, ring.build(QQ, angles, plain))
    return ring.build(base, angles, plain)


def read_circles(base: Ring, parts: Sequence[str]) -> Ring:
    """Return K(cos(t), sin(t), …) from the text in the brackets. Raises :class:`RingError`."""
    what = f"{base}({','.join(parts)})"
    known = base in (QQ, RR) or isinstance(base, PrimeField)
    if not (known or hasattr(base, "modulus_over_rationals")):
        raise RingError(f"{shorten(what)}: circles are over QQ, a number field, RR, or GF(p)")
    if base.characteristic == 2:
        raise RingError(
            f"{shorten(what)}: circles are not parametrised by tangents in characteristic 2"
        )
    found: dict[tuple[str, int], set[str]] = {}
    plain: list[str] = []
    for part in parts:
        function, bracket, inner = part.partition("(")
        if not bracket:
            plain.append(part)
            continue
        try:
            angle = angle_of(inner.removesuffix(")"))
        except HFieldError as error:
            raise RingError(f"{shorten(what)}: {error}") from None
        (name, c), *more = angle.items() or [("", Fraction(0))]
        if function not in ("cos", "sin") or more or c.numerator != 1 or name == PI:
            raise RingError(
                f"{shorten(what)}: expected cos(t),sin(t) or cos(t/2),sin(t/2), found {part}"
            )
        found.setdefault((name, c.denominator), set()).add(function)
    names = [name for name, _ in found]
    variables(what, ",".join([*plain, *names]), base)
    for angle_name, functions in found.items():
        if len(functions) < 2:
            shown = angle_text(*angle_name)
            raise RingError(f"{shorten(what)}: expected both cos({shown}) and sin({shown})")
    return build(base, tuple(found), tuple(plain))
