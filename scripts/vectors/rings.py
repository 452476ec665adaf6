"""The rings of products.json: how gp and GAP build each, and random elements of it as texts."""

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

Sampler = Callable[[Random], str]

FIELD = "\nisunit(n) = n != 0\n"
PLAIN = "\nshow(z) = Str(lift(z))\n"
TEXT = "\nshow(z) = Str(z)\n"


@dataclass(frozen=True)
class Ring:
    """A ring: its text, the gp and GAP lines that set it up, a sampler, and any modulus.

    In both systems the lines bind the ring's own names (x, y, t, s) and ``one``; s is the square
    root of the quadratic fields, which the texts write as sqrt(d) or I.
    """

    name: str
    gp: str
    gap: str
    sample: Sampler
    modulus: tuple[int, ...] = ()
    root: str = ""
    kind: str = "field"


def polynomial(rng: Random, name: str, degree: int, coefficient: Sampler) -> str:
    terms = [f"({coefficient(rng)})*{name}^{n}" for n in range(degree + 1)]
    return "+".join(rng.sample(terms, rng.randint(1, len(terms))))


def modulus_text(modulus: tuple[int, ...]) -> str:
    return "+".join(f"{c}*x^{n}" for n, c in enumerate(modulus) if c)


def integer(rng: Random) -> str:
    return str(rng.randint(-(10**12), 10**12) if rng.random() < 0.15 else rng.randint(-9, 9))


def small(rng: Random) -> str:
    return str(rng.randint(-4, 4))


def rational(rng: Random) -> str:
    return f"{rng.randint(-9, 9)}/{rng.choice((1, 1, 2, 3, 4, 7))}"


def residue(n: int) -> Sampler:
    return lambda rng: str(rng.randrange(n))


def galois(p: int, degree: int) -> Sampler:
    return lambda rng: polynomial(rng, "x", degree - 1, residue(p))


def function(name: str, coefficient: Sampler) -> Sampler:
    def sample(rng: Random) -> str:
        top = polynomial(rng, name, 2, coefficient)
        return f"({top})/({rng.choice(('1', '1', '1', name, name + '+1'))})"

    return sample


def modular(name: str, n: int) -> Ring:
    unit = f"isunit(n) = gcd(lift(n), {n}) == 1"
    gap = f"one := One(ZmodnZ({n}));" if n in (4, 6) else f"one := One(GF({n}));"
    kind = "residues" if n in (4, 6) else "finite"
    return Ring(name, f"one = Mod(1, {n}); {PLAIN} {unit}", gap, residue(n), kind=kind)


def extension(name: str, p: int, modulus: tuple[int, ...], root: str = "") -> Ring:
    degree = len(modulus) - 1
    gp = f"x = ffgen(Mod(1, {p})*({modulus_text(modulus)}), 'x); one = x^0; {TEXT}{FIELD}"
    gap = f"x := {root or f'Z({p}^{degree})'}; one := x^0;"
    return Ring(name, gp, gap, galois(p, degree), modulus, kind="finite")


def quadratic(name: str, d: int) -> Ring:
    root = "I" if d == -1 else f"sqrt({d})"
    gp = f"""s = Mod(y, y^2 - ({d})); one = s^0; {FIELD}
    times(c) = if (c == 1, "", c == -1, "-", Str(c, "*"))
    show(z) = {{ my(c = polcoef(lift(one*z), 0), b = polcoef(lift(one*z), 1));
      if (b == 0, Str(c), c == 0, Str(times(b), "{root}"),
          Str(c, if (b > 0, "+", ""), times(b), "{root}")) }}"""
    gap = f"s := {'E(4)' if d == -1 else f'Sqrt({d})'}; one := 1;"
    return Ring(name, gp, gap, lambda rng: f"{rational(rng)}+{rational(rng)}*s", (), root, "number")


def rational_functions(name: str, p: int, variable: str) -> Ring:
    one = f"Mod(1, {p})" if p else "1"
    gp = f"{variable} = '{variable}*{one}; one = {one}; {PLAIN} {FIELD}"
    base = f"GF({p})" if p else "Rationals"
    gap = f'{variable} := Indeterminate({base}, "{variable}"); one := {variable}^0;'
    sample = function(variable, residue(p) if p else rational)
    return Ring(name, gp, gap, sample, kind="functions")


RINGS = (
    Ring("QQ", f"one = 1; {TEXT}{FIELD}", "one := 1;", rational, kind="number"),
    Ring(
        "ZZ",
        f"one = 1; {TEXT}isunit(n) = abs(n) == 1",
        "one := 1;",
        integer,
        kind="integers",
    ),
    modular("ZZ/6", 6),
    modular("ZZ/4", 4),
    modular("GF(2)", 2),
    modular("GF(3)", 3),
    modular("GF(7)", 7),
    modular("GF(13)", 13),
    extension("GF(4)", 2, (1, 1, 1)),
    extension("GF(8)", 2, (1, 1, 0, 1)),
    extension("GF(9)", 3, (2, 2, 1)),
    extension("GF(2^8)", 2, (1, 0, 1, 1, 1, 0, 0, 0, 1)),
    extension("GF(3^5)", 3, (1, 2, 0, 0, 0, 1)),
    extension("GF(9, x^2+1)", 3, (1, 0, 1), root="Z(9)^2"),
    quadratic("QQ(sqrt(2))", 2),
    quadratic("QQ(I)", -1),
    quadratic("QQ(sqrt(-7))", -7),
    rational_functions("QQ(x)", 0, "x"),
    rational_functions("GF(2)(t)", 2, "t"),
    rational_functions("GF(5)(t)", 5, "t"),
    Ring(
        "GF(4)(t)",
        f"x = ffgen(Mod(1, 2)*(x^2+x+1), 'x); one = x^0; t = 't*one; {TEXT}{FIELD}",
        't := Indeterminate(GF(4), "t"); x := Z(4); one := t^0;',
        function("t", galois(2, 2)),
        (1, 1, 1),
        kind="functions",
    ),
    Ring(
        "ZZ[x,y]",
        f"one = 1; {TEXT}isunit(n) = n == 1 || n == -1",
        'x := Indeterminate(Rationals, "x"); y := Indeterminate(Rationals, "y"); one := x^0;',
        lambda rng: polynomial(rng, "y", 1, lambda r: polynomial(r, "x", 1, small)),
        kind="polynomials",
    ),
)
