// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/elimination/curve_meetings.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// What is seen above one point of a component, and how it compares with another point of it.
struct Observation {
  /// As of the first curve, but with the numbers of the curve that has more different parameters at common points, and
  /// with infinite parameters of either.
  CurveMeetings meetings;
  /// Of a component in one variable: the common points are the same points of space above another point of the line.
  bool one_image = false;
  /// Of such a component: the eliminated parameter of the first surface at some common point is the same above another
  /// point of the line.
  bool one_parameter = false;
};

/// Looks at the common points of the curves Phi(u, .) and Psi(., t) above points (u, t) modulo random primes of 62
/// bits; all that is seen is true of the complex surfaces but for rare choices of the seed.
class ComponentObserver {
 public:
  /// `self`: both are one surface, and the pair of equal points does not count. The surfaces are referred to.
  ComponentObserver(const RationalSurface& first, const RationalSurface& second, bool self, std::uint64_t seed)
      : first_(first), second_(second), self_(self), seed_(seed) {}

  /// Above a general point of the plane.
  CurveMeetings anywhere(std::uint64_t round) const;

  /// Above a general point of the curve f = 0; nullopt when no rational point of it was found.
  std::optional<Observation> on(const Polynomial& f, std::uint64_t round) const;

 private:
  struct PlanePoint {
    mp_limb_t u = 0;
    mp_limb_t t = 0;
  };
  CurveMeetings above(const PlanePoint& point, const PrimeField& field, std::uint64_t round) const;

  const RationalSurface& first_;
  const RationalSurface& second_;
  bool self_;
  std::uint64_t seed_;
};

}  // namespace eliminant::symbolic
