// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include <doctest/doctest.h>

#include <intersect/curve_helpers.hpp>

#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/symbolic/geometry/nurbs.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::Interval;
using symbolic::ParameterRegion;
using symbolic::ParametricCurve;
using symbolic::ParametricSurface;
using symbolic::RationalSurface;
using symbolic::UnivariatePolynomial;

namespace {

using Kind = RationalSurface::Kind;
using Region = std::optional<ParameterRegion>;

CurveResult meet(const ParametricCurve& curve, const Surface& surface, long digits = 15,
                 Engine engine = Engine::automatic) {
  Options options;
  options.digits = digits;
  options.engine = engine;
  const Context context;
  return intersect_curve_surface({curve, surface}, options, context);
}

ParametricSurface surface_of(Kind kind, const std::vector<Polynomial>& coordinates, const Region& region = {}) {
  return {{{RationalSurface(kind, coordinates), region}}};
}

/// In the parameters s, t, and u where the surface is triangular.
std::vector<Polynomial> parsed(Kind kind, std::initializer_list<const char*> coordinates) {
  static const std::vector<std::string> three{"s", "t", "u"};
  static const std::vector<std::string> two{"s", "t"};
  std::vector<Polynomial> result;
  for (const char* text : coordinates)
    result.push_back(symbolic::parse_polynomial(text, kind == Kind::triangular ? three : two));
  return result;
}

ParametricSurface triangular(std::initializer_list<const char*> coordinates, const Region& region = {}) {
  return surface_of(Kind::triangular, parsed(Kind::triangular, coordinates), region);
}

ParametricSurface tensor(std::initializer_list<const char*> coordinates, const Region& region = {}) {
  return surface_of(Kind::tensor_product, parsed(Kind::tensor_product, coordinates), region);
}

Surface equation(std::string_view text) {
  static const std::vector<std::string> names{"x", "y", "z"};
  return ImplicitSurface{symbolic::parse_polynomial(text, names)};
}

Region rectangle(const Interval& first, const Interval& second) { return ParameterRegion{{first, second}, false}; }
Region unit_square() { return rectangle({0, 1}, {0, 1}); }
Region unit_triangle() { return ParameterRegion{{Interval{0, 1}, Interval{0, 1}}, true}; }

const char* const torus[4] = {"-s^2*t^2 - 3*s^2 + t^2 + 3", "2*s*t^2 + 6*s", "2*s^2*t + 2*t",
                              "s^2*t^2 + s^2 + t^2 + 1"};

ParametricSurface torus_surface() { return tensor({torus[0], torus[1], torus[2], torus[3]}); }
ParametricSurface sphere() { return triangular({"s^2 + t^2 + u^2", "2*s*u", "2*s*t", "s^2 - t^2 - u^2"}); }
ParametricSurface lonlat_sphere(const Region& region = {}) {
  return tensor({"-2*s^2*t + 2*t", "4*s*t", "-s^2*t^2 + s^2 - t^2 + 1", "s^2*t^2 + s^2 + t^2 + 1"}, region);
}
ParametricSurface cylinder() { return tensor({"1 - s^2", "2*s", "s^2*t + t", "s^2 + 1"}); }
ParametricSurface cone() { return tensor({"-s^2*t + t", "2*s*t", "s^2*t + t", "s^2 + 1"}); }

/// A factor of the condition on t, and its multiplicity.
using Factors = std::vector<std::pair<std::string, unsigned long>>;

/// The solutions are the roots of these factors with these multiplicities, and t = infinity as often as is said.
void check_roots(const CurveResult& result, const Factors& factors, unsigned long at_infinity = 0) {
  unsigned long total = at_infinity;
  std::vector<std::size_t> found(factors.size());
  std::vector<UnivariatePolynomial> polynomials;
  for (const auto& [text, multiplicity] : factors) {
    UnivariatePolynomial factor;
    for (const Polynomial::Term& term : in_t(text).terms())
      fmpz_poly_set_coeff_fmpz(factor.get(), static_cast<long>(term.exponents[0]), term.coefficient.numerator().get());
    total += multiplicity * static_cast<unsigned long>(factor.degree());
    polynomials.push_back(std::move(factor));
  }
  CHECK(complete_audit_holds(result, total));
  unsigned long infinite = 0;
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    const CurveSolution& s = result.solutions[i];
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(may_agree(s.t, result.solutions[j].t));
    if (is_infinite(s.t)) {
      infinite += s.multiplicity;
      continue;
    }
    long matches = 0;
    for (std::size_t k = 0; k < factors.size(); ++k) {
      const bridge::ComplexBall value = evaluate(polynomials[k], s.t.value()->ball, check_bits);
      if (acb_contains_zero(value.get()) == 0 || s.multiplicity != factors[k].second) continue;
      ++matches;
      ++found[k];
    }
    CHECK(matches == 1);
  }
  CHECK(infinite == at_infinity);
  for (std::size_t k = 0; k < factors.size(); ++k) CHECK(found[k] == static_cast<std::size_t>(polynomials[k].degree()));
}

/// The values of homogeneous polynomials at parameters of which some may be infinite.
std::vector<bridge::ComplexBall> surface_point(const RationalSurface& surface, const std::vector<Parameter>& at) {
  std::vector<bridge::ComplexBall> point;
  for (const Polynomial& f : surface.coordinates()) {
    bridge::ComplexBall sum;
    for (const Polynomial::Term& term : f.terms()) {
      bridge::ComplexBall product;
      acb_set_fmpq(product.get(), term.coefficient.get(), check_bits);
      bool present = true;
      for (std::size_t k = 0; k < at.size(); ++k) {
        if (!at[k]) {
          present = present && term.exponents[k] == static_cast<unsigned long>(surface.bidegree()[k]);
          continue;
        }
        bridge::ComplexBall power;
        acb_pow_ui(power.get(), at[k]->ball.get(), term.exponents[k], check_bits);
        acb_mul(product.get(), product.get(), power.get(), check_bits);
      }
      if (present) acb_add(sum.get(), sum.get(), product.get(), check_bits);
    }
    point.push_back(std::move(sum));
  }
  return point;
}

/// Every solution is on the curve and, at each of its parameters, on the surface; the multiplicities add up.
bool complete(const CurveResult& result, const ParametricCurve& curve, const RationalSurface& surface,
              unsigned long degree) {
  const symbolic::RationalCurve& map = curve.pieces[0].map;
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    const CurveSolution& s = result.solutions[i];
    const auto point = balls(s.point);
    if (!may_be_same_point(point_at(map, *s.t), point) || s.surface_parameters.empty()) return false;
    for (const std::vector<Parameter>& parameters : s.surface_parameters)
      if (!may_be_same_point(surface_point(surface, parameters), point)) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (may_agree(s.t, result.solutions[j].t)) return false;
  }
  return complete_audit_holds(result, degree * static_cast<unsigned long>(map.degree()));
}

bool same_parameters(const CurveResult& a, const CurveResult& b, bool curve_reversed = false) {
  if (a.solutions.size() != b.solutions.size()) return false;
  return std::all_of(a.solutions.begin(), a.solutions.end(), [&](const CurveSolution& s) {
    return std::count_if(b.solutions.begin(), b.solutions.end(), [&](const CurveSolution& other) {
             return may_agree(s.t, curve_reversed ? reversed(other.t) : other.t) &&
                    s.multiplicity == other.multiplicity && s.reality == other.reality;
           }) == 1;
  });
}

/// How many solutions are at this t, with this multiplicity.
long count_of(const CurveResult& result, const Rational& t, unsigned long multiplicity) {
  return std::count_if(result.solutions.begin(), result.solutions.end(), [&](const CurveSolution& s) {
    return is_t(s, t) && s.multiplicity == multiplicity && s.certified && s.reality == Reality::real;
  });
}

/// All of a group of parameters, up to the factor of homogeneous ones.
bool are_parameters(const std::vector<Parameter>& found, std::vector<Rational> expected, long radius_exponent) {
  if (found.size() != expected.size()) return false;
  if (expected.size() == 3) {
    std::size_t last = 2;
    while (expected[last].is_zero()) --last;
    const Rational unit = expected[last];
    for (Rational& value : expected) value = value / unit;
  }
  for (std::size_t k = 0; k < expected.size(); ++k)
    if (!is_value(found[k], expected[k], radius_exponent)) return false;
  return true;
}

Polynomial random_coordinate(Draw& draw, Kind kind, std::array<long, 2> degrees, long size) {
  std::vector<Polynomial::Term> terms;
  for (long i = 0; i <= degrees[0]; ++i)
    for (long j = 0; j <= (kind == Kind::triangular ? degrees[0] - i : degrees[1]); ++j) {
      std::vector<unsigned long> exponents{static_cast<unsigned long>(i), static_cast<unsigned long>(j)};
      if (kind == Kind::triangular) exponents.push_back(static_cast<unsigned long>(degrees[0] - i - j));
      terms.push_back({Rational(draw.between(-size, size)), exponents});
    }
  return Polynomial::from_terms(kind == Kind::triangular ? 3 : 2, terms);
}

/// Taylor's polynomial of f at t = c, of degree below the order.
Polynomial jet(const Polynomial& f, const Rational& c, unsigned long order) {
  const std::vector<Polynomial> there{t_variable() + t_constant(c)};
  const std::vector<Polynomial> back{t_variable() - t_constant(c)};
  std::vector<Polynomial::Term> kept;
  for (const Polynomial::Term& term : f.compose(there).terms())
    if (term.exponents[0] < order) kept.push_back(term);
  return Polynomial::from_terms(1, kept).compose(back);
}

/// A surface and a curve that touches it at t = c to this order, in the point of these parameters.
struct Contact {
  std::vector<Polynomial> surface;
  std::vector<Polynomial> curve;
  /// The order is not larger.
  bool exact = false;
};

Contact contact(Draw& draw, Kind kind, std::array<long, 2> degrees, const std::vector<Rational>& parameters,
                const Rational& c, unsigned long order) {
  Contact result;
  std::vector<Polynomial> path;
  for (const Rational& value : parameters)
    path.push_back(t_constant(value) + Rational(draw.between(-2, 2)) * (t_variable() - t_constant(c)));
  std::vector<std::vector<Rational>> frame(4);
  for (std::size_t k = 0; k < 4; ++k) {
    const Polynomial f = random_coordinate(draw, kind, degrees, 9);
    const Rational away(draw.between(-9, 9));
    result.surface.push_back(f);
    result.curve.push_back(jet(f.compose(path), c, order) + away * power(t_variable() - t_constant(c), order));
    frame[0].push_back(value_at(f, parameters));
    frame[1].push_back(value_at(f.derivative(0), parameters));
    frame[2].push_back(value_at(f.derivative(1), parameters));
    // The curve leaves the surface by the difference of the jets.
    const Polynomial rest = f.compose(path) - result.curve.back();
    const std::vector<Polynomial> there{t_variable() + t_constant(c)};
    frame[3].push_back(value_at(exact_quotient(rest.compose(there), power(t_variable(), order)), {Rational(0)}));
  }
  // With three homogeneous parameters the tangent plane is spanned by two derivatives and the point where the third
  // parameter is not zero.
  result.exact = !determinant(frame).is_zero();
  return result;
}

struct Family {
  Kind kind;
  std::array<long, 2> degrees;
  int trials;
};

unsigned long degree_of(const Family& family) {
  return static_cast<unsigned long>(family.kind == Kind::triangular ? family.degrees[0] * family.degrees[0]
                                                                    : 2 * family.degrees[0] * family.degrees[1]);
}

}  // namespace

TEST_CASE("Example 1 of the moving surfaces paper: two triple points, seven simple ones and two at infinity") {
  const ParametricSurface surface = triangular({"s^3 + t^2*u", "s^2*t + t^2*u", "s^3 + t^3", "s^2*u + t^2*u"});
  const CurveResult result = meet(map_of({"1", "t", "t^2", "t^3"}), surface, 31);
  check_roots(result, {{"t - 1", 3}, {"t + 1", 3}, {"t^7 + 3*t^6 - t^5 - t^3 + t^2 - 2*t + 1", 1}}, 2);
  CHECK(result.counts.real == 4);
  REQUIRE(result.solutions.size() == 10);
  CHECK(result.solutions.front().t.value()->real.substr(0, 30) == "-3.339829813165729118495679368");
  CHECK(is_infinite(result.solutions.back().t));
  CHECK(result.solutions.back().point[3].real == "1");
  CHECK(count_of(result, 1, 3) == 1);
  CHECK(count_of(result, -1, 3) == 1);
}

TEST_CASE("Example 2 of the moving surfaces paper: six simple points of a sphere") {
  const CurveResult result = meet(map_of({"1", "t", "t^2", "t^3"}), sphere(), 31);
  check_roots(result, {{"t^6 + t^4 + t^2 - 1", 1}});
  CHECK(result.counts.real == 2);
  const auto real = std::find_if(result.solutions.begin(), result.solutions.end(),
                                 [](const CurveSolution& s) { return s.reality == Reality::real; });
  REQUIRE(real != result.solutions.end());
  CHECK(real->t.value()->real.substr(0, 30) == "-0.737352705760327675201759650");
}

TEST_CASE("Example 3 of the moving surfaces paper: the image of a contracted line is a simple point") {
  const CurveResult result = meet(map_of({"1", "0", "0", "t"}), sphere());
  check_roots(result, {{"t - 1", 1}, {"t + 1", 1}});
}

TEST_CASE("Curves on a torus, a cylinder, a cone and a sphere covered twice") {
  check_roots(meet(map_of({"t", "0", "0", "1"}), torus_surface()), {{"t^4 - 10*t^2 + 9", 1}});
  check_roots(meet(map_of({"t", "0", "1", "1"}), torus_surface()), {{"t^2 - 4", 2}});
  check_roots(meet(map_of({"1", "t", "0", "1"}), torus_surface()), {{"t", 2}, {"t^2 - 8", 1}});
  check_roots(meet(map_of({"t", "t^2", "t^3 - 1", "1"}), torus_surface()),
              {{"t^12 + 2*t^10 - 4*t^9 + 3*t^8 - 4*t^7 + 14*t^6 - 4*t^5 - 7*t^4 - 16*t^3 - 8*t^2 + 16", 1}});
  check_roots(meet(map_of({"t", "0", "3*t + 1", "1"}), cylinder()), {{"t^2 - 1", 1}});
  check_roots(meet(map_of({"t", "0", "0", "1"}), cone()), {{"t", 2}});
  check_roots(meet(map_of({"t", "0", "1", "1"}), cone()), {{"t^2 - 1", 1}});
  check_roots(meet(map_of({"t", "0", "0", "1"}), lonlat_sphere()), {{"t^2 - 1", 1}});
  check_roots(meet(map_of({"0", "0", "t", "1"}), lonlat_sphere()), {{"t^2 - 1", 1}});
}

TEST_CASE("Curves inside a surface: the equator of a torus and a ruling of a cylinder") {
  for (const auto& [curve, surface] : {std::pair{map_of({"3 - 3*t^2", "6*t", "0", "t^2 + 1"}), torus_surface()},
                                       std::pair{map_of({"1", "0", "t", "1"}), cylinder()}}) {
    const CurveResult result = meet(curve, surface);
    CHECK(result.status == Status::infinite);
    CHECK(result.rest_status == Status::certified);
    REQUIRE(result.overlap.size() == 1);
    CHECK_FALSE(result.overlap[0].t);
    CHECK(result.solutions.empty());
  }
}

TEST_CASE("A sphere by its equation, by a conic map and by longitude and latitude: the same roots") {
  // This one has x and w exchanged.
  const ParametricSurface conic = triangular({"s^2 - t^2 - u^2", "2*s*u", "2*s*t", "s^2 + t^2 + u^2"});
  for (const auto& curve :
       {map_of({"t", "1/2", "1/3", "1"}), map_of({"t", "0", "1", "1"}), map_of({"t", "t^2 - 1", "t^3/2", "1"}),
        map_of({"2*t", "1 - t", "t^2", "1 + t^2"}), map_of({"t", "t/2", "1 - t^2", "2"})}) {
    const CurveResult expected = meet(curve, equation("x^2 + y^2 + z^2 - 1"));
    CHECK(complete_audit_holds(expected, 2 * static_cast<unsigned long>(curve.pieces[0].map.degree())));
    for (const ParametricSurface& surface : {conic, lonlat_sphere()}) {
      const CurveResult result = meet(curve, surface);
      CHECK(complete_audit_holds(result, expected.counts.expected));
      CHECK(same_parameters(expected, result));
    }
  }
}

TEST_CASE("Contact of known order at rational parameters of random surfaces: every solution, and invariance") {
  Draw draw(3);
  long exact = 0;
  for (const Family& family : {Family{Kind::tensor_product, {1, 1}, 60}, Family{Kind::tensor_product, {1, 2}, 30},
                               Family{Kind::tensor_product, {2, 2}, 25}, Family{Kind::tensor_product, {3, 1}, 15},
                               Family{Kind::tensor_product, {3, 3}, 3}, Family{Kind::triangular, {1, 0}, 20},
                               Family{Kind::triangular, {2, 0}, 30}, Family{Kind::triangular, {3, 0}, 10}})
    for (int trial = 0; trial < family.trials; ++trial) {
      CAPTURE(static_cast<int>(family.kind));
      CAPTURE(family.degrees[0]);
      CAPTURE(family.degrees[1]);
      CAPTURE(trial);
      const auto order = static_cast<unsigned long>(family.degrees[0] == 3 ? 1 : draw.between(1, 3));
      const Rational c(draw.between(-2, 2));
      std::vector<Rational> parameters{Rational(draw.between(-3, 3)) / Rational(2), Rational(draw.between(-3, 3))};
      if (family.kind == Kind::triangular) parameters.emplace_back(1);
      const Contact made = contact(draw, family.kind, family.degrees, parameters, c, order);
      if (!made.exact) continue;
      ++exact;
      const ParametricCurve curve = map_of(made.curve);
      const ParametricSurface surface = surface_of(family.kind, made.surface);
      const CurveResult result = meet(curve, surface);
      CHECK(complete(result, curve, surface.pieces[0].map, degree_of(family)));
      CHECK(count_of(result, c, order) == 1);
      CHECK(std::count_if(result.solutions.begin(), result.solutions.end(), [&](const CurveSolution& s) {
              return is_t(s, c) && s.surface_parameters.size() == 1 &&
                     are_parameters(s.surface_parameters[0], parameters, s.radius_exponent);
            }) == 1);
      if (trial % 3 == 0) CHECK(same_parameters(result, meet(map_of(reversed(made.curve)), surface), true));
      if (trial % 3 == 1) {
        const Rational scale = power_of_two(trial % 2 == 0 ? 20 : -20);
        const Rational shift = power_of_two(20);
        std::vector<Polynomial> coordinates = made.surface;
        for (std::size_t k = 0; k < 3; ++k)
          coordinates[k] = scale * coordinates[k] + (k % 2 == 0 ? shift : -shift) * coordinates[3];
        CHECK(same_parameters(result,
                              meet(map_of(moved(made.curve, scale, shift)), surface_of(family.kind, coordinates))));
      }
      if (trial % 3 == 2) {
        const std::size_t count = parameters.size();
        std::vector<Polynomial> exchanged;
        const std::vector<Polynomial> images =
            count == 2
                ? std::vector{Polynomial::variable(2, 1), Polynomial::variable(2, 0)}
                : std::vector{Polynomial::variable(3, 1), Polynomial::variable(3, 2), Polynomial::variable(3, 0)};
        for (const Polynomial& f : made.surface) exchanged.push_back(f.compose(images));
        CHECK(same_parameters(result, meet(curve, surface_of(family.kind, exchanged))));
      }
    }
  CHECK(exact >= 150);
}

TEST_CASE("Points on the border of a patch, in its corners, and within 2^-27 of them") {
  Draw draw(4);
  for (const std::array<long, 2>& degrees : {std::array<long, 2>{1, 1}, {2, 2}, {3, 1}, {3, 3}})
    for (const long exponent : {0L, 13L, 20L, 27L})
      for (const bool outside : {false, true}) {
        const Rational push = exponent == 0 ? Rational(0) : power_of_two(-exponent);
        const Rational beside = outside ? -push : push;
        const Rational middle = Rational(1) / Rational(2);
        for (const std::vector<Rational>& at : {std::vector<Rational>{beside, middle},
                                                {Rational(1) - beside, middle},
                                                {middle, beside},
                                                {middle, Rational(1) - beside},
                                                {beside, Rational(1) - beside}}) {
          CAPTURE(degrees[0]);
          CAPTURE(degrees[1]);
          CAPTURE(at[0].to_string());
          CAPTURE(at[1].to_string());
          const Contact made = contact(draw, Kind::tensor_product, degrees, at, 1, 1);
          if (!made.exact) continue;
          const bool within = exponent == 0 || !outside;
          const CurveResult result =
              meet(map_of(made.curve, Interval{1, 2}), surface_of(Kind::tensor_product, made.surface, unit_square()));
          CHECK(result.status == Status::certified);
          CHECK(count_of(result, 1, 1) == (within ? 1 : 0));
          CHECK(result.counts.inside == result.solutions.size());
          // A domain of the curve that ends just before.
          const CurveResult before = meet(map_of(made.curve, Interval{0, Rational(1) - power_of_two(-40)}),
                                          surface_of(Kind::tensor_product, made.surface, unit_square()));
          CHECK(before.status == Status::certified);
          CHECK(count_of(before, 1, 1) == 0);
        }
      }
}

TEST_CASE("Points on the border of a triangular patch, in its corners, and beside them") {
  Draw draw(5);
  for (const long degree : {1L, 2L})
    for (const long exponent : {0L, 13L, 27L})
      for (const bool outside : {false, true}) {
        const Rational push = exponent == 0 ? Rational(0) : power_of_two(-exponent);
        const Rational beside = outside ? -push : push;
        const Rational third = Rational(1) / Rational(3);
        for (const std::vector<Rational>& at : {std::vector<Rational>{beside, third, Rational(1) - third - beside},
                                                {third, beside, Rational(1) - third - beside},
                                                {third, Rational(1) - third - beside, beside},
                                                {Rational(1) - beside - beside, beside, beside}}) {
          CAPTURE(degree);
          CAPTURE(at[0].to_string());
          CAPTURE(at[1].to_string());
          const Contact made = contact(draw, Kind::triangular, {degree, 0}, at, 0, 1);
          const CurveResult all = meet(map_of(made.curve), surface_of(Kind::triangular, made.surface));
          if (count_of(all, 0, 1) != 1) continue;
          const bool within = exponent == 0 || !outside;
          const CurveResult result = meet(map_of(made.curve, Interval{0, power_of_two(-30)}),
                                          surface_of(Kind::triangular, made.surface, unit_triangle()));
          CHECK(result.status == Status::certified);
          CHECK(count_of(result, 0, 1) == (within ? 1 : 0));
        }
      }
}

TEST_CASE("Lines through two sheets of a surface: every real preimage") {
  // Whitney's umbrella, with the double line x = y = 0.
  const ParametricSurface umbrella = tensor({"s*t", "s", "t^2", "1"});
  const CurveResult result = meet(map_of({"t", "2*t", "1", "1"}), umbrella);
  REQUIRE(result.status == Status::certified);
  CHECK(count_of(result, 0, 2) == 1);
  REQUIRE(result.solutions[0].surface_parameters.size() == 2);
  CHECK(are_parameters(result.solutions[0].surface_parameters[0], {0, -1}, -14));
  CHECK(are_parameters(result.solutions[0].surface_parameters[1], {0, 1}, -14));
  // Only one of the sheets belongs to the patch, whatever the engine.
  const ParametricSurface half = tensor({"s*t", "s", "t^2", "1"}, rectangle({-2, 2}, {0, 2}));
  for (const Engine engine : {Engine::automatic, Engine::box, Engine::pencil, Engine::exact}) {
    const CurveResult trimmed = meet(map_of({"t", "2*t", "1", "1"}, Interval{-1, 1}), half, 15, engine);
    CHECK(trimmed.status == Status::certified);
    CHECK(count_of(trimmed, 0, 1) == 1);
  }
  const ParametricSurface none = tensor({"s*t", "s", "t^2", "1"}, rectangle({-2, 2}, {2, 3}));
  const CurveResult nothing = meet(map_of({"t", "2*t", "1", "1"}, Interval{-1, 1}), none);
  CHECK(nothing.status == Status::certified);
  CHECK(nothing.solutions.empty());
}

TEST_CASE("A map that covers its surface twice: one solution with both parameters") {
  const ParametricSurface surface = tensor({"s^2", "t", "s^4 - 3*t + s^2", "1"});
  const CurveResult result = meet(map_of({"2", "t", "3", "1"}), surface);
  CHECK(complete_audit_holds(result, 2));
  CHECK(count_of(result, 1, 1) == 1);
  CHECK(result.solutions[0].surface_parameters.size() == 2);
}

TEST_CASE("A solution on a seam of a NURBS surface or of a curve is listed once") {
  const symbolic::KnotVector across{1, {0, 0, 1, 2, 2}};
  const symbolic::KnotVector along{1, {0, 0, 1, 1}};
  const ParametricSurface roof = symbolic::nurbs_surface(
      {across, along}, {{{0, 0, 0, 1}, {0, 1, 0, 1}}, {{1, 0, 1, 1}, {1, 1, 1, 1}}, {{2, 0, 0, 1}, {2, 1, 0, 1}}});
  const CurveResult ridge = meet(map_of({"1", "1/3", "t", "1"}), roof);
  CHECK(ridge.status == Status::certified);
  CHECK(ridge.solutions.size() == 1);
  CHECK(count_of(ridge, 1, 1) == 1);
  const CurveResult across_both = meet(map_of({"t", "1/3", "1/2", "1"}), roof);
  CHECK(across_both.solutions.size() == 2);
  CHECK(count_of(across_both, Rational(1) / Rational(2), 1) == 1);
  CHECK(count_of(across_both, Rational(3) / Rational(2), 1) == 1);
  ParametricCurve pieces = map_of({"t", "1/3", "t - 1", "1"}, Interval{0, 1});
  pieces.pieces.push_back(map_of({"t", "1/3", "t - 1", "1"}, Interval{1, 2}).pieces[0]);
  const CurveResult seam = meet(pieces, equation("z"));
  CHECK(seam.solutions.size() == 1);
  CHECK(count_of(seam, 1, 1) == 1);
}

TEST_CASE("A line in a bilinear patch: the part between the borders") {
  const ParametricSurface patch = tensor({"s", "t", "s*t", "1"}, unit_square());
  const CurveResult result = meet(map_of({"t", "1/4", "t/4", "1"}), patch);
  CHECK(result.status == Status::infinite);
  REQUIRE(result.overlap.size() == 1);
  REQUIRE(result.overlap[0].t);
  CHECK(is_value((*result.overlap[0].t)[0], 0, -14));
  CHECK(is_value((*result.overlap[0].t)[1], 1, -14));
  const CurveResult shorter = meet(map_of({"t", "1/4", "t/4", "1"}, Interval{Rational(1) / Rational(2), 3}), patch);
  REQUIRE(shorter.overlap.size() == 1);
  REQUIRE(shorter.overlap[0].t);
  CHECK(is_value((*shorter.overlap[0].t)[0], Rational(1) / Rational(2), -14));
  CHECK(is_value((*shorter.overlap[0].t)[1], 1, -14));
}

TEST_CASE("Surfaces by an equation: tangents, asymptotic lines and infinity") {
  const CurveResult tangent = meet(map_of({"t", "0", "1", "1"}), equation("x^2 + y^2 + z^2 - 1"));
  check_roots(tangent, {{"t", 2}});
  const CurveResult flex = meet(map_of({"t", "0", "0", "1"}), equation("z - x^3 + x*y^2 - y"));
  check_roots(flex, {{"t", 3}});
  const CurveResult infinite = meet(map_of({"t", "0", "1", "1"}), equation("z^2 - x*z - 4"));
  check_roots(infinite, {{"t + 3", 1}}, 1);
  const CurveResult nothing = meet(map_of({"t", "0", "0", "1"}, Interval{0, 1}), equation("x - 2"));
  CHECK(nothing.status == Status::certified);
  CHECK(nothing.solutions.empty());
}

TEST_CASE("A single point is no curve, a constant no surface, and a plane curve does not meet a surface") {
  CHECK_THROWS_AS(meet(map_of({"1", "2", "3", "1"}), sphere()), InvalidInput);
  CHECK_THROWS_AS(meet(map_of({"t", "0", "1"}), sphere()), InvalidInput);
  CHECK_THROWS_AS(meet(map_of({"t", "0", "0", "1"}), equation("1")), InvalidInput);
}
