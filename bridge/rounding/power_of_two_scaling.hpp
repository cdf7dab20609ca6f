// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::bridge {

/// The substitution x = 2^x_log2 X, y = 2^y_log2 Y.
struct PowerOfTwoScaling {
  long x_log2 = 0;
  long y_log2 = 0;
};

/// The scaling under which the coefficients of p and q are as equal in magnitude as a least squares fit of their
/// logarithms can make them (each polynomial may be multiplied by a constant). A heuristic for the conditioning of the
/// numeric stage; it is applied exactly and costs no digit. p and q are non-zero and have two variables.
PowerOfTwoScaling choose_scaling(const symbolic::Polynomial& p, const symbolic::Polynomial& q);

}  // namespace eliminant::bridge
