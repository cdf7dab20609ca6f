// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <sys/resource.h>

#include <support/curves.hpp>

// OpenBLAS only, and only where it is the LAPACK that is linked.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));

namespace eliminant::bench {

/// One thread in LAPACK, from before the first benchmark on. OpenBLAS reads OPENBLAS_NUM_THREADS when it is loaded,
/// before a program can set it. For another threaded LAPACK set its own variable (OMP_NUM_THREADS, MKL_NUM_THREADS).
inline const bool one_thread = [] {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
  return true;
}();

struct CurvePair {
  symbolic::Polynomial p{2};
  symbolic::Polynomial q{2};
};

/// Two curves with all coefficients up to the total degree, each of 10 bits and a sign; the same ones at every run.
inline CurvePair dense_pair(long degree) {
  test::Random random(static_cast<std::uint64_t>(degree));
  constexpr long largest = 1023;
  const auto d = static_cast<unsigned long>(degree);
  symbolic::Polynomial p = test::random_dense(random, d, largest).primitive_part();
  symbolic::Polynomial q = test::random_dense(random, d, largest).primitive_part();
  return {std::move(p), std::move(q)};
}

/// The largest memory the process has had in use so far. To know it of one benchmark, run that one alone.
inline double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  constexpr double kilobytes_per_megabyte = 1024;
  return static_cast<double>(usage.ru_maxrss) / kilobytes_per_megabyte;
}

}  // namespace eliminant::bench
