// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/border_arcs.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curve_curve.hpp>
#include <eliminant/intersect/curve_surface.hpp>
#include <eliminant/intersect/net_patches.hpp>

namespace eliminant::intersect {

namespace {

using Range = std::array<double, 2>;

double middle(const Coordinate& x) { return arf_get_d(arb_midref(x.ball.real()), ARF_RND_NEAR); }

std::optional<Range> range_of(const std::optional<ParameterInterval>& interval) {
  if (!interval || !(*interval)[0] || !(*interval)[1]) return std::nullopt;
  return Range{middle(*(*interval)[0]), middle(*(*interval)[1])};
}

bool is_certified(const CurveResult& result) {
  return result.rest_status.value_or(result.status) == Status::certified &&
         (result.status == Status::certified || result.status == Status::infinite) &&
         std::all_of(result.overlap.begin(), result.overlap.end(), [](const Overlap& part) { return part.certified; });
}

/// One of the eight border curves.
struct Border {
  std::size_t axis = 0;
  int side = -1;
  /// Where it lies in the other patch, and where on its border.
  std::vector<Range> inside;
  std::vector<Range> on_border;
  /// Where it meets border curves of the other patch, and its own ends.
  std::vector<double> cuts{0, 1};
};

class ArcSearch {
 public:
  ArcSearch(const bridge::ExactNet& first, const bridge::ExactNet& second, const Context& context)
      : nets_{&first, &second}, context_(context) {
    for (std::size_t axis = 0; axis < 4; ++axis)
      for (const int side : {-1, 1}) borders_.push_back({axis, side, {}, {}, {0, 1}});
  }

  std::optional<BorderArcs> run() && {
    for (Border& border : borders_)
      if (!look_inside(border)) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 4; j < 8; ++j)
        if (!meet(borders_[i], borders_[j])) return std::nullopt;
    for (Border& border : borders_)
      if (!cut(border)) return std::nullopt;
    return std::move(result_);
  }

 private:
  symbolic::CurvePiece curve(const Border& border) const {
    return border_of(*nets_[border.axis / 2], border.axis % 2, border.side);
  }

  bool look_inside(Border& border) {
    const symbolic::ParametricSurface other{{patch_of(*nets_[1 - border.axis / 2])}};
    const CurveResult found =
        intersect_curve_surface({symbolic::ParametricCurve{{curve(border)}}, other}, Options(), context_);
    if (!is_certified(found)) return false;
    for (const Overlap& part : found.overlap) {
      const auto range = range_of(part.t);
      if (!range) return false;
      border.inside.push_back(*range);
    }
    return true;
  }

  bool meet(Border& a, Border& b) {
    const CurveResult found = intersect_curve_curve(
        {symbolic::ParametricCurve{{curve(a)}}, symbolic::ParametricCurve{{curve(b)}}}, Options(), context_);
    if (!is_certified(found)) return false;
    const auto add = [&](double t, double u) {
      a.cuts.push_back(t);
      b.cuts.push_back(u);
      std::array<double, 4> at{};
      for (const auto& [border, place] : {std::pair(&a, t), std::pair(&b, u)}) {
        at[border->axis] = border->side < 0 ? 0 : 1;
        at[border->axis < 2 ? 1 - border->axis : 5 - border->axis] = place;
      }
      result_.meetings.push_back(at);
    };
    for (const CurveSolution& solution : found.solutions) {
      if (solution.reality == Reality::non_real) continue;
      if (!solution.certified || !solution.t || !*solution.t || !solution.u || !*solution.u) return false;
      if (solution.inside) add(middle(**solution.t), middle(**solution.u));
    }
    for (const Overlap& part : found.overlap) {
      const auto t = range_of(part.t);
      const auto u = range_of(part.u);
      if (!t || !u) return false;
      a.on_border.push_back(*t);
      b.on_border.push_back(*u);
      add((*t)[0], (*u)[part.reversed ? 1 : 0]);
      add((*t)[1], (*u)[part.reversed ? 0 : 1]);
    }
    return true;
  }

  /// False where places are neither equal nor apart.
  bool cut(Border& border) {
    constexpr double same = 1e-12;
    constexpr double apart = 1e-7;
    std::vector<double>& cuts = border.cuts;
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double length = cuts[i + 1] - cuts[i];
      if (length <= same) continue;
      if (length < apart) return false;
      const double place = 0.5 * (cuts[i] + cuts[i + 1]);
      const auto holds = [&](const Range& range) {
        return place > std::min(range[0], range[1]) && place < std::max(range[0], range[1]);
      };
      BorderArc arc{{border.axis, border.side, cuts[i], cuts[i + 1]}, false};
      arc.on_both = std::any_of(border.on_border.begin(), border.on_border.end(), holds);
      const bool inside = std::any_of(border.inside.begin(), border.inside.end(), holds);
      if (arc.on_both ? border.axis < 2 : inside) result_.arcs.push_back(arc);
    }
    return true;
  }

  std::array<const bridge::ExactNet*, 2> nets_;
  const Context& context_;
  std::vector<Border> borders_;
  BorderArcs result_;
};

}  // namespace

std::optional<BorderArcs> border_arcs(const bridge::ExactNet& first, const bridge::ExactNet& second,
                                      const Context& context) {
  try {
    return ArcSearch(first, second, context).run();
  } catch (const InvalidInput&) {
    // A border that is one point.
    return std::nullopt;
  }
}

}  // namespace eliminant::intersect
