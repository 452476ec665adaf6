"""Random matrices, compared with the regular representation over the prime field, by flint."""

import flint

from hfield import NotInvertibleError, QuaternionAlgebra, UndecidedError, ring

ALGEBRAS = [
    "(-1,-1|QQ)", "(1,1|QQ)", "(0,-1|QQ)", "(0,0|QQ)", "(-1,-1|GF(7))", "(0,3|GF(7))", "(-1,-1|GF(9))",
    "(-1,0|GF(9))", "(-1,-1|QQ(sqrt(-7)))", "(1,0|QQ(sqrt(-7)))", "(-1,x|QQ(x))", "(0,x|QQ(x))",
    "(-1,-1|GF(2))", "[1,1|GF(4))", "[0,0|GF(4))", "[1,t|GF(2)(t))", "(t,t|GF(2)(t))",
]  # fmt: skip


class Case:
    """An algebra, entries for matrices over it, and its regular representation over a prime field."""

    def __init__(self, text, rng):
        self.algebra, self.rng = QuaternionAlgebra.from_text(text), rng
        self.field = F = self.algebra.ring
        gens = [] if F.name in ("QQ", "GF(7)", "GF(2)") else [F.gen, F.gen + F(1)]
        self.scalars = [F(n) for n in (0, 0, 1, -1, 2, 3)] + gens
        self.is_division = text in (
            "(-1,-1|QQ)",
            "(-1,-1|QQ(sqrt(-7)))",
            "(-1,x|QQ(x))",
            "[1,t|GF(2)(t))",
        )

    def matrix(self, m, n):
        A = self.algebra
        entry = lambda: A(*(self.rng.choice(self.scalars) for _ in range(4)))  # noqa: E731
        return A.matrix([[entry() for _ in range(n)] for _ in range(m)])

    def block(self, x):
        """Return multiplication by a scalar over the prime field; variables are given values."""
        F = self.field
        if F.name in ("QQ", "GF(7)", "GF(2)"):
            return [[x]]
        if F.name == "QQ(x)":
            return [[ring("QQ").parse(F.text(x).replace("x", "(10007/3)"))]]
        if F.name == "QQ(sqrt(-7))":
            a, b = F.coefficients_of(x)
            return [[a, -7 * b], [b, a]]
        if F.name == "GF(2)(t)":
            F = ring("GF(2^13)")
            x = F.parse(self.field.text(x).replace("t", "x"))
        columns = [[int(c) for c in (x * F.gen**n).to_list()] for n in range(F.degree)]
        return [list(row) for row in zip(*columns, strict=True)]

    def regular(self, rows):
        """Return x ↦ M·x on coordinates over the prime field, and by how much that is larger than over F."""
        table, flat = self.algebra.basis, []
        for row in rows:
            images = [[(q * u).coordinates for u in table] for q in row]
            for c in range(4):
                blocks = [self.block(image[c]) for entry in images for image in entry]
                flat += [[x for block in blocks for x in block[r]] for r in range(len(blocks[0]))]
        degree = len(flat) // (4 * len(rows))
        p = self.field.characteristic
        made = (
            flint.nmod_mat([[int(x) for x in row] for row in flat], p)
            if p
            else flint.fmpq_mat(flat)
        )
        return made, degree

    def rank(self, rows):
        """Return four times the rank over A."""
        made, degree = self.regular(rows)
        return made.rank() // degree

    def check(self, n):
        """Hold a matrix of n rows, sometimes one of small rank or not square, against its representation."""
        A, rng = self.algebra, self.rng
        M = self.matrix(n, rng.choice((n, n, n + 1, max(n - 1, 1))))
        if rng.random() < 0.5:
            M = M @ self.matrix(M.shape[1], max(n // 2, 1)) @ self.matrix(max(n // 2, 1), n)
        m, width = M.shape
        rank = self.rank(M.rows)
        assert 4 * M.rank() == rank
        right, left = M.right_kernel(), M.left_kernel()
        for x in right:
            assert M @ A.matrix([[q] for q in x]) == A.matrix([[0]] * m)
        for y in left:
            assert A.matrix([y]) @ M == A.matrix([[0] * width])
        assert (self.rank(A.matrix(right).T.rows) if right else 0) == 4 * width - rank
        # of rows, x ↦ x·M is of the same rank as its transpose under conjugation
        adjoint = A.matrix(left).conjugate_transpose().rows if left else None
        assert (self.rank(adjoint) if adjoint else 0) == 4 * m - self.rank(
            M.conjugate_transpose().rows
        )
        if self.is_division:
            assert (len(right), len(left)) == (width - M.rank(), m - M.rank())
        try:
            E, T, pivots = M.echelon_form()
            assert T @ M == E
            assert T.is_invertible()
            assert all(E[r, c] == (r == k) for k, c in enumerate(pivots) for r in range(m))
            assert not any(q for row in E.rows[len(pivots) :] for q in row)
        except UndecidedError:
            assert not self.is_division
        b = M @ self.matrix(width, 1)
        assert M @ M.solve(b) == b
        if m == width:
            self._check_square(M, rank)

    def _check_square(self, M, rank):
        n, F = M.shape[0], self.field
        N = self.matrix(n, n)
        norm = M.reduced_norm()
        assert F.equal((M @ N).reduced_norm(), norm * N.reduced_norm())
        assert M.is_invertible() == (rank == 4 * n)
        if M.is_invertible():
            assert M @ M.inverse() == M**0 == M.inverse() @ M
        else:
            try:
                M.inverse()
            except NotInvertibleError:
                return
            raise AssertionError(f"{M} has no inverse")
