"""Names of rings made up: by the grammar, in many spellings, with letters wrong, with words for variables."""

import re
from random import Random

TAME = ("x", "t", "s", "u", "y", "z", "w", "a", "b", "T", "x1", "u_2", "pt", "p", "q")
# What reads like a constant, a word of the language, a place, a ring or a prime number.
WILD = (
    *("e", "i", "j", "k", "I", "E", "i5", "e_1", "I0", "pi", "alpha", "omega", "phi2", "golden"),
    *("zeta", "zeta5", "zeta_8", "zeta12", "zeta5x", "Zeta5", "sqrt2", "sqrt_2", "sqrt", "sqrtx"),
    *(
        "root2",
        "inf",
        "oo",
        "Inf",
        "infinity",
        "inf0",
        "x_inf",
        "t_5",
        "GF9",
        "F9",
        "Qp",
        "QQ",
        "Q5",
    ),
    *(
        "Z6",
        "RR",
        "C",
        "Zmod",
        "RDF",
        "CDF",
        "and",
        "or",
        "not",
        "exists",
        "norm",
        "conj",
        "trace",
        "inv",
    ),
    *(
        "over",
        "F",
        "H",
        "N",
        "O",
        "T1",
        "c7",
        "cos",
        "exp",
        "log",
        "lambda",
        "cbrt2",
        "x_",
        "_x",
        "xy",
    ),
    *(
        "x'",
        "5",
        "2x",
        "",
        "x+1",
        "Frac",
        "é",
        "ξ",
        "х",
        "ζ5",
        "ζ₅",
        "ζ_8",
        "π",
        "α",
        "x₁",
        "√2",
        "√x",
    ),
    *("x²", "Ⅷ", "x½"),
)
PRIMES = (2, 3, 5, 7, 11, 13, 17, 23, 29, 31)
ORDERS = (2, 3, 4, 5, 7, 8, 9, 11, 13, 16, 25, 27, 32, 49, 64, 81, 121, 125, 243, 256, 1024)
STRANGE_ORDERS = (6, 12, 1, 0, 10**9 + 7, 2**13, 3**8, 1000003**2)
HIGH = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
LOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def name(rng: Random) -> str:
    """Return a name, dressed or misspelt more often than not."""
    text = rng.choice(SHAPES)(rng)
    if rng.random() < 0.3:
        text = dressed(text, rng)
    for _ in range(rng.choice((0, 0, 0, 1, 1, 2))):
        text = misspelt(text, rng)
    return text


def variable(rng: Random) -> str:
    """Return what is a variable, or had better be none."""
    return rng.choice(TAME if rng.random() < 0.65 else WILD)


def variables(rng: Random) -> str:
    """Return one variable or several."""
    return ",".join(variable(rng) for _ in range(rng.choice((1, 1, 1, 1, 1, 2, 2, 3))))


def whole(n: int, rng: Random) -> str:
    """Write a number, worked out or not."""
    m = rng.randrange(1, 9)
    ways = (f"({n})", f"{n - m}+{m}", f"{m}*{n}-{m - 1}*{n}", f"{n}^1", f"+{n}")
    return rng.choice((*[f"{n}"] * 6, *ways))


def plainly(rng: Random) -> str:
    """A ring without parts."""
    return rng.choice(
        [
            "QQ",
            "ZZ",
            "RR",
            "CC",
            "RDF",
            "CDF",
            "Q",
            "Z",
            "R",
            "C",
            "ℚ",
            "ℤ",
            "ℝ",
            "ℂ",
            "F",
            "Qp",
            "P",
        ]
    )


def residues(rng: Random) -> str:
    """ℤ/n."""
    n = rng.choice((rng.randrange(0, 40), rng.randrange(40, 10**6), 2 ** rng.randrange(1, 70)))
    power, count = f"{rng.choice(PRIMES)}^{rng.randrange(0, 12)}", whole(n, rng)
    plain = (
        f"ZZ/{n}",
        f"Z/{n}",
        f"ZZ{n}",
        f"Z{n}",
        f"Z/{n}Z",
        f"ZZ/{n}ZZ",
        f"ZZ/{power}",
        f"Z{power}",
    )
    return rng.choice(
        (*plain, f"Zmod({count})", f"ZZ/({count})", f"ZZ/({power}-1)", f"ZZ/{power}+1")
    )


def finite(rng: Random) -> str:
    """GF(q), with a modulus or without."""
    q = rng.choice((*ORDERS, *ORDERS, *ORDERS, *STRANGE_ORDERS))
    p = next(p for p in (2, 3, 5, 7, 11, 13, 1000003, q) if p and q % p == 0)
    n = next((n for n in range(1, 20) if p**n == q), 1)
    power = rng.choice((f"{p}^{n}", f"{q}"))
    if n > 1 and rng.random() < 0.3:
        return f"GF({power}, {modulus(p, n, rng)})"
    short = (f"GF{power}", f"F{power}", f"F_{power}", f"𝔽{q}", f"𝔽_{q}", f"GF_{q}", f"GF {q}")
    long = (f"GF({power})", f"GF({whole(q, rng)})", f"FF({q})", f"F({q})", f"GF({p})^{n}")
    return rng.choice((*[f"GF({q})"] * 4, *short, *long))


def modulus(p: int, n: int, rng: Random) -> str:
    """A polynomial in x of degree n, irreducible or not."""
    between = [rng.choice((0, 0, rng.randrange(p))) for _ in range(n - 1)]
    return terms(
        [rng.randrange(1, p), *between, 1], rng.choice(("x",) * 12 + ("X", "y", "2", "t")), rng
    )


def terms(c: list[int], x: str, rng: Random) -> str:
    """Write Σ cₙ·xⁿ with all terms or few, in any order, or by Horner; perhaps times a number."""
    way = rng.randrange(6)
    if way == 0:
        text = "+".join(f"{a}*{x}^{n}" for n, a in enumerate(c))
    elif way == 1:
        text = f"{c[-1]}"
        for a in c[-2::-1]:
            text = f"({text})*{x}+{a}"
    else:
        power = ["1", x, *(f"{x}^{n}" for n in range(2, len(c)))]
        shown = [f"{a}*{power[n]}" for n, a in enumerate(c) if a]
        shown = [re.sub(r"^1\*|\*1$", "", text) for text in shown]
        if way == 2:
            rng.shuffle(shown)
        text = "+".join(reversed(shown)) or "0"
    text = text.replace("+-", "-")
    return f"{rng.choice((2, 4, 7))}*({text})" if rng.random() < 0.1 else text


def polynomials(rng: Random) -> str:
    """R[x, …]."""
    bases = (
        "ZZ",
        "QQ",
        "Z",
        "Q",
        "ℤ",
        "QQ",
        "RR",
        "ZZ/6",
        finite(rng),
        f"GF({rng.choice(PRIMES)})",
    )
    return f"{rng.choice(bases)}[{variables(rng)}]"


def functions(rng: Random) -> str:
    """F(x, …)."""
    base = rng.choice(("QQ", "QQ", "Q", "ℚ", "ZZ", "RR", finite(rng), finite(rng), finite(rng)))
    way = rng.randrange(8)
    if way == 0:
        return f"Frac({base}[{variables(rng)}])"
    if way == 1:
        return f"{rng.choice(('Q', 'QQ', 'GF9', 'F4', 'GF2^3', 'F_5'))}{variable(rng)}"
    return f"{base}({variables(rng)})"


def rational(rng: Random) -> str:
    """A number for under a root."""
    n = rng.choice((rng.randrange(-30, 60), rng.randrange(-3, 6)))
    return rng.choice(
        (*[f"{n}"] * 6, f"{n}/{rng.randrange(1, 9)}", f"{n}.5", f"({n})", f"{n}+1", f"2*{n}", "x")
    )


def number(rng: Random) -> str:
    """A number that has a name."""
    a, n = rational(rng), rng.choice((0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 16, 20, 24, 1001))
    root = f"root({a},{rng.choice((1, 2, 3, 3, 4, 5, 6))})"
    unity = (f"zeta{n}", f"zeta{n}", f"zeta_{n}", f"zeta({n})", f"ζ_{n}", f"ζ{n}")
    square = (*[f"sqrt({a})"] * 3, f"√{a}", f"√({a})", f"sqrt{rng.randrange(-9, 30)}")
    return rng.choice(("I", "I", f"cbrt({a})", root, root, *unity, *square))


def numbers(rng: Random) -> str:
    """A field of numbers."""
    way, x = rng.randrange(12), number(rng)
    if way == 0:
        return f"QQ({rng.choice(('zeta', 'zeta_', 'ζ_'))}{rng.randrange(3, 25)})+"
    if way == 1:
        short = rng.choice(("I", "sqrt2", "sqrt-7", "sqrt8", "sqrt(3)", "√5", "zeta5"))
        return f"{rng.choice(('Q', 'QQ'))}{short}"
    if way == 2:
        several = (
            f"{x}+1",
            f"(1+{x})/2",
            f"2*{x}",
            f"-{x}",
            f"{x}^2",
            f"1/{x}",
            f"{x}+{number(rng)}",
        )
        return f"QQ({rng.choice(several)})"
    if way < 5:
        return f"QQ({','.join([x, *(number(rng) for _ in range(rng.choice((1, 1, 2))))])})"
    return f"{rng.choice(('QQ', 'QQ', 'Q', 'ℚ'))}({x})"


def generated(rng: Random) -> str:
    """ℚ[s]/(f)."""
    s, n = variable(rng), rng.choice((1, 2, 2, 3, 3, 3, 4, 5))
    between = [rng.choice((0, 0, -1, 1, 2)) for _ in range(n - 1)]
    f = terms(
        [rng.choice((-2, -1, 1, 2, 3, 5, 7)), *between, 1], rng.choice((s,) * 9 + ("x",)), rng
    )
    if rng.random() < 0.15:
        f = f.replace("1", "1/2", 1)
    return f"{rng.choice(('QQ', 'QQ', 'Q', 'ZZ'))}[{s}]/({f})"


def extension(rng: Random) -> str:
    """F(t)[u]/(f)."""
    base = rng.choice(("QQ(x)", "GF(3)(t)", "GF(9)(t)", "QQ"))
    return f"{base}[{variable(rng)}]/({rng.choice(('u^2-x', 'u^2-t', 'w^2+w+t'))})"


def of_rationals(rng: Random) -> str:
    """ℚ_p."""
    p = rng.choice((*PRIMES, 1, 4, 6))
    named = (f"Qp({p})", f"QQ_{p}", f"Q_({p})", f"QQp({p})", f"ℚ_{p}", f"ℚ{str(p).translate(LOW)}")
    return rng.choice((*named, "QQ_inf", "Qp"))


def of_functions(rng: Random) -> str:
    """Functions at a polynomial, or at infinity; Laurent series."""
    if rng.random() < 0.3:
        return f"{finite(rng)}(({variable(rng)}))"
    q, v = rng.choice((2, 3, 4, 5, 7, 8, 9)), variable(rng)
    field = rng.choice((f"GF({q})({v})", f"Frac(GF({q})[{v}])"))
    text = terms([rng.randrange(5) for _ in range(rng.choice((1, 2, 2, 3)))] + [1], v, rng)
    if q in (4, 8, 9) and rng.random() < 0.5:
        text += rng.choice(("+x", "-x", f"+x*{v}", f"+(x+1)*{v}"))
    infinity = ("inf", "(inf)", "oo", "∞", f"1/{v}")
    return f"{field}_{rng.choice((f'({text})', f'({text})', text, v, f'({v})', *infinity))}"


def of_numbers(rng: Random) -> str:
    """A number field at an ideal, or at an infinite place."""
    quadratic = [(f"QQ(sqrt({d}))", f"sqrt({d})") for d in (2, 5, -7, 17, -3)]
    fields = [
        *[("QQ(I)", "I"), ("QI", "I"), *quadratic, ("QQ(zeta5)", "zeta5"), ("QQ(zeta_8)", "zeta8")],
        *[("QQ(zeta7)+", "c7"), ("QQ(zeta3)", "zeta3"), ("QQ(root(2,3))", "root(2,3)")],
        *[("QQ(cbrt(3))", "root(3,3)"), ("QQ[s]/(s^3-2)", "s"), ("QQ[s]/(s^3-s-1)", "s")],
        *[("QQ[inf]/(inf^2-2)", "inf"), ("QQ[w]/(w^4-w-1)", "w"), (generated(rng), "s")],
    ]
    field, v = rng.choice(fields)
    p = rng.choice((*PRIMES, 1, 4, 6))
    r = rng.randrange(p)
    ideal = (
        f"({p}, {v}-{r})",
        f"({p},{v}-{r})",
        f"({p}, {r}+{v})",
        f"({p}, {v}^2+{r}*{v}+1)",
        f"({p}, {v})",
    )
    infinity = ("inf", "inf+", "inf-", "inf0", "inf1", "inf2", "(inf0)", "oo")
    return f"{field}_{rng.choice((f'{p}', f'({p})', *ideal, *infinity, f'({p}; {v})', v))}"


def dressed(text: str, rng: Random) -> str:
    """Write it in other signs, or with blanks."""
    for _ in range(rng.choice((1, 1, 2))):
        way = rng.randrange(9)
        if way == 0:
            text = re.sub(r"\^(\d+)", lambda m: m[1].translate(HIGH), text)
        elif way == 1:
            text = text.replace("sqrt", "√")
        elif way == 2:
            text = (
                text.replace("QQ", "ℚ").replace("ZZ", "ℤ").replace("GF", "𝔽").replace("zeta", "ζ")
            )
        elif way == 3:
            text = text.replace("-", "−").replace("*", rng.choice("·×"))
        elif way == 4:
            text = text.replace("^", "**")
        elif way == 5:
            text = re.sub(r"_(\d+)", lambda m: m[1].translate(LOW), text)
        elif way == 6:
            text = text.replace("QQ", "Q").replace("ZZ", "Z")
        else:
            at = rng.randrange(len(text) + 1)
            text = text[:at] + rng.choice((" ", "  ", "\t", "\u00a0")) + text[at:]
    return text


def misspelt(text: str, rng: Random) -> str:
    """Put in, leave out, replace or swap a sign."""
    at, way = rng.randrange(len(text) + 1), rng.randrange(6)
    if way == 5:
        return text[: at - 1] + text[at : at + 1] + text[max(at - 1, 0) : at] + text[at + 1 :]
    sign = rng.choice("QZRCFIexyts_()[]+-*/^,.0123456789 √ζπ²₅∞−é'") if way < 4 else ""
    return text[:at] + sign + text[at + (way > 1) :]


SHAPES = (
    *(
        plainly,
        residues,
        finite,
        finite,
        polynomials,
        functions,
        functions,
        numbers,
        numbers,
        numbers,
    ),
    *(
        generated,
        generated,
        extension,
        of_rationals,
        of_functions,
        of_functions,
        of_numbers,
        of_numbers,
    ),
)
