// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/space_form.hpp>

#include <cmath>

namespace eliminant::intersect {

SpaceForm::SpaceForm(const symbolic::Polynomial& form) {
  for (const auto& term : form.terms())
    terms_.push_back({enclose(term.coefficient), {term.exponents[0], term.exponents[1], term.exponents[2]}});
}

SpaceForm::Value SpaceForm::at(const std::array<DoubleInterval, 3>& point) const {
  Value sum;
  for (const Term& term : terms_) {
    DoubleInterval product = term.coefficient;
    for (std::size_t i = 0; i < 3; ++i)
      for (unsigned long e = 0; e < term.exponents[i]; ++e) product = product * point[i];
    sum.value = sum.value + product;
    sum.size += std::fabs(middle(product));
  }
  return sum;
}

}  // namespace eliminant::intersect
