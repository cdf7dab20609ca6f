// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include <eliminant/symbolic/arithmetic/integer.hpp>

namespace eliminant::symbolic {

/// A matrix over Z: RAII around FLINT's type.
class IntegerMatrix {
 public:
  IntegerMatrix(long rows, long columns) { fmpz_mat_init(value_, rows, columns); }
  IntegerMatrix(const IntegerMatrix& other) { fmpz_mat_init_set(value_, other.value_); }
  IntegerMatrix(IntegerMatrix&& other) noexcept {
    fmpz_mat_init(value_, 0, 0);
    fmpz_mat_swap(value_, other.value_);
  }
  IntegerMatrix& operator=(IntegerMatrix other) noexcept {
    fmpz_mat_swap(value_, other.value_);
    return *this;
  }
  ~IntegerMatrix() { fmpz_mat_clear(value_); }

  fmpz_mat_struct* get() { return value_; }
  const fmpz_mat_struct* get() const { return value_; }
  long rows() const { return fmpz_mat_nrows(value_); }
  long columns() const { return fmpz_mat_ncols(value_); }
  fmpz* entry(long i, long j) { return fmpz_mat_entry(value_, i, j); }
  const fmpz* entry(long i, long j) const { return fmpz_mat_entry(value_, i, j); }
  long rank() const { return fmpz_mat_rank(value_); }

  friend bool operator==(const IntegerMatrix& a, const IntegerMatrix& b) {
    return fmpz_mat_equal(a.value_, b.value_) != 0;
  }

 private:
  fmpz_mat_t value_;
};

/// A basis over Q of the vectors v with A v = 0, in the columns: each with coprime integer entries, a positive one in
/// the position of its free variable and 0 in those of the others.
IntegerMatrix nullspace(const IntegerMatrix& a);

}  // namespace eliminant::symbolic
