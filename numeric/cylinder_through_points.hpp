// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <cstddef>

#include <eliminant/numeric/cylinder_direction_forms.hpp>

namespace eliminant::numeric {

/// A circular cylinder.
struct Cylinder {
  std::array<double, 3> direction;   ///< of unit length, its largest component positive
  std::array<double, 3> axis_point;  ///< the foot of the perpendicular from the first point to the axis
  double radius;                     ///< in the unit of the points
};

/// At most six elements, without allocation.
template <class Element>
class AtMostSix {
 public:
  void push_back(const Element& element) { elements_[size_++] = element; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Element& operator[](std::size_t i) const { return elements_[i]; }
  Element& operator[](std::size_t i) { return elements_[i]; }
  const Element* begin() const { return elements_.data(); }
  const Element* end() const { return elements_.data() + size_; }

 private:
  std::array<Element, 6> elements_{};
  std::size_t size_ = 0;
};

using ComplexDirection = std::array<std::complex<double>, 3>;

/// Number of coordinate systems that cylinder_directions knows.
inline constexpr std::size_t direction_frames = 3;

/// The directions of the cylinders through a point and the four at these offsets from it, of each pair of conjugate
/// ones one, the real ones first and with imaginary parts 0; the largest coordinate is 1. `frame` < direction_frames
/// picks one of several rotated coordinate systems: what is near infinity or above another one in one is not so in the
/// next. Method: in y the cubic is reduced modulo the conic to A(x) y + B(x), whose norm is a sextic in x; its roots,
/// y = -B / A, and Newton's iteration. Guarantee: none. Empty for coplanar points, and where nothing finite results.
AtMostSix<ComplexDirection> cylinder_directions(const std::array<std::array<double, 3>, 4>& offsets,
                                                std::size_t frame = 0);

/// The vector c from a point to the foot of the perpendicular from it to the axis of direction t through the points at
/// these offsets: c = (N_i (d_j x t) + N_j (t x d_i)) / (2 (t.t) D(d_i, d_j, t)), for the pair (i, j) with the largest
/// denominator. Infinite or NaN where there is none.
SpaceVector<double> axis_offset(const std::array<SpaceVector<double>, 4>& offsets, const SpaceVector<double>& t);

/// The real circular cylinders through five points, in doubles, at most six. Guarantee: none; see
/// intersect/cylinders/cylinders.hpp for proven ones. Infinitely many, as for coplanar points and three on a line:
/// empty, or some of them. The points should not be so far from the origin that their differences lose digits.
AtMostSix<Cylinder> real_cylinders_through(const std::array<std::array<double, 3>, 5>& points);

}  // namespace eliminant::numeric
