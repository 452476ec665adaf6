"""The grammar of ring elements, quaternions and statements: from text to syntax tree.

Python's expression syntax, parsed by hfield itself and never by ``eval``::

    statement := "exists" NAME ("," NAME)* ":" statement | infix
    infix     := prefix (OPERATOR infix)*   binding, from loose to tight:
                 <=>   =>   or   and   (not)   == != >= > <= <   + -   * /   (sign)   ** ^
    prefix    := ("not" | "-" | "+") infix | power
    power     := atom ("[" digit "]")? (("**" | "^") integer)?
    atom      := NUMBER | NAME | NAME "(" statement ("," statement)* ")" | "(" statement ")"

Chains associate to the left, ``=>`` to the right; comparisons and ``<=>`` do not chain. An exponent is an
integer literal, optionally with a sign and parentheses. The meaning of names is not decided here: rings,
algebras and the prover each have their own names.
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
