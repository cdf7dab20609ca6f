// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace eliminant::bridge {

/// A box of parameters of both patches.
struct CellBox {
  std::array<double, 4> lower{};
  std::array<double, 4> upper{};
};

}  // namespace eliminant::bridge
