"""Ternary quadratic forms and orders: the even Clifford algebra of a form, and the form of an order.

The form of an order with basis 1, i, j, k is ``N(x·[j,k] + y·[k,i] + z·[i,j]) / tr(i·[j,k])``. It is the
discriminant times the norm on the elements of trace 0 in the codifferent. Applied to the even Clifford
algebra of a form, with the basis ``e₂e₃, e₃e₁, e₁e₂``, this returns the same form. So classes of forms of one
discriminant correspond to isomorphism classes of orders (J. Voight, *Quaternion Algebras*, chapter 22), and
forms are compared by comparing orders.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import product
from typing import TYPE_CHECKING, TypeAlias

from flint import fmpz_mat

from hfield.algebra.quaternion import Quaternion
from hfield.core.properties import cached_property
from hfield.errors import IndefiniteError, LatticeError, MixedParentsError, RingError, shorten
from hfield.fields.base.printing import sum_text
from hfield.fields.base.ring import Ring, WithIntegers
from hfield.fields.names import ring as named_ring
from hfield.fields.rationals.ring import QQ
from hfield.fields.rationals.whole_numbers import fraction
from hfield.hints import FORM, Hinted
from hfield.orders.basis import base_of
from hfield.orders.lattice_values import LatticeValue
from hfield.orders.pseudo_bases import basis_modulo_numbers
from hfield.orders.ternary_reduction import reduced_bases
from hfield.verdicts import Verdict

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Parent
    from hfield.orders.base_values import BaseNumber
    from hfield.orders.lattice import Order

Triple = tuple[Quaternion, Quaternion, Quaternion]
Row: TypeAlias = "tuple[BaseNumber, BaseNumber, BaseNumber]"
Matrix: TypeAlias = "tuple[Row, ...]"


class FormEquivalence(Verdict[tuple[Row, ...]]):
    """A verdict on equivalence; the witness is the ``matrix`` M with f(v) = g(v·M) for rows v. It has a
    ``reason``.

    In an indefinite algebra a theorem may decide without a matrix.
    """

    @property
    def matrix(self) -> Matrix | None:
        """The witness."""
        return self.witness

    def __repr__(self) -> str:
        return (
            f"FormEquivalence(holds={self.value}, reason={self.reason!r}, matrix={self.matrix!r})"
        )


class TernaryForm(Hinted):
    """The form ``a·x² + b·y² + c·z² + r·yz + s·xz + t·xy`` over ℤ, or over the integers of a number field.

    >>> from hfield import ternary_form
    >>> f = ternary_form([1, 1, 1, 1, 1, 1]); O = f.order()
    >>> f(1, 0, -1), f.discriminant(), O.is_maximal(), O.unit_count()
    (1, 2, True, 24)
    >>> f.reduced(), f.automorphism_count(), O.ternary_form() == f.reduced()
    (x²+y²+z²+x·z+x·y, 48, True)
    """

    foreign_names = FORM

    def __init__(
        self, ring: Ring, coefficients: Iterable[object], algebras: Callable[..., Parent]
    ) -> None:
        if not (isinstance(ring, WithIntegers) and ring.characteristic == 0):
            raise RingError(
                f"forms are over ℤ or the integers of a number field here, not over {ring.name}"
            )
        self.ring, self._algebras = ring, algebras
        self.coefficients: tuple[BaseNumber, ...] = tuple(map(ring, coefficients))
        if len(self.coefficients) != 6:
            raise LatticeError(
                "a ternary form has six coefficients, of x², y², z², yz, xz and xy; "
                f"{len(self.coefficients)} were given"
            )
        for x in self.coefficients:
            if not _is_integer(ring, x):
                raise LatticeError(
                    f"the coefficient {ring.text(x)} is not an integer of {ring.name}"
                )
        if ring.is_zero(self.discriminant()):
            raise LatticeError(f"{self} is degenerate: its discriminant is 0")

    def __call__(self, x: object, y: object, z: object) -> BaseNumber:
        """Return the value at a vector."""
        u, v, w = map(self.ring, (x, y, z))
        a, b, c, r, s, t = self.coefficients
        value: BaseNumber = a * u * u + b * v * v + c * w * w + r * v * w + s * u * w + t * u * v
        return value

    def discriminant(self) -> BaseNumber:
        """Return the half-discriminant 4abc + rst − ar² − bs² − ct²; it is that of the order up to units."""
        a, b, c, r, s, t = self.coefficients
        return 4 * a * b * c + r * s * t - a * r * r - b * s * s - c * t * t

    def gram_matrix(self) -> Matrix:
        """Return the matrix of f(u + v) − f(u) − f(v); the diagonal has twice the values."""
        a, b, c, r, s, t = self.coefficients
        return (2 * a, t, s), (t, 2 * b, r), (s, r, 2 * c)

    def is_definite(self) -> bool:
        """Return whether the field is totally real and the form is anisotropic at every real place."""
        base = base_of(self.ring)
        a, b, *_, t = self.coefficients
        minors = [base.inside(x) for x in (4 * a * b - t * t, a * self.discriminant())]
        signs = (base.sign(x, place) for x in minors for place in base.real_places)
        return base.is_totally_real and all(sign > 0 for sign in signs)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TernaryForm):
            return NotImplemented
        return self.ring == other.ring and self.coefficients == other.coefficients

    def __hash__(self) -> int:
        return hash((self.ring, *map(self.ring.key, self.coefficients)))

    def _text(self, style: str) -> str:
        square = (("x", 2),), (("y", 2),), (("z", 2),)
        words = *square, (("y", 1), ("z", 1)), (("x", 1), ("z", 1)), (("x", 1), ("y", 1))
        terms = zip((self.ring.text(c, style) for c in self.coefficients), words, strict=True)
        return sum_text((term for term in terms if term[0] != "0"), style)

    def __repr__(self) -> str:
        return self._text("unicode")

    def latex(self) -> str:
        """Write the form in LaTeX."""
        return self._text("latex")

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"

    # --- its order ---------------------------------------------------------------------------------

    @cached_property
    def _clifford(self) -> Triple:
        """The products e₂e₃, e₃e₁, e₁e₂ in the Clifford algebra, as elements of a quaternion algebra."""
        F, rows = self.ring, self._orthogonal
        α, β, γ = (self(*row) for row in rows)
        i, j = -α * β, -β * γ  # the squares of f₁f₂ and f₂f₃
        base = base_of(F)
        r, s = (base.outside(base.square_factor(base.inside(x))) for x in (i, j))
        A = self._algebras(F, i / (r * r), j / (s * s))
        one, I, J, K = A.basis
        I, J, K = I * r, J * s, K * (r * s / β)  # f₁f₂, f₂f₃ and f₁f₃
        table = [[one * α, I, K], [-I, one * β, J], [-K, -J, one * γ]]
        # the e are combinations of the orthogonal f
        inverse = _inverse(F, rows)

        def pair(m: int, n: int) -> Quaternion:
            terms = (
                table[u][v] * (inverse[m][u] * inverse[n][v])
                for u, v in product(range(3), repeat=2)
            )
            total: Quaternion = sum(terms, A.zero)
            return total

        return pair(1, 2), pair(2, 0), pair(0, 1)

    @cached_property
    def _orthogonal(self) -> Matrix:
        """A basis of the space that is orthogonal for the form (Lagrange)."""
        F, gram = self.ring, self.gram_matrix()

        def pairing(u: Sequence[BaseNumber], v: Sequence[BaseNumber]) -> BaseNumber:
            return sum((u[m] * gram[m][n] * v[n] for m, n in product(range(3), repeat=2)), F.zero)

        rest = [[F(int(m == n)) for n in range(3)] for m in range(3)]
        found: list[list[BaseNumber]] = []
        while rest:
            several = [(n, v) for n, v in enumerate(rest)]
            several += [(n, _added(v, u)) for n, v in enumerate(rest) for u in rest[:n]]
            n, f = next((n, v) for n, v in several if not F.is_zero(pairing(v, v)))
            scale = F.inverse(pairing(f, f))
            rest = [_added(v, f, -pairing(v, f) * scale) for m, v in enumerate(rest) if m != n]
            found.append(f)
        return tuple((x, y, z) for x, y, z in found)

    @cached_property
    def _codifferent(self) -> Triple:
        """The elements of trace 0 dual to the three products; f is a multiple of their norm."""
        return dual_basis(self._clifford)[0]

    def order(self) -> Order:
        """Return the even Clifford algebra, an order with the discriminant of the form."""
        return self._order

    @cached_property
    def _order(self) -> Order:
        i, j, k = self._clifford
        return i.algebra.order_from_basis([1, i, j, k])

    # --- forms that are alike ----------------------------------------------------------------------

    def equivalence(self, other: TernaryForm) -> FormEquivalence:
        """Return an answer with an integral ``matrix`` M of unit determinant such that f(v) = g(v·M).

        It is computed from an isomorphism of orders. Raises as :meth:`Order.isomorphism` does:
        :class:`UndecidedError`, and over fields other than ℚ :class:`IndefiniteError`. Raises
        :class:`MixedParentsError` for forms over different rings.

        >>> from hfield import ternary_form
        >>> f, g = ternary_form([1, 1, 3, 0, 0, 0]), ternary_form([3, 2, 1, 0, 0, 2])
        >>> f.equivalence(g).reason
        'the discriminants 12 and 20 do not differ by the square of a unit'
        >>> f.equivalence(ternary_form([1, 2, 3, 0, 0, 2])).matrix
        ((1, 0, 0), (-1, 1, 0), (0, 0, 1))
        """
        F = self.ring
        if not isinstance(other, TernaryForm) or other.ring != F:
            raise MixedParentsError(
                f"expected another form over the integers of {F.name}, not {shorten(repr(other))}"
            )
        ratio = self.discriminant() / other.discriminant()
        root = F.sqrt(ratio) if F.is_square(ratio) else None
        if root is None or not (_is_integer(F, root) and _is_integer(F, F.inverse(root))):
            return FormEquivalence(
                False,
                f"the discriminants {F.text(self.discriminant())} and {F.text(other.discriminant())} "
                "do not differ by the square of a unit",
            )
        first, second = self.order(), other.order()
        onto = second.algebra.isomorphism(first.algebra)
        if onto is None:
            return FormEquivalence(
                False, "their even Clifford algebras are not isomorphic over the field"
            )
        moved = first.algebra.order_from_basis([1, *map(onto, other._clifford)])
        answer = first.isomorphism(moved)
        x = answer.element
        if not answer or x is None:
            return FormEquivalence(bool(answer), f"of their orders: {answer.reason}")
        back = x.inverse()
        images = [x * d * back for d in self._codifferent]
        basis = [onto(q) for q in other._clifford]
        a, b, c = ([root * (d * q).trace() for q in basis] for d in images)
        return FormEquivalence(
            True, "the matrix maps one onto the other", (tuple(a), tuple(b), tuple(c))
        )

    def is_equivalent(self, other: TernaryForm) -> bool:
        """Return whether two forms are equivalent. Raises as :meth:`equivalence` does."""
        return bool(self.equivalence(other))

    def genus(self) -> tuple[TernaryForm, ...]:
        """Return one form of each class in the genus of a definite form.

        They are the forms of the types of orders. Raises :class:`IndefiniteError`, and over a number field
        :class:`LatticeError` for an order that is not a free module.

        >>> from hfield import ternary_form
        >>> ternary_form([1, 1, 23, 1, 0, 0]).genus()
        (x²+y²+23·z²+y·z, x²+4·y²+6·z²+y·z+x·z, 2·x²+3·y²+5·z²−2·y·z+2·x·z+x·y)
        """
        classes = self.order().class_set()
        kinds, orders = classes.types, classes.left_orders()
        out = []
        for kind in range(len(set(kinds))):
            found = orders[kinds.index(kind)].ternary_form()
            u = self.discriminant() / found.discriminant()
            out.append(TernaryForm(self.ring, [u * x for x in found.coefficients], self._algebras))
        return tuple(map(reduced_over_integers, out))

    @property
    def _sign(self) -> int:
        """The sign of the discriminant of a form over ℤ."""
        return 1 if fraction(self.discriminant()) > 0 else -1

    def _reduced_bases(self) -> list[tuple[Sequence[Sequence[int]], tuple[int, ...]]]:
        if self.ring != QQ or not self.is_definite():
            raise IndefiniteError(
                "forms are reduced, and automorphisms counted, where they are definite and over ℤ"
            )
        gram = [[self._sign * int(fraction(x)) for x in row] for row in self.gram_matrix()]
        reduced = fmpz_mat(gram).lll(rep="gram")
        return list(reduced_bases([[int(x) for x in row] for row in reduced.tolist()]))

    def reduced(self) -> TernaryForm:
        """Return the unique reduced form of the class: the first of those reduced after Korkine and
        Zolotarev.

        Equivalent forms have the same reduced form. An isometry maps the reduced bases of one lattice to
        those of the other. All reduced bases are listed, including those with vectors of equal length or
        coefficients 1/2, and the least coefficients in a fixed order are returned. Raises
        :class:`IndefiniteError` except for definite forms over ℤ.
        """
        a, b, c, t, s, r = min(
            (form for _, form in self._reduced_bases()),
            key=lambda form: (form[:3], *((abs(x), x < 0) for x in form[3:])),
        )
        found = [self._sign * x for x in (a // 2, b // 2, c // 2, r, s, t)]
        return TernaryForm(self.ring, found, self._algebras)

    def automorphism_count(self) -> int:
        """Return the number of integral automorphisms of the form. Raises as :meth:`reduced` does."""
        first, *_ = found = [form for _, form in self._reduced_bases()]
        return 2 * found.count(first)


def read_form(text: str, ring: Ring, algebras: Callable[..., Parent]) -> TernaryForm:
    """Read a form in x, y and z, in the notation in which it is printed or as code.

    Raises :class:`NotationError` for anything but a polynomial, :class:`LatticeError` for a polynomial that
    is not a ternary form.
    """
    polynomials = named_ring(f"{ring.name}[x,y,z]")
    exponents = (2, 0, 0), (0, 2, 0), (0, 0, 2), (0, 1, 1), (1, 0, 1), (1, 1, 0)
    coefficients = dict.fromkeys(exponents, ring.zero)
    for monomial, coefficient in polynomials(text).terms():
        if tuple(monomial) not in coefficients:
            raise LatticeError(
                f"{shorten(text)!r} is not a ternary form: expected terms in x², y², z², yz, xz and xy alone"
            )
        coefficients[tuple(monomial)] = ring(coefficient)
    return TernaryForm(ring, coefficients.values(), algebras)


def form_of_order(order: LatticeValue) -> TernaryForm:
    """Return a form whose even Clifford algebra is an order; over ℤ, the reduced form if it is definite.

    Raises :class:`LatticeError` for an order that is not a free module.
    """
    return reduced_over_integers(form_of(basis_modulo_numbers(order), type(order.algebra)))


def reduced_over_integers(form: TernaryForm) -> TernaryForm:
    """Return the reduced form of a definite form over ℤ; return any other form unchanged."""
    return form.reduced() if form.ring == QQ and form.is_definite() else form


def form_of(basis: Triple, algebras: Callable[..., Parent]) -> TernaryForm:
    """Return the form of the order with the basis 1, i, j, k."""
    A = basis[0].algebra
    F = A.ring
    dual, scale = dual_basis(basis)
    base = base_of(F)
    if base.trace(base.inside(scale)) < 0:
        scale = -scale  # of the basis in another order
    values = [scale * d.norm() for d in dual]
    pairs = [scale * (dual[m] * dual[n].conjugate()).trace() for m, n in ((1, 2), (0, 2), (0, 1))]
    return TernaryForm(F, [*values, *pairs], algebras)


def dual_basis(basis: Triple) -> tuple[Triple, BaseNumber]:
    """Return the elements of trace 0 that are dual to i, j, k for the trace, and tr(i·[j,k])."""
    i, j, k = basis
    scale = (i * (j * k - k * j)).trace()
    inverse = i.algebra.ring.inverse(scale)
    return tuple((p * q - q * p) * inverse for p, q in ((j, k), (k, i), (i, j))), scale


def _is_integer(ring: Ring, x: BaseNumber) -> bool:
    base = base_of(ring)
    return bool(base.coordinate_rows([base.inside(x)]).numer_denom()[1] == 1)


def _added(
    u: Sequence[BaseNumber], v: Sequence[BaseNumber], c: BaseNumber | int = 1
) -> list[BaseNumber]:
    return [x + c * y for x, y in zip(u, v, strict=True)]


def _inverse(ring: Ring, m: Matrix) -> list[list[BaseNumber]]:
    """Return the inverse of a 3 × 3 matrix (Cramer)."""

    def minor(r: int, c: int) -> BaseNumber:
        (p, q), (u, v) = ((r + 1) % 3, (r + 2) % 3), ((c + 1) % 3, (c + 2) % 3)
        return m[p][u] * m[q][v] - m[p][v] * m[q][u]

    scale = ring.inverse(sum((m[0][n] * minor(0, n) for n in range(3)), ring.zero))
    return [[minor(r, c) * scale for r in range(3)] for c in range(3)]
