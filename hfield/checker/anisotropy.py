"""Check that a norm form is anisotropic: by an ordering, a level, a place or a specialisation.

At a place two elements u and j of the algebra are given. N(x + y·u) must have twice the least valuation of x
and y, N(j) must have odd valuation, and nothing may cancel in N(x + y·u + j·(z + w·u)). None of this depends
on the characteristic of the field or of its residue fields. docs/explanation/trust.md has the proofs.
"""

from collections.abc import Hashable, Mapping

from hfield.checker.budget import bounded
from hfield.checker.evaluate import Evaluator, RingScalars
from hfield.checker.language import walk
from hfield.checker.rejection import Rejected, a_text, an_object, reject, texts
from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.functions import SeveralVariables
from hfield.checker.scalars.place import E, Place, R
from hfield.checker.scalars.ring import AnyRing, Ring
from hfield.checker.statement import read_setting

Constants = tuple[E, E, E]
KEYS = {
    "ordering": "by",
    "level": "by",
    "place": "by place u j",
    "specialisation": "by at proof",
}


def anisotropic(field: Ring[E], c: Constants[E], data: object, algebra: str) -> tuple[str, ...]:
    """Prove that the norm form of the algebra (a, t, b) is anisotropic, or raise :class:`Rejected`.

    Return the theorems that are cited (none). ``data["by"]`` names the method of proof.
    """
    by = data.get("by") if isinstance(data, Mapping) else None
    if not isinstance(by, str) or by not in KEYS:
        reject(f"the reason for the norm form of {algebra} is of no known kind")
    data = an_object(data, KEYS[by], "a fact about a norm")
    if not field.is_field:
        reject(f"{field.name} is not an exact field")
    if by == "ordering":
        _by_ordering(field, c)
    elif by == "level":
        _by_level(field, c)
    elif by == "place":
        u, j = _quaternion(field, data["u"]), _quaternion(field, data["j"])
        _by_place(field, c, field.place(data["place"]), u, j)
    else:
        point = a_text(data["at"], "a point")
        base, value = field.at(point)
        a, t, b = map(value, c)
        anisotropic(base, (a, t, b), data["proof"], f"{algebra} at {point}")
    return ()


def is_certified(algebra: str, ring: object, data: object) -> bool:
    """Return whether the data prove that the norm form of a named algebra is anisotropic."""
    try:
        with bounded():
            field, c = constants_of(algebra, ring)
            anisotropic(field, c, data, algebra)
    except Rejected:
        return False
    return True


def is_readable(algebra: str, ring: object) -> bool:
    """Return whether this module can read the constants of an algebra and the places of its field."""
    try:
        field, _ = constants_of(algebra, ring)
    except Rejected:
        return False
    return not isinstance(field, SeveralVariables)


def constants_of(algebra: str, data: object) -> tuple[AnyRing, Constants[Hashable]]:
    """Return the field given by the data, and (a, t, b). Raises :class:`Rejected`."""
    ring = read_ring(data)
    setting = read_setting(algebra, ring)
    constants = ring.named_elements(
        node for tree in setting.constants for node in walk(tree) if node[0] in ("name", "call")
    )
    evaluator = Evaluator(RingScalars(ring), setting.constants, constants)
    if evaluator.conditions:
        reject("the structure constants are not defined")
    a, t, b = evaluator.constants
    return ring, (a, t, b)


def _quaternion(field: Ring[E], value: object) -> list[E]:
    found = texts(value, "coordinates", 4)
    if len(found) != 4:
        reject("a quaternion has four coordinates")
    return [field.read(text) for text in found]


def _by_ordering(field: Ring[E], c: Constants[E]) -> None:
    """Use 4N = (2w + tx)² − d·x² − b·((2y + tz)² − d·z²), d = t² + 4a, with d and b negative."""
    a, t, b = c
    d = field.add(field.mul(t, t), field.mul(field.number(4), a))
    signs = zip(field.signs(d), field.signs(b), strict=True)  # None if there is no ordering
    if (-1, -1) not in signs:
        reject("the constants are not both negative in an ordering that is known here")


def _by_level(field: Ring[E], c: Constants[E]) -> None:
    """Use that −1 is not a sum of two squares, in an algebra H(F)."""
    a, t, b = c
    hamilton = all(field.equal(x, field.number(n)) for x, n in ((a, -1), (t, 0), (b, -1)))
    if not hamilton or field.characteristic == 2 or not field.level_above(2):
        reject("−1 may be a sum of two squares, or this is not H(F)")


def _by_place(field: Ring[E], c: Constants[E], place: Place[E, R], u: list[E], j: list[E]) -> None:
    """Use that X² − tr(u)·X + N(u) is integral and has no root in the residue ring, and N(j) has odd
    valuation.

    tr(j) and N(u + j) − N(u) − N(j) must be divisible by ``odd``.
    """
    name, odd = place.name, field.need_inverse(place.odd)

    def paired(p: list[E], q: list[E]) -> E:
        both = norm(field, c, [field.add(x, y) for x, y in zip(p, q, strict=True)])
        return field.add(both, field.neg(field.add(norm(field, c, p), norm(field, c, q))))

    one = [field.one, field.zero, field.zero, field.zero]
    trace, size = place.residue(paired(one, u)), place.residue(norm(field, c, u))
    if trace is None or size is None or not place.is_irreducible(trace, size):
        reject(f"the polynomial of u has a root among the residues at {name}, or is not integral")
    unit = place.residue(field.mul(odd, norm(field, c, j)))
    if unit is None or not place.is_unit(unit):
        reject(f"the norm of j has not the valuation of {name}")
    if any(place.residue(field.mul(odd, paired(p, j))) is None for p in (one, u)):
        reject(f"the traces of j and of its product with u are not divisible by {name}")


def norm(field: Ring[E], c: Constants[E], q: list[E]) -> E:
    """Return n(w, x) − b·n(y, z), where n(u, v) = u² + t·uv − a·v²."""
    a, t, b = c

    def binary(u: E, v: E) -> E:
        mixed = field.mul(u, field.add(u, field.mul(t, v)))
        return field.add(mixed, field.neg(field.mul(a, field.mul(v, v))))

    w, x, y, z = q
    return field.add(binary(w, x), field.neg(field.mul(b, binary(y, z))))
