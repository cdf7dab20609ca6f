// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/contacts/contact_curve.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// Finds the curves along which two tensor-product patches on [0, 1]^2 touch, and proves them.
///
/// Points of such a curve are followed in doubles (contact_curve_points), its equation in the parameters of one patch
/// and those of the other are recognised (contact_relation_fit), exact division proves them (symbolic::touch_along). A
/// curve that is not of low degree with simple rational coefficients is not found.
///
/// Along a border that both patches have, points are equal without contact. Where their tangent planes come near each
/// other there, such a border explains boxes as a curve of contact does, if the patches are on different sides of it.
class ContactCurves {
 public:
  /// All must outlive the object.
  ContactCurves(const ControlNet& first, const ControlNet& second, const ExactNet& exact_first,
                const ExactNet& exact_second)
      : first_(first), second_(second), exact_first_(exact_first), exact_second_(exact_second) {}

  /// Those that were found.
  const std::deque<ContactCurve>& curves() const { return curves_; }

  /// Whether any box may be explained.
  bool can_explain() const { return !curves_.empty() || !borders_.empty(); }

  /// Looks for one within `reach` of these parameters (u, v, s, t). True when there is one that was not known.
  bool find(const std::array<double, 4>& near, double reach);

  /// Looks for one along a part of a border curve (axis 0 to 3, side -1 or 1) that lies in the other patch, and for one
  /// that both patches have. True when there is a curve of contact, known or not.
  bool find_along(std::size_t axis, int side, double lower, double upper);

  /// Whether there is one along that border.
  bool is_along(std::size_t axis, int side) const;

  /// True where it is proven that every common point in the box is one of a curve that was found, or of a border in
  /// common.
  bool explains(const CellBox& box);

  /// Whether these parameters are a point of one, exactly.
  bool holds(const std::array<symbolic::Rational, 4>& parameters) const;

  /// After too many failures around the curves that were found: more would come to nothing.
  bool is_exhausted() const;
  void count_failed_cut();

  /// On a cut, where the parameter of the axis is that of `near`: the largest of a few boxes around a point of a curve
  /// that is explained, at most of that half width in each parameter; nullopt where no curve passes that near.
  std::optional<CellBox> explained_around(std::size_t axis, const std::array<double, 4>& near,
                                          const std::array<double, 4>& half_width);

  /// As ContactCurve::crossing, and the index of the curve.
  struct Crossing : CurveCrossing {
    std::size_t curve = 0;
  };
  std::optional<Crossing> crossing(const CellBox& box);

 private:
  bool is_known(const std::array<double, 4>& point) const;
  bool recognise(const std::vector<std::array<double, 4>>& points, bool swapped);
  /// As a curve of contact, or as a border in common.
  bool recognise_border(const std::vector<std::array<double, 4>>& points, bool swapped, std::size_t axis, int side);
  std::optional<ContactCurve> curve_through(const std::vector<std::array<double, 4>>& points, bool swapped) const;
  bool add_if_touching(const ContactCurve& curve);
  std::optional<CellBox> explained_around(const ContactCurve& curve, std::size_t axis,
                                          const std::array<double, 4>& near, const std::array<double, 4>& half_width);
  const std::vector<symbolic::Polynomial>& coordinates(bool of_second);

  const ControlNet& first_;
  const ControlNet& second_;
  const ExactNet& exact_first_;
  const ExactNet& exact_second_;
  /// As polynomials, once they are needed.
  std::array<std::vector<symbolic::Polynomial>, 2> coordinates_;
  /// Pointers to its members stay valid.
  std::deque<ContactCurve> curves_;
  /// Borders of both patches along which they need not touch, and how often one may fail to explain a box.
  std::deque<ContactCurve> borders_;
  int border_attempts_ = 20000;
  /// Of each curve the size of the last box that was explained: much larger ones are not tried.
  std::vector<double> explained_size_;
  /// Attempts left, at points and at equations.
  int attempts_ = 60;
  int equations_ = 4;
  /// Boxes of which nothing was proven.
  unsigned long failures_ = 0;
};

}  // namespace eliminant::bridge
