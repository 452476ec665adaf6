"""Units of norm 1 of orders over ℚ that are indefinite, as Fuchsian groups: Dirichlet domains, signatures, words.

All is decided in rational numbers, as the plane lies in the algebra (``plane``). ``group`` is what
a user holds.
"""
