// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <support/curves.hpp>

/// tests/data/bezoutian_matrices.json, and surfaces for Bezoutian matrices.
namespace eliminant::test {

inline const nlohmann::json& bezoutian_data() {
  static const nlohmann::json data =
      nlohmann::json::parse(std::ifstream(ELIMINANT_TEST_DATA "/bezoutian_matrices.json"));
  return data;
}

/// From four coordinates in the first two parameters named, the weight first.
inline symbolic::RationalSurface weight_first(const std::vector<std::string>& coordinates,
                                              const std::vector<std::string>& parameters) {
  std::vector<Polynomial> parsed;
  for (const std::string& text : coordinates) parsed.push_back(symbolic::parse_polynomial(text, parameters));
  std::rotate(parsed.begin(), parsed.begin() + 1, parsed.end());
  return {symbolic::RationalSurface::Kind::tensor_product, std::move(parsed)};
}

inline symbolic::RationalSurface weight_first(const nlohmann::json& coordinates,
                                              const std::vector<std::string>& parameters) {
  return weight_first(coordinates.get<std::vector<std::string>>(), parameters);
}

/// All coefficients uniform in [-size, size]; with weight 1 where `polynomial`.
inline symbolic::RationalSurface random_surface(Random& random, unsigned long m, unsigned long n, bool polynomial,
                                                long size) {
  std::vector<Polynomial> coordinates;
  for (int k = 0; k < 4; ++k) {
    std::vector<Polynomial::Term> terms;
    for (unsigned long i = 0; i <= m; ++i)
      for (unsigned long j = 0; j <= n; ++j) terms.push_back({Rational(random.between(-size, size)), {i, j}});
    coordinates.push_back(k == 3 && polynomial ? Polynomial::constant(2, 1) : Polynomial::from_terms(2, terms));
  }
  return {symbolic::RationalSurface::Kind::tensor_product, std::move(coordinates)};
}

/// Names of parameters.
inline const std::vector<std::string>& first_parameters() {
  static const std::vector<std::string> names{"u", "v"};
  return names;
}
inline const std::vector<std::string>& second_parameters() {
  static const std::vector<std::string> names{"s", "t"};
  return names;
}
/// The variables of a matrix of an intersection.
inline const std::vector<std::string>& kept_parameters() {
  static const std::vector<std::string> names{"u", "t"};
  return names;
}

}  // namespace eliminant::test
