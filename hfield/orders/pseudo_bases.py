"""Pseudo-bases: a module over the integers of a field as a direct sum of ideals times vectors; free bases.

A vector of m numbers is a row of m·n rational numbers: the coordinates of each number in an integral basis.
"""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING

import flint

from hfield.errors import LatticeError, UndecidedError
from hfield.fields.number_fields.integral_basis import coordinate_rows, element_of
from hfield.orders.base import Base, number_field_integers
from hfield.orders.base_values import BaseNumber
from hfield.orders.hermite import tuples

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.fields.number_fields.elements import FieldElement
    from hfield.fields.number_fields.ideals import FractionalIdeal
    from hfield.orders.base import NumberFieldIntegers
    from hfield.orders.basis import AlgebraBasis
    from hfield.orders.lattice_values import LatticeValue

    PseudoBasis = tuple[tuple[tuple[BaseNumber, ...], Quaternion], ...]

COEFFICIENTS = 12  # of b in Steinitz's step that are tried; most are good


def hermite(rows: list[list[int]], size: int) -> flint.fmpz_mat:
    """Return the Hermite normal form, a square matrix, of integer rows of full rank."""
    return flint.fmpz_mat(size, size, flint.fmpz_mat(rows).hnf().entries()[: size * size])


def rational_hermite(rows: list[list[flint.fmpq]], size: int) -> list[list[flint.fmpq]]:
    """Return a basis in Hermite form of the lattice spanned by rational rows of full rank."""
    whole, below = flint.fmpq_mat(rows).numer_denom()
    found: list[list[flint.fmpq]] = (flint.fmpq_mat(hermite(whole.tolist(), size)) / below).tolist()
    return found


def multiplication(base: Base, x: BaseNumber, m: int = 1) -> flint.fmpq_mat:
    """Return the matrix of multiplication by x on vectors of Kᵐ, acting on rows of coordinates from the
    right.
    """
    block = base.coordinate_rows([w * x for w in base.integral_basis]).tolist()
    zero = [flint.fmpq(0)] * base.degree
    return flint.fmpq_mat([zero * k + row + zero * (m - 1 - k) for k in range(m) for row in block])


def inverse_ideal(base: Base, ideal: list[BaseNumber]) -> list[BaseNumber]:
    """Return a ℤ-basis of all x with x·I integral, given a basis of an ideal I."""
    # coordinates v with v·B integral for all columns B: v is in the inverse of their lattice
    columns = [c for y in ideal for c in multiplication(base, y).transpose().tolist()]
    lattice = flint.fmpq_mat(rational_hermite(columns, base.degree))
    return [base.element_of(row) for row in lattice.transpose().inv().tolist()]


def pseudo_basis(lattice: LatticeValue) -> PseudoBasis:
    """Return bases of ideals, and quaternions: the lattice is the direct sum of their products."""
    return lattice.ambient.kernels.choose(by_last_coordinates, polynomials=_free)(lattice)


def _free(lattice: LatticeValue) -> PseudoBasis:
    base = lattice.ambient.base
    return tuple(((base.outside(base.field.one),), q) for q in lattice.basis)


def by_last_coordinates(lattice: LatticeValue) -> PseudoBasis:
    """Return a pseudo-basis over ℤ or ℤ_K: pairs of an ideal, given by a basis over ℤ, and an element of the
    algebra.
    """
    ambient = lattice.ambient
    return tuple(
        (tuple(map(ambient.base.outside, ideal)), ambient.quaternion(row))
        for ideal, row in _pseudo_basis(ambient.base, lattice.rows)
    )


def _pseudo_basis(
    base: Base, rows: flint.fmpq_mat
) -> list[tuple[tuple[BaseNumber, ...], list[flint.fmpq]]]:
    """Return ideals Iₜ and vectors xₜ such that a module of full rank in Kᵐ is the direct sum of the Iₜ·xₜ.

    The last coordinates of all vectors form an ideal I. I⁻¹ times the module has a vector with last
    coordinate 1, and the method continues with the vectors with last coordinate 0 (Voight, *Quaternion
    Algebras*, 9.3.6).
    """
    n, size = base.degree, rows.nrows()
    out = []
    # the last coordinate first, so that the Hermite form separates the vectors in which it is 0
    module = [_turned(row, n) for row in rows.tolist()]
    while size:
        module = rational_hermite(module, size)
        ideal = [base.element_of(row[:n]) for row in module[:n]]
        factors = (multiplication(base, x, size // n) for x in inverse_ideal(base, ideal))
        larger = [row for x in factors for row in (flint.fmpq_mat(module) * x).tolist()]
        basis = rational_hermite(larger, size)[:n]
        block = flint.fmpq_mat([row[:n] for row in basis])
        combination = base.coordinate_rows([base.field.one]) * block.inv()
        assert all(c.q == 1 for c in combination.entries()), "I⁻¹·I contains 1"
        vector = (combination * flint.fmpq_mat(basis)).entries()
        out.append((tuple(ideal), _turned([*[flint.fmpq(0)] * (rows.nrows() - size), *vector], n)))
        module = [row[n:] for row in module[n:]]
        size -= n
    return out[::-1]


def _turned(row: list[flint.fmpq], n: int) -> list[flint.fmpq]:
    """Return the coordinates in blocks of n, with the blocks in reverse order."""
    return [c for k in range(len(row) - n, -1, -n) for c in row[k : k + n]]


def basis_modulo_numbers(order: LatticeValue) -> tuple[Quaternion, Quaternion, Quaternion]:
    """Return i, j, k that form with 1 a basis of an order; numbers of the field may be added to them.

    In degree 1 the basis is reduced if the algebra is definite. Raises :class:`LatticeError` for an order
    that is not a free module.
    """
    ambient = order.ambient
    if ambient.degree == 1:
        den, rows, _ = order.reduced_ternary if ambient.definite else order.ternary
        i, j, k = (order.element(row, 2 * den) for row in tuples(rows))
    else:
        _, *pairs = pseudo_basis(order)  # the first are the integers of the field
        i, j, k = free_basis(ambient, tuple(pairs))
    return i, j, k


def free_basis(ambient: AlgebraBasis, pairs: PseudoBasis) -> tuple[Quaternion, ...]:
    """Return a basis of a free module that is given by ideals and vectors.

    ``I·x + J·y`` is ``ℤ_K·(a·x + b·y) + I·J·(s·y − t·x)`` for a in I and b in J with a·s + b·t = 1, s in I⁻¹
    and t in J⁻¹ (Steinitz). The ideal that remains at the end is principal if and only if the module is free.
    Raises :class:`LatticeError` if it is not.
    """
    found: list[Quaternion] = []
    left: list[tuple[FractionalIdeal, Quaternion]] = []
    base = number_field_integers(ambient.base)
    for basis, x in pairs:
        ideal = base.ideal(list(basis))
        principal = ideal.is_principal()
        if principal:
            found.append(x * principal.generator)
        else:
            left.append((ideal, x))
    while left:
        if len(left) == 1:
            raise LatticeError(
                f"this lattice is not a free module over the integers of {base.ring.name}: it is one "
                f"with a factor {left[0][0]}, which is not principal"
            )
        (I, x), (J, y), *left = left
        a, b, s, t = _combination(base, I, J)
        found.append(x * a + y * b)
        rest, vector = I * J, y * s - x * t
        principal = rest.is_principal()
        if principal:
            found.append(vector * principal.generator)
        else:
            left.append((rest, vector))
    return tuple(found)


def _combination(
    base: NumberFieldIntegers, I: FractionalIdeal, J: FractionalIdeal
) -> tuple[FieldElement, FieldElement, FieldElement, FieldElement]:
    """Return a in I, b in J, s in I⁻¹ and t in J⁻¹ with a·s + b·t = 1."""
    a = I.basis[0]
    U, inverse = base.principal(a) / I, J.inverse()
    digits = sorted(range(-COEFFICIENTS, COEFFICIENTS + 1), key=abs)
    for c in product(digits, repeat=base.degree):
        b = sum((y * n for y, n in zip(J.basis, c, strict=True)), base.field.zero)
        if b == base.field.zero:
            continue
        V = base.principal(b) * inverse
        if U + V == 1:
            break
    else:
        raise UndecidedError(f"no small element of {J} was found that generates it modulo {U}")
    # 1 as a sum of elements of U and V: a reduced basis of all integers, and how it is made of both
    rows = flint.fmpz_mat([*U.rows.numer_denom()[0].tolist(), *V.rows.numer_denom()[0].tolist()])
    reduced, change = rows.lll(transform=True)
    n = base.degree
    own = flint.fmpq_mat(flint.fmpz_mat(reduced.tolist()[n:]))
    one = coordinate_rows(base.field, [base.field.one]) * own.inv()
    steps = one * flint.fmpq_mat(flint.fmpz_mat(change.tolist()[n:]))
    y = element_of(base.field, (flint.fmpq_mat(1, n, steps.entries()[:n]) * U.rows).entries())
    s, t = y * a.inverse(), (base.field.one - y) * b.inverse()
    out = base.outside
    return out(a), out(b), out(s), out(t)
