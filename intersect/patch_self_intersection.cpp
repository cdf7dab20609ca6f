// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/bridge/ball.hpp>
#include <eliminant/bridge/branch_tracing.hpp>
#include <eliminant/bridge/injectivity.hpp>
#include <eliminant/bridge/pinch_point.hpp>
#include <eliminant/intersect/branch_components.hpp>
#include <eliminant/intersect/branch_joining.hpp>
#include <eliminant/intersect/patch_pair.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Integer;
using symbolic::Rational;

/// Where a patch is cut along both parameters, in [0, 1], from 0 to 1.
using Grid = std::array<std::vector<Rational>, 2>;

double nearest(const Rational& value) {
  bridge::RealBall ball;
  arb_set_fmpq(ball.get(), value.get(), 64);
  return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
}

/// About equal parts. The lines of the two grids differ, and have no symmetry: inputs do, and their double curves would
/// pass through corners.
Grid grid_of(std::size_t parts, bool second) {
  Grid grid;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    grid[axis].emplace_back(0);
    for (std::size_t i = 1; i < parts; ++i) {
      // Shifted by up to a fifth of a part: steps of the golden ratio, in 1024ths.
      const auto turn = static_cast<long>((i * 633 + axis * 217 + (second ? 391 : 58)) % 1024);
      const Rational shift = Rational((turn - 512) * 2 / 5) / Rational(1024);
      grid[axis].push_back((Rational(static_cast<long>(i)) + shift) / Rational(static_cast<long>(parts)));
    }
    grid[axis].emplace_back(1);
  }
  return grid;
}

/// A part of the patch between neighbouring lines.
struct Part {
  bridge::ParameterRectangle rectangle;
  symbolic::SurfacePiece piece;
  std::optional<PreparedNet> net;
  /// Around its control points.
  std::array<double, 3> lower{};
  std::array<double, 3> upper{};
};

bool touch(const bridge::ParameterRectangle& a, const bridge::ParameterRectangle& b) {
  for (std::size_t k = 0; k < 2; ++k)
    if (a.lower[k] > b.upper[k] || b.lower[k] > a.upper[k]) return false;
  return true;
}

bool apart(const Part& a, const Part& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.lower[k] > b.upper[k] || b.lower[k] > a.upper[k]) return true;
  return false;
}

bridge::ParameterRectangle hull(const bridge::ParameterRectangle& a, const bridge::ParameterRectangle& b) {
  bridge::ParameterRectangle result;
  for (std::size_t k = 0; k < 2; ++k) {
    result.lower[k] = std::min(a.lower[k], b.lower[k]);
    result.upper[k] = std::max(a.upper[k], b.upper[k]);
  }
  return result;
}

std::vector<bridge::ParameterRectangle> rectangles_of(const Grid& grid) {
  std::vector<bridge::ParameterRectangle> result;
  for (std::size_t i = 0; i + 1 < grid[0].size(); ++i)
    for (std::size_t j = 0; j + 1 < grid[1].size(); ++j)
      result.push_back(
          {{nearest(grid[0][i]), nearest(grid[1][j])}, {nearest(grid[0][i + 1]), nearest(grid[1][j + 1])}});
  return result;
}

class PatchWithItself {
 public:
  PatchWithItself(const symbolic::SurfacePiece& patch, const Options& options, const Context& context)
      : patch_(patch), net_(prepared_patch(patch, "")), options_(options), context_(context) {}

  SurfaceResult run() && {
    const auto start = std::chrono::steady_clock::now();
    result_.problem = "self_intersection";
    result_.engine.method = "subdivision";
    result_.engine.precision_bits = 53;
    result_.status = Status::numeric;
    const auto rounded = net_.rounded(net_.origin());
    if (!rounded) {
      result_.warnings.push_back("coordinates are beyond the range in which hardware doubles are safe");
    } else {
      result_.status = Status::certified;
      choose_grids(*rounded);
      intersect_parts();
      finish(*rounded);
    }
    result_.seconds.emplace_back("total",
                                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return std::move(result_);
  }

 private:
  /// Parts that touch must have injective hulls: then all double points are between parts that do not touch.
  void choose_grids(const bridge::ControlNet& net) {
    constexpr std::size_t most_parts = 32;
    for (std::size_t parts = 1; parts <= most_parts; parts *= 2) {
      first_grid_ = grid_of(parts, false);
      second_grid_ = grid_of(parts, true);
      folded_.clear();
      const auto first = rectangles_of(first_grid_);
      const auto second = rectangles_of(second_grid_);
      for (const bridge::ParameterRectangle& a : first)
        for (const bridge::ParameterRectangle& b : second) {
          if (!touch(a, b) || bridge::is_injective_on(net, hull(a, b))) continue;
          const bridge::ParameterRectangle h = hull(a, b);
          folded_.push_back(
              {{h.lower[0], h.lower[1], h.lower[0], h.lower[1]}, {h.upper[0], h.upper[1], h.upper[0], h.upper[1]}});
        }
      if (folded_.empty() || explain_folds(net)) return;
      context_.checkpoint("looking for parts without self-intersection");
    }
  }

  /// Where the surface turns most there may be a pinch point, and nothing else.
  bool explain_folds(const bridge::ControlNet& net) {
    pinches_.clear();
    for (const bridge::CellBox& box : clusters_of(folded_)) {
      const bridge::ParameterRectangle rectangle{{box.lower[0], box.lower[1]}, {box.upper[0], box.upper[1]}};
      const auto pinch = bridge::pinch_point_in(net, rectangle);
      if (!pinch) return false;
      pinches_.push_back({*pinch, rectangle});
    }
    folded_.clear();
    return true;
  }

  std::vector<Part> parts_of(const Grid& grid) const {
    std::vector<Part> parts;
    const auto rectangles = rectangles_of(grid);
    const auto place = [&](std::size_t axis, const Rational& local) {
      const symbolic::Interval& side = patch_.region->sides[axis];
      return side.lower + local * (side.upper - side.lower);
    };
    for (std::size_t i = 0; i + 1 < grid[0].size(); ++i)
      for (std::size_t j = 0; j + 1 < grid[1].size(); ++j) {
        symbolic::SurfacePiece piece = patch_;
        piece.region->sides[0] = {place(0, grid[0][i]), place(0, grid[0][i + 1])};
        piece.region->sides[1] = {place(1, grid[1][j]), place(1, grid[1][j + 1])};
        Part part{rectangles[parts.size()], piece, prepared_patch(piece, ""), {}, {}};
        part.lower.fill(INFINITY);
        part.upper.fill(-INFINITY);
        for (const bridge::ExactPoint& point : part.net->exact.points)
          for (std::size_t k = 0; k < 3; ++k) {
            const double x = point[3].sign() > 0 ? nearest(point[k] / point[3]) : NAN;
            const double slack = 1e-12 * std::fabs(x);
            part.lower[k] = std::min(part.lower[k], x - slack);
            part.upper[k] = std::max(part.upper[k], x + slack);
          }
        parts.push_back(std::move(part));
      }
    return parts;
  }

  void intersect_parts() {
    const std::vector<Part> first = parts_of(first_grid_);
    const std::vector<Part> second = parts_of(second_grid_);
    const double tolerance = options_.tolerance * size_of(net_);
    for (const Part& a : first)
      for (const Part& b : second) {
        if (touch(a.rectangle, b.rectangle) || apart(a, b) || result_.limit) continue;
        append(result_, intersect_patches(*a.net, *b.net, tolerance, context_));
      }
  }

  void finish(const bridge::ControlNet& net) {
    DomainBounds bounds;
    for (std::size_t k = 0; k < 4; ++k) {
      const symbolic::Interval& side = patch_.region->sides[k % 2];
      bounds[k] = {nearest(side.lower), nearest(side.upper)};
    }
    join_branches(result_, bounds);
    remove_mirror_images(result_);
    for (const Pinch& pinch : pinches_) add_pinch(net, pinch);
    for (const bridge::CellBox& box : clusters_of(folded_)) add_fold(box);
    summarise(result_);
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
    const auto value = patch_.map.at({rational(point.parameters[0]), rational(point.parameters[1])});
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
    const auto& [u, v] = pinch.point.parameters;
    const bridge::CellBox box{
        {pinch.rectangle.lower[0], pinch.rectangle.lower[1], pinch.rectangle.lower[0], pinch.rectangle.lower[1]},
        {pinch.rectangle.upper[0], pinch.rectangle.upper[1], pinch.rectangle.upper[0], pinch.rectangle.upper[1]}};
    // Both preimages come together, and doubles tell them apart so far only.
    bridge::TracedArc arc;
    double chord = 0;
    constexpr double most = 4096;
    for (double factor = 1; !arc.proven && factor < most; factor *= 4) {
      const double tolerance = factor * options_.tolerance * size_of(net_);
      double near = 0x1p-6;
      std::optional<double> reach;
      for (; near > 0x1p-40 && !(reach && *reach < tolerance); near *= 0.5)
        reach = bridge::reach_of_pinch_point(net, pinch.point, 0.5 * near);
      chord = reach.value_or(INFINITY);
      arc = bridge::BranchTracer(net, net).trace_near(from, {u, v, u, v}, box, near, tolerance, context_);
    }
    for (std::size_t i = 1; i < arc.points.size(); ++i) component.points.push_back(placed(arc.points[i].parameters));
    component.points.push_back(placed({u, v, u, v}));
    component.end.kind = BranchEndKind::singular;
    component.end.singular_point = result_.singular_points.size();
    component.mirrored = true;
    component.error = std::max({component.error, arc.error, chord});
    if (!arc.proven || !std::isfinite(chord)) {
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

  static Rational rational(double x) {
    Rational result;
    bridge::RealBall ball;
    arb_set_d(ball.get(), x);
    arf_get_fmpq(result.get(), arb_midref(ball.get()));
    return result;
  }

  const symbolic::SurfacePiece& patch_;
  PreparedNet net_;
  const Options& options_;
  const Context& context_;
  Grid first_grid_;
  Grid second_grid_;
  /// Hulls of parts that touch and are not known to be injective, as boxes of pairs of parameters.
  std::vector<bridge::CellBox> folded_;
  std::vector<Pinch> pinches_;
  SurfaceResult result_;
};

}  // namespace

SurfaceResult intersect_patch_with_itself(const symbolic::SurfacePiece& patch, const Options& options,
                                          const Context& context) {
  return PatchWithItself(patch, options, context).run();
}

}  // namespace eliminant::intersect
