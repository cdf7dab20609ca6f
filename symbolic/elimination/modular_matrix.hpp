// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::symbolic {

/// A matrix over a prime field, zero at first: RAII around FLINT's type.
class ModularMatrix {
 public:
  ModularMatrix(long rows, long columns, const PrimeField& field) {
    nmod_mat_init(value_, rows, columns, field.prime());
  }
  ModularMatrix(ModularMatrix&& other) noexcept {
    nmod_mat_init(value_, 0, 0, other.value_->mod.n);
    nmod_mat_swap(value_, other.value_);
  }
  ModularMatrix& operator=(ModularMatrix&& other) noexcept {
    nmod_mat_swap(value_, other.value_);
    return *this;
  }
  ModularMatrix(const ModularMatrix&) = delete;
  ModularMatrix& operator=(const ModularMatrix&) = delete;
  ~ModularMatrix() { nmod_mat_clear(value_); }
  nmod_mat_struct* get() { return value_; }
  const nmod_mat_struct* get() const { return value_; }
  mp_limb_t& operator()(long i, long j) { return nmod_mat_entry(value_, i, j); }
  mp_limb_t operator()(long i, long j) const { return nmod_mat_entry(value_, i, j); }

 private:
  nmod_mat_t value_;
};

}  // namespace eliminant::symbolic
