// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/arithmetic/integer_relation.hpp>

#include <flint/fmpz_lll.h>

#include <eliminant/symbolic/arithmetic/integer_matrix.hpp>

namespace eliminant::symbolic {

std::vector<Integer> integer_relation(const std::vector<Integer>& numbers) {
  const auto count = static_cast<long>(numbers.size());
  // The identity, beside the numbers.
  IntegerMatrix basis(count, count + 1);
  for (long i = 0; i < count; ++i) {
    fmpz_one(basis.entry(i, i));
    fmpz_set(basis.entry(i, count), numbers[static_cast<std::size_t>(i)].get());
  }
  fmpz_lll_t parameters;
  fmpz_lll_context_init_default(parameters);
  fmpz_lll(basis.get(), nullptr, parameters);
  std::vector<Integer> relation;
  for (long i = 0; i < count; ++i) relation.emplace_back(basis.entry(0, i));
  return relation;
}

}  // namespace eliminant::symbolic
