// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include <eliminant/bridge/rounding/power_of_two_scaling.hpp>

namespace eliminant::bridge {

namespace {

double log2_magnitude(const fmpz_t value) {
  slong exponent = 0;
  const double mantissa = fmpz_get_d_2exp(&exponent, value);
  return std::log2(std::fabs(mantissa)) + static_cast<double>(exponent);
}

}  // namespace

PowerOfTwoScaling choose_scaling(const symbolic::Polynomial& p, const symbolic::Polynomial& q) {
  // Minimise the sum of (log2 |c| + a i + b j + e)^2 over all terms c x^i y^j, with e of its own for p and for q. The
  // small ridge term makes unneeded freedom (a variable that does not occur) come out as zero.
  Eigen::Matrix4d normal = Eigen::Matrix4d::Identity() * 1e-6;
  Eigen::Vector4d right_hand_side = Eigen::Vector4d::Zero();
  int index = 2;
  for (const symbolic::Polynomial* curve : {&p, &q}) {
    for (const auto& term : curve->terms()) {
      Eigen::Vector4d row = Eigen::Vector4d::Zero();
      row(0) = static_cast<double>(term.exponents[0]);
      row(1) = static_cast<double>(term.exponents[1]);
      row(index) = 1;
      const double magnitude =
          log2_magnitude(fmpq_numref(term.coefficient.get())) - log2_magnitude(fmpq_denref(term.coefficient.get()));
      normal += row * row.transpose();
      right_hand_side -= magnitude * row;
    }
    ++index;
  }
  const Eigen::Vector4d solution = normal.ldlt().solve(right_hand_side);
  const auto rounded = [](double exponent) {
    return std::isfinite(exponent) ? std::lround(std::clamp(exponent, -1e7, 1e7)) : 0L;
  };
  return {rounded(solution(0)), rounded(solution(1))};
}

}  // namespace eliminant::bridge
