"""Make the files on number fields: python3 scripts/vectors/make_number_fields.py

Writes number_fields.json and number_field_ramification.json. Needs cypari (PARI as a Python module), the
extra ``oracles``. Python draws the inputs (seeded); PARI decides.
"""

from collections.abc import Iterator
from random import Random
from typing import Any

from common import write_cases
from cypari import pari

POLYNOMIALS = (
    # cubic: pure, complex, real, cyclic, with a common index divisor, with a larger class number
    "x^3-2", "x^3-x-1", "x^3-3*x-1", "x^3-x^2-4*x-1", "x^3-x^2-2*x-8", "x^3+10*x+1", "x^3+103*x+7",
    # quartic: 8th, 5th roots of unity, real ones, wild at 2 in all ways, many ideal classes
    "x^4-x-1", "x^4+1", "x^4+x^3+x^2+x+1", "x^4-10*x^2+1", "x^4-2", "x^4+4*x+2", "x^4-4*x^2+2",
    "x^4-16*x^2+4", "x^4+7*x^2+4*x+2", "x^4+210*x^2+11",
    # quintic
    "x^5-x+1", "x^5-2", "x^5-4*x+2", "x^5-x^4-4*x^3+3*x^2+3*x-1",
    # sextic: 7th and 9th roots of unity, others
    "x^6+x^5+x^4+x^3+x^2+x+1", "x^6+x^3+1", "x^6-2", "x^6-2*x^3+2", "x^6+8*x+4", "x^6+3*x^5+6*x+10",
    # degree 7 to 10: 11th, 16th, 15th, 24th roots of unity, others
    "x^7-2", "x^7-x-1", "x^7-7*x+3", "x^8+1", "x^8-x^4+1", "x^8-x^7+x^5-x^4+x^3-x+1", "x^8+15", "x^8+4*x^3+2",
    "x^9-3", "x^9-x^3+2", "x^10-2", "x^10+2*x+2", "x^10+x^9+x^8+x^7+x^6+x^5+x^4+x^3+x^2+x+1",
)  # fmt: skip
PRIMES = (2, 3, 5, 7, 11, 13, 31)
EACH = 50


def text(value: Any) -> str:
    return str(value).replace(" ", "")


def generator(nf: Any, prime: Any) -> str:
    """A second generator of a prime ideal, as a polynomial in x."""
    return text(nf.nfbasistoalg(prime[1]).lift())


def drawn(rng: Random, degree: int, n: int) -> str:
    if n % 7 == 0:
        return str(rng.choice((-1, 2, -2, 3, -3, 5, -7)))
    size = (2, 5, 30, 10**4 if degree < 6 else 100)[n % 4]
    terms = [f"({rng.randint(-size, size)})*x^{k}" for k in range(degree)]
    below = rng.randint(2, 12) if n % 5 == 0 else 1
    return f"({'+'.join(terms)})/{below}"


def field_case(polynomial: str, nf: Any) -> dict[str, Any]:
    rng = Random(f"field {polynomial}")
    degree = int(pari(polynomial).poldegree())
    elements = [text(pari(drawn(rng, degree, n))) for n in (1, 2, 3, 5)]
    elements = [x for x in elements if x != "0"]
    primes = []
    for p in PRIMES:
        above = [
            {
                "e": int(P[2]),
                "f": int(P[3]),
                "gen": generator(nf, P),
                "valuations": [int(nf.idealval(pari(x), P)) for x in elements],
            }
            for P in nf.idealprimedec(p)
        ]
        primes.append({"p": p, "above": above})
    return {
        "polynomial": polynomial,
        "discriminant": int(nf[2]),
        "signature": [int(n) for n in nf[1]],
        "class_number": int(pari(f"bnfinit({polynomial},1).no")),
        "elements": elements,
        "primes": primes,
    }


def algebras(polynomial: str, nf: Any) -> Iterator[dict[str, Any]]:
    rng = Random(f"algebras {polynomial}")
    real = list(pari(polynomial).polrootsreal())
    degree = int(pari(polynomial).poldegree())
    for n in range(EACH):
        a, b = pari(0), pari(0)
        while a == 0 or b == 0:
            a, b = (pari(drawn(rng, degree, n + k)) for k in (0, 1 + n % 3))
        if n % 6 == 5:  # split: b = z² − a·y²
            a = pari(drawn(rng, degree, 4 + n % 2)) or pari("x")
            b = pari("(a,z,f)->lift(Mod(z^2-a,f))")(a, pari("x+1"), pari(polynomial))
            if b == 0:
                b = pari(1)
        primes = {str(P): P for x in (pari(2), a, b) for P in nf.idealfactor(x)[0]}
        ramified = [
            [int(P[0]), generator(nf, P)] for P in primes.values() if int(nf.nfhilbert(a, b, P)) < 0
        ]
        negative = [
            k
            for k, z in enumerate(real)
            if pari("(a,z)->subst(a,x,z)")(a, z) < 0 and pari("(a,z)->subst(a,x,z)")(b, z) < 0
        ]
        assert (len(ramified) + len(negative)) % 2 == 0, (polynomial, a, b)
        yield {
            "polynomial": polynomial,
            "a": text(a),
            "b": text(b),
            "checked": len(primes),
            "finite": sorted(ramified),
            "real": negative,
        }


def main() -> None:
    pari.allocatemem(10**9)
    source = {
        "system": f"PARI {'.'.join(str(n) for n in list(pari('version()'))[:3])} (cypari)",
        "script": "make_number_fields.py",
    }
    fields, found = [], []
    for polynomial in POLYNOMIALS:
        nf = pari(f"nfinit({polynomial})")
        fields.append(field_case(polynomial, nf))
        found += algebras(polynomial, nf)
    write_cases(
        "number_fields.json", {**source, "route": "nfinit, idealprimedec, idealval"}, fields
    )
    write_cases(
        "number_field_ramification.json", {**source, "route": "nfhilbert, polrootsreal"}, found
    )
    print(
        len(fields), "fields,", len(found), "algebras,", sum(c["checked"] for c in found), "symbols"
    )


if __name__ == "__main__":
    main()
