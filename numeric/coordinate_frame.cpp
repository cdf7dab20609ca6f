// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/coordinate_frame.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::numeric {

double power_of_two_above(double x) {
  if (!(x > 0) || !std::isfinite(x)) return 1;
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, std::clamp(exponent, -500, 500));
}

void CoordinateFrame::apply(CoordinateRows& rows) const {
  for (long k = 0; k < 4; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (centre[at] != 0) rows.row(k) -= centre[at] * rows.row(3);
  }
  for (long k = 0; k < 4; ++k) rows.row(k) /= scale[static_cast<std::size_t>(k)];
}

CoordinateFrame CoordinateFrame::of(const SurfaceForms& surface) {
  CoordinateFrame frame;
  const Eigen::Vector4d middle = surface.coefficients.rowwise().sum();
  CoordinateRows rows = surface.coefficients;
  for (std::size_t k = 0; k < 3; ++k) {
    const double centre = middle(static_cast<long>(k)) / middle(3);
    if (!std::isfinite(centre)) continue;
    // Few digits, so that the subtraction is exact wherever it cancels.
    constexpr double digits = 0x1p10;
    const double unit = power_of_two_above(std::abs(centre)) / digits;
    frame.centre[k] = std::round(centre / unit) * unit;
  }
  frame.apply(rows);
  for (std::size_t k = 0; k < 4; ++k)
    frame.scale[k] = power_of_two_above(rows.row(static_cast<long>(k)).cwiseAbs().maxCoeff());
  return frame;
}

void ParameterTurn::apply(const CurveForms& curve, CurveForms& result) const {
  const long degree = curve.degree();
  result.coefficients.setZero(4, degree + 1);
  std::array<double, largest_numeric_degree + 1> form{};
  double factor = 1;
  for (long i = 0; i <= degree; ++i, factor *= scale) {
    // (c x_0 + s x_1)^i (c x_1 - s x_0)^(degree - i), in ascending powers of x_0.
    form.fill(0);
    form[0] = factor;
    for (long k = 0; k < degree; ++k) {
      const double low = k < i ? sine : cosine;
      const double high = k < i ? cosine : -sine;
      for (auto j = static_cast<std::size_t>(k) + 1; j > 0; --j) form[j] = form[j] * low + form[j - 1] * high;
      form[0] *= low;
    }
    for (long j = 0; j <= degree; ++j)
      result.coefficients.col(j) += form[static_cast<std::size_t>(j)] * curve.coefficients.col(i);
  }
}

}  // namespace eliminant::numeric
