// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/tangential_elimination.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include <eliminant/bridge/nets/graph_slopes.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>

namespace eliminant::bridge {

DoubleInterval Hessian::form(const std::array<double, 2>& a, const std::array<double, 2>& b) const {
  return uu * DoubleInterval(a[0] * b[0]) + uv * DoubleInterval(a[0] * b[1] + a[1] * b[0]) +
         vv * DoubleInterval(a[1] * b[1]);
}

std::optional<TangentialElimination> TangentialElimination::on(const ControlNet& first, const ControlNet& second,
                                                               const std::array<double, 4>& centre,
                                                               const CellBox& box) {
  const PatchJets::Value a0 = PatchJets(first).at(centre[0], centre[1]);
  const PatchJets::Value b0 = PatchJets(second).at(centre[2], centre[3]);
  const auto frame = tangent_frame(a0);
  if (!frame) return std::nullopt;
  const EnclosedPatch a(
      taylor_on_box(first, *frame, {{box.lower[0], box.lower[1], 0}, {box.upper[0], box.upper[1], 0}}, 0, 2));
  // The parameters (s, t) by (u, v), to first order: the inverse of the derivative along the tangent plane.
  Eigen::Matrix2d derivative;
  for (long row = 0; row < 2; ++row)
    for (long k = 0; k < 2; ++k) derivative(row, k) = coordinate(*frame, b0.first[static_cast<std::size_t>(k)], row);
  const Eigen::Matrix2d inverse = derivative.inverse();
  if (!inverse.allFinite()) return std::nullopt;
  // A box for (s, t) that holds the cell and all values of that function.
  const double extent_u = a.value[0].magnitude();
  const double extent_v = a.value[1].magnitude();
  // With a contraction of 0.3 in the larger of both coordinates.
  const double mixed = 0.44 * std::max(extent_u, extent_v);
  OpenBox of_second{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto row = static_cast<long>(k);
    constexpr double room = 1.1;
    const double half =
        room * (std::fabs(inverse(row, 0)) * (extent_u + mixed) + std::fabs(inverse(row, 1)) * (extent_v + mixed));
    of_second.lower[k] = std::min(box.lower[2 + k], centre[2 + k] - half);
    of_second.upper[k] = std::max(box.upper[2 + k], centre[2 + k] + half);
    // Control points tell little far beyond the domain.
    constexpr double beyond = 0.25;
    if (of_second.lower[k] < -beyond || of_second.upper[k] > 1 + beyond) return std::nullopt;
  }
  const EnclosedPatch b(taylor_on_box(second, *frame, of_second, 0, 2));

  const GraphSlopes graph(b.first, {{{inverse(0, 0), inverse(0, 1)}, {inverse(1, 0), inverse(1, 1)}}});
  constexpr double at_most = 0.3;
  if (!(graph.contraction < at_most)) return std::nullopt;
  const EnclosedPatch::Point& normal = graph.normal;
  // How (s, t) follow u and v.
  std::array<std::array<DoubleInterval, 2>, 2> follow;
  for (std::size_t i = 0; i < 2; ++i) {
    const DoubleInterval p = graph.solve[0][0] * a.first[i][0] + graph.solve[0][1] * a.first[i][1];
    const DoubleInterval q = graph.solve[1][0] * a.first[i][0] + graph.solve[1][1] * a.first[i][1];
    for (std::size_t k = 0; k < 2; ++k)
      follow[i][k] =
          DoubleInterval(inverse(static_cast<long>(k), 0)) * p + DoubleInterval(inverse(static_cast<long>(k), 1)) * q;
  }
  const auto entry = [&](std::size_t i, std::size_t j) {
    DoubleInterval sum(0);
    for (std::size_t c = 0; c < 3; ++c) {
      const DoubleInterval bend = b.second[0][c] * follow[i][0] * follow[j][0] +
                                  b.second[1][c] * (follow[i][0] * follow[j][1] + follow[i][1] * follow[j][0]) +
                                  b.second[2][c] * follow[i][1] * follow[j][1];
      sum = sum + normal[c] * (a.second[i + j][c] - bend);
    }
    return sum;
  };
  TangentialElimination result{*frame, a, b, {}, graph.contraction, {}, {entry(0, 0), entry(0, 1), entry(1, 1)}};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto row = static_cast<long>(i);
    result.inverse[i] = {inverse(row, 0), inverse(row, 1)};
    for (std::size_t c = 0; c < 3; ++c) result.gradient[i] = result.gradient[i] + normal[c] * a.first[i][c];
  }
  return result;
}

}  // namespace eliminant::bridge
