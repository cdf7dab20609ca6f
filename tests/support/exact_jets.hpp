// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include <support/text_patches.hpp>

#include <eliminant/bridge/nets/taylor_tables.hpp>
#include <eliminant/bridge/rounding/rational_double.hpp>

/// Derivatives of patches in affine coordinates, exactly.
namespace eliminant::test {

using bridge::nearest;

/// Affine partial derivatives of order (i, j), i + j <= 3, by the division of series.
class ExactJet {
 public:
  ExactJet(const bridge::ExactNet& net, const Rational& a, const Rational& b) {
    const bridge::TaylorTable<Rational> table = bridge::taylor_at(net, {a, b}, order);
    for (std::size_t i = 0; i <= order; ++i)
      for (std::size_t j = 0; i + j <= order; ++j)
        for (std::size_t k = 0; k < 3; ++k) {
          Rational rest = table.at(i, j)[k];
          for (std::size_t p = 0; p <= i; ++p)
            for (std::size_t q = 0; q <= j; ++q)
              if (p + q < i + j) rest = rest - coefficient_[p][q][k] * table.at(i - p, j - q)[3];
          coefficient_[i][j][k] = rest / table.at(0, 0)[3];
        }
  }
  double derivative(std::size_t i, std::size_t j, std::size_t k) const {
    constexpr std::array<long, 4> factorial{1, 1, 2, 6};
    return nearest(coefficient_[i][j][k] * Rational(factorial[i] * factorial[j]));
  }

 private:
  static constexpr std::size_t order = 3;
  std::array<std::array<std::array<Rational, 3>, 4>, 4> coefficient_;
};

}  // namespace eliminant::test
