// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/contacts/corank_one_contact.hpp>
#include <eliminant/bridge/contacts/height_series.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

namespace eliminant::bridge {

/// All common points of two patches in a box around a contact of corank one, proven: beside the contact half-branches
/// in which z = y - r(x) is a function of x that vanishes like |x|^(m/2), two of them, with z > 0 and z < 0, on each
/// side of it on which there are any.
struct CorankOneBranches {
  CorankOneContact contact;
  /// Of the contact, rounded.
  std::array<double, 4> at{};
  /// r, rounded.
  std::vector<double> ridge;
  /// Whether there are branches where x > 0, and where x < 0.
  std::array<bool, 2> sides{};
  /// |x| is at most that.
  double reach = 0;
  /// Of h_zz, and h_z = slope |x|^(n + 1) at z = 0, n the degree of r.
  double least_bend = 0;
  double most_slope = 0;
  /// |z|, |z'| and |z''| on a branch, divided by |x|^(m/2), |x|^(m/2 - 1) and |x|^(m/2 - 2).
  double least_ratio = 0;
  double most_ratio = 0;
  double most_steepness = 0;
  double most_turning = 0;
  /// Of r.
  double ridge_slope = 0;
  double ridge_bend = 0;
  /// Of a point of the first patch by y, and of its second derivative by x along chords of branches.
  double speed = 0;
  double curvature = 0;
  /// What is known of h is so for y in that range.
  std::array<double, 2> range_of_y{};
  /// How far s and t are from the contact, and bounds of how they change with the coordinates along the plane.
  std::array<double, 2> second_reach{};
  std::array<std::array<double, 2>, 2> second_by_plane{};

  std::size_t half_branches() const { return (sides[0] ? 2U : 0U) + (sides[1] ? 2U : 0U); }
  /// x and z of a point (u, v) relative to the contact.
  std::array<double, 2> coordinates_of(double u, double v) const;
  /// On which half-branch a point of the intersection is, whose parameters are known up to the radius: 0 to 3 are those
  /// with x > 0, z > 0; x > 0, z < 0; x < 0, z > 0; x < 0, z < 0. nullopt where it is too near to call.
  std::optional<std::size_t> half_branch(double u, double v, double radius) const;
  /// Bounds the distance in space of a half-branch from its chord between two values of |x|, and to the contact.
  double chord_error(double x, double other) const;
  double last_chord_error(double x) const;
};

/// Two patches around a contact of corank one, by their exact power series there: sizes of any order are relative to
/// the distance from the contact, not to the coordinates of the patches.
class CorankOnePatches {
 public:
  /// `parameters` are those of the contact, inside of both domains; nullopt where the first patch is not immersed
  /// there.
  static std::optional<CorankOnePatches> around(const ControlNet& first, const ControlNet& second,
                                                const ExactNet& exact_first, const ExactNet& exact_second,
                                                const std::array<symbolic::Rational, 4>& parameters,
                                                CorankOneContact contact);

  /// nullopt where the box is too large to prove anything. `first` is the net given.
  ///
  /// With (s, t) as the function of (u, v) that keeps the coordinates along the tangent plane equal, h_zz has one sign
  /// in the box, so that h is convex for every x; its value at z = 0 is x^m times an enclosed number, and its slope
  /// there O(x^(n+1)), n being the degree of r, with 2 n + 2 > m: where the signs of value and second derivative are
  /// equal there are no zeros, where they are opposite at most one on either side.
  std::optional<CorankOneBranches> in_box(const ControlNet& first, const CellBox& box) const;

  /// A point of a half-branch, relative to the contact.
  struct Point {
    double x = 0;
    double z = 0;
    std::array<double, 2> second{};
    /// Of z.
    double error = 0;
  };
  /// The one with the given x, from a guess that is on the same half-branch.
  std::optional<Point> point(const CorankOneBranches& branches, const Point& guess) const;

  /// u, v, s, t.
  std::array<double, 4> parameters(const CorankOneBranches& branches, const Point& point) const;

  const CorankOneContact& contact() const { return contact_; }

 private:
  using Table = TaylorTable<DoubleInterval>;
  using Pair = std::array<DoubleInterval, 2>;
  static constexpr std::size_t spare_terms = 2;
  using Heights = PlaneSeries<DoubleInterval, CorankOneContact::highest_order + spare_terms>;

  CorankOnePatches(Table first, Table second) : first_(std::move(first)), second_(std::move(second)) {}

  Heights heights(const DoubleInterval& x, const DoubleInterval& z, const Pair& second, std::size_t order) const;
  DoubleInterval ridge_at(const DoubleInterval& x, std::size_t derivative) const;
  std::optional<std::array<double, 2>> second_reach(const Pair& of_first, std::array<double, 2> least) const;
  /// The Taylor coefficient of x^i z^j at all points (x, 0).
  DoubleInterval coefficient_along(const Heights& here, const Heights& around, const DoubleInterval& x, std::size_t i,
                                   std::size_t j) const;

  CorankOneContact contact_;
  std::array<double, 4> at_{};
  std::vector<DoubleInterval> ridge_;
  bool polynomial_ = false;
  /// In a frame with the contact at the origin, of all orders; (x, y) are the parameters of the first.
  Table first_;
  Table second_;
  /// The parameters of the second by the coordinates along the plane, to first order.
  std::array<std::array<double, 2>, 2> inverse_{};
};

}  // namespace eliminant::bridge
