// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/joined_self_intersection.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include <eliminant/bridge/rounding/rational_double.hpp>
#include <eliminant/intersect/patches/branch_components.hpp>
#include <eliminant/intersect/patches/branch_joining.hpp>
#include <eliminant/intersect/patches/one_sign_parts.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/patch_parts.hpp>
#include <eliminant/intersect/patches/surface_atlas.hpp>
#include <eliminant/intersect/patches/surface_summary.hpp>
#include <eliminant/intersect/whole_surfaces/projective_charts.hpp>

namespace eliminant::intersect {

namespace {

using bridge::nearest;
using bridge::ParameterRectangle;

ParameterRectangle hull(const ParameterRectangle& a, const ParameterRectangle& b) {
  ParameterRectangle result;
  for (std::size_t k = 0; k < 2; ++k) {
    result.lower[k] = std::min(a.lower[k], b.lower[k]);
    result.upper[k] = std::max(a.upper[k], b.upper[k]);
  }
  return result;
}

/// The largest gap between both, relative to their sides; not above 0 where they touch.
double gap_between(const ParameterRectangle& a, const ParameterRectangle& b) {
  double result = -INFINITY;
  for (std::size_t k = 0; k < 2; ++k) {
    const double gap = std::max(a.lower[k] - b.upper[k], b.lower[k] - a.upper[k]);
    result = std::max(result, gap / std::max(a.upper[k] - a.lower[k], b.upper[k] - b.lower[k]));
  }
  return result;
}

/// With a gap up to that both parts are nearly one, which many cells would have to tell apart: injective, or better cut
/// again.
constexpr double near = 0.0625;

std::vector<ProjectiveChart> charts_of(const symbolic::ParametricSurface& surface, SurfaceResult& result) {
  constexpr std::size_t own_cuts = 2;
  std::vector<ProjectiveChart> charts;
  for (const ProjectiveChart& chart : projective_charts(surface, own_cuts)) {
    OneSignParts cut = one_sign_parts(chart.piece, own_cuts);
    if (cut.signs != WeightSigns::one) {
      result.warnings.emplace_back(
          "the weight of the surface has a zero in its domain, or comes near to one: it was not looked at");
      return {};
    }
    for (symbolic::SurfacePiece& part : cut.parts) charts.push_back({std::move(part), {}, chart.corner});
  }
  return charts;
}

/// A part of a chart.
struct ChartPart {
  std::size_t chart = 0;
  std::size_t index = 0;
};

struct ChartPartPair {
  ChartPart first;
  ChartPart second;
};

class SurfaceWithItself {
 public:
  SurfaceWithItself(const symbolic::ParametricSurface& surface, const std::vector<ProjectiveChart>& charts,
                    SurfaceResult& result, const Options& options, const Context& context)
      : surface_(surface),
        charts_(charts),
        result_(result),
        options_(options),
        context_(context),
        atlas_(surface, charts) {
    const auto origin = prepared_patch(charts.front().piece, "first").origin();
    for (const ProjectiveChart& chart : charts) {
      size_ = std::max(size_, size_of(prepared_patch(chart.piece, "first")));
      for (std::size_t kind = 0; kind < 2; ++kind) trees_[kind].emplace_back(chart.piece, kind, origin);
    }
  }

  void run() {
    if (!atlas_.is_rounded()) {
      result_.warnings.emplace_back("coordinates are beyond the range in which hardware doubles are safe");
      return;
    }
    result_.status = Status::certified;
    if (!atlas_.is_continuous()) {
      result_.warnings.emplace_back("pieces that are neighbours do not have the same points on the side between them");
      result_.status = Status::numeric;
    }
    separate();
    intersect_parts();
    const DomainBounds bounds = domain_bounds(surface_, surface_);
    join_branches(result_, bounds);
    remove_mirror_images(result_, bounds);
    remove_points_of_closing();
    for (const bridge::CellBox& box : clusters_of(open_)) add_fold(box);
    summarise(result_);
  }

 private:
  const PatchPart& part(std::size_t kind, const ChartPart& part) const {
    return trees_[kind][part.chart].part(part.index);
  }

  /// Around the part, in the parameters of the surface: neighbours touch.
  ParameterRectangle rectangle_of(std::size_t kind, const ChartPart& at) const {
    const ProjectiveChart& chart = charts_[at.chart];
    const PatchPart& own = part(kind, at);
    std::array<symbolic::Interval, 2> sides;
    for (std::size_t k = 0; k < 2; ++k) {
      const symbolic::Interval& whole = chart.piece.region->sides[k];
      const symbolic::Rational length = whole.upper - whole.lower;
      sides[k] = {whole.lower + own.sides[k].lower * length, whole.lower + own.sides[k].upper * length};
    }
    if (!chart.corner)
      return {{nearest(sides[0].lower), nearest(sides[1].lower)}, {nearest(sides[0].upper), nearest(sides[1].upper)}};
    // Lines remain lines: the corners are the corners of a quadrilateral.
    ParameterRectangle result{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (const symbolic::Rational& a : {sides[0].lower, sides[0].upper})
      for (const symbolic::Rational& b : {sides[1].lower, sides[1].upper}) {
        const std::array<double, 2> place = chart.corner->at(nearest(a), nearest(b));
        constexpr double rounding = 1e-14;
        for (std::size_t k = 0; k < 2; ++k) {
          result.lower[k] = std::min(result.lower[k], place[k] - rounding);
          result.upper[k] = std::max(result.upper[k], place[k] + rounding);
        }
      }
    return result;
  }

  /// The rectangle, and where the surface closes it one period before and after.
  std::vector<ParameterRectangle> images_of(const ParameterRectangle& rectangle) const {
    std::vector<ParameterRectangle> images{rectangle};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& period = atlas_.periods()[k];
      if (!period) continue;
      const std::vector<ParameterRectangle> before = images;
      for (const ParameterRectangle& image : before)
        for (const double shift : {-*period, *period}) {
          images.push_back(image);
          // What touches exactly touches when both ends of the domain are rounded, too.
          const double rounding = 0x1p-50 * (std::fabs(image.lower[k]) + std::fabs(image.upper[k]) + std::fabs(shift));
          images.back().lower[k] += shift - rounding;
          images.back().upper[k] += shift + rounding;
        }
    }
    return images;
  }

  enum class Relation { apart, injective, near, touching };

  /// Of a pair of parts: they have no common point, or none but points of equal parameters; what is not known is
  /// whether they touch in the parameters.
  Relation relation(const ChartPartPair& pair) const {
    const ParameterRectangle a = rectangle_of(0, pair.first);
    const ParameterRectangle b = rectangle_of(1, pair.second);
    bool touches = false;
    bool is_near = false;
    bool injective = true;
    for (const ParameterRectangle& image : images_of(b)) {
      const double gap = gap_between(a, image);
      if (gap > near) continue;
      is_near = true;
      touches = touches || gap <= 0;
      injective = injective && atlas_.is_injective_on(hull(a, image));
    }
    if (is_near && injective) return Relation::injective;
    if (!touches && intersect::apart(part(0, pair.first), part(1, pair.second))) return Relation::apart;
    return touches ? Relation::touching : Relation::near;
  }

  void separate() {
    std::vector<ChartPartPair> open;
    for (std::size_t i = 0; i < charts_.size(); ++i)
      for (std::size_t j = 0; j < charts_.size(); ++j) open.push_back({{i, 0}, {j, 0}});
    constexpr int most_levels = 12;
    constexpr std::size_t most_pairs = 30000;
    constexpr int most_cuts = 4;
    for (int level = 0; !open.empty(); ++level) {
      std::vector<ChartPartPair> folded;
      for (const ChartPartPair& pair : open) {
        const Relation found = relation(pair);
        constexpr int most_levels_at_pole = 4;
        if (found == Relation::injective || found == Relation::apart) continue;
        if (level >= most_levels_at_pole &&
            atlas_.meet_at_pole(rectangle_of(0, pair.first), rectangle_of(1, pair.second)))
          open_.push_back(box_of(pair));
        else if (found == Relation::touching ||
                 atlas_.meet_at_pole(rectangle_of(0, pair.first), rectangle_of(1, pair.second)))
          folded.push_back(pair);
        else
          separate_further(pair, found, most_cuts);
      }
      if (level == most_levels || folded.size() * 16 > most_pairs) {
        for (const ChartPartPair& pair : folded) open_.push_back(box_of(pair));
        return;
      }
      open.clear();
      for (const ChartPartPair& pair : folded)
        for (const ChartPartPair& smaller : quarters(pair)) open.push_back(smaller);
      context_.checkpoint("looking for parts without self-intersection");
    }
  }

  /// A pair that does not touch. Where the gap is small, injective, or better cut again.
  void separate_further(const ChartPartPair& pair, Relation found, int levels) {
    if (found == Relation::apart || found == Relation::injective) return;
    const ParameterRectangle a = rectangle_of(0, pair.first);
    bool is_near = false;
    for (const ParameterRectangle& image : images_of(rectangle_of(1, pair.second)))
      is_near = is_near || gap_between(a, image) <= near;
    if (!is_near || levels == 0) {
      separated_.push_back(pair);
      return;
    }
    for (const ChartPartPair& smaller : quarters(pair)) separate_further(smaller, relation(smaller), levels - 1);
  }

  std::vector<ChartPartPair> quarters(const ChartPartPair& pair) {
    std::vector<ChartPartPair> result;
    for (const std::size_t i : trees_[0][pair.first.chart].children(pair.first.index))
      for (const std::size_t j : trees_[1][pair.second.chart].children(pair.second.index))
        result.push_back({{pair.first.chart, i}, {pair.second.chart, j}});
    return result;
  }

  bridge::CellBox box_of(const ChartPartPair& pair) const {
    const ParameterRectangle a = rectangle_of(0, pair.first);
    const ParameterRectangle b = rectangle_of(1, pair.second);
    return {{a.lower[0], a.lower[1], b.lower[0], b.lower[1]}, {a.upper[0], a.upper[1], b.upper[0], b.upper[1]}};
  }

  void intersect_parts() {
    const double tolerance = options_.tolerance * size_;
    std::size_t undecided = 0;
    for (const ChartPartPair& pair : separated_) {
      if (result_.limit) return;
      const auto& [a, b] = pair;
      SurfaceResult found = intersect_parts_of_patch(trees_[0][a.chart].net(a.index), trees_[1][b.chart].net(b.index),
                                                     tolerance, context_);
      to_surface_parameters(found, charts_[a.chart], charts_[b.chart]);
      if (found.status == Status::numeric) ++undecided;
      append(result_, std::move(found));
      // A surface that covers another part of itself would go on for long.
      constexpr std::size_t most_undecided = 32;
      if (undecided < most_undecided) continue;
      result_.warnings.emplace_back("too many parts of the surface may touch each other: the rest was not looked at");
      return;
    }
  }

  /// Where a surface closes each point has parameters at both ends: a curve through it is found with other ones as a
  /// point of the border.
  void remove_points_of_closing() {
    std::erase_if(result_.components, [&](const SurfaceComponent& component) {
      if (component.kind != SurfaceComponentKind::point) return false;
      return std::any_of(result_.components.begin(), result_.components.end(), [&](const SurfaceComponent& curve) {
        if (curve.kind != SurfaceComponentKind::curve) return false;
        const auto& at = component.points.front().parameters;
        return is_image(at, curve.points.front().parameters) || is_image(at, curve.points.back().parameters);
      });
    });
  }

  /// Whether both pairs of parameters are the same points of a surface that closes, in either order.
  bool is_image(const std::array<double, 4>& a, const std::array<double, 4>& b) const {
    const auto same = [&](std::size_t i, std::size_t j) {
      const double difference = std::fabs(a[i] - b[j]);
      const double period = atlas_.periods()[i % 2].value_or(0);
      constexpr double accuracy = 1e-9;
      return std::min(difference, std::fabs(difference - period)) <= accuracy * std::max(1.0, period);
    };
    return (same(0, 0) && same(1, 1) && same(2, 2) && same(3, 3)) ||
           (same(0, 2) && same(1, 3) && same(2, 0) && same(3, 1));
  }

  std::array<double, 3> point_at(double u, double v) const {
    using bridge::exactly;
    std::array<double, 3> result{NAN, NAN, NAN};
    for (const symbolic::SurfacePiece& piece : surface_.pieces) {
      const bool triangle = piece.region->triangle;
      const auto& [first, second] = piece.region->sides;
      if (!triangle && (exactly(u) < first.lower || first.upper < exactly(u) || exactly(v) < second.lower ||
                        second.upper < exactly(v)))
        continue;
      std::vector<symbolic::Rational> parameters{exactly(u), exactly(v)};
      if (triangle) parameters.push_back(symbolic::Rational(1) - exactly(u) - exactly(v));
      const auto value = piece.map.at(parameters);
      for (std::size_t k = 0; k < 3 && !value[3].is_zero(); ++k) result[k] = nearest(value[k] / value[3]);
      break;
    }
    return result;
  }

  void add_fold(const bridge::CellBox& box) {
    SurfaceSingularPoint point;
    for (std::size_t k = 0; k < 4; ++k) {
      point.at.parameters[k] = 0.5 * (box.lower[k] + box.upper[k]);
      point.radius = std::max(point.radius, 0.5 * (box.upper[k] - box.lower[k]));
    }
    point.at.point = point_at(point.at.parameters[0], point.at.parameters[1]);
    point.reason =
        "the surface turns so much within the radius that it may meet itself there: a pinch point, an edge or a pole";
    result_.singular_points.push_back(std::move(point));
    result_.status = Status::numeric;
  }

  const symbolic::ParametricSurface& surface_;
  const std::vector<ProjectiveChart>& charts_;
  SurfaceResult& result_;
  const Options& options_;
  const Context& context_;
  SurfaceAtlas atlas_;
  double size_ = 0;
  /// Of each chart, cut at different places for the first and the second point.
  std::array<std::vector<PartTree>, 2> trees_;
  /// Of parts that do not touch.
  std::vector<ChartPartPair> separated_;
  /// Pairs that touch and are not known to be injective.
  std::vector<bridge::CellBox> open_;
};

}  // namespace

SurfaceResult intersect_joined_surface_with_itself(const symbolic::ParametricSurface& surface, const Options& options,
                                                   const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  SurfaceResult result;
  result.problem = "self_intersection";
  result.engine.method = "subdivision";
  result.engine.precision_bits = 53;
  result.status = Status::numeric;
  const std::vector<ProjectiveChart> charts = charts_of(surface, result);
  if (!charts.empty()) SurfaceWithItself(surface, charts, result, options, context).run();
  result.seconds.emplace_back("total", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return result;
}

}  // namespace eliminant::intersect
