// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/enclosed_patch.hpp>

namespace eliminant::bridge {

EnclosedPatch::EnclosedPatch(const TaylorTable<DoubleInterval>& table) {
  constexpr std::size_t weight = 3;
  const DoubleInterval& w = table.at(0, 0)[weight];
  const std::array<const std::array<DoubleInterval, 4>*, 2> slope{&table.at(1, 0), &table.at(0, 1)};
  const std::array<const std::array<DoubleInterval, 4>*, 3> bend{&table.at(2, 0), &table.at(1, 1), &table.at(0, 2)};
  constexpr std::array<double, 3> factor{2, 1, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    value[k] = table.at(0, 0)[k] / w;
    for (std::size_t i = 0; i < 2; ++i) first[i][k] = ((*slope[i])[k] - value[k] * (*slope[i])[weight]) / w;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = i == 2 ? 1 : 0;
      const std::size_t b = i == 0 ? 0 : 1;
      second[i][k] = (DoubleInterval(factor[i]) * ((*bend[i])[k] - value[k] * (*bend[i])[weight]) -
                      first[a][k] * (*slope[b])[weight] - first[b][k] * (*slope[a])[weight]) /
                     w;
    }
  }
}

}  // namespace eliminant::bridge
