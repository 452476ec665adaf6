"""Recount finite_counts.json in PARI/GP: python3 scripts/vectors/check_counts.py

Needs the Debian package pari-gp; some seconds. The elements are quat.gp's pairs, not matrices;
the centre is the kernel of the commutators with the basis.
"""

from common import HERE, read_cases, run_gp
from rings import RINGS

COUNT = r"""
count(par, F) =
{
  my(a, b, t, m, E, id, norms = 0, nil = 0, idem = 0, plus = 0, minus = 0, unit = 0, rows);
  [a, b, t] = one*par; m = w^2 - t*w - a;
  E = [quat(one*c~, m) | c <- Vec(matid(4))]; id = E[1];
  forvec (n = vector(4, n, [1, #F]),
    my(p = quat([F[k] | k <- n], m), s = mul(p, p, b), nm = scalar(mul(p, conj4(p), b)));
    norms += nm == 0; unit += nm != 0;
    nil += mul(s, s, b) == 0; idem += s == p; plus += s == id; minus += s == -id);
  rows = [concat([coords(mul(c, e, b) - mul(e, c, b)) | e <- E]) | c <- E];
  my(centre = 4 - matrank(Mat([r~ | r <- rows])));
  print([norms, nil, idem, plus, minus, unit, centre]);
}
"""
NAMES = ("norm_zero", "nilpotent", "idempotent", "sqrt_one", "sqrt_minus_one", "unit", "centre_dim")


def elements(q: int, modulus: list[int]) -> str:
    if not modulus:
        return f"[one*n | n <- [0..{q - 1}]]"
    return f"concat([0*one], [x^n | n <- [1..{q - 1}]])"  # a Conway root is primitive


if __name__ == "__main__":
    library = (HERE / "quat.gp").read_text(encoding="utf-8")
    everything = read_cases("finite_counts.json")
    good = 0
    for q in dict.fromkeys(case["q"] for case in everything):
        cases = [case for case in everything if case["q"] == q]
        modulus = cases[0].get("modulus", [])
        ring = next((ring.gp for ring in RINGS if ring.name == f"GF({q})"), f"one = Mod(1, {q})")
        calls = [f"count([{case['a']},{case['b']},{case['t']}], F);" for case in cases]
        lines = run_gp("\n".join([library, ring, COUNT, f"F = {elements(q, modulus)};", *calls]))
        for case, line in zip(cases, lines, strict=True):
            same = str([case[name] for name in NAMES]) == line
            same = same and case["commutative"] == (case["centre_dim"] == 4)
            good += same
            if not same:
                print("DISAGREES", line, case)
    print(f"recounted: {good} of {len(everything)} agree")
