// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// Common curves of Phi(u, v) and Psi(s, t) along which u and t both stand still: the curves Phi(u_0, .) and
/// Psi(., t_0) are one. The projection to (u, t) shows such a curve as the point (u_0, t_0), and a factor of the
/// eliminant it is not. Two patches with a common border are of this kind.
struct StationaryComponents {
  /// Irreducible over Z; each u_0 is a root of one of the first, each t_0 of one of the second. Both empty: there are
  /// no such curves, or the surfaces overlap.
  std::vector<UnivariatePolynomial> u;
  std::vector<UnivariatePolynomial> t;

  bool empty() const { return u.empty() && t.empty(); }
};

/// From the projections to (u, s) and to (v, t), where such a curve is a line: the factors in u alone, in t alone,
/// above which there are finite common points that move while the other kept parameter stands still. Where no such
/// factors exist, which is decided modulo primes, it costs two determinants in one variable for each. What lies above
/// them is seen at random points modulo primes. Throws InvalidInput for a surface of triangular kind or one that
/// depends on one parameter only.
StationaryComponents stationary_components(const RationalSurface& first, const RationalSurface& second,
                                           std::uint64_t seed, const Context& context);

}  // namespace eliminant::symbolic
