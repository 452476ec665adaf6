"""The names of rings, read: ``QQ``, ``ZZ/6``, ``GF(9, x^2+1)``, ``QQ(sqrt(-7))``, ``GF(4)(t)``."""

import re
from functools import lru_cache

from hfield.certificates.language import Tree, parse
from hfield.certificates.rejection import MAX_DIGITS, Rejected, reject, shown
from hfield.certificates.scalars.finite import PROVED_BELOW, Residues, galois_field, is_prime
from hfield.certificates.scalars.functions import Functions, Polynomials
from hfield.certificates.scalars.numbers import QQ, Floats, Rationals, Surds
from hfield.certificates.scalars.ring import Ring

MAX_NAME = 4_000
RESERVED = {*"eijk", "I", "and", "or", "not", "exists"}


@lru_cache(maxsize=64)
def read_field(text: str) -> Ring:
    """Return the ring of that name."""
    if len(text) > MAX_NAME:
        reject(f"the name of a ring has {len(text)} characters; at most {MAX_NAME} are read")
    name = without_blanks(text)
    named = {"QQ": QQ, "ZZ": Rationals(False), "RDF": Floats()}
    if name in named:
        return named[name]
    if name in ("RR", "CC"):
        return Surds(name, None)
    if m := re.fullmatch(r"ZZ/([0-9]+)", name):
        n = _number(m[1])
        if n < 2:
            reject("ZZ/n needs n of at least 2")
        return Residues(n, n < PROVED_BELOW and is_prime(n), f"ZZ/{n}")
    m = re.fullmatch(r"GF\(([0-9]+)(?:,(.+))?\)", name)
    if m is not None and ")(" not in (m[2] or ""):
        return galois_field(_number(m[1]), _modulus(m[2], _number(m[1])), name)
    if m := re.fullmatch(r"QQ\((?:sqrt\((-?[0-9]+)\)|I)\)", name):
        d = -1 if m[1] is None else _number(m[1])
        if m[1] is not None and d == -1:
            reject("QQ(sqrt(-1)) is called QQ(I)")
        return Surds(name, d)
    if m := re.fullmatch(r"(.+)\(([a-zA-Z][a-zA-Z0-9_]*)\)", name):
        base = read_field(m[1])
        if not (base is QQ or base.order is not None) or not base.is_field:
            reject(f"{shown(name)}: functions are over QQ or a finite field")
        return Functions(base, _variable(m[2], base), name)
    if m := re.fullmatch(r"(.+)\[([a-zA-Z][a-zA-Z0-9_]*(?:,[a-zA-Z][a-zA-Z0-9_]*)*)\]", name):
        base = read_field(m[1])
        if not isinstance(base, Rationals | Residues) or (base.order and not base.is_field):
            reject(f"{shown(name)}: polynomials are over ZZ, QQ or GF(p)")
        names = tuple(_variable(v, base) for v in m[2].split(","))
        if len(set(names)) < len(names):
            reject(f"{shown(name)}: a variable occurs twice")
        return Polynomials(base, names, name)
    reject(f"there is no ring {shown(name)!r}")


def without_blanks(text: str) -> str:
    """Return a name without its blanks; rejects blanks that part a word or a number in two."""
    if re.search(r"\w\s+\w", text) or not text.isascii():
        reject(f"{shown(text)!r} cannot be read without its blanks, or has strange letters")
    return "".join(text.split())


def _number(digits: str) -> int:
    if len(digits) > MAX_DIGITS:
        reject(f"a number of {len(digits)} digits is too large")
    return int(digits)


def _variable(name: str, base: Ring) -> str:
    if name in RESERVED or base.constant(("name", name)) is not None:
        reject(f"{shown(name)!r} cannot name a variable")
    return name


def _modulus(text: str | None, q: int) -> list[int] | None:
    """Read a polynomial in x with integer coefficients, low degree first."""
    if text is None:
        return None
    bound = q.bit_length() + 1

    def read(tree: Tree) -> list[int]:
        kind = tree[0]
        if kind == "num" and isinstance(tree[1], int):
            return [tree[1]]
        if tree == ("name", "x"):
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
        raise Rejected(f"the modulus {shown(text)!r} is no polynomial in x of a fitting degree")

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
