// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/curve_boxes.hpp>

#include <utility>

#include <eliminant/intersect/curve_surface/prepared_net.hpp>
#include <eliminant/intersect/curves/box_solutions.hpp>
#include <eliminant/intersect/curves/common_points.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>

namespace eliminant::intersect {

using bridge::ComplexBall;
using symbolic::Rational;

std::optional<std::vector<CurveSolution>> solve_by_boxes(const symbolic::CurvePiece& first,
                                                         const symbolic::CurvePiece& second, const Options& options,
                                                         const Context& context) {
  if (first.map.dimension() != 2 || second.map.dimension() != 2) return std::nullopt;
  const std::optional<PreparedNet> a = prepared_net(first);
  const std::optional<PreparedNet> b = prepared_net(second);
  if (!a || !b) return std::nullopt;
  const std::array<Rational, 3> origin = a->origin();
  const auto net_a = a->rounded(origin);
  const auto net_b = b->rounded(origin);
  if (!net_a || !net_b) return std::nullopt;
  const auto points = bridge::bezier_common_points(
      *net_a, *net_b, [&]() -> const bridge::ExactNet& { return a->exact; },
      [&]() -> const bridge::ExactNet& { return b->exact; }, context);
  if (!points) return std::nullopt;

  const std::vector<symbolic::Interval> domains{a->domain[0], b->domain[0]};
  const bridge::System system = common_point_system(first.map, second.map);
  std::vector<CurveSolution> solutions;
  for (const bridge::BezierCommonPoint& point : *points) {
    const BoxSolution box{point, domains};
    if (point.exact) {
      CurveSolution& solution = solutions.emplace_back(box.exact_on(first.map, options));
      solution.u = exactly(box.exact_parameters()[1], options);
      continue;
    }
    auto solution = box.refined(system, options, [&](const std::vector<ComplexBall>& zero, long bits) {
      return print_common_point(first.map, zero[0], zero[1], options, bits);
    });
    if (!solution) return std::nullopt;
    solutions.push_back(*std::move(solution));
  }
  return solutions;
}

}  // namespace eliminant::intersect
