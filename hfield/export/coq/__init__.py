"""Statements as theorems of Coq, which a proof assistant checks on its own (docs/coq.md)."""
