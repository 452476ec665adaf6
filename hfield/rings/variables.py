"""Names of variables: which may stand for one, and which read like something else."""

import re

from hfield.errors import RingError, shorten
from hfield.rings.base import Ring

BASIS = ("e", "i", "j", "k")
WORDS = {
    *("and", "or", "not", "exists", "conj", "norm", "trace", "inv", "scalar", "vector", "comm"),
    *("sqrt", "cbrt", "root"),
}
_GREEK = (
    "alpha|beta|gamma|delta|epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi|omicron|pi|rho|sigma|tau|"
    "upsilon|phi|chi|psi|omega|varphi|vartheta|varepsilon"
)
# Greek letters, roots, e and i with an index, functions, infinity, and names of rings such as Qp or GF9.
_CONSTANT = re.compile(
    rf"(?i:{_GREEK}|[α-ω]|sqrt|cbrt|root|cos|sin|tan|exp|log|cis|golden|euler)_?\d*"
    r"|[eijkEI]_?\d*|(?i:inf|infinity|oo|infty)"
    r"|(?:QQ?|ZZ?|R|RR|C|CC|RDF|GF|NN|Zmod)_?(?:[pqI]|\d+|bar)?|FF?_?\d+"
)


def variables(
    what: str, inner: str, base: Ring | None = None, *, adjoined: bool = False
) -> tuple[str, ...]:
    """Read names of variables, none of which means anything else. Raises :class:`RingError`.

    ``adjoined`` names have no modulus behind them, and a number could stand there as well: a name that reads
    like a constant, as in ``QQ(zeta5)`` or ``QQ[pi]``, is not taken for a variable.
    """
    names = tuple(inner.split(","))
    for name in names:
        if not re.fullmatch(r"[^\W\d_]\w*", name):
            raise RingError(f"{what}: {shorten(name)!r} is not the name of a variable such as x")
        if name in BASIS:
            unit = "; the imaginary unit is QQ(I)" if name == "i" else ""
            raise RingError(
                f"{what}: the variable {name!r} would clash with the basis e, i, j, k of the "
                f"quaternions; choose another letter{unit}"
            )
        if name in WORDS:
            raise RingError(f"{what}: {name!r} is a word of the language; choose another name")
        if name == "I":
            raise RingError(f"{what}: I is the imaginary unit, in QQ(I); choose another name")
        if adjoined and _CONSTANT.fullmatch(name):
            raise RingError(
                f"{what}: {shorten(name)} reads like a constant, and is not taken for a variable; name the "
                f"variable x or t, as in {base}({_free(base)}) or {base}[{_free(base)}]; number fields are "
                "written QQ(zeta5), QQ(root(2,3)) or QQ[s]/(s^3-2)"
            )
        if base is not None and name in base.names():
            raise RingError(
                f"{what}: {name!r} already names the generator of {base}; choose another letter, "
                f"such as {_free(base)}"
            )
    if len(set(names)) < len(names):
        raise RingError(f"{what}: a variable occurs twice; expected different names")
    return names


def _free(base: Ring | None) -> str:
    """Return a letter that names nothing in the ring."""
    return next(x for x in "tsuvxyz" if base is None or x not in base.names())
