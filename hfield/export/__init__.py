"""Theorems for proof assistants: Coq, and Lean 4."""
