"""The programs that arrays of quaternions need beside those of the one formula: coordinate by coordinate."""

from hfield.straight_line import FIRST, SECOND, Program, Step

SCALAR = ("s1",)
OTHER_SCALAR = ("s2",)


def _each(operation: str, names: tuple[tuple[str, ...], ...]) -> Program:
    """Return the program that does one thing to each coordinate."""
    steps = tuple(Step(f"r{n}", operation, operands) for n, operands in enumerate(names))
    inputs = tuple(dict.fromkeys(name for operands in names for name in operands))
    return Program(inputs, steps, tuple(step.name for step in steps))


SUM = _each("+", tuple(zip(FIRST, SECOND, strict=True)))
DIFFERENCE = _each("-", tuple(zip(FIRST, SECOND, strict=True)))
NEGATIVE = _each("neg", tuple((name,) for name in FIRST))
SCALED = _each("*", tuple((name, *SCALAR) for name in FIRST))
SCALAR_PRODUCT = _each("*", ((*SCALAR, *OTHER_SCALAR),))
