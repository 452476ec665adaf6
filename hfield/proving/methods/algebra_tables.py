"""Small associative algebras in which the product of two basis vectors is ± a basis vector or 0.

Found by backtracking over the products; associativity and the relations asked for are checked as
soon as the products that they need are there, and all of them once more at the end.
"""

from collections.abc import Mapping, Sequence
from itertools import product

from hfield.proving.clock import Clock

Entry = tuple[int, int]  # sign (0 for the product 0), index of the basis vector
Table = dict[tuple[int, int], Entry]
Vector = list[int]


def evaluate(f: Mapping[str, int], letters: str, table: Table, unit: int | None) -> Vector | None:
    """Return the value of a polynomial at the basis vectors, None if a product is missing.

    The empty word is the basis vector ``unit``, which then is the identity.
    """
    out = [0] * len(letters)
    for word, c in f.items():
        sign, at = (1, letters.index(word[0])) if word else (1, unit or 0)
        for letter in word[1:]:
            entry = table.get((at, letters.index(letter)))
            if entry is None:
                return None
            sign, at = sign * entry[0], entry[1]
            if not sign:
                break
        out[at] += c * sign
    return out


def is_associative(table: Table, size: int) -> bool:
    """Tell whether (xy)z = x(yz) wherever the products needed are there."""
    for x, y, z in product(range(size), repeat=3):
        xy, yz = table.get((x, y)), table.get((y, z))
        if xy is None or yz is None:
            continue
        left = (0, 0) if not xy[0] else table.get((xy[1], z))
        right = (0, 0) if not yz[0] else table.get((x, yz[1]))
        if left is None or right is None:
            continue
        a = (xy[0] * left[0], left[1])
        b = (yz[0] * right[0], right[1])
        if a != b and (a[0] or b[0]):
            return False
    return True


def find_table(
    letters: str,
    unit: str | None,
    relations: Sequence[Mapping[str, int]],
    goals: Sequence[Mapping[str, int]],
    p: int,
    clock: Clock,
) -> tuple[Table, int, Vector] | None:
    """Return a table in which the relations hold and a goal fails, with that goal and its value.

    Modulo p if p is prime, in which case there are no signs when p = 2; over ℤ for p = 0. ``unit``
    is the letter of the identity if there has to be one. Tables graded by the Klein four-group, as
    that of H is, come first; then any others.
    """
    size = len(letters)
    identity = None if unit is None else letters.index(unit)
    signs = (1, 0) if p == 2 else (1, -1, 0)
    entries = [(s, n) for s in signs for n in range(size if s else 1)]
    table: Table = {}
    if identity is not None:
        for n in range(size):
            table[identity, n] = table[n, identity] = (1, n)
    places = [(x, y) for x in range(size) for y in range(size) if (x, y) not in table]
    places.sort(key=lambda place: (place[0] != place[1], identity is None and 0 in place))

    def is_zero(v: Vector) -> bool:
        return not any(c % p if p else c for c in v)

    def fits() -> bool:
        values = (evaluate(f, letters, table, identity) for f in relations)
        return is_associative(table, size) and all(v is None or is_zero(v) for v in values)

    def search(n: int, graded: bool) -> tuple[Table, int, Vector] | None:
        if clock.is_late:
            return None
        if n == len(places):
            for m, goal in enumerate(goals):
                value = evaluate(goal, letters, table, identity)
                if value is not None and not is_zero(value):
                    return dict(table), m, value
            return None
        x, y = places[n]
        for entry in [(s, x ^ y) for s in signs if s] if graded else entries:
            table[places[n]] = entry
            if fits():
                found = search(n + 1, graded)
                if found is not None:
                    return found
        del table[places[n]]
        return None

    return (search(0, True) or search(0, False)) if fits() else None
