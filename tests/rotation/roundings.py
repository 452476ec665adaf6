"""Bounds of rounding errors of a formula for all inputs in boxes at once: first order, and what is left.

A `Number` is what a formula computes with: enclosures of its exact value over boxes, of how much it moves by
each rounding on the way (a rounding multiplies by 1 + ε, |ε| ≤ U), and of all of second order. Values are
numbers, or linear forms in the coordinates of a point. Enclosures are pairs of floats, rounded outwards.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

U = 2.0**-53
Enclosure = tuple[Any, Any]
Form = dict[int, Enclosure]  # by the coordinate of the point; the key −1 is that of plain numbers
names = itertools.count()


def _out(low: Any, high: Any) -> Enclosure:
    return np.nextafter(low, -np.inf), np.nextafter(high, np.inf)


def _plus(a: Enclosure, b: Enclosure) -> Enclosure:
    return _out(a[0] + b[0], a[1] + b[1])


def _times(a: Enclosure, b: Enclosure) -> Enclosure:
    ends = [x * y for x in a for y in b]
    return _out(np.minimum.reduce(ends), np.maximum.reduce(ends))


def _size(a: Enclosure) -> Any:
    return np.maximum(np.abs(a[0]), np.abs(a[1]))


def _summed(a: Form, b: Form) -> Form:
    return {k: _plus(a[k], b[k]) if k in a and k in b else a.get(k, b.get(k)) for k in {*a, *b}}  # type: ignore[misc]


def _product(a: Form, b: Form) -> Form:
    if -1 not in a:
        a, b = b, a  # one of the two is a plain number
    return {k: _times(a[-1], x) for k, x in b.items()}


def _up(x: Any) -> Any:
    return np.nextafter(x, np.inf)


Sizes = dict[int, Any]


def _sizes(form: Form) -> Sizes:
    return {k: _size(x) for k, x in form.items()}


def _most(*terms: Sizes) -> Sizes:
    """Return an upper bound of a sum."""
    total: Sizes = {}
    for term in terms:
        for k, x in term.items():
            total[k] = _up(total.get(k, 0.0) + x)
    return total


def _multiplied(a: Sizes, b: Sizes) -> Sizes:
    if -1 not in a:
        a, b = b, a
    return {k: _up(a.get(-1, 0.0) * x) for k, x in b.items()} if a else {}


def _scaled(a: Sizes, factor: float) -> Sizes:
    return {k: _up(factor * x) for k, x in a.items()}


def half_ulp(size: Any) -> Any:
    """Return in units of U the most that rounding a number up to that size is off by.

    What is next below a power of two counts as that: roundings before may have taken it there.
    """
    return np.exp2(np.floor(np.log2(np.maximum((1.0 + 1e-12) * size, 2.0**-200))))


class Number:
    """A number of a formula, over boxes of inputs.

    Parameters
    ----------
    value : dict
        Enclosures of the exact value.
    noise : dict of dicts
        By the roundings: enclosures of the derivative by ε.
    rest : dict
        Bounds of what is of second order, in units of U².
    degree : int
        With which power of an unknown factor, the length of a quaternion, the number grows. At 0 its
        exponent is known, and with it half a unit in its last place.
    """

    def __init__(
        self,
        value: Form,
        noise: dict[int, Form] | None = None,
        rest: Sizes | None = None,
        degree: int = 0,
    ) -> None:
        self.value, self.noise, self.rest = value, noise or {}, rest or {}
        self.degree = degree

    def _unit(self) -> Form:
        """Return what a rounding is multiplied with: the number, or half a unit in its last place."""
        if self.degree:
            return self.value
        sizes = _most(_sizes(self.value), _scaled(self.moved, U), _scaled(self.rest, U * U))
        return {k: (half_ulp(x), half_ulp(x)) for k, x in sizes.items()}

    @property
    def moved(self) -> Sizes:
        """Bounds of what all roundings together do in first order, in units of U."""
        return _most(*map(_sizes, self.noise.values()))

    def rounded(self) -> Number:
        """Return the same after one more rounding."""
        noise = {**self.noise, next(names): self._unit()}
        rest = _most(self.rest, self.moved, _scaled(self.rest, U))
        return Number(self.value, noise, rest, self.degree)

    def _sum(self, other: Any, sign: float) -> Number:
        if type(other) is int and other == 0:  # nothing is added
            return self
        b = other if isinstance(other, Number) else Number({-1: (other, other)})
        assert self.degree == b.degree or (not isinstance(other, Number) and other == 0.0)
        turned = (sign, sign)

        def signed(form: Form) -> Form:
            return form if sign > 0 else {k: _times(turned, x) for k, x in form.items()}

        noise = {
            k: _summed(self.noise.get(k, {}), signed(b.noise.get(k, {})))
            for k in {*self.noise, *b.noise}
        }
        value = _summed(self.value, signed(b.value))
        return Number(value, noise, _most(self.rest, b.rest), self.degree).rounded()

    def __add__(self, other: Any) -> Number:
        return self._sum(other, 1.0)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Number:
        return self._sum(other, -1.0)

    def __rsub__(self, other: Any) -> Number:
        return (-self)._sum(other, 1.0)

    def __neg__(self) -> Number:
        return self._by(-1.0)

    def _by(self, factor: float) -> Number:
        """Return the product with ±1 or a power of two, which is exact."""
        pair = (factor, factor)
        noise = {k: {j: _times(pair, x) for j, x in form.items()} for k, form in self.noise.items()}
        return Number(
            {j: _times(pair, x) for j, x in self.value.items()},
            noise,
            _scaled(self.rest, abs(factor)),
            self.degree,
        )

    def __mul__(self, other: Any) -> Any:
        if type(other) is int and other == 0:
            return 0
        if not isinstance(other, Number):
            if np.frexp(abs(other))[0] == 0.5:
                return self._by(float(other))
            other = Number({-1: (float(other), float(other))})
        return self.product(other).rounded()

    def product(self, other: Number) -> Number:
        """Return the product before it is rounded."""
        a, b = self, other
        noise: dict[int, Form] = {}
        for k in {*a.noise, *b.noise}:
            noise[k] = _summed(
                _product(a.value, b.noise[k]) if k in b.noise else {},
                _product(a.noise[k], b.value) if k in a.noise else {},
            )
        x, y = (_most(_sizes(n.value), _scaled(n.moved, U), _scaled(n.rest, U * U)) for n in (a, b))
        rest = _most(_multiplied(x, b.rest), _multiplied(a.rest, y), _multiplied(a.moved, b.moved))
        return Number(_product(a.value, b.value), noise, rest, a.degree + b.degree)

    __rmul__ = __mul__

    def __rtruediv__(self, other: Any) -> Number:
        """Return 1/x, of positive plain numbers."""
        assert other == 1.0
        low, high = self.value[-1]
        assert (low > 0.0).all()
        inverse = _out(1.0 / high, 1.0 / low)
        slope = _times(inverse, (-inverse[1], -inverse[0]))
        noise = {k: _product({-1: slope}, form) for k, form in self.noise.items()}
        moved, rest = self.moved.get(-1, 0.0), self.rest.get(-1, 0.0)
        off = _up(_up(moved + U * rest) ** 2 * _up(_up(inverse[1] * inverse[1]) * inverse[1]))
        assert (U * moved * inverse[1] < 1e-3).all()
        second = _up(_up(rest * _up(inverse[1] * inverse[1])) + 1.01 * off)
        return Number({-1: inverse}, noise, {-1: second}, -self.degree).rounded()


def _apart(total: Number) -> tuple[Number, Number]:
    """Return a number rounded, and what that cut off."""
    high = total.rounded()
    name = next(k for k in high.noise if k not in total.noise)
    low = {name: {k: (-b, -a) for k, (a, b) in high.noise[name].items()}}
    zero = {k: (0.0 * a, 0.0 * b) for k, (a, b) in total.value.items()}
    return high, Number(zero, low, _most(total.moved, _scaled(total.rest, U)), total.degree)


def together(a: Number, b: Number) -> Number:
    """Return the sum before it is rounded."""
    noise = {k: _summed(a.noise.get(k, {}), b.noise.get(k, {})) for k in {*a.noise, *b.noise}}
    return Number(_summed(a.value, b.value), noise, _most(a.rest, b.rest), a.degree)


def fused_numbers(a: Any, b: Any, c: Any) -> Number:
    """Return ``a·b + c``, rounded once."""
    a, b = (x if isinstance(x, Number) else Number({-1: (x, x)}) for x in (a, b))
    total: Number = a.product(b) + c
    return total


def two_sum(a: Any, b: Any) -> tuple[Number, Number]:
    """Return what `rotation.native.pairs.two_sum` does, with its error as a number."""
    if not isinstance(a, Number):
        a, b = b, a
    b = b if isinstance(b, Number) else Number({-1: (b, b)})
    return _apart(together(a, b))


def two_product(xp: Any, a: Number, b: Number) -> tuple[Number, Number]:
    """Return the product rounded, and its error."""
    return _apart(a.product(b))


def norm(image: list[Number], keys: tuple[int, ...]) -> tuple[Any, Any]:
    """Return bounds of ‖error‖/‖v‖ of linear forms, in units of U: of first order, and the rest of it.

    The first is the spectral norm of the matrix of absolute sums, by L. Collatz: of M ≥ 0 no more than the
    largest of (M·s)ᵢ/sᵢ, for any s > 0.
    """
    found = []
    for sizes in ([n.moved for n in image], [_scaled(n.rest, U) for n in image]):
        p = [[row.get(k, 0.0) + 0.0 * image[0].moved[keys[0]] for k in keys] for row in sizes]
        m = [[sum(r[i] * r[j] for r in p) for j in range(len(keys))] for i in range(len(keys))]
        s = [np.ones_like(p[0][0]) for _ in keys]
        for _ in range(6):
            t = [sum(a * b for a, b in zip(row, s, strict=True)) + 1e-9 for row in m]
            s = [x / np.maximum.reduce(t) + 1e-9 for x in t]
        t = [sum(a * b for a, b in zip(row, s, strict=True)) for row in m]
        ratio = np.maximum.reduce([a / b for a, b in zip(t, s, strict=True)])
        found.append(np.sqrt(ratio) * (1.0 + 1e-12))  # a hundred roundings of this very calculation
    return found[0], found[1]


def image_error(own: Any, fused: bool, sizes: Any, shared: Sequence[Enclosure] = ()) -> Any:
    """Return a bound of ‖error‖/‖v‖ of m·v, in units of U, m an orthogonal matrix but for its errors.

    For every G, |wᵀ·G·v| ≤ ½·(wᵀ·|Gᵀ|·w + vᵀ·|G|·v) with |G| = √(Gᵀ·G), and a sum over all G is at most
    half of the sum of the largest eigenvalues of Σ|Gᵀ| and Σ|G|. Those of the sums of a row of m are eᵢ·bᵀ
    with parts b of the row; the squares of the rows add up to 1 as m is orthogonal.

    Parameters
    ----------
    own : array, shape (3, 3, n)
        How far each entry may be off by what no other entry shares.
    fused : bool
        Whether the sums of a row are fused multiply-adds.
    sizes : array, shape (3, 3, n)
        Bounds of the entries.
    shared : sequence of pairs of arrays (3, 3, n)
        Enclosures of how far the matrix is off by other roundings.
    """
    rows, columns = (3.0, (3.0, 2.0, 1.0)) if fused else (2.0, (2.0, 2.0, 1.0))
    own = own if fused else own + sizes  # a rounding for each product
    left = np.moveaxis(rows * np.eye(3)[..., None] + np.eye(3)[..., None] * own.sum(axis=1), -1, 0)
    right = np.moveaxis(np.diag(columns)[..., None] + np.eye(3)[..., None] * own.sum(axis=0), -1, 0)
    around = np.zeros(len(left))
    for low, high in shared:
        middle = 0.5 * (low + high)
        around += np.sqrt(((high - low) ** 2).sum(axis=(0, 1))) * 0.51
        u, s, vt = np.linalg.svd(np.moveaxis(middle, -1, 0))
        left = left + np.einsum("nij,nj,nkj->nik", u, s, u)
        right = right + np.einsum("nji,nj,njk->nik", vt, s, vt)
    largest = (np.linalg.eigvalsh(m)[:, -1] for m in (left, right))
    return (0.5 * sum(largest) + around) * (1.0 + 1e-9)


def turned_error(matrix: Sequence[Sequence[Number]], fused: bool) -> Any:
    """Return what `image_error` does for a matrix of numbers."""
    numbers = [x for row in matrix for x in row]
    n = len(numbers[0].value[-1][0])

    def filled(entries: Iterable[Any]) -> Any:
        return np.array([np.broadcast_to(x, n) for x in entries]).reshape(3, 3, n)

    own, shared = np.zeros((3, 3, n)), []
    for name in sorted({name for x in numbers for name in x.noise}):
        parts = [x.noise.get(name, {-1: (0.0, 0.0)})[-1] for x in numbers]
        low, high = (filled(ends) for ends in zip(*parts, strict=True))
        size = _size((low, high))
        if np.count_nonzero(size.any(axis=-1)) > 1:
            shared.append((low, high))
        else:
            own += size
    sizes = filled(_size(x.value[-1]) for x in numbers)
    second = np.sqrt((filled(x.rest.get(-1, 0.0) for x in numbers) ** 2).sum(axis=(0, 1)))
    return image_error(own, fused, sizes, shared) + U * second


def proved(
    evaluate: Any, grid: tuple[Any, Any], bound: float, most: int = 400_000
) -> tuple[float, int]:
    """Show that ``evaluate(low, high)`` is below a bound, by halving boxes; return the largest, and how many.

    ``evaluate`` takes the corners of boxes, (n, k) each; the grid is those that it begins with.
    """
    low, high = grid
    largest, count = 0.0, 0
    while len(low):
        count += len(low)
        if count > most:
            raise AssertionError(f"not shown with {most} boxes: {len(low)} are left, near {low[0]}")
        above = np.concatenate(
            [evaluate(low[n : n + 4000], high[n : n + 4000]) for n in range(0, len(low), 4000)]
        )
        fine = above < bound
        largest = max(largest, float(above[fine].max(initial=0.0)))
        low, high = low[~fine], high[~fine]
        widest = np.argmax(high - low, axis=-1)
        rows = np.arange(len(low))
        middle = 0.5 * (low + high)[rows, widest]
        upper, lower = low.copy(), high.copy()
        upper[rows, widest], lower[rows, widest] = middle, middle
        low, high = np.concatenate([low, upper]), np.concatenate([lower, high])
    return largest, count
