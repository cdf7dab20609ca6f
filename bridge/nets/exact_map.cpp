// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/exact_map.hpp>

#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::bridge {

std::vector<symbolic::Polynomial> coordinates_of(const ExactNet& net) {
  const std::size_t row = net.degrees[1] + 1;
  std::vector<std::vector<symbolic::ControlPoint>> rows(net.degrees[0] + 1);
  for (std::size_t i = 0; i < net.points.size(); ++i)
    rows[i / row].emplace_back(net.points[i].begin(), net.points[i].end());
  return symbolic::bezier_patch(rows).map.coordinates();
}

}  // namespace eliminant::bridge
