// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/bezoutian_minors.hpp>

#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/bezoutian_determinant.hpp>

namespace eliminant::symbolic {

namespace {

/// Calls visit(rows) for each set of `count` rows until it returns false.
template <class Visit>
void for_each_set(std::size_t size, std::size_t count, const Visit& visit) {
  if (count > size) return;
  std::vector<bool> chosen(size, false);
  std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(count), true);
  do {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < size; ++i)
      if (chosen[i]) rows.push_back(i);
    if (!visit(rows)) return;
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
}

bool all_minors_vanish(const SeparatedBezoutian& matrix, std::size_t count, std::uint64_t seed,
                       const Context& context) {
  bool vanish = true;
  for_each_set(matrix.size(), count, [&](const std::vector<std::size_t>& rows) {
    vanish = principal_minor(matrix, rows, seed, context).is_zero();
    return vanish;
  });
  return vanish;
}

}  // namespace

BezoutianMinors bezoutian_minors(const SeparatedBezoutian& matrix, std::uint64_t seed, const Context& context) {
  BezoutianMinors result;
  result.rank = generic_rank_modulo(matrix, seed).rank;
  while (result.rank < matrix.size() && !all_minors_vanish(matrix, result.rank + 1, seed, context)) ++result.rank;
  if (result.rank == 0) {
    result.gcd = Polynomial::constant(2, 1);
    return result;
  }
  for_each_set(matrix.size(), result.rank, [&](const std::vector<std::size_t>& rows) {
    const Polynomial minor = principal_minor(matrix, rows, seed, context);
    if (fmpq_mpoly_gcd(result.gcd.get(), result.gcd.get(), minor.get(), minor.ring()) == 0)
      throw LimitReached("the greatest common divisor of two minors is too large");
    return result.gcd.is_zero() || !result.gcd.is_constant();
  });
  result.gcd = result.gcd.primitive_part();
  return result;
}

}  // namespace eliminant::symbolic
