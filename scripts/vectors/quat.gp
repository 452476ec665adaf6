\\ [a, b, t] as pairs over L = R[w]/(w^2 - t*w - a), for make_products.py and check_counts.py.
\\ A quaternion is u + v*j with u = q0 + q1*w, v = q2 + q3*w in L, and j*u = bar(u)*j, j^2 = b.
\\ PARI multiplies in L itself (t_POLMOD); no structure constant of the algebra is written down.
\\ The caller sets one (the unit of R), show(z) (its text) and isunit(n) before the first case.

w = varhigher("w");

bar(u) = trace(u) - u;
quat(c, m) = [Mod(c[1] + c[2]*w, m), Mod(c[3] + c[4]*w, m)];
mul(p, q, b) = [p[1]*q[1] + b*p[2]*bar(q[2]), p[1]*q[2] + p[2]*bar(q[1])];
conj4(p) = [bar(p[1]), -p[2]];
co(u, n) = one*polcoef(u.pol, n, w);
coords(p) = [co(p[1], 0), co(p[1], 1), co(p[2], 0), co(p[2], 1)];
scalar(p) = { my(c = coords(p)); if (c[2] || c[3] || c[4], error("not a scalar: ", c)); c[1] };

tab(v) = { my(s = show(v[1])); for (n = 2, #v, s = Str(s, "\t", show(v[n]))); s };

case(par, pc, qc) =
{
  my(a, b, t, m, p, q, r, n, tr, cj, inv);
  [a, b, t] = one*par; pc = one*pc; qc = one*qc;
  m = w^2 - t*w - a;
  p = quat(pc, m); q = quat(qc, m); cj = conj4(p);
  r = coords(mul(p, q, b));
  n = scalar(mul(p, cj, b));
  tr = scalar(p + cj);
  inv = "null";
  if (isunit(n),
    my(c = coords(cj)/n);
    if (scalar(mul(p, quat(c, m), b)) != one, error("inverse"));
    inv = tab(c));
  print(tab(concat([[a, b, t], pc, qc, r, [n, tr], coords(cj)])), "\t", inv);
}
