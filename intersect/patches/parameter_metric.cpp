// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/parameter_metric.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::intersect {

ParameterMetric::ParameterMetric(const DomainBounds& bounds) : bounds_(bounds) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (!bounds_[k]) continue;
    const auto [lower, upper] = *bounds_[k];
    constexpr double digits = 0x1p-50;
    rounding_ = std::max(rounding_, digits * std::max(std::fabs(lower), std::fabs(upper)) / width(k));
  }
}

double ParameterMetric::distance(const std::array<double, 4>& a, const std::array<double, 4>& b) const {
  double result = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (a[k] == b[k]) continue;
    const bool inverted = std::fabs(a[k]) > 1 && std::fabs(b[k]) > 1;
    // On the projective line large parameters are compared by their inverses.
    const double difference = bounds_[k] ? (a[k] - b[k]) / width(k) : inverted ? 1 / a[k] - 1 / b[k] : a[k] - b[k];
    result = std::max(result, std::fabs(difference));
  }
  return result;
}

}  // namespace eliminant::intersect
