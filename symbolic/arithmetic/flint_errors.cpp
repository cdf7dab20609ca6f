// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>

#include <gmp.h>

#include <cstdlib>
#include <mutex>
#include <new>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/flint_headers.hpp>

namespace eliminant::symbolic {

namespace {

// FLINT has already written its own message to standard error. The attribute is spelt as in FLINT 2.9, where it is a
// part of the function type that flint_set_abort takes; clang does not convert [[noreturn]] to it.
__attribute__((noreturn)) void throw_instead_of_abort() {
  throw Error("internal error: the exact arithmetic (FLINT) met a case that should have been excluded before");
}

void* allocate(std::size_t size) {
  void* const block = std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void* allocate_zeroed(std::size_t count, std::size_t size) {
  void* const block = std::calloc(count == 0 ? 1 : count, size == 0 ? 1 : size);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void* reallocate(void* old, std::size_t size) {
  void* const block = std::realloc(old, size == 0 ? 1 : size);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void* reallocate_sized(void* old, std::size_t, std::size_t size) { return reallocate(old, size); }
void release(void* block) { std::free(block); }
void release_sized(void* block, std::size_t) { std::free(block); }

}  // namespace

void install_flint_error_handler() {
  static std::once_flag once;
  std::call_once(once, [] { flint_set_abort(throw_instead_of_abort); });
}

void throw_on_exhausted_memory() {
  mp_set_memory_functions(allocate, reallocate_sized, release_sized);
  __flint_set_memory_functions(allocate, allocate_zeroed, reallocate, release);
}

}  // namespace eliminant::symbolic
