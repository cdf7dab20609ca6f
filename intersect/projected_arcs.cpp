// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/projected_arcs.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <eliminant/bridge/fibre_isolation.hpp>

namespace eliminant::intersect {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

DoubleInterval interval_of(const bridge::RealBall& ball) {
  arf_t lower;
  arf_t upper;
  arf_init(lower);
  arf_init(upper);
  arb_get_interval_arf(lower, upper, ball.get(), 80);
  const DoubleInterval result{arf_get_d(lower, ARF_RND_FLOOR), arf_get_d(upper, ARF_RND_CEIL)};
  arf_clear(lower);
  arf_clear(upper);
  return result;
}

DoubleInterval interval_of(const Coordinate& coordinate) {
  return interval_of(bridge::RealBall(coordinate.ball.real()));
}

symbolic::Rational exact(double value) {
  arf_t number;
  arf_init(number);
  arf_set_d(number, value);
  symbolic::Rational result;
  arf_get_fmpq(result.get(), number);
  arf_clear(number);
  return result;
}

}  // namespace

ProjectedArcs::ProjectedArcs(const symbolic::Polynomial& curve, const std::array<ProjectiveChange, 2>& changes,
                             const Options& options, const Context& context)
    : changes_(changes) {
  CurveTopologyProblem problem;
  problem.p = curve;
  topology_ = curve_topology(problem, options, context);
  for (std::size_t k = 0; k < 2; ++k) hidden_[k] = symbolic::hide_variable(curve, k);
  for (const TopologyEdge& edge : topology_.edges) {
    ProjectedArc arc;
    arc.ends = {edge.from, edge.to};
    const TopologyVertex& from = topology_.vertices[edge.from];
    const TopologyVertex& to = topology_.vertices[edge.to];
    arc.vertical = edge.polyline.front()[0] == edge.polyline.back()[0] && from.x_infinite == 0 && to.x_infinite == 0 &&
                   from.vertical + to.vertical + (from.kind == VertexKind::infinity ? 1U : 0U) +
                           (to.kind == VertexKind::infinity ? 1U : 0U) >
                       1;
    if (arc.vertical) {
      arc.inside = {from.y_infinite < 0 ? -infinite : interval_of(from.y).upper,
                    to.y_infinite > 0 ? infinite : interval_of(to.y).lower};
    } else {
      arc.inside = {from.x_infinite < 0 ? -infinite : interval_of(from.x).upper,
                    to.x_infinite > 0 ? infinite : interval_of(to.x).lower};
    }
    arcs_.push_back(arc);
  }
}

std::array<DoubleInterval, 2> ProjectedArcs::enclosure(std::size_t vertex) const {
  return {interval_of(topology_.vertices[vertex].x), interval_of(topology_.vertices[vertex].y)};
}

std::optional<std::array<DoubleInterval, 2>> ProjectedArcs::isolated_root(std::size_t arc,
                                                                          const symbolic::Rational& value, double near,
                                                                          const Context& context) const {
  const bool vertical = arcs_[arc].vertical;
  bridge::RationalFibre fibre(hidden_[vertical ? 1 : 0], value, context);
  std::vector<DoubleInterval> roots;
  for (std::size_t k = 0; k < fibre.count(); ++k) roots.push_back(interval_of(fibre.refined(k, 60)));
  // A point of a polyline is within the error of its arc: exactly one root may be that near.
  const double tolerance = 4 * topology_.error + 1e-9 * (1 + std::fabs(near));
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (!overlap(roots[k], DoubleInterval(near - tolerance, near + tolerance))) continue;
    if (found) return std::nullopt;
    found = k;
  }
  if (!found) return std::nullopt;
  const DoubleInterval root = roots[*found];
  double gap = 1 + std::fabs(near);
  for (std::size_t k = 0; k < roots.size(); ++k)
    if (k != *found)
      gap = std::min(gap, k < *found ? root.lower - roots[k].upper : roots[k].lower - root.upper);
  if (!(gap > 0)) return std::nullopt;
  return std::array<DoubleInterval, 2>{root, DoubleInterval(root.lower - gap / 3, root.upper + gap / 3)};
}

std::vector<double> ProjectedArcs::shares_beyond(std::size_t arc, double parameter, std::size_t end) const {
  const auto& polyline = topology_.edges[arc].polyline;
  const std::size_t own = arcs_[arc].vertical ? 1 : 0;
  std::vector<double> result;
  if (arcs_[arc].vertical) return result;
  const double last = static_cast<double>(polyline.size() - 1);
  for (std::size_t k = 1; k + 1 < polyline.size(); ++k) {
    const std::size_t at = end == 1 ? k : polyline.size() - 1 - k;
    const bool beyond = end == 1 ? polyline[at][own] > parameter : polyline[at][own] < parameter;
    if (beyond) result.push_back((static_cast<double>(at) + 0.25) / last);
  }
  return result;
}

std::optional<std::size_t> ProjectedArcs::arc_below(const SurfacePair& pair, const PointEnclosure& point,
                                                    const Context& context) const {
  BranchPoint start{point.inverted, {}};
  for (std::size_t i = 0; i < 4; ++i) start.at[i] = middle(point.box[i]);
  const auto above = enclose_branch_point(pair, start, 0);
  if (!above) return std::nullopt;
  for (std::size_t i = 0; i < 4; ++i)
    if (!overlap(above->box[i], point.box[i])) return std::nullopt;
  const symbolic::Rational u = exact(start.at[0]);
  if (u.is_zero() && point.inverted[0]) return std::nullopt;
  const double x = from_chart(0, point.inverted[0])(start.at[0]);
  const DoubleInterval y = projection(*above)[1];
  bridge::RationalFibre fibre(hidden_[0], from_chart(0, point.inverted[0])(u), context);
  std::optional<std::size_t> index;
  for (std::size_t k = 0; k < fibre.count(); ++k) {
    if (!overlap(interval_of(fibre.refined(k, 60)), y)) continue;
    if (index) return std::nullopt;
    index = k;
  }
  if (!index) return std::nullopt;
  // Polylines of arcs do not cross: their order is that of the roots.
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t arc = 0; arc < arcs_.size(); ++arc) {
    if (arcs_[arc].vertical || !(arcs_[arc].inside.lower < x && x < arcs_[arc].inside.upper)) continue;
    const auto& polyline = topology_.edges[arc].polyline;
    const auto next = std::find_if(polyline.begin(), polyline.end(), [&](const auto& p) { return p[0] >= x; });
    if (next == polyline.begin() || next == polyline.end()) return std::nullopt;
    const auto& [x1, y1] = *next;
    const auto& [x0, y0] = *(next - 1);
    order.emplace_back(y0 + (y1 - y0) * (x - x0) / (x1 - x0), arc);
  }
  if (order.size() != fibre.count()) return std::nullopt;
  std::sort(order.begin(), order.end());
  return order[*index].second;
}

std::array<DoubleInterval, 2> ProjectedArcs::projection(const PointEnclosure& point) const {
  return {from_chart(0, point.inverted[0])(point.box[0]), from_chart(1, point.inverted[3])(point.box[3])};
}

std::optional<std::array<DoubleInterval, 2>> ProjectedArcs::box_between(std::size_t arc,
                                                                        const std::array<DoubleInterval, 2>& from,
                                                                        const std::array<DoubleInterval, 2>& to,
                                                                        const Context& context) const {
  if (arcs_[arc].vertical) return std::nullopt;
  const DoubleInterval x = hull(from[0], to[0]);
  const DoubleInterval y = hull(from[1], to[1]);
  if (!x.is_finite() || !y.is_finite()) return std::nullopt;
  for (double room = std::max(width(y), 1e-12 * y.magnitude() + 1e-300); room < 1e6 * (width(x) + width(y)) + 1e-9;
       room *= 4) {
    bool free = true;
    for (const double side : {y.lower - room, y.upper + room}) {
      bridge::RationalFibre fibre(hidden_[1], exact(side), context);
      for (std::size_t k = 0; k < fibre.count(); ++k)
        free = free && !overlap(interval_of(fibre.refined(k, 60)), x);
    }
    if (free) return std::array<DoubleInterval, 2>{x, DoubleInterval(y.lower - room, y.upper + room)};
  }
  return std::nullopt;
}

std::optional<BranchSeed> ProjectedArcs::seed_above(const SurfacePair& pair, std::size_t arc, double share,
                                                    const Context& context) const {
  const ProjectedArc& where = arcs_[arc];
  const auto& polyline = topology_.edges[arc].polyline;
  const std::size_t own = where.vertical ? 1 : 0;
  const double position = share * static_cast<double>(polyline.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(position), polyline.size() - 2);
  std::array<double, 2> start = polyline[k];
  if (where.vertical)
    for (std::size_t i = 0; i < 2; ++i)
      start[i] += (position - static_cast<double>(k)) * (polyline[k + 1][i] - polyline[k][i]);
  else if (k == 0)
    start = polyline[1];
  if (!(where.inside.lower < start[own] && start[own] < where.inside.upper)) return std::nullopt;
  // The value is a double in the chart of the point.
  const auto suits_inverse = [&](std::size_t kept, double value) { return !(std::fabs(changes_[kept](value)) <= 1); };
  const bool inverted = suits_inverse(own, start[own]);
  const ProjectiveChange from = from_chart(own, inverted);
  const double in_chart = from.inverse()(start[own]);
  const auto root = isolated_root(arc, from(exact(in_chart)), start[1 - own], context);
  if (!root) return std::nullopt;

  BranchSeed seed;
  seed.arc = arc;
  seed.axis = where.vertical ? 3 : 0;
  const std::size_t other = 3 - seed.axis;
  const bool other_inverted = suits_inverse(1 - own, middle((*root)[0]));
  const Charts charts{own == 0 ? inverted : other_inverted, false, false, own == 0 ? other_inverted : inverted};
  const ProjectiveChange to = from_chart(1 - own, other_inverted).inverse();
  std::array<DoubleInterval, 2> kept;
  kept[own] = DoubleInterval(in_chart);
  kept[1 - own] = to((*root)[0]);
  DoubleInterval isolated = to((*root)[1]);
  if (!isolated.is_finite()) isolated = kept[1 - own];
  for (const double side : {0.25, 1.0 / 32, 1.0 / 512}) {
    const auto boxes = fibre_boxes(pair, charts, kept[0], kept[1], side, 4000);
    if (!boxes) return std::nullopt;
    for (const FibreBox& box : *boxes) {
      BranchPoint point{box.inverted, {}};
      for (std::size_t i = 0; i < 4; ++i) point.at[i] = middle(box.box[i]);
      const auto enclosure = enclose_branch_point(pair, point, seed.axis);
      if (!enclosure || !contains(isolated, enclosure->box[other])) continue;
      seed.point = *enclosure;
      seed.isolated = isolated;
      return seed;
    }
    if (boxes->empty()) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace eliminant::intersect
