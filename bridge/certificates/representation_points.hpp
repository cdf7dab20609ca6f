// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/bridge/enclosures/ball_curve.hpp>
#include <eliminant/symbolic/elimination/univariate_representation.hpp>

namespace eliminant::bridge {

/// The point of the class of multiplicity k above the root t: y = -numerator(t) / (k denominator(t)), x = t - s y.
/// nullopt when the enclosure of the denominator contains 0: t has to be enclosed more tightly.
std::optional<PlaneBall> point_above(const symbolic::UnivariateRepresentation& representation,
                                     unsigned long multiplicity, const ComplexBall& t, long precision_bits);

}  // namespace eliminant::bridge
