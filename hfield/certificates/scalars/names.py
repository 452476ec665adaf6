"""What the names of rings are made of: numbers, variables, and polynomials with integer coefficients."""

import re

from hfield.certificates.language import Tree, parse
from hfield.certificates.rejection import MAX_DIGITS, Rejected, reject, shown
from hfield.certificates.scalars.ring import Ring

RESERVED = {*"eijk", "I", "and", "or", "not", "exists"}


def without_blanks(text: str) -> str:
    """Return a name without its blanks; rejects blanks that part a word or a number in two."""
    if re.search(r"\w\s+\w", text) or not text.isascii():
        reject(f"{shown(text)!r} cannot be read without its blanks, or has strange letters")
    return "".join(text.split())


def integer(digits: str) -> int:
    """Read an integer."""
    if not re.fullmatch("-?[0-9]+", digits):
        reject(f"expected a number, found {shown(digits)!r}")
    if len(digits) > MAX_DIGITS:
        reject(f"a number of {len(digits)} digits is too large")
    return int(digits)


def variable(name: str, base: Ring) -> str:
    """Return the name of a variable, which must mean nothing else."""
    if (
        name in RESERVED
        or re.fullmatch("zeta[0-9]+", name)
        or base.constant(("name", name)) is not None
    ):
        reject(f"{shown(name)!r} cannot name a variable")
    return name


def polynomial(text: str, name: str, bound: int) -> list[int]:
    """Read a polynomial in one variable of at most that degree; integers, low degree first."""

    def read(tree: Tree) -> list[int]:
        kind = tree[0]
        if kind == "num" and isinstance(tree[1], int):
            return [tree[1]]
        if tree == ("name", name):
            return [0, 1]
        if kind == "neg":
            return [-c for c in read(tree[1])]
        if kind in ("+", "-"):
            f, g = read(tree[1]), read(tree[2])
            size = max(len(f), len(g))
            f, g = f + [0] * (size - len(f)), g + [0] * (size - len(g))
            return [a + b if kind == "+" else a - b for a, b in zip(f, g, strict=True)]
        if kind == "*":
            return times(read(tree[1]), read(tree[2]))
        if kind == "pow" and 0 <= tree[2] <= bound:
            out, base = [1], read(tree[1])
            for _ in range(tree[2]):
                out = times(out, base)
            return out
        raise Rejected(
            f"the modulus {shown(text)!r} is no polynomial in {name} of a fitting degree"
        )

    def times(f: list[int], g: list[int]) -> list[int]:
        if len(f) + len(g) - 2 > bound:
            reject(f"the modulus {shown(text)!r} has too high a degree")
        out = [0] * (len(f) + len(g) - 1)
        for m, a in enumerate(f):
            for n, b in enumerate(g):
                out[m + n] += a * b
        if any(c.bit_length() > 4 * MAX_DIGITS for c in out):
            reject(f"the modulus {shown(text)!r} has too large coefficients")
        return out

    found = read(parse(text))
    while found and found[-1] == 0:
        found.pop()
    return found
