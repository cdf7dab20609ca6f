// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <eliminant/symbolic/geometry/bezier.hpp>
#include <support/bezier_case.hpp>
#include <support/curves.hpp>
#include <support/patch_nets.hpp>

/// Bezier curves and patches as exact maps, and from these to doubles.
namespace eliminant::test {

using symbolic::ControlPoint;

using RationalPolygon = std::vector<ControlPoint>;
/// Homogeneous coordinates, the weight last: polynomials in t, or in the two parameters of a patch.
using Map = std::vector<Polynomial>;

/// Of a point, with its weight.
constexpr std::size_t coordinates = 4;
inline const symbolic::Interval unit{0, 1};

Rational fraction(long numerator, long denominator);

Polynomial t_power(unsigned long exponent);

/// first + second t + ...
Polynomial in_t(const std::vector<Rational>& ascending);

std::vector<Rational> ascending_coefficients(const Polynomial& p, std::size_t degree);

Rational value(const Polynomial& p, const std::vector<Rational>& point);

ControlPoint values(const Map& map, const std::vector<Rational>& point);

Map composed(const Map& map, const std::vector<Polynomial>& parameters);

Map curve_map(const RationalPolygon& points);

RationalPolygon control_polygon(const Map& map, std::size_t degree);

Map homogeneous_map(const RationalNet& net);

/// A case of these two objects. Odd denominators are multiplied away: together from the coordinates where all weights
/// are 1, else from the homogeneous coordinates of each.
BezierCase binary_case(std::string family, const RationalPolygon& curve, RationalNet other);

BezierCase plane_case(std::string family, const RationalPolygon& first, const RationalPolygon& second);

PlantedParameter planted_at(const Rational& parameter, unsigned long multiplicity);

}  // namespace eliminant::test
