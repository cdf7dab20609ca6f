// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/projected_arcs.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <eliminant/bridge/roots/fibre_isolation.hpp>

namespace eliminant::intersect {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

DoubleInterval interval_of(const Coordinate& coordinate) { return enclose(bridge::RealBall(coordinate.ball.real())); }

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

ProjectedArcs::ProjectedArcs(const symbolic::Polynomial& curve, const symbolic::Polynomial& extraneous,
                             const std::array<ProjectiveChange, 2>& changes, const Options& options,
                             const Context& context)
    : changes_(changes) {
  CurveTopologyProblem problem;
  problem.p = curve;
  topology_ = curve_topology(problem, options, context);
  for (std::size_t k = 0; k < 2; ++k) {
    hidden_[k] = symbolic::hide_variable(curve, k);
    extraneous_[k] = symbolic::hide_variable(extraneous, k);
  }
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

double ProjectedArcs::parameter_at(std::size_t arc, double share) const {
  const auto& polyline = topology_.edges[arc].polyline;
  const std::size_t own = arcs_[arc].vertical ? 1 : 0;
  const double position = share * static_cast<double>(polyline.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(position), polyline.size() - 2);
  return polyline[k][own] + (position - static_cast<double>(k)) * (polyline[k + 1][own] - polyline[k][own]);
}

std::vector<double> ProjectedArcs::parameters_beyond(std::size_t arc, double parameter, std::size_t end) const {
  const double limit = end == 1 ? arcs_[arc].inside.upper : arcs_[arc].inside.lower;
  const double sign = end == 1 ? 1 : -1;
  const double room = std::min(1 + std::fabs(parameter), sign * (limit - parameter));
  std::vector<double> result;
  for (const double share : {2e-3, 1e-2, 0.05, 0.2, 0.5})
    if (room > 0) result.push_back(parameter + sign * share * room);
  return result;
}

std::vector<std::size_t> ProjectedArcs::arcs_at(double x) const {
  // Polylines of arcs do not cross, so that their order is that of the arcs. Beyond its polyline an arc goes to
  // infinity, in the order of its last points or along an asymptote.
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t arc = 0; arc < arcs_.size(); ++arc) {
    if (arcs_[arc].vertical || !(arcs_[arc].inside.lower < x && x < arcs_[arc].inside.upper)) continue;
    const auto& polyline = topology_.edges[arc].polyline;
    const auto next = std::find_if(polyline.begin(), polyline.end(), [&](const auto& p) { return p[0] >= x; });
    if (next == polyline.begin() || next == polyline.end()) {
      const bool before = next == polyline.begin();
      const int sign = topology_.vertices[arcs_[arc].ends[before ? 0 : 1]].y_infinite;
      order.emplace_back(sign != 0 ? sign * infinite : (before ? polyline.front() : polyline.back())[1], arc);
      continue;
    }
    const auto& [x1, y1] = *next;
    const auto& [x0, y0] = *(next - 1);
    order.emplace_back(y0 + (y1 - y0) * (x - x0) / (x1 - x0), arc);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> result;
  for (const auto& [y, arc] : order) result.push_back(arc);
  return result;
}

std::vector<DoubleInterval> ProjectedArcs::roots_at(const symbolic::HiddenVariablePolynomial& polynomial,
                                                    const symbolic::Rational& value, const Context& context) {
  if (symbolic::on_vertical_line(polynomial, value).degree() < 1) return {};
  bridge::RationalFibre fibre(polynomial, value, context);
  std::vector<DoubleInterval> roots;
  for (std::size_t k = 0; k < fibre.count(); ++k) roots.push_back(enclose(fibre.refined(k, 60)));
  return roots;
}

std::optional<std::size_t> ProjectedArcs::root_of(std::size_t arc, double parameter,
                                                  const std::vector<DoubleInterval>& roots) const {
  if (!arcs_[arc].vertical) {
    const std::vector<std::size_t> arcs = arcs_at(parameter);
    if (arcs.size() != roots.size()) return std::nullopt;
    return static_cast<std::size_t>(std::find(arcs.begin(), arcs.end(), arc) - arcs.begin());
  }
  // The line x = alpha itself: alpha is enclosed by the coordinates of the vertices at its ends.
  std::optional<std::size_t> found;
  const DoubleInterval alpha = interval_of(topology_.vertices[arcs_[arc].ends[0]].x);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (!overlap(roots[k], alpha)) continue;
    if (found) return std::nullopt;
    found = k;
  }
  return found;
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
  const std::vector<DoubleInterval> roots = roots_at(hidden_[0], from_chart(0, point.inverted[0])(u), context);
  const std::vector<std::size_t> arcs = arcs_at(x);
  if (arcs.size() != roots.size()) return std::nullopt;
  std::optional<std::size_t> index;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    if (!overlap(roots[k], y)) continue;
    if (index) return std::nullopt;
    index = k;
  }
  if (!index) return std::nullopt;
  return arcs[*index];
}

std::array<DoubleInterval, 2> ProjectedArcs::projection(const PointEnclosure& point) const {
  return {from_chart(0, point.inverted[0])(point.box[0]), from_chart(1, point.inverted[3])(point.box[3])};
}

std::optional<std::array<DoubleInterval, 2>> ProjectedArcs::box_between(std::size_t arc,
                                                                        const std::array<DoubleInterval, 2>& from,
                                                                        const std::array<DoubleInterval, 2>& to,
                                                                        const Context& context) const {
  const DoubleInterval x = hull(from[0], to[0]);
  const DoubleInterval y = hull(from[1], to[1]);
  if (arcs_[arc].vertical) return std::array<DoubleInterval, 2>{x, y};
  if (!x.is_finite() || !y.is_finite()) return std::nullopt;
  for (double room = std::max(width(y), 1e-12 * y.magnitude() + 1e-300); room < 1e6 * (width(x) + width(y)) + 1e-9;
       room *= 4) {
    bool free = true;
    for (const double side : {y.lower - room, y.upper + room}) {
      bridge::RationalFibre fibre(hidden_[1], exact(side), context);
      for (std::size_t k = 0; k < fibre.count(); ++k) free = free && !overlap(enclose(fibre.refined(k, 60)), x);
    }
    if (free) return std::array<DoubleInterval, 2>{x, DoubleInterval(y.lower - room, y.upper + room)};
  }
  return std::nullopt;
}

std::optional<BranchSeed> ProjectedArcs::seed_above(const SurfacePair& pair, std::size_t arc, double parameter,
                                                    const Context& context) const {
  const ProjectedArc& where = arcs_[arc];
  const std::size_t own = where.vertical ? 1 : 0;
  // The parameter is a double in the chart of the point.
  const auto suits_inverse = [&](std::size_t kept, double value) { return !(std::fabs(changes_[kept](value)) <= 1); };
  const bool inverted = suits_inverse(own, parameter);
  const ProjectiveChange from = from_chart(own, inverted);
  const double in_chart = from.inverse()(parameter);
  if (!std::isfinite(in_chart) || in_chart == 0) return std::nullopt;
  const symbolic::Rational value = from(exact(in_chart));
  if (!contains(where.inside, enclose(value)) || enclose(value).lower == where.inside.lower) return std::nullopt;
  const std::vector<DoubleInterval> roots = roots_at(hidden_[own], value, context);
  const auto index = root_of(arc, parameter, roots);
  if (!index || *index >= roots.size()) return std::nullopt;
  const DoubleInterval root = roots[*index];
  double gap = 1 + root.magnitude();
  if (*index > 0) gap = std::min(gap, root.lower - roots[*index - 1].upper);
  if (*index + 1 < roots.size()) gap = std::min(gap, roots[*index + 1].lower - root.upper);
  for (const DoubleInterval& other : roots_at(extraneous_[own], value, context))
    gap = std::min(gap, std::max(root.lower - other.upper, other.lower - root.upper));
  if (!(gap > 0)) return std::nullopt;

  BranchSeed seed;
  seed.arc = arc;
  seed.axis = where.vertical ? 3 : 0;
  const std::size_t other = 3 - seed.axis;
  const bool other_inverted = suits_inverse(1 - own, middle(root));
  const Charts charts{own == 0 ? inverted : other_inverted, false, false, own == 0 ? other_inverted : inverted};
  const ProjectiveChange to = from_chart(1 - own, other_inverted).inverse();
  std::array<DoubleInterval, 2> kept;
  kept[own] = DoubleInterval(in_chart);
  kept[1 - own] = to(root);
  DoubleInterval isolated = to(DoubleInterval(root.lower - gap / 3, root.upper + gap / 3));
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
