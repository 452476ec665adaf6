"""Rings and places as the data of certificates: by the name that the package reads, or part by part."""

from collections.abc import Sequence
from typing import Any

from hfield.checker.scalars.fields import read_ring
from hfield.checker.scalars.ring import Ring
from hfield.errors import RingError
from hfield.fields.names import ring
from hfield.fields.quadratic_forms import place as place_of

Data = dict[str, Any]

QQ: Data = {"kind": "rationals"}
ZZ: Data = {"kind": "integers"}
RR: Data = {"kind": "reals"}
CC: Data = {"kind": "complexes"}
RDF: Data = {"kind": "floats"}
CDF: Data = {"kind": "complex floats"}
INFINITY: Data = {"kind": "infinity"}


def data_of(name: str) -> Data:
    """Return the data of a ring that the package knows by a name."""
    found = ring(name).data
    if found is None:
        raise RingError(f"{name} has no data, and no certificates")
    return found


def read_field(name: str) -> Ring:
    """Return the checker's ring of a name that the package reads."""
    return read_ring(data_of(name))


def place_data(field: str, text: str) -> Data:
    """Return the data of a place that the package knows."""
    own = ring(field)
    return own.place_data(place_of(own, text))


def residues(n: Any) -> Data:
    return {"kind": "residues", "modulus": n}


def finite(p: Any, degree: Any = 1, modulus: Any = None) -> Data:
    return {"kind": "finite field", "characteristic": p, "degree": degree, "modulus": modulus}


def quadratic(d: Any) -> Data:
    return {"kind": "quadratic field", "d": d}


def multiquadratic(*d: Any) -> Data:
    return {"kind": "multiquadratic field", "d": list(d)}


def generated(modulus: Sequence[Any], variable: Any = "s") -> Data:
    """ℚ[variable]/(modulus), low degree first."""
    return {"kind": "number field", "modulus": list(modulus), "variable": variable}


def root_field(radicand: Any, order: Any) -> Data:
    return {"kind": "root field", "radicand": radicand, "order": order}


def cyclotomic(n: Any, real: bool = False) -> Data:
    return {"kind": "real cyclotomic field" if real else "cyclotomic field", "order": n}


def functions(base: Any, *variables: Any) -> Data:
    return {"kind": "rational functions", "base": base, "variables": list(variables)}


def polynomials(base: Any, *variables: Any) -> Data:
    return {"kind": "polynomials", "base": base, "variables": list(variables)}


def completion(of: Any, place: Any) -> Data:
    return {"kind": "completion", "of": of, "place": place}


def number(n: Any) -> Data:
    return {"kind": "number", "n": n}


def split(n: Any, root: Any) -> Data:
    return {"kind": "split", "n": n, "root": root}


def ideal(p: Any, *element: Any) -> Data:
    """The ideal of p and an element, of which the coefficients follow; of p alone if none do."""
    return {"kind": "prime ideal", "p": p, "element": list(element) or None}


def other(p: Any, polynomial: Any, generator: Any) -> Data:
    return {"kind": "other generator", "p": p, "polynomial": polynomial, "generator": generator}


def prime(*coefficients: Any) -> Data:
    """A prime polynomial, low degree first."""
    return {"kind": "prime polynomial", "coefficients": list(coefficients)}


def real(n: Any) -> Data:
    return {"kind": "real", "number": n}
