// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/overlaps/border_arcs.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/branches/point_exclusion.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/intersect/curves/curve_curve.hpp>
#include <eliminant/intersect/overlaps/patch_inversion.hpp>
#include <eliminant/intersect/patches/net_patches.hpp>

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
  /// Where it lies on the border of the other patch.
  std::vector<Range> on_border;
  /// Where it meets border curves of the other patch, and its own ends.
  std::vector<double> cuts{0, 1};
};

class ArcSearch {
 public:
  ArcSearch(const PatchNets& first, const PatchNets& second, const Context& context)
      : nets_{&first.exact, &second.exact},
        rounded_{&first.rounded, &second.rounded},
        jets_{bridge::PatchJets(first.rounded), bridge::PatchJets(second.rounded)},
        context_(context) {
    for (const Eigen::Array4d& point : first.rounded.points)
      size_ = std::max(size_, (point / point[3]).head<3>().abs().maxCoeff());
    for (std::size_t axis = 0; axis < 4; ++axis)
      for (const int side : {-1, 1}) borders_.push_back({axis, side, {}, {0, 1}});
  }

  std::optional<BorderArcs> run() && {
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

  /// Whether a point of a border curve, which is on no border of the other patch, lies in that: either Newton's method
  /// leads to parameters well within, or no parameters have the point.
  std::optional<bool> is_inside(const Border& border, double place) {
    const std::size_t own = border.axis / 2;
    std::array<double, 2> at{};
    at[border.axis % 2] = border.side < 0 ? 0 : 1;
    at[1 - border.axis % 2] = place;
    const bridge::PatchJets::Value value = jets_[own].at(at[0], at[1]);
    const std::array<double, 2> image = nearest_parameters(jets_[1 - own], value.point);
    const Eigen::Array4d gap = jets_[1 - own].at(image[0], image[1]).point - value.point;
    constexpr double accuracy = 1e-12;
    constexpr double margin = 1e-9;
    if (gap.head<3>().abs().maxCoeff() < accuracy * size_ && std::min(image[0], image[1]) > margin &&
        std::max(image[0], image[1]) < 1 - margin)
      return true;
    bridge::PointBox box;
    for (std::size_t k = 0; k < 3; ++k)
      box[k] = bridge::DoubleInterval::around(value.point[static_cast<long>(k)], value.error);
    box[3] = 1;
    if (bridge::excludes_point(*rounded_[1 - own], box, context_)) return false;
    return std::nullopt;
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
      if (!arc.on_both) {
        const auto inside = is_inside(border, place);
        if (!inside) return false;
        if (!*inside) continue;
      } else if (border.axis >= 2) {
        continue;
      }
      result_.arcs.push_back(arc);
    }
    return true;
  }

  std::array<const bridge::ExactNet*, 2> nets_;
  std::array<const bridge::ControlNet*, 2> rounded_;
  std::array<bridge::PatchJets, 2> jets_;
  double size_ = 0;
  const Context& context_;
  std::vector<Border> borders_;
  BorderArcs result_;
};

}  // namespace

std::optional<BorderArcs> border_arcs(const PatchNets& first, const PatchNets& second, const Context& context) {
  try {
    return ArcSearch(first, second, context).run();
  } catch (const InvalidInput&) {
    // A border that is one point.
    return std::nullopt;
  }
}

}  // namespace eliminant::intersect
