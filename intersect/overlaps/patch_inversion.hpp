// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include <eliminant/bridge/nets/patch_jets.hpp>

namespace eliminant::intersect {

/// The parameters in [0, 1]^2 of the point of a patch nearest to a point, by the method of Gauss and Newton from `at`.
/// Approximate; a local minimum.
std::array<double, 2> parameters_near(bridge::PatchJets& patch, const Eigen::Array4d& point, std::array<double, 2> at);

/// The same from the best of a grid of parameters.
std::array<double, 2> nearest_parameters(bridge::PatchJets& patch, const Eigen::Array4d& point);

}  // namespace eliminant::intersect
