// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

/// Whole surfaces written down as polynomials.
namespace eliminant::test {

/// In x, y, z.
inline symbolic::Polynomial in_space(const std::string& text) {
  static const std::vector<std::string> names{"x", "y", "z"};
  return symbolic::parse_polynomial(text, names);
}

/// x, y, z and the weight in u and v.
inline symbolic::RationalSurface map_of(const std::vector<std::string>& texts) {
  static const std::vector<std::string> names{"u", "v"};
  std::vector<symbolic::Polynomial> coordinates;
  for (const std::string& text : texts) coordinates.push_back(symbolic::parse_polynomial(text, names));
  return {symbolic::RationalSurface::Kind::tensor_product, std::move(coordinates)};
}

using Texts = std::vector<std::string>;

/// The unit sphere from its pole (0, 0, 1), which is a base point at infinity.
inline const Texts sphere_from_pole{"2*u", "2*v", "u^2 + v^2 - 1", "u^2 + v^2 + 1"};
/// The unit sphere by angles: each point has two pairs of parameters.
inline const Texts sphere_by_angles{"2*v*(1 - u^2)", "4*u*v", "(1 - v^2)*(1 + u^2)", "(1 + u^2)*(1 + v^2)"};
/// x^2 + y^2 = z^2.
inline const Texts cone{"v*(1 - u^2)", "2*u*v", "v*(u^2 + 1)", "u^2 + 1"};

}  // namespace eliminant::test
