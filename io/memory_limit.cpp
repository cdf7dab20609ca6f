// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/memory_limit.hpp>

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#endif

#include <eliminant/numeric/lapack.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>

namespace eliminant::io {

void prepare_arithmetic() {
  symbolic::throw_on_exhausted_memory();
  symbolic::install_flint_error_handler();
  numeric::use_one_blas_thread();
}

void limit_memory([[maybe_unused]] long megabytes) {
#if __has_include(<sys/resource.h>)
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = static_cast<rlim_t>(megabytes) * 1024 * 1024;
  if (limit.rlim_max != RLIM_INFINITY && limit.rlim_cur > limit.rlim_max) limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_AS, &limit);
#endif
}

KeptMemoryLimit::KeptMemoryLimit() {
#if __has_include(<sys/resource.h>)
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  bytes_ = limit.rlim_cur;
#endif
}

KeptMemoryLimit::~KeptMemoryLimit() {
#if __has_include(<sys/resource.h>)
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = static_cast<rlim_t>(bytes_);
  setrlimit(RLIMIT_AS, &limit);
#endif
}

}  // namespace eliminant::io
