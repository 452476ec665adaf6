"""The names of the rings that correspond to sympy domains and galois field classes."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, TypeGuard

from hfield.errors import RingError, shorten
from hfield.fields.base.from_sympy import is_of_sympy

if TYPE_CHECKING:
    import galois
    import sympy
    from sympy.polys.domains.domain import Domain


def name_of_foreign_ring(spec: object) -> str | None:
    """Return the name of the ring that a sympy domain or a galois field represents; None for other objects.

    Raises :class:`RingError` for a ring that is not available, or whose text could mean another ring.
    """
    if isinstance(spec, type) and hasattr(spec, "irreducible_poly"):
        return _of_galois(spec)
    if not _is_domain(spec):
        return None
    name = _DOMAINS.get(type(spec).__name__)
    if name is None:
        raise RingError(f"{shorten(spec)} of sympy has no counterpart here")
    return name(spec)


def _is_domain(x: object) -> TypeGuard[Domain]:
    return is_of_sympy(x) and hasattr(x, "is_Exact") and hasattr(x, "characteristic")


def _of_galois(field: type[galois.FieldArray]) -> str:
    p, n = int(field.characteristic), int(field.degree)
    if n == 1:
        return f"GF({p})"
    coefficients = [int(c) for c in field.irreducible_poly.coeffs]
    terms = (f"{c}*x^{n - m}" for m, c in enumerate(coefficients) if c)
    return f"GF({p}^{n},{'+'.join(terms)})"


def _of_residues(domain: Domain) -> str:
    n = int(domain.mod)
    from hfield.core.primality import is_prime

    if is_prime(n):
        return f"GF({n})"
    raise RingError(
        f"sympy.GF({n}) is the ring of integers modulo {n}, which is not a field: write 'ZZ/{n}' for it, or "
        f"'GF({n})' for a field of {n} elements, if there is one"
    )


def _of_floats(domain: Domain) -> str:
    raise RingError(
        f"sympy.{domain} has floats: write 'RDF' for floats, 'RR' or 'CC' for the algebraic numbers"
    )


def _of_polynomials(domain: Domain) -> str:
    return f"{name_of_foreign_ring(domain.domain)}[{_variables(domain)}]"


def _of_fractions(domain: Domain) -> str:
    base = name_of_foreign_ring(domain.domain)
    return f"Frac({base}[{_variables(domain)}])"


def _variables(domain: Domain) -> str:
    names = [getattr(x, "name", None) for x in domain.symbols]
    if None in names:
        raise RingError(f"{shorten(domain)} of sympy: expected symbols as its variables")
    return ",".join(map(str, names))


def _of_algebraic(domain: Domain) -> str:
    """Return the number field, given by the names of its generators or by the polynomial of its generator."""
    import sympy

    if not domain.domain.is_QQ:
        raise RingError(f"{shorten(domain)}: number fields are read over QQ")
    given = domain.orig_ext
    texts = [_number_text(_root(x)) for x in given]
    if all(texts):
        return f"QQ({','.join(map(str, texts))})"
    x = sympy.Symbol("s")
    polynomial = sympy.minimal_polynomial(_root(domain.ext), x, polys=True)
    coefficients = (Fraction(int(c.p), int(c.q)) for c in polynomial.all_coeffs())
    degree = int(polynomial.degree())
    terms = (f"({c})*s^{degree - n}" for n, c in enumerate(coefficients) if c)
    return f"QQ[s]/({'+'.join(terms)})"


def _root(x: sympy.Expr) -> sympy.Expr:
    """Return the value of an algebraic number of sympy, which may be given under another name."""
    while hasattr(x, "alias"):
        x = x.root
    expression: sympy.Expr = x
    return expression


def _number_text(x: sympy.Expr) -> str | None:
    """Return the text of a root of a rational number or of a principal root of unity; else None."""
    import sympy

    if x is sympy.I:
        return "I"
    if x.is_Pow and x.base.is_Rational and x.exp.is_Rational and x.exp.p == 1:
        if x.base < 0 and x.exp.q % 2:
            return None  # not the real root, which root(-2,3) is
        return f"sqrt({x.base})" if x.exp.q == 2 else f"root({x.base},{x.exp.q})"
    n = _order_of_principal_root(x) if isinstance(x, sympy.CRootOf) else None
    if n is not None:
        return f"zeta{n}"
    turn = x.args[0] / (2 * sympy.pi * sympy.I) if isinstance(x, sympy.exp) else None
    if turn is not None and turn.is_Rational and turn.p == 1:
        return f"zeta{turn.q}"
    return None


def _order_of_principal_root(x: sympy.Expr) -> int | None:
    """Return n if a numbered root is exp(2πi/n), as in sympy's cyclotomic fields; else None."""
    import sympy

    degree = int(x.poly.degree())
    for n in range(3, 6 * degree + 7):  # φ(n) > n/6 there
        if sympy.totient(n) == degree and x.poly == sympy.Poly(
            sympy.cyclotomic_poly(n, x.poly.gen), x.poly.gen
        ):
            return (
                n if abs(x.evalf() - sympy.exp(2 * sympy.pi * sympy.I / n).evalf()) < 1e-9 else None
            )
    return None


_DOMAINS: dict[str, Callable[[Domain], str]] = {
    "IntegerRing": lambda _: "ZZ",
    "FLINTIntegerRing": lambda _: "ZZ",
    "GMPYIntegerRing": lambda _: "ZZ",
    "PythonIntegerRing": lambda _: "ZZ",
    "RationalField": lambda _: "QQ",
    "GMPYRationalField": lambda _: "QQ",
    "PythonRationalField": lambda _: "QQ",
    "FiniteField": _of_residues,
    "PythonFiniteField": _of_residues,
    "GMPYFiniteField": _of_residues,
    "GaussianRationalField": lambda _: "QQ(I)",
    "GaussianIntegerRing": lambda _: "ZZ[I]",
    "RealField": _of_floats,
    "ComplexField": _of_floats,
    "PolynomialRing": _of_polynomials,
    "GlobalPolynomialRing": _of_polynomials,
    "FractionField": _of_fractions,
    "AlgebraicField": _of_algebraic,
}
