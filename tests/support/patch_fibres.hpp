// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/symbolic/arithmetic/rational.hpp>
#include <eliminant/symbolic/matrices/separated_bezoutian.hpp>
#include <support/patch_case.hpp>

namespace eliminant::test {

/// The intersection of two patches above single values of the first parameter u, by elimination: the real roots in
/// [0, 1] of the determinant in t of the Bezoutian matrix at u, and the other two parameters from its kernel.
class PatchFibres {
 public:
  explicit PatchFibres(const PatchCase& patches);

  struct Fibre {
    /// (u, v, s, t), all inside the domains.
    std::vector<std::array<double, 4>> points;
    /// Roots whose lift is not known: multiple ones, and those on a border within rounding.
    std::size_t unclear = 0;
  };

  /// nullopt where the determinant vanishes for all t, or where the matrix has no second power of v or s.
  std::optional<Fibre> at(const symbolic::Rational& u) const;

 private:
  std::array<double, 3> residual(const std::array<double, 4>& parameters) const;

  ControlNet first_;
  ControlNet second_;
  symbolic::SeparatedBezoutian matrix_;
};

/// Whether polylines in (u, v, s, t) cross u = constant as the fibre says: each point between the ends of a segment of
/// its own, up to `reach`; pairs of points closer to each other than that may be missing.
bool agrees_with_fibre(const std::vector<std::vector<std::array<double, 4>>>& polylines, double u,
                       const PatchFibres::Fibre& fibre, double reach);

}  // namespace eliminant::test
