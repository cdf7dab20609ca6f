// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/enclosures/interval_polynomial.hpp>

#include <algorithm>

#include <eliminant/bridge/enclosures/ball.hpp>

namespace eliminant::bridge {

namespace {

DoubleInterval power(const DoubleInterval& x, std::size_t exponent) {
  DoubleInterval result(1);
  for (std::size_t k = 0; k < exponent; ++k) result = result * x;
  // A square is not negative.
  if (exponent % 2 == 0 && exponent > 0) result.lower = std::max(result.lower, 0.0);
  return result;
}

}  // namespace

IntervalPolynomial::IntervalPolynomial(const symbolic::Polynomial& p)
    : IntervalPolynomial(static_cast<std::size_t>(std::max(p.degree(0), 0L)) + 1,
                         static_cast<std::size_t>(std::max(p.degree(1), 0L)) + 1) {
  total_degree_ = static_cast<std::size_t>(std::max(p.total_degree(), 0L));
  for (const symbolic::Polynomial::Term& term : p.terms()) {
    const RealBall ball(term.coefficient, 64);
    const double nearest = arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR);
    at(term.exponents[0], term.exponents[1]) = DoubleInterval::widened(nearest, nearest);
  }
}

IntervalPolynomial IntervalPolynomial::in_frame(const std::array<double, 2>& origin,
                                                const std::array<double, 2>& across,
                                                const std::array<double, 2>& along) const {
  const std::size_t size = total_degree_ + 1;
  IntervalPolynomial result(size, size);
  IntervalPolynomial row(size, size);
  result.total_degree_ = row.total_degree_ = total_degree_;
  // In place: terms of each degree come from those of the same degree and of the one below.
  const auto multiply = [&](IntervalPolynomial& p, std::size_t degree, std::size_t k) {
    for (std::size_t n = std::min(degree + 1, total_degree_) + 1; n-- > 0;)
      for (std::size_t i = 0; i <= n; ++i) {
        const std::size_t j = n - i;
        DoubleInterval sum = p.at(i, j) * DoubleInterval(origin[k]);
        if (i > 0) sum = sum + p.at(i - 1, j) * DoubleInterval(across[k]);
        if (j > 0) sum = sum + p.at(i, j - 1) * DoubleInterval(along[k]);
        p.at(i, j) = sum;
      }
  };
  // Horner's scheme in the first argument, of Horner's schemes in the second.
  for (std::size_t i = rows_; i-- > 0;) {
    std::fill(row.coefficients_.begin(), row.coefficients_.end(), DoubleInterval(0));
    const std::size_t highest = std::min(columns_ - 1, total_degree_ - std::min(i, total_degree_));
    for (std::size_t j = highest + 1; j-- > 0;) {
      if (j < highest) multiply(row, highest - 1 - j, 1);
      row.at(0, 0) = row.at(0, 0) + at(i, j);
    }
    if (i + 1 < rows_) multiply(result, total_degree_ - std::min(i + 1, total_degree_), 0);
    for (std::size_t k = 0; k < result.coefficients_.size(); ++k)
      result.coefficients_[k] = result.coefficients_[k] + row.coefficients_[k];
  }
  return result;
}

IntervalPolynomial IntervalPolynomial::derivative(std::size_t axis) const {
  IntervalPolynomial result(std::max<std::size_t>(rows_ - (axis == 0 ? 1 : 0), 1),
                            std::max<std::size_t>(columns_ - (axis == 1 ? 1 : 0), 1));
  result.total_degree_ = total_degree_ - (total_degree_ > 0 ? 1 : 0);
  for (std::size_t i = axis == 0 ? 1 : 0; i < rows_; ++i)
    for (std::size_t j = axis == 1 ? 1 : 0; j < columns_; ++j) {
      const auto factor = static_cast<double>(axis == 0 ? i : j);
      result.at(axis == 0 ? i - 1 : i, axis == 1 ? j - 1 : j) = at(i, j) * DoubleInterval(factor);
    }
  return result;
}

DoubleInterval IntervalPolynomial::on(const DoubleInterval& x, const DoubleInterval& y) const {
  std::vector<DoubleInterval> powers;
  for (std::size_t j = 0; j < columns_; ++j) powers.push_back(power(y, j));
  DoubleInterval sum(0);
  for (std::size_t i = 0; i < rows_; ++i) {
    DoubleInterval row(0);
    for (std::size_t j = 0; j < columns_ && i + j <= total_degree_; ++j) row = row + at(i, j) * powers[j];
    sum = sum + row * power(x, i);
  }
  return sum;
}

double IntervalPolynomial::near(double x, double y) const {
  double sum = 0;
  for (std::size_t i = rows_; i-- > 0;) {
    double row = 0;
    for (std::size_t j = columns_; j-- > 0;) row = row * y + 0.5 * (at(i, j).lower + at(i, j).upper);
    sum = sum * x + row;
  }
  return sum;
}

}  // namespace eliminant::bridge
