"""Compare labels of orders, words in gates and LPS graphs with independent computations.

    python -m scripts.try_labels_and_words [--scale 1.0]

Labels are compared with conjugation and with class sets, T-counts with normal forms of Matsumoto and Amano
that are rewritten here in rotations of the cube, words in other gates with reduced words, and spectra of LPS
graphs with Ramanujan's bound, with closed walks on the tree, and with neighbours of ideals. Takes about six
minutes. Exit status 1 if anything differs.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from functools import cache, reduce
from operator import mul
from typing import Any

import numpy as np
from flint import fmpz_mat
from scipy.sparse import csr_array
from scipy.sparse.linalg import eigsh

from hfield import GF, H, LatticeError, QuaternionAlgebra, ternary_form

LEVELS = {2: 40, 3: 30, 5: 25, 7: 20, 11: 15, 13: 12, 17: 10, 19: 10, 30: 11, 42: 9, 66: 5, 70: 4}
Outcome = tuple[bool, str]
"""Whether all is as it should be, and the numbers."""
MAX_DENSE = 2500  # vertices of a graph of which all eigenvalues are computed
PAIRS = [(5, 13), (5, 17), (5, 29), (13, 5), (13, 17), (17, 5), (17, 13), (29, 5)]


# --- labels --------------------------------------------------------------------------------------------


def orders(rng: random.Random) -> Iterator[Any]:
    """Yield orders of definite algebras: Eichler orders, and suborders that are none."""
    while True:
        D = rng.choice(list(LEVELS))
        A = QuaternionAlgebra(D)
        N = rng.choice([n for n in range(1, LEVELS[D] + 1) if np.gcd(n, D) == 1])
        O = A.eichler_order(N)
        if rng.random() < 0.3:
            O = rng.choice(O.suborders(rng.choice((2, 3))))
        yield O


def conjugations(count: int, rng: random.Random) -> Outcome:
    """Compare labels of conjugate orders."""
    changed = total = 0
    for O in orders(rng):
        label = O.label()
        for _ in range(50):
            x = O.algebra(*(rng.randint(-20, 20) for _ in range(3)), rng.randint(1, 20))
            y = x.inverse()
            P = O.algebra.order_from_basis([x * q * y for q in O.basis])
            changed += P.label() != label
            total += 1
        if total >= count:
            return not changed, f"{total} conjugate orders, {changed} with another label"
    raise AssertionError


def class_sets(count: int, rng: random.Random) -> Outcome:
    """Compare labels of all left orders with types, which are found otherwise."""
    different = classes = most = 0
    for n, O in enumerate(orders(rng)):
        if n == count:
            break
        C = O.class_set()
        labels = [P.label() for P in C.left_orders()]
        pairs = set(zip(labels, C.types, strict=True))
        same = len(set(labels)) == C.type_number == len(pairs) and labels == C.labels()
        different += not same
        classes += len(C)
        most = max(most, C.type_number)
    return not different, (
        f"{count} class sets with {classes} classes and up to {most} types, "
        f"{different} with another number of labels"
    )


def definite_forms(count: int, rng: random.Random) -> Outcome:
    """Compare reduced forms of small forms, most of them on a boundary, after a change of basis."""
    changed = total = 0
    while total < count:
        coefficients = [rng.randint(1, 4) for _ in range(3)] + [
            rng.randint(-3, 3) for _ in range(3)
        ]
        try:
            form = ternary_form(coefficients)
        except LatticeError:
            continue
        if not form.is_definite():
            continue
        gram = fmpz_mat([[int(x) for x in row] for row in form.gram_matrix()])
        m = fmpz_mat([[int(r == c) for c in range(3)] for r in range(3)])
        for _ in range(6):
            r, c = rng.sample(range(3), 2)
            step = [[int(a == b) + (rng.choice((-2, -1, 1, 2)) if (a, b) == (r, c) else 0) for b in range(3)]
                    for a in range(3)]  # fmt: skip
            m = fmpz_mat(step) * m
        g = m * gram * m.transpose()
        moved = [g[0, 0] // 2, g[1, 1] // 2, g[2, 2] // 2, g[1, 2], g[0, 2], g[0, 1]]
        changed += ternary_form([int(x) for x in moved]).reduced() != form.reduced()
        total += 1
    return not changed, f"{total} small forms in another basis, {changed} with another reduced form"


# --- the gates H, S and T ----------------------------------------------------------------------------------

Rotation = tuple[tuple[int, int], ...]  # where x, y, z go: an axis and a sign


def compose(first: Rotation, second: Rotation) -> Rotation:
    """Return the rotation first·second: second acts first."""
    return tuple((first[axis][0], first[axis][1] * sign) for axis, sign in second)


UNIT: Rotation = ((0, 1), (1, 1), (2, 1))
S_ROTATION: Rotation = ((1, 1), (0, -1), (2, 1))  # x to y, y to −x
H_ROTATION: Rotation = ((2, 1), (1, -1), (0, 1))  # x to z, y to −y, z to x


@cache
def coset(clifford: Rotation) -> tuple[str, Rotation]:
    """Return L in "", "H", "SH" and a rotation c that keeps the axis z, with L·c the given one."""
    for letters in ("", "H", "SH"):
        c = compose(inverse(clifford_of(letters)), clifford)
        if c[2][0] == 2:
            return letters, c
    raise AssertionError


def clifford_of(letters: str) -> Rotation:
    return reduce(compose, ({"H": H_ROTATION, "S": S_ROTATION}[x] for x in letters), UNIT)


def inverse(rotation: Rotation) -> Rotation:
    out: list[tuple[int, int]] = [(0, 0)] * 3
    for axis, (image, sign) in enumerate(rotation):
        out[image] = (axis, sign)
    return tuple(out)


def normal_form(word: str) -> tuple[list[str], Rotation]:
    """Return the syllables T, HT, SHT and the last Clifford gate (Matsumoto and Amano, 2008).

    A word is multiplied from the left to the right, and after each letter it is a normal form.
    """
    syllables: list[str] = []
    rest = UNIT
    for letter in word:
        if letter != "T":
            rest = compose(rest, clifford_of(letter))
            continue
        letters, c = coset(rest)
        if c[2][1] < 0:  # c·T = T⁻¹·c = T·S⁻¹·c
            c = compose(inverse(S_ROTATION), c)
        if letters or not syllables:
            syllables.append(letters + "T")
            rest = c
        else:  # L·T·T = L·S
            rest = compose(clifford_of(syllables.pop()[:-1] + "S"), c)
    return syllables, rest


class CliffordAndT:
    """Quaternions for the gates, and words from factorisations."""

    def __init__(self) -> None:
        self.A = A = H("QQ(sqrt(2))")
        self.O = A.maximal_order()
        self.P = A.ring.primes_above(2)[0]
        self.gates = {"T": A("1 + (1+k)/sqrt(2)"), "S": A("(1+k)/sqrt(2)"), "H": A("(i+k)/sqrt(2)")}
        self.cliffords: dict[Any, str] = {projective(A.one): ""}  # with shortest words
        todo = [""]
        while todo:
            word = todo.pop(0)
            for letter in "HS":
                key = projective(self.product(word + letter))
                if key not in self.cliffords:
                    self.cliffords[key] = word + letter
                    todo.append(word + letter)
        assert len(self.cliffords) == self.O.unit_index() == 24

    def product(self, word: str) -> Any:
        return reduce(mul, (self.gates[x] for x in word), self.A.one)

    def primitive(self, x: Any) -> Any:
        """Return an element of the order that differs by a number, and that √2 does not divide."""
        root = self.A.ring.gen
        while x not in self.O:
            x = x * root
        while x / root in self.O:
            x = x / root
        return x

    def word(self, x: Any) -> str:
        """Return a word in H, S and T for a primitive element."""
        u, factors = self.O.factor(x, [self.P] * self.P.valuation(x.norm()))
        T, out, left = self.gates["T"], "", u
        for pi in factors:  # π = a·T·b for Clifford gates a and b
            a, b = next(
                (a, b)
                for b in self.right()
                if (a := self.clifford(pi * (T * b).inverse())) is not None
            )
            out += self.cliffords[projective(left * self.product(a))] + "T"
            left = b
        return out + self.cliffords[projective(left)]

    def right(self) -> list[Any]:
        return [self.A.one, self.product("H"), self.product("HS")]

    def clifford(self, x: Any) -> str | None:
        return self.cliffords.get(projective(x))


def projective(x: Any) -> Any:
    """Return what is equal for multiples by numbers: the element with a first coordinate 1."""
    first = next(c for c in x.coordinates if c != 0)
    return x / first


def t_counts(count: int, rng: random.Random) -> Outcome:
    gates = CliffordAndT()
    different = wrong = most = 0
    for _ in range(count):
        word = "".join(rng.choice("HST") for _ in range(rng.randint(20, 500)))
        x = gates.primitive(gates.product(word))
        syllables, rest = normal_form(word)
        t = gates.P.valuation(x.norm())
        different += t != len(syllables)
        back = "".join(syllables)
        found = gates.word(x)
        wrong += projective(gates.product(found)) != projective(x) or found.count("T") != t
        last = gates.cliffords[projective(gates.product(back).inverse() * x)]
        wrong += clifford_of(last) != rest
        most = max(most, t)
    return not different and not wrong, (
        f"{count} random words in H, S, T with up to {most} gates T: {different} T-counts differ from those "
        f"of Matsumoto and Amano, {wrong} words are wrong"
    )


def t_counts_by_search(depth: int) -> Outcome:
    """Count the operators of each T-count by a search in breadth: 24·3·2^(n−1) after the first."""
    gates = CliffordAndT()
    cliffords = [gates.product(word) for word in gates.cliffords.values()]
    known = {projective(c) for c in cliffords}
    layer, sizes, wrong = cliffords, [len(known)], 0
    for n in range(1, depth + 1):
        found = {}
        for x in layer:
            for c in cliffords:
                y = x * gates.gates["T"] * c
                key = projective(y)
                if key not in known:
                    known.add(key)
                    found[key] = y
        layer = list(found.values())
        wrong += sum(gates.P.valuation(gates.primitive(y).norm()) != n for y in layer)
        sizes.append(len(layer))
    expected = [24] + [72 * 2 ** (n - 1) for n in range(1, depth + 1)]
    return sizes == expected and not wrong, (
        f"operators of T-count 0 … {depth} by search: {sizes}, expected {expected}; {wrong} valuations "
        "differ"
    )


# --- V gates and icosahedral gates -----------------------------------------------------------------------


def v_gates(count: int, rng: random.Random) -> Outcome:
    """Compare lengths of reduced words in V1, V2, V3 and their inverses with valuations at 5."""
    O = H("QQ").hurwitz_order()
    A = O.algebra
    gates = {name: A(f"1 + 2*{x}") for name, x in zip("XYZ", "ijk", strict=True)}
    gates |= {name.lower(): q.conjugate() for name, q in gates.items()}
    units = set(O.units())
    wrong = most = 0
    for _ in range(count):
        reduced: list[str] = []
        x = A.one
        for _ in range(rng.randint(10, 80)):
            letter = rng.choice("XYZxyz")
            x = x * gates[letter]
            if reduced and reduced[-1] == letter.swapcase():
                reduced.pop()
            else:
                reduced.append(letter)
        while x / 5 in O:
            x = x / 5
        n = len(reduced)
        most = max(most, n)
        u, factors = O.factor(x, [5] * n) if x.norm() == 5**n else (A.zero, [])
        letters, left = [], u
        for pi in factors:  # left·π = V·left′
            whole = left * pi
            letter = next(name for name, v in gates.items() if v.inverse() * whole in units)
            letters.append(letter)
            left = gates[letter].inverse() * whole
        wrong += letters != reduced or left not in (A.one, -A.one)
    return not wrong, (
        f"{count} random words in V gates, reduced to up to {most}: {wrong} words or lengths differ"
    )


def icosahedral_gates(count: int, rng: random.Random) -> Outcome:
    """Compare counts of gates τ of norm 2 and of norm 7 + 5φ with valuations, the 60 rotations being free."""
    A = H("QQ(sqrt(5))")
    O, K = A.maximal_order(), A.ring
    units = O.units_modulo_scalars()
    notes, good = [], True
    for norm in (K(2), K("19/2 + 5/2*sqrt(5)")):
        tau = next(q for q in O.elements_of_norm(norm) if q.trace() == 0 or norm == 2)
        P = K.ideal(norm).factorisation()[0][0]
        ideals = {O.left_ideal([tau * u, norm]) for u in units}
        expected = O.ideals_of_norm(P)
        wrong = most = 0
        for _ in range(count):
            x, length = A.one, rng.randint(1, 20)
            for _ in range(length):
                x = x * rng.choice(units) * tau
            while x / norm in O:
                x = x / norm
            t = P.valuation(x.norm())
            u, factors = O.factor(x, [P] * t)
            product = reduce(mul, factors, u)
            # each factor is a rotation, τ and a rotation
            fits = all(any(is_unit(O, pi * v * tau.inverse()) for v in units) for pi in factors)
            wrong += product != x or not fits or t > length
            most = max(most, t)
        good = good and ideals == set(expected) and not wrong
        notes.append(
            f"{len(ideals)} of {len(expected)} ideals of norm {K.text(norm)} are O·τ·u, {count} random words "
            f"with up to {most} gates τ: {wrong} wrong"
        )
    return good, "icosahedral: " + "; ".join(notes)


def is_unit(O: Any, x: Any) -> bool:
    return x in O and x.inverse() in O


# --- LPS graphs ------------------------------------------------------------------------------------------


def generators(p: int) -> list[Any]:
    """Return the p + 1 quaternions of norm p with an odd positive first coordinate and three even ones."""
    O = H("QQ").lipschitz_order()
    found = [q for q in O.elements_of_norm(p) if int(q.coordinates[0]) % 2 and q.coordinates[0] > 0]
    assert len(found) == p + 1
    return found


def lps(p: int, q: int) -> tuple[np.ndarray, int]:
    """Return the neighbours of each vertex of X^{p,q}, p + 1 columns, and how many layers around 1 are trees.

    Vertices are quaternions modulo q up to numbers; 1 is vertex 0.
    """
    ring = GF(q)
    inverses = [0] + [int(pow(n, -1, q)) for n in range(1, q)]
    table = [tuple(int(c) % q for c in s.coordinates) for s in generators(p)]
    assert ring.order == q

    def normal(x: tuple[int, ...]) -> tuple[int, ...]:
        scale = inverses[next(c for c in x if c)]
        return tuple(c * scale % q for c in x)

    def times(x: tuple[int, ...], y: tuple[int, ...]) -> tuple[int, ...]:
        a, b, c, d = x
        e, f, g, h = y
        return normal((
            (a * e - b * f - c * g - d * h) % q, (a * f + b * e + c * h - d * g) % q,
            (a * g - b * h + c * e + d * f) % q, (a * h + b * g - c * f + d * e) % q,
        ))  # fmt: skip

    numbers = {(1, 0, 0, 0): 0}
    todo, rows = [(1, 0, 0, 0)], []
    for x in todo:
        row = []
        for s in table:
            y = times(x, s)
            if y not in numbers:
                numbers[y] = len(todo)
                todo.append(y)
            row.append(numbers[y])
        rows.append(row)
    A = H(ring)  # the same products in the algebra itself
    for x, s in ((todo[-1], table[0]), (todo[len(todo) // 2], table[-1])):
        y = A(*x) * A(*s)
        assert normal(tuple(int(c) for c in y.coordinates)) == times(x, s)
    return np.array(rows), girth(rows)


def girth(rows: list[list[int]]) -> int:
    """Return the length of a shortest cycle through vertex 0, by a search in breadth."""
    distance, parent = {0: 0}, {0: -1}
    todo, best = [0], 10**9
    for x in todo:
        if 2 * distance[x] >= best:
            break
        back = 0
        for y in rows[x]:
            if y == parent[x] and not back:
                back = 1  # the edge by which x was reached, once
            elif y in distance:
                best = min(best, distance[x] + distance[y] + 1)
            else:
                distance[y], parent[y] = distance[x] + 1, x
                todo.append(y)
    return best


def closed_walks(p: int, length: int) -> int:
    """Return how many closed walks of a length start at a vertex of the tree of degree p + 1."""
    counts = {0: 1}
    for _ in range(length):
        longer: Counter[int] = Counter()
        for d, n in counts.items():
            longer[d + 1] += n * (p if d else p + 1)
            if d:
                longer[d - 1] += n
        counts = longer
    return counts.get(0, 0)


def on_the_line(p: int, q: int) -> Any:
    """Return the characteristic polynomial of the quotient of X^{p,q} on the lines over GF(q)."""
    A = H(GF(q))
    I, J = A.split()
    matrices = [np.eye(2, dtype=int)]
    matrices += [np.array([[int(x) for x in row] for row in m]) for m in (I, J)]
    matrices.append(matrices[1] @ matrices[2] % q)
    lines = [(1, n) for n in range(q)] + [(0, 1)]
    number = {line: n for n, line in enumerate(lines)}
    out = [[0] * (q + 1) for _ in lines]
    for s in generators(p):
        m = sum(int(c) * matrix for c, matrix in zip(s.coordinates, matrices, strict=True)) % q
        for n, line in enumerate(lines):
            x, y = (int(c) for c in np.array(line) @ m % q)
            image = (1, y * pow(x, -1, q) % q) if x else (0, 1)
            out[n][number[image]] += 1
    return fmpz_mat(out).charpoly()


def by_ideals(p: int, q: int) -> Any:
    """Return the same polynomial from neighbours of right ideals of ℤ⟨1, 2i, 2j, 2k⟩ at level q."""
    A = H("QQ")
    C = (A.order(["2*i", "2*j", "2*k"]) & A.eichler_order(q)).class_set()
    weights: dict[int, dict[int, int]] = {}
    for i, j, data in C.graph(p):
        weights.setdefault(i, {})[j] = data["weight"]
    component, todo = {0}, [0]
    for i in todo:
        for j in weights[i]:
            if j not in component:
                component.add(j)
                todo.append(j)
    rows = [[weights[i].get(j, 0) for j in todo] for i in todo]
    return fmpz_mat(rows).charpoly()


def spectrum(p: int, q: int) -> Outcome:
    rows, cycle = lps(p, q)
    n = len(rows)
    square = pow(p, (q - 1) // 2, q) == 1
    size = q * (q * q - 1) // (2 if square else 1)
    entries = np.ones(rows.size)
    places = (np.repeat(np.arange(n), p + 1), rows.ravel())
    adjacency = csr_array((entries, places), shape=(n, n))
    assert abs(adjacency - adjacency.T).max() == 0
    if n <= MAX_DENSE:
        values = np.linalg.eigvalsh(adjacency.toarray())
        walks = all(
            abs(np.sum(values**k) - n * closed_walks(p, k)) < 1e-6 * n * (p + 1) ** k
            for k in range(cycle)
        )
    else:
        values = np.sort(np.concatenate([eigsh(adjacency, k=4, which=w)[0] for w in ("LA", "SA")]))
        walks = None
    trivial = np.isclose(np.abs(values), p + 1, atol=1e-6)
    inner = np.abs(values[~trivial]).max()
    bound = 2 * p**0.5
    expected_trivial = 1 if square else 2
    same = on_the_line(p, q) == by_ideals(p, q)
    lower = (2 if square else 4) * np.log(q) / np.log(p) - (0 if square else np.log(4) / np.log(p))
    good = n == size and trivial.sum() == expected_trivial and inner <= bound + 1e-6 and same
    good = good and walks is not False and cycle >= lower
    return good, (
        f"X^({p},{q}): {'PSL' if square else 'PGL'}2, {n} vertices of degree {p + 1}, largest inner "
        f"eigenvalue {inner:.6f} ≤ {bound:.6f}, ±{p + 1} {trivial.sum()} times, girth {cycle} ≥ {lower:.2f}, "
        f"closed walks {'not counted' if walks is None else 'as on the tree' if walks else 'WRONG'}, "
        f"quotient on the line {'as by ideals' if same else 'DIFFERS'}: {'good' if good else 'WRONG'}"
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0] if __doc__ else "")
    parser.add_argument("--scale", type=float, default=1.0, help="a factor for all counts")
    scale = parser.parse_args().scale

    def counted(n: int) -> int:
        return max(1, round(n * scale))

    parts: list[Callable[[], Outcome]] = [
        lambda: conjugations(counted(10_000), random.Random(1)),
        lambda: definite_forms(counted(3_000), random.Random(7)),
        lambda: class_sets(counted(500), random.Random(2)),
        lambda: t_counts(counted(1_000), random.Random(3)),
        lambda: t_counts_by_search(4),
        lambda: v_gates(counted(300), random.Random(4)),
        lambda: icosahedral_gates(counted(50), random.Random(5)),
        *((lambda p=p, q=q: spectrum(p, q)) for p, q in PAIRS),
    ]
    all_good = True
    for part in parts:
        start = time.perf_counter()
        good, numbers = part()
        all_good = all_good and bool(good)
        print(f"{numbers} ({time.perf_counter() - start:.1f} s)", flush=True)
    return int(not all_good)


if __name__ == "__main__":
    sys.exit(main())
