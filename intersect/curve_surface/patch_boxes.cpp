// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/patch_boxes.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/intersect/curves/box_solutions.hpp>
#include <eliminant/intersect/curves/common_points.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::Rational;

constexpr std::size_t weight = 3;

}  // namespace

PatchBoxes::PatchBoxes(const symbolic::SurfacePiece& piece) : surface_(piece.map), prepared_(prepared_net(piece)) {
  if (!prepared_) return;
  origin_ = prepared_->origin();
  net_ = prepared_->rounded(origin_);
}

bool PatchBoxes::excludes(const std::vector<ComplexBall>& point, const Context& context) const {
  if (!net_) return false;
  double size = 0;
  for (const ComplexBall& coordinate : point)
    size = std::max(size, std::fabs(arf_get_d(arb_midref(coordinate.real()), ARF_RND_NEAR)));
  constexpr double safe = 1e60;
  if (!(size < safe) || !(size > 1 / safe)) return false;
  bridge::PointBox box;
  constexpr long precision_bits = 128;
  for (std::size_t k = 0; k < 4; ++k) {
    bridge::RealBall moved;
    if (k < weight) {
      const bridge::RealBall shift(origin_[k], precision_bits);
      arb_mul(moved.get(), shift.get(), point[weight].real(), precision_bits);
    }
    arb_sub(moved.get(), point[k].real(), moved.get(), precision_bits);
    bridge::RealBall end;
    arb_get_lbound_arf(arb_midref(end.get()), moved.get(), 64);
    box[k].lower = arf_get_d(arb_midref(end.get()), ARF_RND_FLOOR);
    arb_get_ubound_arf(arb_midref(end.get()), moved.get(), 64);
    box[k].upper = arf_get_d(arb_midref(end.get()), ARF_RND_CEIL);
  }
  return bridge::excludes_point(*net_, box, context);
}

std::optional<std::vector<CurveSolution>> PatchBoxes::solve(const symbolic::CurvePiece& curve, const Options& options,
                                                            const Context& context) const {
  if (!net_) return std::nullopt;
  const std::optional<PreparedNet> prepared_curve = prepared_net(curve);
  if (!prepared_curve) return std::nullopt;
  const std::optional<bridge::ControlNet> curve_net = prepared_curve->rounded(origin_);
  if (!curve_net) return std::nullopt;
  const auto points = bridge::bezier_common_points(
      *curve_net, *net_, [&]() -> const bridge::ExactNet& { return prepared_curve->exact; },
      [&]() -> const bridge::ExactNet& { return prepared_->exact; }, context);
  if (!points) return std::nullopt;

  const std::vector<symbolic::Interval> domains{prepared_curve->domain[0], prepared_->domain[0], prepared_->domain[1]};
  bridge::HomogeneousParameters chart(4);
  for (ComplexBall& parameter : chart) acb_one(parameter.get());
  const bridge::System of_surface_first = common_point_system(surface_, curve.map, chart, {0, 2}, weight);
  const bridge::System system = [&](const std::vector<ComplexBall>& at, long bits) {
    bridge::SystemValue value = of_surface_first({at[1], at[2], at[0]}, bits);
    for (std::vector<ComplexBall>& row : value.jacobian) std::rotate(row.begin(), row.begin() + 2, row.end());
    return value;
  };
  std::vector<CurveSolution> solutions;
  for (const bridge::BezierCommonPoint& point : *points) {
    const BoxSolution box{point, domains};
    if (point.exact) {
      CurveSolution& solution = solutions.emplace_back(box.exact_on(curve.map, options));
      const std::vector<Rational> parameters = box.exact_parameters();
      solution.surface_parameters.push_back({exactly(parameters[1], options), exactly(parameters[2], options)});
      continue;
    }
    auto solution = box.refined(system, options, [&](const std::vector<ComplexBall>& zero, long bits) {
      bridge::HomogeneousParameters at = chart;
      at[0] = zero[1];
      at[2] = zero[2];
      return print_common_point(surface_, curve.map, at, zero[0], options, bits);
    });
    if (!solution) return std::nullopt;
    solutions.push_back(*std::move(solution));
  }
  return solutions;
}

}  // namespace eliminant::intersect
