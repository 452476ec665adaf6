"""Dear files before anything is read, and dear statements that are expanded."""

from functools import partial

from tests.adversary.hostile.writing import (
    IDENTITY,
    LENGTH,
    Hostile,
    joined,
    number,
    proved,
    repeated,
)


def filled(unit: str, n: int) -> str:
    """Return a file with n times the same under "evidence"."""
    start, end = proved("s == s", {"kind": "identity", "x": 0}).split('"x":0')
    return f'{start}"x":[{",".join([unit] * n)}]{end}'


# --- statements that are expanded -------------------------------------------------------------------

SUMS = [f"({q}[0]+{q}[1]+{q}[2]+{q}[3])" for q in "pqruvw"]
LEFT = "*".join([*SUMS[:3], "(s+t+y+x+z)", "(s+t**2+y**3)"])  # 960 terms
RIGHT = "*".join([*SUMS[3:], "(s**5+t**7+y**11+x**13+z**17)", "(t**20+y**30+x**40)"])


def expanded(statement: str, field: str | None = None, algebra: str | None = None) -> str:
    return proved(statement, IDENTITY, field, algebra=algebra)


def many_products(n: int) -> str:
    return expanded(" or ".join(f"{LEFT}*{RIGHT} == {k}" for k in range(n)))


def power_of_sums(n: int) -> str:
    return expanded(f"({'+'.join(SUMS)}+s+t+y+x+z)**{n} == 0")


def long_coefficients(n: int) -> str:
    return expanded(f"({number(30)}*s+{number(30, 1)}*t+{number(30, 2)}*y+1)**{n} == 0")


def wide_product(n: int) -> str:
    """Products of long coefficients."""
    f, g = ("+".join(f"{number(150, k)}*{v}**{k + 1}" for k in range(n)) for v in "st")
    return expanded(f"({f})*({g}) == 0")


def tower(n: int) -> str:
    return expanded(f"{'(' * n}(s+t){'**9)' * n} == 0")


def quaternion_power(n: int) -> str:
    return expanded(f"(p*q*r)**{n} == 0")


def negated(n: int) -> str:
    return expanded(f"{'-(' * 45}({'+'.join(SUMS)})**{n}{')' * 45} == 0")


def added(n: int) -> str:
    return expanded(f"({'+'.join(SUMS)})**4+{repeated('s', '+', n)} == 0")


def conjugated(n: int) -> str:
    return expanded(f"{'conj(' * n}p*q*r*u*v{')' * n} == 0")


def divided(n: int) -> str:
    return expanded(f"{joined(f'1/(s+{k})' for k in range(1, n))} == 0")


def multiplied_divisors(n: int) -> str:
    return expanded(f"{joined((f'(1/(s+{k})+1)' for k in range(1, n)), '*')} == 0")


def large_divisors(n: int) -> str:
    return expanded(joined(f"1/((p+q+r+u)[0]**9+s**{k})" for k in range(1, n)) + " == 0")


def inverted(n: int) -> str:
    return expanded(f"{'inv(' * n}q{')' * n} == 0")


def equivalent(n: int) -> str:
    return expanded(" <=> ".join(["(s == t"] * n) + " <=> s == t" + ")" * n)


def alternatives(n: int) -> str:
    return expanded(joined((f"(s == {k} and t == {k})" for k in range(n)), " or "))


def equal_literals(n: int) -> str:
    large = f"({'+'.join(SUMS[:4])})**4 == 0"
    pairs = " or ".join(f"(s == {k} and {large})" for k in range(n))
    return expanded(pairs)


def many_literals(n: int) -> str:
    pairs = " or ".join(f"(s == {k} and t == {k})" for k in range(9))
    return expanded(pairs + " or " + joined((f"y == {k}" for k in range(n)), " or "))


def denied(n: int) -> str:
    return expanded(f"{'not (' * 40}{joined((f's == {k}' for k in range(n)), ' or ')}{')' * 40}")


def spaced(n: int) -> str:
    return expanded("s " + " " * n + "== s")


def reduced_powers(n: int) -> str:
    """Over a finite field exponents are reduced, and goals multiplied."""
    return expanded(" or ".join(f"({SUMS[0]}+{k})**{n} == 0" for k in range(4)), "GF(9)")


def constants_in(field: str, n: int, constant: str) -> str:
    """Powers of a constant of the field, in many terms."""
    return expanded(joined(f"s**{k}*{constant}**{9_000 + k}" for k in range(n)) + " == 0", field)


def structure(n: int) -> str:
    """Structure constants that are large."""
    return expanded("(p*q)*r == p*(q*r)", algebra=f"((a+c+d+1)**{n},(b+f+g)**{n}|F)")


FILES: dict[str, Hostile] = {
    "file: lists": (partial(filled, "[]"), 1_000, 2_600_000),
    "file: objects": (partial(filled, '{"a":0}'), 1_000, 990_000),
    "file: numbers": (partial(filled, "257"), 1_000, 1_950_000),
    "file: long numbers": (partial(filled, "9" * 3_999), 3, 1_990),
    "file: texts": (partial(filled, '"ab"'), 1_000, 1_590_000),
    "file: wide texts": (partial(filled, '"😀"'), 1_000, 1_100_000),
    "identity: three products of a million terms": (many_products, 1, 3),
    "identity: a power of a sum": (power_of_sums, 2, 6),
    "identity: long coefficients": (long_coefficients, 6, 120),
    "identity: a product of long coefficients": (wide_product, 4, 60),
    "identity: a tower of powers": (tower, 1, 40),
    "identity: powers of quaternions": (quaternion_power, 1, 9),
    "identity: signs": (negated, 2, 4),
    "identity: small additions to a large sum": (added, 100, 9_000),
    "identity: conjugates": (conjugated, 10, 90),
    "identity: many divisors": (divided, 20, 1_500),
    "identity: a product with many divisors": (multiplied_divisors, 10, 800),
    "identity: large divisors": (large_divisors, 4, 200),
    "identity: inverses of inverses": (inverted, 2, 60),
    "identity: <=>": (equivalent, 5, 20),
    "identity: many clauses": (alternatives, 6, 700),
    "identity: clauses with equal parts": (equal_literals, 4, 10),
    "identity: clauses with many parts": (many_literals, 40, 1_500),
    "identity: not": (denied, 20, 1_400),
    "identity: blanks": (spaced, 100, LENGTH),
    "identity: exponents over GF(9)": (reduced_powers, 9, 60),
    "identity: constants of RR": (lambda n: constants_in("RR", n, "sqrt(2)"), 3, 500),
    "identity: constants of QQ(ζ₄₁)": (lambda n: constants_in("QQ(zeta41)", n, "zeta41"), 2, 500),
    "identity: constants of QQ(x)": (lambda n: constants_in("QQ(x)", n, "x"), 3, 500),
    "identity: structure constants": (structure, 2, 30),
}
