#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes plane_curves_systems.json beside this file: systems of two plane curves with all their solutions.

    python3 generate_plane_curves_systems.py

Needs PARI's program gp (2.15 was used); the tests read only the result. How the solutions are found, and why none is
missing, stands in plane_curves_systems.gp.

Of two conjugate solutions one is stored, that with positive imaginary part of x, or of y where x is real. Numbers are
rounded to 45 significant digits, those of up to six solutions of a system, of different kinds, to 510; a number with
fewer than 40 digits is exact.
"""
import decimal
import json
import pathlib
import random
import re
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent
decimal.getcontext().prec = 800

SYSTEMS = []


def add(name, p, q):
    """p and q in ordinary notation; "=..." is an expression of PARI, stored as PARI prints its value."""
    SYSTEMS.append((name, p, q))


def product(terms):
    return "*".join(terms)


def changed(text, x, y):
    """text with (x), (y) put in the places of the variables."""
    return re.sub(r"[xy]", lambda m: f"({x if m.group() == 'x' else y})", text)


def dense(rng, degree, size):
    terms = []
    for i in range(degree, -1, -1):
        for j in range(degree - i, -1, -1):
            c = rng.randint(-size, size)
            if c:
                terms.append(f"{c}*x^{i}*y^{j}")
    text = " + ".join(terms)
    text = re.sub(r"\*[xy]\^0(?!\d)", "", text)
    return re.sub(r"\^1(?!\d)", "", text).replace("+ -", "- ")


def describe_systems():
    rng = random.Random(3)

    for d in range(2, 9):
        add(f"dense {d} {d}", dense(rng, d, 500), dense(rng, d, 500))
    for m, n in [(1, 8), (2, 7), (3, 5), (8, 3), (6, 4), (1, 1)]:
        add(f"dense {m} {n}", dense(rng, m, 99), dense(rng, n, 99))
    add("dense 4 4, 30-digit coefficients", dense(rng, 4, 10**30), dense(rng, 4, 10**30))
    add("dense 5 4, small coefficients", dense(rng, 5, 2), dense(rng, 4, 2))
    add("dense 3 4, rational coefficients", "x^3/7 - 22/7*x*y^2 + 1/3*y^3 - 5/11*x*y + 2/13",
        "3/5*x^4 - x^2*y^2/9 + 8/17*y^4 + x/2 - 1/19")

    singular = {
        "nodal cubic": "y^2 - x^2*(x+1)",
        "cuspidal cubic": "y^2 - x^3",
        "cuspidal cubic, turned": "(x+2*y)^2 - (x-y)^3",
        "tacnode and node": "2*x^4 - 3*x^2*y + y^2 - 2*y^3 + y^4",
        "tacnodes": "(x^2+y^2-1)^2 - x^4 - x^2*(y^2-1)",
        "trifolium": "(x^2+y^2)^2 + 3*x^2*y - y^3",
        "lemniscate": "(x^2+y^2)^2 - 2*(x^2-y^2)",
        "deltoid": "(x^2+y^2)^2 + 18*(x^2+y^2) - 27 - 8*(x^3-3*x*y^2)",
        "rhamphoid cusp": "(y-x^2)^2 - x^5",
        "cardioid": "(x^2+y^2)^2 + 4*x*(x^2+y^2) - 4*y^2",
        "quadrifolium": "(x^2+y^2)^3 - 4*x^2*y^2",
        "three nodes in a row": "y^2 - x^2*(x-1)^2*(x+1)^2*(x+3)",
        "Chebyshev curve 5 4": "=polchebyshev(5,1,x)-polchebyshev(4,1,y)",
        "astroid": "(x^2+y^2-1)^3 + 27*x^2*y^2",
        "bicorn": "y^2*(1-x^2) - (x^2+2*y-1)^2",
    }
    for name, f in singular.items():
        text = f[1:] if f.startswith("=") else f
        add(f"{name}, f and f_y", f, f"=deriv({text},'y)")
    for name in ["cuspidal cubic, turned", "trifolium", "deltoid", "bicorn"]:
        add(f"{name}, f and f_x", singular[name], f"=deriv({singular[name]},'x)")
    add("trifolium, f_x and f_y", f"=deriv({singular['trifolium']},'x)", f"=deriv({singular['trifolium']},'y)")
    add("astroid, f_x and f_y", f"=deriv({singular['astroid']},'x)", f"=deriv({singular['astroid']},'y)")

    fermat = {
        9: "2*x^9 - y^9 + 3", 10: "x^10 - 3*x*y^4 + y - 2", 11: "x^3 + y^3 - 1", 12: "(x-1/2)^12 + 2*y^12 - 3*x",
        13: "x^2 + y^2 - 1", 14: "x^7 - y^7", 15: "x^5*y - y^2 + 1", 16: "x^16 - 2*y^16 + 3", 17: "x + y - 1",
        18: "x^3 + y^3 - 1", 19: "x^4 - y^5", 20: "2*x^20 - y^20 + 3",
    }
    for n, q in fermat.items():
        add(f"Fermat {n}", f"x^{n} + y^{n} - 1", q)
    add("Fermat 9 and its double, at infinity", "x^9 + y^9 - 1", "x^9 + y^9 - x - y")

    add("Wilkinson 10 lines, parabola", product(f"(x-{i})" for i in range(1, 11)), "y - x^2")
    add("Wilkinson 10 lines, parabola on its side", product(f"(x-{i})" for i in range(1, 11)), "y^2 - x")
    add("Wilkinson 20 lines, parabola on its side", product(f"(x-{i})" for i in range(1, 21)), "y^2 - x + 12")
    add("Wilkinson 15 lines, circle", product(f"(y-{i})" for i in range(1, 16)), "x^2 + y^2 - 100")
    add("Wilkinson 8 turned lines, parabola", product(f"(x+y-{i})" for i in range(1, 9)), "y - x^2")
    add("Wilkinson 10 by 10", product(f"(x-{i})" for i in range(1, 11)), product(f"(y-{i})" for i in range(1, 11)))

    for n in [5, 8, 12]:
        add(f"Chebyshev grid {n}", f"=polchebyshev({n},1,x)", f"=polchebyshev({n},1,y)")
    add("Chebyshev curves 5 4 and 3 7", "=polchebyshev(5,1,x)-polchebyshev(4,1,y)",
        "=polchebyshev(3,1,x)-polchebyshev(7,1,y)")
    add("Chebyshev curve 9 8, line", "=polchebyshev(9,1,x)-polchebyshev(8,1,y)", "x - 2*y")
    add("Chebyshev curve 6 7, circle", "=polchebyshev(6,1,x)+polchebyshev(7,1,y)", "x^2 + y^2 - 1")

    for k in range(2, 9):
        x, y = [("x+2*y-1", "y-x/3"), ("2*x-y", "x+y-2"), ("x-y/2+1", "x+3*y"), ("x", "y")][k % 4]
        add(f"tangency of order {k}", changed("y - x^2", x, y), changed(f"y - x^2 + x^{k}*(x-1)", x, y))
    for k, extra in [(3, "x^3"), (5, "x^3*y"), (8, "y^4")]:
        add(f"contact of order {k} with a circle", "x^2 + y^2 - 2*y", f"x^2 + y^2 - 2*y + {extra}")
    add("tangency of order 4 at non-rational points", "y - x^3", "y - x^3 + (x^2-2)^4")
    add("tangency of order 2 at non-real points", "y - x", "(y-x)*(x+3*y-1) + (x^2+x+1)^2")

    add("cusps 3 2 and 2 3", "x^3 - y^2", "x^2 - y^3")
    add("cusps 5 3 and 4 7", "x^5 - y^3", "x^4 - y^7")
    add("cusps 7 4 and 5 2", "x^7 - y^4", "x^5 - 2*y^2")
    add("cusps 3 2 and 3 2", "x^3 - y^2", "x^3 - 2*y^2 + x*y^2")
    add("cusps 5 3 and 3 5 at (1, -2), turned", changed("x^5 - y^3", "x+y+1", "x-2*y-5"),
        changed("x^3 - y^5", "x+y+1", "x-2*y-5"))

    for e in [5, 10, 20, 40]:
        add(f"real pair 1e-{e} apart", "y - x^3 + x", f"y - x^3 + x + (x+2)*((x-1)^2 - 1/4*1e-{2 * e})")
        add(f"conjugate pair 1e-{e} apart", "y - x^3 + x", f"y - x^3 + x + (x+2)*((x-1)^2 + 1/4*1e-{2 * e})")
    add("circles, real pair 2e-10 apart", "x^2 + y^2 - 1", "(x-2)^2 + y^2 - 1 - 4e-20")
    add("circles, conjugate pair 2e-20 apart", "x^2 + y^2 - 1", "(x-2)^2 + y^2 - 1 + 4e-40")
    add("three points 1e-10 apart and a pair 1e-5 apart", "x^2 + y - 2",
        "(x-1)*(x-1-1e-10)*(x-1+1e-10)*((x+1)^2 - 1e-10)")

    add("vertical lines 1", "x*(x-1)", "y^5 - y - x")
    add("vertical lines 2", "x^2 - 2", "y^4 - x*y - 1")
    add("vertical lines 3", "x^3 - x - 1", "y^3 - 3*x*y^2 + x^2 - 5")
    add("double vertical line", "x^2", "y^3 - y + x")
    add("vertical and horizontal lines with a quartic", "x*y*(x-1)*(y-1)", "x^4 + y^4 - x^3 - y^3 + x*y*(x-2)")
    add("vertical line, four points of multiplicity 2", "(x-1)^2 + (y^4-5*y^2+4)^2", "(x-1)*(y+7)")

    add("infinity: one common asymptote, touched", "(x-y)*(x+2*y) - 1", "(x-y)*(x+3*y) - 1")
    add("infinity: circles", "x^2 + y^2 - 1", "x^2 + y^2 - 2*x")
    add("infinity: parabolas of one axis", "y - x^2", "y - 3*x^2 - x + 3")
    add("infinity: parabolas that touch there", "y - x^2", "y - x^2 - x + 3")
    add("infinity: equal leading forms", "x^5 + y^5 - 1", "x^5 + y^5 - x*y")
    add("infinity: circular points", "(x^2+y^2)^3 - 4*x^2*y^2", "(x^2+y^2)^2 - x^2 + y^2")
    add("infinity: fourfold direction", "y*(x+y)^4 - 1", "x*(x+y)^3 - y + 2")
    add("infinity: both axes", "x^2*y - 1", "x*y^2 + x - y - 3")
    add("infinity: high powers", "x^3*y^5 - x + y", "x^4*y^2 - y^3 + 2")
    add("infinity: in the direction of y", "x*y^3 + y + x^2 - 1", "x*y^2 - x + 2")

    add("empty: hyperbola and asymptote", "x*y - 1", "x")
    add("empty: parallels", "x + y - 1", "2*x + 2*y + 3")
    add("empty: parabolas", "y - x^2", "y - x^2 - 1")
    add("empty: Fermat curves", "x^9 + y^9 - 1", "x^9 + y^9 - 2")
    add("empty: a curve and a constant", "x^2*y - 5", "7")
    add("empty: product of parallels", "(x-1)*(x-2)*(x-3)", "(x-4)^2*(x-5)")

    add("common line", "(x-y)*(x^2+y^2-1)", "(x-y)*(x-2)")
    add("common circle, once and twice", "(x^2+y^2-1)^2*(x-3*y)", "(x^2+y^2-1)*(y-x^2)")
    add("common factors of Chebyshev curves", "=polchebyshev(7,1,x)-polchebyshev(7,1,y)",
        "=polchebyshev(5,1,x)-polchebyshev(5,1,y)")
    add("common cusp, tangency beside it", "(x^3-y^2)*(y-x^2)", "(x^3-y^2)*(y-2*x+1)*(x+5)")
    add("equal curves", "3*x^2*y - 6", "2 - x^2*y")
    add("a curve and its square", "x^3 - y^2 - y", "(x^3-y^2-y)^2")

    add("coefficients 1e30 and 1e-30", "1e30*x^2 + y^2 - 1e-30", "x*y - 1e-30*x + 1e-31")
    add("coefficients 1e30, cubic", "1e30*x^3 - 3*y^3 + 1e15*x*y - 2", "y^2 - 1e30*x - 1e-30")
    add("tiny conic, huge line", "1e-30*x^2 + 2e-30*y^2 - 3e-30", "1e30*x - 2e30*y + 1e30")
    add("solutions of sizes 1e-30 and 1e30", "x*y - 1", "(x-1e30)*(x-1e-30)*(x+2)")
    add("decimal coefficients", "0.1*x^2 + 0.25*y^2 - 1.5e-3", "0.1*x*y - 12.5e-5*y + 0.0001")


def exact(text):
    """The same in PARI's notation: no decimals, which PARI would round."""
    def number(match):
        value = Fraction(match.group())
        return f"({value})"
    return re.sub(r"\d+(\.\d+)?([eE][-+]?\d+)?", lambda m: number(m) if re.search(r"[.eE]", m.group()) else m.group(),
                  text)


def run_gp(script, seconds):
    run = subprocess.run(["gp", "-q", "-f", str(HERE / "plane_curves_systems.gp")], input=script, text=True,
                         capture_output=True, timeout=seconds, check=True)
    if "***" in run.stderr.replace("*** Warning", "").replace("***   Warning: new maximum", ""):
        raise RuntimeError(run.stderr)
    return run.stdout


def evaluated(texts):
    """The values of the PARI expressions as PARI prints them."""
    output = run_gp("".join(f"print({t})\n" for t in texts), 60)
    return [line.replace(" ", "") for line in output.strip().splitlines()]


TINY = Decimal("1e-600")


def rounded(value, scale, digits):
    if abs(value) <= TINY * scale or value == 0:
        return "0"
    with decimal.localcontext() as context:
        context.prec = 30
        short = (+value).normalize()
    if abs(short - value) <= TINY * abs(value):
        return f"{short:f}" if -6 < short.adjusted() < 12 else f"{short:e}"
    with decimal.localcontext() as context:
        context.prec = digits
        return str(+value).replace("E", "e")


def solutions(lines):
    """(x_re, x_im, y_re, y_im, multiplicity, real), one of each conjugate pair, sorted."""
    points = []
    for line in lines:
        *numbers, multiplicity, real = line.split("|")
        x_re, x_im, y_re, y_im = (Decimal(n.replace(" ", "")) for n in numbers)
        real = real == "1"
        x_size = max(abs(x_re), abs(x_im), Decimal("1e-60"))
        y_size = max(abs(y_re), abs(y_im), Decimal("1e-60"))
        x_im = Decimal(0) if abs(x_im) <= TINY * x_size else x_im
        y_im = Decimal(0) if abs(y_im) <= TINY * y_size else y_im
        assert real == (x_im == 0 and y_im == 0)
        points.append((x_re, x_im, y_re, y_im, int(multiplicity), real, x_size, y_size))
    kept = [p for p in points if p[5] or p[1] > 0 or (p[1] == 0 and p[3] > 0)]
    assert sum(1 if p[5] else 2 for p in kept) == len(points)
    return sorted(kept)


def to_write_long(points):
    """Indices of up to six solutions, of different kinds as far as there are any."""
    chosen = []
    kinds = {}
    for i, p in enumerate(points):
        kinds.setdefault((p[5], p[4] > 1), []).append(i)
    while len(chosen) < min(6, len(points)):
        for indices in kinds.values():
            if indices and len(chosen) < 6:
                chosen.append(indices.pop(len(indices) // 2))
    return chosen


def main():
    describe_systems()
    names = [name for name, _, _ in SYSTEMS]
    assert len(set(names)) == len(names)
    expressions = sorted({t[1:] for _, p, q in SYSTEMS for t in (p, q) if t.startswith("=")})
    values = dict(zip(expressions, evaluated(expressions)))
    only = sys.argv[1:]
    result = []
    for name, p, q in SYSTEMS:
        if only and name not in only:
            continue
        p, q = (values[t[1:]] if t.startswith("=") else t for t in (p, q))
        output = run_gp(f'report("{name}", {exact(p)}, {exact(q)})\n', 600).strip().splitlines()
        _, shown, component, bezout, shear = output[0].split("|")
        points = solutions(output[1:])
        with_multiplicity = sum(p[4] * (1 if p[5] else 2) for p in points)
        system = {"name": name, "p": p, "q": q, "status": "certified" if component == "1" else "infinite"}
        if component != "1":
            system["component"] = component.replace(" ", "")
        system["distinct"] = sum(1 if p[5] else 2 for p in points)
        system["real"] = sum(p[5] for p in points)
        system["with_multiplicity"] = with_multiplicity
        system["at_infinity"] = int(bezout) - with_multiplicity
        long = to_write_long(points)
        system["points"] = [
            {"x": [rounded(p[0], p[6], 510 if i in long else 45), rounded(p[1], p[6], 510 if i in long else 45)],
             "y": [rounded(p[2], p[7], 510 if i in long else 45), rounded(p[3], p[7], 510 if i in long else 45)],
             "multiplicity": p[4], "real": p[5]} for i, p in enumerate(points)]
        result.append(system)
        print(name, {k: system[k] for k in ("status", "distinct", "real", "with_multiplicity", "at_infinity")},
              f"shear {shear}", file=sys.stderr, flush=True)
    if only:
        return
    lines = []
    for system in result:
        head = {k: v for k, v in system.items() if k != "points"}
        points = ",\n".join("   " + json.dumps(p) for p in system["points"])
        lines.append(json.dumps(head)[:-1] + ', "points": [' + ("\n" + points if points else "") + "]}")
    (HERE / "plane_curves_systems.json").write_text("[\n" + ",\n".join(lines) + "\n]\n")
    print(len(result), "systems", file=sys.stderr)


if __name__ == "__main__":
    main()
