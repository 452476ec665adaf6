"""Modules over the integers of a number field K, as lattices in Kᵐ: pseudo-bases, inverse ideals.

Rows are coordinates in an integral basis of K, n for each of the m coordinates.
"""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Any

import flint

from hfield.errors import LatticeError, UndecidedError
from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.fields.number_fields.ring import NumberField

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.ideals import Ideal
    from hfield.orders.over_integers.frames import Frame

    PseudoBasis = tuple[tuple[tuple[Any, ...], Quaternion], ...]

COEFFICIENTS = 12  # of b in Steinitz's step that are tried; most are good


def hermite(rows: list[list[int]], size: int) -> flint.fmpz_mat:
    """Return the Hermite normal form, square, of integer rows of full rank."""
    return flint.fmpz_mat(size, size, flint.fmpz_mat(rows).hnf().entries()[: size * size])


def rational_hermite(rows: list[list[flint.fmpq]], size: int) -> list[list[flint.fmpq]]:
    """Return a basis in Hermite's form of the lattice that rational rows of full rank span."""
    whole, below = flint.fmpq_mat(rows).numer_denom()
    found: list[list[flint.fmpq]] = (flint.fmpq_mat(hermite(whole.tolist(), size)) / below).tolist()
    return found


def unique_rows(rows: flint.fmpq_mat) -> flint.fmpq_mat:
    """Return the Hermite normal form of a basis of what rows span over ℤ, of full rank."""
    whole, den = rows.numer_denom()
    n = rows.ncols()
    table = whole.hnf().tolist()[:n]
    if len(table) < n or not table[-1][-1]:
        raise LatticeError(
            f"expected generators of a lattice of full rank {n} over ZZ; got {whole.rank()}"
        )
    return flint.fmpq_mat(flint.fmpz_mat(table)) * flint.fmpq(1, int(den))


def meet(first: flint.fmpq_mat, second: flint.fmpq_mat) -> flint.fmpq_mat:
    """Return the intersection, the dual of the sum of the duals in the plain pairing of coordinates."""
    both = [*first.inv().transpose().tolist(), *second.inv().transpose().tolist()]
    return unique_rows(flint.fmpq_mat(both)).inv().transpose()


def multiplication(field: NumberField, x: Any, m: int = 1) -> flint.fmpq_mat:
    """Return the matrix that multiplies vectors of Kᵐ by x, from the right of rows of coordinates."""
    block = coordinate_rows(field, [w * x for w in field.integral_basis()]).tolist()
    zero = [flint.fmpq(0)] * field.degree
    return flint.fmpq_mat([zero * k + row + zero * (m - 1 - k) for k in range(m) for row in block])


def inverse_ideal(field: NumberField, ideal: list[Any]) -> list[Any]:
    """Return a basis over ℤ of the x with x·I integral, for the basis of an ideal I."""
    # coordinates v with v·B integral for all columns B: v is in the inverse of the lattice of these
    columns = [c for y in ideal for c in multiplication(field, y).transpose().tolist()]
    lattice = flint.fmpq_mat(rational_hermite(columns, field.degree))
    return [element_of(field, row) for row in lattice.transpose().inv().tolist()]


def pseudo_basis(
    field: NumberField, rows: flint.fmpq_mat
) -> list[tuple[tuple[Any, ...], list[Any]]]:
    """Return ideals Iₜ and vectors xₜ: a module of full rank in Kᵐ is the direct sum of the Iₜ·xₜ.

    From the last coordinate on: the coordinates there are an ideal I, and I⁻¹ times the module has a vector
    whose coordinate is 1; what is left are the vectors where it is 0 (Voight, *Quaternion Algebras*, 9.3.6).
    """
    n, size = field.degree, rows.nrows()
    out = []
    # the last coordinate first, so that Hermite's form sets aside the vectors where it is 0
    module = [_turned(row, n) for row in rows.tolist()]
    while size:
        module = rational_hermite(module, size)
        ideal = [element_of(field, row[:n]) for row in module[:n]]
        factors = (multiplication(field, x, size // n) for x in inverse_ideal(field, ideal))
        larger = [row for x in factors for row in (flint.fmpq_mat(module) * x).tolist()]
        basis = rational_hermite(larger, size)[:n]
        block = flint.fmpq_mat([row[:n] for row in basis])
        combination = coordinate_rows(field, [field.one]) * block.inv()
        assert all(c.q == 1 for c in combination.entries()), "I⁻¹·I contains 1"
        vector = (combination * flint.fmpq_mat(basis)).entries()
        out.append((tuple(ideal), _turned([*[flint.fmpq(0)] * (rows.nrows() - size), *vector], n)))
        module = [row[n:] for row in module[n:]]
        size -= n
    return out[::-1]


def _turned(row: list[flint.fmpq], n: int) -> list[flint.fmpq]:
    """Return the coordinates, n numbers each, in the opposite order."""
    return [c for k in range(len(row) - n, -1, -n) for c in row[k : k + n]]


def free_basis(frame: Frame, pairs: PseudoBasis) -> tuple[Quaternion, ...]:
    """Return a basis of a module that is given by ideals and vectors, one that is free.

    ``I·x + J·y`` is ``ℤ_K·(a·x + b·y) + I·J·(s·y − t·x)`` for a in I and b in J with a·s + b·t = 1, s in I⁻¹
    and t in J⁻¹ (Steinitz): what is left at last is principal exactly where the module is free. Raises
    :class:`LatticeError` for another one.
    """
    found: list[Quaternion] = []
    left: list[tuple[Ideal, Quaternion]] = []
    for basis, x in pairs:
        ideal = frame.ideal(list(basis))
        principal = ideal.is_principal()
        if principal:
            found.append(x * principal.generator)
        else:
            left.append((ideal, x))
    while left:
        if len(left) == 1:
            raise LatticeError(
                f"this lattice is no free module over the integers of {frame.integers.ring.name}: it is one "
                f"with a factor {left[0][0]}, which is not principal"
            )
        (I, x), (J, y), *left = left
        a, b, s, t = _combination(frame, I, J)
        found.append(x * a + y * b)
        rest, vector = I * J, y * s - x * t
        principal = rest.is_principal()
        if principal:
            found.append(vector * principal.generator)
        else:
            left.append((rest, vector))
    return tuple(found)


def _combination(frame: Frame, I: Ideal, J: Ideal) -> tuple[Any, Any, Any, Any]:
    """Return a in I, b in J, s in I⁻¹ and t in J⁻¹ with a·s + b·t = 1."""
    a = I.elements[0]
    U, inverse = frame.integers.principal(a) / I, J.inverse()
    digits = sorted(range(-COEFFICIENTS, COEFFICIENTS + 1), key=abs)
    for c in product(digits, repeat=frame.n):
        b = sum((y * n for y, n in zip(J.elements, c, strict=True)), frame.field.zero)
        if b == frame.field.zero:
            continue
        V = frame.integers.principal(b) * inverse
        if U + V == 1:
            break
    else:
        raise UndecidedError(f"no small element of {J} was found that generates it modulo {U}")
    # 1 as a sum of elements of U and V: a reduced basis of all integers, and how it is made of both
    rows = flint.fmpz_mat([*U.rows.numer_denom()[0].tolist(), *V.rows.numer_denom()[0].tolist()])
    reduced, change = rows.lll(transform=True)
    n = frame.n
    own = flint.fmpq_mat(flint.fmpz_mat(reduced.tolist()[n:]))
    one = coordinate_rows(frame.field, [frame.field.one]) * own.inv()
    steps = one * flint.fmpq_mat(flint.fmpz_mat(change.tolist()[n:]))
    y = element_of(frame.field, (flint.fmpq_mat(1, n, steps.entries()[:n]) * U.rows).entries())
    s, t = y * a.inverse(), (frame.field.one - y) * b.inverse()
    out = frame.integers.outside
    return out(a), out(b), out(s), out(t)
