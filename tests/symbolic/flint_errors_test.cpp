// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>
#include <eliminant/symbolic/arithmetic/integer.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;

TEST_CASE("install_flint_error_handler: what would end the process is thrown") {
  install_flint_error_handler();
  install_flint_error_handler();
  const Integer one(1);
  const Integer zero;
  Integer quotient;
  CHECK_THROWS_AS(fmpz_fdiv_q(quotient.get(), one.get(), zero.get()), Error);
}
