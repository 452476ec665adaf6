"""Certificates made to be dear: for each kind of evidence and ring, long numbers, high degrees, many terms.

``HOSTILE`` maps a name, ``kind: what is large``, to a function of a size that makes the text of a file, and
to the sizes at which it is tried: one for tests, and one at which it is as dear as the format allows.
"""

import json
from collections.abc import Callable, Iterable
from functools import partial
from random import Random
from typing import Any

from tests.certificates.cases import certified

IDENTITY = {"kind": "identity"}
LONG = 3_900  # digits, as many as are read with some room
LENGTH = 19_000  # characters of a statement, likewise


def number(digits: int, seed: int = 0) -> int:
    """Return a number of that many digits."""
    return Random(f"{seed} {digits}").randrange(10 ** (digits - 1), 10**digits)


def ratio(digits: int, seed: int = 0) -> str:
    """Return a fraction of two such numbers."""
    return f"{number(digits, seed)}/{number(digits, -1 - seed)}"


def joined(terms: Iterable[str], sign: str = "+") -> str:
    """Return terms joined by a sign, with parentheses so that the tree is not high."""
    parts = list(terms)
    while len(parts) > 50:
        parts = [f"({sign.join(parts[k : k + 50])})" for k in range(0, len(parts), 50)]
    return sign.join(parts)


def repeated(text: str, sign: str, n: int, most: int = LENGTH) -> str:
    """Return terms joined by a sign, n of them or as many as a statement holds."""
    return joined([f"({text})"] * max(1, min(n, most // (len(text) + len(sign) + 3))), sign)


def written(data: Any) -> str:
    return json.dumps(data, separators=(",", ":"))


def proved(statement: str, evidence: Any, field: str | None = None, **changes: Any) -> str:
    algebra = changes.pop("algebra", None)
    method = changes.pop("method", evidence["kind"])
    return written({**certified(statement, field, method, evidence, algebra), **changes})


# --- files, before anything is read ---------------------------------------------------------------


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


# --- implications -----------------------------------------------------------------------------------


def implied(
    statement: str, items: list[Any], field: str | None = None, facts: Any = (), **changes: Any
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
    return implied("s == 0 => t == 0", [item(["s"], [text])] * max(1, n * len(unit) // 900_000))


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


def relations(field: str, constant: str, n: int) -> str:
    own = [f"{constant}**65535-{constant}**65536" for _ in range(n)]
    return implied(
        f"s == {constant} => t == 0", [item(["s"], ["0"] * (n + 1), relations=own)], field
    )


def choices(n: int) -> str:
    goals = " or ".join(f"(s == {k} and t == {k})" for k in range(8))
    more = joined((f"y == {k}" for k in range(500)), " or ")
    return implied(f"{goals} or {more}", [opposite(["x"], [step("contradiction", ["0"])], [])] * n)


def algebra_facts(n: int) -> str:
    """Facts about norms, the constants of whose algebras are long."""
    facts = [
        {"form": "norm", "by": "place", "place": "3", "algebra": f"(-{number(100, k)},-1|QQ)",
         "u": [ratio(900, m) for m in range(4)], "j": [ratio(900, m) for m in range(4)]}
        for k in range(n)
    ]  # fmt: skip
    return implied("s == 0 => t == 0", [item(["s"], ["0"])], "QQ", facts)


# --- values of rings --------------------------------------------------------------------------------

NAMES = [f"{a}{b}" for a in "abcdefgh" for b in range(90)]
ROOTS = (2, 3, 5, 7, 11)
X64 = "x^64+x^4+x^3+x+1"


def in_powers(name: str, high: int, long: int, n: int) -> str:
    """Return an element: a sum of powers with long coefficients."""
    return joined(f"({ratio(max(1, long * n // 100), k)})*{name}**{k}" for k in range(high))


RINGS: dict[str, tuple[str, Callable[[int], str]]] = {
    "QQ": ("QQ", lambda n: ratio(LONG * n // 100)),
    "ZZ": ("ZZ", lambda n: str(number(LONG * n // 100))),
    "ZZ/n": (f"ZZ/{number(LONG)}", lambda n: str(number(LONG * n // 100))),
    "GF(p)": ("GF(3317044064679887385961813)", lambda n: str(number(20))),
    "GF(2^64)": (f"GF({2**64},{X64})", lambda n: joined(f"x**{k}" for k in range(n * 64 // 100))),
    "RR": (
        "RR",
        lambda n: "+".join(f"({ratio(n)})*sqrt({d})" for d in (2, 3, 5, 6, 7, 10, 11, 13)),
    ),
    "RR, many primes": ("RR", lambda n: joined((f"sqrt({d})" for d in SQUAREFREE[: 10 * n]), "*")),
    "CC": ("CC", lambda n: "+".join(f"({ratio(9 * n)})*sqrt(-{d})" for d in (2, 3, 5, 6, 7, 10))),
    "QQ(I)": ("QQ(I)", lambda n: f"{ratio(LONG * n // 100)}+{ratio(39 * n)}*I"),
    "QQ(√2)": ("QQ(sqrt(2))", lambda n: f"{ratio(39 * n)}+{ratio(39 * n)}*sqrt(2)"),
    "QQ(√2, …)": (
        f"QQ({','.join(f'sqrt({d})' for d in ROOTS)})",
        lambda n: "*".join(f"(1+{ratio(2 * n)}*sqrt({d}))" for d in ROOTS),
    ),
    "QQ(ζ₄₁)": ("QQ(zeta41)", partial(in_powers, "zeta41", 40, 200)),
    "QQ(c₇₉)": ("QQ(zeta79)+", partial(in_powers, "c79", 39, 200)),
    "QQ(x)": ("QQ(x)", lambda n: f"({in_powers('x', n, 20, n)})/({in_powers('x', n, 30, n)})"),
    "QQ[x]": ("QQ[x]", lambda n: in_powers("x", 2 * n, 20, n)),
    "ZZ[a,…]": (f"ZZ[{','.join(NAMES)}]", lambda n: joined(NAMES[: 7 * n])),
    "ZZ[a,b]": ("ZZ[a,b]", lambda n: f"(a+b+1)**{n // 2}"),
    "GF(5)(t)": ("GF(5)(t)", lambda n: f"(t**{4 * n}+t+1)/(t**{3 * n}+t**{n}+2)"),
    "GF(2^64)(t)": (f"GF({2**64},{X64})(t)", lambda n: f"(x*t**{n}+x**63)/(t**{n}+x**7*t+x)"),
    "GF(9)((t))": ("GF(9)((t))", lambda n: f"(x*t**{n}+x)/(t**{n}+2*t+x)"),
    "Qp(5)": ("Qp(5)", lambda n: ratio(39 * n)),
    "QQ(c₇₉)_inf0": ("QQ(zeta79)+_inf0", partial(in_powers, "c79", 39, 200)),
    "RDF": ("RDF", lambda n: str(2**52)),
}
CONSTANTS = {  # what has to occur in a statement so that facts may speak of it
    "RR": "+".join(f"sqrt({d})" for d in (2, 3, 5, 6, 7, 10, 11, 13)), "QQ(√2)": "sqrt(2)",
    "QQ(√2, …)": "+".join(f"sqrt({d})" for d in ROOTS), "QQ(x)": "x", "QQ(c₇₉)": "c79",
    "QQ(c₇₉)_inf0": "c79",
}  # fmt: skip
SQUAREFREE = [
    str(n) for n in range(2, 4_000) if all(n % (d * d) for d in range(2, 64))
]  # fmt: skip
TERMS: dict[str, Callable[[int], str]] = {
    "sums that cancel": lambda n: repeated("s-s+y-y", "+", 20 * n),
    "products": lambda n: repeated("s*y-y*s", "+", 20 * n),
    "quotients": lambda n: repeated("s/y-1/s", "+", 20 * n),
    "quaternions": lambda n: repeated("p*q-q*p", "+", 20 * n),
    "powers": lambda n: repeated("s**999*y**999", "+", 20 * n),
    "high powers": lambda n: repeated("(p+s)**9999-q**9999", "+", 20 * n),
    "equalities": lambda n: repeated("s == y", " or ", 20 * n) + " or z",
}


def evaluated(ring: str, term: str, n: int) -> str:
    """A witness with values that are long, for a statement that computes with them."""
    name, value = RINGS[ring]
    statement, x = f"{TERMS[term](n)} == z", value(n)
    here = {"s": [x], "y": [x], "z": ["0"]}
    here |= {q: [x, "1", "0", x] for q in "pq"}
    found = {v: here[v] for v in here if v in statement}
    evidence = {"kind": "witness", "field": name, "values": found}
    return proved(statement, evidence, name, verdict="refuted", method="counterexample")


def value_of(name: str, text: str) -> str:
    """A witness that is a long text."""
    evidence = {"kind": "witness", "field": name, "values": {"s": [text]}}
    return proved("s == 0", evidence, name, verdict="refuted", method="counterexample")


def values(name: str, unit: str, sign: str, n: int) -> str:
    """Many long texts of elements, of which −1 should be the sum of the squares."""
    text = repeated(unit, sign, n)
    evidence = {"kind": "squares", "values": [text] * min(400, max(1, n // len(text)))}
    return proved("formally-real", evidence, name, verdict="refuted", method="sum of squares")


def signed(ring: str, n: int) -> str:
    """A sign, which needs precision: that of a difference that is nearly 0."""
    name, value = RINGS[ring]
    x = value(n)
    facts = [{"form": "norm", "by": "ordering", "algebra": f"(({x})**2-({x})*({x}+1),-1|{name})"}]
    return implied(f"s == {CONSTANTS.get(ring, 0)} => t == 0", [item(["s"], ["0"])], name, facts)


def near_zero(n: int) -> str:
    """√2 and its best fractions: the sign of the difference takes as many digits as they have."""
    u, v = 1, 1
    while len(str(v)) < n:
        u, v = u + 2 * v, u + v
    facts = [
        {"form": "norm", "by": "ordering", "algebra": f"({u}/{v}-sqrt(2),{m}*({u}-{v}*sqrt(2))|RR)"}
        for m in range(1, 20)
    ]
    return implied("s == sqrt(2) => t == 0", [item(["s"], ["0"])], "RR", facts)


def many_roots_near_zero(n: int) -> str:
    roots = (2, 3, 5, 7, 11, 13, 17, 19)
    text = "-".join(f"{number(n, d)}*sqrt({d})" for d in roots)
    facts = [{"form": "norm", "by": "ordering", "algebra": f"({text},-1|RR)"}]
    statement = f"s == {'+'.join(f'sqrt({d})' for d in roots)} => t == 0"
    return implied(statement, [item(["s"], ["0"])], "RR", facts)


def squareness(ring: str, n: int) -> str:
    """Whether a norm is a square."""
    name, value = RINGS[ring]
    x = value(n)
    evidence = {"kind": "no root", "value": [x, x, "1", "0"]}
    return proved("modulus-exists", evidence, name, verdict="refuted", method="witness")


def at_place(name: str, place: str, value: str, times: int = 1) -> str:
    facts = [
        {"form": "norm", "by": "place", "place": place, "u": [value, value, "0", "0"],
         "j": ["0", "0", value, "0"], "algebra": f"(-1,-{k}|{name})"}
        for k in range(2, 2 + times)
    ]  # fmt: skip
    return implied("s == 0 => t == 0", [item(["s"], ["0"])], name, facts)


def named(name: str) -> str:
    """A ring whose name is dear to read."""
    return expanded("s == s", name)


def long_modulus(n: int) -> str:
    """ℚ[g]/(g⁴⁰ + …), the least common denominator of whose coefficients is long."""
    return named(f"QQ[g]/(g^40+{'+'.join(f'g^{k}/{number(n, k)}' for k in range(1, 40))}+1)")


def powers_in_modulus(n: int) -> str:
    return named(f"QQ[g]/(g^40+{'+'.join(f'g^{k}/(3**{n}+{k})**2' for k in range(1, 40))}+1)")


def sturm(n: int) -> str:
    """The real roots of a polynomial with long coefficients."""
    modulus = "+".join(f"{2 * number(n, k)}*g^{k}" for k in range(1, 37))
    name = f"QQ[g]/(g^37+{modulus}-2)"
    facts = [{"form": "norm", "by": "ordering"}]
    return implied("s == 0 => t == 0", [item(["s"], ["0"])], name, facts)


def specialised(n: int) -> str:
    top = joined(f"{number(20, k)}*x**{k}" for k in range(n))
    reason = {"by": "specialisation", "at": ratio(1_000), "proof": {"by": "ordering"}}
    facts = [{"form": "norm", "algebra": f"(-({top}),-1|QQ(x))", **reason}]
    return implied("s == x => t == 0", [item(["s"], ["0"])], "QQ(x)", facts)


# --- other kinds of evidence ------------------------------------------------------------------------


def tried(field: str, statement: str, count: int) -> str:
    return proved(statement, {"kind": "exhaustion", "cases": count}, field)


def with_terms(n: int) -> str:
    """A long term for each of many places."""
    names = "ztyx"
    evidence = {"kind": "terms", "terms": {v: repeated("s", "+", n) for v in names}}
    goal = repeated("z+t+y+x", "+", n, 15_000)
    whole = {**evidence, "proof": IDENTITY}
    return proved(f"exists {', '.join(names)}: {goal} == s", whole, method="witness")


def with_calls(n: int) -> str:
    """A long term inside of calls."""
    evidence = {"kind": "terms", "terms": {"q": repeated("p", "+", n)}, "proof": IDENTITY}
    goal = repeated("q", "+", n, 15_000)
    return proved(f"exists q: {'conj(' * 90}{goal}{')' * 90} == p", evidence, method="witness")


def with_cases(n: int) -> str:
    own = {"when": "s == 0", "terms": {"t": repeated("s", "+", n)}, "proof": IDENTITY}
    evidence = {"kind": "cases", "cases": [own] * 60, "cover": IDENTITY}
    goal = repeated("t", "+", n, 15_000)
    return proved(f"exists t: {goal} == s", evidence, method="witness")


def real_root(n: int) -> str:
    evidence = {"kind": "real root", "by": "sign change", "between": [ratio(n), ratio(n, 1)]}
    text = joined(f"{k}*s**{k}" for k in range(1, 900))
    return proved(f"exists s: {text} == 1", evidence, "RR", method="witness")


def quaternion_root(n: int) -> str:
    text = f"{'(' * 90}q{'+p)' * 90}"
    goal = repeated(text, "+", n)
    return proved(f"exists q: {goal} == 1", {"kind": "quaternion root"}, "RR", method="witness")


def reduction(n: int) -> str:
    proof: Any = IDENTITY
    for k in range(50):
        proof = {"kind": "reduction", "modulus": 2 ** (9_000 - 50 + k), "proof": proof}
    goal = repeated("(s+t+y)**9", "+", n)
    return proved(f"{goal} != 1", proof, "ZZ")


def subfield(n: int) -> str:
    evidence = {
        "kind": "subfield", "field": "QQ(sqrt(-41))", "root": str(number(n)),
        "witness": {"kind": "witness", "field": "QQ(sqrt(-41))", "values": {"s": ["1"]}},
    }  # fmt: skip
    return proved("s == 0", evidence, "Qp(3)", verdict="refuted", method="counterexample")


def multilinear(n: int) -> str:
    words = [f"{a}{b}{c}" for a in "eijk" for b in "eijk" for c in "eijk"]
    evidence = {"kind": "multilinear", "unknowns": ["p", "q", "r"]}
    text = repeated("p*(q*r)", "+", n, LENGTH // 2)
    listed = [[w, [0, 0, 0, 0]] for w in words]
    return proved(f"{text} == {text}", {**evidence, "tuples": listed})


def degrees(n: int) -> str:
    total = "(p+q+r+u+v+w)"
    text = repeated(f"{total}*{total}*{total}*({total}*{total}*{total})", "+", n)
    evidence = {"kind": "multilinear", "unknowns": list("pqruvw"), "tuples": [["", [0] * 4]]}
    return proved(f"{text} == p", evidence)


def unsatisfiable(n: int) -> str:
    goal = repeated("(s+t+y)**9", "+", n)
    evidence = {"kind": "unsatisfiable", "proof": IDENTITY}
    return proved(f"{goal} == 1 => s == 1", evidence, verdict="vacuous")


# --- words --------------------------------------------------------------------------------------------


def presented(statement: str, proofs: Any, relations: Any, goals: Any) -> str:
    evidence = {
        "kind": "presentation", "characteristic": 0, "identity": True, "relations": relations,
        "goals": goals, "proofs": proofs,
    }  # fmt: skip
    return proved(f"associative(i, j, k): {statement}", evidence)


def read_words(n: int) -> str:
    return presented(f"{repeated('(i+j)**12', '+', n)} == 0 => i == 0", [], [], [])


def long_words(n: int) -> str:
    """Each multiple of a relation has words of its own, and long coefficients."""
    text = joined(f"{'*'.join('ij'[int(b)] for b in f'{k:08b}')}" for k in range(200))
    relation = [[1, "".join("ij"[int(b)] for b in f"{k:08b}")] for k in range(200)]
    multiples = [
        [number(LONG, 1), "".join("ij"[int(b)] for b in f"{k:015b}"), 0, ""] for k in range(n)
    ]
    proofs = [{"cofactors": multiples, "denominator": 1}]
    return presented(f"{text} == 0 => i == 0", proofs, [relation], [[[1, "i"]]])


def table(n: int) -> str:
    evidence = {
        "kind": "algebra", "characteristic": 0, "identity": True,
        "relations": [[[1, "i" * 200]]] , "goals": [[[1, "i"]]], "goal": 0, "value": [0, 1, 0, 0],
        "table": {x + y: [10**9] * 4 for x in "eijk" for y in "eijk"},
    }  # fmt: skip
    text = f"associative(i, j, k): {repeated('i**200 == 0', ' and ', n)} => i == 0"
    return proved(text, evidence, verdict="refuted")


# --- words of the ledger ------------------------------------------------------------------------------


def every(part: str, evidence: Any, field: str | None, n: int) -> str:
    parts = [{"verdict": "proved", "evidence": evidence}] * n
    return proved(f"every{{{';'.join([part] * n)}}}", {"kind": "parts", "parts": parts}, field)


def all_choices(n: int) -> str:
    elements = [[str(k), "0", "0", "0"] for k in range(n)]
    evidence = {"kind": "all choices", "elements": elements, "roots": list(map(str, range(n)))}
    return proved("modulus-law{*}", evidence, "QQ", verdict="refuted")


def level(n: int) -> str:
    evidence = {"kind": "squares", "values": [ratio(LONG)] * n}
    return proved("formally-real", evidence, "QQ", verdict="refuted")


# --- lattices -----------------------------------------------------------------------------------------

ONE = [[int(m == n) for n in range(4)] for m in range(4)]
LIPSCHITZ = "1,0,0,0|0,1,0,0|0,0,1,0|0,0,0,1"


def skewed(digits: int) -> list[list[int]]:
    """Return a basis of ℤ⁴ with long entries."""
    rows, n = [list(row) for row in ONE], number(max(1, digits // 3))
    for m in range(1, 4):
        rows[m] = [a + n * b for a, b in zip(rows[m], rows[m - 1], strict=True)]
    return rows


def rows_text(digits: int, seed: int = 0) -> str:
    return "|".join(",".join(ratio(digits, seed + 4 * m + n) for n in range(4)) for m in range(4))


def about(statement: str, evidence: Any, algebra: str = "(-1,-1|QQ)", **changes: Any) -> str:
    kind = statement.partition("{")[0]
    return proved(statement, {"kind": kind, **evidence}, "QQ", algebra=algebra, **changes)


def embedding(n: int) -> str:
    basis = {"den": 1, "rows": skewed(n)}
    statement = f"embedding{{{LIPSCHITZ}; -{4 * 997 + 3}}}"
    return about(statement, {"basis": basis}, verdict="refuted", method="enumeration")


def embedding_lines(n: int) -> str:
    """Long lines and short minors: every vector is found, and slowly."""
    rows = [ONE[0], *([number(n, m), *row[1:]] for m, row in enumerate(ONE[1:]))]
    statement = f"embedding{{{LIPSCHITZ}; -{4 * 1_000 * 64}}}"
    return about(
        statement, {"basis": {"den": 1, "rows": rows}}, verdict="refuted", method="enumeration"
    )


def embedding_far(n: int) -> str:
    """A discriminant so large that too many elements would be run through."""
    basis = {"den": 1, "rows": ONE}
    statement = f"embedding{{{LIPSCHITZ}; -{number(n) * 4 + 3}}}"
    return about(statement, {"basis": basis}, verdict="refuted", method="enumeration")


def long_order(n: int) -> str:
    return about(f"order{{{rows_text(n)}; 1}}", {})


def long_algebra(n: int) -> str:
    algebra = f"[-{ratio(n)},-{ratio(n, 1)},{ratio(n, 2)}|QQ)"
    return about(f"order{{{LIPSCHITZ}; 1}}", {}, algebra)


def long_ideal(n: int) -> str:
    return about(f"ideal{{{rows_text(n // 2)}; left; {rows_text(n // 2, 50)}; 1}}", {})


def equivalent_lattices(n: int) -> str:
    statement = f"equivalent{{left; {rows_text(n // 2)}; {rows_text(n // 2, 50)}}}"
    return about(statement, {"element": [ratio(LONG // 2, k) for k in range(4)]})


def unequal_lattices(n: int) -> str:
    statement = f"equivalent{{left; {rows_text(n // 2)}; {rows_text(n // 2, 50)}}}"
    return about(statement, {"between": {"den": 1, "rows": skewed(LONG)}}, verdict="refuted")


def many_orders(n: int) -> str:
    """The least vectors of every class, whose bases are long."""
    classes = [{"den": 1, "rows": skewed(3 * k + 3)} for k in range(n)]
    return about(f"class-set{{{LIPSCHITZ}; {n}}}", {"classes": classes})


def same_order(n: int) -> str:
    classes = [{"den": 1, "rows": ONE}] * n
    return about(f"class-set{{{LIPSCHITZ}; {n}}}", {"classes": classes})


def isomorphic(n: int) -> str:
    bases = [{"den": 1, "rows": skewed(n)}] * 2
    statement = f"isomorphic-orders{{{LIPSCHITZ}; {LIPSCHITZ}}}"
    evidence = {"trace": 0, "norm": 30, "bases": bases}
    return about(statement, evidence, verdict="refuted", method="enumeration")


def factoring(n: int) -> str:
    """A discriminant with two large primes."""
    rows = f"1,0,0,0|0,{n},0,0|0,0,{n},0|0,0,0,{n}"
    return about(f"order{{{rows}; {4 * n**3}; maximal}}", {})


Hostile = tuple[Callable[[int], str], int, int]
HOSTILE: dict[str, Hostile] = {
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
    "identity: <=>": (equivalent, 5, 60),
    "identity: many clauses": (alternatives, 6, 900),
    "identity: clauses with equal parts": (equal_literals, 4, 10),
    "identity: clauses with many parts": (many_literals, 40, 1_500),
    "identity: not": (denied, 20, 1_400),
    "identity: blanks": (spaced, 100, LENGTH),
    "identity: exponents over GF(9)": (reduced_powers, 9, 60),
    "identity: constants of RR": (lambda n: constants_in("RR", n, "sqrt(2)"), 3, 500),
    "identity: constants of QQ(ζ₄₁)": (lambda n: constants_in("QQ(zeta41)", n, "zeta41"), 2, 500),
    "identity: constants of QQ(x)": (lambda n: constants_in("QQ(x)", n, "x"), 3, 500),
    "identity: structure constants": (structure, 2, 30),
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
    "implication: long squares": (squares, 20, LONG),
    "implication: a form times a number": (proportional, 6, 400),
    "implication: binary forms": (binary_form, 2, 900),
    "implication: polynomials without roots": (rootless, 3, 300),
    "implication: candidates for roots": (rooted, 1, 2_000),
    "implication: cases in cases": (cases, 6, 64),
    "implication: relations of QQ(ζ₄₁)": (partial(relations, "QQ(zeta41)", "zeta41"), 1, 9_000),
    "implication: relations of RR": (partial(relations, "RR", "sqrt(2)"), 2, 9_000),
    "implication: relations of QQ(x)": (partial(relations, "QQ(x)", "x"), 2, 9_000),
    "implication: many choices": (choices, 20, 19_000),
    "implication: facts": (algebra_facts, 1, 30),
    **{
        f"witness over {ring}: {term}": (partial(evaluated, ring, term), 3, 100)
        for ring in RINGS
        for term in TERMS
    },
    "witness: a long term": (lambda n: value_of("QQ", repeated("1", "+", n)), 200, 9_000),
    "words: long terms": (partial(values, "QQ", "1", "+"), 500, 7_000_000),
    "words: signs": (partial(values, "QQ", "- 1", "+"), 500, 7_000_000),
    "words: parentheses": (partial(values, "QQ", "((((1))))", "+"), 500, 7_000_000),
    "words: powers": (partial(values, "QQ", "3**999", "+"), 500, 7_000_000),
    "words: powers in GF(5)": (partial(values, "GF(5)", "2**9999", "+"), 500, 7_000_000),
    "words: names of many": (
        partial(values, f"ZZ[{','.join(NAMES)}]".replace("ZZ", "QQ"), "a1", "+"),
        500,
        7_000_000,
    ),
    "words: names": (partial(values, "QQ(I)", "I", "+"), 500, 7_000_000),
    "words: decimals": (partial(values, "QQ", "1e9", "+"), 500, 7_000_000),
    **{
        f"ordering of {ring}": (partial(signed, ring), 1, 4)
        for ring in ("QQ", "RR", "QQ(√2)", "QQ(√2, …)", "QQ(c₇₉)", "QQ(x)", "QQ(c₇₉)_inf0")
    },
    "ordering of RR: nearly 0": (near_zero, 20, 500),
    "ordering of RR: many roots": (many_roots_near_zero, 20, 1_900),
    **{
        f"squares of {ring}": (partial(squareness, ring), 2, 40)
        for ring in RINGS
        if ring not in ("ZZ", "ZZ/n", "QQ[x]", "ZZ[a,…]", "ZZ[a,b]", "RDF")
    },
    "place of QQ": (
        lambda n: at_place("QQ", str(2 * number(n) + 1), ratio(n), n // 33 + 1),
        9,
        990,
    ),
    "place of QQ: powers": (lambda n: at_place("QQ", "3", f"1/3**{n}", n // 350 + 1), 9, 9_900),
    "place of QQ(√17), split": (
        lambda n: at_place("QQ(sqrt(17))", "(2,sqrt(17)-1)", f"sqrt(17)/2**{n}", n // 350 + 1),
        9,
        999,
    ),
    "place of QQ(√2), inert": (
        lambda n: at_place("QQ(sqrt(2))", "5", f"{ratio(n)}*sqrt(2)", n // 130 + 1),
        9,
        LONG,
    ),
    "place of QQ(ζ₄₁)": (
        lambda n: at_place(
            "QQ(zeta41)", "(83,zeta41-30)", f"zeta41/83**{n}+1/83**{n}", n // 70 + 1
        ),
        2,
        2_000,
    ),
    "place of QQ(ζ₄₁), another generator": (
        lambda n: at_place("QQ(zeta41)", f"(3,x+1;zeta41+{number(n)})", "zeta41"),
        2,
        900,
    ),
    "place of QQ[g]/(g³ − 2)": (
        lambda n: at_place("QQ[g]/(g^3-2)", "(2,g)", f"g/2**{n}+1/3", n // 350 + 1),
        9,
        9_900,
    ),
    "place of GF(5)(t)": (
        lambda n: at_place("GF(5)(t)", f"t^{n}+t+1", f"(t+1)**{n}", 3),
        3,
        200,
    ),
    "place of GF(2^64)(t)": (
        lambda n: at_place(f"GF({2**64},{X64})(t)", f"t^{n}+x*t+x", f"(t+x)**{n}", 3),
        2,
        200,
    ),
    "place of QQ(x)": (specialised, 5, 200),
    "name: a long modulus": (long_modulus, 2, 90),
    "name: powers in a modulus": (powers_in_modulus, 3, 5_000),
    "name: a power in a modulus": (lambda n: named(f"QQ[g]/(g^40-1/3^{n})"), 9, 9_999),
    "name: real roots": (sturm, 2, 100),
    "name: roots in discs": (lambda n: named(f"QQ[g]/(g^{n}+{2**90 + 1}*g^2+{2**90}*g+4)"), 4, 14),
    "name: a factor of high degree": (lambda n: named(f"QQ[g]/(g^{n}-2)"), 5, 40),
    "name: cyclotomic": (lambda n: named(f"QQ(zeta{n})"), 24, 360),
    "name: double angle": (lambda n: named(f"QQ(zeta{n})+"), 24, 384),
    "name: a modulus of GF(q)": (
        lambda n: named(f"GF({2**500},({'x+' * n}{number(500)}*x+{number(500, 1)})**500)"),
        1,
        100,
    ),
    "name: GF(q) of high degree": (lambda n: named(f"GF({2**n},x^{n}+x^4+x^3+x+1)"), 5, 64),
    "name: GF(q)": (lambda n: named(f"GF({2**n - 1})"), 20, 512),
    "name: many variables": (lambda n: named(f"ZZ[{','.join(NAMES[:n])}]"), 30, 720),
    "name: completions of completions": (lambda n: named("QQ" + "_inf" * n), 3, 900),
    "name: brackets": (lambda n: named("((" * n), 10, 1_900),
    "exhaustion: powers": (
        lambda n: tried(
            "GF(4999)", f"{joined(f's**{k}' for k in range(n, 1, -1))} == s or s != 1", 4999
        ),
        40,
        2_000,
    ),
    "exhaustion: clauses": (
        lambda n: tried(
            "GF(4999)", f"{joined(f's**{k}*t' for k in range(n, 1, -1))} == s or s != t", 4999**2
        ),
        40,
        2_000,
    ),
    "exhaustion: GF(4096)": (
        lambda n: tried(
            "GF(4096)",
            f"{joined(f'x**{k}*s**{k}*t' for k in range(n, 1, -1))} == s or s != t",
            4096**2,
        ),
        20,
        900,
    ),
    "exhaustion: quaternions": (lambda n: tried("GF(7)", f"(p*q)**{n} == (q*p)**{n}", 7**8), 2, 12),
    "exhaustion: evaluated": (
        lambda n: tried("ZZ/4", f"{repeated('s**9999', '+', n)} == 1/s", 4),
        5,
        2_000,
    ),
    "exhaustion: high powers of quaternions": (
        lambda n: tried("ZZ/8", f"{repeated('q**9999', '+', n)} == 1/q[0]", 8**4),
        3,
        2_000,
    ),
    "exhaustion: exists": (
        lambda n: tried("ZZ/6", f"exists s: {repeated('q**9', '+', n)} == s*i + i", 6**4),
        5,
        2_000,
    ),
    "terms: long terms": (with_terms, 30, 9_000),
    "terms: in calls": (with_calls, 30, 9_000),
    "cases: long terms": (with_cases, 30, 9_000),
    "real root: a change of sign": (real_root, 2, LONG),
    "quaternion root: high": (quaternion_root, 2, 400),
    "reduction: again and again": (reduction, 2, 1_900),
    "subfield: a long root": (subfield, 30, LONG),
    "multilinear: long sides": (multilinear, 4, 2_000),
    "multilinear: many degrees": (degrees, 1, 200),
    "unsatisfiable: long": (unsatisfiable, 2, 1_800),
    "presentation: words of a statement": (read_words, 1, 1_900),
    "presentation: long coefficients": (long_words, 5, 1_900),
    "algebra: long words": (table, 2, 1_500),
    "every: determinants": (
        lambda n: every(
            f"basis{{6;{';'.join(','.join(['7'] * 6) for _ in range(6))}}}",
            {"kind": "determinant"},
            None,
            n,
        ),
        1,
        64,
    ),
    "every: forms": (
        lambda n: every("last-argument{4;1,2,3,4}", {"kind": "identity"}, None, n),
        1,
        64,
    ),
    "modulus-law: all choices": (all_choices, 3, 8),
    "modulus-law: all pairs of roots": (
        lambda n: proved("modulus-law{*}", {"kind": "square roots"}, f"GF({n})"),
        7,
        251,
    ),
    "formally-real: long squares": (level, 3, 900),
    "embedding: a long basis": (embedding, 30, LONG),
    "embedding: long lines": (embedding_lines, 30, LONG),
    "embedding: a large discriminant": (embedding_far, 3, 60),
    "order: long rows": (long_order, 5, 550),
    "order: a long algebra": (long_algebra, 5, 1_900),
    "ideal: long rows": (long_ideal, 6, 560),
    "equivalent: long rows": (equivalent_lattices, 6, 560),
    "equivalent, refuted: long rows": (unequal_lattices, 6, 560),
    "class-set: long bases": (many_orders, 5, 200),
    "class-set: many classes": (same_order, 5, 19_000),
    "isomorphic-orders: long bases": (isomorphic, 30, LONG),
    "order: two large primes": (factoring, 1_009, 1_000_003 * 1_000_033),
}
