// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/bridge/nets/control_net.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::bridge {

/// The homogeneous coordinates of a patch as polynomials in its parameters, up to a common factor.
std::vector<symbolic::Polynomial> coordinates_of(const ExactNet& net);

}  // namespace eliminant::bridge
