// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/symbolic/arithmetic/limits.hpp>

namespace eliminant::io {

/// Reads msolve's format: the variables on the first line, the characteristic (0) on the second, then two polynomials
/// in two variables, separated by a comma. `variables` replaces those of the file. Polynomials have the grammar of
/// parse_polynomial: repeated monomials are added, x/2 is x over 2.
/// Throws ParseError, InvalidInput and LimitReached with the place in `text`.
intersect::PlaneCurvesProblem read_ms_problem(const std::string& text,
                                              const std::optional<std::vector<std::string>>& variables,
                                              const symbolic::Limits& limits);

}  // namespace eliminant::io
