// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/overlaps/border_arc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/intersect/overlaps/patch_inversion.hpp>

namespace eliminant::intersect {

DrawnCurve drawn_border(const bridge::ControlNet& first, const bridge::ControlNet& second,
                        const bridge::ContainedBorder& border, double tolerance) {
  const bool of_first = border.axis < 2;
  bridge::PatchJets own(of_first ? first : second);
  bridge::PatchJets other(of_first ? second : first);
  const std::size_t kept = border.axis;
  const std::size_t along = of_first ? 1 - kept : 5 - kept;
  const double length = border.upper - border.lower;
  const auto bounds = own.bounds_on(0, 1, 0, 1);
  const Eigen::Array4d& bend = bounds->second[along % 2 == 0 ? 0 : 2];
  const double curvature = bend.head<3>().matrix().norm() * length * length;
  // Enough to see whether both patches are tangent all along it.
  constexpr double least_steps = 8;
  const auto steps =
      static_cast<std::size_t>(std::clamp(std::ceil(std::sqrt(curvature / (8 * tolerance))), least_steps, 1e6));
  DrawnCurve drawn;
  std::array<double, 2> start{0.5, 0.5};
  double evaluation = 0;
  double size = 0;
  for (std::size_t i = 0; i <= steps; ++i) {
    std::array<double, 4> at{};
    at[kept] = border.side < 0 ? 0 : 1;
    at[along] = border.lower + length * static_cast<double>(i) / static_cast<double>(steps);
    const std::size_t base = of_first ? 0 : 2;
    const bridge::PatchJets::Value value = own.at(at[base], at[base + 1]);
    evaluation = std::max(evaluation, value.error);
    size = std::max(size, value.point.head<3>().abs().maxCoeff());
    start = i == 0 ? nearest_parameters(other, value.point) : parameters_near(other, value.point, start);
    at[2 - base] = start[0];
    at[3 - base] = start[1];
    drawn.parameters.push_back(at);
    drawn.points.push_back({value.point[0], value.point[1], value.point[2]});
  }
  const double speed = (bounds->first[0] + bounds->first[1]).head<3>().matrix().norm();
  constexpr double accuracy_of_ends = 1e-14;
  drawn.error = curvature / 8 / static_cast<double>(steps * steps) + 1.74 * evaluation + accuracy_of_ends * speed;
  return drawn;
}

}  // namespace eliminant::intersect
