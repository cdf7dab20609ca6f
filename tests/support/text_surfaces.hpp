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

}  // namespace eliminant::test
