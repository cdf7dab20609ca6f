// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

/// The simplest fraction that is equal to the number as far as its accuracy goes, by continued fractions; nullopt when
/// there is no simple one: denominators up to `largest_denominator`, powers of two up to 2^20.
std::optional<symbolic::Rational> simple_fraction(double value, double accuracy, double largest_denominator = 4096);

}  // namespace eliminant::bridge
