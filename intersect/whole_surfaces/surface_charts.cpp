// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/surface_charts.hpp>

#include <eliminant/base/error.hpp>

namespace eliminant::intersect {

DoubleInterval enclose(const bridge::RealBall& value) {
  arf_t lower;
  arf_t upper;
  arf_init(lower);
  arf_init(upper);
  arb_get_interval_arf(lower, upper, value.get(), 80);
  const DoubleInterval result{arf_get_d(lower, ARF_RND_FLOOR), arf_get_d(upper, ARF_RND_CEIL)};
  arf_clear(lower);
  arf_clear(upper);
  return result;
}

DoubleInterval enclose(const symbolic::Rational& value, long exponent) {
  bridge::RealBall ball(value, 80);
  arb_mul_2exp_si(ball.get(), ball.get(), exponent);
  return enclose(ball);
}

namespace {

/// About log2 of the largest coefficient.
long size_of(const std::vector<symbolic::Polynomial>& coordinates) {
  long bits = 0;
  for (const symbolic::Polynomial& p : coordinates)
    for (const auto& term : p.terms())
      bits = std::max(bits, static_cast<long>(fmpz_bits(fmpq_numref(term.coefficient.get()))));
  return bits;
}

}  // namespace

SurfaceCharts::SurfaceCharts(const symbolic::RationalSurface& surface) {
  if (surface.kind() != symbolic::RationalSurface::Kind::tensor_product)
    throw InvalidInput("a surface over the projective plane has no parameters of its own each",
                       "a surface with two affine parameters");
  const auto [m, n] = surface.bidegree();
  degree_ = {static_cast<std::size_t>(m), static_cast<std::size_t>(n)};
  const std::size_t count = (degree_[0] + 1) * (degree_[1] + 1);
  coefficients_.resize(4 * count);
  const long exponent = -size_of(surface.coordinates());
  for (std::size_t c = 0; c < 4; ++c)
    for (const auto& term : surface.coordinates()[c].terms())
      coefficients_[c * count + term.exponents[0] * (degree_[1] + 1) + term.exponents[1]] =
          enclose(term.coefficient, exponent);
  for (const DoubleInterval& coefficient : coefficients_) middles_.push_back(middle(coefficient));
}

std::size_t SurfaceCharts::index(std::size_t coordinate, std::size_t i, std::size_t j,
                                 const std::array<bool, 2>& inverted) const {
  const std::size_t row = inverted[0] ? degree_[0] - i : i;
  const std::size_t column = inverted[1] ? degree_[1] - j : j;
  return (coordinate * (degree_[0] + 1) + row) * (degree_[1] + 1) + column;
}

bool SurfaceCharts::has_base_point(const std::array<bool, 2>& inverted) const {
  for (std::size_t c = 0; c < 4; ++c) {
    const DoubleInterval& constant = coefficients_[index(c, 0, 0, inverted)];
    if (constant.lower != 0 || constant.upper != 0) return false;
  }
  return true;
}

std::array<DoubleInterval, 4> SurfaceCharts::value(const std::array<bool, 2>& inverted,
                                                   const std::array<DoubleInterval, 2>& at) const {
  std::array<DoubleInterval, 4> result;
  for (std::size_t c = 0; c < 4; ++c) {
    DoubleInterval sum;
    for (std::size_t i = degree_[0] + 1; i-- > 0;) {
      DoubleInterval row;
      for (std::size_t j = degree_[1] + 1; j-- > 0;) row = row * at[1] + coefficients_[index(c, i, j, inverted)];
      sum = sum * at[0] + row;
    }
    result[c] = sum;
  }
  return result;
}

template <class Number>
JetOf<Number> SurfaceCharts::jet_of(const std::vector<Number>& coefficients, const std::array<bool, 2>& inverted,
                                    const std::array<Number, 2>& at) const {
  JetOf<Number> result;
  for (std::size_t c = 0; c < 4; ++c) {
    Number sum{};
    Number by_first{};
    Number by_second{};
    for (std::size_t i = degree_[0] + 1; i-- > 0;) {
      Number row{};
      Number slope{};
      for (std::size_t j = degree_[1] + 1; j-- > 0;) {
        slope = slope * at[1] + row;
        row = row * at[1] + coefficients[index(c, i, j, inverted)];
      }
      by_first = by_first * at[0] + sum;
      by_second = by_second * at[0] + slope;
      sum = sum * at[0] + row;
    }
    result.value[c] = sum;
    result.derivative[0][c] = by_first;
    result.derivative[1][c] = by_second;
  }
  return result;
}

SurfaceJet SurfaceCharts::jet(const std::array<bool, 2>& inverted, const std::array<DoubleInterval, 2>& at) const {
  return jet_of(coefficients_, inverted, at);
}

JetOf<double> SurfaceCharts::approximate_jet(const std::array<bool, 2>& inverted,
                                             const std::array<double, 2>& at) const {
  return jet_of(middles_, inverted, at);
}

}  // namespace eliminant::intersect
