// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/integer.hpp>

namespace eliminant::symbolic {

Integer Integer::from_string(std::string_view digits, int base) {
  std::string text(digits);
  if (!text.empty() && text.front() == '+') text.erase(0, 1);
  Integer result;
  if (text.empty() || fmpz_set_str(result.value_, text.c_str(), base) != 0)
    throw InvalidInput("'" + std::string(digits.substr(0, 40)) + "' is not an integer", "an optional sign and digits");
  return result;
}

std::string Integer::to_string() const {
  char* text = fmpz_get_str(nullptr, 10, value_);
  std::string result(text);
  flint_free(text);
  return result;
}

Integer power(const Integer& base, unsigned long exponent) {
  Integer result;
  fmpz_pow_ui(result.get(), base.get(), exponent);
  return result;
}

}  // namespace eliminant::symbolic
