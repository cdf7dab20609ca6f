// SPDX-License-Identifier: BSD-3-Clause
#include <support/patch_families.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <support/patch_drawing.hpp>

namespace eliminant::test {

namespace {

using Drawing = PatchDrawing;

enum class Space { as_is, mixed, weighted, rational };

PatchCase pair_of(Random& random, RationalNet first, RationalNet second, Space space) {
  make_binary(first, second);
  if (space == Space::weighted || space == Space::rational) {
    const Projectivity weights = weighting(random);
    first = transformed(first, weights);
    second = transformed(second, weights);
  }
  if (space == Space::mixed || space == Space::rational) {
    const Projectivity matrix = mixing(random);
    first = transformed(first, matrix);
    second = transformed(second, matrix);
  }
  PatchCase result;
  result.first = in_doubles(first);
  result.second = in_doubles(second);
  return result;
}

/// Where one graph lies over another: x = at + by s.
struct Footprint {
  Rational at = 0;
  Rational by = 1;

  Polynomial of(const Polynomial& parameter) const { return number(at) + by * parameter; }
};

/// z = f over the unit square, z = f - F over another rectangle.
PatchCase graphs(Random& random, const Polynomial& f, const Polynomial& difference, unsigned long degree, Space space,
                 const Footprint& x = {}, const Footprint& y = {}) {
  const std::vector<Polynomial> place{x.of(u()), y.of(v())};
  const PatchMap second = affine_patch(place[0], place[1], (f - difference).compose(place));
  return pair_of(random, control_net(affine_patch(u(), v(), f), degree, degree), control_net(second, degree, degree),
                 space);
}

/// z = g over the unit square, and z = g + F over a quadrangle in it, F in its own parameters: (u, v) is bilinear.
PatchCase skew_graphs(Drawing& drawing, const Polynomial& difference, Space space) {
  constexpr std::size_t degree = 3;
  const PatchMap place = patch_map(drawing.wavy(1, 1, fraction(1, 8), fraction(3, 4), 0));
  std::vector<Polynomial::Term> terms;
  for (unsigned long i = 0; i <= degree; ++i)
    for (unsigned long j = 0; i + j <= degree; ++j) terms.push_back({drawing.between(-0.5, 0.5), {i, j}});
  const Polynomial g = Polynomial::from_terms(2, terms);
  const std::vector<Polynomial> at{place[0], place[1]};
  return pair_of(drawing.random, control_net(affine_patch(at[0], at[1], g.compose(at) + difference), degree, degree),
                 control_net(affine_patch(u(), v(), g), degree, degree), space);
}

/// Every second one as it is, every second one mixed.
Space turn(unsigned long index) { return index % 2 == 0 ? Space::as_is : Space::mixed; }

/// T_n(2 t - 1).
Polynomial chebyshev(long n, const Polynomial& t) {
  const Polynomial x = Rational(2) * t - number(1);
  Polynomial before = number(1);
  Polynomial last = x;
  for (long k = 1; k < n; ++k) {
    Polynomial next = Rational(2) * x * last - before;
    before = std::move(last);
    last = std::move(next);
  }
  return last;
}

class Collection {
 public:
  using Make = std::function<PatchCase(Drawing&, unsigned long)>;

  explicit Collection(std::string only) : only_(std::move(only)) {}

  /// `make` draws one case; the numbers of a family do not depend on the others.
  void add(const std::string& family, unsigned long count, const Make& make) {
    if (!only_.empty() && only_ != family) return;
    Random random = family_random(family);
    for (unsigned long index = 0; index < count; ++index) {
      Drawing drawing{random};
      PatchCase& made = cases_.emplace_back(make(drawing, index));
      made.family = family;
      made.index = index;
    }
  }

  std::vector<PatchCase> take() { return std::move(cases_); }

 private:
  std::string only_;
  std::vector<PatchCase> cases_;
};

void add_random(Collection& all) {
  const auto general = [&](const std::string& family, unsigned long count, std::size_t degree, Space space) {
    all.add(family, count, [=](Drawing& drawing, unsigned long) {
      const RationalNet first = drawing.wavy(degree, degree, 0, 1, 0.6);
      return pair_of(drawing.random, first, drawing.wavy(degree, degree, 0, 1, 0.6), space);
    });
  };
  general("random bicubic", 40, 3, Space::as_is);
  general("random biquadratic", 40, 2, Space::as_is);
  general("random rational bicubic", 10, 3, Space::weighted);
  // A general patch over a graph of total degree k.
  const auto over_graph = [&](const std::string& family, unsigned long count, unsigned long degree, bool rational) {
    all.add(family, count, [=](Drawing& drawing, unsigned long index) {
      const RationalNet first = drawing.wavy(degree, degree, fraction(1, 8), fraction(3, 4), 0.6);
      std::vector<Polynomial::Term> terms;
      for (unsigned long i = 0; i <= degree; ++i)
        for (unsigned long j = 0; i + j <= degree; ++j) terms.push_back({drawing.between(-0.5, 0.5), {i, j}});
      const Polynomial g = Polynomial::from_terms(2, terms);
      return pair_of(drawing.random, first, control_net(affine_patch(u(), v(), g), degree, degree),
                     rational ? Space::rational : turn(index));
    });
  };
  over_graph("bicubic over a graph", 20, 3, false);
  over_graph("biquadratic over a graph", 20, 2, false);
  over_graph("rational biquadratic over a graph", 10, 2, true);
}

void add_branches(Collection& all) {
  // The level set of a product of Chebyshev polynomials has a loop in every second inner cell of a board and an arc
  // in every second one on its border: 8 and 10 for n = 5, 2 and 6 for n = 3.
  const auto waves = [&](const std::string& family, unsigned long count, long degree, Space fixed) {
    all.add(family, count, [=](Drawing& drawing, unsigned long index) {
      const auto n = static_cast<unsigned long>(degree);
      const Rational level = drawing.sign() * drawing.between(0.06, 0.25);
      const double noise = index % 4 == 3 ? 0.125 : 0.0078125;
      const Polynomial difference = fraction(1, 8) * (chebyshev(degree, u()) * chebyshev(degree, v()) - number(level) +
                                                      drawing.terms(n, n, noise));
      const Polynomial f = drawing.terms(n, n, 0.25);
      const Space space = fixed == Space::rational ? fixed : turn(index);
      if (index % 5 == 4) return graphs(drawing.random, f, difference, n, space, {fraction(1, 4), 1}, {});
      return graphs(drawing.random, f, difference, n, space);
    });
  };
  waves("branches and loops, degree 3", 30, 3, Space::as_is);
  waves("branches and loops, degree 5", 30, 5, Space::as_is);
  waves("rational branches and loops, degree 3", 10, 3, Space::rational);
}

/// A quadratic form in (u - u0, v - v0) of this signature, and small cubic terms where the degree allows them.
Polynomial form_at(Drawing& drawing, const Rational& u0, const Rational& v0, unsigned long degree, bool definite) {
  const Polynomial x = u() - number(u0);
  const Polynomial y = v() - number(v0);
  Polynomial form = drawing.between(1, 2) * x * x + drawing.between(-0.75, 0.75) * x * y;
  form = form + (definite ? Rational(1) : Rational(-1)) * drawing.between(1, 2) * y * y;
  if (degree >= 3)
    form = form + drawing.between(-0.1, 0.1) * x * x * x + drawing.between(-0.1, 0.1) * x * x * y +
           drawing.between(-0.1, 0.1) * y * y * y;
  return form;
}

void add_small(Collection& all) {
  constexpr unsigned fine_bits = 36;
  for (int exponent = 1; exponent <= 4; ++exponent) {
    const double size = std::pow(10.0, -exponent);
    const std::string text = "1e-" + std::to_string(exponent);
    all.add("loop of diameter " + text, 10, [=](Drawing& drawing, unsigned long index) {
      drawing.resolution = 32;
      const unsigned long degree = index % 4 < 2 ? 3 : 2;
      const Rational u0 = drawing.inner();
      const Rational v0 = drawing.inner();
      const Polynomial form = form_at(drawing, u0, v0, degree, true);
      const Polynomial difference = form - number(binary(size * size / 4, fine_bits));
      return graphs(drawing.random, drawing.terms(degree, degree, 0.5), difference, degree, turn(index));
    });
  }
  for (int exponent = 1; exponent <= 5; ++exponent) {
    const Rational gap = binary(std::pow(10.0, -exponent), 24);
    all.add("gap of 1e-" + std::to_string(exponent), 10, [=](Drawing& drawing, unsigned long index) {
      drawing.resolution = 32;
      const unsigned long degree = index % 4 < 2 ? 3 : 2;
      const Rational u0 = drawing.inner();
      const Rational v0 = drawing.inner();
      // Every fifth pair is parallel.
      const Polynomial form = index % 5 == 4 ? number(0) : form_at(drawing, u0, v0, degree, true);
      const Polynomial f = drawing.terms(degree, degree, 0.5);
      return graphs(drawing.random, f, drawing.sign() * (form + number(gap)), degree, turn(index));
    });
  }
}

void add_contacts(Collection& all) {
  const auto at_point = [&](const std::string& family, unsigned long count, bool definite, bool rational) {
    all.add(family, count, [=](Drawing& drawing, unsigned long index) {
      drawing.resolution = 32;
      const unsigned long degree = index % 4 < 2 ? 3 : 2;
      const Rational u0 = drawing.inner();
      const Rational v0 = drawing.inner();
      const Polynomial form = drawing.sign() * form_at(drawing, u0, v0, degree, definite);
      const Polynomial f = drawing.terms(degree, degree, 0.5);
      return graphs(drawing.random, f, form, degree, rational ? Space::rational : turn(index));
    });
  };
  at_point("contact in a point", 12, true, false);
  at_point("rational contact in a point", 4, true, true);
  at_point("crossing contact", 12, false, false);
  at_point("rational crossing contact", 4, false, true);
  all.add("cusp", 4, [](Drawing& drawing, unsigned long index) {
    drawing.resolution = 32;
    const Polynomial x = u() - number(drawing.inner());
    const Polynomial y = v() - number(drawing.inner());
    const Polynomial difference = drawing.between(1, 2) * x * x - drawing.between(1, 2) * y * y * y;
    return graphs(drawing.random, drawing.terms(3, 3, 0.5), difference, 3, turn(index));
  });
  all.add("contact along a curve", 12, [](Drawing& drawing, unsigned long index) {
    drawing.resolution = 32;
    const Polynomial x = u() - number(drawing.inner());
    const Polynomial y = v() - number(drawing.inner());
    Polynomial line = x + drawing.between(-0.5, 0.5) * y + drawing.between(-0.25, 0.25) * x * y;
    unsigned long degree = 2;
    Polynomial factor = number(drawing.sign());
    if (index % 3 == 1) {
      // Another branch crosses.
      degree = 3;
      factor = drawing.between(-0.5, 0.5) * x + y;
    } else if (index % 3 == 2) {
      degree = 5;
      line =
          x * x + drawing.between(1, 2) * y * y - number(drawing.between(0.0625, 0.125) * drawing.between(0.25, 0.5));
      factor = number(1) + drawing.between(0.1, 0.5) * u();
    }
    return graphs(drawing.random, drawing.terms(degree, degree, 0.5), line * line * factor, degree, turn(index / 3));
  });
}

void add_borders(Collection& all) {
  const auto positive = [](Drawing& drawing) { return drawing.between(0.5, 2); };
  // Plants F, positive on the square but for the zeros named.
  const auto family = [&](const std::string& name, const std::function<Polynomial(Drawing&)>& difference,
                          const Footprint& x = {}) {
    all.add(name, 4, [=](Drawing& drawing, unsigned long index) {
      drawing.resolution = 32;
      const Polynomial planted = difference(drawing);
      return graphs(drawing.random, drawing.terms(3, 3, 0.5), planted, 3, turn(index), x);
    });
  };
  const auto sum = [=](Drawing& drawing) {
    return positive(drawing) * u() + positive(drawing) * v() + drawing.between(0, 1) * u() * v();
  };
  family("touching in a corner", sum);
  family("meeting along an edge", [=](Drawing& drawing) { return u() * (number(1) + sum(drawing)); });
  family("touching an edge", [=](Drawing& drawing) {
    const Polynomial y = v() - number(drawing.inner());
    return positive(drawing) * u() + positive(drawing) * y * y;
  });
  family("through a corner", [=](Drawing& drawing) {
    return positive(drawing) * u() - positive(drawing) * v() + drawing.between(-0.25, 0.25) * u() * v();
  });
  const Footprint beside{1, 1};
  family(
      "beside each other, crossing",
      [=](Drawing& drawing) { return v() - number(drawing.inner()) + drawing.between(-0.25, 0.25) * u() * v(); },
      beside);
  family(
      "beside each other, with a common edge",
      [=](Drawing& drawing) { return (u() - number(1)) * (number(1) + sum(drawing)); }, beside);
}

/// What is planted above, in parameters that are not affine in space.
void add_skew(Collection& all) {
  const auto at_point = [](Drawing& drawing, bool definite) {
    const Rational u0 = drawing.inner();
    return form_at(drawing, u0, drawing.inner(), 3, definite);
  };
  const auto family = [&](const std::string& name, const std::function<Polynomial(Drawing&, unsigned long)>& planted) {
    all.add(name, 6, [=](Drawing& drawing, unsigned long index) {
      drawing.resolution = 16;
      const Polynomial difference = planted(drawing, index);
      return skew_graphs(drawing, difference, turn(index));
    });
  };
  family("skew branches and loops", [](Drawing& drawing, unsigned long) {
    const Rational level = drawing.sign() * drawing.between(0.0625, 0.25);
    return fraction(1, 8) * (chebyshev(3, u()) * chebyshev(3, v()) - number(level));
  });
  family("skew loop", [=](Drawing& drawing, unsigned long index) {
    constexpr unsigned fine_bits = 30;
    const double size = std::pow(10.0, -static_cast<double>(1 + index % 4));
    return at_point(drawing, true) - number(binary(size * size / 4, fine_bits));
  });
  family("skew gap", [=](Drawing& drawing, unsigned long index) {
    const Rational gap = binary(std::pow(10.0, -static_cast<double>(1 + index % 5)), 24);
    return drawing.sign() * ((index == 5 ? number(0) : at_point(drawing, true)) + number(gap));
  });
  family("skew contact in a point",
         [=](Drawing& drawing, unsigned long) { return drawing.sign() * at_point(drawing, true); });
  family("skew crossing contact", [=](Drawing& drawing, unsigned long) { return at_point(drawing, false); });
  family("skew contact along a curve", [](Drawing& drawing, unsigned long index) {
    const Polynomial x = u() - number(drawing.inner());
    const Polynomial y = v() - number(drawing.inner());
    const Polynomial line = x + drawing.between(-0.5, 0.5) * y;
    return drawing.sign() * line * line * (index % 2 == 0 ? number(1) : drawing.between(-0.5, 0.5) * x + y);
  });
}

std::vector<PatchCase> collected(const std::string& only) {
  Collection all(only);
  add_random(all);
  add_branches(all);
  add_small(all);
  add_contacts(all);
  add_borders(all);
  add_skew(all);
  return all.take();
}

}  // namespace

std::vector<PatchCase> patch_cases() { return collected({}); }

std::vector<PatchCase> patch_cases(const std::string& family) { return collected(family); }

PatchCase exchanged(PatchCase patches) {
  std::swap(patches.first, patches.second);
  return patches;
}

}  // namespace eliminant::test
