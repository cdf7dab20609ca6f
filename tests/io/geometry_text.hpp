// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <eliminant/io/input/curve_input.hpp>
#include <eliminant/io/input/surface_input.hpp>
#include <eliminant/io/results/json_fields.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>

/// Curves and surfaces from their text.
namespace eliminant::test {

inline intersect::Curve curve_from(const std::string& text) {
  const io::JsonDocument document(text);
  return io::read_curve(io::JsonFields(document), document.root(), "\"curve\"");
}

inline intersect::Surface surface_from(const std::string& text) {
  const io::JsonDocument document(text);
  return io::read_surface(io::JsonFields(document), document.root(), "\"surface\"");
}

inline std::vector<symbolic::Polynomial> polynomials(const std::vector<std::string>& texts,
                                                     const std::vector<std::string>& names) {
  std::vector<symbolic::Polynomial> result;
  for (const std::string& text : texts) result.push_back(symbolic::parse_polynomial(text, names));
  return result;
}

/// Fields of the object under `name` of a bad geometry, for the wrapper of the problem around it.
template <class Wrap>
auto under(const std::string& name, const Wrap& wrap) {
  return [=](const std::string& fields) { return wrap("{\"" + name + "\": {" + fields + "}}"); };
}

}  // namespace eliminant::test
