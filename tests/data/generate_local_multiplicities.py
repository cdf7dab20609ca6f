#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes local_multiplicities.txt beside this file: small systems with the multiplicities of all their solutions.

    python3 generate_local_multiplicities.py

Needs Singular (4.3.1 was used) for the multiplicities, see local_multiplicities.sing, and PARI's gp (2.15) for the
decimals of the multiple points; the tests read only the result. The dimensions k m of the classes are added up and
compared with the dimension of Q[x, y] / (p, q).

A line is

    p ; q ; 1x5 2x1 3x2 ; 2@x_re,x_im,y_re,y_im 3@... 3@...

with the number of solutions of each multiplicity, and all multiple solutions to 12 digits.
"""
import collections
import decimal
import pathlib
import random
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
SIZE = 2000
WITHOUT_MULTIPLE_POINT = 650
BATCH = 100


def times(a, b):
    result = collections.Counter()
    for (i, j), c in a.items():
        for (k, l), d in b.items():
            result[i + k, j + l] += c * d
    return {m: c for m, c in result.items() if c}


def plus(a, b):
    result = collections.Counter(a)
    for m, c in b.items():
        result[m] += c
    return {m: c for m, c in result.items() if c}


def derivative(a, variable):
    result = {}
    for (i, j), c in a.items():
        if (i, j)[variable]:
            result[(i - 1, j) if variable == 0 else (i, j - 1)] = c * (i, j)[variable]
    return result


def degree(a):
    return max((i + j for i, j in a), default=-1)


def text(a):
    words = ""
    for (i, j), c in sorted(a.items(), key=lambda t: (-t[0][0] - t[0][1], -t[0][0])):
        factors = [f"{v}^{e}" if e > 1 else v for v, e in (("x", i), ("y", j)) if e]
        if abs(c) != 1 or not factors:
            factors.insert(0, str(abs(c)))
        words += ("-" if c < 0 else "+" if words else "") + "*".join(factors)
    return words


def random_polynomial(rng, d, terms=None, lowest=0):
    monomials = [(i, j) for i in range(d + 1) for j in range(d + 1 - i) if i + j >= lowest]
    if terms is not None:
        monomials = rng.sample(monomials, min(terms, len(monomials)))
    return {m: c for m in monomials if (c := rng.randint(-3, 3))}


def allowed(a):
    return 1 <= degree(a) <= 4 and all(-3 <= c <= 3 for c in a.values())


def candidate(rng):
    """Two polynomials; the kinds differ in how they come to multiple points."""
    kind = rng.randrange(9)
    d, e = rng.randint(1, 4), rng.randint(1, 4)
    if kind == 0:  # dense
        return random_polynomial(rng, d), random_polynomial(rng, e)
    if kind == 1:  # sparse
        return random_polynomial(rng, d, rng.randint(2, 4)), random_polynomial(rng, e, rng.randint(2, 4))
    if kind == 2:  # low orders at the origin
        d, e = rng.randint(2, 4), rng.randint(2, 4)
        return random_polynomial(rng, d, rng.randint(2, 5), rng.randint(1, 3)), \
            random_polynomial(rng, e, rng.randint(2, 5), rng.randint(1, 3))
    if kind == 3:  # a curve and a derivative
        f = random_polynomial(rng, rng.randint(2, 4), rng.randint(2, 4))
        return f, derivative(f, rng.randrange(2))
    if kind == 4:  # a square, and anything
        s = random_polynomial(rng, rng.randint(1, 2), rng.randint(2, 3))
        return times(s, s), random_polynomial(rng, e, rng.randint(1, 4))
    if kind == 5:  # s^2 + h q against q: contact wherever s meets q
        s = random_polynomial(rng, rng.randint(1, 2), rng.randint(2, 3))
        q = random_polynomial(rng, e, rng.randint(2, 4))
        h = random_polynomial(rng, 4 - e, rng.randint(1, 2))
        return plus(times(s, s), times(h, q)), q
    if kind == 6:  # the irreducible squares with small coefficients, in one variable or a linear form
        t = random_polynomial(rng, 1, 2)
        u = plus(plus(times(t, t), {m: c * rng.choice([-1, 1]) for m, c in t.items()} if rng.random() < 0.7 else {}),
                 {(0, 0): rng.choice([-1, 1])})
        q = random_polynomial(rng, e, rng.randint(2, 4))
        h = random_polynomial(rng, 4 - e, 1) if rng.random() < 0.5 else {}
        return plus(times(u, u), times(h, q)), q
    if kind == 7:  # products of lines and conics
        a, b = random_polynomial(rng, 1), random_polynomial(rng, rng.randint(1, 2), 3)
        c, f = random_polynomial(rng, 1, 2), random_polynomial(rng, rng.randint(1, 2), 3)
        return times(times(a, b), a if rng.random() < 0.4 else {(0, 0): 1}), times(c, f)
    # one variable only in one of them
    variable = rng.randrange(2)
    f = {(i, 0) if variable else (0, i): c for i in range(5) if (c := rng.randint(-3, 3))}
    return times(f, {(0, 0): 1}), random_polynomial(rng, e, rng.randint(2, 5))


def run(command, script, seconds):
    return subprocess.run(command, input=script, text=True, capture_output=True, timeout=seconds, check=True).stdout


def local_multiplicities(systems):
    """For each system None (infinite) or the list of (k, multiplicity, (minimal polynomial, f, g) or None)."""
    script = f'< "{HERE / "local_multiplicities.sing"}";\n'
    for i, (p, q) in enumerate(systems):
        script += f"local_multiplicities({i}, {text(p)}, {text(q)});\n"
    output = run(["Singular", "-q"], script + "quit;\n", 900)
    result = {}
    dimensions = {}
    for line in output.splitlines():
        words = line.split()
        if words[:1] == ["system"]:
            index = int(words[1])
            result[index] = None if words[2] == "infinite" else []
            dimensions[index] = words[2]
        elif words[:1] == ["class"]:
            result[index].append((int(words[1]), int(words[2]), tuple(words[3:]) or None))
        elif words[:1] != ["//"]:
            raise RuntimeError(line)
    for i in range(len(systems)):
        if result[i] is not None and sum(k * m for k, m, _ in result[i]) != int(dimensions[i]):
            raise RuntimeError(f"dimensions of {text(systems[i][0])}, {text(systems[i][1])}")
    return [result[i] for i in range(len(systems))]


def coordinates(classes):
    """For each (minimal polynomial, f, g) its points, as (x_re, x_im, y_re, y_im)."""
    script = "default(realprecision, 57);\n"
    for minimal, f, g in classes:
        script += f'print("class"); foreach(polroots(subst({minimal}, a, z)), r, my(v = 1.0 * [subst({f}, a, r), ' \
                  f"subst({g}, a, r)]); print(real(v[1]), \" \", imag(v[1]), \" \", real(v[2]), \" \", imag(v[2])));\n"
    result = []
    for line in run(["gp", "-q", "-f"], script, 300).replace(" E", "E").splitlines():
        if line == "class":
            result.append([])
        elif line.strip():
            result[-1].append(tuple(twelve_digits(word) for word in line.split()))
    assert len(result) == len(classes)
    return result


def twelve_digits(word):
    value = decimal.Decimal(word)
    if abs(value) < decimal.Decimal("1e-40"):
        return "0"
    with decimal.localcontext() as context:
        context.prec = 12
        value = (+value).normalize()
    return f"{value:f}" if -5 < value.adjusted() < 8 else f"{value:e}"


def main():
    rng = random.Random(4)
    chosen = []
    seen = set()
    simple = 0
    while len(chosen) < SIZE:
        batch = []
        while len(batch) < BATCH:
            p, q = candidate(rng)
            if not (allowed(p) and allowed(q)) or (text(p), text(q)) in seen:
                continue
            seen.add((text(p), text(q)))
            batch.append((p, q))
        for (p, q), classes in zip(batch, local_multiplicities(batch)):
            if classes is None or len(chosen) == SIZE:
                continue
            if all(m == 1 for _, m, _ in classes):
                if simple == WITHOUT_MULTIPLE_POINT:
                    continue
                simple += 1
            chosen.append((p, q, classes))
        print(len(chosen), simple, file=sys.stderr, flush=True)
    multiple = [c for _, _, classes in chosen for c in classes if c[1] > 1]
    points = iter(coordinates([c[2] for c in multiple]))
    lines = []
    for p, q, classes in chosen:
        numbers = collections.Counter()
        places = []
        for k, m, _ in classes:
            numbers[m] += k
            if m > 1:
                found = next(points)
                assert len(found) == k
                places += [f"{m}@" + ",".join(point) for point in found]
        lines.append(f"{text(p)} ; {text(q)} ; {' '.join(f'{m}x{n}' for m, n in sorted(numbers.items()))} ; "
                     f"{' '.join(places)}".rstrip())
    (HERE / "local_multiplicities.txt").write_text("\n".join(lines) + "\n")
    print(len(chosen), "systems,", simple, "without a multiple point,",
          sum(any(m > 1 and k > 1 for k, m, _ in c) for _, _, c in chosen), "with non-rational multiple points,",
          "largest multiplicity", max(m for _, m, _ in multiple), file=sys.stderr)


if __name__ == "__main__":
    main()
