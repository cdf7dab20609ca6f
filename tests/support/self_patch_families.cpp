// SPDX-License-Identifier: BSD-3-Clause
#include <support/self_patch_families.hpp>

#include <cmath>
#include <functional>
#include <utility>

#include <support/patch_drawing.hpp>

namespace eliminant::test {

namespace {

using Drawing = PatchDrawing;

constexpr std::size_t degree = 3;

/// Moved by a linear map.
SelfPatchCase self_case(Drawing& drawing, const PatchMap& map, std::optional<PairedSheets> sheets = {}) {
  RationalNet net = control_net(map, degree, degree);
  RationalNet same = net;
  make_binary(net, same);
  SelfPatchCase result;
  result.patches.first = in_doubles(transformed(net, mixing(drawing.random)));
  result.sheets = std::move(sheets);
  return result;
}

/// (w, v, U k(w, v) + ...), U = u - c and w = U^2, k of degree 1 in w: U and -U have one point where k = 0.
SelfPatchCase folded(Drawing& drawing, const Rational& centre, const Polynomial& k_of_square) {
  const Polynomial fold = u() - number(centre);
  const Polynomial square = fold * fold;
  const std::vector<Polynomial> at{square, v()};
  const Polynomial k = k_of_square.compose(at);
  const Polynomial even = drawing.terms(1, 3, 0.25).compose(at);
  PairedSheets sheets;
  sheets.half.equation = k;
  const Rational twice = Rational(2) * centre;
  sheets.half.box = {{centre, twice < Rational(1) ? twice : Rational(1)}, {0, 1}};
  sheets.centre = fmpz_get_d(centre.numerator().get()) / fmpz_get_d(centre.denominator().get());
  return self_case(drawing, affine_patch(square, v(), fold * k + even), sheets);
}

/// (p, q, (u - v) k(p, q) + ...), p = u + v and q = u v, k of degree 2: (u, v) and (v, u) have one point where k = 0.
SelfPatchCase exchanging(Drawing& drawing, const Polynomial& k_of_sum_and_product) {
  const std::vector<Polynomial> at{u() + v(), u() * v()};
  const Polynomial k = k_of_sum_and_product.compose(at);
  std::vector<Polynomial::Term> terms;
  for (unsigned long i = 0; i <= degree; ++i)
    for (unsigned long j = 0; i + j <= degree; ++j) terms.push_back({drawing.between(-0.125, 0.125), {i, j}});
  const Polynomial even = Polynomial::from_terms(2, terms).compose(at);
  PairedSheets sheets;
  sheets.involution = PairedSheets::Involution::exchange;
  const std::vector<Polynomial> below_diagonal{u(), u() * v()};
  sheets.half = {k.compose(below_diagonal), {{0, 1}, {0, 1}}};
  return self_case(drawing, affine_patch(at[0], at[1], (u() - v()) * k + even), sheets);
}

/// k = w - c(v).
Polynomial height(const Polynomial& c) { return u() - c; }

/// An ellipse in the plane of sum and product, u and v for those.
Polynomial ellipse(const Rational& sum, const Rational& product, const Rational& radius_squared) {
  const Polynomial p = u() - number(sum);
  const Polynomial q = v() - number(product);
  return p * p + Rational(9) * q * q - number(radius_squared);
}

/// (y z, x z, x y) for the three barycentric coordinates of a triangle: each side is taken twice, by the reflection at
/// its midpoint, and the vertices have one image. There three sheets are transversal, and the midpoints are pinch
/// points of the stable kind, so that small further terms change no number.
SelfPatchCase with_triple_point(Drawing& drawing) {
  const std::array<std::array<Rational, 2>, 3> vertices{{{drawing.between(0.2, 0.35), drawing.between(0.2, 0.35)},
                                                         {drawing.between(0.65, 0.8), drawing.between(0.2, 0.4)},
                                                         {drawing.between(0.35, 0.65), drawing.between(0.65, 0.8)}}};
  // Twice the area with the opposite side, which is up to a factor the barycentric coordinate.
  std::array<Polynomial, 3> x{Polynomial(2), Polynomial(2), Polynomial(2)};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& a = vertices[(i + 1) % 3];
    const auto& b = vertices[(i + 2) % 3];
    x[i] = (b[0] - a[0]) * (v() - number(a[1])) - (b[1] - a[1]) * (u() - number(a[0]));
  }
  const auto coordinate = [&](std::size_t i) {
    return Rational(4) * x[(i + 1) % 3] * x[(i + 2) % 3] + fraction(1, 1024) * drawing.terms(3, 3, 0.5);
  };
  const PatchMap map = affine_patch(coordinate(0), coordinate(1), coordinate(2));
  SelfPatchCase result = self_case(drawing, map);
  result.triple_points = 1;
  // Three arcs from a pinch point to the border, all through the triple point.
  result.patches.planted = PatchCounts{3, 0, 0, 4};
  return result;
}

using Make = std::function<SelfPatchCase(Drawing&, unsigned long)>;

class Collection {
 public:
  explicit Collection(std::string only) : only_(std::move(only)) {}

  void add(const std::string& family, const Make& make) {
    constexpr unsigned long count = 5;
    if (!only_.empty() && only_ != family) return;
    Random random = family_random(family);
    for (unsigned long index = 0; index < count; ++index) {
      Drawing drawing{random, 64};
      SelfPatchCase& made = cases_.emplace_back(make(drawing, index));
      made.patches.family = family;
      made.patches.index = index;
    }
  }

  std::vector<SelfPatchCase> take() { return std::move(cases_); }

 private:
  std::string only_;
  std::vector<SelfPatchCase> cases_;
};

Rational centre(unsigned long index) { return fraction(static_cast<long>(3 + index % 3), 8); }

void add_meeting(Collection& all) {
  all.add("double curve from edge to edge", [](Drawing& drawing, unsigned long index) {
    const Polynomial c = number(drawing.between(0.05, 0.09)) + drawing.between(-0.02, 0.02) * v() +
                         drawing.between(-0.02, 0.02) * v() * v() * v();
    return folded(drawing, centre(index), height(c));
  });
  all.add("double curve with pinch points", [](Drawing& drawing, unsigned long index) {
    // c vanishes once, or twice with positive values between or outside.
    const Polynomial first = v() - number(drawing.between(0.2, 0.4));
    const Polynomial second = v() - number(drawing.between(0.6, 0.8));
    const Rational size = drawing.between(0.0625, 0.125);
    if (index % 3 == 0) return folded(drawing, centre(index), height(size * first));
    return folded(drawing, centre(index), height((index % 3 == 1 ? -size : size) * first * second));
  });
  all.add("closed double curve", [](Drawing& drawing, unsigned long index) {
    const Rational product = index % 2 == 0 ? fraction(1, 8) : fraction(9, 64);
    return exchanging(drawing, ellipse(1, product, fraction(2 + static_cast<long>(index), 1024)));
  });
  all.add("triple point", [](Drawing& drawing, unsigned long) { return with_triple_point(drawing); });
}

void add_embedded(Collection& all) {
  all.add("embedded graph", [](Drawing& drawing, unsigned long) {
    return self_case(drawing, affine_patch(u(), v(), drawing.terms(3, 3, 0.5)));
  });
  all.add("embedded fold", [](Drawing& drawing, unsigned long index) {
    // c < 0: down to one thousandth.
    const Polynomial y = v() - number(drawing.inner());
    const Rational distance = index % 2 == 0 ? fraction(1, 1024) : fraction(1, 16);
    return folded(drawing, centre(index), height(drawing.between(-1, -0.5) * y * y - number(distance)));
  });
  all.add("embedded fold, cut before it closes", [](Drawing& drawing, unsigned long) {
    // The zeros are at |U| > 1/8, where -U is no parameter of the patch.
    const Polynomial c = number(fraction(1, 32)) + drawing.between(0, 0.125) * v();
    return folded(drawing, fraction(1, 8), height(c));
  });
  all.add("embedded, with two sheets", [](Drawing& drawing, unsigned long index) {
    const Rational distance = index % 2 == 0 ? fraction(-1, 1024) : fraction(-1, 16);
    return exchanging(drawing, ellipse(drawing.between(0.75, 1.25), drawing.between(0.125, 0.25), distance));
  });
}

std::vector<SelfPatchCase> collected(const std::string& only) {
  Collection all(only);
  add_meeting(all);
  add_embedded(all);
  return all.take();
}

}  // namespace

std::array<double, 4> PairedSheets::parameters(const std::array<double, 2>& on_half) const {
  const double first = on_half[0];
  if (involution == Involution::fold) return {first, on_half[1], 2 * centre - first, on_half[1]};
  return {first, first * on_half[1], first * on_half[1], first};
}

bool PairedSheets::is_pinch_point(const std::array<double, 2>& on_half) const {
  constexpr double reach = 1e-9;
  return involution == Involution::fold ? std::abs(on_half[0] - centre) < reach : std::abs(on_half[1] - 1) < reach;
}

std::vector<SelfPatchCase> self_patch_cases() { return collected({}); }

std::vector<SelfPatchCase> self_patch_cases(const std::string& family) { return collected(family); }

TrueIntersection true_self_intersection(const SelfPatchCase& patch) {
  if (!patch.sheets) return {patch.patches.planted.value_or(PatchCounts{}), {}};
  TrueIntersection result = plane_intersection(patch.sheets->half);
  for (const TrueComponent& component : result.components)
    if (component.kind == TrueComponent::Kind::curve)
      for (const auto& end : {component.parameters.front(), component.parameters.back()})
        if (patch.sheets->is_pinch_point(end)) ++result.counts.singular;
  return result;
}

}  // namespace eliminant::test
