// SPDX-License-Identifier: BSD-3-Clause
#include <support/patch_fibres.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/bridge/roots/descartes_isolation.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>
#include <support/patch_nets.hpp>

namespace eliminant::test {

namespace {

using bridge::RealBall;
using symbolic::PolynomialMatrix;
using symbolic::Rational;
using symbolic::UnivariatePolynomial;

constexpr long bits = 192;

double midpoint(const RealBall& ball) { return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR); }

RealBall value_at(const UnivariatePolynomial& p, const RealBall& t) {
  RealBall sum;
  for (long k = p.degree(); k >= 0; --k) {
    arb_mul(sum.get(), sum.get(), t.get(), bits);
    arb_add_fmpz(sum.get(), sum.get(), p.coefficient(k).get(), bits);
  }
  return sum;
}

using Matrix = std::vector<std::vector<double>>;

/// In doubles, divided by the largest entry.
Matrix matrix_at(const PolynomialMatrix& matrix, const RealBall& t) {
  const auto size = static_cast<std::size_t>(matrix.rows());
  std::vector<std::vector<RealBall>> values(size);
  RealBall largest;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) {
      values[i].push_back(value_at(matrix.entry(static_cast<long>(i), static_cast<long>(j)), t));
      RealBall absolute;
      arb_abs(absolute.get(), values[i][j].get());
      arb_max(largest.get(), largest.get(), absolute.get(), bits);
    }
  Matrix result(size, std::vector<double>(size));
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) {
      arb_div(values[i][j].get(), values[i][j].get(), largest.get(), bits);
      result[i][j] = midpoint(values[i][j]);
    }
  return result;
}

/// Of a matrix of corank one, by elimination with complete pivoting.
std::vector<double> kernel_vector(Matrix a) {
  const std::size_t n = a.size();
  std::vector<std::size_t> columns(n);
  for (std::size_t k = 0; k < n; ++k) columns[k] = k;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    std::size_t row = k;
    std::size_t column = k;
    for (std::size_t i = k; i < n; ++i)
      for (std::size_t j = k; j < n; ++j)
        if (std::abs(a[i][j]) > std::abs(a[row][column])) {
          row = i;
          column = j;
        }
    std::swap(a[k], a[row]);
    for (auto& entries : a) std::swap(entries[k], entries[column]);
    std::swap(columns[k], columns[column]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  std::vector<double> solution(n, 0);
  solution[n - 1] = 1;
  for (std::size_t k = n - 1; k-- > 0;) {
    double sum = 0;
    for (std::size_t j = k + 1; j < n; ++j) sum += a[k][j] * solution[j];
    solution[k] = -sum / a[k][k];
  }
  std::vector<double> result(n);
  for (std::size_t k = 0; k < n; ++k) result[columns[k]] = solution[k];
  return result;
}

/// x of a kernel of powers, from the pair of its largest entry that is `step` apart: index / step modulo `count` is the
/// exponent of x.
double ratio_of_powers(const std::vector<double>& kernel, std::size_t step, std::size_t count) {
  std::size_t best = 0;
  double largest = -1;
  for (std::size_t k = 0; k < kernel.size(); ++k) {
    if ((k / step) % count + 1 == count) continue;
    const double size = std::abs(kernel[k]) + std::abs(kernel[k + step]);
    if (size > largest) {
      largest = size;
      best = k;
    }
  }
  return kernel[best + step] / kernel[best];
}

/// Real roots in [0, 1], with the multiplicity one or more.
struct Root {
  RealBall t;
  unsigned long multiplicity = 1;
};

std::vector<Root> roots_in_unit_interval(const UnivariatePolynomial& p) {
  std::vector<Root> result;
  for (const symbolic::SquarefreeFactor& part : symbolic::squarefree_decomposition(p)) {
    auto roots = bridge::descartes_isolation(part.factor, Context());
    if (!roots) continue;
    for (RealBall& root : *roots) {
      if (midpoint(root) > -1 && midpoint(root) < 2 && arb_is_exact(root.get()) == 0)
        bridge::refine_real_root(part.factor, root, bits / 2, Context());
      const double t = midpoint(root);
      if (t >= 0 && t <= 1) result.push_back({root, part.multiplicity});
    }
  }
  return result;
}

}  // namespace

PatchFibres::PatchFibres(const PatchCase& patches)
    : first_(patches.first),
      second_(patches.second),
      matrix_(surface_piece(patches.first).map, surface_piece(patches.second).map) {}

std::array<double, 3> PatchFibres::residual(const std::array<double, 4>& parameters) const {
  const auto a = patch_point(first_, parameters[0], parameters[1]);
  const auto b = patch_point(second_, parameters[2], parameters[3]);
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::optional<PatchFibres::Fibre> PatchFibres::at(const Rational& u) const {
  constexpr double same_point = 1e-6;
  constexpr double border = 1e-7;
  const std::size_t n = matrix_.first_degree();
  if (n < 2 || matrix_.second_degree() < 2) return std::nullopt;
  const PolynomialMatrix matrix = matrix_.at_first_parameter(u);
  const UnivariatePolynomial p = determinant(matrix);
  if (p.is_zero()) return std::nullopt;
  Fibre fibre;
  const double first = fmpz_get_d(u.numerator().get()) / fmpz_get_d(u.denominator().get());
  for (const Root& root : roots_in_unit_interval(p)) {
    const std::vector<double> kernel = kernel_vector(matrix_at(matrix, root.t));
    const double v = ratio_of_powers(kernel, 1, n);
    const double s = ratio_of_powers(kernel, n, matrix_.second_degree());
    const std::array<double, 4> parameters{first, v, s, midpoint(root.t)};
    double outside = -1;
    for (const double x : parameters) outside = std::max({outside, -x, x - 1});
    if (outside > border) continue;
    const auto rest = residual(parameters);
    const bool lifted = std::abs(rest[0]) + std::abs(rest[1]) + std::abs(rest[2]) < same_point;
    if (lifted && root.multiplicity == 1 && outside < -border)
      fibre.points.push_back(parameters);
    else
      ++fibre.unclear;
  }
  return fibre;
}

bool agrees_with_fibre(const std::vector<std::vector<std::array<double, 4>>>& polylines, double u,
                       const PatchFibres::Fibre& fibre, double reach) {
  using Segment = std::array<std::array<double, 4>, 2>;
  std::vector<Segment> crossing;
  for (const auto& polyline : polylines)
    for (std::size_t k = 0; k + 1 < polyline.size(); ++k)
      if ((polyline[k][0] < u) != (polyline[k + 1][0] < u)) crossing.push_back({polyline[k], polyline[k + 1]});
  std::vector<std::array<double, 4>> alone;
  for (const auto& point : fibre.points) {
    const auto found = std::find_if(crossing.begin(), crossing.end(), [&](const Segment& segment) {
      for (std::size_t k = 1; k < 4; ++k) {
        const auto [low, high] = std::minmax(segment[0][k], segment[1][k]);
        if (point[k] < low - reach || point[k] > high + reach) return false;
      }
      return true;
    });
    if (found == crossing.end())
      alone.push_back(point);
    else
      crossing.erase(found);
  }
  // What is left are turning points at u.
  const auto close = [&](const std::array<double, 4>& a, const std::array<double, 4>& b) {
    for (std::size_t k = 1; k < 4; ++k)
      if (std::abs(a[k] - b[k]) > 2 * reach) return false;
    return true;
  };
  const bool turns = alone.empty() || (alone.size() == 2 && close(alone[0], alone[1]));
  return turns && crossing.size() <= fibre.unclear;
}

}  // namespace eliminant::test
