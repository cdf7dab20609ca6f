// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/section_graph.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <eliminant/symbolic/elimination/infinite_base_points.hpp>

namespace eliminant::intersect {

namespace {

using bridge::BallCurve;
using bridge::PlaneBall;
using symbolic::Polynomial;

constexpr long precision_bits = 256;

Polynomial product_of(const std::vector<SectionFactor>& factors) {
  Polynomial product = Polynomial::constant(2, symbolic::Rational(1));
  for (const SectionFactor& factor : factors) product = product * factor.factor;
  return product;
}

TopologyResult topology_of(const symbolic::SurfacePiece& patch, const std::vector<SectionFactor>& factors,
                           const Options& options, const Context& context) {
  CurveTopologyProblem problem;
  problem.p = product_of(factors);
  problem.variables = {"u", "v"};
  const auto& sides = patch.region->sides;
  problem.box = Box{{sides[0].lower, sides[0].upper}, {sides[1].lower, sides[1].upper}};
  Options own = options;
  own.engine = Engine::automatic;
  own.digits = 17;
  return curve_topology(problem, own, context);
}

PlaneBall ball_around(const std::array<double, 2>& point, double radius) {
  PlaneBall ball;
  for (std::size_t k = 0; k < 2; ++k) {
    acb_ptr z = (k == 0 ? ball.x : ball.y).get();
    acb_set_d(z, point[k]);
    mag_set_d(arb_radref(acb_realref(z)), radius);
  }
  return ball;
}

}  // namespace

SectionGraph::SectionGraph(const symbolic::SurfacePiece& patch, std::vector<SectionFactor> factors,
                           bool weight_has_one_sign, const SideRoles& roles, const Options& options,
                           const Context& context)
    : factors_(std::move(factors)),
      polynomials_(patch.map.coordinates()),
      domain_(patch.region->sides),
      topology_(topology_of(patch, factors_, options, context)),
      infinite_around_origin_(!weight_has_one_sign && symbolic::is_infinite_around_origin(patch.map)) {
  for (const SectionFactor& factor : factors_) balls_.emplace_back(factor.factor);
  for (const Polynomial& p : polynomials_) coordinates_.emplace_back(p);
  complete_ = topology_.status == Status::certified;
  describe_vertices(patch, weight_has_one_sign);
  describe_edges(roles);
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    SectionVertex& vertex = vertices_[v];
    vertex.passes =
        vertex.ends == 2 && !vertex.at_infinity && !vertex.group && topology_.vertices[v].kind != VertexKind::singular;
  }
}

PlaneBall SectionGraph::place_of(const TopologyVertex& vertex) const { return {vertex.x.ball, vertex.y.ball}; }

bool SectionGraph::may_vanish(const BallCurve& curve, const PlaneBall& at) const {
  return acb_contains_zero(curve.value(at, precision_bits).get()) != 0;
}

bool SectionGraph::is_singular_for(std::size_t factor, std::size_t vertex) const {
  const bridge::BallJet jet = balls_[factor].jet(place_of(topology_.vertices[vertex]), precision_bits);
  return acb_contains_zero(jet.dx.get()) != 0 && acb_contains_zero(jet.dy.get()) != 0;
}

bool SectionGraph::is_origin(std::size_t factor, std::size_t vertex) const {
  // Of all points at which factors and weight meet only one is in the box of a vertex.
  const PlaneBall at = place_of(topology_.vertices[vertex]);
  return factors_[factor].factor.constant_term().is_zero() && acb_contains_zero(at.x.get()) != 0 &&
         acb_contains_zero(at.y.get()) != 0;
}

std::optional<unsigned long> SectionGraph::order_along(std::size_t factor, std::size_t coordinate, std::size_t vertex,
                                                       const Options& options, const Context& context) const {
  PlaneCurvesProblem problem;
  problem.p = factors_[factor].factor;
  problem.q = polynomials_[coordinate];
  const Result result = intersect_plane_curves(problem, options, context);
  if (result.status != Status::certified) return std::nullopt;
  const PlaneBall at = place_of(topology_.vertices[vertex]);
  std::optional<unsigned long> order;
  for (const Solution& solution : result.solutions) {
    if (acb_overlaps(solution.x.ball.get(), at.x.get()) == 0 || acb_overlaps(solution.y.ball.get(), at.y.get()) == 0)
      continue;
    if (order) return std::nullopt;
    order = solution.multiplicity;
  }
  return order;
}

bool SectionGraph::goes_to_infinity(std::size_t factor, std::size_t base_point, const Options& options,
                                    const Context& context) const {
  if (infinite_around_origin_ && is_origin(factor, base_point)) return true;
  if (is_singular_for(factor, base_point)) return false;
  Options own = options;
  own.engine = Engine::automatic;
  own.digits = 17;
  own.field = Field::real;
  const auto weight = order_along(factor, 3, base_point, own, context);
  if (!weight) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (const auto order = order_along(factor, k, base_point, own, context); order && *order < *weight) return true;
  return false;
}

void SectionGraph::describe_vertices(const symbolic::SurfacePiece& patch, bool weight_has_one_sign) {
  for (const TopologyVertex& vertex : topology_.vertices) {
    SectionVertex own;
    const PlaneBall at = place_of(vertex);
    for (std::size_t f = 0; f < factors_.size(); ++f)
      own.on_curve = own.on_curve || (factors_[f].kind == SectionFactorKind::curve && may_vanish(balls_[f], at));
    own.at_infinity = !weight_has_one_sign && may_vanish(coordinates_[3], at);
    own.base_point = own.at_infinity && std::all_of(coordinates_.begin(), coordinates_.end(),
                                                    [&](const BallCurve& p) { return may_vanish(p, at); });
    for (std::size_t k = 0; k < 2; ++k) {
      const arb_srcptr coordinate = (k == 0 ? vertex.x : vertex.y).ball.real();
      const symbolic::Interval& side = patch.region->sides[k];
      if (!vertex.on_border) continue;
      if (arb_contains_fmpq(coordinate, side.lower.get()) != 0) own.side[k] = -1;
      if (arb_contains_fmpq(coordinate, side.upper.get()) != 0) own.side[k] = 1;
    }
    vertices_.push_back(own);
  }
}

std::optional<SectionEdge> SectionGraph::identified_at(const std::array<double, 2>& point, bool vertical) const {
  SectionEdge edge;
  edge.sample = point;
  edge.vertical = vertical;
  edge.radius = 8 * topology_.error + 0x1p-48 * std::max({1.0, std::fabs(point[0]), std::fabs(point[1])});
  const PlaneBall ball = ball_around(point, edge.radius);
  std::optional<std::size_t> found;
  for (std::size_t f = 0; f < factors_.size(); ++f) {
    if (!may_vanish(balls_[f], ball)) continue;
    if (found) return std::nullopt;
    found = f;
  }
  if (!found) return std::nullopt;
  edge.factor = *found;
  if (factors_[*found].kind != SectionFactorKind::curve) return edge;
  const bridge::BallSlopes slopes = balls_[*found].slopes_on(ball, precision_bits);
  if (acb_contains_zero((vertical ? slopes.dx : slopes.dy).get()) != 0) return std::nullopt;
  const bridge::ComplexBall weight = coordinates_[3].value(ball, precision_bits);
  if (arb_contains_zero(weight.real()) != 0) return std::nullopt;
  edge.weight_sign = arb_is_negative(weight.real()) != 0 ? -1 : 1;
  return edge;
}

std::optional<SectionEdge> SectionGraph::identified(const TopologyEdge& edge) const {
  const auto& line = edge.polyline;
  const std::size_t n = line.size();
  if (n < 2) return std::nullopt;
  if (line.front()[0] == line.back()[0])
    return identified_at({line.front()[0], 0.5 * (line.front()[1] + line.back()[1])}, true);
  // From the middle to the ends.
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = k % 2 == 0 ? n / 2 + k / 2 : n / 2 - (k + 1) / 2;
    if (i == 0 || i + 1 >= n) continue;
    if (const auto found = identified_at(line[i], false)) return found;
  }
  return std::nullopt;
}

bool SectionGraph::is_on_other_seam(const TopologyEdge& edge, const SideRoles& roles) const {
  if (!edge.on_border) return false;
  for (std::size_t k = 0; k < 2; ++k) {
    const int side = vertices_[edge.from].side[k];
    if (side != 0 && side == vertices_[edge.to].side[k] && roles[k][side < 0 ? 0 : 1] == SideRole::other_seam) {
      // An arc from the border to itself through the inside is none.
      const double at = edge.polyline[edge.polyline.size() / 2][k];
      const double end = edge.polyline.front()[k];
      if (std::fabs(at - end) <= 1e-13 * std::max(1.0, std::fabs(end))) return true;
    }
  }
  return false;
}

void SectionGraph::describe_edges(const SideRoles& roles) {
  std::vector<std::size_t> point_edges;
  edges_.resize(topology_.edges.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const TopologyEdge& edge = topology_.edges[e];
    const std::optional<SectionEdge> found = identified(edge);
    if (!found) {
      complete_ = false;
      continue;
    }
    const SectionFactorKind kind = factors_[found->factor].kind;
    if (kind == SectionFactorKind::point) point_edges.push_back(e);
    if (kind != SectionFactorKind::curve) continue;
    const bool elsewhere = is_on_other_seam(edge, roles);
    for (const std::size_t end : {edge.from, edge.to}) ++(elsewhere ? vertices_[end].elsewhere : vertices_[end].ends);
    if (!elsewhere) edges_[e] = found;
  }
  gather_groups(point_edges);
}

void SectionGraph::gather_groups(const std::vector<std::size_t>& point_edges) {
  std::vector<std::size_t> parent(vertices_.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root_of = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v];
    return v;
  };
  std::vector<bool> in_group(vertices_.size(), false);
  for (const std::size_t e : point_edges) {
    const TopologyEdge& edge = topology_.edges[e];
    parent[root_of(edge.from)] = root_of(edge.to);
    in_group[edge.from] = in_group[edge.to] = true;
  }
  std::vector<std::optional<std::size_t>> group_of(vertices_.size());
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    if (!in_group[v]) continue;
    auto& group = group_of[root_of(v)];
    if (!group) {
      group = groups_.size();
      groups_.emplace_back();
    }
    vertices_[v].group = group;
    groups_[*group].push_back(v);
  }
}

std::vector<BranchChain> SectionGraph::chains() const {
  bridge::BranchGraph graph;
  // A vertex at which branches end becomes one point for each of them.
  std::vector<std::size_t> vertex_of;
  std::vector<std::optional<std::size_t>> point_of(vertices_.size());
  const auto point_at = [&](std::size_t vertex) {
    if (vertices_[vertex].passes && point_of[vertex]) return *point_of[vertex];
    vertex_of.push_back(vertex);
    graph.points.emplace_back();
    point_of[vertex] = vertex_of.size() - 1;
    return vertex_of.size() - 1;
  };
  std::vector<std::size_t> edge_of;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (!edges_[e]) continue;
    bridge::CellArc arc;
    arc.from = point_at(topology_.edges[e].from);
    arc.to = point_at(topology_.edges[e].to);
    graph.arcs.push_back(arc);
    edge_of.push_back(e);
  }
  std::vector<BranchChain> chains = branch_chains(graph);
  for (BranchChain& chain : chains) {
    for (std::size_t& arc : chain.arcs) arc = edge_of[arc];
    chain.start = vertex_of[chain.start];
    chain.end = vertex_of[chain.end];
  }
  return chains;
}

}  // namespace eliminant::intersect
