"""Map scalars of one base ring into another, for ``change_ring``.

Scalars are converted through their texts, so a generator must mean the same in both rings: the class of x in
GF(4) is not the x of GF(16), and a residue modulo 7 is not a rational number.
"""

from collections.abc import Callable

import flint

from hfield import syntax
from hfield.core.product import Scalar
from hfield.errors import CoercionError, HFieldError, shorten
from hfield.fields.base.ring import E, Ring
from hfield.fields.finite.ring import ExtensionField


def embedding(source: Ring, target: Ring) -> Callable[[Scalar], Scalar]:
    """Return the map of scalars of ``source`` into ``target``.

    The map is a homomorphism if both are fields of one characteristic. From characteristic 0 it may reduce
    modulo p; then it fails at denominators that vanish. For finite fields it is the embedding that is
    compatible with Conway polynomials, if these are the moduli, else a fixed one. Raises
    :class:`CoercionError` if there is no such map.
    """
    if source == target:
        return target
    p, q = source.characteristic, target.characteristic
    if (p % q if q else p) != 0:
        raise CoercionError(
            f"{source} does not map into {target}: its characteristic is {p}, the other's {q}"
        )
    given = target.embed_from(source)
    if given is not None:
        return given
    names = {**target.names(), **_generators(source, target)}
    functions = {"/": target.divide, "**": target.power, **target.functions()}
    reader = syntax.Reader(target, names, functions, target.name, target.parse_limit)

    def embed(x: Scalar) -> Scalar:
        text = source.text(x)
        try:
            image: Scalar = reader.read(text)
            return image
        except HFieldError as error:
            raise CoercionError(
                f"{shorten(text)} of {source} has no image in {target}: {error}"
            ) from error

    return embed


def _generators(source: Ring, target: Ring) -> dict[str, Scalar]:
    """Return the images of generators whose names do not determine them."""
    if isinstance(source, ExtensionField):
        return {str(source.gen_name): _image(source, target)}
    own, below = source.images_in(target), source.constants
    return own if below is None else {**own, **_generators(below, target)}


def _image(source: ExtensionField, target: Ring[E]) -> E:
    """Return a root of the modulus of a finite field in the target."""
    inner = target.constants or target
    if inner == source:
        return target(source.text(source.gen))
    if not isinstance(inner, ExtensionField) or inner.degree % source.degree:
        raise CoercionError(f"{target} does not contain {source}")
    root = inner.power(inner.gen, (inner.order - 1) // (source.order - 1))
    if not inner.is_zero(_modulus_at(source, inner, root)):
        polynomials = flint.fq_default_poly_ctx(inner.context)
        modulus = polynomials([inner(c) for c in source.coefficients])
        root = min((y for y, _ in modulus.roots()), key=inner.label)
    return target(inner.text(root))


def _modulus_at(
    source: ExtensionField, target: ExtensionField, y: flint.fq_default
) -> flint.fq_default:
    value = target.zero
    for c in reversed(source.coefficients):
        value = value * y + target(c)
    return value
