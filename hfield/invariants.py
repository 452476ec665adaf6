"""What an algebra is: the methods of :class:`hfield.QuaternionAlgebra` that hand over to ``structure``."""

from __future__ import annotations

from collections.abc import Hashable
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

from hfield import structure
from hfield.errors import CoercionError, MixedParentsError, UndecidedError, shorten
from hfield.factorisation import Factors, known_primes
from hfield.hints import ALGEBRA, Hinted
from hfield.product import Constants
from hfield.quaternion import Parent, Quaternion
from hfield.rings.base import Ring

if TYPE_CHECKING:
    from hfield.maps import Division, Isomorphism, LinearMap, Splitting


# What may be counted, in singular and plural.
_KINDS = {word: kind for kind in ("elements", "units") for word in (kind, kind[:-1])}
_KINDS |= {kind + end: kind for kind in ("nilpotent", "idempotent") for end in ("", "s")}


class Opposite(NamedTuple):
    """The opposite algebra, in which p and q have the product q·p, and how it is isomorphic.

    ``isomorphism`` maps the given algebra onto ``algebra`` and turns products round, φ(pq) = φ(q)·φ(p).
    """

    algebra: Any
    isomorphism: Any


class Invariants(Hinted, Parent):
    """The part of an algebra that answers what it is.

    Every answer is exact. Where no procedure decides, :class:`UndecidedError` says what was tried.
    """

    elsewhere = ALGEBRA

    def _here(self) -> tuple[Ring, Constants]:
        return self.ring, self.constants

    # --- linear algebra ------------------------------------------------------------------------

    def center(self) -> tuple[Quaternion, ...]:
        """Return a basis of the centre, e first, found by linear algebra in the base ring (thesis 1.1.2).

        Over a ring over which it is not free these are generators, none superfluous: every central element
        is a combination of them, with coefficients that are not unique. Over ℤ/n the centre is the direct
        sum of what each of them generates. Raises :class:`UndecidedError` over infinite rings that are not
        domains, and over rings of one's own, where elimination meets no units.

        >>> from hfield import H
        >>> H("QQ").center(), H("ZZ/4").center()
        ((1,), (1, 2i, 2j, 2k))
        """
        return tuple(self(*c) for c in structure.centre(*self._here()))

    centre = center

    def is_commutative(self) -> bool:
        """Tell whether p·q = q·p always; for H(F) exactly when 2 = 0 in F (thesis 1.1.2)."""
        return structure.is_commutative(*self._here())

    def radical(self) -> tuple[Quaternion, ...]:
        """Return a basis of the Jacobson radical: () where it is 0, as over a field for a semisimple algebra.

        Over a ring over which it is not free these are generators, as in :meth:`center`. Raises
        :class:`UndecidedError` over infinite rings other than fields, ℤ and polynomial rings, over finite
        ones, other than ℤ/n, that are too large to be gone through, and where n cannot be factored.

        >>> from hfield import H
        >>> H("GF(2)").radical(), H("ZZ/9").radical()
        ((1 + i, 1 + j, 1 + k), (3, 3i, 3j, 3k))
        """
        return tuple(self(*c) for c in structure.radical(*self._here()))

    def is_central_simple(self) -> bool:
        """Tell whether the algebra is central simple: whether ``(t² + 4a)·b ≠ 0``, over a field."""
        return structure.is_central_simple(*self._here())

    def derivations(self) -> tuple[LinearMap, ...]:
        """Return a basis of the derivations, D(pq) = D(p)·q + p·D(q), as linear maps.

        A central simple algebra has only inner ones, ``q ↦ xq − qx``, a space of dimension 3. Over a ring
        over which they are not free these are generators, as in :meth:`center`.
        """
        from hfield.maps import LinearMap

        matrices = structure.derivations(*self._here())
        return tuple(LinearMap(self, self, list(zip(*m, strict=True))) for m in matrices)

    def opposite(self) -> Opposite:
        """Return the opposite algebra and an isomorphism with it.

        It has the same constants, for the map that fixes i and j and sends k = ij to ji turns products
        round. (The conjugate is another such map.)

        >>> from hfield import H
        >>> B, phi = H("QQ").opposite()
        >>> e, i, j, k = B.basis
        >>> phi(i*j) == phi(j)*phi(i)
        True
        """
        from hfield.maps import Isomorphism

        images = [structure.to_opposite(self.constants, q.coordinates) for q in self.basis]
        return Opposite(self, Isomorphism(self, self, images, reverses=True))

    # --- division or splitting -----------------------------------------------------------------

    # ``factors`` may name primes of the constants (over ℚ) or of their norms, where these are too hard to
    # factor; each is proved prime, or :class:`RingError` is raised.

    def zero_norm_element(self, factors: Factors | None = None) -> Quaternion | None:
        """Return a nonzero element of norm 0, or None if it is proved that there is none.

        Raises :class:`UndecidedError` where neither is known; the message says what was tried.
        """
        with known_primes(factors):
            found = structure.zero_norm(*self._here()).element
        return None if found is None else self(*found)

    def is_division_algebra(self, factors: Factors | None = None) -> bool:
        """Tell whether every nonzero element is invertible. Raises :class:`UndecidedError`."""
        with known_primes(factors):
            return structure.is_division(*self._here())

    def division_or_splitting(self, factors: Factors | None = None) -> Splitting | Division:
        """Return an isomorphism with M₂(F), or the reason why the algebra is a division algebra.

        The first is true, the second false in an ``if``. Raises :class:`CoercionError` for a degenerate
        algebra, which is neither, and :class:`UndecidedError`.
        """
        with known_primes(factors):
            return self._split_or_not

    @cached_property
    def _split_or_not(self) -> Splitting | Division:
        from hfield.maps import Division, Splitting
        from hfield.structure.isomorphisms.splitting import Splitting as Found

        if not self.ring.is_exact:
            raise UndecidedError(
                f"{self.ring} is inexact, so splitting is not decided there: ask over RR"
            )
        answer = structure.division_or_splitting(*self._here())
        return Splitting(self, answer) if isinstance(answer, Found) else Division(self, answer)

    def split(self, factors: Factors | None = None) -> Splitting | None:
        """Return an isomorphism with M₂(F), or None for a division algebra; errors as its twin's.

        >>> from hfield import H
        >>> I, J = H("GF(3)").split()
        """
        from hfield.maps import Splitting

        answer = self.division_or_splitting(factors)
        return answer if isinstance(answer, Splitting) else None

    def _splitting(self) -> Splitting:
        answer = self.split()
        if answer is None:
            raise CoercionError(
                f"{self} has no matrices over {self.ring}, for it is a division algebra: "
                f"{self._split_or_not.reason}"
            )
        return answer

    def to_matrix(self, q: object) -> Any:
        """Return the 2 × 2 matrix of q under :meth:`split`. Raises CoercionError if there is none."""
        return self._splitting().to_matrix(q)

    def from_matrix(self, matrix: Any) -> Quaternion:
        """Return the element of a 2 × 2 matrix under :meth:`split`. Raises CoercionError if none."""
        return self._splitting().from_matrix(matrix)

    # --- ramification --------------------------------------------------------------------------

    def ramified_places(self, factors: Factors | None = None) -> tuple[Hashable, ...]:
        """Return the places where the algebra stays a division algebra, finite ones first.

        Raises :class:`RingError` for a degenerate algebra, :class:`UndecidedError` without a theory.
        """
        return structure.ramified_places(self.ring, self.constants, factors)

    def discriminant(self, factors: Factors | None = None) -> Any:
        """Return the product of the finite ramified places: an int over ℚ, a polynomial over k(t).

        Over a quadratic field, where it is an ideal, the tuple of its prime ideals.
        """
        return structure.reduced_discriminant(*self._here(), factors)

    # --- isomorphism ---------------------------------------------------------------------------

    def _comparable(self, other: object) -> Constants:
        if not isinstance(other, Invariants):
            raise CoercionError(
                f"{shorten(repr(other))} is not a quaternion algebra to compare {self} with; "
                "expected one, such as QuaternionAlgebra.from_text('(-1,-3|QQ)')"
            )
        if other.ring != self.ring:
            raise MixedParentsError(
                f"{self} is over {self.ring} and {other} over {other.ring}: algebras are compared over "
                "one field; use A.change_ring(L) first"
            )
        return other.constants

    def is_isomorphic(self, other: object, factors: Factors | None = None) -> bool:
        """Tell whether two algebras over one field are isomorphic.

        Raises :class:`MixedParentsError` for different fields, and :class:`UndecidedError`.
        """
        with known_primes(factors):
            return structure.is_isomorphic(*self._here(), self._comparable(other))

    def isomorphism(self, other: Any, factors: Factors | None = None) -> Isomorphism | None:
        """Return an isomorphism onto ``other``, a callable, or None if there is none.

        The relations and the determinant are checked. Raises as :meth:`is_isomorphic` does.
        """
        from hfield.maps import Isomorphism

        with known_primes(factors):
            found = structure.isomorphism(*self._here(), self._comparable(other))
        return None if found is None else Isomorphism(self, other, found.images)

    # --- finite fields ---------------------------------------------------------------------------

    def count(self, kind: str = "elements", *, norm: Any = None, square: Any = None) -> int:
        """Return how many elements there are, over a finite ring.

        ``kind`` is one of ``elements``, ``units``, ``nilpotent``, ``idempotent``; ``norm=n`` asks for those
        of norm n, ``square=s`` for those with square s. Closed formulas answer over a finite field and ℤ/n
        (:func:`hfield.structure.confirm` confirms them), exhaustion over other finite rings.
        Raises :class:`NotFiniteError`, :class:`CoercionError` for a kind that does not exist,
        :class:`UndecidedError` over ℤ/n where n cannot be factored, and :class:`TooLargeError` where
        there is too much to go through.

        >>> from hfield import H
        >>> A = H("GF(9)"); A.count(norm=0), A.count("idempotent"), A.count(square=-1)
        (801, 92, 92)
        >>> H("ZZ/1000").count(norm=0)
        299600000
        """
        if sum((kind != "elements", norm is not None, square is not None)) > 1:
            raise CoercionError("count one thing at a time: a kind, or norm=…, or square=…")
        ring, c = self._here()
        value = square if norm is None else norm
        if value is not None:
            kind = "norm" if square is None else "square roots"
        elif kind in ("norm", "square roots"):
            raise CoercionError(f"say which {kind}: A.count(norm=0), or A.count(square=-1)")
        kind = _KINDS.get(kind, kind)
        if ring.order is not None and not structure.has_formulas(ring):
            found = structure.tally(ring, c)
            tables = {"norm": found.norms, "square roots": found.roots}
            if kind in tables:
                return tables[kind][ring.text(ring(value))]
            if kind in _KINDS.values():
                return int(getattr(found, kind))
        return structure.count(ring, c, kind, value).value
