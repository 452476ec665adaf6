"""Class groups, units and principal ideals of random fields of degree 2 to 6, against PARI's (cypari).

    python scripts/try_class_groups.py [--fields 200] [--seed 0] [--write FILE]

Compares the class group, the narrow class group, the regulator, the roots of unity, ζ_K(−1), and of random
prime ideals whether they are principal. ``--write`` keeps PARI's answers as JSON, for tests/fields. Exit
status 1 if one differs or is refused.
"""

import argparse
import json
import sys
from pathlib import Path
from random import Random
from typing import Any

import cypari

sys.path.insert(0, str(Path(__file__).parents[1]))

from hfield import ring
from hfield.errors import HFieldError

LARGEST = 10**7


def random_field(rng: Random) -> Any:
    """A polynomial of a random field with a discriminant below 10⁷; PARI reduces half of them.

    Quadratic fields are chosen by the radicand: of random polynomials only those of small fields would stay.
    """
    while True:
        n = rng.choice([2, 3, 4, 5, 6])
        size = {3: 40, 4: 12, 5: 5}.get(n, 3)
        f = f"x^{n}" + "".join(f"{rng.randint(-size, size):+d}*x^{k}" for k in range(n))
        if n == 2:
            f = f"x^2{rng.choice([-1, 1]) * rng.randint(1, LARGEST):+d}"
        polynomial = cypari.pari(f)
        if polynomial.polisirreducible() and abs(int(polynomial.nfdisc())) <= LARGEST:
            return polynomial.polredabs() if rng.random() < 0.5 else polynomial


def answers(polynomial: Any, rng: Random) -> dict[str, Any]:
    """What PARI says."""
    b = polynomial.bnfinit(1)
    real = int(b.nf_get_sign()[0])
    primes = [p for p in (2, 3, 5, 7, 11, 13) if rng.random() < 0.5]
    zeta = None
    if real == int(polynomial.poldegree()):
        value = cypari.pari(f"bestappr(lfun(lfuncreate({polynomial}),-1),10^7)")
        zeta = [int(value.numerator()), int(value.denominator())]
    return {
        "polynomial": str(polynomial).replace("x", "s").replace(" ", ""),
        "discriminant": int(polynomial.nfdisc()),
        "classes": [int(c) for c in b.bnf_get_cyc()][::-1],
        "narrow": [int(c) for c in b.bnfnarrow()[1]][::-1],
        "regulator": float(b.bnf_get_reg()),
        "torsion": int(polynomial.nfrootsof1()[0]),
        "zeta": zeta,
        "principal": {
            str(p): sorted(
                [int(P.pr_get_f()), int(not any(b.bnfisprincipal(P, 0)))]
                for P in b.idealprimedec(p)
            )
            for p in primes
        },
    }


def differences(case: dict[str, Any]) -> list[str]:
    """What the library says otherwise."""
    K = ring(f"QQ[s]/({case['polynomial']})")
    units, out = K.unit_group(), []
    found = {
        "classes": list(K.class_group().invariants),
        "narrow": list(K.narrow_class_group().invariants),
        "torsion": units.torsion_order,
        "regulator": case["regulator"]
        if abs(float(units.regulator.mid()) / case["regulator"] - 1) < 1e-9
        else float(units.regulator.mid()),
    }
    if case["zeta"]:
        value = K.zeta_minus_one()
        found["zeta"] = [value.numerator, value.denominator]
    for name, value in found.items():
        if value != case[name]:
            out.append(f"{case['polynomial']}: {name} is {case[name]}, not {value}")
    for p, wanted in case["principal"].items():
        rows = []
        for P in K.primes_above(int(p)):
            a = K.ideal(P)
            answer = a.is_principal()
            if answer and K.ideal(answer.generator) != a:
                out.append(f"{case['polynomial']}: {answer.generator} does not generate {P}")
            rows.append([P.f, int(bool(answer))])
        if sorted(rows) != wanted:
            out.append(
                f"{case['polynomial']}: principal above {p} are {wanted}, not {sorted(rows)}"
            )
    return out


def main() -> int:
    """Compare."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fields", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--write", type=Path)
    options = parser.parse_args()
    rng, cases, wrong = Random(options.seed), [], 0
    for _ in range(options.fields):
        case = answers(random_field(rng), rng)
        cases.append(case)
        try:
            found = differences(case)
        except HFieldError as error:
            found = [f"{case['polynomial']}: {error}"]
        wrong += bool(found)
        print(*found, sep="\n", end="\n" if found else "", flush=True)
    if options.write:
        lines = ",\n".join(map(json.dumps, cases))
        options.write.write_text(
            f'{{"source": "PARI {cypari.pari.version()}",\n"cases": [\n{lines}\n]}}\n'
        )
    print(f"{len(cases)} fields, {wrong} of them otherwise")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
