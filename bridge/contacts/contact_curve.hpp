// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/contacts/height_series.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/enclosures/interval_polynomial.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/elimination/contact_identity.hpp>

namespace eliminant::bridge {

/// A point in which one smooth branch of the intersection crosses a curve of contact, all of the intersection in a box.
struct CurveCrossing {
  /// u, v, s, t.
  std::array<double, 4> parameters{};
  /// Each parameter is wrong by at most that.
  double radius = 0;
  /// Whether the point is in the box; else the branch passes the box without it.
  bool inside = true;
  /// The parameters relative to the point, multiplied by these and added, grow strictly along the branch.
  std::array<double, 4> growing{};

  // The branch in the parameters of the base: a function x of y at origin + x across + y along, |y| <= length.
  std::array<double, 2> origin{};
  std::array<double, 2> across{};
  std::array<double, 2> along{};
  double reach = 0;
  double length = 0;
  /// Bounds its first and second derivative.
  double branch_slope = 0;
  double branch_bend = 0;
  /// A lower bound of the third derivative of h across the curve, in absolute value.
  double least_third = 0;
  /// In space, of the base: bounds of first derivatives by the parameters, added, and of the second along vectors whose
  /// coordinates are at most one.
  std::array<double, 3> speed{};
  std::array<double, 3> bending{};

  /// x and y of parameters of the base.
  std::array<double, 2> coordinates_of(const std::array<double, 2>& at) const;
};

/// A curve along which two patches touch, and what is proven of the intersection around it.
///
/// With (s, t) as the function of (u, v) that keeps the coordinates along a tangent plane equal, the rest h(u, v) of
/// the difference vanishes to second order on the curve. Where the curve meets every line of one direction in a
/// parallelogram and the second derivative of h in that direction has one sign, h has no other zero there (Rolle).
/// Where the curve is a border of both patches, and they lie on different sides of it in the projection along the
/// normal, nothing has to be known of h: patches that only have a border in common are kept apart that way, too.
/// Where the third one has one sign, each line has one zero more, which moves along one smooth branch; it crosses the
/// curve once where the second derivative changes its sign along the curve, monotonically.
class ContactCurve {
 public:
  /// The curve is in the parameters of `base`, which is the second patch where `swapped`. The relation must have been
  /// proven (symbolic::touch_along). The nets must outlive the object.
  ContactCurve(const ControlNet& base, const ControlNet& other, const ExactNet& exact_base, const ExactNet& exact_other,
               symbolic::ContactRelation relation, bool swapped);

  const symbolic::ContactRelation& relation() const { return relation_; }
  bool swapped() const { return swapped_; }
  /// For u, v, s, t: -1 where the curve is the border on which the parameter is 0, 1 where it is 1, else 0.
  const std::array<int, 4>& sides_along() const { return sides_along_; }
  /// u, v, s, t at parameters of the base on the curve, approximately.
  std::array<double, 4> parameters_at(const std::array<double, 2>& base) const;

  /// From a point of the base's parameters to the curve, to first order; with a sign.
  double distance_from(const std::array<double, 2>& base) const;

  /// The point of the base.
  std::array<double, 3> point_at(const std::array<double, 2>& base) const;

  /// u, v, s, t of the point of the curve next to `near` where the parameter of an axis is that of `near`,
  /// approximately; nullopt where Newton's method finds none.
  std::optional<std::array<double, 4>> point_on_cut(std::size_t axis, const std::array<double, 4>& near) const;

  /// True where it is proven that every common point in the box is a point of the curve.
  bool explains(const CellBox& box);
  /// The same where the curve is a border of both patches, of which only has to be proven that points are equal on it
  /// (symbolic::meet_along).
  bool keeps_apart(const CellBox& box);
  /// True where an earlier proof says so already.
  bool is_explained(const CellBox& box) const;

  /// Whether the curve passes the box or not far from it, approximately.
  bool is_near(const CellBox& box) const;
  /// nullopt where it is not proven that all common points in the box are points of the curve and of one branch that
  /// crosses it.
  std::optional<CurveCrossing> crossing(const CellBox& box) const;

  /// Where the curve is on the line at a value y, approximately: its x.
  double across_at(const CurveCrossing& crossing, double y) const;

  /// Bounds the distance in space of the branch from a chord between two of its points at parameters of the base, which
  /// are wrong by at most `error` in x; infinite where nothing is known.
  static double chord_error(const CurveCrossing& crossing, const std::array<double, 2>& from,
                            const std::array<double, 2>& to, double error);
  /// The part of it that grows with the square of the step in y, for a step of one near these parameters.
  static double unit_chord_error(const CurveCrossing& crossing, const std::array<double, 2>& near);

  const ControlNet& base() const { return base_; }
  const ControlNet& other() const { return other_; }
  const ExactNet& exact_base() const { return exact_base_; }
  const ExactNet& exact_other() const { return exact_other_; }

 private:
  struct Region;
  struct Forms;
  struct Tables;
  /// A parallelogram of the base's parameters with a box of the other's that was explained.
  struct Explained {
    std::array<double, 2> origin{};
    std::array<double, 2> across{};
    std::array<double, 2> along{};
    double reach = 0;
    double length = 0;
    std::array<double, 2> lower{};
    std::array<double, 2> upper{};

    bool covers(const CellBox& box) const;
  };

  std::optional<Tables> tables_near(const std::array<double, 2>& at, std::size_t order) const;
  /// From the fourth derivatives in `heights`, and lower ones at the origin.
  Forms forms_on(const Region& region, const PlaneSeries<DoubleInterval>& heights) const;
  /// Encloses h and its derivatives at every point of a region, cut into so many tiles across and along.
  PlaneSeries<DoubleInterval, 5> heights_by_tiles(const Region& region, std::size_t tiles) const;
  /// From the fifth derivatives, and lower ones at the origin: for larger regions.
  Forms close_forms_on(const Region& region, std::size_t tiles) const;
  /// The second derivative of h along a region that hardly has a length.
  DoubleInterval bend_on_cut(const Region& region, const PlaneSeries<DoubleInterval>& heights) const;
  /// The second derivative of h across the curve where it meets the line through the origin of a region, from exact
  /// coefficients.
  DoubleInterval bend_at_origin(const Region& region) const;
  /// Of a derivative of h at a point, computed in doubles, in a direction of length about 1.
  double rounding_of_derivative(std::size_t order) const;

  /// Where it may be explained: around the curve, and lines across it.
  struct Surroundings {
    std::array<double, 2> origin{};
    std::array<double, 2> across{};
    std::array<double, 2> along{};
    bool is_cut = false;
  };
  /// nullopt where the box, its parameters those of the base first, is not near the curve.
  std::optional<Surroundings> surroundings(const CellBox& box) const;
  /// Keeps the region as explained, unless it is that of a cut; true.
  bool record(const Region& region, bool is_cut);
  /// Whether every point of the region whose parameters of the base are inside the domain, and not on the curve, has
  /// parameters of the other patch outside of its domain, both patches having the curve as a border.
  bool keeps_apart(const Region& region) const;
  CellBox in_base_order(const CellBox& box) const;
  std::array<double, 2> nearest(std::array<double, 2> at) const;
  std::array<double, 2> gradient(const std::array<double, 2>& at) const;
  std::optional<Region> region(const CellBox& box, const std::array<double, 2>& origin,
                               const std::array<double, 2>& across, const std::array<double, 2>& along,
                               std::size_t order) const;
  /// h at a point of the curve by the parameters of the base, approximately.
  std::optional<PlaneSeries<double>> heights_near(const std::array<double, 2>& at, std::size_t order) const;
  std::optional<std::array<double, 2>> crossing_near(const std::array<double, 2>& start, double reach) const;

  const ControlNet& base_;
  const ControlNet& other_;
  const ExactNet& exact_base_;
  const ExactNet& exact_other_;
  symbolic::ContactRelation relation_;
  bool swapped_;
  std::array<int, 4> sides_along_{};
  IntervalPolynomial curve_;
  std::array<IntervalPolynomial, 2> by_;
  std::array<IntervalPolynomial, 2> numerator_;
  std::array<IntervalPolynomial, 2> denominator_;
  std::vector<Explained> explained_;
};

}  // namespace eliminant::bridge
