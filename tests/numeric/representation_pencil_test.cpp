// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/numeric/representation_pencil.hpp>

using namespace eliminant::numeric;
using Complex = std::complex<double>;

namespace {

/// Uniform in [0, 1), the same ones at every run (splitmix64).
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : state_(seed) {}
  double operator()() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
  }
  double operator()(double low, double high) { return low + (high - low) * (*this)(); }

 private:
  std::uint64_t state_;
};

using Point = Eigen::Vector4d;

/// A wavy patch over the unit square, its weights between 1/2 and 2 where it is rational.
SurfaceForms random_patch(Uniform& uniform, std::array<long, 2> degrees, bool rational) {
  CoordinateRows points(4, (degrees[0] + 1) * (degrees[1] + 1));
  for (long i = 0; i <= degrees[0]; ++i)
    for (long j = 0; j <= degrees[1]; ++j) {
      const double x = static_cast<double>(i) / static_cast<double>(degrees[0]);
      const double y = static_cast<double>(j) / static_cast<double>(degrees[1]);
      const double weight = rational ? uniform(0.5, 2) : 1;
      points.col(i * (degrees[1] + 1) + j) =
          weight * Point(x + uniform(-0.1, 0.1), y + uniform(-0.1, 0.1), uniform(-0.6, 0.6), 1);
    }
  return bezier_patch_forms(points, degrees);
}

CurveForms line(const Point& a, const Point& b) {
  CoordinateRows points(4, 2);
  points << a, b;
  return bezier_curve_forms(points);
}

/// With derivatives by s and t, whose homogeneous pairs are (s : 1 - s).
PointJet<double> at(const SurfaceForms& patch, double s, double t) {
  // Divided by (1 - s)^m (1 - t)^n: the point is the same.
  ParameterChart<double> chart{{s / (1 - s), 1, t / (1 - t), 1}, {0, 2}};
  return jet(patch, chart);
}

Point vector_of(const std::array<double, 4>& v) { return {v[0], v[1], v[2], v[3]}; }

double affine(const Complex& a, const Complex& b) { return (a / b).real(); }

bool is_finite(const NumericIntersection& s) {
  const auto finite = [](const Complex& z) { return std::isfinite(z.real()) && std::isfinite(z.imag()); };
  return std::all_of(s.t.begin(), s.t.end(), finite) && std::all_of(s.parameters.begin(), s.parameters.end(), finite) &&
         std::isfinite(s.step) && std::isfinite(s.distance) && std::abs(s.t[0]) + std::abs(s.t[1]) > 0.5;
}

/// The intersection with that parameter on the curve, if there is exactly one within 1e-6.
const NumericIntersection* find(const NumericIntersections& found, double t) {
  const NumericIntersection* result = nullptr;
  for (const NumericIntersection& s : found.solutions) {
    if (!(std::abs(s.t[0] - t * s.t[1]) < 1e-6)) continue;
    if (result != nullptr) return nullptr;
    result = &s;
  }
  return result;
}

}  // namespace

TEST_CASE("Pencil in doubles: lines through a known point of a patch find its parameters") {
  Uniform uniform(1);
  RepresentationPencil::Workspace workspace;
  NumericIntersections found;
  for (int i = 0; i < 200; ++i) {
    const std::array<long, 2> degrees{1 + i % 4, 1 + (i / 4) % 4};
    const SurfaceForms patch = random_patch(uniform, degrees, i % 2 == 0);
    const RepresentationPencil pencil(patch);
    CAPTURE(i);
    const double s = uniform(0.05, 0.95);
    const double t = uniform(0.05, 0.95);
    const Point point = vector_of(at(patch, s, t).value);
    const Point other(uniform(), uniform(), uniform(-1, 1), 1);
    // The point at parameter 1/3.
    const Point start = 1.5 * (point / point(3) - other / 3);
    pencil.intersect(line(start, other), false, workspace, found);
    REQUIRE(found.outcome == NumericOutcome::solved);
    CHECK(found.solutions.size() == static_cast<std::size_t>(2 * degrees[0] * degrees[1]));
    const NumericIntersection* solution = find(found, 1.0 / 3);
    REQUIRE(solution != nullptr);
    CHECK(solution->state == NumericState::converged);
    CHECK(std::abs(affine(solution->t[0], solution->t[1]) - 1.0 / 3) < 1e-10);
    CHECK(std::abs(affine(solution->parameters[0], solution->parameters[1]) - s) < 1e-10);
    CHECK(std::abs(affine(solution->parameters[2], solution->parameters[3]) - t) < 1e-10);
  }
}

TEST_CASE("Pencil in doubles: all 54 solutions of a cubic, and real ones alone are the same real ones") {
  Uniform uniform(2);
  RepresentationPencil::Workspace workspace;
  NumericIntersections all;
  NumericIntersections real;
  std::size_t converged = 0;
  for (int i = 0; i < 20; ++i) {
    const SurfaceForms patch = random_patch(uniform, {3, 3}, true);
    const RepresentationPencil pencil(patch);
    CoordinateRows points(4, 4);
    for (long k = 0; k < 4; ++k) points.col(k) = Point(uniform(), uniform(), uniform(-0.9, 0.9), 1);
    const CurveForms curve = bezier_curve_forms(points);
    pencil.intersect(curve, false, workspace, all);
    CHECK(all.solutions.size() == 54);
    for (const NumericIntersection& s : all.solutions)
      if (s.state == NumericState::converged) ++converged;
    pencil.intersect(curve, true, workspace, real);
    std::size_t matched = 0;
    for (const NumericIntersection& s : all.solutions) {
      if (s.t[0].imag() != 0 || s.t[1].imag() != 0) continue;
      REQUIRE(matched < real.solutions.size());
      const NumericIntersection& same = real.solutions[matched];
      CHECK(s.state == same.state);
      CHECK(std::abs(s.t[0] - same.t[0]) + std::abs(s.t[1] - same.t[1]) < 1e-10);
      for (std::size_t k = 0; k < 4; ++k)
        if (s.state == NumericState::converged) CHECK(std::abs(s.parameters[k] - same.parameters[k]) < 1e-10);
      ++matched;
    }
    CHECK(matched == real.solutions.size());
  }
  CHECK(converged >= 20 * 54 - 4);
}

TEST_CASE("Pencil in doubles: far from the origin and in other units") {
  Uniform uniform(3);
  RepresentationPencil::Workspace workspace;
  NumericIntersections found;
  for (const double scale : {0x1p-20, 1.0, 0x1p20})
    for (const double shift : {0.0, 0x1p20}) {
      CAPTURE(scale);
      CAPTURE(shift);
      Uniform same(4);
      CoordinateRows points(4, 16);
      for (long i = 0; i < 16; ++i)
        // 20 binary digits: shifting them is exact.
        points.col(i) = Point(std::round(same() * 0x1p20) * 0x1p-20 * scale + shift * scale,
                              std::round(same() * 0x1p20) * 0x1p-20 * scale - shift * scale,
                              std::round(same() * 0x1p20) * 0x1p-20 * scale, 1);
      const RepresentationPencil pencil(bezier_patch_forms(points, {3, 3}));
      const Point a(scale * (0.25 + shift), scale * (0.25 - shift), -3 * scale, 1);
      const Point b(scale * (0.75 + shift), scale * (0.5 - shift), 4 * scale, 1);
      pencil.intersect(line(a, b), false, workspace, found);
      REQUIRE(found.outcome == NumericOutcome::solved);
      CHECK(found.solutions.size() == 18);
      for (const NumericIntersection& s : found.solutions) CHECK(s.state == NumericState::converged);
    }
}

TEST_CASE("Pencil in doubles: base points make the matrix wider") {
  // A torus, its parametrisation with two pairs of base points that are not real.
  SurfaceForms torus;
  torus.degrees = {2, 2};
  torus.coefficients.setZero(4, 9);
  const auto set = [&](long k, long i, long j, double value) {
    torus.coefficients(k, monomial_index(false, {2, 2}, i, j)) = value;
  };
  set(0, 2, 2, -1), set(0, 2, 0, -3), set(0, 0, 2, 1), set(0, 0, 0, 3);
  set(1, 1, 2, 2), set(1, 1, 0, 6);
  set(2, 2, 1, 2), set(2, 0, 1, 2);
  set(3, 2, 2, 1), set(3, 2, 0, 1), set(3, 0, 2, 1), set(3, 0, 0, 1);
  const MovingPlaneBlocks m = moving_plane_blocks(torus, {3, 1});
  CHECK(m.rows() == 8);
  CHECK(m.columns() == 12);
  CHECK(m.smallest_pivot > 1e-3);
  CHECK(m.largest_dropped_pivot < 1e-14);
  const RepresentationPencil pencil(torus);
  RepresentationPencil::Workspace workspace;
  NumericIntersections found;
  // The x-axis (t, 0, 0) meets it in -3, -1, 1 and 3.
  CurveForms axis;
  axis.coefficients.setZero(4, 2);
  axis.coefficients(0, 1) = 1;
  axis.coefficients(3, 0) = 1;
  pencil.intersect(axis, false, workspace, found);
  REQUIRE(found.outcome == NumericOutcome::solved);
  for (const double t : {-3.0, -1.0, 1.0, 3.0}) {
    const NumericIntersection* solution = find(found, t);
    REQUIRE(solution != nullptr);
    CHECK(solution->state == NumericState::converged);
  }
  std::size_t converged = 0;
  for (const NumericIntersection& s : found.solutions)
    if (s.state == NumericState::converged) ++converged;
  CHECK(converged == 4);
  // The outer equator lies inside.
  CurveForms equator;
  equator.coefficients.setZero(4, 3);
  equator.coefficients.col(0) << 3, 0, 0, 1;
  equator.coefficients.col(1) << 0, 6, 0, 0;
  equator.coefficients.col(2) << -3, 0, 0, 1;
  pencil.intersect(equator, false, workspace, found);
  CHECK(found.outcome == NumericOutcome::rank_deficient);
  CHECK(found.solutions.empty());
}

TEST_CASE("Pencil in doubles: hard lines give finite numbers, and never claim a multiple point") {
  Uniform uniform(5);
  RepresentationPencil::Workspace workspace;
  NumericIntersections found;
  std::size_t simple_tangent = 0;
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    const SurfaceForms patch = random_patch(uniform, {3, 3}, i % 2 == 0);
    const RepresentationPencil pencil(patch);
    const PointJet<double> jet_of_point = at(patch, uniform(0.1, 0.9), uniform(0.1, 0.9));
    const Point point = vector_of(jet_of_point.value);
    const Point along =
        uniform(-1, 1) * vector_of(jet_of_point.derivative[0]) + uniform(-1, 1) * vector_of(jet_of_point.derivative[1]);
    CurveForms curve;
    switch (i % 5) {
      case 0:  // tangent at t = 0: point + t along, in powers of t
      case 1:
        curve.coefficients.resize(4, 2);
        curve.coefficients << point, along;
        break;
      case 2:  // meets the surface at t = infinity
        curve.coefficients.resize(4, 2);
        curve.coefficients << Point(uniform(), uniform(), uniform(), 1), point;
        break;
      case 3:  // a corner of the patch, and a curve with a tiny leading coefficient
        curve.coefficients.resize(4, 4);
        curve.coefficients << patch.coefficients.col(0), along, point, 1e-15 * along;
        break;
      default:  // far away, and with parameters of another size
        curve.coefficients.resize(4, 2);
        curve.coefficients << Point(1e9 * uniform(), uniform(), uniform(), 1), 1e-12 * along;
    }
    pencil.intersect(curve, false, workspace, found);
    REQUIRE(found.outcome == NumericOutcome::solved);
    CHECK(found.solutions.size() == static_cast<std::size_t>(18 * curve.degree()));
    for (const NumericIntersection& s : found.solutions) CHECK(is_finite(s));
    if (i % 5 > 1) continue;
    for (const NumericIntersection& s : found.solutions)
      if (std::abs(s.t[0]) < 1e-7 * std::abs(s.t[1]) && s.state == NumericState::converged) ++simple_tangent;
  }
  CHECK(simple_tangent == 0);
}

TEST_CASE("Pencil in doubles: points that stand for a base point are found and not claimed") {
  Uniform uniform(9);
  RepresentationPencil::Workspace workspace;
  NumericIntersections found;
  for (int i = 0; i < 50; ++i) {
    CAPTURE(i);
    // All coordinates vanish at s = t = 0: the surface has degree 7 and contains the line of the values in its limit.
    SurfaceForms surface;
    surface.degrees = {2, 2};
    surface.coefficients.resize(4, 9);
    for (long k = 0; k < surface.coefficients.size(); ++k) surface.coefficients(k) = uniform(-1, 1);
    surface.coefficients.col(0).setZero();
    const RepresentationPencil pencil(surface);
    CHECK(pencil.rows() == 8);
    CHECK(pencil.columns() == 9);
    CurveForms curve;
    curve.coefficients.resize(4, 2);
    curve.coefficients << uniform(-1, 1) * surface.coefficients.col(1) + uniform(-1, 1) * surface.coefficients.col(3),
        Point(uniform(), uniform(), uniform(), uniform());
    pencil.intersect(curve, false, workspace, found);
    REQUIRE(found.outcome == NumericOutcome::solved);
    std::size_t at_base_point = 0;
    std::size_t elsewhere = 0;
    for (const NumericIntersection& s : found.solutions) {
      CHECK(is_finite(s));
      if (s.state == NumericState::converged) ++elsewhere;
      if (std::abs(s.t[0]) > 1e-6 * std::abs(s.t[1])) continue;
      ++at_base_point;
      CHECK(s.state == NumericState::undetermined);
    }
    CHECK(at_base_point == 1);
    CHECK(elsewhere == 6);
  }
}

TEST_CASE("Pencil in doubles: a line inside the surface has less than full rank, and nothing is said of it") {
  Uniform uniform(6);
  RepresentationPencil::Workspace workspace;
  NumericIntersections found;
  for (int i = 0; i < 50; ++i) {
    // Ruled: linear in the second parameter.
    const SurfaceForms patch = random_patch(uniform, {3, 1}, i % 2 == 0);
    const double s = uniform();
    const CurveForms ruling = line(vector_of(at(patch, s, 0.25).value), vector_of(at(patch, s, 0.75).value));
    RepresentationPencil(patch).intersect(ruling, false, workspace, found);
    CHECK(found.outcome == NumericOutcome::rank_deficient);
    CHECK(found.solutions.empty());
  }
}

TEST_CASE("Pencil in doubles: threads share one object and find the same") {
  Uniform uniform(8);
  const RepresentationPencil pencil(random_patch(uniform, {3, 3}, true));
  std::vector<CurveForms> lines;
  for (int i = 0; i < 100; ++i)
    lines.push_back(line({uniform(), uniform(), uniform(-1, 1), 1}, {uniform(), uniform(), uniform(-1, 1), 1}));
  const auto solve = [&](std::vector<NumericIntersections>& results) {
    RepresentationPencil::Workspace workspace;
    results.resize(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) pencil.intersect(lines[i], false, workspace, results[i]);
  };
  std::vector<std::vector<NumericIntersections>> results(4);
  std::vector<std::thread> threads;
  for (auto& result : results) threads.emplace_back([&] { solve(result); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : results)
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::vector<NumericIntersection>& first = results.front()[i].solutions;
      REQUIRE(result[i].solutions.size() == first.size());
      for (std::size_t k = 0; k < first.size(); ++k) {
        const bool same =
            result[i].solutions[k].t == first[k].t && result[i].solutions[k].parameters == first[k].parameters;
        CHECK(same);
      }
    }
}

TEST_CASE("Pencil in doubles: what is no problem is refused") {
  Uniform uniform(7);
  const SurfaceForms patch = random_patch(uniform, {3, 3}, false);
  const RepresentationPencil pencil(patch);
  RepresentationPencil::Workspace workspace;
  NumericIntersections found;
  CurveForms curve = line({0, 0, 0, 1}, {1, 1, 1, 1});
  curve.coefficients(1, 1) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(pencil.intersect(curve, false, workspace, found), eliminant::InvalidInput);
  curve.coefficients.setZero();
  CHECK_THROWS_AS(pencil.intersect(curve, false, workspace, found), eliminant::InvalidInput);
  curve.coefficients.resize(4, 1);
  curve.coefficients.setOnes();
  CHECK_THROWS_AS(pencil.intersect(curve, false, workspace, found), eliminant::InvalidInput);
  SurfaceForms broken = patch;
  broken.coefficients(0, 0) = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(RepresentationPencil{broken}, eliminant::InvalidInput);
  broken.coefficients.setZero();
  CHECK_THROWS_AS(RepresentationPencil{broken}, eliminant::InvalidInput);
}
