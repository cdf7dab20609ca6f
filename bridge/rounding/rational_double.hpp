// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

/// A double within one unit in the last place of a rational number; infinite beyond the range of doubles.
double nearest(const symbolic::Rational& value);

/// A finite double as the rational number it is.
symbolic::Rational exactly(double value);

}  // namespace eliminant::bridge
