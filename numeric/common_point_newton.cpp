// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/common_point_newton.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace eliminant::numeric {

namespace {

using Complex = std::complex<double>;

double size_of(double x) { return std::abs(x); }
/// Within a factor of the square root of two, and cheaper.
double size_of(const Complex& x) { return std::max(std::abs(x.real()), std::abs(x.imag())); }

template <class Scalar>
double norm_of(const std::array<Scalar, 4>& v) {
  double sum = 0;
  for (const Scalar& x : v) sum += std::norm(x);
  return std::sqrt(sum);
}

/// By cofactors; false when the determinant is 0 or overflows.
template <class Scalar>
bool invert(const std::array<std::array<Scalar, 3>, 3>& a, std::array<std::array<Scalar, 3>, 3>& inverse) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      inverse[j][i] = a[(i + 1) % 3][(j + 1) % 3] * a[(i + 2) % 3][(j + 2) % 3] -
                      a[(i + 1) % 3][(j + 2) % 3] * a[(i + 2) % 3][(j + 1) % 3];
  const Scalar determinant = a[0][0] * inverse[0][0] + a[0][1] * inverse[1][0] + a[0][2] * inverse[2][0];
  if (!(size_of(determinant) > std::numeric_limits<double>::min())) return false;
  const Scalar reciprocal = Scalar(1) / determinant;
  for (auto& row : inverse)
    for (Scalar& entry : row) entry *= reciprocal;
  return std::isfinite(size_of(reciprocal));
}

}  // namespace

template <class Scalar>
bool settle_common_point(const SurfaceForms& surface, double surface_norm, const CurveForms& curve,
                         CommonPointGuess<Scalar>& guess) {
  constexpr int most_steps = 6;
  constexpr double settled = 1e-8;
  constexpr double farthest = 0.5;
  const auto degrees = static_cast<double>(surface.degrees[0] + surface.degrees[1] + curve.degree());
  const double norms = surface_norm * curve.coefficients.norm();
  guess.moved = 0;
  guess.distance = 1;
  for (int iteration = 0; iteration < most_steps; ++iteration) {
    const PointJet<Scalar> image = jet(surface, guess.chart);
    const PointJet<Scalar> point = jet(curve, guess.t, guess.t_variable);
    const double scale = norm_of(image.value) * norm_of(point.value);
    constexpr double nowhere = 1e-11;
    if (!(scale > nowhere * norms)) return false;
    std::size_t pivot = 0;
    for (std::size_t k = 1; k < 4; ++k)
      if (size_of(point.value[k]) > size_of(point.value[pivot])) pivot = k;
    std::array<Scalar, 3> value;
    std::array<std::array<Scalar, 3>, 3> derivative;
    std::array<std::array<Scalar, 3>, 3> inverse;
    double distance = 0;
    std::size_t row = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k == pivot) continue;
      value[row] = (image.value[k] * point.value[pivot] - image.value[pivot] * point.value[k]) / scale;
      for (std::size_t a = 0; a < 2; ++a)
        derivative[row][a] =
            (image.derivative[a][k] * point.value[pivot] - image.derivative[a][pivot] * point.value[k]) / scale;
      derivative[row][2] =
          (image.value[k] * point.derivative[0][pivot] - image.value[pivot] * point.derivative[0][k]) / scale;
      distance += std::norm(value[row]);
      ++row;
    }
    // Of the start, and of the last point before it settled.
    distance = std::min(1.0, 2 * std::sqrt(distance));
    if (iteration == 0) guess.distance = distance;
    if (!invert(derivative, inverse)) return false;
    double inverse_size = 0;
    double step = 0;
    std::array<Scalar, 3> change;
    for (std::size_t i = 0; i < 3; ++i) {
      change[i] = inverse[i][0] * value[0] + inverse[i][1] * value[1] + inverse[i][2] * value[2];
      step = std::max(step, size_of(change[i]));
      for (const Scalar& entry : inverse[i]) inverse_size += std::norm(entry);
    }
    inverse_size = std::sqrt(inverse_size);
    if (!(step + guess.moved < farthest)) return false;
    if (iteration == 0) guess.first_step = step;
    guess.moved += step;
    guess.step = step;
    for (std::size_t a = 0; a < 2; ++a) guess.chart.values[guess.chart.variables[a]] -= change[a];
    guess.t[guess.t_variable] -= change[2];
    const double curvature = degrees * degrees * norms / scale;
    const double noise = inverse_size * machine_epsilon<double>() * norms / scale;
    if (step > settled || !(inverse_size * (step + noise) * curvature < 0.1)) continue;
    guess.distance = distance;
    return true;
  }
  return false;
}

template bool settle_common_point(const SurfaceForms&, double, const CurveForms&, CommonPointGuess<double>&);
template bool settle_common_point(const SurfaceForms&, double, const CurveForms&, CommonPointGuess<Complex>&);

}  // namespace eliminant::numeric
