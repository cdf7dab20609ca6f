// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/prepared_net.hpp>

#include <cmath>

#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>

namespace eliminant::intersect {

using symbolic::Interval;
using symbolic::Rational;

std::array<Rational, 3> PreparedNet::origin() const {
  std::array<Rational, 3> result;
  const bridge::ExactPoint& first = exact.points.front();
  if (first[3].is_zero()) return result;
  bridge::RealBall ball;
  for (std::size_t k = 0; k < 3; ++k) {
    // The differences have to be small, and few bits keep them short.
    constexpr long few_bits = 20;
    arb_set_fmpq(ball.get(), (first[k] / first[3]).get(), few_bits);
    arf_get_fmpq(result[k].get(), arb_midref(ball.get()));
  }
  return result;
}

std::optional<bridge::ControlNet> PreparedNet::rounded(const std::array<Rational, 3>& origin) const {
  return bridge::ControlNet::round(exact.degrees, exact.points, origin);
}

std::optional<PreparedNet> prepared_net(const symbolic::CurvePiece& curve) {
  if (!curve.domain || !(curve.domain->lower < curve.domain->upper) || curve.map.degree() < 1) return std::nullopt;
  const auto degree = static_cast<std::size_t>(curve.map.degree());
  PreparedNet net{{{degree}, std::vector<bridge::ExactPoint>(degree + 1)}, {*curve.domain}};
  const std::size_t dimension = curve.map.dimension();
  for (std::size_t k = 0; k <= dimension; ++k) {
    std::vector<Rational> power;
    for (std::size_t i = 0; i <= degree; ++i)
      power.emplace_back(curve.map.coordinates()[k].coefficient(static_cast<long>(i)));
    std::vector<Rational> coefficients = symbolic::bernstein_coefficients(power, *curve.domain);
    for (std::size_t i = 0; i <= degree; ++i) net.exact.points[i][k == dimension ? 3 : k] = std::move(coefficients[i]);
  }
  return net;
}

std::optional<PreparedNet> prepared_net(const symbolic::SurfacePiece& patch) {
  if (patch.map.kind() != symbolic::RationalSurface::Kind::tensor_product || !patch.region || patch.region->triangle)
    return std::nullopt;
  for (const Interval& side : patch.region->sides)
    if (!(side.lower < side.upper)) return std::nullopt;
  const auto m = static_cast<std::size_t>(patch.map.bidegree()[0]);
  const auto n = static_cast<std::size_t>(patch.map.bidegree()[1]);
  if (m == 0 || n == 0) return std::nullopt;
  PreparedNet net{{{m, n}, std::vector<bridge::ExactPoint>((m + 1) * (n + 1))},
                  {patch.region->sides[0], patch.region->sides[1]}};
  for (std::size_t k = 0; k < 4; ++k) {
    // One parameter after the other: table[i][j] of s^i t^j.
    std::vector<std::vector<Rational>> table(m + 1, std::vector<Rational>(n + 1));
    for (const symbolic::Polynomial::Term& term : patch.map.coordinates()[k].terms())
      table[term.exponents[0]][term.exponents[1]] = term.coefficient;
    for (std::vector<Rational>& row : table) row = symbolic::bernstein_coefficients(row, patch.region->sides[1]);
    for (std::size_t j = 0; j <= n; ++j) {
      std::vector<Rational> column;
      for (std::size_t i = 0; i <= m; ++i) column.push_back(table[i][j]);
      column = symbolic::bernstein_coefficients(column, patch.region->sides[0]);
      for (std::size_t i = 0; i <= m; ++i) net.exact.points[i * (n + 1) + j][k] = std::move(column[i]);
    }
  }
  return net;
}

}  // namespace eliminant::intersect
