"""From a kernel's name and the way its arrays lie in memory to machine code."""

from typing import Any

from hfield.compiling import machine_code
from rotation.kernels import formulas
from rotation.native import assembling
from rotation.native.operands import Operand, Way
from rotation.native.sweeping import module

Kind = tuple[int, str, int, int]

_announce = machine_code.Announcer(
    "rotation: compiling a loop for many points, once on this machine "
    "(rotation.warm_up() does it beforehand)"
)
_NUMBERS = {"d": "double", "f": "float"}
_made: dict[Any, machine_code.Function] = {}


def compiled(
    name: tuple[Any, ...], kinds: tuple[Kind, ...], writes: bool
) -> machine_code.Function | None:
    """Return the loop of the kernel ``name``, or None where there can be no machine code.

    ``kinds`` are, operand by operand, how many components there are, numpy's letter for their type, and
    the strides in bytes from one component to the next and from one row to the next.
    """
    if not machine_code.available():
        return None
    operands = [_operand(*kind) for kind in kinds]
    if writes and operands[-1].way is Way.SAME:  # a batch of one
        operands[-1] = operands[-1]._replace(way=Way.STRIDED)
    key = (name, *operands)
    with machine_code.lock:
        if key not in _made:
            assembling.introduce()
            found = formulas.kernel(*name)
            number = operands[0].number if name[0] == "one" else "double"
            text = module(found.fast, found.careful, tuple(operands), int(writes), number)
            _made[key] = machine_code.function(
                machine_code.compiled(text, "entry", announce=_announce)
            )
        return _made[key]


def _operand(width: int, letter: str, component: int, row: int) -> Operand:
    operand = Operand(width, _NUMBERS[letter], Way.STRIDED)
    size = operand.size
    if row == 0:
        way = Way.SAME
    elif row == width * size and (component == size or width == 1):
        way = Way.SIDE_BY_SIDE
    elif row == size:
        way = Way.COLUMNS
    else:
        way = Way.STRIDED
    return operand._replace(way=way)
