// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <support/patch_nets.hpp>

namespace eliminant::test {

/// A patch in the power basis.
class PowerPatch {
 public:
  explicit PowerPatch(const ControlNet& net) {
    const PatchMap map = patch_map(net);
    for (std::size_t k = 0; k < 4; ++k) {
      grids_[k].assign(net.size(), std::vector<double>(net.front().size(), 0));
      for (const auto& term : map[k].terms())
        grids_[k][term.exponents[0]][term.exponents[1]] =
            fmpz_get_d(term.coefficient.numerator().get()) / fmpz_get_d(term.coefficient.denominator().get());
    }
  }

  /// Value and derivatives by u and v of each affine coordinate.
  using Jet = std::array<std::array<double, 3>, 3>;
  Jet at(double u, double v) const {
    std::array<std::array<double, 3>, 4> forms{};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = grids_[k].size(); i-- > 0;) {
        double value = 0;
        double slope = 0;
        for (std::size_t j = grids_[k][i].size(); j-- > 0;) {
          slope = slope * v + value;
          value = value * v + grids_[k][i][j];
        }
        forms[k][1] = forms[k][1] * u + forms[k][0];
        forms[k][0] = forms[k][0] * u + value;
        forms[k][2] = forms[k][2] * u + slope;
      }
    Jet jet{};
    const double w = forms[3][0];
    for (std::size_t k = 0; k < 3; ++k) {
      jet[k][0] = forms[k][0] / w;
      for (std::size_t i = 1; i < 3; ++i) jet[k][i] = (forms[k][i] - jet[k][0] * forms[3][i]) / w;
    }
    return jet;
  }

 private:
  std::array<std::vector<std::vector<double>>, 4> grids_;
};

}  // namespace eliminant::test
