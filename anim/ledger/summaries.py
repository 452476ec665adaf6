"""The summary of chapter 3, numbered 3.5 here, and chapter 4."""

from anim.ledger.counting import model_has
from rotation.ledger.programs import claim

CLAIMS = (
    claim(
        "C3.5-a",
        "points-in-the-summary",
        "number",
        "2001 points",
        "2001 punktów",
        model_has(2001, "points"),
        spoilt=model_has(2002, "points"),
        corrected=model_has(2002, "points"),
        note="2002 in 3.3: 1000 from each circle, the tip and the apex.",
    ),
    claim(
        "C3.5-b",
        "time-of-a-rotation",
        "number",
        "rotation of 2001 points takes ≈1.3 s (matrix), 1.5 s (quaternion)",
        "1.3 / 1.5 s",
        note="Timings of a machine that is not named.",
    ),
    claim(
        "C3.5-c",
        "time-of-a-frame",
        "number",
        "one frame takes about 0.5 s; up to 10 s",
        "0.5 s, 10 s",
        note="Timings of a machine that is not named.",
    ),
    claim(
        "C3.5-d",
        "cost-of-a-matrix",
        "claim",
        "generating a rotation matrix is very time-consuming",
        "bardzo czasochłonnym",
        note="A timing, and a matter of judgement; `hfield bench` measures it.",
    ),
    claim(
        "C4-a",
        "numbers-of-the-conclusion",
        "claim",
        "synthetic test 550 000 points, final model 6000 polygons",
        "6 tys. wielokątów",
        model_has(6000, "polygons"),
        spoilt=model_has(3000, "polygons"),
        corrected=model_has(3000, "polygons"),
        note="As C3.3-k. The 550 000 points are those of 3.2.",
    ),
    claim(
        "C4-b",
        "century-of-hamilton",
        "claim",
        "quaternions introduced in the 19th century by W. Hamilton",
        "XIX wieku",
        note="History.",
    ),
)
