"""``hfield export --lean``: what is written for Lean 4. scripts/check_lean.sh runs Lean itself."""

import pytest

from hfield.cli.commands import export
from hfield.cli.parser import Parser, UsageError
from hfield.errors import HFieldError
from hfield.export.lean import lean_file, lean_theorem
from hfield.prover.prove import prove


def one(statement, algebra=None):
    return lean_theorem("t", prove(statement, algebra=algebra).certificate)


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        (
            "p*q == q*p + 2*comm(p, q) - comm(p, q) - comm(p, q) + comm(p, q)",
            "qscale 2 (qsub (qmul",
        ),
        ("norm(p*q) == norm(p)*norm(q)", "((norm (-1) 0 (-1) (qmul (-1) 0 (-1) p q)) : R)"),
        ("2 == 0 => p*q == q*p", "((2 : R) = 0) →\n"),
        ("s*q == q*s", "(qscale s q) : Quaternion R) = (qscale s q)"),
        ("q[3] == -conj(q)[3]", "((q).km : R) = (-((conj 0 q)).km)"),
        ("s + q == q + s", "(qadd (embed s) q)"),
        ("p == q or p == -q => p*p == q*q", " ∨ "),
    ],
)
def test_statements(statement, said):
    text = str(one(statement))
    assert said in text
    assert text.endswith(":= by\n  coordinates")


def test_other_algebras():
    assert "qmul a 1 b" in one("(p*q)*r == p*(q*r)", "[a,b|F)").text
    assert "(p q r : Quaternion R) (a b : R)" in one("(p*q)*r == p*(q*r)", "[a,b|F)").text


@pytest.mark.parametrize(
    ("statement", "field", "reason"),
    [
        ("p*q == q*p", None, "what is proved"),
        ("p*q == q*p", "GF(2)", "for all fields"),
        ("norm(q) != 0 => q*inv(q) == e", None, "joined by and, or"),
        ("s*y == 0 => s == 0 or y == 0", None, "needs a field"),
        ("exists q: q*q == -1", None, "identities and implications"),
        ("(((q**3)**3)*p)*r == ((q**3)**3)*(p*r)", None, "leaves"),
    ],
)
def test_what_is_left_out_says_why(statement, field, reason):
    with pytest.raises(HFieldError, match=reason):
        lean_theorem("t", prove(statement, field).certificate)


def test_the_command(capsys, tmp_path):
    def run(*words):
        parser = Parser("hfield export", export.HELP)
        export.configure(parser)
        return export.run(parser.read(words))

    file = tmp_path / "out.lean"
    words = ("--lean", str(file), "--statement", "e*q == q", "--statement", "p*q == q*p")
    assert run(*words) == 1
    assert "1 theorem exported, 1 not exported" in capsys.readouterr().out
    assert file.read_text(encoding="utf-8") == lean_file(
        [lean_theorem("statement_1", prove("e*q == q").certificate)]
    )
    for words in (("--lean", "x"), ("--lean", "x", "--coq", "y", "--statement", "e*q == q")):
        with pytest.raises(UsageError):
            run(*words)
