"""Build sums, products and quotients of terms without superfluous 0 and 1."""

from hfield.syntax import Binary, Call, Negate, Node, Number

ZERO, ONE = Number(0), Number(1)


def plus(x: Node, y: Node) -> Node:
    """Return x + y, without summands 0."""
    if ZERO in (x, y):
        return y if x == ZERO else x
    return Binary("-", x, y.operand) if isinstance(y, Negate) else Binary("+", x, y)


def minus(x: Node, y: Node) -> Node:
    """Return x − y, without summands 0."""
    if y == ZERO:
        return x
    if isinstance(y, Negate):
        return plus(x, y.operand)
    return Negate(y) if x == ZERO else Binary("-", x, y)


def times(x: Node, y: Node) -> Node:
    """Return x·y, simplified if a factor is 0 or 1, with the sign in front."""
    if ZERO in (x, y):
        return ZERO
    if ONE in (x, y):
        return y if x == ONE else x
    sign, factors = 1, list[Node]()
    for factor in (x, y):
        if isinstance(factor, Negate):
            sign, factor = -sign, factor.operand
        elif isinstance(factor, Number) and factor.value == -1:
            sign, factor = -sign, ONE
        factors.append(factor)
    product = factors[1] if factors[0] == ONE else Binary("*", *factors)
    if factors[1] == ONE:
        product = factors[0]
    return product if sign > 0 else Negate(product)


def over(x: Node, y: Node, by_scalar: bool, left: bool = False) -> Node:
    """Return x·y⁻¹, or y⁻¹·x; ``by_scalar`` means that y is a scalar."""
    if x == ZERO or y == ONE:
        return x
    if by_scalar:
        return Binary("/", x, y)
    inverse = Call("inv", (y,))
    if x == ONE:
        return inverse
    return Binary("*", inverse, x) if left else Binary("*", x, inverse)
