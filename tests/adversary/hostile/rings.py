"""Dear data of rings and of places, one of each kind and more."""

from functools import partial

from tests.adversary.hostile.writing import LONG, Hostile, joined, number, proved, ratio, repeated


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


FILES: dict[str, Hostile] = {
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
}
