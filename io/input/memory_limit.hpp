// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace eliminant::io {

/// Lets FLINT, GMP and MPFR throw instead of ending the process, also when memory is exhausted, and keeps OpenBLAS to
/// one thread and lets it take its working memory. For the program, once, before anything else.
void prepare_arithmetic();

/// Limits what the process takes in addition to what it had when it was last counted (program, libraries, stacks), as
/// address space; beyond it allocations throw std::bad_alloc. Without effect where the system has no such limit.
void limit_memory(long megabytes);

/// What the process has now does not count for limit_memory. prepare_arithmetic does this, too.
void count_memory_from_now();

/// Gives the process the limit back that it had when this object was made.
class KeptMemoryLimit {
 public:
  KeptMemoryLimit();
  KeptMemoryLimit(const KeptMemoryLimit&) = delete;
  KeptMemoryLimit& operator=(const KeptMemoryLimit&) = delete;
  ~KeptMemoryLimit();

 private:
  unsigned long long bytes_ = 0;
};

}  // namespace eliminant::io
