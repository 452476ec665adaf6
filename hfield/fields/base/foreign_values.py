"""Describe a value of another ring in error messages."""

import numbers
from typing import TYPE_CHECKING, TypeGuard

import flint

from hfield.core.primality import is_prime
from hfield.fields.base.flint_types import SparsePolynomial

if TYPE_CHECKING:
    import galois


def is_galois(x: object) -> TypeGuard["galois.FieldArray"]:
    """Return whether x is a galois array or scalar, without importing galois."""
    return hasattr(type(x), "irreducible_poly")


def parent_name(x: object) -> str | None:
    """Return the name of the ring or library that x belongs to, or None for numbers and unknown types."""
    kind = type(x).__name__
    if isinstance(x, flint.nmod):
        n = x.modulus()
        return f"GF({n})" if is_prime(n) else f"ZZ/{n}"
    if isinstance(x, flint.fmpz_mod):
        return "the integers modulo another, large number"
    if isinstance(x, flint.fq_default):
        p, n = int(x.polynomial().modulus()), len(x.to_list())
        return f"GF({p**n})"
    is_of_ours = type(x).__module__.startswith("hfield.fields.") and hasattr(x, "__radd__")
    if is_of_ours and hasattr(x, "field"):  # places and ideals have a field too, and are no numbers
        return str(x.field)
    if isinstance(x, SparsePolynomial):
        return f"the polynomials in {','.join(x.context().names())} ({kind})"
    if kind in ("Surd", "Closed", "NumberInField"):
        return "the algebraic numbers"
    if is_galois(x):
        return f"galois's {type(x).name} modulo {type(x).irreducible_poly}"
    return None


def describe(x: object, ring: str, is_exact: bool, characteristic: int) -> tuple[str, str]:
    """Return a description of x, and of how to convert it, for the error of a ring that rejects it."""
    found = parent_name(x)
    if found is not None:
        other = ", with another modulus" if found == ring else ""
        return (
            f"{x} of {found}{other}",
            "elements of different rings do not mix; convert it explicitly",
        )
    called = f"{x!r} ({type(x).__name__})"
    if is_exact and isinstance(x, numbers.Complex):
        if isinstance(x, complex):
            example = f"'{x.real:g} + {x.imag:g}*I'"
        else:
            example = "'3' or '1/2'" if characteristic else f"{str(x)!r}"
        number = (
            f"write a text such as {example}, or a Fraction"
            if x == x
            else "and this is not a number"
        )
        return called, f"a float is not exact; {number}"
    return called, "expected an int, a Fraction, an element of the ring, or a text"
