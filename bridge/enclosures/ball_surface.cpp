// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/enclosures/ball_surface.hpp>

#include <algorithm>
#include <map>

namespace eliminant::bridge {

BallSurface::BallSurface(const symbolic::RationalSurface& surface)
    : tensor_product_(surface.kind() == symbolic::RationalSurface::Kind::tensor_product) {
  std::map<std::vector<unsigned long>, std::vector<symbolic::Integer>> coefficients;
  const std::size_t count = surface.coordinates().size();
  for (std::size_t k = 0; k < count; ++k)
    for (const symbolic::Polynomial::Term& term : surface.coordinates()[k].terms()) {
      std::vector<unsigned long> exponents = term.exponents;
      if (tensor_product_)
        exponents = {term.exponents[0], static_cast<unsigned long>(surface.bidegree()[0]) - term.exponents[0],
                     term.exponents[1], static_cast<unsigned long>(surface.bidegree()[1]) - term.exponents[1]};
      std::vector<symbolic::Integer>& row = coefficients[exponents];
      row.resize(count);
      row[k] = term.coefficient.numerator();
    }
  for (auto& [exponents, row] : coefficients) {
    highest_.resize(exponents.size(), 0);
    for (std::size_t k = 0; k < exponents.size(); ++k) highest_[k] = std::max(highest_[k], exponents[k]);
    monomials_.push_back({exponents, std::move(row)});
  }
}

std::vector<std::vector<std::size_t>> BallSurface::groups() const {
  return tensor_product_ ? std::vector<std::vector<std::size_t>>{{0, 1}, {2, 3}}
                         : std::vector<std::vector<std::size_t>>{{0, 1, 2}};
}

BallSurface::Jet BallSurface::jet_at(const HomogeneousParameters& parameters, const std::vector<std::size_t>& by,
                                     long precision_bits) const {
  std::vector<std::vector<ComplexBall>> powers(parameters.size());
  std::vector<bool> is_one;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    is_one.push_back(acb_is_one(parameters[k].get()) != 0);
    powers[k].resize(highest_[k] + 1);
    acb_one(powers[k].front().get());
    for (unsigned long e = 1; e <= highest_[k] && !is_one[k]; ++e)
      acb_mul(powers[k][e].get(), powers[k][e - 1].get(), parameters[k].get(), precision_bits);
  }
  const std::size_t count = monomials_.front().coefficients.size();
  Jet result;
  result.point.resize(count);
  result.derivatives.assign(by.size(), std::vector<ComplexBall>(count));
  ComplexBall value;
  // Sets `value` to the monomial, with one exponent lowered where that is asked for.
  const auto set_value = [&](const std::vector<unsigned long>& exponents, std::optional<std::size_t> lowered) {
    bool first = true;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const unsigned long exponent = exponents[k] - (lowered && *lowered == k ? 1 : 0);
      if (exponent == 0 || is_one[k]) continue;
      if (first)
        acb_set(value.get(), powers[k][exponent].get());
      else
        acb_mul(value.get(), value.get(), powers[k][exponent].get(), precision_bits);
      first = false;
    }
    if (first) acb_one(value.get());
    if (lowered) acb_mul_ui(value.get(), value.get(), exponents[*lowered], precision_bits);
  };
  const auto add = [&](const Monomial& monomial, std::vector<ComplexBall>& sums) {
    for (std::size_t c = 0; c < count; ++c)
      if (!monomial.coefficients[c].is_zero())
        acb_addmul_fmpz(sums[c].get(), value.get(), monomial.coefficients[c].get(), precision_bits);
  };
  for (const Monomial& monomial : monomials_) {
    set_value(monomial.exponents, std::nullopt);
    add(monomial, result.point);
    for (std::size_t d = 0; d < by.size(); ++d) {
      if (monomial.exponents[by[d]] == 0) continue;
      set_value(monomial.exponents, by[d]);
      add(monomial, result.derivatives[d]);
    }
  }
  return result;
}

std::vector<ComplexBall> BallSurface::point_at(const HomogeneousParameters& parameters, long precision_bits) const {
  return jet_at(parameters, {}, precision_bits).point;
}

}  // namespace eliminant::bridge
