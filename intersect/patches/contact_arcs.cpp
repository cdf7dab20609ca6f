// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/contact_arcs.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/bridge/branches/section_tracing.hpp>
#include <eliminant/bridge/nets/function_net.hpp>
#include <eliminant/intersect/sections/section_frame.hpp>
#include <eliminant/intersect/sections/section_graph.hpp>
#include <eliminant/symbolic/elimination/bivariate_factors.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Interval;
using symbolic::Polynomial;
using symbolic::Rational;

const std::array<Interval, 2> unit_square{Interval{0, 1}, Interval{0, 1}};

/// 1 or -1 where that is its sign on all of the domain, else 0.
int sign_on_domain(const Polynomial& p) {
  if (p.is_zero()) return 0;
  if (!bridge::excludes_zero(bridge::function_net(p, unit_square), {0, 0}, {1, 1})) return 0;
  return p.constant_term().sign();
}

/// Whether its zeros are a side of the domain.
bool is_border_line(const Polynomial& p) {
  for (std::size_t k = 0; k < 2; ++k)
    for (const long at : {0L, 1L})
      if (p == (Polynomial::variable(2, k) - Polynomial::constant(2, at))) return true;
  return false;
}

/// The side of the other domain where a parameter is 0 or 1.
struct OtherSide {
  std::size_t parameter = 0;
  int side = -1;
  /// Positive inside.
  Polynomial function{2};
};

class Arcs {
 public:
  Arcs(const bridge::ContactCurve& curve, const PatchNets& base, const std::vector<bridge::CurveCrossing>& crossings,
       double tolerance, double size, const Context& context)
      : curve_(curve),
        base_(base),
        crossings_(crossings),
        tolerance_(tolerance),
        size_(size),
        context_(context),
        piece_(patch_of(base.exact)),
        frame_(piece_, PreparedNet{base.exact, {unit_square[0], unit_square[1]}}),
        function_(bridge::function_net(curve.relation().curve, unit_square)) {}

  ContactArcs run() && {
    if (!prepare()) {
      result_.complete = false;
      return std::move(result_);
    }
    Options options;
    constexpr SideRoles borders{{{SideRole::border, SideRole::border}, {SideRole::border, SideRole::border}}};
    graph_.emplace(piece_, factors_, true, borders, options, context_);
    reached_.assign(graph_->vertices().size(), false);
    result_.complete = graph_->complete() && is_smooth();
    if (!result_.complete) return std::move(result_);
    for (const BranchChain& chain : graph_->chains()) add(chain);
    if (!has_no_other_points()) result_.complete = false;
    for (std::size_t i = 0; i < crossings_.size(); ++i) cut_at(i);
    return std::move(result_);
  }

 private:
  /// The functions that vanish where the curve leaves the other domain; false where something is not understood.
  bool prepare() {
    const symbolic::ContactRelation& relation = curve_.relation();
    factors_.push_back({relation.curve.primitive_part(), 2, SectionFactorKind::curve});
    for (std::size_t k = 0; k < 2; ++k) {
      const int sign = sign_on_domain(relation.denominator[k]);
      if (sign == 0) return false;
      const Rational positive(sign);
      const Polynomial lower = positive * relation.numerator[k];
      const Polynomial upper = positive * (relation.denominator[k] - relation.numerator[k]);
      if (!add_side(k, -1, lower) || !add_side(k, 1, upper)) return false;
    }
    return true;
  }

  bool add_side(std::size_t parameter, int side, const Polynomial& function) {
    // Along the side, all of the curve is in the domain.
    if (symbolic::vanishes_along(function, curve_.relation().curve)) return true;
    const int sign = sign_on_domain(function);
    if (sign > 0) return true;
    sides_.push_back({parameter, side, function});
    for (const symbolic::BivariateFactor& factor : symbolic::bivariate_factors(function.primitive_part(), 0)) {
      const Polynomial p = factor.factor.primitive_part();
      const bool known =
          std::any_of(factors_.begin(), factors_.end(), [&](const SectionFactor& f) { return f.factor == p; });
      if (!known && !is_border_line(p) && sign_on_domain(p) == 0)
        factors_.push_back({p, 1, SectionFactorKind::at_infinity});
    }
    return true;
  }

  /// No singular point of the curve itself.
  bool is_smooth() const {
    for (std::size_t v = 0; v < graph_->vertices().size(); ++v) {
      const SectionVertex& own = graph_->vertices()[v];
      if (own.on_curve && graph_->topology().vertices[v].kind == VertexKind::singular && graph_->is_singular_for(0, v))
        return false;
      if (own.on_curve && own.ends == 0) return false;
    }
    return true;
  }

  void add(const BranchChain& chain) {
    ContactArc arc;
    arc.closed = chain.closed;
    for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
      const std::optional<bool> inside = is_inside(chain.arcs[i]);
      if (!inside) result_.complete = false;
      if (!inside.value_or(false)) return;
      bridge::SectionArc traced = trace(chain.arcs[i], arc);
      if (chain.reversed[i]) std::reverse(traced.points.begin(), traced.points.end());
      for (std::size_t k = arc.points.empty() ? 0 : 1; k < traced.points.size(); ++k)
        arc.points.push_back(placed(traced.points[k]));
    }
    for (const std::size_t e : chain.arcs)
      for (const std::size_t v : {graph_->topology().edges[e].from, graph_->topology().edges[e].to}) reached_[v] = true;
    if (arc.points.size() < 2) {
      result_.complete = false;
      return;
    }
    if (arc.closed) {
      arc.points.back() = arc.points.front();
    } else {
      arc.start = end_at(chain.start, arc.points.front());
      arc.end = end_at(chain.end, arc.points.back());
    }
    result_.arcs.push_back(std::move(arc));
  }

  /// The curve may touch the other domain from outside, in a point on no arc.
  bool has_no_other_points() const {
    constexpr long bits = 256;
    for (std::size_t v = 0; v < reached_.size(); ++v) {
      if (reached_[v] || !graph_->vertices()[v].on_curve) continue;
      const TopologyVertex& there = graph_->topology().vertices[v];
      const bridge::PlaneBall ball{there.x.ball, there.y.ball};
      const bool is_outside = std::any_of(sides_.begin(), sides_.end(), [&](const OtherSide& side) {
        return arb_is_negative(bridge::BallCurve(side.function).value(ball, bits).real()) != 0;
      });
      if (!is_outside) return false;
    }
    return true;
  }

  /// Whether the other parameters of an edge are in their domain; they do not leave it on the edge.
  std::optional<bool> is_inside(std::size_t edge) const {
    const SectionEdge& own = *graph_->edges()[edge];
    for (const OtherSide& side : sides_) {
      const bridge::IntervalPolynomial function(side.function);
      const DoubleInterval value = function.on(bridge::DoubleInterval::around(own.sample[0], own.radius),
                                               bridge::DoubleInterval::around(own.sample[1], own.radius));
      if (!value.excludes_zero()) return std::nullopt;
      if (value.upper < 0) return false;
    }
    return true;
  }

  bridge::SectionArc trace(std::size_t e, ContactArc& arc) const {
    const TopologyEdge& edge = graph_->topology().edges[e];
    const SectionEdge& own = *graph_->edges()[e];
    const bridge::SectionTracer tracer(base_.rounded, function_);
    bridge::SectionSeed seed{own.sample, own.radius, {}};
    bridge::SectionArc whole;
    for (const bool forward : {false, true}) {
      seed.side[own.vertical ? 1 : 0] = forward ? 1 : -1;
      const std::size_t v = forward ? edge.to : edge.from;
      bridge::SectionGoal goal = frame_.place_of(graph_->topology().vertices[v], graph_->vertices()[v].side);
      goal.monotone = !own.vertical;
      bridge::SectionArc part = tracer.trace(seed, goal, tolerance_, size_, context_);
      arc.error = std::max(arc.error, part.error);
      arc.proven = arc.proven && part.proven;
      if (forward)
        whole.points.insert(whole.points.end(), part.points.begin() + 1, part.points.end());
      else
        whole.points.assign(part.points.rbegin(), part.points.rend());
    }
    return whole;
  }

  bridge::TracedPoint placed(const bridge::SectionPoint& at) const {
    bridge::TracedPoint point;
    point.parameters = curve_.parameters_at(at.parameters);
    for (double& parameter : point.parameters) parameter = std::clamp(parameter, 0.0, 1.0);
    point.point = at.point;
    return point;
  }

  /// On a border of the base, or where a parameter of the other patch reaches its end.
  ContactArcEnd end_at(std::size_t vertex, bridge::TracedPoint& point) {
    const SectionVertex& own = graph_->vertices()[vertex];
    std::array<int, 4> side{own.side[0], own.side[1], 0, 0};
    const TopologyVertex& there = graph_->topology().vertices[vertex];
    const bridge::PlaneBall ball{there.x.ball, there.y.ball};
    constexpr long bits = 256;
    for (const OtherSide& other : sides_)
      if (acb_contains_zero(bridge::BallCurve(other.function).value(ball, bits).get()) != 0)
        side[2 + other.parameter] = other.side;
    if (std::all_of(side.begin(), side.end(), [](int s) { return s == 0; })) result_.complete = false;
    if (curve_.swapped()) side = {side[2], side[3], side[0], side[1]};
    for (std::size_t k = 0; k < 4; ++k)
      if (side[k] != 0) point.parameters[k] = side[k] < 0 ? 0 : 1;
    return {side, std::nullopt};
  }

  /// Cuts the arc that passes the crossing.
  void cut_at(std::size_t index) {
    const bridge::CurveCrossing& crossing = crossings_[index];
    const std::size_t first = curve_.swapped() ? 2 : 0;
    const std::array<double, 2> at{crossing.parameters[first], crossing.parameters[first + 1]};
    double least = INFINITY;
    std::size_t of_arc = 0;
    std::size_t segment = 0;
    for (std::size_t i = 0; i < result_.arcs.size(); ++i) {
      const auto& points = result_.arcs[i].points;
      for (std::size_t k = 1; k < points.size(); ++k) {
        const double d = distance(at, points[k - 1].parameters, points[k].parameters, first);
        if (d < least) {
          least = d;
          of_arc = i;
          segment = k;
        }
      }
    }
    constexpr double near = 1e-4;
    if (!(least < near)) {
      result_.complete = false;
      return;
    }
    split(of_arc, segment, index);
  }

  static double distance(const std::array<double, 2>& p, const std::array<double, 4>& a, const std::array<double, 4>& b,
                         std::size_t first) {
    const std::array<double, 2> along{b[first] - a[first], b[first + 1] - a[first + 1]};
    const std::array<double, 2> to{p[0] - a[first], p[1] - a[first + 1]};
    const double square = along[0] * along[0] + along[1] * along[1];
    const double share = square > 0 ? std::clamp((to[0] * along[0] + to[1] * along[1]) / square, 0.0, 1.0) : 0.0;
    return std::hypot(to[0] - share * along[0], to[1] - share * along[1]);
  }

  void split(std::size_t index, std::size_t segment, std::size_t crossing) {
    ContactArc& arc = result_.arcs[index];
    const bridge::CurveCrossing& at = crossings_[crossing];
    bridge::TracedPoint point;
    point.parameters = at.parameters;
    const std::size_t first = curve_.swapped() ? 2 : 0;
    bridge::PatchJets jets(base_.rounded);
    const bridge::PatchJets::Value value = jets.at(at.parameters[first], at.parameters[first + 1]);
    for (std::size_t k = 0; k < 3; ++k) point.point[k] = value.point[static_cast<long>(k)];
    // Both parts of a chord are as near to their arcs as the chord is to the whole, but for the error of the point.
    const double speed = (value.first[0].abs() + value.first[1].abs()).head<3>().maxCoeff();
    arc.error += 1.74 * (2 * speed * at.radius + value.error);
    const auto middle = arc.points.begin() + static_cast<std::ptrdiff_t>(segment);
    std::vector<bridge::TracedPoint> before(arc.points.begin(), middle);
    std::vector<bridge::TracedPoint> after(middle, arc.points.end());
    before.push_back(point);
    after.insert(after.begin(), point);
    const ContactArcEnd here{{}, crossing};
    if (arc.closed) {
      after.insert(after.end(), before.begin() + 1, before.end());
      arc.points = std::move(after);
      arc.closed = false;
      arc.start = arc.end = here;
      return;
    }
    ContactArc rest = arc;
    arc.points = std::move(before);
    arc.end = here;
    rest.points = std::move(after);
    rest.start = here;
    result_.arcs.push_back(std::move(rest));
  }

  using DoubleInterval = bridge::DoubleInterval;

  const bridge::ContactCurve& curve_;
  const PatchNets& base_;
  const std::vector<bridge::CurveCrossing>& crossings_;
  double tolerance_;
  double size_;
  const Context& context_;
  symbolic::SurfacePiece piece_;
  SectionFrame frame_;
  bridge::ControlNet function_;
  std::vector<OtherSide> sides_;
  std::vector<SectionFactor> factors_;
  std::optional<SectionGraph> graph_;
  /// Vertices on arcs that are in both domains.
  std::vector<bool> reached_;
  ContactArcs result_;
};

}  // namespace

ContactArcs contact_arcs(const bridge::ContactCurve& curve, const PatchNets& base,
                         const std::vector<bridge::CurveCrossing>& crossings, double tolerance, double size,
                         const Context& context) {
  return Arcs(curve, base, crossings, tolerance, size, context).run();
}

}  // namespace eliminant::intersect
