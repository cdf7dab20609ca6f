// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <eliminant/intersect/patches/branch_spline.hpp>

using namespace eliminant::intersect;

namespace {

using Values = std::array<double, 7>;

SurfacePoint point_of(const Values& values) {
  return {{values[0], values[1], values[2], values[3]}, {values[4], values[5], values[6]}};
}

// Points of a curve over [0, length], the last one the first of a loop.
SurfaceComponent polyline(const std::function<Values(double)>& curve, double length, std::size_t segments, bool loop) {
  SurfaceComponent component;
  component.kind = loop ? SurfaceComponentKind::loop : SurfaceComponentKind::curve;
  for (std::size_t i = 0; i <= segments; ++i)
    component.points.push_back(point_of(curve(length * static_cast<double>(i) / static_cast<double>(segments))));
  if (loop) component.points.back() = component.points.front();
  return component;
}

// The value by de Boor's algorithm.
Values value_at(const BranchSpline& spline, double x) {
  std::size_t span = 3;
  while (span + 1 < spline.control_points.size() && spline.knots[span + 1] <= x) ++span;
  std::array<Values, 4> points;
  for (std::size_t i = 0; i < 4; ++i) points[i] = spline.control_points[span - 3 + i];
  for (std::size_t level = 1; level <= 3; ++level)
    for (std::size_t i = 3; i >= level; --i) {
      const double lower = spline.knots[span - 3 + i];
      const double weight = (x - lower) / (spline.knots[span + 1 + i - level] - lower);
      for (std::size_t k = 0; k < 7; ++k) points[i][k] = (1 - weight) * points[i - 1][k] + weight * points[i][k];
    }
  return points[3];
}

// Calls `use` with points of the spline, `count` of each span.
void sample(const BranchSpline& spline, std::size_t count, const std::function<void(const Values&)>& use) {
  for (std::size_t i = 3; i < spline.control_points.size(); ++i)
    for (std::size_t j = 0; j <= count; ++j)
      use(value_at(spline, std::lerp(spline.knots[i], spline.knots[i + 1],
                                     static_cast<double>(j) / static_cast<double>(count))));
}

void check_form(const BranchSpline& spline, const SurfaceComponent& component) {
  CHECK(spline.degree == 3);
  REQUIRE(spline.knots.size() == spline.control_points.size() + 4);
  CHECK(std::is_sorted(spline.knots.begin(), spline.knots.end()));
  CHECK(std::count(spline.knots.begin(), spline.knots.end(), spline.knots.front()) == 4);
  CHECK(std::count(spline.knots.begin(), spline.knots.end(), spline.knots.back()) == 4);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(spline.control_points.front()[4 + k] == component.points.front().point[k]);
    CHECK(spline.control_points.back()[4 + k] == component.points.back().point[k]);
  }
}

double norm(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

// Largest distance of a chord from the unit circle.
double sagitta(std::size_t segments) { return 1 - std::cos(std::numbers::pi / static_cast<double>(segments)); }

Values circle(double angle) {
  const double x = std::cos(angle);
  const double y = std::sin(angle);
  return {(x + 1) / 2, (y + 1) / 2, x / 4, 0.5, x, y, 2};
}

}  // namespace

TEST_CASE("branch_spline: of a segment the Bezier curve of degree three") {
  for (const std::size_t segments : {1U, 2U, 3U, 7U, 1000U}) {
    SurfaceComponent line =
        polyline([](double t) -> Values { return {t, 1 - t, t, 0.25, 3 * t, -2 * t, 1 + t}; }, 1, segments, false);
    line.error = 1e-12;
    const auto spline = branch_spline(line, 1e-9);
    REQUIRE(spline);
    check_form(*spline, line);
    CHECK(spline->control_points.size() == 4);
    CHECK(spline->error >= 1e-12);
    CHECK(spline->error < 1e-12 + 1e-13);
    const double third = spline->control_points[1][4];
    CHECK(std::fabs(third - 1) < 1e-12);
  }
}

TEST_CASE("branch_spline: a circle closes, smoothly, within its error") {
  for (const std::size_t segments : {200U, 2000U, 60000U}) {
    CAPTURE(segments);
    SurfaceComponent component = polyline(circle, 2 * std::numbers::pi, segments, true);
    component.error = sagitta(segments);
    const double tolerance = 2 * component.error;
    const auto spline = branch_spline(component, tolerance);
    REQUIRE(spline);
    check_form(*spline, component);
    CHECK(spline->error <= component.error + tolerance);
    CHECK(spline->error > component.error);
    double largest = 0;
    sample(*spline, 7, [&](const Values& p) {
      largest = std::max(largest, norm(std::hypot(p[4], p[5]) - 1, 0, p[6] - 2));
      CHECK(std::fabs(p[0] - (p[4] + 1) / 2) < tolerance);
      CHECK(std::fabs(p[2] - p[4] / 4) < tolerance);
    });
    CHECK(largest <= spline->error);
    // The error of cubic splines on spans of length h is about h^4/384; halving may double their number.
    const double span = std::pow(384 * component.error, 0.25);
    CHECK(static_cast<double>(spline->control_points.size()) < 4 + 2.5 * 2 * std::numbers::pi / span);
    // First differences at both ends of the closed curve.
    const auto& c = spline->control_points;
    const auto& t = spline->knots;
    for (std::size_t k = 0; k < 7; ++k) {
      const double begin = (c[1][k] - c[0][k]) / (t[4] - t[3]);
      const double end = (c[c.size() - 1][k] - c[c.size() - 2][k]) / (t[c.size()] - t[c.size() - 1]);
      CHECK(std::fabs(begin - end) < 1e-8);
    }
  }
}

TEST_CASE("branch_spline: a helix within its error, both ways") {
  const auto helix = [](double t) -> Values {
    return {t / 10, std::sin(t), std::cos(t), 1 - t / 10, std::cos(t), std::sin(t), t / 4};
  };
  SurfaceComponent component = polyline(helix, 10, 20000, false);
  // The helix has the curvature 1/(1 + 1/16) and the speed sqrt(17/16).
  const double step = 10.0 / 20000 * std::sqrt(17.0 / 16);
  component.error = step * step / 8 * 16 / 17 * 1.001;
  const double tolerance = 2 * component.error;
  const auto spline = branch_spline(component, tolerance);
  REQUIRE(spline);
  check_form(*spline, component);
  CHECK(spline->error <= component.error + tolerance);
  CHECK(spline->control_points.size() < 400);
  std::vector<Values> samples;
  sample(*spline, 20, [&](const Values& p) {
    const Values on = helix(4 * p[6]);
    CHECK(norm(p[4] - on[4], p[5] - on[5], 0) <= spline->error * 1.1);
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::fabs(p[k] - on[k]) < 2 * tolerance);
    samples.push_back(p);
  });
  // Every point of the curve has the spline at its height.
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) CHECK(samples[i + 1][6] - samples[i][6] < 0.01);
}

TEST_CASE("branch_spline: the error holds for coarse and uneven polylines") {
  // An ellipse with few points, bunched together.
  const auto ellipse = [](double t) -> Values {
    const double angle = t + 0.8 * std::sin(t) * std::cos(t / 2);
    return {t, t, t, t, 3 * std::cos(angle), std::sin(angle), 0};
  };
  for (const std::size_t segments : {4U, 5U, 9U, 33U, 400U}) {
    CAPTURE(segments);
    SurfaceComponent component = polyline(ellipse, 2, segments, false);
    const auto spline = branch_spline(component, 1e-7);
    REQUIRE(spline);
    check_form(*spline, component);
    // Distance of the samples from the polyline.
    double largest = 0;
    sample(*spline, 9, [&](const Values& p) {
      double nearest = INFINITY;
      for (std::size_t i = 0; i < segments; ++i) {
        const auto& a = component.points[i].point;
        const auto& b = component.points[i + 1].point;
        const std::array<double, 2> d{b[0] - a[0], b[1] - a[1]};
        const double along =
            std::clamp(((p[4] - a[0]) * d[0] + (p[5] - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]), 0.0, 1.0);
        nearest = std::min(nearest, std::hypot(p[4] - a[0] - along * d[0], p[5] - a[1] - along * d[1]));
      }
      largest = std::max(largest, nearest);
    });
    CHECK(largest <= spline->error);
    CHECK(largest > 0);
  }
}

TEST_CASE("branch_spline: a branch that turns in space where its parameters do not") {
  // A cuspidal edge: the curve comes back on itself.
  const auto turning = [](double t) -> Values {
    const double x = t - 1;
    return {x, -x, x * x, 0, x * x, x * x * x, 0};
  };
  SurfaceComponent component = polyline(turning, 2, 4001, false);
  component.error = 1e-7;
  const auto spline = branch_spline(component, 1e-6);
  REQUIRE(spline);
  CHECK(spline->error < 1.2e-6);
  sample(*spline, 5, [&](const Values& p) {
    CHECK(std::fabs(p[4] - p[0] * p[0]) < 2e-6);
    CHECK(std::fabs(p[1] + p[0]) < 2e-6);
  });
}

TEST_CASE("branch_spline: parameters without a value stay so, points at infinity have no spline") {
  SurfaceComponent component = polyline(circle, 1, 100, false);
  for (SurfacePoint& point : component.points)
    point.parameters[2] = point.parameters[3] = std::numeric_limits<double>::quiet_NaN();
  component.points[3].parameters[1] = INFINITY;
  const auto spline = branch_spline(component, 1e-4);
  REQUIRE(spline);
  for (const auto& control_point : spline->control_points) {
    CHECK(std::isfinite(control_point[0]));
    for (const std::size_t k : {1U, 2U, 3U}) CHECK(std::isnan(control_point[k]));
  }
  component.points[3].point[1] = INFINITY;
  CHECK_FALSE(branch_spline(component, 1e-4));
  component = polyline(circle, 0, 1, false);
  CHECK_FALSE(branch_spline(component, 1e-4));
  component = polyline(circle, 1, 10, false);
  component.kind = SurfaceComponentKind::overlap;
  CHECK_FALSE(branch_spline(component, 1e-4));
  CHECK_FALSE(branch_spline(SurfaceComponent{}, 1e-4));
}

TEST_CASE("branch_spline: points that stand still are left out") {
  SurfaceComponent once = polyline(circle, 1, 100, false);
  SurfaceComponent twice = once;
  twice.points.insert(twice.points.begin() + 50, once.points[50]);
  twice.points.push_back(once.points.back());
  const auto a = branch_spline(once, 1e-5);
  const auto b = branch_spline(twice, 1e-5);
  REQUIRE((a && b));
  CHECK(a->knots == b->knots);
  CHECK(a->control_points == b->control_points);
}
