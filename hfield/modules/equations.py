"""Linear equations with one unknown quaternion: Σ aₙ·x·bₙ = c, by coordinates over the base ring."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import NotationError, UndecidedError, shorten
from hfield.structure.linear_algebra.echelon import null_space, solution
from hfield.syntax import Reader, plain_element


@dataclass(frozen=True)
class LinearSolutions:
    """All solutions: ``particular`` plus the combinations of ``kernel``, a basis over the field; or none.

    Where there is none it is false, ``particular`` is None, and ``reason`` says why: ``functional`` are four
    scalars whose sum with the coordinates of the left side is 0 for every x, and with those of c is not.
    """

    particular: Quaternion | None
    kernel: tuple[Quaternion, ...]
    reason: str = ""
    functional: tuple[object, ...] = ()

    def __bool__(self) -> bool:
        return self.particular is not None


def solve_linear(
    algebra: Parent, terms: Sequence[tuple[object, object]], c: object
) -> LinearSolutions:
    """Return all x with Σ a·x·b = c for the pairs (a, b) of ``terms``.

    Raises :class:`UndecidedError` over rings that are no fields.
    """
    pairs = [(algebra(a), algebra(b)) for a, b in terms]
    images = []
    for u in algebra.basis:
        image = algebra.scalar(0)
        for a, b in pairs:
            image = image + a * u * b
        images.append(image)
    return _solved(algebra, images, algebra(c))


def _solved(algebra: Parent, of_basis: Sequence[Quaternion], right: Quaternion) -> LinearSolutions:
    F = algebra.ring
    if not F.is_field:
        raise UndecidedError(f"linear equations are solved over fields, and {F.name} is none")
    images = [q.coordinates for q in of_basis]
    rows = [list(row) for row in zip(*images, strict=True)]
    found = solution(F, rows, [[x] for x in right.coordinates])
    kernel = tuple(algebra(*v) for v in null_space(F, rows, 4))
    if found is not None:
        return LinearSolutions(algebra(*(row[0] for row in found)), kernel)
    for y in null_space(F, [list(v) for v in images], 4):
        value = sum((s * x for s, x in zip(y, right.coordinates, strict=True)), F.zero)
        if not F.is_zero(value):
            weights = ", ".join(map(F.text, y))
            reason = (
                f"({weights}) times the coordinates of the left side is 0 for every x, "
                f"and {F.text(value)} for c = {right}"
            )
            return LinearSolutions(None, kernel, reason, tuple(y))
    raise AssertionError("a system without solution has a functional that says so")


@dataclass(frozen=True)
class Affine:
    """A constant plus a map linear over the base ring, known by the images of e, i, j, k."""

    constant: Quaternion
    images: tuple[Quaternion, ...] = ()

    def each(self, f: Callable[[Quaternion], Quaternion]) -> Affine:
        """Return this with a linear function after it."""
        return Affine(f(self.constant), tuple(map(f, self.images)))

    def __neg__(self) -> Affine:
        return self.each(lambda q: -q)

    def __add__(self, other: Affine) -> Affine:
        pairs = zip(self.images, other.images, strict=True)
        images = tuple(p + q for p, q in pairs) if self.images and other.images else None
        return Affine(self.constant + other.constant, images or self.images or other.images)

    def __sub__(self, other: Affine) -> Affine:
        return self + -other

    def __mul__(self, other: Affine) -> Affine:
        if not other.images:
            return self.each(lambda q: q * other.constant)
        return other.each(lambda q: self.known("a factor beside the unknown") * q)

    def known(self, what: str) -> Quaternion:
        """Return the constant. Raises :class:`NotationError` where the unknown is in it."""
        if self.images:
            raise NotationError(
                f"{what} has the unknown in it, so that the equation is not linear; roots() of a polynomial "
                "and `hfield roots` find those of coefficients on the left"
            )
        return self.constant


def read_equation(algebra: Parent, text: str, unknown: str = "x") -> LinearSolutions:
    """Solve an equation such as ``i*x - x*j == k``, linear over the base field in one unknown.

    ``conj``, ``trace``, ``scalar`` and ``vector`` of the unknown are linear, too.
    Raises :class:`NotationError` for what cannot be read or is not linear, and :class:`UndecidedError` over
    rings that are no fields.
    """
    F = algebra.ring
    sides = plain_element(text).replace("==", "=").split("=")
    if len(sides) != 2:
        raise NotationError(f"an equation has one =, as in i*x - x*j = k; found {shorten(text)!r}")
    if unknown in F.names():
        raise NotationError(
            f"{unknown} is an element of {F.name}; name the unknown otherwise (q, say)"
        )

    def linear(f: Callable[[Quaternion], Quaternion]) -> Callable[[Affine], Affine]:
        return lambda x: x.each(f)

    def alone(f: Callable[..., Quaternion]) -> Callable[..., Affine]:
        return lambda x, *more: Affine(f(x.known("its argument"), *more))

    names = {name: Affine(algebra.scalar(x)) for name, x in F.names().items()}
    names |= {name: Affine(q) for name, q in zip("eijk", algebra.basis, strict=True)}
    names[unknown] = Affine(algebra.scalar(0), algebra.basis)
    functions: dict[str, Callable[..., Affine]] = {
        "/": lambda x, y: x.each(lambda q: q / y.known("a divisor")),
        "**": alone(lambda q, n: q**n),
        "conj": linear(Quaternion.conjugate),
        "trace": linear(lambda q: algebra.scalar(q.trace())),
        "scalar": linear(lambda q: algebra.scalar(q.scalar_part)),
        "vector": linear(lambda q: q.vector_part),
        "norm": alone(lambda q: algebra.scalar(q.norm())),
        "inv": alone(Quaternion.inverse),
    }
    reader = Reader(
        lambda n: Affine(algebra.scalar(n)), names, functions, str(algebra), F.parse_limit
    )
    left, right = map(reader.read, sides)
    both = left - right
    if not both.images:
        raise NotationError(f"the unknown {unknown} does not occur in {shorten(text)!r}")
    return _solved(algebra, both.images, -both.constant)
