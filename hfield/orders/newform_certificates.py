"""Certificates of newforms: the ideals in the sums of Hecke operators and traces; eigenvectors.

The evidence of an orbit is an eigenvector with values in its field. Let g be the polynomial of the eigenvalue
α of an operator T on the orbit, and h that of the other eigenvalues of T. Then (g(x) − g(T))/(x − T)·h(T)·u
is an eigenvector at x = α, for every function u with h(T)·u ≠ 0. At least one function of a basis has this
property. Functions have values that units of left orders fix, in a rational basis
(:mod:`hfield.orders.weight_values`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import cached_property
from itertools import accumulate, count, islice
from typing import TYPE_CHECKING, Any

from flint import fmpq, fmpq_mat, fmpq_poly, fmpz, fmpz_mat, fmpz_poly, nmod_mat, nmod_poly

from hfield.checker.orders.weights import MAX_WEIGHT
from hfield.checker.scalars.number_fields import MAX_DEGREE
from hfield.core.primality import is_prime
from hfield.orders import certificates
from hfield.orders.base_values import Prime
from hfield.orders.class_elements import ClassElements
from hfield.orders.classes import Classes, orbits
from hfield.orders.ideals_of_norm import two_sided_prime
from hfield.orders.invariants import good_primes
from hfield.orders.lattice_values import LatticeValue, multiple, product, times_ideal
from hfield.orders.related_orders import overorders
from hfield.orders.weight_values import WeightValues, padded

if TYPE_CHECKING:
    from hfield.algebra.quaternion import Quaternion
    from hfield.evidence import CertifiedClaim
    from hfield.orders.eigensystems import Module
    from hfield.orders.newforms import Newform

Ideal = tuple[int, "Quaternion"]
"""The number j of a class and an element c: the ideal c·I_j."""
LEAST_MODULUS, MAX_MODULI = 10**9, 20


def of_newforms(module: Module, norm: int, signs: bool) -> CertifiedClaim:
    """Return the claim of the Galois orbits of newforms, with eigenvalues at good primes of norm up to a
    bound.

    With ``signs``, those of Atkin and Lehner at the primes of the level and the discriminant are added. The
    primes of the operator that tells the newforms apart are added to those up to the bound. The
    checker is not asked about polynomials and weights above 2 over other fields than ℚ.
    """
    refusal = None
    if module.weight > MAX_WEIGHT:
        refusal = f"the checker knows newforms of weights up to {MAX_WEIGHT}"
    elif module.weight > 2 and not module.base.is_rational:
        refusal = "the checker knows newforms of weights above 2 over QQ only"
    elif module.base.is_polynomial:
        refusal = "the checker knows newforms over QQ and over number fields"
    elif (degree := max((f.degree for f in module.newforms), default=1)) > MAX_DEGREE:
        refusal = (
            f"an orbit has {degree} newforms; the checker reads fields of degree up to {MAX_DEGREE}"
        )
    return _NewformEvidence(module, norm, signs).claim(refusal)


class _NewformEvidence:
    """The evidence for the newforms of a module."""

    def __init__(self, module: Module, norm: int, signs: bool) -> None:
        self.module, self.forms = module, module.newforms
        self.classes, self.ambient = module.classes, module.classes.ambient
        self.operator = dict(zip(*self.forms[0].operator, strict=True)) if self.forms else {}
        bad = sorted({P for P, _ in module.level} | set(module.ramified), key=module.absolute_norm)
        self.sign_primes = bad if signs else []
        self.primes = [P for P in module.primes_up_to(norm) if P not in bad]
        self.primes += [P for P in self.operator if P not in self.primes]
        if not self.primes:
            self.primes = [next(good_primes(self.classes.order))]

    def claim(self, refusal: str | None) -> CertifiedClaim:
        """Return the claim; the evidence is omitted if the checker does not verify it."""
        shown = {} if refusal else self._data()
        stated = [
            f"{f.field.name}: {','.join(f.field.text(f.eigenvalue(P)) for P in self.primes)}"
            for f in self.forms
        ]
        where = list(map(self.module.shown, self.sign_primes))
        signs = [",".join(str(f.signs[P]) for P in where) for f in self.forms]
        parts = str(self.module.weight), " | ".join(stated) or "none", " | ".join(signs) or "none"
        primes = self.primes, self.sign_primes
        return certificates.of_newforms(self.classes, primes, parts, shown, refusal)

    def _data(self) -> dict[str, object]:
        vectors = list(map(self._eigenvector, self.forms))
        neighbours = [
            [[i, self._json(self._neighbours(i, P))] for i in self._rows(P, vectors)]
            for P in self.primes
        ]
        above = [
            (O, self._fibres(O))
            for P, _ in self.module.level
            for O in overorders(self.classes.order, P, 1)
        ]
        central = [
            [self._json([self._multiplied(i, P)])[0] for i in range(len(self.classes))]
            for P in certificates.class_group_primes(self.ambient)
        ]
        signs = [
            {
                "ideal": certificates.lattice_json(two_sided_prime(self.classes.order, P)),
                "images": [
                    [i, self._json([self._exchanged(i, P)])[0]] for i in self._seen(vectors)
                ],
            }
            for P in self.sign_primes
        ]
        return {
            **({"central": central} if central else {}),
            **({"signs": signs} if signs else {}),
            "neighbours": neighbours,
            "above": [
                {"order": certificates.lattice_json(O), "ideals": list(map(self._json, fibres))}
                for O, fibres in above
            ],
            "operator": [self.operator.get(P, 0) for P in self.primes],
            "modulus": self._modulus([fibre for _, fibres in above for fibre in fibres]),
            "orbits": [
                {"ring": f.field.data, "vector": v}
                for f, v in zip(self.forms, vectors, strict=True)
            ],
        }

    # --- ideals ------------------------------------------------------------------------------------------

    @cached_property
    def _elements(self) -> ClassElements:
        """The elements that map ideals of one class to each other."""
        return ClassElements(self.classes)

    def _json(self, ideals: list[Ideal]) -> list[object]:
        return [[j, certificates.element_json(self.ambient, c)] for j, c in ideals]

    def _neighbours(self, i: int, prime: Prime) -> list[Ideal]:
        """Return the ideals of relative norm P in class i."""
        volume = _volume(self.classes.lattice(i)) * self.module.absolute_norm(prime) ** 2
        return [self._scaled(*found, volume) for found in self._elements.neighbours(i, prime)]

    def _multiplied(self, i: int, prime: Prime) -> Ideal:
        """Return class i times a prime ideal of the base."""
        ideal = self.module.base.prime_ideal(prime)
        volume = _volume(times_ideal(self.classes.lattice(i), ideal))
        return self._scaled(*self._elements.multiplied(i, ideal), volume)

    def _exchanged(self, i: int, prime: Prime) -> Ideal:
        """Return class i times the two-sided ideal at a prime."""
        ideal = two_sided_prime(self.classes.order, prime)
        volume = _volume(product(self.classes.lattice(i), ideal))
        return self._scaled(*self._elements.exchanged(i, prime), volume)

    def _scaled(self, j: int, row: list[fmpz], volume: Fraction) -> Ideal:
        """Return a class j and a rational multiple of an element c such that c·I_j has a given volume."""
        c = self.ambient.element(row)
        return j, c * self._factor(multiple(self.classes.lattice(j), c, "left"), volume)

    def _factor(self, lattice: LatticeValue, volume: Fraction) -> Fraction:
        """Return the positive number by which a lattice must be multiplied to have a given volume."""
        top, below = (volume / _volume(lattice)).as_integer_ratio()
        size = self.ambient.size
        return Fraction(int(fmpz(top).root(size)), int(fmpz(below).root(size)))

    def _fibres(self, above: LatticeValue) -> list[list[Ideal]]:
        """Return, for each class of right ideals L of a larger order O′, the ideals J with J·O′ = L."""
        larger = ClassElements(Classes(above))
        index = _volume(self.classes.order) / _volume(above)
        volumes = [_volume(larger.classes.lattice(n)) * index for n, _ in enumerate(larger.units)]
        found: list[dict[LatticeValue, Ideal]] = [{} for _ in larger.units]
        for j in range(len(self.classes)):
            ideal = self.classes.lattice(j)
            n, row = larger.located(product(ideal, above), self.classes.norms[j])
            back = self.ambient.element(row).inverse()
            for unit in larger.units[n]:
                c = self.ambient.element(unit) * back
                c = c * self._factor(multiple(ideal, c, "left"), volumes[n])
                found[n].setdefault(multiple(ideal, c, "left"), (j, c))
        return [list(fibre.values()) for fibre in found]

    # --- functions ---------------------------------------------------------------------------------------

    @cached_property
    def values(self) -> WeightValues:
        """The values of functions."""
        return WeightValues(self.classes.order.algebra, self.module.weight)

    @cached_property
    def _bases(self) -> list[fmpq_mat]:
        """For each class a basis of the values that units fix, in reduced echelon form."""
        element = self.ambient.element
        return [self.values.fixed(list(map(element, units[1:]))) for units in self._elements.units]

    @cached_property
    def _starts(self) -> list[int]:
        """The number of the first function of each class, in a basis; and the dimension."""
        return [0, *accumulate(int(basis.nrows()) for basis in self._bases)]

    @property
    def size(self) -> int:
        """The dimension of the functions."""
        return self._starts[-1]

    def _sum(self, ideals: Iterable[Ideal]) -> dict[int, fmpq_mat]:
        """Return the sum of the values at some ideals: on values at each class, in its basis."""
        found: dict[int, fmpq_mat] = {}
        for j, c in ideals:
            matrix = self._bases[j] * self.values.action(c)
            found[j] = found[j] + matrix if j in found else matrix
        return found

    @cached_property
    def _matrix(self) -> tuple[fmpz_mat, fmpz]:
        """The operator that distinguishes the newforms, times an integer, and this integer."""
        size, starts = self.size, self._starts
        columns = [_pivots(basis) for basis in self._bases]
        entries = [fmpq(0)] * size**2
        for P, c in self.operator.items():
            scale = c * self.module.absolute_norm(P) ** (self.module.weight // 2 - 1)
            for i, kept in enumerate(columns):
                located = self._elements.neighbours(i, P) if kept else []
                for j, matrix in self._sum(
                    (j, self.ambient.element(x)) for j, x in located
                ).items():
                    for n, k in enumerate(kept, starts[i]):
                        for m in range(matrix.nrows()):
                            entries[n * size + starts[j] + m] += scale * matrix[m, k]
        found: tuple[fmpz_mat, fmpz] = fmpq_mat(size, size, entries).numer_denom()
        return found

    # --- eigenvectors ------------------------------------------------------------------------------------

    @cached_property
    def _polynomial(self) -> fmpz_poly:
        """The product of the distinct factors of its characteristic polynomial."""
        matrix, den = self._matrix
        coefficients = reversed(matrix.charpoly().coeffs())
        whole = fmpz_poly([c // den**k for k, c in enumerate(coefficients)][::-1])
        return whole // whole.gcd(whole.derivative())

    def _eigenvector(self, form: Newform) -> list[list[int]]:
        """Return an eigenvector: for each class the coordinates of a value, by powers of the generator."""
        g, d = form.polynomial, form.degree
        T, den = self._matrix
        images = (self._image(self._polynomial // g, i) for i in range(self.size))
        powers = [next(w for w in images if any(w.entries()))]
        for _ in range(1, d):
            powers.append(T * powers[-1])
        krylov = fmpq_mat([[fmpq(x, den**n) for x in v.entries()] for n, v in enumerate(powers)])
        hankel = fmpq_mat([[int(g[m + 1 + k]) for k in range(d)] for m in range(d)])
        values = (hankel * krylov).transpose()  # of each function, in powers of α
        modulus = fmpq_poly(g)
        first = next(row for row in values.tolist() if any(row))
        inverse = fmpq_poly(first).xgcd(modulus)[1]
        scale = fmpq_mat(
            [padded(fmpq_poly([0] * k + [1]) * inverse % modulus, d) for k in range(d)]
        )
        alpha = sum((form.eigenvalue(P) * c for P, c in self.operator.items()), form.field(0))
        change, power = [], form.field(1)
        for _ in range(d):
            change.append(_coefficients(form, power))
            power = power * alpha
        return self._expanded(values * scale * fmpq_mat(change))

    @cached_property
    def _kinds(self) -> list[int]:
        """Which functions of the basis are mapped to one another by ideals of the base, by numbers."""
        central = self.classes.central
        return orbits(len(self.classes), central) if central else list(range(self.size))

    def _expanded(self, vector: fmpq_mat) -> list[list[int]]:
        """Return a multiple of a function with integral values, class by class."""
        rows, d, width = vector.tolist(), vector.ncols(), self.values.dimension
        found = list[fmpq]()
        for basis, start, end in zip(self._bases, self._starts, self._starts[1:], strict=False):
            if start < end:
                found += (basis.transpose() * fmpq_mat(rows[start:end])).entries()
            else:
                found += [fmpq(0)] * (width * d)
        number = width * d
        whole = fmpq_mat(len(self.classes), number, found).numer_denom()[0]
        return [list(map(int, row)) for row in whole.tolist()]

    def _image(self, h: fmpz_poly, i: int) -> fmpz_mat:
        """Return a multiple of the image of a function with trivial character under h(T).

        The function is one of the basis; in weight 2 the sum of those of an orbit of ideals of the base.
        """
        T, den = self._matrix
        kinds = self._kinds
        start = fmpz_mat(self.size, 1, [int(kinds[i] == kinds[j]) for j in range(self.size)])
        found = fmpz_mat(self.size, 1)
        for k, c in enumerate(reversed(h.coeffs())):
            found = T * found + start * (c * den**k)
        return found

    def _rows(self, prime: Prime, vectors: list[list[list[int]]]) -> list[int]:
        """Return classes at which a Hecke operator is to be given."""
        return list(range(len(self.classes))) if self.operator.get(prime) else self._seen(vectors)

    def _seen(self, vectors: list[list[list[int]]]) -> list[int]:
        """Return classes such that each eigenvector is not 0 at one of them; one at least."""
        if not vectors:
            return [0]
        found, rest = list[int](), vectors
        while rest:
            zeros = [[v for v in rest if not any(v[i])] for i in range(len(self.classes))]
            i = min(range(len(zeros)), key=lambda i: len(zeros[i]))
            found.append(i)
            rest = zeros[i]
        return found

    def _modulus(self, fibres: list[list[Ideal]]) -> int:
        """Return a prime modulo which eigenvalues stay distinct and equations independent."""
        rows = [row for fibre in fibres for row in self._equations(self._sum(fibre))]
        if self.module.weight == 2:
            kinds, units = [norm.number for norm in self.classes.norms], self.classes.units
            for kind in sorted(set(kinds)):  # functions of the norm
                pairs = zip(kinds, units, strict=True)
                rows.append([fmpq(1, w) if k == kind else fmpq(0) for k, w in pairs])
        for moved in self.classes.central:
            for i, j in enumerate(moved):
                rows.append([fmpq(int(n == j) - int(n == i)) for n in range(self.size)])
        table = fmpq_mat(len(rows), self.size, [c for row in rows for c in row]).numer_denom()[0]
        whole = fmpz_poly([1])
        for f in self.forms:
            whole *= f.polynomial
        rank = self.size - whole.degree()
        for p in islice(filter(is_prime, count(LEAST_MODULUS)), MAX_MODULI):
            reduced = nmod_poly(whole.coeffs(), p)
            if not reduced.gcd(reduced.derivative()).degree() and nmod_mat(table, p).rank() == rank:
                return p
        raise AssertionError("the newforms do not have the dimension of the new functions")

    def _equations(self, sums: dict[int, fmpq_mat]) -> Iterator[list[fmpq]]:
        """Yield the equations that a sum of values is 0, on coordinates of functions."""
        for k in range(self.values.dimension):
            row = [fmpq(0)] * self.size
            for j, matrix in sums.items():
                for m, n in enumerate(range(self._starts[j], self._starts[j + 1])):
                    row[n] = matrix[m, k]
            yield row


def _pivots(basis: fmpq_mat) -> list[int]:
    return [next(k for k, c in enumerate(row) if c) for row in basis.tolist()]


def _volume(lattice: LatticeValue) -> Fraction:
    """Return the absolute value of the determinant of the rows of a lattice."""
    return Fraction(abs(int(lattice.matrix.det())), int(lattice.den) ** lattice.ambient.size)


def _coefficients(form: Newform, x: Any) -> list[fmpq]:
    """Return the coefficients of an element in powers of the generator of the field."""
    return [fmpq(x)] if form.degree == 1 else padded(x.poly, form.degree)
