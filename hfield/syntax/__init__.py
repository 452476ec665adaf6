"""The one grammar: text to syntax tree, for ring elements, quaternions and statements alike.

Python's expression syntax, read by a recursive descent of our own and never by ``eval``::

    statement := "exists" NAME ("," NAME)* ":" statement | iff
    iff       := implies ("<=>" implies)?          implies := or ("=>" implies)?
    or        := and ("or" and)*                   and     := not ("and" not)*
    not       := "not" not | compare               compare := sum (("==" | "!=") sum)?
    sum       := product (("+" | "-") product)*    product := unary (("*" | "/") unary)*
    unary     := ("-" | "+") unary | power         power   := postfix (("**" | "^") integer)?
    postfix   := atom ("[" digit "]")*
    atom      := NUMBER | NAME | NAME "(" sum ("," sum)* ")" | "(" statement ")"

An exponent is an integer literal, signed and in parentheses if one likes. What a name means is
not decided here: rings, algebras and the prover each bring their own names.
"""

from hfield.syntax.parser import MAX_DEPTH, MAX_DIGITS, MAX_LENGTH, parse
from hfield.syntax.reader import Reader, weight
from hfield.syntax.tree import (
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
    Power,
)

__all__ = [
    "MAX_DEPTH",
    "MAX_DIGITS",
    "MAX_LENGTH",
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
    "Power",
    "Reader",
    "parse",
    "weight",
]
