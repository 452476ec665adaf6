"""Programs, coordinate by coordinate, for operations on arrays of quaternions other than the product."""

from hfield.core.straight_line import FIRST, SECOND, ZERO, Program, ProgramStep

Sides = tuple[tuple[str, ...], ...]  # the names of the rows of each operand

SCALAR = ("s1",)
OTHER_SCALAR = ("s2",)
THIRD = ("w3", "x3", "y3", "z3")


def _each(operation: str, names: tuple[tuple[str, ...], ...]) -> Program:
    """Return the program that applies one operation to each coordinate."""
    steps = tuple(ProgramStep(f"r{n}", operation, operands) for n, operands in enumerate(names))
    inputs = tuple(dict.fromkeys(name for operands in names for name in operands))
    return Program(inputs, steps, tuple(step.name for step in steps))


_PAIRS, _BOTH_SCALARS = tuple(zip(FIRST, SECOND, strict=True)), ((*SCALAR, *OTHER_SCALAR),)
COORDINATEWISE: dict[str, tuple[Program, Sides]] = {
    "sum": (_each("+", _PAIRS), (FIRST, SECOND)),
    "difference": (_each("-", _PAIRS), (FIRST, SECOND)),
    "negative": (_each("neg", tuple((name,) for name in FIRST)), (FIRST,)),
    "scaled": (_each("*", tuple((name, *SCALAR) for name in FIRST)), (FIRST, SCALAR)),
    "scalar product": (_each("*", _BOTH_SCALARS), (SCALAR, OTHER_SCALAR)),
}
SCALARS: dict[str, tuple[Program, Sides]] = {
    "sum": (_each("+", _BOTH_SCALARS), (SCALAR, OTHER_SCALAR)),
    "difference": (_each("-", _BOTH_SCALARS), (SCALAR, OTHER_SCALAR)),
    "product": COORDINATEWISE["scalar product"],
    "negative": (_each("neg", (SCALAR,)), (SCALAR,)),
}


def with_sum(program: Program) -> Program:
    """Return the program of a product to which a third element is added."""
    pairs = list(zip(program.outputs, THIRD, strict=True))
    steps = [ProgramStep(f"r{n}", "+", pair) for n, pair in enumerate(pairs) if pair[0] != ZERO]
    outputs = tuple(z if x == ZERO else f"r{n}" for n, (x, z) in enumerate(pairs))
    return Program((*program.inputs, *THIRD), (*program.steps, *steps), outputs)


def with_denominators(program: Program) -> Program:
    """Extend a program of two elements to their denominators, which are multiplied."""
    step = ProgramStep("d", "*", ("d1", "d2"))
    return Program((*program.inputs, "d1", "d2"), (*program.steps, step), (*program.outputs, "d"))


def _over_both(operation: str) -> Program:
    """Return the program that adds or subtracts two elements with denominators."""
    steps = []
    for n, (x, y) in enumerate(zip(FIRST, SECOND, strict=True)):
        steps += [ProgramStep(f"u{n}", "*", (x, "d2")), ProgramStep(f"v{n}", "*", (y, "d1"))]
        steps.append(ProgramStep(f"r{n}", operation, (f"u{n}", f"v{n}")))
    steps.append(ProgramStep("d", "*", ("d1", "d2")))
    inputs = (*FIRST, *SECOND, "d1", "d2")
    return Program(inputs, tuple(steps), ("r0", "r1", "r2", "r3", "d"))


_CONJUGATE_AND_NORM = (*FIRST, "n1")
_BOTH = ((*FIRST, "d1"), (*SECOND, "d2"))
_INVERSE = tuple(ProgramStep(f"r{n}", "*", (name, "d1")) for n, name in enumerate(FIRST))
FRACTIONS = {
    "sum": (_over_both("+"), _BOTH),
    "difference": (_over_both("-"), _BOTH),
    # of the conjugate and the norm of the numerators, and of the denominator
    "inverse": (
        Program((*_CONJUGATE_AND_NORM, "d1"), _INVERSE, ("r0", "r1", "r2", "r3", "n1")),
        (_CONJUGATE_AND_NORM, ("d1",)),
    ),
}
