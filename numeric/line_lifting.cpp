// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <vector>

#include <eliminant/numeric/line_lifting.hpp>

namespace eliminant::numeric {

namespace {

using Complex = std::complex<double>;
using Coefficients = std::vector<Complex>;

/// Ascending coefficients of p(constant + slope y, y), of formal degree `degree`: Horner's rule in x.
Coefficients restrict_to_line(const BivariatePolynomial<double>& p, long degree, const Complex& constant,
                              double slope) {
  Coefficients sum(static_cast<std::size_t>(degree) + 1, Complex(0));
  for (long i = p.coefficients.rows(); i-- > 0;) {
    for (std::size_t j = sum.size(); j-- > 0;) sum[j] = sum[j] * constant + (j > 0 ? sum[j - 1] * slope : Complex(0));
    for (long j = 0; j < p.coefficients.cols() && j <= degree; ++j)
      sum[static_cast<std::size_t>(j)] += p.coefficients(i, j);
  }
  return sum;
}

/// Row by row, each scaled to largest entry 1.
std::vector<Coefficients> hybrid_bezout_rows(const Coefficients& f, const Coefficients& g) {
  const std::size_t m = f.size() - 1;
  const std::size_t n = g.size() - 1;
  // g shifted to degree m.
  const auto shifted = [&](std::size_t j) { return j >= m - n ? g[j - (m - n)] : Complex(0); };
  std::vector<Coefficients> rows;
  Coefficients row(m, Complex(0));
  for (std::size_t i = 0; i < n; ++i) {
    // k_i = y k_(i-1) + f_(m-i) y^(m-n) g - g~_(m-i) f; the coefficient of y^m cancels.
    const Complex f_leading = f[m - i];
    const Complex g_leading = shifted(m - i);
    for (std::size_t j = m; j-- > 0;)
      row[j] = (j > 0 ? row[j - 1] : Complex(0)) + f_leading * shifted(j) - g_leading * f[j];
    rows.push_back(row);
  }
  for (std::size_t k = 0; k < m - n; ++k) {
    Coefficients multiple(m, Complex(0));
    for (std::size_t j = 0; j <= n; ++j) multiple[j + k] = g[j];
    rows.push_back(std::move(multiple));
  }
  for (Coefficients& each : rows) {
    double largest = 0;
    for (const Complex& entry : each) largest = std::max(largest, std::norm(entry));
    if (largest > 0)
      for (Complex& entry : each) entry /= std::sqrt(largest);
  }
  return rows;
}

/// A vector that the matrix nearly maps to 0.
std::optional<Coefficients> kernel_vector(std::vector<Coefficients> rows) {
  const std::size_t m = rows.size();
  for (std::size_t k = 0; k + 1 < m; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < m; ++i)
      if (std::norm(rows[i][k]) > std::norm(rows[pivot][k])) pivot = i;
    if (rows[pivot][k] == Complex(0)) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = k + 1; i < m; ++i) {
      const Complex factor = rows[i][k] / rows[k][k];
      if (factor == Complex(0)) continue;
      // Written out: the multiplication of std::complex looks for NaN.
      for (std::size_t j = k + 1; j < m; ++j) {
        const Complex& u = rows[k][j];
        rows[i][j] -= Complex(factor.real() * u.real() - factor.imag() * u.imag(),
                              factor.real() * u.imag() + factor.imag() * u.real());
      }
    }
  }
  Coefficients vector(m, Complex(0));
  vector[m - 1] = 1;
  for (std::size_t k = m - 1; k-- > 0;) {
    Complex sum(0);
    for (std::size_t j = k + 1; j < m; ++j) sum += rows[k][j] * vector[j];
    vector[k] = -sum / rows[k][k];
  }
  return vector;
}

}  // namespace

std::optional<PlanePoint<double>> common_zero_on_line(const BivariatePolynomial<double>& p,
                                                      const BivariatePolynomial<double>& q, long m, long n,
                                                      const LinePencil& lines, const Complex& t) {
  const Complex constant = t / lines.x_weight;
  const double slope = -lines.y_weight / lines.x_weight;
  const Coefficients f = restrict_to_line(p, m, constant, slope);
  const Coefficients g = restrict_to_line(q, n, constant, slope);
  Complex y;
  if (m == 1) {
    const Coefficients& steeper = std::norm(f[1]) > std::norm(g[1]) ? f : g;
    y = -steeper[0] / steeper[1];
  } else {
    const std::optional<Coefficients> vector = kernel_vector(hybrid_bezout_rows(f, g));
    if (!vector) return std::nullopt;
    // The end at which the powers of y are large.
    const bool low = std::norm(vector->front()) >= std::norm(vector->back());
    y = low ? (*vector)[1] / (*vector)[0] : (*vector)[vector->size() - 1] / (*vector)[vector->size() - 2];
  }
  return PlanePoint<double>{constant + slope * y, y};
}

}  // namespace eliminant::numeric
