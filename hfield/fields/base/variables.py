"""Names of variables: which are allowed, and which have another meaning."""

import re

from hfield.checker.glossary import BASIS, WORDS, reads_like_a_constant
from hfield.errors import RingError, shorten
from hfield.fields.base.ring import Ring


def variables(
    what: str, inner: str, base: Ring | None = None, *, adjoined: bool = False
) -> tuple[str, ...]:
    """Read names of variables, and check that none has another meaning. Raises :class:`RingError`.

    ``adjoined`` names stand in round brackets, which may also contain numbers: there a name that looks like a
    constant, such as ``zeta5`` or ``pi``, is not taken as a variable.
    """
    names = tuple(inner.split(","))
    for name in names:
        if not re.fullmatch("[a-zA-Z][a-zA-Z0-9_]*", name):
            raise RingError(f"{what}: {shorten(name)!r} is not the name of a variable such as x")
        if name in BASIS:
            unit = "; the imaginary unit is QQ(I)" if name == "i" else ""
            raise RingError(
                f"{what}: the variable {name!r} would clash with the basis e, i, j, k of the "
                f"quaternions; choose another letter{unit}"
            )
        if name == "I":
            raise RingError(f"{what}: I is the imaginary unit, in QQ(I); choose another name")
        if name in WORDS:
            raise RingError(f"{what}: {name!r} is a word of the language; choose another name")
        if adjoined and reads_like_a_constant(name):
            raise RingError(
                f"{what}: {shorten(name)} reads like a constant, and is not taken for a variable; for "
                f"rational functions name the variable x or t, as in {base}({_free(base)}); number fields "
                "are written QQ(zeta5), QQ(root(2,3)) or QQ[s]/(s^3-2)"
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
    """Return a letter that is not a name in the ring."""
    return next(x for x in "tsuvxyz" if base is None or x not in base.names())


def names_in(text: str) -> set[str]:
    """Return the names in a text."""
    return set(re.findall(r"[^\W\d]\w*", text))
