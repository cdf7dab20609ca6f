// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/bridge/enclosures/ball.hpp>

namespace eliminant::bridge {

/// A matrix of complex balls: RAII around Arb's type.
class BallMatrix {
 public:
  BallMatrix(std::size_t rows, std::size_t columns) {
    acb_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  explicit BallMatrix(const std::vector<std::vector<ComplexBall>>& rows) : BallMatrix(rows.size(), rows.size()) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows.size(); ++j) acb_set(entry(i, j), rows[i][j].get());
  }
  explicit BallMatrix(const std::vector<ComplexBall>& column) : BallMatrix(column.size(), 1) {
    for (std::size_t i = 0; i < column.size(); ++i) acb_set(entry(i, 0), column[i].get());
  }
  BallMatrix(BallMatrix&& other) noexcept {
    acb_mat_init(value_, 0, 0);
    acb_mat_swap(value_, other.value_);
  }
  BallMatrix(const BallMatrix&) = delete;
  BallMatrix& operator=(const BallMatrix&) = delete;
  ~BallMatrix() { acb_mat_clear(value_); }
  acb_mat_struct* get() { return value_; }
  const acb_mat_struct* get() const { return value_; }
  acb_ptr entry(std::size_t i, std::size_t j) {
    return acb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }
  acb_srcptr entry(std::size_t i, std::size_t j) const {
    return acb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }
  std::size_t rows() const { return static_cast<std::size_t>(acb_mat_nrows(value_)); }
  void drop_radii() { acb_mat_get_mid(value_, value_); }

 private:
  acb_mat_t value_;
};

/// Enclosures of right eigenvectors, one for each eigenvalue, in the columns; nullopt when the eigenvalues are not
/// proven to be different at this precision (Arb, by the method of [VanDerHoevenMourrain2017]).
std::optional<BallMatrix> simple_eigenvectors(const BallMatrix& matrix, long precision_bits);

}  // namespace eliminant::bridge
