// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <eliminant/intersect/whole_surfaces/surface_charts.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::intersect {

/// A polynomial in x, y, z, or a form in x, y, z, w at w = 1, in doubles with bounded rounding.
class SpaceForm {
 public:
  explicit SpaceForm(const symbolic::Polynomial& form);

  struct Value {
    DoubleInterval value;
    /// The sum of the sizes of its terms.
    double size = 0;
  };
  Value at(const std::array<DoubleInterval, 3>& point) const;

 private:
  struct Term {
    DoubleInterval coefficient;
    std::array<unsigned long, 3> exponents{};
  };
  std::vector<Term> terms_;
};

}  // namespace eliminant::intersect
