// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/arithmetic/polynomial.hpp>

namespace eliminant::symbolic {

/// p = component * first, q = component * second (up to rational constants), first and second coprime.
struct CommonComponent {
  Polynomial
      component;     ///< primitive over Z, positive leading coefficient; 1 when p and q are coprime, 0 when both vanish
  Polynomial first;  ///< primitive over Z; 0 when p is
  Polynomial second;  ///< primitive over Z; 0 when q is
};

/// Splits off the greatest common divisor of p and q exactly. Throws InvalidInput when their variables differ.
CommonComponent split_common_component(const Polynomial& p, const Polynomial& q);

}  // namespace eliminant::symbolic
