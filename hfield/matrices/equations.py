"""Linear equations Σ aₙ·x·bₙ = c, and systems of them, in coordinates over the base ring."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from operator import itemgetter
from typing import Any, TypeVar

from hfield.algebra.quaternion import Parent, Quaternion
from hfield.errors import NotationError, UndecidedError, shorten
from hfield.fields.linear_algebra.echelon import null_space, solution
from hfield.matrices.vocabulary import vocabulary
from hfield.syntax import Reader, Vocabulary, spell
from hfield.verdicts import Verdict

T = TypeVar("T")
S = TypeVar("S", bound="Solutions[Any]")
Vector = tuple[Quaternion, ...]


@dataclass(frozen=True, eq=False, repr=False)
class Solutions(Verdict[T]):
    """All solutions: ``particular`` plus the combinations of ``kernel``, a basis over the field; or none.

    If there is no solution, it is false, ``particular`` is None, and ``reason`` says why. Then ``functional``
    contains four scalars per equation that prove this: the combination of the coordinates of the left sides
    with these scalars is 0 for all unknowns, but that of the right sides is not.
    """

    kernel: tuple[T, ...] = ()
    functional: tuple[object, ...] = ()

    @property
    def particular(self) -> T | None:
        """One of the solutions, the witness."""
        return self.witness

    def __repr__(self) -> str:
        shown = ", ".join(map(str, self.kernel))
        return super().__repr__() + (f", plus combinations of {shown}" if self and shown else "")


class LinearSolutions(Solutions[Quaternion]):
    """All solutions of an equation in one unknown."""


class SystemSolutions(Solutions[dict[str, Quaternion]]):
    """All solutions of a system, by the names of the unknowns."""


def solve_linear(
    algebra: Parent, terms: Sequence[tuple[object, object]], c: object
) -> LinearSolutions:
    """Return all x with Σ a·x·b = c for the pairs (a, b) of ``terms``.

    Raises :class:`UndecidedError` over rings that are not fields.
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
    return _solve(algebra, [(of_basis, right)], LinearSolutions, itemgetter(0))


def _solve(
    algebra: Parent,
    equations: Sequence[tuple[Sequence[Quaternion], Quaternion]],
    kind: type[S],
    name: Callable[[Vector], T],
) -> S:
    """Solve equations, each given by the images of e, i, j, k for each unknown, and the right side.

    ``name`` converts a vector with an entry for each unknown to a member of the solutions.
    """
    F = algebra.ring
    if not F.is_field:
        raise UndecidedError(f"{F.no_field}: linear equations are solved over fields only")
    rows = [
        list(row)
        for images, _ in equations
        for row in zip(*(q.coordinates for q in images), strict=True)
    ]
    right = [x for _, q in equations for x in q.coordinates]
    found, width = solution(F, rows, [[x] for x in right]), len(rows[0])
    kernel = tuple(name(_vector(algebra, v)) for v in null_space(F, rows, width))
    if found is not None:
        particular = name(_vector(algebra, [row[0] for row in found]))
        return kind(True, witness=particular, kernel=kernel)
    columns = [list(column) for column in zip(*rows, strict=True)]
    for y in null_space(F, columns, len(rows)):
        value = sum((s * x for s, x in zip(y, right, strict=True)), F.zero)
        if not F.is_zero(value):
            weights = ", ".join(map(F.text, y))
            several = len(equations) > 1
            what = "the right sides" if several else f"c = {equations[0][1]}"
            reason = (
                f"({weights}) times the coordinates of the left side{'s' * several} is 0 for every "
                f"{'choice of the unknowns' if several else 'x'}, but {F.text(value)} for {what}"
            )
            return kind(False, reason, kernel=kernel, functional=tuple(y))
    raise AssertionError("a system without solution has a functional that says so")


def _vector(algebra: Parent, v: Sequence[object]) -> Vector:
    return tuple(algebra(*v[n : n + 4]) for n in range(0, len(v), 4))


@dataclass(frozen=True)
class Affine:
    """A constant plus a linear map over the base ring, given by the images of e, i, j, k for each unknown."""

    constant: Quaternion
    images: tuple[Quaternion, ...] = ()

    def each(self, f: Callable[[Quaternion], Quaternion]) -> Affine:
        """Return the composition with a linear function."""
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
        """Return the constant. Raises :class:`NotationError` if the unknown occurs."""
        if self.images:
            raise NotationError(
                f"{what} contains the unknown, so the equation is not linear; roots() of a polynomial and "
                "`hfield roots` solve equations with all coefficients on the left"
            )
        return self.constant


def read_equation(algebra: Parent, text: str, unknown: str = "x") -> LinearSolutions:
    """Solve an equation such as ``i*x - x*j == k``, linear over the base field in one unknown.

    ``conj``, ``trace``, ``scalar`` and ``vector`` of the unknown count as linear. Raises
    :class:`NotationError` for equations that are unreadable or not linear, and :class:`UndecidedError` over
    rings that are not fields.
    """
    both = _read(algebra, text, [unknown])
    if not both.images:
        raise NotationError(f"the unknown {unknown} does not occur in {shorten(text)!r}")
    return _solved(algebra, both.images, -both.constant)


def read_system(algebra: Parent, texts: Sequence[str], unknowns: Sequence[str]) -> SystemSolutions:
    """Solve equations in several unknowns; as :func:`read_equation`.

    >>> from hfield import H
    >>> read_system(H("QQ"), ["i*x + y = j", "x - y*i = 0"], ["x", "y"]).particular
    {'x': -1/2*k, 'y': 1/2*j}
    """
    if not texts or not unknowns:
        raise NotationError("expected equations, and the names of their unknowns")
    if len(set(unknowns)) < len(unknowns):
        raise NotationError(f"an unknown is named twice: {', '.join(unknowns)}")
    zeros = (algebra.scalar(0),) * (4 * len(unknowns))
    spelled = [_spelled(algebra, text, unknowns) for text in texts]
    for x in unknowns:
        if not any(x in names_in(text) for text in spelled):
            raise NotationError(f"the unknown {x} does not occur in the equations")
    read = [_read(algebra, text, unknowns) for text in texts]

    def named(v: Vector) -> dict[str, Quaternion]:
        return dict(zip(unknowns, v, strict=True))

    equations = [(f.images or zeros, -f.constant) for f in read]
    return _solve(algebra, equations, SystemSolutions, named)


UNKNOWNS = "xyzuvwpqrst"


def unknowns_in(algebra: Parent, texts: Sequence[str]) -> list[str]:
    """Return the letters from p to z in equations that have no other meaning."""
    ring = algebra.ring
    letters = [x for x in UNKNOWNS if x not in ring.names()]
    words: set[str] = set()
    for text in texts:
        try:
            words.update(names_in(_spelled(algebra, text, letters)))
        except NotationError:  # a matrix, or a text that its reader will reject
            words.update(names_in(text))
    return [x for x in letters if x in words]


def names_in(text: str) -> list[str]:
    """Return the names in a text, with repetitions."""
    return re.findall(r"[^\W\d]\w*", text)


def _spelled(algebra: Parent, text: str, unknowns: Sequence[str]) -> str:
    """Return an equation in the plain letters of the language."""
    ring = algebra.ring
    known = (*unknowns, *"eijk", *ring.names())
    return spell(text, Vocabulary.of_names(known, ring.functions())).text


def _read(algebra: Parent, text: str, unknowns: Sequence[str]) -> Affine:
    """Return the left side of an equation minus the right side."""
    F = algebra.ring
    sides = _spelled(algebra, text, unknowns).replace("==", "=").split("=")
    if len(sides) != 2:
        raise NotationError(f"an equation has one =, as in i*x - x*j = k; found {shorten(text)!r}")

    def linear(f: Callable[[Quaternion], Quaternion]) -> Callable[[Affine], Affine]:
        return lambda x: x.each(f)

    def alone(f: Callable[..., Quaternion]) -> Callable[..., Affine]:
        return lambda x, *more: Affine(f(x.known("its argument"), *more))

    zero = algebra.scalar(0)
    names, functions = vocabulary(algebra, Affine, lambda x: x.known("its argument"))
    for n, x in enumerate(unknowns):
        if x in names:
            where = algebra if x in "eijk" else F.name
            raise NotationError(
                f"{x} is an element of {where}; name the unknown otherwise (q, say)"
            )
        before, after = (zero,) * (4 * n), (zero,) * (4 * (len(unknowns) - n - 1))
        names[x] = Affine(zero, (*before, *algebra.basis, *after))
    functions |= {
        "/": lambda x, y: x.each(lambda q: q / y.known("a divisor")),
        "**": alone(lambda q, n: q**n),
        "conj": linear(Quaternion.conjugate),
        "trace": linear(lambda q: algebra.scalar(q.trace())),
        "scalar": linear(lambda q: algebra.scalar(q.scalar_part)),
        "vector": linear(lambda q: q.vector_part),
        "norm": alone(lambda q: algebra.scalar(q.norm())),
        "inv": alone(Quaternion.inverse),
        "comm": lambda x, y: x * y - y * x,
    }
    reader = Reader(
        lambda n: Affine(algebra.scalar(n)), names, functions, str(algebra), F.parse_limit
    )
    left, right = map(reader.read, sides)
    both: Affine = left - right
    return both
