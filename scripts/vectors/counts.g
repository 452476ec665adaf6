# Print a line of counts for each small algebra, for make_counts.py; quat.g is read before this.

Count := function(q, par)
  local a, b, t, B, N, A, v, m, s, null, nil, idem, plus, minus, units, coeffs;
  a := par[1]; b := par[2]; t := par[3];
  B := Model(a, b, t, One(GF(q))); N := B[1];
  null := 0; nil := 0; idem := 0; plus := 0; minus := 0; units := 0;
  for v in GF(q)^4 do
    m := Combine(B, v);
    s := m*m;
    if IsZero(Determinant(m)) then null := null + 1; fi;  # the determinant is the norm's square
    if IsZero(s*s) then nil := nil + 1; fi;
    if s = m then idem := idem + 1; fi;
    if s = N then plus := plus + 1; fi;
    if s = -N then minus := minus + 1; fi;
    if Inverse(m) <> fail then units := units + 1; fi;
  od;
  A := AlgebraWithOne(GF(q), [B[2], B[3]]);
  if Dimension(A) <> 4 then Error("the model has lost a dimension"); fi;
  coeffs := List(par, z -> List(Coefficients(CanonicalBasis(GF(q)), z), IntFFE));
  Print([q, coeffs, null, nil, idem, plus, minus, units,
    Dimension(Centre(A)), IsCommutative(A)], "\n");
end;

for q in [2, 3, 4, 5, 7, 8, 9] do
  o := Z(q)^0; n := 0*o; g := Z(q);
  for par in Set([
      [-o, -o, n], [o, o, n], [g, o, n], [g, g, n], [o, g, n], [n, o, n], [n, g, n], [o, n, n],
      [g, n, n], [n, n, n], [o, o, o], [n, o, o], [n, g, o], [g, o, o], [g, g, o], [-o, g, o],
      [o, n, o], [g, n, o], [n, n, o], [g^2, g, g], [-o, -o, g], [n, n, g]]) do
    Count(q, par);
  od;
od;
