// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/lapack.hpp>

#include <vector>

// Weak: the address is null with another LAPACK.
extern "C" void openblas_set_num_threads(int count) __attribute__((weak));
extern "C" int blas_thread_shutdown_() __attribute__((weak));

namespace eliminant::numeric {

void use_one_blas_thread() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
  // The helper threads were started when the library was loaded, and each is about to take working memory of its own.
  if (blas_thread_shutdown_ != nullptr) blas_thread_shutdown_();
}

void reserve_blas_memory() {
  constexpr int n = 32;
  const std::vector<double> a(n * n, 1);
  std::vector<double> c(n * n, 0);
  const double one = 1;
  dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, a.data(), &n, &one, c.data(), &n);
  std::vector<int> pivots(n);
  int info = 0;
  dgetrf_(&n, &n, c.data(), &n, pivots.data(), &info);
}

}  // namespace eliminant::numeric
