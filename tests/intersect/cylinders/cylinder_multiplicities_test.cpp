// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using symbolic::Rational;
using symbolic::SpacePoint;
using Points = std::array<SpacePoint, 5>;

namespace {

/// The paper's cubic of the points p_1, p_2, p_3, p_k: N_2 D(d_3, d_k, t) - N_3 D(d_2, d_k, t) + N_k D(d_2, d_3, t), at
/// t = (x, y, 1 + 3 x - 7 y).
symbolic::Polynomial paper_cubic(const Points& points, std::size_t k) {
  using symbolic::Polynomial;
  const Polynomial x = Polynomial::variable(2, 0);
  const Polynomial y = Polynomial::variable(2, 1);
  const std::array<Polynomial, 3> t{x, y, Polynomial::constant(2, 1) + Rational(3) * x + Rational(-7) * y};
  const auto along = [&t](const SpacePoint& d) { return d[0] * t[0] + d[1] * t[1] + d[2] * t[2]; };
  const Polynomial square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
  const auto distance = [&](const SpacePoint& d) { return symbolic::dot_product(d, d) * square - along(d) * along(d); };
  const SpacePoint a = symbolic::difference(points[1], points[0]);
  const SpacePoint b = symbolic::difference(points[2], points[0]);
  const SpacePoint c = symbolic::difference(points[k], points[0]);
  return distance(a) * along(symbolic::cross_product(b, c)) - distance(b) * along(symbolic::cross_product(a, c)) +
         distance(c) * along(symbolic::cross_product(a, b));
}

/// Whether a solution (x, y) has the direction d, which is not parallel to the line at infinity of the chart.
bool has_direction(const Solution& solution, const SpacePoint& d) {
  const Rational weight = d[2] - Rational(3) * d[0] + Rational(7) * d[1];
  return acb_contains_fmpq(solution.x.ball.get(), (d[0] / weight).get()) != 0 &&
         acb_contains_fmpq(solution.y.ball.get(), (d[1] / weight).get()) != 0;
}

/// Multiplicities of the common zeros of two of the paper's cubics, one less at the common edges; empty where the chart
/// or the first three points are special.
std::vector<unsigned long> multiplicities_of_cubics(const Points& points) {
  PlaneCurvesProblem cubics;
  cubics.p = paper_cubic(points, 3);
  cubics.q = paper_cubic(points, 4);
  if (cubics.p.total_degree() < 3 || cubics.q.total_degree() < 3) return {};
  const Result result = intersect_plane_curves(cubics, {}, Context());
  if (result.status != Status::certified || result.counts.at_infinity != 0) return {};
  std::vector<unsigned long> multiplicities;
  for (const Solution& solution : result.solutions) {
    unsigned long multiplicity = solution.multiplicity;
    for (const auto& [i, j] : std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {0, 2}, {1, 2}})
      if (has_direction(solution, symbolic::difference(points[i], points[j]))) --multiplicity;
    if (multiplicity > 0) multiplicities.push_back(multiplicity);
  }
  std::sort(multiplicities.begin(), multiplicities.end());
  return multiplicities;
}

}  // namespace

TEST_CASE("Cylinders: multiplicities are those of the paper's cubics without their common edges") {
  std::mt19937 generator(3);
  int compared = 0;
  int multiple = 0;
  for (int round = 0; round < 400; ++round) {
    Points points;
    for (SpacePoint& point : points)
      for (Rational& coordinate : point) coordinate = static_cast<long>(generator() % 3) - 1;
    const CylindersResult result = cylinders_through({points}, {}, Context());
    if (result.counts.bezout_number != 6 || result.counts.isotropic != 0) continue;
    const std::vector<unsigned long> expected = multiplicities_of_cubics(points);
    if (expected.empty()) continue;
    std::vector<unsigned long> multiplicities;
    for (const CylinderSolution& solution : result.solutions) multiplicities.push_back(solution.multiplicity);
    std::sort(multiplicities.begin(), multiplicities.end());
    CAPTURE(round);
    CHECK(multiplicities == expected);
    ++compared;
    multiple += multiplicities.back() > 1 ? 1 : 0;
  }
  CHECK(compared > 100);
  CHECK(multiple > 10);
}
