// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/bezier_intersection.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/branches/bezier_common_points.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/intersect/curves/curve_curve.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::intersect {

namespace {

using bridge::exactly;
using bridge::HomogeneousPoint;
using symbolic::Rational;

void check(const std::vector<HomogeneousPoint>& points, std::size_t expected, bool in_plane, const char* what) {
  const std::string name = what;
  if (points.size() != expected || expected < 2)
    throw InvalidInput(name + " has " + std::to_string(points.size()) + " control points",
                       expected < 2 ? "a degree of at least 1" : std::to_string(expected) + " of them");
  bool weighted = false;
  for (const HomogeneousPoint& point : points) {
    if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }))
      throw InvalidInput("a control point of " + name + " is not finite", "numbers");
    if (in_plane && point[2] != 0) throw InvalidInput("a control point of " + name + " has z != 0", "a plane curve");
    weighted = weighted || point[3] != 0;
  }
  if (!weighted) throw InvalidInput("all weights of " + name + " are 0", "a weight that is not 0");
}

bridge::ExactNet exact_net(std::vector<std::size_t> degrees, const std::vector<HomogeneousPoint>& points) {
  bridge::ExactNet net{std::move(degrees), {}};
  net.points.reserve(points.size());
  for (const HomogeneousPoint& p : points)
    net.points.push_back({exactly(p[0]), exactly(p[1]), exactly(p[2]), exactly(p[3])});
  return net;
}

/// Whether two homogeneous points are one, exactly.
bool are_proportional(const HomogeneousPoint& p, const HomogeneousPoint& q) {
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < j; ++k) {
      const double a = p[j] * q[k];
      const double b = p[k] * q[j];
      // Beyond rounding, and not below the range of doubles.
      constexpr double rounding = 0x1p-50;
      constexpr double smallest = 0x1p-1000;
      if (std::fabs(a - b) > rounding * (std::fabs(a) + std::fabs(b)) + smallest && std::isfinite(a - b)) return false;
    }
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < j; ++k)
      if (!(exactly(p[j]) * exactly(q[k]) == exactly(p[k]) * exactly(q[j]))) return false;
  return true;
}

void check_not_one_point(const std::vector<HomogeneousPoint>& points, const char* what) {
  const auto is_zero = [](const HomogeneousPoint& p) { return p == HomogeneousPoint{}; };
  const auto first = std::find_if_not(points.begin(), points.end(), is_zero);
  if (first == points.end()) return;
  const bool varies = std::any_of(std::next(first), points.end(), [&](const HomogeneousPoint& p) {
    return !is_zero(p) && !are_proportional(*first, p);
  });
  if (!varies) throw InvalidInput(std::string(what) + " is a single point", "control points that differ");
}

symbolic::ControlPoint control_point(const HomogeneousPoint& p, bool in_plane) {
  if (in_plane) return {exactly(p[0]), exactly(p[1]), exactly(p[3])};
  return {exactly(p[0]), exactly(p[1]), exactly(p[2]), exactly(p[3])};
}

symbolic::ParametricCurve exact_curve(const BezierCurve& curve, bool in_plane) {
  std::vector<symbolic::ControlPoint> points;
  for (const HomogeneousPoint& p : curve.points) points.push_back(control_point(p, in_plane));
  return {{symbolic::bezier_curve(points)}};
}

symbolic::ParametricSurface exact_patch(const BezierPatch& patch) {
  std::vector<std::vector<symbolic::ControlPoint>> rows(patch.degree[0] + 1);
  for (std::size_t i = 0; i < patch.points.size(); ++i)
    rows[i / (patch.degree[1] + 1)].push_back(control_point(patch.points[i], false));
  return {{symbolic::bezier_patch(rows)}};
}

double middle(const Parameter& parameter) {
  return parameter ? arf_get_d(arb_midref(parameter->ball.real()), ARF_RND_NEAR) : INFINITY;
}

/// The point of a Bezier curve by de Casteljau's algorithm.
std::array<double, 3> point_at(const BezierCurve& curve, double t) {
  std::vector<HomogeneousPoint> p = curve.points;
  for (std::size_t level = p.size() - 1; level > 0; --level)
    for (std::size_t i = 0; i < level; ++i)
      for (std::size_t k = 0; k < 4; ++k) p[i][k] = (1 - t) * p[i][k] + t * p[i + 1][k];
  return {p[0][0] / p[0][3], p[0][1] / p[0][3], p[0][2] / p[0][3]};
}

}  // namespace

BezierIntersector::BezierIntersector(BezierPatch second) : patch_(std::move(second)) {
  if (patch_->degree[0] < 1 || patch_->degree[1] < 1)
    throw InvalidInput("the patch has degree 0 in a parameter", "a degree of at least 1");
  check(patch_->points, (patch_->degree[0] + 1) * (patch_->degree[1] + 1), false, "the patch");
  prepare({patch_->degree[0], patch_->degree[1]}, patch_->points);
}

BezierIntersector::BezierIntersector(BezierCurve second) : curve_(std::move(second)) {
  check(curve_->points, std::max<std::size_t>(curve_->points.size(), 2), true, "the second curve");
  check_not_one_point(curve_->points, "the second curve");
  prepare({curve_->points.size() - 1}, curve_->points);
}

void BezierIntersector::prepare(const std::vector<std::size_t>& degrees, const std::vector<HomogeneousPoint>& points) {
  const HomogeneousPoint& first = points.front();
  for (std::size_t k = 0; k < 3; ++k) {
    // Few digits, so that differences are exact for coordinates of ordinary length.
    constexpr double few_bits = 0x1p32;
    const double quotient = first[3] != 0 ? first[k] / first[3] : 0;
    const double padding = few_bits * quotient;
    origin_[k] = std::isfinite(padding) ? (quotient + padding) - padding : 0;
  }
  net_ = bridge::ControlNet::of(degrees, points, origin_);
}

BezierIntersections BezierIntersector::intersect(const BezierCurve& first, const Context& context) const {
  check(first.points, std::max<std::size_t>(first.points.size(), 2), curve_.has_value(), "the curve");
  check_not_one_point(first.points, "the curve");
  const auto net = net_ ? bridge::ControlNet::of({first.points.size() - 1}, first.points, origin_) : std::nullopt;
  if (!net) return by_matrices(first, context);
  std::optional<bridge::ExactNet> exact_first;
  std::optional<bridge::ExactNet> exact_second;
  const auto points = bridge::bezier_common_points(
      *net, *net_,
      [&]() -> const bridge::ExactNet& {
        if (!exact_first) exact_first = exact_net(net->degrees, first.points);
        return *exact_first;
      },
      [&]() -> const bridge::ExactNet& {
        if (!exact_second) exact_second = exact_net(net_->degrees, patch_ ? patch_->points : curve_->points);
        return *exact_second;
      },
      context);
  if (!points) return by_matrices(first, context);
  BezierIntersections result;
  result.status = Status::certified;
  result.by_boxes = true;
  for (const bridge::BezierCommonPoint& point : *points) {
    BezierPoint& solution = result.points.emplace_back();
    solution.parameters = point.zero.parameters;
    solution.radius = point.zero.radius;
    solution.point = point_at(first, solution.parameters[0]);
    solution.multiplicity = point.multiplicity;
    solution.certified = true;
  }
  std::sort(result.points.begin(), result.points.end(),
            [](const BezierPoint& a, const BezierPoint& b) { return a.parameters < b.parameters; });
  return result;
}

BezierIntersections BezierIntersector::by_matrices(const BezierCurve& first, const Context& context) const {
  Options options;
  options.field = Field::real;
  // One radius holds for parameters and coordinates, which may be large.
  double largest = 1;
  for (const HomogeneousPoint& p : first.points)
    for (std::size_t k = 0; k < 3; ++k)
      if (p[3] != 0) largest = std::max(largest, std::fabs(p[k] / p[3]));
  options.digits += std::isfinite(largest) ? std::lround(std::ceil(std::log10(largest))) : 0;
  CurveResult exact;
  if (patch_) {
    exact = intersect_curve_surface({exact_curve(first, false), exact_patch(*patch_)}, options, context);
  } else {
    exact = intersect_curve_curve({exact_curve(first, true), exact_curve(*curve_, true)}, options, context);
  }
  BezierIntersections result;
  result.status = exact.status;
  for (const CurveSolution& solution : exact.solutions) {
    if (!solution.inside) continue;
    BezierPoint point;
    point.parameters[0] = middle(*solution.t);
    // The printed digits, and the rounding to doubles of numbers of at most 1.
    point.radius = std::pow(10.0, static_cast<double>(solution.radius_exponent)) + 0x1p-52;
    point.point = point_at(first, point.parameters[0]);
    point.multiplicity = solution.multiplicity;
    point.certified = solution.certified;
    if (solution.u) {
      point.parameters[1] = middle(*solution.u);
      result.points.push_back(point);
    }
    if (patch_ && solution.surface_parameters.empty()) {
      point.parameters[1] = point.parameters[2] = std::numeric_limits<double>::quiet_NaN();
      result.points.push_back(point);
    }
    for (const std::vector<Parameter>& on_patch : solution.surface_parameters) {
      point.parameters[1] = middle(on_patch[0]);
      point.parameters[2] = middle(on_patch[1]);
      result.points.push_back(point);
    }
  }
  for (const Overlap& overlap : exact.overlap)
    if (overlap.t) result.overlap.push_back({middle((*overlap.t)[0]), middle((*overlap.t)[1])});
  return result;
}

}  // namespace eliminant::intersect
