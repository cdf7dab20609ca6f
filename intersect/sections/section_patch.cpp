// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/section_patch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/branches/section_tracing.hpp>
#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/nets/function_net.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/intersect/patches/branch_joining.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/surface_summary.hpp>
#include <eliminant/intersect/sections/section_frame.hpp>
#include <eliminant/intersect/sections/section_graph.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

class PatchSection {
 public:
  PatchSection(const symbolic::SurfacePiece& patch, const Polynomial& equation, const SideRoles& roles,
               const Options& options, const Context& context)
      : patch_(patch),
        equation_(equation),
        roles_(roles),
        options_(options),
        context_(context),
        frame_(patch, prepared_patch(patch, "parametrised")) {}

  SurfaceResult run() && {
    result_.engine.method = "equation";
    result_.status = Status::certified;
    const Polynomial section = section_polynomial(patch_.map, equation_);
    if (section.is_zero()) {
      add_overlap();
      return std::move(result_);
    }
    if (!prepare(section)) return std::move(result_);
    find();
    return std::move(result_);
  }

 private:
  void add_overlap() {
    SurfaceComponent component;
    component.kind = SurfaceComponentKind::overlap;
    for (const auto& [u, v] : {std::pair(0U, 0U), std::pair(1U, 0U), std::pair(1U, 1U), std::pair(0U, 1U)})
      component.points.push_back(frame_.corner(u, v));
    component.certified = options_.certify;
    result_.components.push_back(std::move(component));
    result_.status = Status::infinite;
  }

  /// The factors that have zeros in the domain, and the nets; false when there is nothing to do.
  bool prepare(const Polynomial& section) {
    factors_ = section_factors(patch_.map, section, options_.seed);
    std::erase_if(factors_, [&](const SectionFactor& factor) {
      return bridge::excludes_zero(bridge::function_net(factor.factor, patch_.region->sides), {0, 0}, {1, 1});
    });
    for (const SectionFactor& factor : factors_)
      if (factor.kind == SectionFactorKind::at_infinity) {
        const std::vector<std::string> names{"u", "v"};
        result_.warnings.push_back("the factor " + to_string(factor.factor, names) +
                                   " of the equation on the surface was left out: its zeros lie at infinity");
      }
    std::erase_if(factors_, [](const SectionFactor& factor) { return factor.kind == SectionFactorKind::at_infinity; });
    if (factors_.empty()) return false;
    if (!frame_.weight_has_one_sign())
      for (SectionFactor& factor : section_factors(patch_.map, patch_.map.coordinates()[3], options_.seed))
        factors_.push_back(std::move(factor));
    return true;
  }

  void find() {
    graph_.emplace(patch_, factors_, frame_.weight_has_one_sign(), roles_, options_, context_);
    if (!graph_->complete()) {
      result_.status = Status::numeric;
      result_.warnings.emplace_back(topology_not_proven);
    }
    if (!frame_.round()) {
      result_.status = Status::numeric;
      result_.warnings.emplace_back(beyond_doubles);
      return;
    }
    for (const SectionFactor& factor : graph_->factors())
      functions_.push_back(bridge::function_net(factor.factor, patch_.region->sides));
    scale_ = frame_.weight_has_one_sign() ? size_of(frame_.net()) : size_of_curve();
    add_points();
    for (const BranchChain& chain : graph_->chains()) add_chain(chain);
    if (!graph_->complete()) doubt_everything();
    summarise(result_);
  }

  /// Without the topology even the kind of a component is not known: what looks like a point may be a small loop.
  void doubt_everything() {
    const std::string reason = topology_not_proven;
    const auto doubt = [&](auto& part) {
      part.certified = false;
      if (part.reason.empty()) part.reason = reason;
    };
    std::for_each(result_.components.begin(), result_.components.end(), doubt);
    std::for_each(result_.singular_points.begin(), result_.singular_points.end(), doubt);
  }

  /// Half of the arcs have their middles within that distance.
  double size_of_curve() const {
    std::vector<double> sizes;
    for (const auto& edge : graph_->edges()) {
      if (!edge) continue;
      const auto local = frame_.to_local(edge->sample);
      const Eigen::Array4d point = frame_.jets_at(local, edge->weight_sign).point;
      const double size = point.abs().head<3>().maxCoeff();
      if (std::isfinite(size)) sizes.push_back(size);
    }
    if (sizes.empty()) return 1;
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<long>(sizes.size() / 2), sizes.end());
    const double median = sizes[sizes.size() / 2];
    return median > 0 ? median : 1;
  }

  bridge::SectionGoal place_of(std::size_t vertex) const {
    return frame_.place_of(graph_->topology().vertices[vertex], graph_->vertices()[vertex].side);
  }

  bridge::PatchJets::Value jets_of(const bridge::SectionGoal& at) const {
    // Quotients by the weight do not depend on its sign.
    return frame_.jets_at(at.at, 1);
  }

  SurfacePoint placed(std::size_t vertex) const {
    const bridge::SectionGoal at = place_of(vertex);
    const Eigen::Array4d point = jets_of(at).point;
    return frame_.placed(at.at, {point[0], point[1], point[2]});
  }

  double error_at(std::size_t vertex) const {
    const bridge::SectionGoal at = place_of(vertex);
    const bridge::PatchJets::Value value = jets_of(at);
    const double slope = std::max(value.first[0].abs().head<3>().maxCoeff(), value.first[1].abs().head<3>().maxCoeff());
    return 8 * slope * at.radius + 2 * value.error + 1e-14 * scale_;
  }

  /// Those of groups first.
  void add_points() {
    for (const std::vector<std::size_t>& group : graph_->groups()) {
      group_points_.push_back(std::nullopt);
      const auto finite =
          std::find_if(group.begin(), group.end(), [&](std::size_t v) { return !graph_->vertices()[v].at_infinity; });
      if (finite == group.end()) continue;
      SurfaceSingularPoint point;
      point.at = placed(*finite);
      point.radius = error_at(*finite);
      point.certified = options_.certify;
      if (std::any_of(group.begin(), group.end(), [&](std::size_t v) {
            return graph_->vertices()[v].base_point && graph_->vertices()[v].ends > 0;
          })) {
        point.certified = false;
        point.reason = "curves end at a base point there, where the surface is not defined";
      }
      const std::array<double, 4> first = placed(group.front()).parameters;
      for (std::size_t k = 0; k < 2; ++k)
        if (std::any_of(group.begin(), group.end(), [&](std::size_t v) {
              return std::fabs(placed(v).parameters[k] - first[k]) > 1e-12 * std::max(1.0, std::fabs(first[k]));
            }))
          point.at.parameters[k] = unknown;
      group_points_.back() = result_.singular_points.size();
      result_.singular_points.push_back(point);
    }
    vertex_points_.resize(graph_->vertices().size());
    for (std::size_t v = 0; v < vertex_points_.size(); ++v) add_vertex(v);
  }

  void add_vertex(std::size_t v) {
    const SectionVertex& own = graph_->vertices()[v];
    const TopologyVertex& vertex = graph_->topology().vertices[v];
    if (!own.on_curve || own.group) return;
    if (own.at_infinity) {
      return;
    }
    const bool isolated = vertex.half_branches() == 0;
    if (vertex.kind == VertexKind::singular && (own.ends > 0 || own.elsewhere > 0 || isolated)) {
      SurfaceSingularPoint point;
      point.at = placed(v);
      point.half_branches = vertex.half_branches();
      point.kind = isolated                                                ? SurfaceSingularity::contact
                   : point.half_branches == 4 && vertex.milnor_number == 1 ? SurfaceSingularity::crossing
                                                                           : SurfaceSingularity::cusp;
      point.radius = std::max(error_at(v), std::pow(10.0, static_cast<double>(vertex.radius_exponent)));
      point.certified = vertex.certified;
      vertex_points_[v] = result_.singular_points.size();
      result_.singular_points.push_back(point);
    }
    if (own.ends > 0 || own.elsewhere > 0) return;
    SurfaceComponent component;
    component.kind = SurfaceComponentKind::point;
    component.points.push_back(placed(v));
    component.tangential = isolated;
    if (!isolated) component.start.side = {own.side[0], own.side[1], 0, 0};
    component.end = component.start;
    component.error = error_at(v);
    component.certified = vertex.certified;
    result_.components.push_back(std::move(component));
  }

  void add_chain(const BranchChain& chain) {
    SurfaceComponent component;
    component.kind = chain.closed ? SurfaceComponentKind::loop : SurfaceComponentKind::curve;
    component.certified = options_.certify;
    for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
      bridge::SectionArc arc = traced(chain.arcs[i], component);
      const SectionEdge& edge = *graph_->edges()[chain.arcs[i]];
      component.tangential = component.tangential || graph_->factors()[edge.factor].multiplicity > 1;
      if (chain.reversed[i]) std::reverse(arc.points.begin(), arc.points.end());
      for (std::size_t k = component.points.empty() ? 0 : 1; k < arc.points.size(); ++k)
        component.points.push_back(frame_.placed(arc.points[k].parameters, arc.points[k].point));
    }
    double largest = scale_;
    for (const SurfacePoint& point : component.points)
      for (const double x : point.point) largest = std::max(largest, std::fabs(x));
    component.error += 1e-14 * largest;
    if (chain.closed) {
      component.points.back() = component.points.front();
    } else {
      component.start = end_at(chain.start, chain.arcs.front(), component);
      component.end = end_at(chain.end, chain.arcs.back(), component);
    }
    result_.components.push_back(std::move(component));
  }

  /// From one end of an edge to the other.
  bridge::SectionArc traced(std::size_t e, SurfaceComponent& component) {
    const TopologyEdge& edge = graph_->topology().edges[e];
    const SectionEdge& own = *graph_->edges()[e];
    const bridge::SectionTracer tracer(frame_.net_for(own.weight_sign), functions_[own.factor]);
    bridge::SectionSeed seed{frame_.to_local(own.sample), frame_.to_local_length(own.radius), {}};
    bridge::SectionArc whole;
    for (const bool forward : {false, true}) {
      seed.side[own.vertical ? 1 : 0] = forward ? 1 : -1;
      bridge::SectionGoal goal = goal_at(forward ? edge.to : edge.from, own.factor);
      goal.monotone = !own.vertical;
      bridge::SectionArc arc = tracer.trace(seed, goal, options_.tolerance * scale_, scale_, context_);
      component.error = std::max(component.error, arc.error);
      if (!arc.proven) doubt(component, arc);
      if (forward) {
        whole.points.insert(whole.points.end(), arc.points.begin() + 1, arc.points.end());
      } else {
        whole.points.assign(arc.points.rbegin(), arc.points.rend());
      }
    }
    return whole;
  }

  void doubt(SurfaceComponent& component, const bridge::SectionArc& arc) const {
    component.certified = false;
    const std::array<double, 2>& at = arc.points.back().parameters;
    component.reason = "the distance of the polyline from the curve is not proven near u = " +
                       std::to_string(frame_.to_domain(0, at[0])) +
                       ", v = " + std::to_string(frame_.to_domain(1, at[1]));
  }

  bridge::SectionGoal goal_at(std::size_t v, std::size_t factor) const {
    bridge::SectionGoal goal = place_of(v);
    const TopologyVertex& vertex = graph_->topology().vertices[v];
    if (graph_->vertices()[v].at_infinity)
      goal.kind = bridge::SectionEnd::infinity;
    else if (vertex.kind != VertexKind::singular || !graph_->is_singular_for(factor, v))
      goal.kind = bridge::SectionEnd::regular;
    else if (vertex.milnor_number == 1 && vertex.half_branches() == 4)
      goal.kind = bridge::SectionEnd::node;
    else
      goal.kind = bridge::SectionEnd::singular;
    return goal;
  }

  BranchEnd end_at(std::size_t v, std::size_t edge, SurfaceComponent& component) {
    const SectionVertex& own = graph_->vertices()[v];
    BranchEnd end;
    end.side = {own.side[0], own.side[1], 0, 0};
    const auto is_border = [&](std::size_t k) {
      return own.side[k] != 0 && roles_[k][own.side[k] < 0 ? 0 : 1] == SideRole::border;
    };
    if (own.at_infinity) {
      const std::size_t factor = graph_->edges()[edge]->factor;
      const bool known = !own.base_point || graph_->goes_to_infinity(factor, v, options_, context_);
      end.kind = known ? BranchEndKind::infinity : BranchEndKind::unknown;
      if (!known) {
        component.certified = false;
        component.reason = "it ends at a base point, where the surface is not defined";
      }
    } else if (own.group) {
      end.kind = is_border(0) || is_border(1) ? BranchEndKind::border : BranchEndKind::singular;
      end.singular_point = group_points_[*own.group];
    } else if (vertex_points_[v]) {
      end.kind = BranchEndKind::singular;
      end.singular_point = vertex_points_[v];
    } else if (own.side[0] != 0 || own.side[1] != 0) {
      end.transition = transition_at(v, is_border(0) ? 0 : 1);
    } else {
      end.kind = BranchEndKind::unknown;
      component.certified = false;
      component.reason = "an end is not understood";
    }
    return end;
  }

  /// The border followed by its parameter crosses F = 0 to greater values of F: out.
  Transition transition_at(std::size_t v, std::size_t axis) const {
    const bridge::SectionGoal at = place_of(v);
    const bridge::ControlNet section =
        bridge::function_net(section_polynomial(patch_.map, equation_), patch_.region->sides);
    double slope = bridge::PatchJets(section).at(at.at[0], at.at[1]).first[1 - axis][0];
    // The section is F, made primitive, times a power of the weight.
    if (equation_.terms().front().coefficient.sign() < 0) slope = -slope;
    const auto weight = bridge::function_net(patch_.map.coordinates()[3], patch_.region->sides);
    if (bridge::PatchJets(weight).at(at.at[0], at.at[1]).point[0] < 0 && equation_.total_degree() % 2 != 0)
      slope = -slope;
    constexpr double undecided = 1e-10;
    if (!(std::fabs(slope) > undecided)) return Transition::touching;
    return slope > 0 ? Transition::out : Transition::in;
  }

  const symbolic::SurfacePiece& patch_;
  const Polynomial& equation_;
  const SideRoles& roles_;
  const Options& options_;
  const Context& context_;
  SectionFrame frame_;
  std::vector<SectionFactor> factors_;
  std::optional<SectionGraph> graph_;
  /// Of each factor.
  std::vector<bridge::ControlNet> functions_;
  double scale_ = 1;
  /// Indices of singular points.
  std::vector<std::optional<std::size_t>> group_points_;
  std::vector<std::optional<std::size_t>> vertex_points_;
  SurfaceResult result_;
};

}  // namespace

SurfaceResult intersect_patch_with_equation(const symbolic::SurfacePiece& patch, const Polynomial& equation,
                                            const SideRoles& roles, const Options& options, const Context& context) {
  return PatchSection(patch, equation, roles, options, context).run();
}

}  // namespace eliminant::intersect
