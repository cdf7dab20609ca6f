// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/patch_pair.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/branches/arc_tracing.hpp>
#include <eliminant/bridge/branches/branch_subdivision.hpp>
#include <eliminant/bridge/branches/patch_border_points.hpp>
#include <eliminant/bridge/branches/zoomed_tracing.hpp>
#include <eliminant/bridge/contacts/contact_curves.hpp>
#include <eliminant/bridge/contacts/corank_one_tracing.hpp>
#include <eliminant/bridge/contacts/crossing_tracing.hpp>
#include <eliminant/bridge/contacts/surface_contact.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/curve_surface/prepared_net.hpp>
#include <eliminant/intersect/overlaps/border_arc.hpp>
#include <eliminant/intersect/overlaps/patch_overlap.hpp>
#include <eliminant/intersect/patches/border_curves.hpp>
#include <eliminant/intersect/patches/branch_components.hpp>
#include <eliminant/intersect/patches/branch_joining.hpp>
#include <eliminant/intersect/patches/contact_arcs.hpp>

namespace eliminant::intersect {

namespace {

using bridge::BranchGraph;
using bridge::ControlNet;
using bridge::nearest;
using Eigen::Array4d;
using symbolic::Rational;

/// Weights of one sign are made positive.
void make_weights_positive(PreparedNet& net) {
  const bool negative =
      std::all_of(net.exact.points.begin(), net.exact.points.end(), [](const auto& p) { return p[3].sign() < 0; });
  if (!negative) return;
  for (bridge::ExactPoint& point : net.exact.points)
    for (Rational& coordinate : point) coordinate = Rational(0) - coordinate;
}

/// By which power of two c the control points of row i (column, for axis 1) must be multiplied, c^i, so that their
/// weights do not rise or fall: u / (1 - u) is c times the new parameter's.
long balance_exponent(const PreparedNet& net, std::size_t axis) {
  const std::size_t m = net.exact.degrees[0];
  const std::size_t n = net.exact.degrees[1];
  const std::size_t lines = axis == 0 ? n : m;
  const std::size_t degree = axis == 0 ? m : n;
  const auto weight = [&](std::size_t line, std::size_t i) {
    return std::log2(nearest(net.exact.points[axis == 0 ? i * (n + 1) + line : line * (n + 1) + i][3]));
  };
  double sum = 0;
  for (std::size_t line = 0; line <= lines; ++line) sum += weight(line, 0) - weight(line, degree);
  const double slope = sum / static_cast<double>((lines + 1) * degree);
  return std::isfinite(slope) ? std::lround(slope) : 0;
}

/// Multiplies all coordinates of row i by 2^(e i).
void balance(PreparedNet& net, std::size_t axis, long exponent) {
  if (exponent == 0) return;
  const std::size_t row = net.exact.degrees[1] + 1;
  for (std::size_t i = 0; i < net.exact.points.size(); ++i) {
    const auto power = static_cast<long>(axis == 0 ? i / row : i % row) * exponent;
    Rational factor;
    fmpz_one_2exp(fmpq_numref(factor.get()), static_cast<ulong>(std::max(power, 0L)));
    fmpz_one_2exp(fmpq_denref(factor.get()), static_cast<ulong>(std::max(-power, 0L)));
    for (Rational& coordinate : net.exact.points[i]) coordinate = coordinate * factor;
  }
}

class PatchPair {
 public:
  PatchPair(PreparedNet first, PreparedNet second, double tolerance, bool parts_of_one, const Context& context)
      : first_(std::move(first)),
        second_(std::move(second)),
        tolerance_(tolerance),
        context_(context),
        common_surface_asked_(parts_of_one) {}

  SurfaceResult run() && {
    const auto start = std::chrono::steady_clock::now();
    result_.engine.method = "subdivision";
    result_.engine.precision_bits = 53;
    if (prepare()) {
      try {
        solve();
      } catch (const LimitReached& limit) {
        summarise(result_);
        result_.status = Status::incomplete;
        result_.limit = limit.what();
      }
    }
    result_.seconds.emplace_back("total",
                                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return std::move(result_);
  }

 private:
  bool prepare() {
    if (!has_positive_weights(first_) || !has_positive_weights(second_)) {
      result_.warnings.push_back("a patch has weights of both signs or zero: it was not intersected");
      return false;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      PreparedNet& net = k < 2 ? first_ : second_;
      const long exponent = balance_exponent(net, k % 2);
      balance(net, k % 2, exponent);
      balance_[k] = std::ldexp(1.0, static_cast<int>(exponent));
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const symbolic::Interval& side = k < 2 ? first_.domain[k] : second_.domain[k - 2];
      bounds_[k] = {nearest(side.lower), nearest(side.upper)};
    }
    origin_ = first_.origin();
    for (std::size_t k = 0; k < 3; ++k) rounded_origin_[k] = nearest(origin_[k]);
    auto first = first_.rounded(origin_);
    auto second = second_.rounded(origin_);
    if (!first || !second) {
      result_.warnings.push_back("coordinates are beyond the range in which hardware doubles are safe");
      return false;
    }
    first_net_ = *std::move(first);
    second_net_ = *std::move(second);
    return true;
  }

  /// Ends the search for border points: both patches are parts of one surface, and everything is known.
  struct Settled {};

  void solve() {
    try {
      subdivide();
      // Parts of one surface may touch in a corner, where no border is in the other.
      if (result_.status == Status::numeric) settle_common_surface();
    } catch (const Settled&) {
    }
  }

  void subdivide() {
    bridge::ContactCurves curves(first_net_, second_net_, first_.exact, second_.exact);
    curves_ = &curves;
    BorderCurves borders(first_.exact, second_.exact, context_);
    const bridge::BorderPoints border = bridge::patch_border_points(
        first_net_, second_net_, first_.exact, second_.exact,
        [&](std::size_t a, int a_side, std::size_t b, int b_side) { return borders.meetings(a, a_side, b, b_side); },
        [&](std::size_t axis, int side) {
          if (settle_common_surface()) throw Settled();
          return borders.contained(axis, side);
        },
        context_, curves_);
    add_contained(border.contained);
    std::vector<bridge::CrossingPoint> ends;
    for (const bridge::BorderPoint& point : border.points) {
      if (point.arcs == 1) ends.push_back(point);
      if (point.arcs == 0) add_touching_point(point);
    }
    bridge::BranchLimits limits;
    const bridge::SurfaceContactProver contacts(first_net_, second_net_, first_.exact, second_.exact);
    prover_ = &contacts;
    graph_ = bridge::branch_subdivision(first_net_, second_net_, std::move(ends), border.contained, prover_, limits,
                                        context_, curves_);
    for (const bridge::CellContact& contact : graph_.contacts) add_contact(contact);
    for (const bridge::CellCrossing& crossing : graph_.crossings) add_crossing(crossing);
    for (const BranchChain& chain : branch_chains(graph_)) add_chain(chain);
    bool complete = graph_.complete && graph_.open.empty() && border.open.empty();
    for (std::size_t i = 0; i < curves.curves().size(); ++i)
      complete = add_contact_curve(i, border.contained) && complete;
    certify_contained(border.contained);
    for (const bridge::CellBox& hull : clusters_of(graph_.open)) add_undecided(hull);
    for (const bridge::OpenBorder& open : border.open)
      result_.warnings.push_back(border_name(open.axis, open.side) + ": " + open.reason);
    if (!graph_.complete) result_.warnings.push_back("the subdivision was ended at its limit");
    result_.status = complete ? Status::certified : Status::numeric;
    summarise(result_);
  }

  /// Asked once: whether both patches are parts of one surface, and what they have in common is known from that.
  bool settle_common_surface() {
    if (common_surface_asked_) return false;
    common_surface_asked_ = true;
    const auto overlap = patch_overlap({first_.exact, first_net_}, {second_.exact, second_net_}, tolerance_, context_);
    if (!overlap) return false;
    result_.components.clear();
    result_.singular_points.clear();
    result_.warnings.clear();
    for (const DrawnCurve& outline : overlap->outlines)
      result_.components.push_back(component_of(SurfaceComponentKind::overlap, outline));
    for (const auto& [kind, pieces] : {std::pair(SurfaceComponentKind::curve, &overlap->curves),
                                       std::pair(SurfaceComponentKind::loop, &overlap->loops),
                                       std::pair(SurfaceComponentKind::point, &overlap->points)})
      for (const DrawnCurve& drawn : *pieces) {
        SurfaceComponent component = component_of(kind, drawn);
        component.tangential = true;
        component.start.side = sides_at(drawn.parameters.front());
        component.end.side = sides_at(drawn.parameters.back());
        result_.components.push_back(std::move(component));
      }
    result_.status = overlap->complete ? Status::certified : Status::numeric;
    if (!overlap->complete)
      result_.warnings.push_back(
          "both patches are parts of one surface that is not proven to be without self-intersection: what they have in "
          "common beside the common parts is not known");
    summarise(result_);
    if (!overlap->outlines.empty()) result_.rest_status = std::exchange(result_.status, Status::infinite);
    return true;
  }

  static std::string border_name(std::size_t axis, int side) {
    constexpr std::array names{"u", "v", "s", "t"};
    return std::string("the border where ") + names[axis] + (side < 0 ? " is smallest" : " is largest");
  }

  double to_domain(std::size_t k, double local) const {
    const auto& [lower, upper] = bounds_[k];
    const double c = balance_[k];
    const double place = c == 1 ? local : c * local / ((1 - local) + c * local);
    return place == 1 ? upper : lower + place * (upper - lower);
  }

  SurfacePoint placed(const std::array<double, 4>& parameters, const std::array<double, 3>& point) const {
    SurfacePoint result;
    for (std::size_t k = 0; k < 4; ++k) result.parameters[k] = to_domain(k, parameters[k]);
    for (std::size_t k = 0; k < 3; ++k) result.point[k] = point[k] + rounded_origin_[k];
    return result;
  }

  SurfacePoint placed(const std::array<double, 4>& parameters) {
    const bridge::PatchJets::Value value = bridge::PatchJets(first_net_).at(parameters[0], parameters[1]);
    return placed(parameters, {value.point[0], value.point[1], value.point[2]});
  }

  /// Border curves that lie in the other patch; one that is a border of both once.
  void add_contained(const std::vector<bridge::ContainedBorder>& borders) {
    std::vector<SurfaceComponent> found;
    for (const bridge::ContainedBorder& border : borders) {
      SurfaceComponent component = contained_border(border);
      const auto same = [&](const SurfaceComponent& other) {
        const auto near = [&](const SurfacePoint& a, const SurfacePoint& b) {
          double distance = 0;
          for (std::size_t k = 0; k < 4; ++k)
            distance = std::max(distance, std::fabs(a.parameters[k] - b.parameters[k]));
          return distance < 1e-7;
        };
        const SurfacePoint& begin = component.points.front();
        const SurfacePoint& end = component.points.back();
        return (near(begin, other.points.front()) && near(end, other.points.back())) ||
               (near(begin, other.points.back()) && near(end, other.points.front()));
      };
      if (std::none_of(found.begin(), found.end(), same)) found.push_back(std::move(component));
    }
    for (SurfaceComponent& component : found) result_.components.push_back(std::move(component));
  }

  /// Borders along which the patches touch, once that is proven.
  void certify_contained(const std::vector<bridge::ContainedBorder>& borders) {
    for (SurfaceComponent& component : result_.components) {
      if (component.certified || !component.tangential) continue;
      const auto is_proven = [&](const bridge::ContainedBorder& border) {
        return component.start.side[border.axis] == border.side && component.end.side[border.axis] == border.side &&
               curves_->is_along(border.axis, border.side);
      };
      component.certified = std::any_of(borders.begin(), borders.end(), is_proven);
      if (component.certified) component.reason.clear();
    }
  }

  SurfaceComponent contained_border(const bridge::ContainedBorder& border) {
    const DrawnCurve drawn = drawn_border(first_net_, second_net_, border, tolerance_);
    SurfaceComponent component = component_of(SurfaceComponentKind::curve, drawn);
    component.start.side = sides_at(drawn.parameters.front());
    component.end.side = sides_at(drawn.parameters.back());
    component.start.side[border.axis] = component.end.side[border.axis] = border.side;
    component.tangential = std::all_of(drawn.parameters.begin(), drawn.parameters.end(),
                                       [&](const std::array<double, 4>& at) { return is_tangential(at); });
    if (component.tangential) {
      component.certified = false;
      component.reason = "both surfaces touch along a border, and what else they have in common there is not proven";
    }
    return component;
  }

  /// A curve along a border ends where one of both patches does.
  static std::array<int, 4> sides_at(const std::array<double, 4>& at) {
    constexpr double accuracy = 1e-9;
    std::array<int, 4> side{};
    for (std::size_t k = 0; k < 4; ++k) side[k] = at[k] < accuracy ? -1 : at[k] > 1 - accuracy ? 1 : 0;
    return side;
  }

  SurfaceComponent component_of(SurfaceComponentKind kind, const DrawnCurve& drawn) const {
    SurfaceComponent component;
    component.kind = kind;
    component.certified = true;
    for (std::size_t i = 0; i < drawn.points.size(); ++i)
      component.points.push_back(placed(drawn.parameters[i], drawn.points[i]));
    component.error = drawn.error + rounding_of(component);
    return component;
  }

  /// Whether the tangent planes are equal, or differ by so little that doubles cannot tell.
  bool is_tangential(const std::array<double, 4>& parameters) const {
    const auto normal_at = [](const ControlNet& net, double u, double v) {
      const bridge::PatchJets::Value value = bridge::PatchJets(net).at(u, v);
      const Eigen::Vector3d p = value.first[0].head<3>().matrix();
      const Eigen::Vector3d q = value.first[1].head<3>().matrix();
      return Eigen::Vector3d(p.cross(q).normalized());
    };
    const Eigen::Vector3d a = normal_at(first_net_, parameters[0], parameters[1]);
    const Eigen::Vector3d b = normal_at(second_net_, parameters[2], parameters[3]);
    constexpr double least_angle = 1e-7;
    return !(a.cross(b).norm() > least_angle);
  }

  void add_touching_point(const bridge::BorderPoint& point) {
    SurfaceComponent component;
    component.kind = SurfaceComponentKind::point;
    component.points.push_back(placed(point.parameters));
    component.start.side = point.side;
    component.end = component.start;
    component.tangential = point.touching && is_tangential(point.parameters);
    component.error = error_in_space(point) + rounding_of(component);
    component.certified = true;
    result_.components.push_back(std::move(component));
  }

  /// How far the point of the first patch at the parameters given is from the true one.
  double error_in_space(const bridge::CrossingPoint& point) const {
    bridge::PatchJets patch(first_net_);
    const double reach = point.radius + 0x1p-20;
    const auto bounds = patch.bounds_on(point.parameters[0] - reach, point.parameters[0] + reach,
                                        point.parameters[1] - reach, point.parameters[1] + reach);
    if (!bounds) return INFINITY;
    const double speed = (bounds->first[0] + bounds->first[1]).head<3>().matrix().norm();
    return speed * point.radius + 1.74 * patch.at(point.parameters[0], point.parameters[1]).error;
  }

  /// Singular points are those of the contacts first, in their order.
  void add_contact(const bridge::CellContact& contact) {
    SurfaceSingularPoint point;
    point.half_branches = contact.around.half_branches();
    point.kind = point.half_branches == 0  ? SurfaceSingularity::contact
                 : contact.around.crossing ? SurfaceSingularity::crossing
                                           : SurfaceSingularity::cusp;
    point.at = placed(contact.contact.rounded);
    point.radius = 0x1p-50;
    point.certified = true;
    result_.singular_points.push_back(point);
    if (point.half_branches > 0) return;
    SurfaceComponent component;
    component.kind = SurfaceComponentKind::point;
    component.points.push_back(point.at);
    component.tangential = true;
    bridge::CrossingPoint at;
    at.parameters = contact.contact.rounded;
    at.radius = 0x1p-53;
    component.error = error_in_space(at) + rounding_of(component);
    component.certified = true;
    result_.components.push_back(std::move(component));
  }

  /// They follow the contacts.
  void add_crossing(const bridge::CellCrossing& crossing) {
    SurfaceSingularPoint point;
    point.kind = SurfaceSingularity::crossing;
    point.at = placed(crossing.crossing.parameters);
    point.radius = crossing.crossing.radius;
    bridge::CrossingPoint at;
    at.parameters = crossing.crossing.parameters;
    at.radius = crossing.crossing.radius;
    point.radius = std::max(point.radius, error_in_space(at));
    point.half_branches = 4;
    point.certified = true;
    result_.singular_points.push_back(point);
  }

  /// The pieces of a curve of contact; false where they are not proven to be all.
  bool add_contact_curve(std::size_t index, const std::vector<bridge::ContainedBorder>& contained) {
    const bridge::ContactCurve& curve = curves_->curves()[index];
    // All its pieces are those of the border, which are known.
    if (std::any_of(contained.begin(), contained.end(), [&](const bridge::ContainedBorder& border) {
          return curve.sides_along()[border.axis] == border.side;
        }))
      return true;
    std::vector<bridge::CurveCrossing> crossings;
    std::vector<std::size_t> singular;
    for (std::size_t i = 0; i < graph_.crossings.size(); ++i) {
      if (graph_.crossings[i].crossing.curve != index) continue;
      crossings.push_back(graph_.crossings[i].crossing);
      singular.push_back(graph_.contacts.size() + i);
    }
    const PatchNets base =
        curve.swapped() ? PatchNets{second_.exact, second_net_} : PatchNets{first_.exact, first_net_};
    const ContactArcs found =
        contact_arcs(curve, base, crossings, tolerance_, std::min(size_of(first_), size_of(second_)), context_);
    if (!found.complete)
      result_.warnings.emplace_back("the surfaces touch along a curve whose pieces in both domains are not proven");
    for (const ContactArc& arc : found.arcs) {
      SurfaceComponent component;
      component.kind = arc.closed ? SurfaceComponentKind::loop : SurfaceComponentKind::curve;
      component.tangential = true;
      component.certified = arc.proven && found.complete;
      if (!component.certified) component.reason = "the pieces of a curve of contact are not proven";
      for (const bridge::TracedPoint& point : arc.points)
        component.points.push_back(placed(point.parameters, point.point));
      component.error = arc.error + rounding_of(component);
      const auto end_of = [&](const ContactArcEnd& end) {
        BranchEnd result;
        result.side = end.side;
        if (!end.crossing) return result;
        result.kind = BranchEndKind::singular;
        result.singular_point = singular[*end.crossing];
        return result;
      };
      component.start = end_of(arc.start);
      component.end = end_of(arc.end);
      if (!arc.closed) {
        put_on_border(component.points.front(), component.start);
        put_on_border(component.points.back(), component.end);
      }
      result_.components.push_back(std::move(component));
    }
    return found.complete;
  }

  void add_undecided(const bridge::CellBox& hull) {
    SurfaceSingularPoint point;
    std::array<double, 4> middle;
    for (std::size_t k = 0; k < 4; ++k) {
      middle[k] = std::clamp(0.5 * (hull.lower[k] + hull.upper[k]), 0.0, 1.0);
      point.radius = std::max(point.radius, 0.5 * (to_domain(k, hull.upper[k]) - to_domain(k, hull.lower[k])));
    }
    point.at = placed(middle);
    point.reason = "the surfaces touch here or nearly so, which is not proven";
    result_.singular_points.push_back(std::move(point));
  }

  void add_chain(const BranchChain& chain) {
    SurfaceComponent component;
    component.kind = chain.closed ? SurfaceComponentKind::loop : SurfaceComponentKind::curve;
    component.certified = true;
    bridge::ArcTracer tracer(first_net_, second_net_);
    for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
      const bridge::CellArc& arc = graph_.arcs[chain.arcs[i]];
      bridge::TracedArc traced = traced_arc(tracer, arc);
      if (chain.reversed[i]) std::reverse(traced.points.begin(), traced.points.end());
      component.error = std::max(component.error, traced.error);
      component.certified = component.certified && traced.proven;
      for (std::size_t k = component.points.empty() ? 0 : 1; k < traced.points.size(); ++k)
        component.points.push_back(placed(traced.points[k].parameters, traced.points[k].point));
    }
    component.error += rounding_of(component);
    if (!component.certified) component.reason = "the distance of the polyline from the curve is not proven";
    if (chain.closed) {
      component.points.back() = component.points.front();
    } else {
      component.start = end_at(chain.start, component);
      component.end = end_at(chain.end, component);
      put_on_border(component.points.front(), component.start);
      put_on_border(component.points.back(), component.end);
    }
    result_.components.push_back(std::move(component));
  }

  bridge::TracedArc traced_arc(bridge::ArcTracer& tracer, const bridge::CellArc& arc) const {
    const bridge::CrossingPoint& from = graph_.points[arc.from];
    const bridge::PatchPairNets nets{first_net_, second_net_, first_.exact, second_.exact, origin_};
    if (arc.contact) {
      const bridge::CellContact& contact = graph_.contacts[*arc.contact];
      return contact.around.degenerate
                 ? bridge::trace_to_corank_one(first_net_, second_net_, from, contact, tolerance_, context_)
                 : bridge::trace_to_contact(nets, from, contact, tolerance_, context_);
    }
    if (arc.crossing) {
      const bridge::ContactCurves::Crossing& crossing = graph_.crossings[*arc.crossing].crossing;
      return bridge::trace_to_crossing(curves_->curves()[crossing.curve], from, crossing, tolerance_, context_);
    }
    const bridge::CrossingPoint& to = graph_.points[arc.to];
    bridge::TracedArc traced = tracer.trace(from, to, arc.box, tolerance_, context_);
    // Next to a curve of contact doubles tell both surfaces apart so far only.
    constexpr double most = 4096;
    for (double factor = 1; !traced.proven && factor < most; factor *= 4)
      traced = bridge::trace_in_zoom(nets, from, to, arc.box, factor * tolerance_, context_);
    return traced;
  }

  /// Newton's method has moved the end of a polyline off the border a little.
  void put_on_border(SurfacePoint& point, const BranchEnd& end) const {
    for (std::size_t k = 0; k < 4; ++k)
      if (end.side[k] != 0) point.parameters[k] = to_domain(k, end.side[k] < 0 ? 0 : 1);
  }

  /// What the sum with the origin and its rounding add.
  double rounding_of(const SurfaceComponent& component) const {
    double largest = 0;
    for (const SurfacePoint& point : component.points)
      for (const double x : point.point) largest = std::max(largest, std::fabs(x));
    for (const double x : rounded_origin_) largest = std::max(largest, std::fabs(x));
    return 4 * largest * 0x1p-53;
  }

  BranchEnd end_at(std::size_t index, SurfaceComponent& component) {
    const bridge::CrossingPoint& point = graph_.points[index];
    BranchEnd end;
    end.side = point.side;
    const auto contact = std::find_if(graph_.contacts.begin(), graph_.contacts.end(),
                                      [&](const bridge::CellContact& c) { return c.point == index; });
    if (contact != graph_.contacts.end()) {
      end.kind = BranchEndKind::singular;
      end.singular_point = static_cast<std::size_t>(contact - graph_.contacts.begin());
      return end;
    }
    const auto crossing = std::find_if(graph_.crossings.begin(), graph_.crossings.end(),
                                       [&](const bridge::CellCrossing& c) { return c.point == index; });
    if (crossing != graph_.crossings.end()) {
      end.kind = BranchEndKind::singular;
      end.singular_point = graph_.contacts.size() + static_cast<std::size_t>(crossing - graph_.crossings.begin());
      return end;
    }
    const auto on_border = std::find_if(point.side.begin(), point.side.end(), [](int side) { return side != 0; });
    if (on_border == point.side.end()) {
      end.kind = BranchEndKind::unknown;
      component.certified = false;
      component.reason = "an end is next to a point of contact that is not proven";
      return end;
    }
    end.transition = transition_at(point, static_cast<std::size_t>(on_border - point.side.begin()));
    return end;
  }

  /// How the border curve crosses the other surface.
  Transition transition_at(const bridge::CrossingPoint& point, std::size_t axis) const {
    const bridge::PatchJets::Value a = bridge::PatchJets(first_net_).at(point.parameters[0], point.parameters[1]);
    const bridge::PatchJets::Value b = bridge::PatchJets(second_net_).at(point.parameters[2], point.parameters[3]);
    const bridge::PatchJets::Value& own = axis < 2 ? a : b;
    const bridge::PatchJets::Value& other = axis < 2 ? b : a;
    const Array4d& along_border = own.first[1 - axis % 2];
    const Array4d& p = other.first[0];
    const Array4d& q = other.first[1];
    const std::array<double, 3> normal{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    double sum = 0;
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += along_border[static_cast<long>(k)] * normal[k];
      size += std::fabs(along_border[static_cast<long>(k)] * normal[k]);
    }
    constexpr double undecided = 1e-10;
    if (!(std::fabs(sum) > undecided * size)) return Transition::touching;
    return sum > 0 ? Transition::out : Transition::in;
  }

  PreparedNet first_;
  PreparedNet second_;
  double tolerance_;
  const Context& context_;
  std::array<Rational, 3> origin_;
  std::array<double, 3> rounded_origin_{};
  /// Of u, v, s, t.
  std::array<std::array<double, 2>, 4> bounds_{};
  /// Of u, v, s, t: parameters of the nets are those of the patches with u / (1 - u) divided by that.
  std::array<double, 4> balance_{1, 1, 1, 1};
  ControlNet first_net_;
  ControlNet second_net_;
  const bridge::SurfaceContactProver* prover_ = nullptr;
  bridge::ContactCurves* curves_ = nullptr;
  BranchGraph graph_;
  bool common_surface_asked_ = false;
  SurfaceResult result_;
};

}  // namespace

PreparedNet prepared_patch(const symbolic::SurfacePiece& piece, const char* which) {
  if (auto net = prepared_net(piece)) {
    make_weights_positive(*net);
    return *std::move(net);
  }
  throw InvalidInput(std::string("the ") + which +
                     " surface is no patch: a tensor-product map that depends on both parameters, on a domain of "
                     "positive area, was expected");
}

bool has_positive_weights(const PreparedNet& net) {
  return std::all_of(net.exact.points.begin(), net.exact.points.end(), [](const auto& p) { return p[3].sign() > 0; });
}

double size_of(const PreparedNet& net) {
  std::array<double, 3> lower;
  std::array<double, 3> upper;
  lower.fill(INFINITY);
  upper.fill(-INFINITY);
  for (const bridge::ExactPoint& point : net.exact.points) {
    if (point[3].is_zero()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = nearest(point[k] / point[3]);
      lower[k] = std::min(lower[k], x);
      upper[k] = std::max(upper[k], x);
    }
  }
  return std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
}

SurfaceResult intersect_parts_of_patch(PreparedNet first, PreparedNet second, double tolerance,
                                       const Context& context) {
  return PatchPair(std::move(first), std::move(second), tolerance, true, context).run();
}

SurfaceResult intersect_patches(const symbolic::SurfacePiece& first, const symbolic::SurfacePiece& second,
                                const Options& options, const Context& context) {
  PreparedNet a = prepared_patch(first, "first");
  PreparedNet b = prepared_patch(second, "second");
  const double size = std::min(size_of(a), size_of(b));
  return PatchPair(std::move(a), std::move(b), options.tolerance * size, false, context).run();
}

}  // namespace eliminant::intersect
