// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::symbolic {

/// A form in (1 : t), that is with its order at t = infinity.
struct ParameterForm {
  UnivariatePolynomial finite;  ///< zero for the zero form
  long order_at_infinity = 0;

  long degree() const { return finite.degree() + order_at_infinity; }
};

/// The greatest common divisor of two combinations of the maximal minors of M(Psi(t)), primitive over Z; the minor
/// itself when M is square. The gcd of all maximal minors divides it, and almost every choice of the combinations,
/// which `seed` fixes, makes it that. Zero when the rank of M(Psi(t)) is below the number of rows for all t.
/// By evaluation, interpolation and Chinese remaindering up to Hadamard's bound.
ParameterForm minors_on_curve(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed,
                              const Context& context);

/// The same modulo a prime, of degree in t.
long minors_degree_modulo(const MatrixRepresentation& m, const RationalCurve& curve, std::uint64_t seed);

/// The degree of the surface times the degree of its map, that is the number of parameters of the points on a line, and
/// what is known of it.
struct ImplicitDegree {
  long product = 0;     ///< degree of the surface times degree of the map
  long map_degree = 1;  ///< how many parameters the points of the surface have
  /// Degree of the gcd of the maximal minors on a line; where it exceeds `product` the matrix represents the surface
  /// times planes that belong to base points.
  long minors = 0;
  /// Lower and upper bounds met: product is proven.
  bool proven = false;
};

/// From below by two eliminants of three general curves of the linear system, whose common part is the base points;
/// from above by the minors on a general line, which the surface to the power of the map's degree divides. The degree
/// of the map is the dimension of the kernel at a general point. Throws InvalidInput when there are fewer columns than
/// rows.
ImplicitDegree implicit_degree(const RationalSurface& surface, const MatrixRepresentation& m, std::uint64_t seed);

/// S^k(Psi(t)), S the implicit equation and k the degree of the map, where the gcd of the minors holds more (embedded
/// points): each irreducible factor of `minors` as often as it divides S^k(Psi(t)) modulo a prime, which the lines
/// through the points Psi(t) in one general direction tell. nullopt when the matrix also represents planes, or no prime
/// was found to decide.
std::optional<ParameterForm> surface_on_curve(const MatrixRepresentation& m, const ImplicitDegree& degree,
                                              const RationalCurve& curve, const ParameterForm& minors,
                                              std::uint64_t seed, const Context& context);

}  // namespace eliminant::symbolic
