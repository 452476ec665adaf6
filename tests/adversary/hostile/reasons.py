"""For what hostile certificates may be rejected: for what their evidence says, not for its form."""

# What a certificate may be rejected for when all of its evidence has been read.
MEANT = (
    *(
        "takes more work",
        "has too many clauses",
        "has grown too large",
        "too many square roots in one number",
    ),
    *("does not hold by expanding", "is not covered by the evidence", "is true at the values"),
    *("is false in one of the cases", "for some values nothing exists"),
    *("a sum of cofactors", "a relation does not hold", "a sum of multiples of the relations"),
    *("are not those of the statement", "the sides at eee", "is not linear in each unknown"),
    *("do not add up", "the sign does not change", "no single monomial"),
    *("the norm of the element is a square", "the norm is not that number"),
    *("the element is 0", "a choice of the roots satisfies", "are not decided here"),
    *("is not decided here", "has a root among the residues", "the norm of j has not"),
    *("this is no order", "there is nothing to run through", "are in one class"),
    *("the element is not in the order", "the element does not", "an element carries"),
    *("it is not shown that this order is maximal", "both orders have 48 elements"),
    *("is not so near a root", "the evidence does not say which rings"),
    *("is too large", "a number in a relation has more than"),
    *("floats are taken only where", "quotients of floats"),
)
# … and what data of rings may be, when all of them have been read.
MEANT_OF_RINGS = (
    *("is not taken apart here", "is not a prime number", "is too large to be proved prime"),
    *(
        "the degree is from 1 to 40",
        "are not parted here",
        "are not found here",
        "should be a prime is reducible",
    ),
    *(
        "the real place number 0 is not known",
        "functions are over QQ, a number field or a finite field",
    ),
)


def is_meant(name: str, reason: str) -> bool:
    """Tell whether a file of that name may be rejected for that reason."""
    if name.startswith("file:"):
        return reason == "the evidence has an unknown key 'x'"
    meant = MEANT + MEANT_OF_RINGS * name.startswith("ring")
    return any(text in reason for text in meant)
