// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/exact_plane.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace eliminant::bridge {

using symbolic::Rational;

std::optional<Plane> plane_through(std::vector<ExactPoint> rows) {
  std::vector<std::size_t> pivots;
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 4; ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const ExactPoint& row) { return !row[column].is_zero(); });
    if (pivot == rows.end()) continue;
    std::swap(*pivot, rows[rank]);
    const Rational leading = rows[rank][column];
    for (Rational& entry : rows[rank]) entry = entry / leading;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == rank || rows[i][column].is_zero()) continue;
      const Rational factor = rows[i][column];
      for (std::size_t k = 0; k < 4; ++k) rows[i][k] = rows[i][k] - factor * rows[rank][k];
    }
    pivots.push_back(column);
    ++rank;
  }
  if (rank != 3) return std::nullopt;
  std::size_t free = 0;
  while (std::find(pivots.begin(), pivots.end(), free) != pivots.end()) ++free;
  Plane plane;
  plane[free] = Rational(1);
  for (std::size_t i = 0; i < 3; ++i) plane[pivots[i]] = Rational(0) - rows[i][free];
  return plane;
}

}  // namespace eliminant::bridge
