// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/numeric/moving_plane_blocks.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::bridge {

/// The coefficients in doubles, to a relative error of 2^-52, divided by one power of two that makes the largest about
/// 1; what is below 2^-1000 of it is 0.
numeric::CurveForms round_curve(const symbolic::RationalCurve& curve);

/// The same of a surface. Throws InvalidInput when a degree exceeds numeric::largest_numeric_degree.
numeric::SurfaceForms round_surface(const symbolic::RationalSurface& surface);

/// The same of a matrix representation of a surface of that kind, each column by a power of two of its own: the columns
/// are only a basis of the moving planes.
numeric::MovingPlaneBlocks round_representation(const symbolic::MatrixRepresentation& m,
                                                symbolic::RationalSurface::Kind kind);

}  // namespace eliminant::bridge
