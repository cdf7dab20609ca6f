// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

enum class SectionFactorKind {
  curve,       ///< its zeros are curves in space
  point,       ///< its zeros are mapped to points: it is constant on each of its components
  at_infinity  ///< the weight vanishes on it
};

/// An irreducible factor over Q of the function whose zeros are the parameters of an intersection.
struct SectionFactor {
  symbolic::Polynomial factor{2};
  unsigned long multiplicity = 1;
  SectionFactorKind kind = SectionFactorKind::curve;
};

/// F(Phi(u, v)), homogenised by the weight of Phi: zero exactly where Phi is on F = 0, at infinity or not defined.
symbolic::Polynomial section_polynomial(const symbolic::RationalSurface& map, const symbolic::Polynomial& equation);

/// The factors of a section polynomial, or of another one in the parameters, that is not zero. Throws LimitReached.
std::vector<SectionFactor> section_factors(const symbolic::RationalSurface& map, const symbolic::Polynomial& section,
                                           std::uint64_t seed);

}  // namespace eliminant::intersect
