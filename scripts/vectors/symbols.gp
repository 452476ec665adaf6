\\ Hilbert symbols and ramification, for make_symbols.py. Each printed line is one case, in JSON.

quote(z) = Str("\"", strjoin(strsplit(Str(z), " "), ""), "\"");
bool(z) = if (z, "true", "false");

\\ p = 0 is the real place.
symbol(a, b, p) =
{
  strprintf("{\"a\":%s,\"b\":%s,\"place\":%s,\"value\":%d}",
    quote(a), quote(b), if (p, Str(p), "\"inf\""), hilbert(a, b, p));
}

primes_of(a, b) = factor(abs(2*numerator(a)*denominator(a)*numerator(b)*denominator(b)))[, 1]~;

symbols(a, b) = { print(symbol(a, b, 0)); foreach (primes_of(a, b), p, print(symbol(a, b, p))) };
\\ at the first prime p >= n, with p^e and p^f put into a and b
near(a, e, b, f, n) = { my(p = nextprime(n)); print(symbol(a*p^e, b*p^f, p)) };

Q = nfinit(y);

\\ Three routes: symbols at every bad place; alginit (which wants no square a); a rational point.
ramification(a, b) =
{
  my(bad = [p | p <- primes_of(a, b), hilbert(a, b, p) < 0], inf = hilbert(a, b, 0) < 0, division);
  division = #bad + inf > 0;
  if (!issquare(a),
    my(al = algramifiedplaces(alginit(Q, [a, b])));
    if (Set([p.p | p <- al, type(p) != "t_INT"]) != Set(bad), error("alginit"));
    if (sum(n = 1, #al, type(al[n]) == "t_INT") != inf, error("alginit at infinity")));
  if ((type(qfsolve(matdiagonal([a, b, -1]))) != "t_COL") != division, error("qfsolve"));
  my(all = concat(apply(p -> Str(p), bad), if (inf, ["\"inf\""], [])));
  printf("{\"a\":%d,\"b\":%d,\"ramified\":[%s],\"discriminant\":%d,\"division\":%s}\n",
    a, b, strjoin(all, ","), vecprod(bad), bool(division));
}

\\ a = [u, v] is u + v*sqrt(d), and so is b; with norm = 1 a norm from K(sqrt(a)) replaces b.
root_text(d) = if (d == -1, "I", Str("sqrt(", d, ")"));
text(c, d) =
{
  my(v = if (c[2] == 1, "", c[2] == -1, "-", Str(c[2], "*")));
  quote(if (c[2] == 0, Str(c[1]), Str(if (c[1], c[1], ""), if (c[1] && c[2] > 0, "+", ""), v,
    root_text(d))));
}
pair(z) = [polcoef(lift(z), 0), polcoef(lift(z), 1)];

\\ Three routes: the global symbol; is b a norm from K(sqrt(a)); alginit. The last two want a and b
\\ integral (squares clear denominators; rnfisnorm of PARI 2.15 fails on others) and a no square.
integral(z) = z*denominator(content(pair(z)))^2;
quadratic(d, a, b, norm = 0) =
{
  my(B = bnfinit(y^2 - d, 1), s = Mod(y, B.pol), al = a[1] + a[2]*s, be = b[1] + b[2]*s, ai, bi);
  if (norm, be = be^2 - al*(1 + b[2]*s)^2);
  if (al == 0 || be == 0, return);
  my(division = nfhilbert(B, al, be) < 0);
  ai = integral(al); bi = integral(be);
  if (nfeltispower(B, al, 2),
    if (division, error("square")),
    if ((rnfisnorm(rnfisnorminit(B, x^2 - lift(ai), 1), bi)[2] != 1) != division, error("norm"));
    if (algisdivision(alginit(B.nf, [ai, bi])) != division, error("algisdivision")));
  printf("{\"ring\":\"QQ(%s)\",\"d\":%d,\"a\":%s,\"b\":%s,\"division\":%s}\n",
    root_text(d), d, text(pair(al), d), text(pair(be), d), bool(division));
}
