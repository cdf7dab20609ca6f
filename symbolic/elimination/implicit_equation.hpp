// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::symbolic {

/// Equations with more coefficients are refused: plane curves of degree above 103, surfaces of degree above 30.
constexpr unsigned long most_equation_coefficients = 5460;

/// The implicit equation of a plane curve: the form F(x, y, w), irreducible over Q, primitive with positive leading
/// coefficient, that vanishes on it. Both are proven, so that the answer is exact whatever the seed.
/// Method: the determinant of the square moving-line matrix ([LuuBuseMourrain2009], Proposition 1), by evaluation,
/// interpolation and rational reconstruction; where the map is not one to one it is a power of F.
/// Throws InvalidInput for a space curve or a point, and LimitReached.
Polynomial implicit_equation(const RationalCurve& curve, std::uint64_t seed, const Context& context);

/// The implicit equation F(x, y, z, w) of a surface, irreducible, primitive and proven as above. `m` is a
/// representation of the surface, `degree` what implicit_degree says of both. Method: on a line through each point of
/// interpolation in one direction the gcd of two combinations of maximal minors, which are characteristic polynomials;
/// the interpolated form may hold powers of F and planes of base points, which are factored out. Throws InvalidInput
/// when `m` represents nothing (the rank does not drop), and LimitReached.
Polynomial implicit_equation(const RationalSurface& surface, const MatrixRepresentation& m,
                             const ImplicitDegree& degree, std::uint64_t seed, const Context& context);

}  // namespace eliminant::symbolic
