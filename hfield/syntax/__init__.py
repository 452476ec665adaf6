"""The grammar of ring elements, quaternions and statements: from text to syntax tree.

Python's expression syntax, read by a parser of our own and never by ``eval``::

    statement := "exists" NAME ("," NAME)* ":" statement | infix
    infix     := prefix (OPERATOR infix)*   binding, from loose to tight:
                 <=>   =>   or   and   (not)   == != >= > <= <   + -   * /   (sign)   ** ^
    prefix    := ("not" | "-" | "+") infix | power
    power     := atom ("[" digit "]")? (("**" | "^") integer)?
    atom      := NUMBER | NAME | NAME "(" statement ("," statement)* ")" | "(" statement ")"

Chains associate to the left, ``=>`` to the right; comparisons and ``<=>`` do not chain. An
exponent is an integer literal, signed and in parentheses if one likes. What a name means is
not decided here: rings, algebras and the prover each bring their own names.
"""

from hfield.syntax.building import (
    both,
    comm,
    conj,
    either,
    equal,
    iff,
    implies,
    inv,
    names,
    negation,
    norm,
    scalar,
    unequal,
    vector,
)
from hfield.syntax.parser import MAX_DIGITS, parse
from hfield.syntax.products import MAX_DEPTH, Vocabulary
from hfield.syntax.reader import OfTrees, Reader, weight
from hfield.syntax.spelling import MAX_LENGTH, plain, plain_element, spell
from hfield.syntax.tree import (
    ORDER,
    Binary,
    Call,
    Compare,
    Exists,
    Index,
    Logic,
    Name,
    Negate,
    Node,
    Not,
    Number,
    Operand,
    Power,
    children,
    number,
    rebuild,
)
from hfield.syntax.typed import Typed, reported_as_typed

__all__ = [
    "MAX_DEPTH",
    "MAX_DIGITS",
    "MAX_LENGTH",
    "ORDER",
    "Binary",
    "Call",
    "Compare",
    "Exists",
    "Index",
    "Logic",
    "Name",
    "Negate",
    "Node",
    "Not",
    "Number",
    "OfTrees",
    "Operand",
    "Power",
    "Reader",
    "Typed",
    "Vocabulary",
    "both",
    "children",
    "comm",
    "conj",
    "either",
    "equal",
    "iff",
    "implies",
    "inv",
    "names",
    "negation",
    "norm",
    "number",
    "parse",
    "plain",
    "plain_element",
    "rebuild",
    "reported_as_typed",
    "scalar",
    "spell",
    "unequal",
    "vector",
    "weight",
]
