// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <eliminant/numeric/ehrlich_aberth.hpp>

namespace eliminant::numeric {

namespace {

using Complex = std::complex<double>;

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Exponents beyond this are clipped: ldexp gives 0 or infinity there all the same.
int clipped(long exponent) { return static_cast<int>(std::clamp(exponent, -5000L, 5000L)); }

Complex shifted(const Complex& z, long exponent) {
  const int by = clipped(exponent);
  return {std::ldexp(z.real(), by), std::ldexp(z.imag(), by)};
}

/// A polynomial seen from a circle of radius r = 2^(eighths / 8): coefficients of p(r w) over the largest of them.
/// Finer steps than powers of two keep |w|^degree within the range of double for every degree in sight.
class ScaledCoefficients {
 public:
  ScaledCoefficients(const std::vector<ScaledReal>& coefficients, long eighths) : values_(coefficients.size()) {
    const auto position = [&](std::size_t i) {
      return 8 * coefficients[i].exponent + static_cast<long>(i) * eighths;  // log2 of the power of two, in eighths
    };
    long largest = std::numeric_limits<long>::min();
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      if (coefficients[i].mantissa != 0) largest = std::max(largest, position(i));
    static const std::array<double, 8> fractions = [] {
      std::array<double, 8> powers{};
      for (std::size_t k = 0; k < powers.size(); ++k) powers[k] = std::exp2(static_cast<double>(k) / 8);
      return powers;
    }();
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      if (coefficients[i].mantissa == 0) continue;
      const long below = position(i) - largest;  // <= 0
      const long whole = -((-below + 7) / 8);
      values_[i] =
          std::ldexp(coefficients[i].mantissa * fractions[static_cast<std::size_t>(below - 8 * whole)], clipped(whole));
    }
  }

  struct Evaluation {
    Complex value, derivative;
    double rounding_error;
  };

  /// At |w| <= 1.
  Evaluation at(const Complex& w) const {
    Evaluation result{0, 0, 0};
    const double size = std::abs(w);
    double absolute = 0;
    // Written out: std::complex multiplication looks for NaN.
    double re = 0;
    double im = 0;
    double d_re = 0;
    double d_im = 0;
    for (std::size_t i = values_.size(); i-- > 0;) {
      const double next_d_re = d_re * w.real() - d_im * w.imag() + re;
      d_im = d_re * w.imag() + d_im * w.real() + im;
      d_re = next_d_re;
      const double next_re = re * w.real() - im * w.imag() + values_[i];
      im = re * w.imag() + im * w.real();
      re = next_re;
      absolute = absolute * size + std::fabs(values_[i]);
    }
    result.value = {re, im};
    result.derivative = {d_re, d_im};
    result.rounding_error = 4 * static_cast<double>(values_.size()) * unit_roundoff * absolute;
    return result;
  }

 private:
  std::vector<double> values_;
};

/// The exponent in eighths of the smallest circle of the family around z.
long circle_of(const ScaledComplex& z) {
  return 8 * z.exponent + static_cast<long>(std::ceil(8 * std::log2(std::abs(z.mantissa)) + 1e-9));
}

}  // namespace

ScaledComplex normalized(Complex mantissa, long exponent) {
  const double size = std::max(std::fabs(mantissa.real()), std::fabs(mantissa.imag()));
  if (size == 0 || !std::isfinite(size)) return {mantissa, 0};
  const int shift = std::ilogb(size) + 1;
  return {shifted(mantissa, -shift), exponent + shift};
}

std::vector<double> newton_polygon_radii(const std::vector<double>& log2_coefficients) {
  std::vector<std::size_t> hull;
  const auto slope = [&](std::size_t i, std::size_t j) {
    return (log2_coefficients[j] - log2_coefficients[i]) / static_cast<double>(j - i);
  };
  for (std::size_t i = 0; i < log2_coefficients.size(); ++i) {
    if (!std::isfinite(log2_coefficients[i])) continue;
    while (hull.size() >= 2 && slope(hull[hull.size() - 2], hull.back()) <= slope(hull.back(), i)) hull.pop_back();
    hull.push_back(i);
  }
  std::vector<double> radii;
  for (std::size_t k = 0; k + 1 < hull.size(); ++k)
    radii.insert(radii.end(), hull[k + 1] - hull[k], -slope(hull[k], hull[k + 1]));
  return radii;
}

std::vector<ScaledComplex> points_on_circles(const std::vector<double>& radii_log2) {
  constexpr double pi = 3.14159265358979323846;
  std::vector<ScaledComplex> points;
  for (std::size_t first = 0; first < radii_log2.size();) {
    std::size_t last = first;
    while (last < radii_log2.size() && radii_log2[last] == radii_log2[first]) ++last;
    const auto count = static_cast<double>(last - first);
    const double whole = std::floor(radii_log2[first]);
    const double radius = std::exp2(radii_log2[first] - whole);
    // An angle that no symmetry of the polynomial shares.
    const double offset = 0.7 + 0.37 * static_cast<double>(first);
    for (std::size_t k = first; k < last; ++k) {
      const double angle = 2 * pi * static_cast<double>(k - first) / count + offset;
      points.push_back(normalized(std::polar(radius, angle), static_cast<long>(whole)));
    }
    first = last;
  }
  return points;
}

std::vector<ScaledComplex> ehrlich_aberth(const std::vector<ScaledReal>& coefficients, int max_sweeps) {
  std::vector<double> logarithms;
  for (const ScaledReal& a : coefficients)
    logarithms.push_back(std::log2(std::fabs(a.mantissa)) + static_cast<double>(a.exponent));
  std::vector<ScaledComplex> roots = points_on_circles(newton_polygon_radii(logarithms));
  std::map<long, ScaledCoefficients> circles;
  std::vector<bool> settled(roots.size(), false);
  // Where all roots are in the range of double, with room for squares, their differences need no exponents.
  const auto plain_exponent = [](const ScaledComplex& z) { return std::labs(z.exponent) < 250; };
  bool plain = std::all_of(roots.begin(), roots.end(), plain_exponent);
  std::vector<Complex> values;
  if (plain)
    for (const ScaledComplex& z : roots) values.push_back(shifted(z.mantissa, z.exponent));
  const auto repulsion_on = [&](std::size_t i, long unit_exponent) {
    double re = 0;
    double im = 0;
    const Complex here = plain ? values[i] : shifted(roots[i].mantissa, roots[i].exponent - unit_exponent);
    for (std::size_t j = 0; j < roots.size(); ++j) {
      const Complex there = plain ? values[j] : shifted(roots[j].mantissa, roots[j].exponent - unit_exponent);
      const double d_re = here.real() - there.real();
      const double d_im = here.imag() - there.imag();
      const double square = d_re * d_re + d_im * d_im;
      if (square == 0 || !std::isfinite(square)) continue;  // also j = i
      re += d_re / square;
      im -= d_im / square;
    }
    return plain ? shifted({re, im}, unit_exponent) : Complex(re, im);
  };
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    bool moved = false;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (settled[i]) continue;
      const long circle = circle_of(roots[i]);
      // Everything is measured in units of r = 2^(circle / 8) = 2^whole * fraction.
      const long whole = circle >= 0 ? circle / 8 : -((-circle + 7) / 8);
      const double fraction = std::exp2(static_cast<double>(circle - 8 * whole) / 8);
      const Complex w = shifted(roots[i].mantissa, roots[i].exponent - whole) / fraction;
      const auto coefficients_here = circles.try_emplace(circle, coefficients, circle).first;
      const ScaledCoefficients::Evaluation p = coefficients_here->second.at(w);
      if (std::abs(p.value) <= p.rounding_error) {
        settled[i] = true;
        continue;
      }
      const Complex repulsion = repulsion_on(i, whole) * fraction;
      // p / p' over 1 - p / p' * repulsion, without dividing by p'.
      const Complex step = p.value / (p.derivative - p.value * repulsion);
      if (!std::isfinite(step.real()) || !std::isfinite(step.imag())) continue;
      const Complex next = (w - step) * fraction;
      if (next == Complex(0)) continue;
      roots[i] = normalized(next, whole);
      if (plain) values[i] = shifted(roots[i].mantissa, roots[i].exponent);
      plain = plain && plain_exponent(roots[i]);
      moved = true;
      if (std::abs(step) < 4 * unit_roundoff * std::abs(w)) settled[i] = true;
    }
    if (!moved) break;
  }
  return roots;
}

}  // namespace eliminant::numeric
