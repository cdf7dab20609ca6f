// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/branches/injectivity.hpp>
#include <eliminant/bridge/branches/pinch_point.hpp>
#include <eliminant/bridge/branches/zoomed_tracing.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/patches/branch_components.hpp>
#include <eliminant/intersect/patches/branch_joining.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/patch_parts.hpp>
#include <eliminant/intersect/patches/surface_summary.hpp>
#include <eliminant/intersect/patches/triple_points.hpp>

namespace eliminant::intersect {

namespace {

using bridge::nearest;
using symbolic::Rational;

bool touch(const bridge::ParameterRectangle& a, const bridge::ParameterRectangle& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (a.lower[k] > b.upper[k] || b.lower[k] > a.upper[k]) return false;
  return true;
}

/// Whether the gap between both is smaller than this part of them.
bool are_close(const bridge::ParameterRectangle& a, const bridge::ParameterRectangle& b, double part) {
  for (std::size_t k = 0; k < 2; ++k) {
    const double gap = std::max(a.lower[k] - b.upper[k], b.lower[k] - a.upper[k]);
    if (gap > part * std::max(a.upper[k] - a.lower[k], b.upper[k] - b.lower[k])) return false;
  }
  return true;
}

bridge::ParameterRectangle hull(const bridge::ParameterRectangle& a, const bridge::ParameterRectangle& b) {
  bridge::ParameterRectangle result;
  for (std::size_t k = 0; k < 2; ++k) {
    result.lower[k] = std::min(a.lower[k], b.lower[k]);
    result.upper[k] = std::max(a.upper[k], b.upper[k]);
  }
  return result;
}

/// Indices of parts of two trees.
struct PartPair {
  std::size_t first = 0;
  std::size_t second = 0;
};

class PatchWithItself {
 public:
  PatchWithItself(const symbolic::SurfacePiece& patch, const Options& options, const Context& context)
      : patch_(patch),
        net_(prepared_patch(patch, "")),
        options_(options),
        context_(context),
        first_(patch, 0),
        second_(patch, 1) {}

  SurfaceResult run() && {
    const auto start = std::chrono::steady_clock::now();
    result_.problem = "self_intersection";
    result_.engine.method = "subdivision";
    result_.engine.precision_bits = 53;
    result_.status = Status::numeric;
    const auto rounded = net_.rounded(net_.origin());
    if (!rounded || !has_positive_weights(net_)) {
      result_.warnings.push_back(
          "the patch has weights of both signs or zero, or coordinates beyond the range of doubles: it was not looked "
          "at");
    } else {
      result_.status = Status::certified;
      separate(*rounded);
      intersect_parts();
      finish(*rounded);
    }
    result_.seconds.emplace_back("total",
                                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return std::move(result_);
  }

 private:
  /// A gap of that part of a rectangle is small, and cut so often.
  static constexpr double near = 0.0625;
  static constexpr int most_cuts = 4;

  /// Pairs of parts, until those that touch have injective hulls or explain what is between them: then all other double
  /// points are between parts that do not touch.
  void separate(const bridge::ControlNet& net) {
    std::vector<PartPair> touching{{0, 0}};
    constexpr int most_levels = 12;
    constexpr std::size_t most_pairs = 30000;
    for (int level = 0; level < most_levels && !touching.empty() && touching.size() < most_pairs; ++level) {
      std::vector<PartPair> folded;
      for (const PartPair& pair : touching) {
        const PatchPart& a = first_.part(pair.first);
        const PatchPart& b = second_.part(pair.second);
        if (!touch(a.rectangle, b.rectangle))
          separate_further(net, pair, near, most_cuts);
        else if (!bridge::is_injective_on(net, hull(a.rectangle, b.rectangle)))
          folded.push_back(pair);
      }
      folded = without_pinches(net, folded);
      touching.clear();
      if (level + 1 == most_levels || folded.size() * 16 > most_pairs) {
        for (const PartPair& pair : folded) open_.push_back(box_of(pair));
        break;
      }
      for (const PartPair& pair : folded)
        for (const std::size_t i : first_.children(pair.first))
          for (const std::size_t j : second_.children(pair.second)) touching.push_back({i, j});
      context_.checkpoint("looking for parts without self-intersection");
    }
    separate_beside_pinches(net);
  }

  /// Next to a pinch point the surface is folded so sharply that parts have to be far apart to be told apart easily.
  void separate_beside_pinches(const bridge::ControlNet& net) {
    constexpr double not_far = 1.5;
    for (const PartPair& pair : std::exchange(separated_, {})) {
      const bridge::CellBox box = box_of(pair);
      if (std::any_of(pinches_.begin(), pinches_.end(),
                      [&](const Pinch& pinch) { return holds(pinch.rectangle, box); }))
        separate_further(net, pair, not_far, most_cuts);
      else
        separated_.push_back(pair);
    }
  }

  /// Both parts are near a pinch point, and what is known of that says that they have no point in common.
  bool is_off_arcs(const bridge::ControlNet& net, const PartPair& pair) const {
    const bridge::CellBox box = box_of(pair);
    return std::any_of(pinches_.begin(), pinches_.end(), [&](const Pinch& pinch) {
      return holds(pinch.rectangle, box) && bridge::is_off_arc(net, pinch.point, first_.part(pair.first).rectangle,
                                                               second_.part(pair.second).rectangle);
    });
  }

  static bool holds(const bridge::ParameterRectangle& rectangle, const bridge::CellBox& box) {
    for (std::size_t k = 0; k < 2; ++k)
      if (box.lower[k] < rectangle.lower[k] || box.upper[k] > rectangle.upper[k]) return false;
    return true;
  }

  /// A pair that does not touch. With a small gap both are nearly one part of the surface, which many cells would have
  /// to tell apart: injective, or better cut again.
  void separate_further(const bridge::ControlNet& net, const PartPair& pair, double close, int levels) {
    const bridge::ParameterRectangle a = first_.part(pair.first).rectangle;
    const bridge::ParameterRectangle b = second_.part(pair.second).rectangle;
    if (apart(first_.part(pair.first), second_.part(pair.second)) || is_off_arcs(net, pair)) return;
    if (!are_close(a, b, close)) {
      separated_.push_back(pair);
      return;
    }
    if (bridge::is_injective_on(net, hull(a, b))) return;
    if (levels == 0) {
      separated_.push_back(pair);
      return;
    }
    for (const std::size_t i : first_.children(pair.first))
      for (const std::size_t j : second_.children(pair.second)) separate_further(net, {i, j}, close, levels - 1);
  }

  /// The hull of both parts, for both preimages.
  bridge::CellBox box_of(const PartPair& pair) const {
    const bridge::ParameterRectangle h = hull(first_.part(pair.first).rectangle, second_.part(pair.second).rectangle);
    return {{h.lower[0], h.lower[1], h.lower[0], h.lower[1]}, {h.upper[0], h.upper[1], h.upper[0], h.upper[1]}};
  }

  /// Where the surface turns much there may be a pinch point and nothing else; the pairs of which that is not proven.
  std::vector<PartPair> without_pinches(const bridge::ControlNet& net, const std::vector<PartPair>& folded) {
    std::vector<bridge::CellBox> boxes;
    for (const PartPair& pair : folded) boxes.push_back(box_of(pair));
    std::vector<bridge::ParameterRectangle> explained;
    for (const bridge::CellBox& box : clusters_of(boxes)) {
      const bridge::ParameterRectangle rectangle{{box.lower[0], box.lower[1]}, {box.upper[0], box.upper[1]}};
      // On the border of the domain the double curve might end elsewhere.
      bool inside = true;
      for (std::size_t k = 0; k < 2; ++k) inside = inside && rectangle.lower[k] > 0 && rectangle.upper[k] < 1;
      const auto pinch = inside ? bridge::pinch_point_in(net, rectangle) : std::nullopt;
      if (!pinch) continue;
      pinches_.push_back({*pinch, rectangle});
      explained.push_back(rectangle);
    }
    std::vector<PartPair> rest;
    for (std::size_t i = 0; i < folded.size(); ++i) {
      if (std::none_of(explained.begin(), explained.end(), [&](const auto& r) { return holds(r, boxes[i]); }))
        rest.push_back(folded[i]);
    }
    return rest;
  }

  void intersect_parts() {
    const double tolerance = options_.tolerance * size_of(net_);
    std::size_t undecided = 0;
    for (const PartPair& pair : separated_) {
      if (result_.limit) return;
      SurfaceResult part =
          intersect_parts_of_patch(first_.net(pair.first), second_.net(pair.second), tolerance, context_);
      if (part.status == Status::numeric) ++undecided;
      append(result_, std::move(part));
      // A surface that covers another part of itself would go on for long.
      constexpr std::size_t most_undecided = 32;
      if (undecided < most_undecided) continue;
      result_.warnings.push_back("too many parts of the surface may touch each other: the rest was not looked at");
      return;
    }
  }

  void finish(const bridge::ControlNet& net) {
    DomainBounds bounds;
    for (std::size_t k = 0; k < 4; ++k) {
      const symbolic::Interval& side = patch_.region->sides[k % 2];
      bounds[k] = {nearest(side.lower), nearest(side.upper)};
    }
    join_branches(result_, bounds);
    remove_mirror_images(result_, bounds);
    for (const Pinch& pinch : pinches_) add_pinch(net, pinch);
    for (const bridge::CellBox& box : clusters_of(open_)) add_fold(box);
    add_triple_points();
    summarise(result_);
  }

  void add_triple_points() {
    if (result_.limit) return;
    try {
      for (SurfaceSingularPoint& point : triple_points(patch_, result_.components, context_))
        result_.singular_points.push_back(std::move(point));
    } catch (const LimitReached& limit) {
      result_.status = Status::incomplete;
      result_.limit = limit.what();
    }
  }

  struct Pinch {
    bridge::PinchPoint point;
    bridge::ParameterRectangle rectangle;
  };

  double to_domain(std::size_t k, double local) const {
    const symbolic::Interval& side = patch_.region->sides[k % 2];
    const double lower = nearest(side.lower);
    return lower + local * (nearest(side.upper) - lower);
  }
  double from_domain(std::size_t k, double value) const {
    const symbolic::Interval& side = patch_.region->sides[k % 2];
    const double lower = nearest(side.lower);
    return (value - lower) / (nearest(side.upper) - lower);
  }

  SurfacePoint placed(const std::array<double, 4>& local) const {
    SurfacePoint point;
    for (std::size_t k = 0; k < 4; ++k) point.parameters[k] = to_domain(k, local[k]);
    const auto value = patch_.map.at({bridge::exactly(point.parameters[0]), bridge::exactly(point.parameters[1])});
    for (std::size_t k = 0; k < 3; ++k) point.point[k] = value[3].is_zero() ? NAN : nearest(value[k] / value[3]);
    return point;
  }

  /// The one curve that ends at the rectangle of a pinch point goes on to it.
  void add_pinch(const bridge::ControlNet& net, const Pinch& pinch) {
    SurfaceSingularPoint singular;
    singular.kind = SurfaceSingularity::pinch_point;
    const auto& [u, v] = pinch.point.parameters;
    singular.at = placed({u, v, u, v});
    singular.radius =
        pinch.point.radius * std::max(to_domain(0, 1) - to_domain(0, 0), to_domain(1, 1) - to_domain(1, 0));
    singular.half_branches = 1;
    std::vector<std::pair<SurfaceComponent*, bool>> ends;
    for (SurfaceComponent& component : result_.components) {
      if (component.kind != SurfaceComponentKind::curve) continue;
      for (const bool at_start : {false, true}) {
        const BranchEnd& end = at_start ? component.start : component.end;
        const SurfacePoint& point = at_start ? component.points.front() : component.points.back();
        bool inside = end.kind == BranchEndKind::unknown;
        for (std::size_t k = 0; k < 4; ++k) {
          const double local = from_domain(k, point.parameters[k]);
          constexpr double slack = 1e-12;
          inside =
              inside && local > pinch.rectangle.lower[k % 2] - slack && local < pinch.rectangle.upper[k % 2] + slack;
        }
        if (inside) ends.emplace_back(&component, at_start);
      }
    }
    singular.certified = ends.size() == 1;
    if (singular.certified) {
      lead_to_pinch(net, pinch, *ends.front().first, ends.front().second);
    } else {
      singular.reason = "not exactly one double curve was found to end here";
      result_.status = Status::numeric;
    }
    result_.singular_points.push_back(std::move(singular));
  }

  void lead_to_pinch(const bridge::ControlNet& net, const Pinch& pinch, SurfaceComponent& component, bool at_start) {
    if (at_start) {
      std::reverse(component.points.begin(), component.points.end());
      std::swap(component.start, component.end);
    }
    std::array<double, 4> from;
    for (std::size_t k = 0; k < 4; ++k) from[k] = from_domain(k, component.points.back().parameters[k]);
    const std::array<Rational, 3> origin = net_.origin();
    const bridge::TracedArc arc =
        bridge::trace_to_pinch_point({net, net, net_.exact, net_.exact, origin}, from, pinch.point, pinch.rectangle,
                                     options_.tolerance * size_of(net_), context_);
    for (std::size_t i = 1; i < arc.points.size(); ++i) component.points.push_back(placed(arc.points[i].parameters));
    component.end.kind = BranchEndKind::singular;
    component.end.singular_point = result_.singular_points.size();
    component.mirrored = true;
    component.error = std::max(component.error, arc.error);
    if (!arc.proven) {
      component.reason = "the distance of the polyline from the curve next to the pinch point is not proven";
      return;
    }
    if (component.reason == not_followed && component.start.kind != BranchEndKind::unknown) {
      component.certified = true;
      component.reason.clear();
    }
  }

  void add_fold(const bridge::CellBox& box) {
    SurfaceSingularPoint point;
    std::array<double, 4> middle;
    for (std::size_t k = 0; k < 4; ++k) {
      middle[k] = 0.5 * (box.lower[k] + box.upper[k]);
      point.radius = std::max(point.radius, 0.5 * (to_domain(k, box.upper[k]) - to_domain(k, box.lower[k])));
    }
    point.at = placed(middle);
    point.reason =
        "the surface turns so much within the radius that it may meet itself there: a pinch point or an edge";
    result_.singular_points.push_back(std::move(point));
    result_.status = Status::numeric;
  }

  const symbolic::SurfacePiece& patch_;
  PreparedNet net_;
  const Options& options_;
  const Context& context_;
  PartTree first_;
  PartTree second_;
  /// Of parts that do not touch.
  std::vector<PartPair> separated_;
  /// Hulls of parts that touch and are not known to be injective, as boxes of pairs of parameters.
  std::vector<bridge::CellBox> open_;
  std::vector<Pinch> pinches_;
  SurfaceResult result_;
};

}  // namespace

SurfaceResult intersect_patch_with_itself(const symbolic::SurfacePiece& patch, const Options& options,
                                          const Context& context) {
  return PatchWithItself(patch, options, context).run();
}

}  // namespace eliminant::intersect
