// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/overlaps/common_surface.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/nets/exact_plane.hpp>
#include <eliminant/bridge/nets/function_net.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/intersect/overlaps/border_arcs.hpp>
#include <eliminant/intersect/overlaps/patch_inversion.hpp>
#include <eliminant/intersect/patches/net_patches.hpp>
#include <eliminant/intersect/patches/only_common_point.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/symbolic/elimination/implicit_equation.hpp>
#include <eliminant/symbolic/elimination/vanishing.hpp>
#include <eliminant/symbolic/geometry/image_dimension.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>
#include <eliminant/symbolic/matrices/representation_rank.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ExactNet;
using Eigen::Array4d;
using Eigen::Vector3d;
using symbolic::Polynomial;
using symbolic::RationalSurface;

/// Of a plane in which both patches lie, of any degree.
std::optional<Polynomial> common_plane(const ExactNet& first, const ExactNet& second) {
  std::vector<bridge::ExactPoint> points = first.points;
  points.insert(points.end(), second.points.begin(), second.points.end());
  const auto plane = bridge::plane_through(std::move(points));
  if (!plane) return std::nullopt;
  Polynomial equation(4);
  for (std::size_t k = 0; k < 4; ++k) equation = equation + (*plane)[k] * Polynomial::variable(4, k);
  return equation;
}

/// The equation of the first surface, if the second satisfies it.
std::optional<Polynomial> common_equation(const RationalSurface& first, const RationalSurface& second,
                                          const Context& context) {
  constexpr long largest_degree = 8;
  for (const RationalSurface* surface : {&first, &second}) {
    if (2 * surface->bidegree()[0] * surface->bidegree()[1] > largest_degree) return std::nullopt;
    if (!symbolic::is_two_dimensional(*surface)) return std::nullopt;
  }
  try {
    const auto m = symbolic::matrix_representation(first);
    const std::uint64_t seed = Options().seed;
    if (symbolic::rank_on_modulo(m, second, seed) == m.rows()) return std::nullopt;
    Polynomial equation =
        symbolic::implicit_equation(first, m, symbolic::implicit_degree(first, m, seed), seed, context);
    if (!symbolic::vanishes_on(equation, second, context)) return std::nullopt;
    return equation;
  } catch (const LimitReached&) {
    // Of the context, or of the equation.
    context.checkpoint("comparing patches");
  } catch (const InvalidInput&) {
  }
  return std::nullopt;
}

/// Whether the surface has no singular point on the patch: its partial derivatives have no common zero there.
bool is_smooth_on(const Polynomial& equation, const RationalSurface& patch) {
  const std::array<symbolic::Interval, 2> domain{symbolic::Interval{0, 1}, symbolic::Interval{0, 1}};
  std::vector<bridge::ControlNet> slopes;
  for (std::size_t k = 0; k < 4; ++k) {
    const Polynomial slope = equation.derivative(k).compose(patch.coordinates());
    if (!slope.is_zero()) slopes.push_back(bridge::function_net(slope, domain));
  }
  struct Part {
    std::array<double, 2> lower;
    double width;
  };
  std::vector<Part> parts{{{0, 0}, 1}};
  constexpr double smallest_width = 0x1p-7;
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    const std::array<double, 2> upper{part.lower[0] + part.width, part.lower[1] + part.width};
    const auto excludes = [&](const bridge::ControlNet& slope) {
      return bridge::excludes_zero(slope, part.lower, upper, 0);
    };
    if (std::any_of(slopes.begin(), slopes.end(), excludes)) continue;
    if (part.width <= smallest_width) return false;
    const double half = 0.5 * part.width;
    for (const double a : {0.0, half})
      for (const double b : {0.0, half}) parts.push_back({{part.lower[0] + a, part.lower[1] + b}, half});
  }
  return true;
}

bool is_embedded(const symbolic::SurfacePiece& patch, const Context& context) {
  const SurfaceResult itself = intersect_patch_with_itself(patch, Options(), context);
  return itself.status == Status::certified && itself.components.empty() && itself.singular_points.empty();
}

/// A border that is one point: the patch is no disc by its parameters, whose double points around it have no end.
bool has_tip(const ExactNet& net) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (const int side : {-1, 1})
      if (is_one_point(net, axis, side)) return true;
  return false;
}

using Parameters = std::array<double, 4>;

double distance(const Parameters& a, const Parameters& b) {
  double result = 0;
  for (std::size_t k = 0; k < 4; ++k) result = std::max(result, std::fabs(a[k] - b[k]));
  return result;
}

void reverse(DrawnCurve& curve) {
  std::reverse(curve.parameters.begin(), curve.parameters.end());
  std::reverse(curve.points.begin(), curve.points.end());
}

/// Of two discs in one smooth surface.
class Outlines {
 public:
  Outlines(const bridge::ControlNet& first, const bridge::ControlNet& second, double tolerance)
      : first_(first),
        second_(second),
        jets_{bridge::PatchJets(first), bridge::PatchJets(second)},
        tolerance_(tolerance) {}

  std::optional<PatchOverlap> of(const BorderArcs& borders) && {
    for (const BorderArc& arc : borders.arcs)
      if (!add(arc)) return std::nullopt;
    std::vector<DrawnCurve> outlines;
    std::vector<DrawnCurve> open;
    if (!join(std::move(outline_), outlines, open) || !open.empty()) return std::nullopt;
    for (DrawnCurve& outline : outlines) {
      // A common part with a hole is no disc.
      if (!(area(outline) > 0)) return std::nullopt;
      result_.outlines.push_back(std::move(outline));
    }
    if (!join(std::move(touching_), result_.loops, result_.curves)) return std::nullopt;
    for (const Parameters& at : borders.meetings)
      if (!is_on_arc(at)) add_point(at);
    result_.complete = true;
    return std::move(result_);
  }

 private:
  /// Everything that is asked of an arc is asked in its middle, where it is far from being undecided.
  bool add(const BorderArc& arc) {
    const std::size_t own = arc.part.axis / 2;
    const std::size_t kept = arc.part.axis % 2;
    DrawnCurve drawn = drawn_border(first_, second_, arc.part, tolerance_);
    std::array<double, 2> place{};
    place[kept] = arc.part.side < 0 ? 0 : 1;
    place[1 - kept] = 0.5 * (arc.part.lower + arc.part.upper);
    const auto here = jets_[own].at(place[0], place[1]);
    const std::array<double, 2> image = nearest_parameters(jets_[1 - own], here.point);
    const auto there = jets_[1 - own].at(image[0], image[1]);
    const double turn = cosine(normal(here), normal(there));
    constexpr double parallel = 0.99;
    if (!(std::fabs(turn) > parallel)) return false;
    // With the patch on the left: u rises where v is smallest, v rises where u is largest.
    bool forward = (kept == 1) == (arc.part.side < 0);
    if (own == 1 && turn < 0) forward = !forward;
    if (!forward) reverse(drawn);
    if (!arc.on_both) {
      outline_.push_back(std::move(drawn));
      return true;
    }
    const auto same_side = lie_on_one_side(here, there, kept, arc.part.side, image);
    if (!same_side) return false;
    (*same_side ? outline_ : touching_).push_back(std::move(drawn));
    return true;
  }

  static Vector3d vector(const Array4d& a) { return {a[0], a[1], a[2]}; }
  static Vector3d normal(const bridge::PatchJets::Value& at) { return vector(at.first[0]).cross(vector(at.first[1])); }
  static double cosine(const Vector3d& a, const Vector3d& b) { return a.dot(b) / (a.norm() * b.norm()); }

  /// Whether both patches lie on one side of an arc of both borders, within the surface.
  static std::optional<bool> lie_on_one_side(const bridge::PatchJets::Value& here,
                                             const bridge::PatchJets::Value& there, std::size_t kept, int side,
                                             const std::array<double, 2>& image) {
    const Vector3d tangent = vector(here.first[1 - kept]).normalized();
    const Vector3d inward = vector(here.first[kept]) * -side;
    constexpr double near = 1e-9;
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (const int end : {-1, 1}) {
        if (std::fabs(image[axis] - (end < 0 ? 0 : 1)) > near) continue;
        const Vector3d other = vector(there.first[axis]) * -end;
        const double turn = cosine(inward - inward.dot(tangent) * tangent, other - other.dot(tangent) * tangent);
        constexpr double parallel = 0.99;
        if (!(std::fabs(turn) > parallel)) return std::nullopt;
        return turn > 0;
      }
    return std::nullopt;
  }

  /// To closed and open chains, each arc followed by the one that begins where it ends; false where that is not one.
  static bool join(std::vector<DrawnCurve> arcs, std::vector<DrawnCurve>& closed, std::vector<DrawnCurve>& open) {
    constexpr double same = 1e-9;
    constexpr double apart = 1e-6;
    std::vector<std::ptrdiff_t> next(arcs.size(), -1);
    std::vector<bool> follows(arcs.size(), false);
    for (std::size_t i = 0; i < arcs.size(); ++i)
      for (std::size_t j = 0; j < arcs.size(); ++j) {
        const double d = distance(arcs[i].parameters.back(), arcs[j].parameters.front());
        if (d > apart) continue;
        if (d > same || next[i] >= 0 || follows[j]) return false;
        next[i] = static_cast<std::ptrdiff_t>(j);
        follows[j] = true;
      }
    std::vector<bool> used(arcs.size(), false);
    for (const bool with_end : {true, false})
      for (std::size_t i = 0; i < arcs.size(); ++i) {
        if (used[i] || (with_end && follows[i])) continue;
        DrawnCurve chain;
        std::size_t at = i;
        while (true) {
          used[at] = true;
          append(chain, arcs[at]);
          if (next[at] < 0 || used[static_cast<std::size_t>(next[at])]) break;
          at = static_cast<std::size_t>(next[at]);
        }
        if (!with_end) {
          chain.parameters.back() = chain.parameters.front();
          chain.points.back() = chain.points.front();
        }
        (with_end ? open : closed).push_back(std::move(chain));
      }
    return true;
  }

  static void append(DrawnCurve& chain, const DrawnCurve& arc) {
    const std::ptrdiff_t known = chain.points.empty() ? 0 : 1;
    chain.parameters.insert(chain.parameters.end(), arc.parameters.begin() + known, arc.parameters.end());
    chain.points.insert(chain.points.end(), arc.points.begin() + known, arc.points.end());
    chain.error = std::max(chain.error, arc.error);
  }

  /// In the parameters of the first patch, positive for an outline that runs counterclockwise.
  static double area(const DrawnCurve& outline) {
    double sum = 0;
    const auto& p = outline.parameters;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) sum += p[i][0] * p[i + 1][1] - p[i + 1][0] * p[i][1];
    return 0.5 * sum;
  }

  bool is_on_arc(const Parameters& at) const {
    constexpr double near = 1e-9;
    const auto holds = [&](const DrawnCurve& curve) {
      return std::any_of(curve.parameters.begin(), curve.parameters.end(),
                         [&](const Parameters& p) { return distance(p, at) < near; });
    };
    for (const auto* list : {&result_.outlines, &result_.curves, &result_.loops, &result_.points})
      if (std::any_of(list->begin(), list->end(), holds)) return true;
    return false;
  }

  void add_point(const Parameters& at) {
    const auto value = jets_[0].at(at[0], at[1]);
    constexpr double accuracy = 1e-14;
    const double speed = (value.first[0].abs() + value.first[1].abs()).head<3>().matrix().norm();
    result_.points.push_back(
        {{at}, {{value.point[0], value.point[1], value.point[2]}}, 1.74 * value.error + 2 * accuracy * speed});
  }

  const bridge::ControlNet& first_;
  const bridge::ControlNet& second_;
  std::array<bridge::PatchJets, 2> jets_;
  double tolerance_;
  std::vector<DrawnCurve> outline_;
  /// Arcs of both borders, with the patches on different sides.
  std::vector<DrawnCurve> touching_;
  PatchOverlap result_;
};

}  // namespace

std::optional<PatchOverlap> parts_of_common_surface(const PatchNets& first, const PatchNets& second, double tolerance,
                                                    const Context& context) {
  const symbolic::SurfacePiece a = patch_of(first.exact);
  const symbolic::SurfacePiece b = patch_of(second.exact);
  auto equation = common_plane(first.exact, second.exact);
  if (!equation) equation = common_equation(a.map, b.map, context);
  if (!equation || has_tip(first.exact) || has_tip(second.exact) || !is_smooth_on(*equation, a.map) ||
      !is_embedded(a, context) || !is_embedded(b, context))
    return std::nullopt;
  const auto borders = border_arcs(first, second, context);
  if (!borders) return std::nullopt;
  return Outlines(first.rounded, second.rounded, tolerance).of(*borders);
}

}  // namespace eliminant::intersect
