"""Make tests/vectors/orders.json and brandt.json with Sage: ideals and what is computed from them, classes.

Run it in an environment with passagemath-modules, passagemath-pari and passagemath-schemes. Bases are written
as Sage prints them, rows of texts over (1, i, j, k).
"""

import random

from common import write_cases
from sage.algebras.quatalg.quaternion_algebra import QuaternionAlgebra
from sage.all__sagemath_schemes import QQ, ZZ, next_prime
from sage.misc.randstate import set_random_seed
from sage.modular.quatalg.brandt import BrandtModule
from sage.version import version

PAIRS = [
    (-1, -1),
    (-1, -3),
    (-2, -5),
    (-1, -7),
    (-1, -11),
    (-3, -17),
    (-1, -19),
    (-7, -30),
    (-6, -35),
]
PAIRS += [(-13, -22), (2, 3), (-1, 3), (3, 5), (6, -11), (-1, -1019), (-1, -10007)]
PAIRS += [(-2, -(10**12 + 61)), (-1, -(5 * 2**248 - 1))]


def rows(basis):
    return [[str(c) for c in x.coefficient_tuple()] for x in basis]


def element(order, rng, size):
    return sum(ZZ(rng.randint(-size, size)) * b for b in order.basis())


def ideal(order, norm, rng):
    """Return a left ideal of norm that divides a random element's, by generators."""
    while True:
        x = element(order, rng, 50)
        if x.reduced_norm() != 0:
            return order.left_ideal(
                [x * b for b in order.basis()] + [norm * b for b in order.basis()]
            )


def ideals():
    rng = random.Random(14)
    for a, b in PAIRS:
        B = QuaternionAlgebra(QQ, a, b)
        O = B.maximal_order()
        for _ in range(5):
            p, q = (next_prime(rng.randrange(2, 60)) for _ in range(2))
            x = element(O, rng, 9)
            while x.reduced_norm() == 0:
                x = element(O, rng, 9)
            I, J = ideal(O, p, rng), ideal(O, q, rng)
            product = I.conjugate() * J
            case = {
                "a": a,
                "b": b,
                "discriminant": int(B.discriminant()),
                "order": rows(O.basis()),
                "I": rows(I.basis()),
                "J": rows(J.basis()),
                "x": [str(c) for c in x.coefficient_tuple()],
                "norms": [str(I.norm()), str(J.norm())],
                "right_order_I": rows(I.right_order().basis()),
                "conj_I_J": rows(product.basis()),
                "meet": rows(I.intersection(J).basis()),
            }
            if a < 0 and b < 0:
                case["equivalent"] = bool(I.is_left_equivalent(J))
                if abs(b) < 100:
                    case["theta"] = [int(c) for c in I.theta_series_vector(12)]
                    case["units"] = int(O.quadratic_form().representation_number_list(2)[1])
            yield case


def brandt():
    for p in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 43, 67, 97, 101):
        for level in (1, 2, 3, 5):
            if level % p == 0 or p * level > 210:
                continue
            M = BrandtModule(p, level)
            yield {
                "p": p,
                "level": level,
                "classes": int(M.dimension()),
                "hecke": {
                    str(n): [int(c) for c in M.hecke_matrix(n).charpoly().list()]
                    for n in (2, 3, 5, 7)
                    if (p * level) % n
                },
            }


if __name__ == "__main__":
    set_random_seed(0)
    source = {"system": f"Sage {version} (passagemath)", "script": "scripts/vectors/make_orders.py"}
    write_cases("orders.json", source | {"route": "QuaternionFractionalIdeal_rational"}, ideals())
    write_cases("brandt.json", source | {"route": "BrandtModule"}, brandt())
