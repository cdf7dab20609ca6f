// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

/// tests/data/matrix_representations.json, and maps from the texts of their coordinates.
namespace eliminant::test {

inline const nlohmann::json& representation_data() {
  static const nlohmann::json data =
      nlohmann::json::parse(std::ifstream(ELIMINANT_TEST_DATA "/matrix_representations.json"));
  return data;
}

inline std::vector<symbolic::Polynomial> polynomials(const std::vector<std::string>& names,
                                                     const std::vector<std::string>& texts) {
  std::vector<symbolic::Polynomial> result;
  for (const std::string& text : texts) result.push_back(symbolic::parse_polynomial(text, names));
  return result;
}

inline symbolic::RationalSurface surface_map(const std::vector<std::string>& parameters,
                                             const std::vector<std::string>& coordinates) {
  return {parameters.size() == 3 ? symbolic::RationalSurface::Kind::triangular
                                 : symbolic::RationalSurface::Kind::tensor_product,
          polynomials(parameters, coordinates)};
}

inline symbolic::RationalSurface surface_of(const nlohmann::json& entry) {
  return surface_map(entry.at("parameters").get<std::vector<std::string>>(),
                     entry.at("coordinates").get<std::vector<std::string>>());
}

/// The surface of that name among the reference surfaces.
inline const nlohmann::json& surface_entry(const std::string& name) {
  for (const nlohmann::json& entry : representation_data().at("surfaces"))
    if (entry.at("name") == name) return entry;
  throw std::runtime_error("no surface " + name);
}

inline symbolic::RationalSurface reference_surface(const std::string& name) { return surface_of(surface_entry(name)); }

inline symbolic::RationalCurve curve_map(const std::vector<std::string>& coordinates) {
  return symbolic::rational_curve(polynomials({"t"}, coordinates));
}

inline symbolic::RationalCurve curve_of(const nlohmann::json& coordinates) {
  return curve_map(coordinates.get<std::vector<std::string>>());
}

/// Primitive, with positive leading coefficient.
inline symbolic::UnivariatePolynomial univariate(const std::string& text) {
  const symbolic::Polynomial p = symbolic::parse_polynomial(text, std::vector<std::string>{"t"}).primitive_part();
  std::vector<symbolic::Integer> coefficients(static_cast<std::size_t>(p.total_degree() + 1));
  for (const symbolic::Polynomial::Term& term : p.terms())
    coefficients[term.exponents[0]] = term.coefficient.numerator();
  return symbolic::UnivariatePolynomial(coefficients);
}

inline std::string text(const symbolic::UnivariatePolynomial& p) {
  std::vector<symbolic::Polynomial::Term> terms;
  for (long k = 0; k <= p.degree(); ++k)
    terms.push_back({symbolic::Rational(p.coefficient(k)), {static_cast<unsigned long>(k)}});
  return symbolic::to_string(symbolic::Polynomial::from_terms(1, terms), std::vector<std::string>{"t"});
}

inline symbolic::Polynomial form(const std::string& text) {
  return symbolic::parse_polynomial(text, std::vector<std::string>{"x", "y", "z", "w"}).primitive_part();
}

}  // namespace eliminant::test
