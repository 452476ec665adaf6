"""Whether the algebra of a statement exists: its structure constants are defined somewhere.

A constant such as ``1/a`` or ``1/2`` is defined where what is divided by is a unit of the ring. A
statement speaks of those values of the letters only; where there are none, it speaks of nothing.
"""

from dataclasses import replace
from time import monotonic

from hfield.errors import HFieldError, TooLargeError, UndecidedError
from hfield.proving.counterexamples.candidates import Searcher, prime_search, ring_search
from hfield.proving.evaluation.all_cases import counterexample
from hfield.proving.evaluation.interpretation import RingInterpretation
from hfield.proving.existence.terms import about
from hfield.proving.polynomials.expansion import Expanded, polynomial_world
from hfield.proving.polynomials.vanishing import vanishes_as_function
from hfield.proving.statements.language import Sort, Statement
from hfield.proving.statements.setting import Setting, divides
from hfield.rings import ring
from hfield.syntax import parse

FEW = 200
MODULI = range(2, 14)
TRUE = parse("0 == 0")


def algebra_exists(statement: Statement, setting: Setting, deadline: float) -> bool | None:
    """Tell whether the structure constants are defined for some values of the letters.

    Over all fields at once: in some field. None where that is not known.
    """
    if not divides(setting):
        return True
    letters = tuple(name for name in setting.letters if name in statement.sorts)
    about_letters = replace(
        about(statement, TRUE, letters),
        unknowns=tuple((name, Sort.SCALAR) for name in letters),
        divides=True,
    )
    try:
        return _exists(about_letters, setting, deadline)
    except (UndecidedError, TooLargeError):
        return None


def _exists(statement: Statement, setting: Setting, deadline: float) -> bool | None:
    field, constants = setting.field, setting.constants
    if field is None:
        return _generically(statement, setting)
    if not statement.unknowns:
        return Searcher(statement, constants, RingInterpretation(field), deadline, True).test({})
    p = field.characteristic
    if field.is_field and prime_search(statement, constants, p, FEW, deadline, True) is not None:
        return True
    if ring_search(statement, constants, field, FEW, deadline, True) is not None:
        return True
    if field.order is not None:
        found, _ = counterexample(
            statement, constants, field, None, min(deadline, monotonic() + 5.0), True
        )
        return found is not None
    if field.is_field:
        return _generically(statement, setting)
    return False if field.name == "ZZ" and _fails_modulo(statement, setting, deadline) else None


def _generically(statement: Statement, setting: Setting) -> bool:
    """Decide over an infinite field, or all fields: no divisor is 0 as a polynomial."""
    world, variables, unknowns = polynomial_world(statement, setting.constants)
    if setting.field is None:
        return all(c != 0 for c in world.conditions)
    x = Expanded(world.context, variables, unknowns, ())
    return not any(vanishes_as_function(c, x, setting.field) for c in world.conditions)


def _fails_modulo(statement: Statement, setting: Setting, deadline: float) -> bool:
    """Tell whether the divisors are units together nowhere modulo some number, hence not in ℤ."""
    for n in MODULI:
        there = ring(f"ZZ/{n}")
        try:
            found, _ = counterexample(statement, setting.constants, there, None, deadline, True)
        except HFieldError:
            continue
        if found is None:
            return True
    return False
