\\ SPDX-License-Identifier: BSD-3-Clause
\\ All common zeros of two plane curves with their multiplicities, for generate_plane_curves_systems.py.
\\
\\ 1. g = gcd(p, q) is split off; the rest is solved.
\\ 2. The eliminants in x and in y (evaluation, univariate resultants, interpolation) contain the coordinates of every
\\    solution. Their squarefree parts are solved by polroots; polsturm says how many of the roots are real.
\\ 3. A pair of roots is a solution when both curves vanish there, relative to the sum of the absolute values of their
\\    terms, to below 10^-600. A solution is real when both coordinates are.
\\ 4. For u = x + s y with deg_y = total degree for both curves, the order of a root of the resultant in y of
\\    p(u - s y, y), q(u - s y, y) is the sum of the multiplicities of the solutions on the line x + s y = u. As many
\\    solutions as distinct roots: every such line holds one solution, none is missing; otherwise the next s is tried.
default(parisizemax, 2*10^9);
default(realprecision, 720);

integral(p) = {
  my(d = 1);
  for (i = 0, poldegree(p, 'x), my(c = polcoef(p, i, 'x));
    for (j = 0, poldegree(c, 'y), d = lcm(d, denominator(polcoef(c, j, 'y)))));
  p * d };

total_degree(p) = {
  my(d = 0);
  for (i = 0, poldegree(p, 'x), my(c = polcoef(p, i, 'x)); if (c != 0, d = max(d, i + poldegree(c, 'y))));
  d };

\\ Res_v(p, q), a polynomial in w of degree <= bound.
eliminant(p, q, v, w, bound) = {
  my(a = pollead(p, v), b = pollead(q, v), points = List(), values = List(), i = 0);
  if (poldegree(p, v) == 0, return (p^poldegree(q, v)));
  if (poldegree(q, v) == 0, return (q^poldegree(p, v)));
  while (#points <= bound,
    if (subst(a, w, i) != 0 && subst(b, w, i) != 0,
      listput(points, i); listput(values, polresultant(subst(p, w, i), subst(q, w, i), v)));
    i = if (i > 0, -i, 1 - i));
  polinterpolate(Vec(points), Vec(values), w) };

\\ [f_1, f_2, ...], pairwise coprime and squarefree, with f = constant prod f_m^m (Yun).
squarefree_factors(f, w) = {
  my(result = List(), a, b, c, d);
  if (poldegree(f, w) < 1, return ([]));
  f = f / content(f);
  a = gcd(f, deriv(f, w)); b = f / a; d = deriv(f, w) / a - deriv(b, w);
  while (poldegree(b, w) > 0,
    a = gcd(b, d); listput(result, a / content(a));
    b = b / a; c = d / a; d = c - deriv(b, w));
  Vec(result) };

\\ The distinct roots of f in Z[w], and which of them are real.
roots_of(f, w) = {
  my(n, r, reals, order, is_real);
  if (poldegree(f, w) < 1, return ([[], []]));
  f = simplify(subst(f, w, 'z));
  f = f / gcd(f, deriv(f));
  f = f / content(f);
  n = poldegree(f);
  r = polroots(f); reals = polsturm(f);
  order = vecsort(vector(n, i, abs(imag(r[i])) / max(abs(r[i]), 1e-700)), , 1);
  is_real = vector(n);
  for (i = 1, n,
    my(k = order[i], size = abs(imag(r[k])));
    if (i <= reals,
      if (size > 1e-600 * abs(r[k]), error("a real root is missing")); is_real[k] = 1; r[k] = real(r[k]),
      if (size < 1e-300 * abs(r[k]), error("a real root too many"))));
  [r, is_real] };

absolute(f) = { my(v = variable(f)); if (poldegree(f) < 1, abs(f), Pol(apply(abs, Vec(f)), v)) };

\\ Coefficients at (a, y) as a polynomial in y, and the sums of the absolute values of its terms likewise.
at_x(p, a) = subst(p, 'x, a);
sizes_at_x(p, a) = {
  my(f = 0);
  for (i = 0, poldegree(p, 'x), my(c = polcoef(p, i, 'x));
    for (j = 0, poldegree(c, 'y), f += abs(polcoef(c, j, 'y)) * abs(a)^i * 'y^j));
  f };
small(f, sizes, b, bound) = abs(subst(f, 'y, b)) <= bound * subst(sizes, 'y, abs(b));

\\ All [x, y, real] with p = q = 0.
solutions(p, q, bound) = {
  my(xs, ys, found = List(), y_low);
  xs = roots_of(eliminant(p, q, 'y, 'x, bound), 'x);
  ys = roots_of(eliminant(p, q, 'x, 'y, bound), 'y);
  y_low = precision(ys[1], 77);
  for (i = 1, #xs[1],
    my(a = xs[1][i], a_low = precision(a, 77), f = at_x(p, a_low), g = at_x(q, a_low),
       f_sizes = sizes_at_x(p, a_low), g_sizes = sizes_at_x(q, a_low), fine = 0);
    for (j = 1, #ys[1],
      if (small(f, f_sizes, y_low[j], 1e-25) && small(g, g_sizes, y_low[j], 1e-25),
        my(b = ys[1][j]);
        if (!fine, fine = [at_x(p, a), at_x(q, a), sizes_at_x(p, a), sizes_at_x(q, a)]);
        if (small(fine[1], fine[3], b, 1e-600) && small(fine[2], fine[4], b, 1e-600),
          listput(found, [a, b, xs[2][i] && ys[2][j]]),
          if (small(fine[1], fine[3], b, 1e-300) && small(fine[2], fine[4], b, 1e-300),
            error("neither a solution nor none"))))));
  Vec(found) };

\\ The multiplicities of the solutions, in their order.
multiplicities(p, q, points, bound) = {
  my(m = total_degree(p), n = total_degree(q));
  foreach ([1, -2, 3, 5, -7, 11, 19, -31, 53, 101, -257, 1009], s,
    my(f = subst(p, 'x, 'u - s * 'y), g = subst(q, 'x, 'u - s * 'y), r, factors, result);
    if (poldegree(f, 'y) < m || poldegree(g, 'y) < n, next);
    r = eliminant(f, g, 'y, 'u, bound);
    factors = squarefree_factors(r, 'u);
    if (sum(k = 1, #factors, poldegree(factors[k], 'u)) != #points, next);
    if (sum(k = 1, #factors, k * poldegree(factors[k], 'u)) != poldegree(r, 'u), error("wrong factors"));
    result = vector(#points, i,
      my(u = points[i][1] + s * points[i][2], size = abs(points[i][1]) + abs(s * points[i][2]), order = 0);
      for (k = 1, #factors,
        if (poldegree(factors[k], 'u) > 0,
          if (#factors == k && poldegree(r, 'u) == k * poldegree(factors[k], 'u), order = k,
            abs(subst(factors[k], 'u, u)) <= 1e-400 * subst(absolute(factors[k]), 'u, size),
            if (order, error("two multiplicities")); order = k)));
      if (!order, error("no multiplicity")); order);
    if (vecsum(result) != poldegree(r, 'u), error("wrong sum"));
    return ([result, s]));
  error("no separating shear") };

report(name, p, q) = {
  my(g, bound, points, orders);
  p = integral(p); q = integral(q);
  g = gcd(p, q); g = g / content(g);
  p = simplify(p / g); q = simplify(q / g);
  bound = total_degree(p) * total_degree(q);
  points = solutions(p, q, bound);
  orders = if (#points, multiplicities(p, q, points, bound), [[], 0]);
  if (!#points,
    my(s = 1, f, h);
    until (poldegree(f, 'y) == total_degree(p) && poldegree(h, 'y) == total_degree(q),
      s++; f = subst(p, 'x, 'u - s * 'y); h = subst(q, 'x, 'u - s * 'y));
    if (poldegree(eliminant(f, h, 'y, 'u, bound), 'u) > 0, error("solutions are missing")));
  print("system|", name, "|", g, "|", bound, "|", orders[2]);
  for (i = 1, #points,
    print(real(points[i][1]), "|", imag(points[i][1]), "|", real(points[i][2]), "|", imag(points[i][2]), "|",
      orders[1][i], "|", points[i][3])) };
