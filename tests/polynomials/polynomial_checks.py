"""Random polynomials over nine fields, and what must hold of their roots and linear factors."""

from hfield import QuaternionAlgebra, UndecidedError

ALGEBRAS = {  # division and split ones first, then degenerate and commutative ones
    "QQ": ["(-1,-1|QQ)", "(-1,-3|QQ)", "(1,1|QQ)", "(-1,0|QQ)"],
    "QQ(sqrt(2))": ["(-1,-1|QQ(sqrt(2)))", "(1,sqrt(2)|QQ(sqrt(2)))"],
    "QQ(sqrt(-7))": ["(-1,-1|QQ(sqrt(-7)))", "(1,3|QQ(sqrt(-7)))"],
    "QQ(x)": ["(-1,x|QQ(x))", "(1,x|QQ(x))"],
    "GF(3)": ["(-1,-1|GF(3))", "(1,0|GF(3))", "(0,0|GF(3))"],
    "GF(4)": ["[1,1|GF(4))", "(-1,-1|GF(4))", "[x,0|GF(4))"],
    "GF(9)": ["(-1,-1|GF(9))"],
    "GF(5)(t)": ["(2,t|GF(5)(t))", "(1,t|GF(5)(t))"],
    "GF(2)(t)": ["[1,t|GF(2)(t))", "[0,t|GF(2)(t))", "(t,t+1|GF(2)(t))"],
}
DIVISION = {
    "(-1,-1|QQ)", "(-1,-3|QQ)", "(-1,-1|QQ(sqrt(2)))", "(-1,-1|QQ(sqrt(-7)))", "(-1,x|QQ(x))",
    "(2,t|GF(5)(t))", "[1,t|GF(2)(t))",
}  # fmt: skip


class Case:
    """An algebra of which elements are drawn; of one with few elements, all of them."""

    def __init__(self, text, rng, most=81):
        self.algebra = A = QuaternionAlgebra.from_text(text)
        self.P, self.rng, self.is_division = A.polynomials("X"), rng, text in DIVISION
        F = A.ring
        gens = [] if F.order or F.name == "QQ" else [F.gen, F.gen + F(1)]
        self.scalars = list(F.elements()) if F.order else [*map(F, range(-2, 3)), F(0), *gens]
        small = F.order is not None and F.order**4 <= most
        self.everything = list(A.elements()) if small else []

    def element(self):
        return self.algebra(*(self.rng.choice(self.scalars) for _ in range(4)))

    def polynomial(self):
        """Return a polynomial that is not 0, the roots that it was given, and whether it is their product."""
        P, kind, given = self.P, self.rng.randrange(3), []
        degree = self.rng.randint(1, 4 if self.everything else 3)
        f = P([1]) if kind < 2 else P([self.element() for _ in range(self.rng.randint(1, 3))])
        for _ in range(degree if kind < 2 else kind == 2):
            q = (
                self.element()
                if kind == 0 or not given
                else self.rng.choice([*given, 1 - given[0]])
            )
            given.append(q)
            f = f * P([-q, 1])
        return (f, given[-1:], kind < 2) if f else self.polynomial()

    def check(self, f, given, is_product):
        """Hold roots and factors of f against the definitions; return whether both were found."""
        try:
            self._check_roots(f, f.roots(), given)
        except UndecidedError as error:
            if "a radical and zero divisors" in str(error):
                return False
            raise
        if not f.coefficients[-1].is_unit():
            return True
        try:
            found = f.linear_factors()
        except UndecidedError:
            assert not self.is_division, f
            return False
        assert found or not is_product, f
        if found:
            c, roots = found
            product = self.P([c])
            for q in roots:
                product = product * self.P([-q, 1])
            assert product == f
        return True

    def _check_roots(self, f, found, given):
        P = self.P

        def is_among(q):
            return (
                q in found.isolated
                or any(m.contains(q) for m in found.families)
                or any(not P([n, -t, 1])(q) for t, n in found.spheres)
            )

        for q in (*found.isolated, *(m.example for m in found.families)):
            assert not f(q), (f, q)
        assert not any(f.divmod_right(P([n, -t, 1]))[1] for t, n in found.spheres), f
        assert all(map(is_among, given)), (f, given)
        assert all(m.contains(m.example) for m in found.families), f
        if self.is_division:  # Gordon and Motzkin: classes, and those of spheres twice
            classes = {(q.trace(), q.norm()) for q in found.isolated}
            assert len(classes) == len(found.isolated)
            assert len(classes) + 2 * len(found.spheres) <= f.degree, f
            assert found.families == ()
        for q in self.everything:
            assert is_among(q) == (not f(q)), (f, q)
