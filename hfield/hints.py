"""Hints for names of other systems: the corresponding hfield names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar, NoReturn


class ForeignNameError(AttributeError):
    """A name of another system was used; the message gives the hfield name."""


class ForeignImportError(ModuleNotFoundError):
    """A name of another system was imported from hfield; the message gives the hfield name."""


class ForeignName:
    """A name of another system; access raises an AttributeError with the hfield name."""

    def __init__(self, name: str, hint: str) -> None:
        self.name, self.hint = name, hint

    def __get__(self, instance: object, class_: type) -> NoReturn:
        article = "an" if class_.__name__[0] in "AEIO" else "a"
        raise ForeignNameError(
            f"{article} {class_.__name__} has no {self.name!r}: write {self.hint}",
            name=self.name,
            obj=instance,
        )


class Hinted:
    """A class whose AttributeError for a name of another system gives the hfield name.

    ``__getattr__`` would do the same, but make access to every other attribute slower.

    >>> from hfield import H, QQ
    >>> H(QQ).ramified_primes()
    Traceback (most recent call last):
    hfield.hints.ForeignNameError: a QuaternionAlgebra has no 'ramified_primes': write ramified_places()
    """

    __slots__ = ()

    foreign_names: ClassVar[Mapping[str, str]] = {}

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        for name, hint in cls.foreign_names.items():
            own = next((vars(base)[name] for base in cls.__mro__ if name in vars(base)), None)
            if own is None or isinstance(own, ForeignName):
                setattr(cls, name, ForeignName(name, hint))

    def __dir__(self) -> list[str]:
        hidden = {"foreign_names", *self.foreign_names}
        return [name for name in super().__dir__() if name not in hidden]


ELEMENT = {
    "reduced_norm": "norm()",
    "reduced_trace": "trace()",
    "coefficient_tuple": "coordinates",
    "coefficients": "coordinates",
    "reduced_characteristic_polynomial": "characteristic_polynomial()",
    "minpoly": "minimal_polynomial()",
    "charpoly": "characteristic_polynomial()",
    "multiplicative_order": "order()",
    "is_invertible": "is_unit()",
    "parent": "algebra",
    "base_ring": "ring",
    "real": "scalar_part",
    "imag": "vector_part",
    "w": "coordinates[0]",
    "x": "coordinates[1]",
    "y": "coordinates[2]",
    "z": "coordinates[3]",
    "pair": "(p * q.conjugate()).trace()",
    "is_constant": "vector_part.is_zero()",
    "nrd": "norm()",
    "trd": "trace()",
    "bar": "conjugate()",
    "list": "coordinates",
    "normalize": "unit()",
    "normalized": "unit()",
    "components": "coordinates",
}
"""Sage, GAP, Magma, numpy-quaternion."""

ALGEBRA = {
    "over_integers": "is_over_number_field",
    "gens": "basis",
    "gen": "basis[1]",
    "is_division": "is_division_algebra()",
    "ramified_primes": "ramified_places()",
    "ramified_infinite_places": "ramified_places()",
    "finite_ramified_places": "ramified_places()",
    "base_ring": "ring",
    "invariants": "constants",
    "is_matrix_ring": "split(), which is None for a division algebra",
    "is_split": "split(), which is None for a division algebra",
    "is_definite": "maximal_order().is_definite()",
    "quaternion_order": "order(elements)",
    "hilbert_symbol": "hilbert_symbol(a, b, place) of hfield",
    "one_basis": "basis",
    "modp_splitting_data": "split()",
    "is_exact": "ring.is_exact",
    "random": "random_element()",
    "ngens": "len(basis), which is 4",
    "dimension": "len(basis), which is 4",
    "base_field": "ring",
    "characteristic": "ring.characteristic",
    "free_module": "coordinates of an element",
    "vector_space": "coordinates of an element",
    "pair": "(p * q.conjugate()).trace()",
    "inner_product_matrix": "(p * q.conjugate()).trace() for p and q in basis",
    "is_totally_definite": "maximal_order().is_definite()",
    "is_unramified": "ramified_places()",
    "is_ramified_at": "p in ramified_places()",
    "hasse_invariant": "ramified_places()",
    "is_isomorphic_to": "is_isomorphic(other)",
    "unit_ideal": "maximal_order().left_ideal([1])",
    "matrix_ring": "matrix(rows)",
    "isomorphism_to": "isomorphism(other)",
    "maximal_order_with_level": "eichler_order(level)",
    "order_with_level": "eichler_order(level)",
    "maximal_orders": "maximal_order().class_set().left_orders()",
    "ideal": "maximal_order().left_ideal(elements)",
    "zbasis": "maximal_order().basis",
    "class_set": "maximal_order().class_set()",
    "right_class_set": "maximal_order().class_set()",
    "brandt_matrix": "maximal_order().class_set().brandt_matrix(n)",
    "ternary_quadratic_form": "maximal_order().ternary_form()",
    "polynomial": "polynomials()('x^2 + i*x + 1')",
    "polynomial_ring": "polynomials()",
    "roots": "polynomials()('x^2 + i*x + 1').roots()",
}
"""Sage, Magma, PARI."""

LATTICE = {
    "gens": "basis",
    "gen": "basis[n]",
    "ngens": "len(basis), which is 4",
    "basis_matrix": "hnf, the denominator and the rows",
    "quaternion_algebra": "algebra",
    "base_ring": "algebra.ring",
    "intersection": "L & M",
    "minimal_element": "shortest()",
    "minimal_vectors": "shortest()",
    "quadratic_form": "gram_matrix()",
    "scale": "L * x or x * L",
    "multiply_by_conjugate": "L.conjugate() * M",
    "quaternion_order": "left_order() or right_order()",
    "zbasis": "basis",
    "free_module": "basis",
    "reduced_norm": "norm()",
    "theta_series_vector": "theta_series(n)",
}
"""Sage, Magma: lattices."""

IDEAL = LATTICE | {
    "is_left_equivalent": "is_equivalent(other)",
    "is_right_equivalent": "is_equivalent(other)",
    "is_primitive": "primitive_part()",
    "primitive_decomposition": "primitive_part()",
    "cyclic_right_subideals": "the order's ideals_of_norm(n)",
    "quaternion_order": "order",
    "two_generators": "generators",
    "small_equivalent_ideal": "reduced_equivalent()",
    "EquivalentPrimeIdeal": "equivalent_of_prime_norm()",
    "EquivalentSmoothIdeal": "equivalent_of_norm_dividing(T)",
    "KLPT": "equivalent_of_norm_dividing(T), or equivalent_of_power_norm(prime)",
    "Qlapoti": "equivalent_pair(total)",
    "IdealModConstraint": "ideal_mod_constraint(gamma)",
    "EichlerModConstraint": "eichler_mod_constraint(gamma, delta)",
    "IdealToKernel": "kernel of the order's modulo(N)",
}
"""Sage, Magma, papers on isogenies: ideals."""

ORDER = LATTICE | {
    "class_number": "len(class_set()), or algebra.class_number(level)",
    "right_ideals": "class_set()",
    "right_class_set": "class_set()",
    "left_class_set": "class_set().left_ideals()",
    "left_ideals": "class_set().left_ideals()",
    "brandt_matrix": "class_set().brandt_matrix(n)",
    "type_set": "class_set().types",
    "ternary_quadratic_form": "ternary_form(), or ternary_theta_series(n) of the trace-0 part of ℤ + 2O",
    "maximal_order": "maximal_overorder()",
    "is_conjugate": "isomorphism(other)",
    "embed": "embeddings(discriminant)",
    "eichler_invariant": "eichler_symbol(p)",
    "right_ideal_classes": "class_set()",
    "left_ideal_classes": "class_set().left_ideals()",
    "brandt_module": "class_set(), which has brandt_matrix(n)",
    "ideal_classes": "class_set()",
    "is_ramified_at": "p in algebra.ramified_places()",
    "ramified_places": "algebra.ramified_places()",
    "ramified_primes": "algebra.ramified_places()",
    "class_group": "class_set()",
    "type_number": "class_set().type_number",
    "mass_formula": "mass()",
    "unit_ideal": "left_ideal([1])",
    "isomorphism_to": "isomorphism(other)",
    "optimal_embeddings": "embeddings(discriminant)",
    "one": "algebra.one",
    "eichler_order": "algebra.eichler_order(level)",
    "RepresentInteger": "represent_integer(n)",
    "FullRepresentInteger": "represent_integer(n)",
    "StrongApproximation": "strong_approximation(x, N, T)",
    "KernelToIdeal": "ideal of modulo(N)",
    "mod_p_isomorphism": "modulo(N)",
}
"""Sage, Magma, papers on isogenies: orders."""

FIELD = {
    "class_number": "class_group().order",
    "units": "unit_group().generators",
    "regulator": "unit_group().regulator",
    "primes_over": "primes_above(p)",
    "prime_above": "primes_above(p)",
    "prime_factors": "primes_above(p)",
    "maximal_order": "integral_basis()",
    "ring_of_integers": "integral_basis()",
    "disc": "discriminant()",
    "absolute_discriminant": "discriminant()",
}
"""Sage, Magma, PARI: number fields."""

FORM = {
    "disc": "discriminant()",
    "polynomial": "latex()",
    "matrix": "gram_matrix()",
    "is_positive_definite": "is_definite()",
    "number_of_automorphisms": "automorphism_count()",
    "reduced_form_eisenstein": "reduced()",
    "is_isometric": "is_equivalent(other)",
    "genus_representatives": "genus()",
    "clifford_algebra": "order(), the even part",
    "even_clifford_algebra": "order()",
}
"""Sage, Magma: ternary forms."""

CLASSES = {
    "class_number": "len(classes)",
    "dimension": "len(classes)",
    "right_ideals": "list(classes)",
    "ideals": "list(classes)",
    "representatives": "list(classes)",
    "hecke_matrix": "brandt_matrix(n)",
    "brandt_module": "brandt_matrix(n)",
}
"""Sage, Magma: sets of classes of ideals, Brandt modules."""

CALLS = {
    "QuadraticField": "ring('QQ(sqrt(5))')",
    "CyclotomicField": "ring('QQ(zeta5)')",
    "RationalField": "ring('QQ')",
    "Rationals": "ring('QQ')",
    "FiniteField": "ring('GF(9)')",
    "nfinit, bnfinit": "ring('QQ[s]/(s^3-2)')",
    "QuaternionOrder": 'A.order(["i", "j"])',
    "MaximalOrder": "A.maximal_order()",
    "HilbertSymbol": "hilbert_symbol(a, b, p)",
    "hilbert_conductor": "QuaternionAlgebra(F, a, b).discriminant()",
    "Matrix, matrix": "A.matrix([[1, i], [j, 2]])",
    "BrandtMatrix": "O.class_set().brandt_matrix(n)",
    "ClassGroup": "ring('QQ(sqrt(-23))').class_group()",
    "ClassNumber": "len(O.class_set())",
    "Quaternions, QuaternionRing": "H('RR')",
    "TensorProduct": "A.tensor(B)",
    "HasEmbedding": "A.embed(d)",
    "IsSplittingField": "A.embed(d)",
    "IsMatrixRing": "A.split()",
    "RamifiedPrimes": "A.ramified_places()",
    "RightIdealClasses": "O.class_set()",
    "LeftIdealClasses": "O.class_set().left_ideals()",
    "ConjugacyClasses": "O.class_set().left_orders()",
    "BrandtModule": "O.class_set()",
    "HeckeOperator": "O.class_set().brandt_matrix(n)",
    "HilbertCuspForms": "O.class_set().newforms()",
    "CuspForms": "O.class_set().newforms(weight=k)",
    "mfinit, mfeigenbasis": "O.class_set().newforms(weight=k)",
    "IsLeftIsomorphic": "I.equivalence(J)",
    "IsPrincipal": "I.is_principal()",
    "IsConjugate": "O.isomorphism(O2)",
    "NormOneGroup": "O.units()",
    "EichlerInvariant": "O.eichler_symbol(p)",
    "ReducedGramMatrix": "L.gram_matrix()",
    "ShimuraReduceUnit": "G.word(x)",
    "alginit": "QuaternionAlgebra(F, a, b)",
    "alghasse": "A.ramified_places()",
    "algindex": "A.is_division_algebra()",
    "algissplit": "A.split()",
    "algisramified": "A.ramified_places()",
    "algisdivision": "A.is_division_algebra()",
    "algiscommutative": "A.is_commutative()",
    "algcenter": "A.center()",
    "algradical": "A.radical()",
    "algmultable": "A.multiplication_table()",
    "algtensor": "A.tensor(B)",
    "algrandom": "A.random_element()",
    "algnorm": "q.norm()",
    "algtrace": "q.trace()",
    "algcharpoly": "q.characteristic_polynomial()",
    "algtomatrix": "q.matrix()",
    "alginv": "q.inverse()",
    "alglathnf": "A.lattice(elements).hnf",
    "alglatadd": "L + M",
    "alglatinter": "L & M",
    "alglatmul": "L * M",
    "alglatindex": "L.index(M)",
    "alglatcontains": "x in L",
    "algfdom": "G.domain()",
    "algfdomsignature": "G.signature",
    "hilbert": "hilbert_symbol(a, b, p)",
    "Nrd, nrd": "q.norm()",
    "Trd, trd": "q.trace()",
}
"""Functions of Magma and PARI, and abbreviations of the literature: q is an element, d a number, L, M
lattices, O, O2 orders, I, J ideals of A, G a group of units."""


def called_here(name: str) -> str:
    """Return the hfield name for a function of another system; empty if the name is not known.

    >>> called_here("nrd"), called_here("nothing")
    ('q.norm()', '')
    """
    return next((here for there, here in CALLS.items() if name in there.split(", ")), "")


GROUP = {
    "presentation": "generators and relations",
    "fundamental_domain": "domain()",
    "gens": "generators",
    "genus": "signature.genus",
    "volume": "area, in units of 2π",
    "elliptic_points": "signature.orders",
    "cusps": "signature.cusps",
}
"""Magma, PARI, Sage: Fuchsian groups."""
