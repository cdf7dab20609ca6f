// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/lapack.hpp>

// Weak: the address is null with another LAPACK.
extern "C" void openblas_set_num_threads(int count) __attribute__((weak));

namespace eliminant::numeric {

void use_one_blas_thread() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
}

}  // namespace eliminant::numeric
