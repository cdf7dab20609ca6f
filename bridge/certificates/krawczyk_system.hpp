// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <eliminant/bridge/enclosures/ball.hpp>

namespace eliminant::bridge {

/// The values of n functions of n variables on a box, and their partial derivatives row by row.
struct SystemValue {
  std::vector<ComplexBall> values;
  std::vector<std::vector<ComplexBall>> jacobian;
};

/// Encloses the functions and derivatives on a box of balls at a precision.
using System = std::function<SystemValue(const std::vector<ComplexBall>&, long precision_bits)>;

/// A box around `start` (its midpoints count) that contains exactly one zero, a simple one: that many of Newton's
/// steps, then Krawczyk's test. nullopt when none is proven at this precision. Source: [Krawczyk1969].
std::optional<std::vector<ComplexBall>> enclose_system_zero(const System& system, const std::vector<ComplexBall>& start,
                                                            long precision_bits, int newton_steps = 8);

}  // namespace eliminant::bridge
