"""Lemmas that prove relations between closed statements over all fields at once."""

# H(F) is a division algebra if F is formally real: an element of norm 0 with a nonzero coordinate
# makes −1 a sum of three squares.
THREE_SQUARES = tuple(
    f"norm(q) == 0 and q[{n}] != 0 => "
    + " + ".join(f"(q[{m}]/q[{n}])**2" for m in range(4) if m != n)
    + " == -1"
    for n in range(4)
)
# … and exactly if −1 is not a sum of two squares. If s² + y² = −1 (y = 0 included), e + s·i + y·j
# is a nonzero element of norm 0. Conversely let N(q) = 0 with q ≠ 0. If q₂² + q₃² ≠ 0, the third
# line writes −1 as a sum of two squares. Otherwise, if q₂ or q₃ is not 0, the fourth or fifth line
# does. If both are 0, then q₀ or q₁ is not 0, and the last two lines do.
TWO_SQUARES = (
    "s**2 + y**2 == -1 => norm(e + s*i + y*j) == 0",
    "s**2 == -1 => norm(e + s*i) == 0",
    "norm(q) == 0 and q[2]**2 + q[3]**2 != 0 => "
    "((q[0]*q[2] + q[1]*q[3])/(q[2]**2 + q[3]**2))**2"
    " + ((q[0]*q[3] - q[1]*q[2])/(q[2]**2 + q[3]**2))**2 == -1",
    "q[2]**2 + q[3]**2 == 0 and q[3] != 0 => (q[2]/q[3])**2 == -1",
    "q[2]**2 + q[3]**2 == 0 and q[2] != 0 => (q[3]/q[2])**2 == -1",
    "norm(q) == 0 and q[2] == 0 and q[3] == 0 and q[1] != 0 => (q[0]/q[1])**2 == -1",
    "norm(q) == 0 and q[2] == 0 and q[3] == 0 and q[0] != 0 => (q[1]/q[0])**2 == -1",
)
LEMMAS = {
    "implies{formally-real; division}": THREE_SQUARES,
    "implies{division; level-above{2}}": TWO_SQUARES,
    "iff{division; level-above{2}}": TWO_SQUARES,
    # The product commutes in characteristic 2; and if it does, i and j do, which takes 2 = 0.
    "iff{p*q == q*p; 2 == 0}": ("2 == 0 => p*q == q*p", "i*j == j*i => 2 == 0"),
    "implies{2 == 0; exists q: q != 0 and norm(q) == 0}": (
        "2 == 0 => norm(e + i) == 0",
        "e + i != 0",
    ),
}
