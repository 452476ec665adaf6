"""Groups of units of norm 1 of orders, as Fuchsian groups: domains, signatures, words.

The order splits at one real place. Everything is decided with exact numbers, because the hyperbolic plane
lies in the algebra (``plane``). The public classes are in ``group``.
"""
