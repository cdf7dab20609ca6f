// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::test {

/// True when the vectors are multiples of one another by a factor that is not zero, or both zero.
inline bool same_point(const std::vector<symbolic::Rational>& a, const std::vector<symbolic::Rational>& b) {
  const auto is_zero = [](const auto& point) {
    return std::all_of(point.begin(), point.end(), [](const auto& c) { return c.is_zero(); });
  };
  if (a.size() != b.size() || is_zero(a) != is_zero(b)) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!(a[i] * b[j] == a[j] * b[i])) return false;
  return true;
}

}  // namespace eliminant::test
