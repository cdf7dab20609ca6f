// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/results/cylinders_words.hpp>

#include <vector>

#include <eliminant/io/results/result_words.hpp>

namespace eliminant::io {

std::string residual_text(const intersect::CylinderSolution& solution) {
  return solution.residual_exponent ? radius_text(*solution.residual_exponent) : "0";
}

std::string directions_text(const intersect::CylindersResult& result) {
  const std::vector<std::string> names{"x", "y", "z"};
  return result.directions ? symbolic::to_string(*result.directions, names) : "";
}

}  // namespace eliminant::io
