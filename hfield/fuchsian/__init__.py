"""Units of norm 1 of indefinite orders over ℚ as Fuchsian groups: domains, signatures, words.

All is decided in rational numbers, as the plane lies in the algebra (``plane``). ``group`` is what
a user holds.
"""
