"""Dear implications: many items and steps, wide and long cofactors, facts."""

from functools import partial
from typing import Any

from tests.adversary.hostile.writing import LONG, Hostile, joined, number, proved, ratio
from tests.checker.cases import Field
from tests.checker.ring_data import cyclotomic
from tests.checker.ring_data import number as at_number


def implied(
    statement: str, items: list[Any], field: Field = None, facts: Any = (), **changes: Any
) -> str:
    evidence = {"kind": "implication", "facts": list(facts), "items": items}
    return proved(statement, evidence, field, **changes)


def item(zero: list[str], cofactors: list[str], member: str = "0", **more: Any) -> dict[str, Any]:
    own = {"characteristic": 0, "zero": zero, "relations": [], "member": member}
    return {**own, "cofactors": cofactors, "denominator": 1, **more}


def opposite(nonzero: list[str], steps: list[Any], zero: list[str], **more: Any) -> dict[str, Any]:
    own = {"characteristic": 0, "zero": zero, "relations": [], "nonzero": nonzero}
    return {**own, "steps": steps, **more}


def step(kind: str, cofactors: list[str], **more: Any) -> dict[str, Any]:
    return {"step": kind, "cofactors": cofactors, "denominator": 1, **more}


def divisors_and_zeros(n: int) -> str:
    """Every polynomial is divided by every factor of the denominators."""
    divisors = joined((f"1/(s+{k}) == x" for k in range(1, min(n, 500))), " and ")
    return implied(f"y*t == 0 and {divisors} => z == 0", [item(["y*t"], ["0"])] * n)


def long_division(n: int) -> str:
    """A power divided by its factor, again and again."""
    base = "(s+t+y+1)"
    return implied(f"{base}**{n} == 0 and 1/{base} == x => z == 0", [item([], [])])


def many_items(n: int) -> str:
    clauses = " or ".join(f"(s == {k} and t == {k})" for k in range(9))
    return implied(f"{clauses} or y*z == 1", [item([], [])] * n)


def many_zeros(n: int) -> str:
    return implied("s == 0 => s*t == 1", [item(["s"] * n, ["0"] * n)] * 2)


def many_primes(n: int) -> str:
    primes, p = list[int](), 10_007
    while len(primes) < n:
        if all(p % d for d in range(3, 1_000, 2)):
            primes.append(p)
        p += 2
    items = [item([], [], characteristic=p) for p in primes]
    return implied("s == 0 => t == 0", [item(["s"], ["1"], "s"), *items])


def large_primes(n: int) -> str:
    return implied("s == 0 => t == 0", [item([], [], characteristic=3317044064679887385961813)] * n)


def long_denominators(n: int) -> str:
    items = [item([], [], denominator=2**9_000 * number(1_000, k)) for k in range(n)]
    return implied("s == 0 => t == 0", [item(["s"], ["1"], "s"), *items])


def wide_monomials(n: int) -> str:
    """T1·T2·… in one cofactor."""
    text = "*".join(f"T{k}" for k in range(1, n + 1))
    steps = [step("contradiction", [text, *["0"] * n])]
    return implied("s == 0 => t == 0", [opposite(["s"] * n, steps, ["s"])])


def wide_sums(n: int) -> str:
    """(T1 + T2 + …)·(T1·s − 1) for each T: products of polynomials in thousands of variables."""
    text = "+".join(f"T{k}" for k in range(1, n + 1))
    steps = [step("contradiction", ["0", *[text] * n])]
    return implied("s == 0 => t == 0", [opposite(["s"] * n, steps, ["s"])])


def wide_squares(n: int) -> str:
    """Two sums of thousands of variables, multiplied."""
    text = "+".join(f"T{k}" for k in range(1, n + 1))
    taken = step("squares", ["0"] * (n + 1), terms=[text], coefficients=[1])
    facts = [{"form": "squares", "by": "ordering", "most": None, "positive": True}]
    return implied("s == 0 => t == 0", [opposite(["s"] * n, [taken] * 2, ["s"])], "QQ", facts)


def cofactor(text: str) -> str:
    return implied("s == 0 => t == 0", [item(["s"], [text])])


def cofactors(unit: str, sign: str, n: int) -> str:
    """Cofactors that are long texts."""
    text = sign.join([unit] * min(n, 900_000 // (len(unit) + 1)))
    items = [item(["s-sqrt(2)"], [text])] * max(1, n * len(unit) // 900_000)
    return implied("s == sqrt(2) => t == 0", items, "RR")


def many_factors(n: int) -> str:
    """One known polynomial of many terms times cofactors of many."""
    left, right = ("+".join(f"{v}**{k}" for k in range(1, n)) for v in "st")
    return implied("s == 0 => t == 0", [item([left], [right])] * 20)


def squares(n: int) -> str:
    facts = [{"form": "squares", "by": "ordering", "most": None, "positive": True}]
    terms = ["+".join(f"{number(n, k)}*s**{k}" for k in range(1, 200))]
    taken = step("squares", ["0"], terms=terms, coefficients=[number(n)])
    end = step("contradiction", ["0", "0"])
    return implied("s == 0 => t == 0", [opposite([], [taken, end], ["s"])], "QQ", facts)


def proportional(n: int) -> str:
    """A sum that is a form, but for the last of many long coefficients."""
    facts = [{"form": "squares", "by": "ordering", "most": None, "positive": True}]
    term = "s+" + "+".join(f"t**{k}" for k in range(1, n))
    text = "+".join(f"{number(LONG)}*{m}" for m in term.split("+"))
    taken = step("squares", [text], terms=[term], coefficients=[number(LONG, 1)])
    end = step("contradiction", ["0", "0"])
    return implied("s == 0 => t == 0", [opposite([], [taken, end], [term])], "QQ", facts)


def binary_form(n: int) -> str:
    facts = [{"form": "roots", "by": "factors"}]
    coefficients = [str(2 * number(n, k) + 1) for k in range(65)]
    taken = step("binary form", ["0"], terms=["s+t+1", "s+y+1"], coefficients=coefficients)
    steps = [taken, step("contradiction", ["0", "0", "0"])]
    return implied("s*y == 0 => t == 0", [opposite([], steps, ["s"])] * 20, "QQ", facts)


def rootless(n: int) -> str:
    facts = [{"form": "roots", "by": "factors"}]
    polynomial = "s**64 + 2" + "".join(f"+{2 * number(n, k)}*s**{k}" for k in range(1, 63))
    steps = [step("no root", ["0"], polynomial=polynomial)]
    return implied("s == 0 => t == 0", [opposite([], steps, ["s"])] * n, "QQ", facts)


def rooted(n: int) -> str:
    """A polynomial with a root modulo every prime, and many candidates for rational ones."""
    facts = [{"form": "roots", "by": "factors"}]
    # (s² − 13)(s² − 17)(s² − 221) = s⁶ − 251 s⁴ + 6851 s² − 48841, times a number with many divisors
    m = 2 * 3 * 5 * 7 * 11
    polynomial = f"{m}*s**6-{251 * m}*s**4+{6851 * m}*s**2-{48841 * m}"
    steps = [step("no root", ["0"], polynomial=polynomial)]
    return implied("s == 0 => t == 0", [opposite([], steps, ["s"])] * n, "QQ", facts)


def cases(n: int) -> str:
    factors = {"factors": ["s+t+y+1"], "powers": [n]}
    steps: list[Any] = [step("contradiction", ["0"] * 9)]
    for depth in range(7, -1, -1):
        steps = [step("cases", ["0"] * (depth + 1), **factors, branches=[steps])]
    return implied("s*y == 0 => t == 0", [opposite([], steps, ["s"])])


def relations(field: str, constant: str, relation: str, n: int) -> str:
    own = [relation.format(constant)] * n
    items = [item([f"s-{constant}"], ["0"] * (n + 1), relations=own)]
    return implied(f"s == {constant} => t == 0", items, field)


def choices(n: int) -> str:
    goals = " or ".join(f"(s == {k} and t == {k})" for k in range(8))
    more = joined((f"y == {k}" for k in range(500)), " or ")
    return implied(f"{goals} or {more}", [opposite(["x"], [step("contradiction", ["0"])], [])] * n)


def algebra_facts(n: int) -> str:
    """Facts about norms, the constants of whose algebras are long."""
    facts = [
        {"form": "norm", "by": "place", "place": at_number(3), "algebra": f"(-{number(100, k)},-1|QQ)",
         "u": [ratio(900, m) for m in range(4)], "j": [ratio(900, m) for m in range(4)]}
        for k in range(n)
    ]  # fmt: skip
    return implied("s == 0 => t == 0", [item(["s"], ["0"])], "QQ", facts)


def norms(n: int) -> str:
    """The norm form of a long sum, which is to be 0."""
    facts = [{"form": "norm", "by": "ordering"}]
    terms = [f"{number(n, k)}*s**{k}+t**{n}" for k in range(1, 5)]
    steps = [step("norm", ["0"], terms=terms), step("contradiction", ["0"] * 5)]
    return implied("s == 0 => t == 0", [opposite([], steps, ["s"])], "QQ", facts)


def levels(n: int) -> str:
    """Whether −1 is a sum of two squares in a field of high degree."""
    facts = [{"form": "squares", "by": "level", "most": 3, "positive": False}]
    return implied("s == 0 => t == 0", [item(["s"], ["0"])], cyclotomic(n), facts)


FILES: dict[str, Hostile] = {
    "implication: long terms of a norm": (norms, 3, LONG),
    "implication: a level": (levels, 7, 31),
    "implication: divisors of all zeros": (divisors_and_zeros, 20, 3_000),
    "implication: divided again and again": (long_division, 8, 200),
    "implication: items for many clauses": (many_items, 50, 19_000),
    "implication: many zeros": (many_zeros, 50, 19_000),
    "implication: many characteristics": (many_primes, 30, 19_000),
    "implication: large characteristics": (large_primes, 10, 19_000),
    "implication: long denominators": (long_denominators, 3, 1_900),
    "implication: wide monomials": (wide_monomials, 60, 19_000),
    "implication: sums of many variables": (wide_sums, 20, 1_100),
    "implication: products of many variables": (wide_squares, 40, 1_000),
    "implication: cofactors of ones": (partial(cofactors, "1", "+"), 500, 3_900_000),
    "implication: cofactors of powers": (partial(cofactors, "s", "*"), 500, 3_900_000),
    "implication: cofactors of names": (partial(cofactors, "sqrt(2)", "+"), 50, 900_000),
    "implication: cofactors of numbers": (partial(cofactors, "9", "*"), 500, 3_900_000),
    "implication: cofactors of long numbers": (partial(cofactors, "9" * LONG, "+"), 3, 1_900),
    "implication: products with cofactors": (many_factors, 60, 1_000),
    "implication: long squares": (squares, 20, 90),
    "implication: a form times a number": (proportional, 6, 250),
    "implication: binary forms": (binary_form, 2, 900),
    "implication: polynomials without roots": (rootless, 3, 300),
    "implication: candidates for roots": (rooted, 1, 2_000),
    "implication: cases in cases": (cases, 6, 64),
    "implication: relations of QQ(ζ₄₁)": (
        partial(relations, "QQ(zeta41)", "zeta41", "{0}**65535-{0}**65494"),
        1,
        9_000,
    ),
    "implication: relations of RR": (
        partial(relations, "RR", "sqrt(2)", "{0}**4096-4*{0}**4092"),
        2,
        9_000,
    ),
    "implication: relations of QQ(x)": (
        partial(relations, "QQ(x)", "x", "{0}**65535-{0}**65536"),
        2,
        9_000,
    ),
    "implication: many choices": (choices, 20, 19_000),
    "implication: facts": (algebra_facts, 1, 30),
}
