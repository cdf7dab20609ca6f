// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/intersect/sections/space_form.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::intersect {

/// The intersection of two surfaces f = 0 and g = 0 in (x, y, z) around one of its points. In rectangular coordinates
/// from that point none of whose axes is special: those of `to_frame`.
class GermInSpace {
 public:
  /// `error` bounds that of each coordinate of the point; near simple fractions that lie on both surfaces are taken for
  /// it.
  GermInSpace(const symbolic::Polynomial& f, const symbolic::Polynomial& g, const std::array<double, 3>& point,
              double error);

  std::array<double, 3> to_frame(const std::array<double, 3>& point) const;

  /// The coordinate of the frame over which the intersection in the cube of that half width is part of the graph of
  /// one smooth arc: where the gradients of f and g are independent, or else by both projections to planes with that
  /// axis. nullopt where none is proven.
  std::optional<std::size_t> graph_coordinate(double half_width);

  /// Whether the point is proven to be a singular one (symbolic/elimination/space_curve_germ).
  bool is_singular();

 private:
  void project();

  std::array<double, 3> origin_;
  std::array<symbolic::Polynomial, 2> equations_;
  std::array<std::vector<SpaceForm>, 2> gradients_;
  bool projected_ = false;
  std::array<std::optional<symbolic::Polynomial>, 3> projections_;
  std::array<std::vector<SpaceForm>, 3> projected_gradients_;
};

}  // namespace eliminant::intersect
