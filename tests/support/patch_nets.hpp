// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>
#include <support/patch_case.hpp>

/// Patches as polynomials, as rational control nets, and as control nets of doubles that are the same numbers.
namespace eliminant::test {

/// Homogeneous coordinates, the weight last: polynomials in the two parameters of a patch.
using PatchMap = std::array<symbolic::Polynomial, 4>;
using RationalNet = std::vector<std::vector<symbolic::ControlPoint>>;
/// By rows, of homogeneous coordinates.
using Projectivity = std::array<std::array<symbolic::Rational, 4>, 4>;

/// (x, y, z, 1).
PatchMap affine_patch(const symbolic::Polynomial& x, const symbolic::Polynomial& y, const symbolic::Polynomial& z);

/// In the Bernstein basis of bidegree (m, n) of [0, 1]^2. Throws std::out_of_range where a degree is too high.
RationalNet control_net(const PatchMap& map, std::size_t m, std::size_t n);
/// The net back as polynomials; a net of doubles exactly.
PatchMap patch_map(const RationalNet& net);
PatchMap patch_map(const ControlNet& net);

/// Multiplies the affine coordinates of two nets of weights 1 by one number between 1/2 and 1 such that they are binary
/// fractions.
void make_binary(RationalNet& first, RationalNet& second);
/// The image under a projective map.
RationalNet transformed(RationalNet net, const Projectivity& matrix);
/// Throws std::logic_error where a number is no double.
ControlNet in_doubles(const RationalNet& net);
RationalNet rational_net(const ControlNet& net);

/// The patch as the engines take it.
symbolic::SurfacePiece surface_piece(const ControlNet& net);

/// With (v, u) for (u, v); with 1 - u for u; scaled by a power of two and then moved by the same number in all
/// directions, where that is exact.
ControlNet parameters_exchanged(const ControlNet& net);
ControlNet parameter_reversed(ControlNet net);
ControlNet scaled(ControlNet net, int exponent);
ControlNet moved(ControlNet net, double by);

/// The point of a patch in doubles, for measuring.
std::array<double, 3> patch_point(const ControlNet& net, double u, double v);

/// A problem file that says the same; the weights are not 0.
std::string problem_json(const PatchCase& patches);

}  // namespace eliminant::test
