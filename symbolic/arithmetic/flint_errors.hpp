// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace eliminant::symbolic {

/// From now on FLINT reports what it would end the process for by throwing eliminant::Error. The checks before each
/// call should make that impossible; this is the last resort. Cheap, may be called any number of times and from any
/// thread.
void install_flint_error_handler();

/// From now on FLINT, GMP and MPFR throw std::bad_alloc when memory is exhausted, instead of ending the process. For a
/// program that limits its own memory and ends after the exception: what was being computed is leaked. Call it before
/// any other use of these libraries.
void throw_on_exhausted_memory();

}  // namespace eliminant::symbolic
