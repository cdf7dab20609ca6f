// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/patch_pair.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/branches/arc_tracing.hpp>
#include <eliminant/bridge/branches/branch_subdivision.hpp>
#include <eliminant/bridge/branches/patch_border_points.hpp>
#include <eliminant/bridge/branches/zoomed_tracing.hpp>
#include <eliminant/bridge/contacts/common_border.hpp>
#include <eliminant/bridge/contacts/contact_curves.hpp>
#include <eliminant/bridge/contacts/corank_one_tracing.hpp>
#include <eliminant/bridge/contacts/crossing_tracing.hpp>
#include <eliminant/bridge/contacts/kept_distance.hpp>
#include <eliminant/bridge/contacts/surface_contact.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/overlaps/border_arc.hpp>
#include <eliminant/intersect/overlaps/patch_overlap.hpp>
#include <eliminant/intersect/patches/balanced_pair.hpp>
#include <eliminant/intersect/patches/border_curves.hpp>
#include <eliminant/intersect/patches/branch_components.hpp>
#include <eliminant/intersect/patches/branch_joining.hpp>
#include <eliminant/intersect/patches/contact_arcs.hpp>
#include <eliminant/intersect/patches/contained_borders.hpp>
#include <eliminant/intersect/patches/one_point_borders.hpp>
#include <eliminant/intersect/patches/only_common_point.hpp>
#include <eliminant/intersect/patches/patch_section.hpp>
#include <eliminant/intersect/patches/planar_seam.hpp>
#include <eliminant/intersect/patches/surface_summary.hpp>

namespace eliminant::intersect {

namespace {

using bridge::BranchGraph;

class PatchPair {
 public:
  PatchPair(PreparedNet first, PreparedNet second, double tolerance, bool parts_of_one, const Context& context)
      : pair_(std::move(first), std::move(second)),
        nets_(pair_.nets()),
        tolerance_(tolerance),
        context_(context),
        common_surface_asked_(parts_of_one) {}

  SurfaceResult run() && {
    const auto start = std::chrono::steady_clock::now();
    result_.engine.method = "subdivision";
    result_.engine.precision_bits = 53;
    if (!pair_.obstacle().empty()) {
      result_.warnings.push_back(pair_.obstacle());
    } else {
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
  /// Ends the search for border points: both patches are parts of one surface, and everything is known.
  struct Settled {};

  void solve() {
    if (!common_surface_asked_ && (settle_common_point() || settle_seam())) return;
    if (bridge::keep_distance(nets_.first, nets_.second)) {
      result_.status = Status::certified;
      summarise(result_);
      return;
    }
    try {
      subdivide();
      // Parts of one surface may touch in a corner, where no border is in the other.
      if (result_.status == Status::numeric && !settle_common_surface()) settle_section();
    } catch (const Settled&) {
    }
  }

  /// Pieces of smoothly joined surfaces may meet in a corner alone, with any order of contact, and a border that is one
  /// point may be all that a patch has in common with another.
  bool settle_common_point() {
    const auto found = only_common_point({nets_.exact_first, nets_.first}, {nets_.exact_second, nets_.second});
    if (!found) return false;
    std::array<double, 4> parameters{};
    for (std::size_t k = 0; k < 4; ++k)
      parameters[k] = found->parameters[k] ? bridge::nearest(*found->parameters[k]) : std::nan("");
    add_tip(parameters, found->side());
    result_.status = Status::certified;
    summarise(result_);
    return true;
  }

  /// Joined pieces of surfaces may have a border in common, in a plane between them, and nothing else.
  bool settle_seam() {
    const auto seam = planar_seam(nets_);
    if (!seam) return false;
    result_.components = contained_curves(pair_, {*seam}, graph_, tolerance_);
    result_.components[0].certified = true;
    result_.components[0].reason.clear();
    result_.status = Status::certified;
    summarise(result_);
    return true;
  }

  void subdivide() {
    bridge::ContactCurves curves(nets_.first, nets_.second, nets_.exact_first, nets_.exact_second);
    curves_ = &curves;
    BorderCurves borders(nets_.exact_first, nets_.exact_second, context_);
    const bridge::BorderPoints border = bridge::patch_border_points(
        nets_.first, nets_.second, nets_.exact_first, nets_.exact_second,
        [&](std::size_t a, int a_side, std::size_t b, int b_side) { return borders.meetings(a, a_side, b, b_side); },
        [&](std::size_t axis, int side) {
          if (settle_common_surface()) throw Settled();
          const bridge::ExactNet& net = axis < 2 ? nets_.exact_first : nets_.exact_second;
          if (is_one_point(net, axis % 2, side)) {
            if (settle_section()) throw Settled();
            return contained_point(pair_, axis, side);
          }
          if (bridge::is_common_border(nets_, axis, side)) return bridge::ContainedParts{{{0, 1}}, true};
          return borders.contained(axis, side);
        },
        context_, curves_);
    result_.components = contained_curves(pair_, border.contained, graph_, tolerance_);
    std::vector<bridge::CrossingPoint> ends;
    for (const bridge::BorderPoint& point : border.points) {
      if (point.arcs == 1) ends.push_back(point);
      if (point.arcs == 0) add_touching_point(point);
    }
    bridge::BranchLimits limits;
    const bridge::SurfaceContactProver contacts(nets_.first, nets_.second, nets_.exact_first, nets_.exact_second);
    prover_ = &contacts;
    // On cuts a border that is one point is a point of the intersection, from which a branch may start.
    std::vector<bridge::ContainedBorder> curves_along = border.contained;
    std::erase_if(curves_along, [](const bridge::ContainedBorder& contained) { return contained.one_point; });
    graph_ = bridge::branch_subdivision(nets_.first, nets_.second, std::move(ends), curves_along, prover_, limits,
                                        context_, curves_);
    cut_contained(border.contained);
    for (const bridge::CellContact& contact : graph_.contacts) add_contact(contact, border.contained);
    name_singular_ends();
    for (const bridge::CellCrossing& crossing : graph_.crossings) add_crossing(crossing);
    for (const BranchChain& chain : branch_chains(graph_)) add_chain(chain);
    std::vector<bridge::OpenBorder> open_borders = border.open;
    for (const bridge::TouchedBorder& touched : border.touched)
      if (!is_contact(touched)) open_borders.push_back(touched.border);
    bool complete = graph_.complete && graph_.open.empty() && open_borders.empty();
    for (std::size_t i = 0; i < curves.curves().size(); ++i)
      complete = add_contact_curve(i, border.contained) && complete;
    for (const bridge::ContainedBorder& contained : border.contained)
      if (contained.one_point) end_at_point(result_.components, pair_, contained);
    settle_contained_curves(result_.components, pair_, border.contained, curves, graph_);
    for (const bridge::CellBox& hull : clusters_of(graph_.open)) add_undecided(hull);
    for (const bridge::OpenBorder& open : open_borders)
      result_.warnings.push_back(border_name(open.axis, open.side) + ": " + open.reason);
    if (!graph_.complete) result_.warnings.push_back("the subdivision was ended at its limit");
    result_.status = complete ? Status::certified : Status::numeric;
    summarise(result_);
  }

  /// Asked once: whether both patches are parts of one surface, and what they have in common is known from that.
  bool settle_common_surface() {
    if (common_surface_asked_) return false;
    common_surface_asked_ = true;
    const auto overlap =
        patch_overlap({nets_.exact_first, nets_.first}, {nets_.exact_second, nets_.second}, tolerance_, context_);
    if (!overlap) return false;
    forget();
    for (const DrawnCurve& outline : overlap->outlines)
      result_.components.push_back(pair_.placed(SurfaceComponentKind::overlap, outline));
    for (const auto& [kind, pieces] : {std::pair(SurfaceComponentKind::curve, &overlap->curves),
                                       std::pair(SurfaceComponentKind::loop, &overlap->loops),
                                       std::pair(SurfaceComponentKind::point, &overlap->points)})
      for (const DrawnCurve& drawn : *pieces) {
        SurfaceComponent component = pair_.placed(kind, drawn);
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

  void forget() {
    result_.components.clear();
    result_.singular_points.clear();
    result_.warnings.clear();
  }

  /// Asked once: whether all of the intersection is a curve on one patch that has no singular point.
  bool settle_section() {
    if (section_asked_) return false;
    section_asked_ = true;
    const auto section = patch_section(nets_, tolerance_, pair_.size(), context_);
    if (!section) return false;
    forget();
    for (const ContactArc& arc : section->arcs) {
      SurfaceComponent component = pair_.placed(arc);
      component.tangential = section->tangential;
      component.certified = true;
      if (!arc.closed && !section->tangential)
        for (const auto& [end, at] :
             {std::pair(&component.start, &arc.points.front()), std::pair(&component.end, &arc.points.back())})
          end->transition = pair_.transition_at(at->parameters, end->side);
      result_.components.push_back(std::move(component));
    }
    for (const PatchSection::Point& at : section->points) add_tip(at.parameters, at.side);
    result_.status = Status::certified;
    summarise(result_);
    return true;
  }

  static std::string border_name(std::size_t axis, int side) {
    constexpr std::array names{"u", "v", "s", "t"};
    return std::string("the border where ") + names[axis] + (side < 0 ? " is smallest" : " is largest");
  }

  static bool is_on_any(const std::vector<bridge::ContainedBorder>& borders, const bridge::CellContact& contact) {
    return std::any_of(borders.begin(), borders.end(), [&](const auto& border) { return is_on(border, contact); });
  }

  /// Border curves end where branches cross them.
  void cut_contained(const std::vector<bridge::ContainedBorder>& borders) {
    bool any = false;
    for (std::size_t i = 0; i < graph_.contacts.size(); ++i)
      any = any || (crosses(graph_, i) && is_on_any(borders, graph_.contacts[i]));
    if (!any) return;
    std::erase_if(result_.components, [](const auto& c) { return c.kind == SurfaceComponentKind::curve; });
    for (SurfaceComponent& component : contained_curves(pair_, borders, graph_, tolerance_))
      result_.components.push_back(std::move(component));
  }

  /// Whether everything around a point in which a border touches the other patch is known.
  bool is_contact(const bridge::TouchedBorder& touched) const {
    return std::any_of(graph_.contacts.begin(), graph_.contacts.end(), [&](const bridge::CellContact& contact) {
      return contact.contact.parameters == touched.parameters;
    });
  }

  void add_touching_point(const bridge::BorderPoint& point) {
    SurfaceComponent component;
    component.kind = SurfaceComponentKind::point;
    component.points.push_back(pair_.placed(point.parameters));
    component.start.side = point.side;
    component.end = component.start;
    component.tangential = point.touching && pair_.is_tangential(point.parameters);
    component.error = pair_.error_in_space(point) + pair_.rounding_of(component);
    component.certified = true;
    result_.components.push_back(std::move(component));
  }

  /// A parameter that runs along a border that is one point is not a number.
  void add_tip(const std::array<double, 4>& parameters, const std::array<int, 4>& side) {
    bridge::BorderPoint point;
    point.side = side;
    for (std::size_t k = 0; k < 4; ++k) point.parameters[k] = std::isnan(parameters[k]) ? 0 : parameters[k];
    point.radius = 0x1p-53;
    point.touching = true;
    add_touching_point(point);
    for (std::size_t k = 0; k < 4; ++k)
      if (std::isnan(parameters[k])) result_.components.back().points[0].parameters[k] = parameters[k];
  }

  /// Singular points are those of the contacts first, in their order.
  void add_contact(const bridge::CellContact& contact, const std::vector<bridge::ContainedBorder>& contained) {
    const auto index = static_cast<std::size_t>(&contact - graph_.contacts.data());
    // Without a branch a border curve passes through it.
    const bool on_contained = is_on_any(contained, contact);
    contact_index_.push_back(std::nullopt);
    if (on_contained && !crosses(graph_, index)) return;
    contact_index_.back() = result_.singular_points.size();
    SurfaceSingularPoint point;
    point.at = pair_.placed(contact.contact.rounded);
    point.radius = 0x1p-50;
    point.half_branches = half_branches_at(index);
    point.kind = point.half_branches == 0  ? SurfaceSingularity::contact
                 : contact.around.crossing ? SurfaceSingularity::crossing
                                           : SurfaceSingularity::cusp;
    point.certified = true;
    result_.singular_points.push_back(point);
    // Of a crossing on the border of the domain all arcs may be outside: a point of its own.
    if (point.half_branches > 0 || on_contained) return;
    SurfaceComponent component;
    component.kind = SurfaceComponentKind::point;
    component.points.push_back(point.at);
    for (std::size_t k = 0; k < 4; ++k) component.start.side[k] = contact.contact.side(k);
    component.end = component.start;
    component.tangential = true;
    bridge::CrossingPoint at;
    at.parameters = contact.contact.rounded;
    at.radius = 0x1p-53;
    component.error = pair_.error_in_space(at) + pair_.rounding_of(component);
    component.certified = true;
    result_.components.push_back(std::move(component));
  }

  /// Arcs that end there, and border curves in the other patch.
  std::size_t half_branches_at(std::size_t contact) const {
    auto count = std::count_if(graph_.arcs.begin(), graph_.arcs.end(),
                               [&](const bridge::CellArc& arc) { return arc.contact == contact; });
    for (const SurfaceComponent& component : result_.components)
      count += (component.start.singular_point == contact ? 1 : 0) + (component.end.singular_point == contact ? 1 : 0);
    return static_cast<std::size_t>(count);
  }

  /// Border curves end at contacts, which not all are singular points.
  void name_singular_ends() {
    for (SurfaceComponent& component : result_.components)
      for (BranchEnd* end : {&component.start, &component.end})
        if (end->singular_point) end->singular_point = contact_index_[*end->singular_point];
    first_crossing_ = result_.singular_points.size();
  }

  /// They follow the contacts.
  void add_crossing(const bridge::CellCrossing& crossing) {
    SurfaceSingularPoint point;
    point.kind = SurfaceSingularity::crossing;
    point.at = pair_.placed(crossing.crossing.parameters);
    point.radius = crossing.crossing.radius;
    bridge::CrossingPoint at;
    at.parameters = crossing.crossing.parameters;
    at.radius = crossing.crossing.radius;
    point.radius = std::max(point.radius, pair_.error_in_space(at));
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
      singular.push_back(first_crossing_ + i);
    }
    const PatchNets base =
        curve.swapped() ? PatchNets{nets_.exact_second, nets_.second} : PatchNets{nets_.exact_first, nets_.first};
    const ContactArcs found = contact_arcs(curve, base, crossings, tolerance_, pair_.size(), context_);
    if (!found.complete)
      result_.warnings.emplace_back("the surfaces touch along a curve whose pieces in both domains are not proven");
    for (const ContactArc& arc : found.arcs) {
      SurfaceComponent component = pair_.placed(arc);
      component.tangential = true;
      component.certified = arc.proven && found.complete;
      if (!component.certified) component.reason = "the pieces of a curve of contact are not proven";
      for (const auto& [end, crossing] :
           {std::pair(&component.start, arc.start.crossing), std::pair(&component.end, arc.end.crossing)}) {
        if (!crossing) continue;
        end->kind = BranchEndKind::singular;
        end->singular_point = singular[*crossing];
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
      point.radius =
          std::max(point.radius, 0.5 * (pair_.to_domain(k, hull.upper[k]) - pair_.to_domain(k, hull.lower[k])));
    }
    point.at = pair_.placed(middle);
    point.reason = "the surfaces touch here or nearly so, which is not proven";
    result_.singular_points.push_back(std::move(point));
  }

  void add_chain(const BranchChain& chain) {
    SurfaceComponent component;
    component.kind = chain.closed ? SurfaceComponentKind::loop : SurfaceComponentKind::curve;
    component.certified = true;
    bridge::ArcTracer tracer(nets_.first, nets_.second);
    for (std::size_t i = 0; i < chain.arcs.size(); ++i) {
      const bridge::CellArc& arc = graph_.arcs[chain.arcs[i]];
      bridge::TracedArc traced = traced_arc(tracer, arc);
      if (chain.reversed[i]) std::reverse(traced.points.begin(), traced.points.end());
      component.error = std::max(component.error, traced.error);
      component.certified = component.certified && traced.proven;
      for (std::size_t k = component.points.empty() ? 0 : 1; k < traced.points.size(); ++k)
        component.points.push_back(pair_.placed(traced.points[k].parameters, traced.points[k].point));
    }
    component.error += pair_.rounding_of(component);
    if (!component.certified) component.reason = "the distance of the polyline from the curve is not proven";
    if (chain.closed) {
      component.points.back() = component.points.front();
    } else {
      component.start = end_at(chain.start, component);
      component.end = end_at(chain.end, component);
      pair_.put_on_border(component.points.front(), component.start);
      pair_.put_on_border(component.points.back(), component.end);
    }
    result_.components.push_back(std::move(component));
  }

  bridge::TracedArc traced_arc(bridge::ArcTracer& tracer, const bridge::CellArc& arc) const {
    const bridge::CrossingPoint& from = graph_.points[arc.from];
    if (arc.contact) {
      const bridge::CellContact& contact = graph_.contacts[*arc.contact];
      return contact.around.degenerate
                 ? bridge::trace_to_corank_one(nets_.first, nets_.second, from, contact, tolerance_, context_)
                 : bridge::trace_to_contact(nets_, from, contact, tolerance_, context_);
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
      traced = bridge::trace_in_zoom(nets_, from, to, arc.box, factor * tolerance_, context_);
    return traced;
  }

  BranchEnd end_at(std::size_t index, SurfaceComponent& component) {
    const bridge::CrossingPoint& point = graph_.points[index];
    BranchEnd end;
    end.side = point.side;
    const auto contact = std::find_if(graph_.contacts.begin(), graph_.contacts.end(),
                                      [&](const bridge::CellContact& c) { return c.point == index; });
    if (contact != graph_.contacts.end()) {
      end.kind = BranchEndKind::singular;
      end.singular_point = contact_index_[static_cast<std::size_t>(contact - graph_.contacts.begin())];
      return end;
    }
    const auto crossing = std::find_if(graph_.crossings.begin(), graph_.crossings.end(),
                                       [&](const bridge::CellCrossing& c) { return c.point == index; });
    if (crossing != graph_.crossings.end()) {
      end.kind = BranchEndKind::singular;
      end.singular_point = first_crossing_ + static_cast<std::size_t>(crossing - graph_.crossings.begin());
      return end;
    }
    if (std::all_of(point.side.begin(), point.side.end(), [](int side) { return side == 0; })) {
      end.kind = BranchEndKind::unknown;
      component.certified = false;
      component.reason = "an end is next to a point of contact that is not proven";
      return end;
    }
    end.transition = pair_.transition_at(point.parameters, point.side);
    return end;
  }

  BalancedPair pair_;
  bridge::PatchPairNets nets_;
  double tolerance_;
  const Context& context_;
  const bridge::SurfaceContactProver* prover_ = nullptr;
  bridge::ContactCurves* curves_ = nullptr;
  BranchGraph graph_;
  /// Of each contact, among the singular points, where it is one.
  std::vector<std::optional<std::size_t>> contact_index_;
  /// Of the first branch that crosses a curve of contact, there.
  std::size_t first_crossing_ = 0;
  bool common_surface_asked_ = false;
  bool section_asked_ = false;
  SurfaceResult result_;
};

}  // namespace

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
