"""Random right ideals of orders that split at one real place: is a generator found where there is one?"""

import random
from contextlib import suppress
from typing import Any

from hfield.core.factorisation import factorise

MOST = 10**4


def ideal(rng: random.Random, order: Any) -> Any:
    """Return a random invertible right ideal whose norm divides that of an element."""
    A = order.algebra
    size = 30 if A.ring.name == "QQ" else 4
    while True:
        x = sum((b * rng.randint(-size, size) for b in order.basis), A(0))
        if not x.norm():
            continue
        generators = divisor(rng, A.ring, x.norm())
        found = order.right_ideal([x, *generators])
        if generators != [1] and found.is_invertible() and absolute(found.norm()) <= MOST:
            return found


def divisor(rng: random.Random, K: Any, norm: Any) -> list[Any]:
    """Return generators of a random divisor of a number, of norm up to 10⁴."""
    if K.name == "QQ":
        n = 1
        for p, e in factorise(abs(int(norm))).items():
            for _ in range(rng.randint(0, e)):
                n *= p if n * p <= MOST else 1
        return [n]
    J = K.ideal(1)
    for P, e in K.ideal(norm).factorisation():
        for _ in range(rng.randint(0, e)):
            J = J * P if (J * P).norm() <= MOST else J
    return [1] if J.norm() == 1 else list(J.basis)


def absolute(norm: Any) -> Any:
    return norm.norm() if hasattr(norm, "norm") else norm


def has_positive_generator(order: Any, norm: Any) -> bool | None:
    """Ask PARI for a generator that is positive where the algebra ramifies; None without PARI."""
    with suppress(ImportError):
        from cypari import pari

        K = order.algebra.ring
        ramified = {v.index for v in order.algebra.ramified_places() if v in K.real_places()}
        signs = [int(v.index in ramified) for v in K.real_places()]
        f = K.name.partition("/(")[2][:-1]
        elements = [K.text(x) for x in norm.basis]
        script = f"{{my(b = bnrinit(bnfinit(subst({f}, s, 'x)), [1, {signs}]), I = 0);"
        script += "".join(f"I = idealadd(b, I, subst({x}, s, 'x));" for x in elements)
        return bool(pari(f"{script} bnrisprincipal(b, I, 0) == 0}}"))
    return None


def trial(rng: random.Random, order: Any) -> str:
    """Return what came out; it begins with "failed" where that is wrong."""
    I = ideal(rng, order)
    rational = order.algebra.ring.name == "QQ"
    try:
        answer = I.is_principal()
    except Exception as error:  # each failure is counted
        return f"failed: {type(error).__name__}: {error}"
    if not answer:
        known = True if rational else has_positive_generator(order, I.norm())
        return f"failed: {I} is principal" if known else f"not principal, PARI {known is not None}"
    if answer.element is None:
        return f"failed: no generator of {I}, {answer.reason}"
    if order.right_ideal([answer.element]) != I:
        return f"failed: {answer.element} does not generate {I}"
    return "a generator"
