// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <support/bezier_nets.hpp>

#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

/// Tensor-product patches written down as polynomials in u and v.
namespace eliminant::test {

/// x, y, z and the weight.
struct PatchText {
  std::string x;
  std::string y;
  std::string z;
  std::string w = "1";
};

inline std::vector<symbolic::Polynomial> polynomials_of(const PatchText& text) {
  static const std::vector<std::string> names{"u", "v"};
  std::vector<symbolic::Polynomial> result;
  for (const std::string& coordinate : {text.x, text.y, text.z, text.w})
    result.push_back(symbolic::parse_polynomial(coordinate, names));
  return result;
}

using Sides = std::array<symbolic::Interval, 2>;

inline Sides unit_square() { return {symbolic::Interval{0, 1}, symbolic::Interval{0, 1}}; }
/// [-size, size]^2.
inline Sides square(const Rational& size) { return {symbolic::Interval{-size, size}, symbolic::Interval{-size, size}}; }

inline symbolic::SurfacePiece patch(const PatchText& text, const Sides& sides = unit_square()) {
  return {symbolic::RationalSurface(symbolic::RationalSurface::Kind::tensor_product, polynomials_of(text)),
          symbolic::ParameterRegion{sides, false}};
}

/// Its control points on the rectangle, as a net on [0, 1]^2 of the degrees of the polynomials.
inline bridge::ExactNet patch_net(const PatchText& text, const Sides& sides = unit_square()) {
  const std::vector<symbolic::Polynomial> coordinates = polynomials_of(text);
  std::array<std::size_t, 2> degree{1, 1};
  for (const symbolic::Polynomial& p : coordinates)
    for (std::size_t axis = 0; axis < 2; ++axis)
      degree[axis] = std::max(degree[axis], static_cast<std::size_t>(std::max(p.degree(axis), 0L)));
  bridge::ExactNet net{{degree[0], degree[1]}, std::vector<bridge::ExactPoint>((degree[0] + 1) * (degree[1] + 1))};
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<Powers> rows(degree[0] + 1, Powers(degree[1] + 1));
    for (const auto& term : coordinates[k].terms()) rows[term.exponents[0]][term.exponents[1]] = term.coefficient;
    for (Powers& row : rows) row = symbolic::bernstein_coefficients(row, sides[1]);
    for (std::size_t j = 0; j <= degree[1]; ++j) {
      Powers column;
      for (const Powers& row : rows) column.push_back(row[j]);
      column = symbolic::bernstein_coefficients(column, sides[0]);
      for (std::size_t i = 0; i <= degree[0]; ++i) net.points[i * (degree[1] + 1) + j][k] = column[i];
    }
  }
  return net;
}

/// Both exactly and in doubles.
struct NetPair {
  bridge::ExactNet exact_first;
  bridge::ExactNet exact_second;
  bridge::ControlNet first = in_doubles(exact_first);
  bridge::ControlNet second = in_doubles(exact_second);

  NetPair(bridge::ExactNet a, bridge::ExactNet b) : exact_first(std::move(a)), exact_second(std::move(b)) {}
  NetPair(const PatchText& a, const PatchText& b) : NetPair(patch_net(a), patch_net(b)) {}
};

}  // namespace eliminant::test
