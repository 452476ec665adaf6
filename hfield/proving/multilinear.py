"""Multilinear maps are equal when they are equal on all tuples of basis vectors (Lemma 1)."""

from itertools import product
from typing import Any

from hfield.errors import NotationError
from hfield.proving.decision import COMMUTATIVE_RINGS, PROVED, REFUTED, Decision
from hfield.proving.evaluation.interpretation import PrimeInterpretation, bind
from hfield.proving.statements.language import BASIS, Sort, read_statement
from hfield.proving.statements.setting import read_setting
from hfield.rings.base import Ring
from hfield.syntax import Binary, Call, Compare, Index, Name, Negate, Node, Number

MAX_TUPLES = 4**6


def degrees(node: Node, names: tuple[str, ...]) -> set[tuple[int, ...]] | None:
    """Return in which degrees in each of the unknowns the terms of ``node`` are, None if unclear.

    Everything is linear in its arguments but ``*`` and ``comm``, which add degrees up; ``norm``,
    ``inv``, division and powers are left out.
    """
    match node:
        case Number(value):
            return {(0,) * len(names)} if value else set()
        case Name(name):
            return {tuple(int(name == n) for n in names)}
        case Negate(x) | Index(x, _) | Call("conj" | "trace" | "scalar" | "vector", (x,)):
            return degrees(x, names)
        case Binary("+" | "-", x, y):
            left, right = degrees(x, names), degrees(y, names)
            return None if left is None or right is None else left | right
        case Binary("*", x, y) | Call("comm", (x, y)):
            left, right = degrees(x, names), degrees(y, names)
            if left is None or right is None:
                return None
            return {tuple(a + b for a, b in zip(u, v, strict=True)) for u in left for v in right}
    return None


def decide_multilinear(
    statement: str, field: Ring | str | None = None, algebra: str | None = None
) -> Decision:
    """Decide an equation whose sides are linear in each of their quaternion unknowns.

    One line of evidence for each tuple of basis vectors, 4ⁿ for n unknowns. Raises
    :class:`NotationError` when the statement is not such an equation, or its algebra has constants
    that are not integers.
    """
    setting = read_setting(field, algebra)
    read = read_statement(statement, setting.field, (), setting.letters, setting.constants)
    names = tuple(name for name, _ in read.unknowns)
    node = read.conclusion
    if (
        not isinstance(node, Compare)
        or node.op != "=="
        or read.hypotheses
        or read.exists
        or any(sort is Sort.SCALAR for _, sort in read.unknowns)
        or any(not c.lstrip("-").isdigit() for c in setting.constants)
    ):
        raise NotationError(
            "expected an equation between quaternion unknowns, in an algebra with integer constants"
        )
    for side in (node.left, node.right):
        found = degrees(side, names)
        if found is None or not found <= {(1,) * len(names)}:
            raise NotationError(
                "a side is not linear in each unknown: each term must contain each of them once",
                read.text,
                side.position,
            )
    if 4 ** len(names) > MAX_TUPLES:
        raise NotationError(f"4^{len(names)} tuples of basis vectors are too many")
    p = 0 if setting.field is None else setting.field.characteristic
    return _by_tuples(node, names, setting.constants, p, setting.field is None)


def _by_tuples(
    node: Compare, names: tuple[str, ...], constants: tuple[str, str, str], p: int, everywhere: bool
) -> Decision:
    world = PrimeInterpretation(0)
    lines: list[list[Any]] = []
    only_p = False
    for choice in product(BASIS, repeat=len(names)):
        values = {
            name: tuple(int(b == u) for u in BASIS) for name, b in zip(names, choice, strict=True)
        }
        bind(world, constants, values)
        left, right = (list(world.embed(world.term(side)[0])) for side in (node.left, node.right))
        differences = [a - b for a, b in zip(left, right, strict=True)]
        if any(d % p if p else d for d in differences):
            witness = {name: [str(c) for c in v] for name, v in values.items()}
            shown = ", ".join(f"{name} = {b}" for name, b in zip(names, choice, strict=True))
            line = f"for {shown} the sides are {left} and {right}"
            found: dict[str, Any] = {"kind": "witness", "values": witness}
            if everywhere:
                witness, found = {**witness, "F": ["QQ"]}, {**found, "field": "QQ"}
            return Decision(REFUTED, "multilinear", witness, (line,), evidence=found)
        only_p |= any(differences)
        lines.append(["".join(choice), left])
    steps = tuple(f"({', '.join(word)}): both sides are {value}" for word, value in lines)
    scope = f"characteristics [{p}]" if only_p else COMMUTATIVE_RINGS
    evidence = {"kind": "multilinear", "unknowns": list(names), "tuples": lines}
    return Decision(PROVED, "multilinear", None, steps, scope, evidence=evidence)
