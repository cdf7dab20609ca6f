// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/nets/ball_patch.hpp>

#include <cstddef>

#include <eliminant/bridge/nets/taylor_tables.hpp>

namespace eliminant::bridge {

namespace {

constexpr std::size_t weight = 3;

}  // namespace

BallPatch::BallPatch(const ExactNet& net, long precision_bits)
    : precision_bits_(precision_bits), degree_{net.degrees[0], net.degrees[1]} {
  const TaylorTable<symbolic::Rational> table = taylor_at(net, {0, 0}, degree_[0] + degree_[1]);
  const symbolic::Rational unit = table.at(0, 0)[weight];
  for (std::size_t i = 0; i <= degree_[0]; ++i)
    for (std::size_t j = 0; j <= degree_[1]; ++j)
      polynomial_ = polynomial_ && (i + j == 0 || table.at(i, j)[weight].is_zero());
  polynomial_ = polynomial_ && !unit.is_zero();
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i <= degree_[0]; ++i)
      for (std::size_t j = 0; j <= degree_[1]; ++j) {
        const symbolic::Rational& coefficient = table.at(i, j)[k];
        coefficients_[k].emplace_back(polynomial_ ? coefficient / unit : coefficient, precision_bits_);
      }
}

RealBall BallPatch::coordinate_at(std::size_t k, const RealBall& u, const RealBall& v) const {
  // Horner's scheme in u, of Horner's schemes in v.
  RealBall sum;
  const std::size_t columns = degree_[1] + 1;
  for (std::size_t i = degree_[0] + 1; i-- > 0;) {
    RealBall row = coefficients_[k][i * columns + columns - 1];
    for (std::size_t j = columns - 1; j-- > 0;) {
      arb_mul(row.get(), row.get(), v.get(), precision_bits_);
      arb_add(row.get(), row.get(), coefficients_[k][i * columns + j].get(), precision_bits_);
    }
    arb_mul(sum.get(), sum.get(), u.get(), precision_bits_);
    arb_add(sum.get(), sum.get(), row.get(), precision_bits_);
  }
  return sum;
}

std::array<RealBall, 3> BallPatch::point_at(const RealBall& u, const RealBall& v) const {
  std::array<RealBall, 3> point;
  for (std::size_t k = 0; k < 3; ++k) point[k] = coordinate_at(k, u, v);
  if (polynomial_) return point;
  const RealBall divisor = coordinate_at(weight, u, v);
  for (RealBall& coordinate : point) arb_div(coordinate.get(), coordinate.get(), divisor.get(), precision_bits_);
  return point;
}

std::array<RealBall, 3> BallPatch::coordinate_jet_at(std::size_t k, const RealBall& u, const RealBall& v) const {
  const auto times_plus = [&](RealBall& sum, const RealBall& factor, const RealBall& term) {
    arb_mul(sum.get(), sum.get(), factor.get(), precision_bits_);
    arb_add(sum.get(), sum.get(), term.get(), precision_bits_);
  };
  std::array<RealBall, 3> jet;
  const std::size_t columns = degree_[1] + 1;
  for (std::size_t i = degree_[0] + 1; i-- > 0;) {
    RealBall row;
    RealBall slope;
    for (std::size_t j = columns; j-- > 0;) {
      times_plus(slope, v, row);
      times_plus(row, v, coefficients_[k][i * columns + j]);
    }
    times_plus(jet[1], u, jet[0]);
    times_plus(jet[0], u, row);
    times_plus(jet[2], u, slope);
  }
  return jet;
}

BallPatch::Jet BallPatch::jet_at(const RealBall& u, const RealBall& v) const {
  std::array<std::array<RealBall, 3>, 4> of;
  for (std::size_t k = 0; k < 4; ++k) of[k] = coordinate_jet_at(k, u, v);
  Jet jet;
  for (std::size_t k = 0; k < 3; ++k) {
    arb_div(jet.point[k].get(), of[k][0].get(), of[weight][0].get(), precision_bits_);
    for (std::size_t p = 0; p < 2; ++p) {
      RealBall& slope = jet.by[p][k];
      arb_set(slope.get(), of[k][1 + p].get());
      arb_submul(slope.get(), jet.point[k].get(), of[weight][1 + p].get(), precision_bits_);
      arb_div(slope.get(), slope.get(), of[weight][0].get(), precision_bits_);
    }
  }
  return jet;
}

}  // namespace eliminant::bridge
