// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/ball_surface.hpp>

#include <algorithm>

namespace eliminant::bridge {

BallSurface::BallSurface(const symbolic::RationalSurface& surface)
    : tensor_product_(surface.kind() == symbolic::RationalSurface::Kind::tensor_product) {
  for (const symbolic::Polynomial& f : surface.coordinates()) {
    std::vector<Term>& terms = coordinates_.emplace_back();
    for (const symbolic::Polynomial::Term& term : f.terms()) {
      std::vector<unsigned long> exponents = term.exponents;
      if (tensor_product_)
        exponents = {term.exponents[0], static_cast<unsigned long>(surface.bidegree()[0]) - term.exponents[0],
                     term.exponents[1], static_cast<unsigned long>(surface.bidegree()[1]) - term.exponents[1]};
      highest_.resize(exponents.size(), 0);
      for (std::size_t k = 0; k < exponents.size(); ++k) highest_[k] = std::max(highest_[k], exponents[k]);
      terms.push_back({term.coefficient.numerator(), std::move(exponents)});
    }
  }
}

std::vector<std::vector<std::size_t>> BallSurface::groups() const {
  return tensor_product_ ? std::vector<std::vector<std::size_t>>{{0, 1}, {2, 3}}
                         : std::vector<std::vector<std::size_t>>{{0, 1, 2}};
}

std::vector<ComplexBall> BallSurface::values(const HomogeneousParameters& parameters, std::optional<std::size_t> by,
                                             long precision_bits) const {
  std::vector<std::vector<ComplexBall>> powers(parameters.size());
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    powers[k].resize(highest_[k] + 1);
    acb_one(powers[k].front().get());
    for (unsigned long e = 1; e <= highest_[k]; ++e)
      acb_mul(powers[k][e].get(), powers[k][e - 1].get(), parameters[k].get(), precision_bits);
  }
  std::vector<ComplexBall> result(coordinates_.size());
  ComplexBall product;
  for (std::size_t c = 0; c < coordinates_.size(); ++c)
    for (const Term& term : coordinates_[c]) {
      if (by && term.exponents[*by] == 0) continue;
      acb_one(product.get());
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        const unsigned long exponent = term.exponents[k] - (by && *by == k ? 1 : 0);
        if (exponent > 0 && acb_is_one(parameters[k].get()) == 0)
          acb_mul(product.get(), product.get(), powers[k][exponent].get(), precision_bits);
      }
      if (by) acb_mul_ui(product.get(), product.get(), term.exponents[*by], precision_bits);
      acb_addmul_fmpz(result[c].get(), product.get(), term.coefficient.get(), precision_bits);
    }
  return result;
}

std::vector<ComplexBall> BallSurface::point_at(const HomogeneousParameters& parameters, long precision_bits) const {
  return values(parameters, std::nullopt, precision_bits);
}

std::vector<ComplexBall> BallSurface::derivative_at(const HomogeneousParameters& parameters, std::size_t by,
                                                    long precision_bits) const {
  return values(parameters, by, precision_bits);
}

}  // namespace eliminant::bridge
