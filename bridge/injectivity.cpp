// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/injectivity.hpp>

#include <algorithm>
#include <optional>

#include <eliminant/bridge/double_interval.hpp>
#include <eliminant/bridge/patch_jets.hpp>
#include <eliminant/bridge/taylor_tables.hpp>

namespace eliminant::bridge {

bool is_injective_on(const ControlNet& net, const ParameterRectangle& rectangle) {
  const PatchJets::Value middle = PatchJets(net).at(0.5 * (rectangle.lower[0] + rectangle.upper[0]),
                                                    0.5 * (rectangle.lower[1] + rectangle.upper[1]));
  const std::optional<ContactFrame> frame = tangent_frame(middle);
  if (!frame) return false;
  const TaylorTable<DoubleInterval> table = taylor_on_box(
      net, *frame, {{rectangle.lower[0], rectangle.lower[1], 0}, {rectangle.upper[0], rectangle.upper[1], 0}}, 0, 1);
  constexpr std::size_t weight = 3;
  const DoubleInterval& w = table.at(0, 0)[weight];
  for (std::size_t row = 0; row < 2; ++row) {
    const DoubleInterval value = table.at(0, 0)[row] / w;
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::array<DoubleInterval, 4>& slope = k == 0 ? table.at(1, 0) : table.at(0, 1);
      const DoubleInterval derivative = (slope[row] - value * slope[weight]) / w;
      sum += (derivative - DoubleInterval(k == row ? 1 : 0)).magnitude();
    }
    if (!(sum < 1)) return false;
  }
  return true;
}

}  // namespace eliminant::bridge
