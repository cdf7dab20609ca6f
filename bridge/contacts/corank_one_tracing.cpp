// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/corank_one_tracing.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <eliminant/bridge/branches/patch_difference.hpp>
#include <eliminant/bridge/contacts/corank_one_branches.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>

namespace eliminant::bridge {

namespace {

using Point = CorankOnePatches::Point;

/// A point of a half-branch on the first patch, and a bound of its distance from the branch.
struct Vertex {
  TracedPoint at;
  double error = 0;
};

Vertex vertex_at(PatchJets& first, const CorankOneBranches& branches, const std::array<double, 4>& parameters,
                 double error_of_z) {
  constexpr double root_of_three = 1.7321;
  const PatchJets::Value value = first.at(parameters[0], parameters[1]);
  Vertex result;
  for (std::size_t k = 0; k < 4; ++k) result.at.parameters[k] = std::clamp(parameters[k], 0.0, 1.0);
  for (std::size_t k = 0; k < 3; ++k) result.at.point[k] = value.point[static_cast<long>(k)];
  // Parameters are rounded.
  const double speed = std::max(value.first[0].head<3>().abs().maxCoeff(), value.first[1].head<3>().abs().maxCoeff());
  result.error = root_of_three * (value.error + branches.speed * error_of_z + 0x1p-50 * speed);
  return result;
}

/// Where the next point is expected, at that x.
Point predicted(const Point& from, double x, double order) {
  Point result = from;
  const double ratio = x / from.x;
  result.x = x;
  result.z = from.z * std::pow(ratio, 0.5 * order);
  for (double& s : result.second) s *= ratio;
  return result;
}

/// What is known nearer to the contact than the point, where bounds are tighter.
std::optional<CorankOneBranches> nearer(const ControlNet& first, const CorankOnePatches& patches,
                                        const CorankOneBranches& branches, const Point& point) {
  constexpr double room = 1.01;
  const double far = room * std::fabs(point.x);
  const double across = branches.ridge_slope * far +
                        room * branches.most_ratio * std::pow(far, 0.5 * static_cast<double>(branches.contact.order));
  CellBox box{branches.at, branches.at};
  const std::size_t of_x = branches.contact.exchanged ? 1 : 0;
  (point.x > 0 ? box.upper : box.lower)[of_x] += std::copysign(far, point.x);
  box.lower[1 - of_x] -= across;
  box.upper[1 - of_x] += across;
  auto result = patches.in_box(first, box);
  if (!result || !result->sides[point.x > 0 ? 0 : 1]) return std::nullopt;
  // The function (s, t) there is the one around.
  for (std::size_t k = 0; k < 2; ++k)
    if (!(result->second_reach[k] <= branches.second_reach[k])) return std::nullopt;
  return result;
}

/// The largest step from |x| towards the contact for which the chord is within the tolerance.
double step_from(const CorankOneBranches& branches, double x, double tolerance) {
  // To the half of it at most: between both the bend hardly changes.
  const double half = 0.5 * x;
  const double error = branches.chord_error(half, x);
  return error <= tolerance ? half : half * std::sqrt(tolerance / error);
}

}  // namespace

TracedArc trace_to_corank_one(const ControlNet& first, const ControlNet& second, const CrossingPoint& from,
                              const CellContact& contact, double tolerance, const Context& context) {
  TracedArc arc;
  if (!contact.around.degenerate || contact.contact.corank_one == nullptr) return arc;
  CorankOneBranches branches = *contact.around.degenerate;
  const CorankOnePatches& patches = *contact.contact.corank_one;
  const auto order = static_cast<double>(branches.contact.order);
  PatchJets jets(first);
  // Where ArcTracer ends the arc before it.
  const auto& at = from.parameters;
  const Eigen::Vector4d begin = PatchDifference(first, second).newton({at[0], at[1], at[2], at[3]}).x;
  std::array<double, 4> away{};
  for (std::size_t k = 0; k < 4; ++k) away[k] = begin[static_cast<long>(k)] - contact.contact.rounded[k];
  const auto [x, z] = branches.coordinates_of(away[0], away[1]);
  std::optional<Point> here = patches.point(branches, {x, z, {away[2], away[3]}, 0});
  double last_error = 0;
  constexpr std::size_t most_points = 2000000;
  while (here && arc.points.size() < most_points) {
    if (arc.points.size() % 1024 == 0) context.checkpoint("tracing");
    const double far = std::fabs(here->x);
    constexpr double much_nearer = 0.7;
    if (arc.points.empty() || far < much_nearer * branches.reach)
      if (auto inner = nearer(first, patches, branches, *here)) branches = *std::move(inner);
    const Vertex vertex = vertex_at(jets, branches, patches.parameters(branches, *here), here->error);
    arc.error = std::max(arc.error, last_error + vertex.error);
    arc.points.push_back(vertex.at);
    // Nearer to the contact doubles tell nothing more.
    const double left = branches.last_chord_error(far);
    constexpr double nearest = 1e-12;
    if (left + vertex.error < tolerance || left < vertex.error || far < nearest) {
      const Vertex end = vertex_at(jets, branches, contact.contact.rounded, 0);
      arc.error = std::max(arc.error, left + vertex.error + end.error);
      arc.points.push_back(end.at);
      arc.proven = std::isfinite(arc.error);
      return arc;
    }
    const double room = std::max(0.7 * tolerance, 0.1 * vertex.error);
    const double step = step_from(branches, far, room);
    const double next = std::copysign(far - step, here->x);
    last_error = vertex.error + branches.chord_error(far - step, far);
    here = patches.point(branches, predicted(*here, next, order));
  }
  return {};
}

}  // namespace eliminant::bridge
