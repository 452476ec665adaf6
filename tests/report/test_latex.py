"""LaTeX: ASCII, balanced, in the field's signs; and it compiles where there is pdflatex."""

import re
import shutil
import subprocess
from pathlib import Path
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

import hfield
from hfield.cli import main
from hfield.latex import document, words
from hfield.ledger.claim import UNIVERSAL
from hfield.ledger.paper import decision
from hfield.ledger.registry import claims
from hfield.prover.prove import prove
from hfield.report.paper import paper
from tests.patience import PATIENCE
from tests.subcases import subcases

PDFLATEX = shutil.which("pdflatex")
SIGNS = "pqλθψ²³⁻¹₀₁·−√≠⇒∈‖°…“”—żółćę{}$&%#_^~\\<>|\"'`()[]*=+-/.,;: aAIGF(9)QQ\u0304\u20d7中é✓ℚ"


@subcases(
    ("text", "latex"),
    [
        ("q = 1 + i over GF(2)", r"$q = 1 + i$ over $\mathbb{F}_{2}$"),
        ("p[0]**2 == h1·q₁", r"$p_{0}^{2} = h_{1}\cdot q_{1}$"),
        ("q̄ ≠ v⃗", r"$\overline{q} \neq \vec{v}$"),
        ("q₁̄ = q̄̄₁", r"$\overline{q_{1}} = \overline{\overline{q}}_{1}$"),
        ("(p·q)̄ = q̄·p̄", r"$\overline{p\cdot q} = \overline{q}\cdot \overline{p}$"),
        ("√N(q) = √(q·q̄)", r"$\sqrt{N(q)} = \sqrt{q\cdot \overline{q}}$"),
        ("2√3 + √−1", r"$2\sqrt{3} + \sqrt{-1}$"),
        ("√(1 + √(2)) = sqrt(norm(q))", r"$\sqrt{1 + \sqrt{2}} = \sqrt{\operatorname{norm}(q)}$"),
        ("f̃(aₘ) = f(aᵢ)", r"$\tilde{f}(a_{m}) = f(a_{i})$"),
        (
            "conj(q1+q2)=conj q1+conj q2",
            r"$\overline{q_{1}+q_{2}}=\overline{q_{1}}+\overline{q_{2}}$",
        ),
        ("conj conj q = q", r"$\overline{\overline{q}} = q$"),
        (
            "conj(q1q2)=conj q₂ conj q₁",
            r"$\overline{q_{1}q_{2}}=\overline{q_{2}} \overline{q_{1}}$",
        ),
        ("a rule of 4 cases", "a rule of 4 cases"),
        ("100% of #1_a & so", r"100\% of \#1\_a \& so"),
        ("zażółć gęślą", r"za\.{z}\'{o}\l{}\'{c} g\k{e}\'{s}l\k{a}"),
        ("(where p ∈ RR)", r"(where $p \in \mathbb{R}$)"),
        ("basis e, i, j, k and ij = k", "basis $e, i, j, k$ and $ij = k$"),
        ("obroty i animacje z roku", "obroty i animacje z roku"),
        ("if q ≠ 0, 1 lies there", r"if $q \neq 0$, 1 lies there"),
        ("x → ∞.", r"$x \to \infty$."),
        ("the index i_1 of {e_{i_1}}_{i=1}^k", r"the index $i_{1}$ of $\{e_{i_{1}}\}_{i=1}^{k}$"),
        ("Σ_{i=1}^n α_i g(e_{i_{m+1}})", r"$\Sigma _{i=1}^{n} \alpha _{i} g(e_{i_{m+1}})$"),
    ],
)
def test_words(text, latex):
    assert words(text) == latex


def balanced(latex):
    bare = re.sub(r"\\[\\{}$]", "", latex)
    return bare.count("{") == bare.count("}") and bare.count("$") % 2 == 0


@given(st.text(st.sampled_from(SIGNS), max_size=30))
def test_any_text_is_ascii_and_balanced(text):
    latex = words(text)
    assert latex.isascii()
    assert balanced(latex)


def test_every_sign_in_the_ledgers_is_set() -> None:
    texts = [
        text
        for path in Path(hfield.__file__).parents[1].glob("*/ledger/**/*.toml")
        for text in re.findall(r'"((?:[^"\\]|\\.)*)"', path.read_text(encoding="utf-8"))
    ]
    assert len(texts) > 2900
    written = [words(text) for text in texts]
    assert [w for w in written if "U+" in w or r"\surd" in w or r"\sqrt{N}" in w] == []


def test_a_decision_has_verdict_scope_steps_and_witness():
    answer = prove("p*q == q*p")
    latex = decision(answer.text, answer.decision, UNIVERSAL, answer.setting.algebra)
    for part in (
        r"\[ p \cdot q = q \cdot p \]",
        r"\textbf{Refuted}",
        "holds exactly in characteristic 2",
        r"$p = i, q = j$ over $\mathbb{Q}$; there",
        r"\begin{enumerate}",
        r"$(-1,-1|F)$",
    ):
        assert part in latex
    assert latex.isascii()


FORMATS = [
    ["prove", "norm(q) == 0 => q == 0", "--field", "QQ(sqrt(-7))"],
    ["explain", "theorem-1"],
    ["info", "(-1,-3|QQ)"],
    ["info", "[1,t|GF(4)(t))"],
    ["count", "--field", "GF9"],
    ["claims", "--section", "1.3.1"],
    ["verify", "--section", "1.3.1", "--field", "QQ,GF9"],
]


@pytest.mark.parametrize("line", FORMATS, ids=lambda line: line[0])
def test_the_commands_write_latex(line, capsys):
    main([*line, "--format", "latex"])
    piece = capsys.readouterr().out
    main([*line, "--format", "latex", "--standalone"])
    whole = capsys.readouterr().out
    assert piece.isascii()
    assert balanced(piece)
    assert not re.search(r"\b(QQ|GF\()", piece)
    assert piece.strip() in whole
    assert whole.startswith(r"\documentclass")


@pytest.mark.skipif(PDFLATEX is None, reason="pdflatex is not installed")
def test_it_compiles(rows, tmp_path, capsys):
    parts = [words(text) for c in claims() for text in (c.statement, c.printed, c.note) if text]
    rng = Random(0)
    parts += [words("".join(rng.choices(SIGNS, k=20))) for _ in range(500)]
    parts += [words(SIGNS), words(" ".join(SIGNS))]
    for line in FORMATS:
        main([*line, "--format", "latex"])
        parts.append(capsys.readouterr().out)
    texts = {"a": document("\n\n".join(parts), "All ⊕ sorts"), "b": paper(rows, "pl", "sheet_1")}
    for name, text in texts.items():
        (tmp_path / f"{name}.tex").write_text(text, encoding="ascii")
        done = subprocess.run(
            [PDFLATEX, "-interaction=nonstopmode", "-halt-on-error", f"{name}.tex"],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=PATIENCE,
        )
        assert done.returncode == 0, done.stdout[-1500:]
        assert (tmp_path / f"{name}.pdf").stat().st_size > 10_000
