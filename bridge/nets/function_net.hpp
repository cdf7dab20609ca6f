// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/domain.hpp>

namespace eliminant::bridge {

/// The Bernstein coefficients of a polynomial in two variables on a domain as a net on [0, 1]^2 for PatchJets, of
/// degree at least 1 in each parameter, scaled so that the largest becomes 1 in absolute value; the other coordinates
/// are 0. Throws InvalidInput for the zero polynomial.
ControlNet function_net(const symbolic::Polynomial& p, const std::array<symbolic::Interval, 2>& domain);

/// Whether the function has no zero with its parameters in [0, 1] within these bounds, which is proven when true.
bool excludes_zero(const ControlNet& function, const std::array<double, 2>& lower, const std::array<double, 2>& upper,
                   int halvings = 4);

}  // namespace eliminant::bridge
