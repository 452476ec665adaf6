# [a, b, t] in GAP as block matrices, for check_products_gap.py and make_counts.py.
# C is the companion matrix of w^2 - t*w - a; i = diag(C, t - C), j = [[0, b], [1, 0]].
# e, i, j and i*j are linearly independent over any commutative ring, whatever a, b and t are.

Model := function(a, b, t, one)
  local o, id, C, blocks, mi, mj;
  o := 0*one; id := [[one, o], [o, one]];
  C := [[o, a], [one, t]];
  blocks := function(m)
    local r, n;
    r := List([1..4], x -> List([1..4], y -> o));
    for n in [0..3] do
      r{[1, 2] + 2*QuoInt(n, 2)}{[1, 2] + 2*(n mod 2)} := m[n + 1];
    od;
    return r;
  end;
  mi := blocks([C, 0*C, 0*C, t*id - C]);
  mj := blocks([0*C, b*id, id, 0*C]);
  return [blocks([id, 0*C, 0*C, id]), mi, mj, mi*mj];
end;

Combine := function(basis, c)
  return c[1]*basis[1] + c[2]*basis[2] + c[3]*basis[3] + c[4]*basis[4];
end;

# One case of products.json; one, F (a field or fail) and IsUnitDet are set by the caller.
Check := function(a, b, t, pc, qc, r, n, tr, cj, inv)
  local B, p, q, bar, d, ok, A, el, builtin, inverse;
  B := Model(a, b, t, one);
  p := Combine(B, pc); q := Combine(B, qc); bar := Combine(B, cj);
  d := DeterminantMatDivFree(p);
  ok := p*q = Combine(B, r) and p*bar = n*B[1] and p + bar = tr*B[1]
    and d = n*n and TraceMat(p) = tr + tr;
  if inv = fail then
    ok := ok and not IsUnitDet(d);
  else
    ok := ok and IsUnitDet(d) and p*Combine(B, inv) = B[1] and Combine(B, inv)*p = B[1];
  fi;
  builtin := "none";
  if F <> fail and t = 0*t then
    A := QuaternionAlgebra(F, a, b);
    el := c -> ObjByExtRep(FamilyObj(One(A)), c);
    builtin := el(pc)*el(qc) = el(r);
    if a <> 0*a and b <> 0*b and inv <> fail then
      inverse := Inverse(el(pc));
      builtin := builtin and inverse = el(inv);
    fi;
  fi;
  Print(ok, " ", builtin, "\n");
end;
