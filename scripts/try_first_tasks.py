"""Try sixty first tasks of a student, a number theorist and an engineer, typed as they would be.

    python scripts/try_first_tasks.py [--show]

A line that begins with ``hfield`` is a command, any other is Python after ``from hfield import *``. Beside it
is a part of its answer, known from elsewhere. ``--show`` prints what came. Exit status 1 where another answer
came, or an error of Python's own.
"""

import argparse
import io
import shlex
import statistics
import tempfile
from contextlib import chdir, redirect_stderr, redirect_stdout

import numpy

import hfield
import rotation
from hfield.cli import main as command

STUDENT = [
    ("hfield prove 'i^2 = j^2 = k^2 = ijk = -1'", "proved"),
    ("hfield prove 'pq = qp'", "refuted"),
    ("hfield prove 'pq = qp' GF2", "proved"),
    ("hfield eval '(1+2i)(3+j)'", "3 + 6*i + j + 2*k"),
    ("hfield eval '(0,1,0,0)(0,0,1,0)'", "k"),
    (r"hfield prove '\overline{pq} = \overline{q}\,\overline{p}'", "proved"),
    ("hfield prove 'N(pq) = N(p)N(q)'", "proved"),
    ("hfield prove 'tr (p) = p + p̄'", "proved"),
    ("hfield prove 'q ≠ 0 => q q^{-1} = 1' --field ℚ", "proved"),
    ("hfield prove 'pq = 0 => p = 0 or q = 0' -f GF3", "refuted"),
    ("hfield eval '(1+i)⁻¹'", "1/2 - 1/2*i"),
    ("hfield table GF3", "k"),
    ("hfield info ℍ", "division algebra yes"),
    ("hfield info 'H(GF(7))'", "isomorphic to M₂(GF(7))"),
    ("hfield info '(a,b|F)'", "a·e"),
    ("hfield roots 'x^2+1' GF7", "trace 0 and norm 1"),
    ("hfield count GF3", "81"),
    ("hfield four-squares 2026", "2026"),
    ("H(QQ)(1, 2, 3, 4).inverse()", "1/30 - 1/15*i - 1/10*j - 2/15*k"),
    ("H(GF(7))([1, 2, 3, 0]).is_zero_divisor()", "True"),
]
NUMBER_THEORIST = [
    ("hfield eval 'hilbert(2,5,5)'", "-1"),
    ("hfield eval 'hilbert(-1,-1,2)' --field 'QQ(sqrt(5))'", "1"),
    ("hfield info 11", "11"),
    ("hfield order 2 --units", "SL(2,3)"),
    ("hfield classes 11", "class number   2"),
    ("hfield brandt 11 --prime 2", "1 2"),
    ("hfield newforms 11", "a_2 = -2, a_3 = -1, a_5 = 1, a_7 = -2"),
    ("hfield embed 6 -24 --all", "orbits           4"),
    ("hfield domain 6", "6"),
    ("hfield field 'QQ(sqrt(-23))'", "ℤ/3"),
    ("hfield field 'QQ(zeta21)'", "trivial"),
    ("hfield field 'QQ[s]/(s^7-7)'", "trivial"),
    ("hfield survey 2..20", '"mass": "1/12"'),
    ("hfield roots 'x^2+1' --field GF3 --list", "2*j"),
    ("QuaternionAlgebra(11).maximal_order().class_set().brandt_matrix(2)", "[[1, 2], [3, 0]]"),
    ("QuaternionAlgebra(QQ, -1, -3).ramified_places()", "(3, 'inf')"),
    ("hilbert_symbol(-1, -1, 'inf')", "-1"),
    ("ring('QQ(sqrt(-5))').class_group().invariants", "2"),
    ("QuaternionAlgebra(11).is_ramified_at(11)", "write p in ramified_places()"),
    ("hfield.BrandtModule(11)", "write O.class_set()"),
]
ENGINEER = [
    ("hfield render top.mp4", "write hfield render -o top.mp4"),
    ("Rotation.from_euler('Z', 90, degrees=True).apply([1, 2, 3]).round(12)", "[-2.,  1.,  3.]"),
    ("Rotation.from_quat([1, 0, 0, 0]).as_matrix()", "[1., 0., 0.]"),
    ("Rotation.random(3, random_state=1)", "write seed=1"),
    ("len(Rotation.random(3, seed=1))", "3"),
    ("Rotation.random() * RigidTransform.identity()", "RigidTransform"),
    ("rotation.compat.Rotation.from_quat([0, 0, 0, 1]).magnitude()", "0.0"),
    ("Rotation.from_rotvec([0, 0, 1]).as_rotvec()", "1."),
    ("Rotation.from_matrix(numpy.eye(3)).as_euler('xyz')", "0."),
    ("Rotation.identity().inv().magnitude()", "0.0"),
    ("rotation.rotate(numpy.ones((5, 3)), [0, 0, 1], 0.5).shape", "(5, 3)"),
    (
        "Slerp([0, 1], Rotation.from_rotvec([[0, 0, 0], [0, 0, 1]]))(0.5).as_rotvec().round(3)",
        "0.5",
    ),
    ("Rotation.align_vectors([[0, 1, 0]], [[1, 0, 0]])[0].as_euler('zyx', degrees=True)", "90."),
    ("Rotation.random(10, seed=1).mean().as_quat().shape", "(4,)"),
    ("RigidTransform.from_translation([1, 2, 3]).apply([0, 0, 0])", "[1., 2., 3.]"),
    ("H('RDF')(0.5, 0.5, 0.5, 0.5).norm()", "1.0"),
    ("statistics.mean([H(QQ)(1, 2, 3, 4).norm(), H(QQ)(1).norm()])", "31/2"),
    ("H(GF(7)).from_array(numpy.arange(4)[:, None]).norm()", "0"),
    ("H(GF(7)).from_array([[0, 1, 2, 3], [1, 0, 0, 0]], axis=-1).shape", "(2,)"),
    ("H(GF(7))(numpy.arange(8).reshape(2, 4))", "from_array"),
]


def answer(line: str) -> tuple[str, str]:
    """Return what came, and the name of an error that is not ours, or nothing."""
    if line.startswith("hfield "):
        out = io.StringIO()
        with redirect_stdout(out), redirect_stderr(out):
            status = command(shlex.split(line)[1:])
        return out.getvalue(), "" if status in (0, 1, 2, 3) else f"status {status}"
    names = {name: getattr(p, name) for p in (hfield, rotation) for name in p.__all__}
    names |= {"hfield": hfield, "rotation": rotation, "numpy": numpy, "statistics": statistics}
    try:
        return repr(eval(line, names)), ""
    except (hfield.HFieldError, rotation.RotationError, AttributeError) as error:
        return str(error), ""
    except Exception as error:
        return str(error), type(error).__name__


def main() -> int:
    """Try all and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--show", action="store_true", help="print what came")
    show, wrong = parser.parse_args().show, 0
    tasks = {"student": STUDENT, "number theorist": NUMBER_THEORIST, "engineer": ENGINEER}
    with tempfile.TemporaryDirectory() as folder, chdir(folder):
        for who, lines in tasks.items():
            print(f"{who}: {len(lines)} tasks")
            for line, expected in lines:
                came, foreign = answer(line)
                failed = expected not in came or bool(foreign)
                wrong += failed
                if show or failed:
                    print(f"{'✗' if failed else ' '} {line}  {foreign}")
                    print(*(f"      {row}" for row in came.splitlines()[:8]), sep="\n")
    print(f"{wrong} of {sum(map(len, tasks.values()))} were not answered as expected")
    return int(wrong > 0)


if __name__ == "__main__":
    raise SystemExit(main())
