// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/matrices/row_monomials.hpp>

#include <algorithm>
#include <array>
#include <map>

#include <eliminant/base/error.hpp>

namespace eliminant::symbolic {

namespace {

using Exponents = std::vector<unsigned long>;

}  // namespace

RowMonomials::RowMonomials(RationalSurface::Kind kind, const MatrixRepresentation& m) : exponents_(m.row_monomials) {
  if (kind == RationalSurface::Kind::triangular) {
    groups_ = {{0, 1, 2}};
    return;
  }
  groups_ = {{0, 1}, {2, 3}};
  std::array<unsigned long, 2> degrees{0, 0};
  for (const Exponents& row : exponents_)
    for (std::size_t k = 0; k < 2; ++k) degrees[k] = std::max(degrees[k], row[k]);
  for (Exponents& row : exponents_) row = {row[0], degrees[0] - row[0], row[1], degrees[1] - row[1]};
}

bool RowMonomials::has_degree(unsigned long least) const {
  return std::all_of(groups_.begin(), groups_.end(), [&](const std::vector<std::size_t>& group) {
    unsigned long degree = 0;
    for (const std::size_t k : group) degree += exponents_.front()[k];
    return degree >= least;
  });
}

std::vector<std::vector<std::size_t>> RowMonomials::multiples() const {
  std::vector<Exponents> factors{Exponents(exponents_.front().size(), 0)};
  for (const std::vector<std::size_t>& group : groups_) {
    std::vector<Exponents> extended;
    for (const Exponents& factor : factors)
      for (const std::size_t k : group) {
        extended.push_back(factor);
        ++extended.back()[k];
      }
    factors = std::move(extended);
  }
  // Rows by what is left when a factor is divided out.
  std::map<Exponents, std::vector<std::size_t>> lower;
  for (std::size_t f = 0; f < factors.size(); ++f)
    for (std::size_t i = 0; i < exponents_.size(); ++i) {
      Exponents quotient = exponents_[i];
      bool divisible = true;
      for (std::size_t k = 0; k < quotient.size(); ++k) {
        divisible = divisible && quotient[k] >= factors[f][k];
        quotient[k] -= factors[f][k];
      }
      if (divisible) lower[quotient].push_back(i);
    }
  std::vector<std::vector<std::size_t>> result;
  for (auto& [quotient, rows] : lower) result.push_back(std::move(rows));
  return result;
}

std::size_t RowMonomials::neighbour(std::size_t row, std::size_t removed, std::size_t added) const {
  Exponents exponents = exponents_[row];
  --exponents[removed];
  ++exponents[added];
  const auto found = std::find(exponents_.begin(), exponents_.end(), exponents);
  if (found == exponents_.end())
    throw InvalidInput("the row monomials of a matrix representation are not all of one degree", "all of them");
  return static_cast<std::size_t>(found - exponents_.begin());
}

}  // namespace eliminant::symbolic
