// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/io/input/memory_limit.hpp>

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#endif

#ifdef __linux__
#include <fcntl.h>
#include <unistd.h>
#endif

#include <array>
#include <cstdlib>

#include <eliminant/numeric/lapack.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>

namespace eliminant::io {

namespace {

constexpr long megabyte = 1024 * 1024;

// Megabytes of address space that the process has now, or 0 where the system does not say (anywhere but on Linux).
long megabytes_in_use() {
#ifdef __linux__
  const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  std::array<char, 64> text{};
  const ssize_t count = read(file, text.data(), text.size() - 1);
  close(file);
  return count <= 0 ? 0 : std::strtol(text.data(), nullptr, 10) * sysconf(_SC_PAGESIZE) / megabyte;
#else
  return 0;
#endif
}

// What the process takes without a problem.
long own_megabytes = 0;

}  // namespace

void count_memory_from_now() { own_megabytes = megabytes_in_use(); }

void prepare_arithmetic() {
  symbolic::throw_on_exhausted_memory();
  symbolic::install_flint_error_handler();
  numeric::use_one_blas_thread();
  numeric::reserve_blas_memory();
  count_memory_from_now();
}

void limit_memory([[maybe_unused]] long megabytes) {
#if __has_include(<sys/resource.h>)
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = static_cast<rlim_t>(megabytes + own_megabytes) * megabyte;
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
