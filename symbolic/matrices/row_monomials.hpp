// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/symbolic/geometry/rational_surface.hpp>
#include <eliminant/symbolic/matrices/matrix_representation.hpp>

namespace eliminant::symbolic {

/// The row monomials of a matrix representation of a surface in homogeneous parameters, (s1 : s0) and (t1 : t0) with
/// s = s1 / s0, t = t1 / t0 of a tensor-product surface, (s : t : u) of a triangular one; and how the values of these
/// monomials at a point of the parameters, a kernel vector of M, give the parameters back.
class RowMonomials {
 public:
  RowMonomials(RationalSurface::Kind kind, const MatrixRepresentation& m);

  const std::vector<std::vector<unsigned long>>& exponents() const { return exponents_; }
  /// Which homogeneous parameters belong together: two pairs, or one triple.
  const std::vector<std::vector<std::size_t>>& groups() const { return groups_; }
  /// Whether the degree is at least `least` in each group; parameters are read from degree 1 on, and k points of a
  /// fibre are told apart from degree k on, wherever they lie.
  bool has_degree(unsigned long least) const;

  /// For each monomial of one degree less in every group, the rows of its products with all products of one parameter
  /// of each group; equally many for each, in the same order.
  std::vector<std::vector<std::size_t>> multiples() const;

  /// The homogeneous parameters at which the monomials have these values, up to a factor in each group, where the value
  /// in row `largest` is not zero. nullopt when a group has degree 0.
  template <class Number>
  std::optional<std::vector<Number>> parameters(const std::vector<Number>& values, std::size_t largest) const {
    std::vector<Number> result(exponents_.front().size(), Number(0));
    for (const std::vector<std::size_t>& group : groups_) {
      // A parameter that the monomial contains is not zero.
      std::size_t base = group.front();
      for (const std::size_t k : group)
        if (exponents_[largest][k] > exponents_[largest][base]) base = k;
      if (exponents_[largest][base] == 0) return std::nullopt;
      for (const std::size_t k : group)
        result[k] = k == base ? Number(1) : values[neighbour(largest, base, k)] / values[largest];
    }
    return result;
  }

 private:
  /// The row of the monomial with one `added` in place of one `removed`.
  std::size_t neighbour(std::size_t row, std::size_t removed, std::size_t added) const;

  std::vector<std::vector<unsigned long>> exponents_;
  std::vector<std::vector<std::size_t>> groups_;
};

}  // namespace eliminant::symbolic
