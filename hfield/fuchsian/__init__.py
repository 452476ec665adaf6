"""Units of norm 1 of orders that split at one real place as Fuchsian groups: domains, signatures, words.

All is decided in exact numbers, as the plane lies in the algebra (``plane``). ``group`` is what a user holds.
"""
