// SPDX-License-Identifier: BSD-3-Clause
//
// Lines against surfaces of revolution as NURBS and against the Utah teapot: the answers are those of the implicit
// equations, or of the exact engine where the surface has none that is simple.
//   ELIMINANT_ALL_FAMILIES   set: 1000 lines against each; else the first ones, where the exact engine answers
#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/symbolic/geometry/nurbs.hpp>
#include <intersect/curve_helpers.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using symbolic::ControlPoint;
using symbolic::KnotVector;
using symbolic::ParametricSurface;

namespace {

unsigned long lines_for_exact_engine() {
  return std::getenv("ELIMINANT_ALL_FAMILIES") != nullptr ? 1000 : 30;  // NOLINT(concurrency-mt-unsafe)
}

using Point = std::array<Rational, 3>;

/// From the first point, t = 0, to the second, t = 1.
struct Segment {
  Point from;
  Point to;

  /// A coordinate as a polynomial in t.
  Polynomial coordinate(std::size_t k) const { return t_constant(from[k]) + (to[k] - from[k]) * t_variable(); }
  symbolic::ParametricCurve curve() const {
    return map_of({coordinate(0), coordinate(1), coordinate(2), t_constant(1)}, symbolic::Interval{0, 1});
  }
  std::string text() const {
    std::string result;
    for (const Point& point : {from, to})
      for (const Rational& number : point) result += number.to_string() + " ";
    return result;
  }
};

/// Through a box of this half width, with ten binary digits; each fifth with ends on a coarse grid, which brings seams,
/// poles, tangents and lines inside the surface.
Segment random_segment(Draw& draw, unsigned long index, long half_width) {
  const bool coarse = index % 5 == 4;
  const long parts = coarse ? 1 : 1024;
  for (;;) {
    Segment segment;
    for (Point* point : {&segment.from, &segment.to})
      for (Rational& number : *point)
        number = Rational(draw.between(-half_width * parts, half_width * parts)) / Rational(parts);
    if (segment.from != segment.to) return segment;
  }
}

CurveResult solve(const Segment& segment, const ParametricSurface& surface, Engine engine = Engine::automatic) {
  Options options;
  options.engine = engine;
  const Context context;
  return intersect_curve_surface({segment.curve(), surface}, options, context);
}

bool is_proven(const CurveResult& result) {
  const bool listed = std::all_of(result.solutions.begin(), result.solutions.end(),
                                  [](const CurveSolution& s) { return s.certified && s.inside; });
  return listed && (result.status == Status::certified ||
                    (result.status == Status::infinite && result.rest_status == Status::certified));
}

std::string summary(const CurveResult& result) {
  std::string text = "status " + std::to_string(static_cast<int>(result.status));
  for (const CurveSolution& solution : result.solutions)
    text += "; t " + (*solution.t)->real + " x" + std::to_string(solution.multiplicity);
  for (const std::string& warning : result.warnings) text += "; " + warning;
  return text;
}

// Surfaces of revolution.

/// One weight for the ends of arcs and one for their middles; alternatives that make the same arcs, or nearly so.
struct ArcWeights {
  std::array<Rational, 3> quarter;  ///< of a quarter turn; the next one has them in the other order
};
const ArcWeights rational_weights{{Rational(1), Rational(1), Rational(2)}};
/// The square root of 1/2 in 53 bits: arcs that are no circles.
const ArcWeights rounded_weights{{Rational(1), symbolic::parse_number("0x1.6a09e667f3bcdp-1"), Rational(1)}};

/// (w a, w b, w) along quarters of the unit circle from (1, 0).
std::vector<ControlPoint> arc(const ArcWeights& weights, std::size_t quarters) {
  const std::array<std::array<long, 2>, 8> corners{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  std::vector<ControlPoint> points;
  for (std::size_t i = 0; i <= 2 * quarters; ++i) {
    const auto [a, b] = corners[i % 8];
    const Rational& weight = weights.quarter[i % 4 == 3 ? 1 : i % 4];
    points.push_back({weight * Rational(a), weight * Rational(b), weight});
  }
  return points;
}

KnotVector arc_knots(long quarters) {
  KnotVector result{2, {}};
  for (int i = 0; i < 3; ++i) result.knots.emplace_back(0);
  for (long k = 1; k < quarters; ++k) result.knots.insert(result.knots.end(), 2, Rational(k));
  for (int i = 0; i < 3; ++i) result.knots.emplace_back(quarters);
  return result;
}

/// The profile (w r, w z, w) turned about the z axis.
ParametricSurface revolved(const KnotVector& knots, const std::vector<ControlPoint>& profile,
                           const ArcWeights& weights) {
  std::vector<std::vector<ControlPoint>> rows;
  for (const ControlPoint& p : profile) {
    rows.emplace_back();
    for (const ControlPoint& turn : arc(weights, 4))
      rows.back().push_back({p[0] * turn[0], p[0] * turn[1], p[1] * turn[2], p[2] * turn[2]});
  }
  return symbolic::nurbs_surface({knots, arc_knots(4)}, rows);
}

constexpr long torus_radius = 3;
constexpr long cylinder_height = 2;

ParametricSurface torus(const ArcWeights& weights) {
  std::vector<ControlPoint> profile = arc(weights, 4);
  for (ControlPoint& p : profile) p[0] = p[0] + Rational(torus_radius) * p[2];
  return revolved(arc_knots(4), profile, weights);
}

/// From pole to pole: half a turn in the plane of r and z.
ParametricSurface sphere(const ArcWeights& weights) {
  std::vector<ControlPoint> profile = arc(weights, 2);
  for (ControlPoint& p : profile) {
    const Rational height = p[0];
    p[0] = p[1];
    p[1] = height;
  }
  return revolved(arc_knots(2), profile, weights);
}

ParametricSurface cylinder(const ArcWeights& weights) {
  const KnotVector straight{1, {0, 0, 1, 1}};
  return revolved(straight, {{1, 0, 1}, {1, cylinder_height, 1}}, weights);
}

enum class Solid { torus, sphere, cylinder };

/// The implicit equation along the segment.
Polynomial equation_along(Solid solid, const Segment& segment) {
  const Polynomial x = segment.coordinate(0);
  const Polynomial y = segment.coordinate(1);
  const Polynomial z = segment.coordinate(2);
  const Polynomial round = x * x + y * y;
  if (solid == Solid::cylinder) return round - t_constant(1);
  if (solid == Solid::sphere) return round + z * z - t_constant(1);
  const long r2 = torus_radius * torus_radius;
  const Polynomial sum = round + z * z + t_constant(r2 - 1);
  return sum * sum - Rational(4 * r2) * round;
}

/// Whether a root of the equation lies on the segment and, of the cylinder, between its ends. Exactly.
bool counts(Solid solid, const Segment& segment, ParameterRoots& roots, std::size_t i) {
  if (roots.compare(i, 0) < 0 || roots.compare(i, 1) > 0) return false;
  if (solid != Solid::cylinder) return true;
  const Rational rise = segment.to[2] - segment.from[2];
  if (rise.is_zero()) return segment.from[2].sign() >= 0 && !(Rational(cylinder_height) < segment.from[2]);
  const int below = roots.compare(i, -segment.from[2] / rise) * rise.sign();
  const int above = roots.compare(i, (Rational(cylinder_height) - segment.from[2]) / rise) * rise.sign();
  return below >= 0 && above <= 0;
}

/// t = (-b +- sqrt(b^2 - 4 a c)) / (2 a), in balls; empty for no real one.
std::vector<bridge::RealBall> roots_of_quadratic(const symbolic::UnivariatePolynomial& f) {
  const symbolic::Integer a = f.coefficient(2);
  const symbolic::Integer b = f.coefficient(1);
  const symbolic::Integer discriminant = b * b - symbolic::Integer(4) * a * f.coefficient(0);
  if (discriminant.sign() < 0) return {};
  std::vector<bridge::RealBall> result(2);
  bridge::RealBall root;
  arb_sqrt_fmpz(root.get(), discriminant.get(), check_bits);
  for (std::size_t k = 0; k < 2; ++k) {
    if (k == 0) arb_neg(root.get(), root.get());
    if (k == 1) arb_neg(root.get(), root.get());
    arb_sub_fmpz(result[k].get(), root.get(), b.get(), check_bits);
    arb_div_fmpz(result[k].get(), result[k].get(), a.get(), check_bits);
    arb_mul_2exp_si(result[k].get(), result[k].get(), -1);
  }
  return result;
}

/// f, as a polynomial over Z.
symbolic::UnivariatePolynomial over_integers(const Polynomial& f) {
  const Polynomial primitive = f.primitive_part();
  std::vector<symbolic::Integer> coefficients(static_cast<std::size_t>(std::max(f.degree(0), 0L)) + 1);
  for (const Polynomial::Term& term : primitive.terms()) coefficients[term.exponents[0]] = term.coefficient.numerator();
  return symbolic::UnivariatePolynomial(coefficients);
}

struct Tally {
  unsigned long solutions = 0;
  unsigned long multiple = 0;
  unsigned long contained = 0;
};

void check_against_equation(Solid solid, const Segment& segment, const CurveResult& result, Tally& tally) {
  const symbolic::UnivariatePolynomial f = over_integers(equation_along(solid, segment));
  if (f.is_zero()) {
    // A ruling: inside for as long as it lies between the ends.
    ++tally.contained;
    const bool all_beyond = (segment.from[2].sign() < 0 && segment.to[2].sign() < 0) ||
                            (Rational(cylinder_height) < segment.from[2] && Rational(cylinder_height) < segment.to[2]);
    CHECK((result.overlap.empty() && result.solutions.empty()) == all_beyond);
    return;
  }
  CHECK(result.overlap.empty());
  const Context context;
  std::size_t expected = 0;
  if (f.degree() > 0) {
    ParameterRoots roots(f, Wanted::real, context);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (!counts(solid, segment, roots, i)) continue;
      ++expected;
      roots.refine(i, check_bits);
      const auto matches = std::count_if(result.solutions.begin(), result.solutions.end(), [&](const CurveSolution& s) {
        return acb_overlaps((*s.t)->ball.get(), roots.ball(i).get()) != 0 && s.multiplicity == roots.multiplicity(i);
      });
      CHECK(matches == 1);
      if (roots.multiplicity(i) > 1) ++tally.multiple;
    }
  }
  CHECK(result.solutions.size() == expected);
  tally.solutions += expected;
  if (f.degree() != 2) return;
  const std::vector<bridge::RealBall> closed = roots_of_quadratic(f);
  for (const CurveSolution& solution : result.solutions)
    CHECK(std::any_of(closed.begin(), closed.end(), [&](const bridge::RealBall& t) {
      return arb_overlaps((*solution.t)->ball.real(), t.get()) != 0;
    }));
}

bool same_solutions(const CurveResult& a, const CurveResult& b) {
  return a.solutions.size() == b.solutions.size() && a.overlap.size() == b.overlap.size() &&
         std::equal(a.solutions.begin(), a.solutions.end(), b.solutions.begin(),
                    [](const CurveSolution& x, const CurveSolution& y) {
                      return may_agree(x.t, y.t) && x.multiplicity == y.multiplicity;
                    });
}

void check_solid(Solid solid, const ParametricSurface& surface, std::uint64_t seed) {
  Draw draw(seed);
  Tally tally;
  constexpr unsigned long lines = 1000;
  for (unsigned long index = 0; index < lines; ++index) {
    const Segment segment = random_segment(draw, index, solid == Solid::torus ? 5 : 2);
    INFO(index, ": ", segment.text());
    const CurveResult result = solve(segment, surface);
    INFO(summary(result));
    CHECK(is_proven(result));
    check_against_equation(solid, segment, result, tally);
  }
  MESSAGE(lines, " lines, ", tally.solutions, " solutions, ", tally.multiple, " of them multiple, ", tally.contained,
          " lines in the surface");
  CHECK(tally.solutions > lines / 3);
}

/// The exact engine, which splits nothing by boxes, as the oracle.
void check_rounded(const ParametricSurface& surface, long half_width, std::uint64_t seed) {
  Draw draw(seed);
  unsigned long solutions = 0;
  const unsigned long lines = lines_for_exact_engine();
  for (unsigned long index = 0; index < lines; ++index) {
    const Segment segment = random_segment(draw, index, half_width);
    INFO(index, ": ", segment.text());
    const CurveResult result = solve(segment, surface);
    const CurveResult exact = solve(segment, surface, Engine::exact);
    INFO("auto ", summary(result));
    INFO("exact ", summary(exact));
    CHECK(is_proven(result));
    CHECK(is_proven(exact));
    CHECK(same_solutions(result, exact));
    solutions += result.solutions.size();
  }
  MESSAGE(lines, " lines, ", solutions, " solutions");
  CHECK(solutions > lines / 3);
}

// The teapot.

using Net = std::vector<std::vector<ControlPoint>>;

std::vector<Net> teapot() {
  std::ifstream file(ELIMINANT_TEST_DATA "/teapot.json");
  const auto data = nlohmann::json::parse(file);
  std::vector<Net> patches;
  for (const auto& indices : data.at("patches")) {
    Net& net = patches.emplace_back(4);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      ControlPoint point;
      for (const auto& number : data.at("points").at(indices[i].get<std::size_t>()))
        point.push_back(symbolic::parse_number(number.get<std::string>()));
      point.emplace_back(1);
      net[i / 4].push_back(point);
    }
  }
  return patches;
}

/// Whether a plane through the line has all control points on one side, or the segment ends before them along an axis.
bool clearly_apart(const Segment& segment, const Net& net) {
  const auto one_side = [&](const auto& distance) {
    bool positive = true;
    bool negative = true;
    for (const auto& row : net)
      for (const ControlPoint& point : row) {
        const int sign = distance(point).sign();
        positive = positive && sign > 0;
        negative = negative && sign < 0;
      }
    return positive || negative;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3;
    const std::size_t b = (k + 2) % 3;
    const auto from_plane = [&](const ControlPoint& p) {
      return (p[a] - segment.from[a]) * (segment.to[b] - segment.from[b]) -
             (p[b] - segment.from[b]) * (segment.to[a] - segment.from[a]);
    };
    if (one_side(from_plane)) return true;
    const Rational& low = std::min(segment.from[k], segment.to[k]);
    const Rational& high = std::max(segment.from[k], segment.to[k]);
    if (one_side([&](const ControlPoint& p) { return p[k] < low ? Rational(-1) : Rational(0); }) ||
        one_side([&](const ControlPoint& p) { return high < p[k] ? Rational(1) : Rational(0); }))
      return true;
  }
  return false;
}

/// From one side of the pot to another; each fifth within a coordinate plane, which two sorts of patches touch.
Segment teapot_segment(Draw& draw, unsigned long index) {
  Segment segment;
  const auto number = [&](long low, long high) { return Rational(draw.between(64 * low, 64 * high)) / Rational(64); };
  for (Point* point : {&segment.from, &segment.to}) *point = {number(-4, 4), number(-3, 3), number(0, 4)};
  // Apart from each other: the ends on opposite sides.
  const auto axis = static_cast<std::size_t>(draw.between(0, 2));
  segment.from[axis] = Rational(-5);
  segment.to[axis] = Rational(5);
  if (index % 5 == 4 && axis != 1) segment.from[1] = segment.to[1] = Rational(0);
  return segment;
}

}  // namespace

TEST_CASE("Lines against a NURBS torus: the roots of its equation") {
  check_solid(Solid::torus, torus(rational_weights), 11);
}

TEST_CASE("Lines against a NURBS sphere: the roots of its equation") {
  check_solid(Solid::sphere, sphere(rational_weights), 12);
}

TEST_CASE("Lines against a NURBS cylinder: the roots of its equation") {
  check_solid(Solid::cylinder, cylinder(rational_weights), 13);
}

TEST_CASE("Lines against surfaces of revolution with rounded weights: the exact engine") {
  SUBCASE("torus") { check_rounded(torus(rounded_weights), 5, 21); }
  SUBCASE("sphere") { check_rounded(sphere(rounded_weights), 2, 22); }
  SUBCASE("cylinder") { check_rounded(cylinder(rounded_weights), 2, 23); }
}

TEST_CASE("Lines against a NURBS sphere: an end on a seam, where all pieces know the parameter exactly") {
  // (9 t - 5) (t - 1) = 0; four pieces of the sphere have the point of t = 1.
  const Segment segment{{2, 1, -1}, {0, -1, 0}};
  const CurveResult result = solve(segment, sphere(rational_weights));
  CHECK(is_proven(result));
  REQUIRE(result.solutions.size() == 2);
  CHECK(is_t(result.solutions[0], Rational(5) / Rational(9)));
  CHECK(is_t(result.solutions[1], Rational(1)));
}

TEST_CASE("Lines against the teapot: the exact engine") {
  const std::vector<Net> patches = teapot();
  REQUIRE(patches.size() == 32);
  Draw draw(31);
  unsigned long solutions = 0;
  const unsigned long lines = lines_for_exact_engine();
  unsigned long compared = 0;
  for (unsigned long index = 0; index < lines; ++index) {
    const Segment segment = teapot_segment(draw, index);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      INFO("line ", index, ", patch ", k, ": ", segment.text());
      const ParametricSurface patch{{symbolic::bezier_patch(patches[k])}};
      const CurveResult result = solve(segment, patch);
      INFO("auto ", summary(result));
      CHECK(is_proven(result));
      solutions += result.solutions.size();
      if (clearly_apart(segment, patches[k])) {
        CHECK(result.solutions.empty());
        CHECK(result.overlap.empty());
        continue;
      }
      ++compared;
      const CurveResult exact = solve(segment, patch, Engine::exact);
      INFO("exact ", summary(exact));
      CHECK(is_proven(exact));
      CHECK(same_solutions(result, exact));
    }
  }
  MESSAGE(lines, " lines, ", solutions, " solutions on 32 patches, ", compared, " pairs that no plane separates");
  CHECK(solutions > lines);
}
