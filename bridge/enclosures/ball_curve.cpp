// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/bridge/enclosures/ball_curve.hpp>

namespace eliminant::bridge {

namespace {

/// RAII for a vector of complex balls as FLINT wants it.
class BallVector {
 public:
  explicit BallVector(slong size) : size_(size), value_(_acb_vec_init(size)) {}
  /// 1, z, ..., z^(size - 1), each by as few multiplications as squaring allows: a rectangle grows in each of them.
  BallVector(const ComplexBall& z, slong size, long precision_bits) : BallVector(size) {
    _acb_vec_set_powers(value_, z.get(), size, precision_bits);
  }
  BallVector(const BallVector&) = delete;
  BallVector& operator=(const BallVector&) = delete;
  ~BallVector() { _acb_vec_clear(value_, size_); }
  acb_ptr get() { return value_; }
  acb_srcptr get() const { return value_; }

 private:
  slong size_;
  acb_ptr value_;
};

/// |z| as a real ball, rounded up, and the distance of the corners from the midpoint.
struct Reach {
  RealBall modulus;   ///< upper bound of |z| on the ball
  RealBall distance;  ///< upper bound of |z - midpoint|
};

constexpr long bound_bits = 30;

Reach reach(const ComplexBall& z) {
  Reach result;
  Magnitude bound;
  acb_get_mag(bound.get(), z.get());
  arf_set_mag(arb_midref(result.modulus.get()), bound.get());
  mag_hypot(bound.get(), arb_radref(z.real()), arb_radref(z.imaginary()));
  arf_set_mag(arb_midref(result.distance.get()), bound.get());
  return result;
}

/// Adds an upper bound of a * d + b * e to the error of z, or of its real part only.
void widen(ComplexBall& z, const RealBall& a, const RealBall& d, const RealBall& b, const RealBall& e, bool real) {
  RealBall sum;
  arb_mul(sum.get(), a.get(), d.get(), bound_bits);
  arb_addmul(sum.get(), b.get(), e.get(), bound_bits);
  Magnitude error;
  arb_get_mag(error.get(), sum.get());
  arb_add_error_mag(z.real(), error.get());
  if (!real) arb_add_error_mag(z.imaginary(), error.get());
}

}  // namespace

BallCurve::BallCurve(const symbolic::Polynomial& p) : outer_is_y_(p.degree(0) >= p.degree(1)) {
  rows_ = symbolic::hide_variable(p, outer_is_y_ ? 0 : 1).coefficients;
  for (const auto& row : rows_) row_derivatives_.push_back(row.derivative());
}

BallJet BallCurve::jet(const PlaneBall& point, long precision_bits) const {
  const Sums sums = sum_rows(point, true, precision_bits);
  return outer_is_y_ ? BallJet{sums.value, sums.d_inner, sums.d_outer}
                     : BallJet{sums.value, sums.d_outer, sums.d_inner};
}

ComplexBall BallCurve::value(const PlaneBall& point, long precision_bits) const {
  return sum_rows(point, false, precision_bits).value;
}

BallCurve::Sums BallCurve::sum_rows(const PlaneBall& point, bool with_derivatives, long precision_bits) const {
  Sums sums;
  const auto row_count = static_cast<slong>(rows_.size());
  if (row_count == 0) return sums;
  slong longest = 1;
  for (const auto& row : rows_) longest = std::max(longest, static_cast<slong>(row.degree() + 1));
  const BallVector inner_powers(outer_is_y_ ? point.x : point.y, longest, precision_bits);
  const BallVector outer_powers(outer_is_y_ ? point.y : point.x, row_count, precision_bits);
  BallVector values(row_count);
  const auto evaluate = [&](const std::vector<symbolic::UnivariatePolynomial>& rows) {
    for (slong j = 0; j < row_count; ++j) {
      const fmpz_poly_struct* const row = rows[static_cast<std::size_t>(j)].get();
      acb_dot_fmpz(values.get() + j, nullptr, 0, inner_powers.get(), 1, row->coeffs, 1, fmpz_poly_length(row),
                   precision_bits);
    }
  };
  if (with_derivatives) {
    evaluate(row_derivatives_);
    acb_dot(sums.d_inner.get(), nullptr, 0, values.get(), 1, outer_powers.get(), 1, row_count, precision_bits);
  }
  evaluate(rows_);
  acb_dot(sums.value.get(), nullptr, 0, values.get(), 1, outer_powers.get(), 1, row_count, precision_bits);
  if (with_derivatives) {
    for (slong j = 2; j < row_count; ++j)
      acb_mul_ui(values.get() + j, values.get() + j, static_cast<ulong>(j), precision_bits);
    acb_dot(sums.d_outer.get(), nullptr, 0, values.get() + 1, 1, outer_powers.get(), 1, row_count - 1, precision_bits);
  }
  return sums;
}

BallSlopes BallCurve::slopes_on(const PlaneBall& box, long precision_bits) const {
  BallJet at_middle = jet({midpoint(box.x), midpoint(box.y)}, precision_bits);
  const Reach inner = reach(outer_is_y_ ? box.x : box.y);
  const Reach outer = reach(outer_is_y_ ? box.y : box.x);
  // Second derivatives of the polynomial of absolute coefficients; d_outer2 is half of one.
  RealBall value;
  RealBall d_inner;
  RealBall d_outer;
  RealBall d_inner2;
  RealBall d_inner_outer;
  RealBall d_outer2;
  const auto advance = [&](RealBall& sum, const RealBall& next) {
    arb_mul(sum.get(), sum.get(), outer.modulus.get(), bound_bits);
    arb_add(sum.get(), sum.get(), next.get(), bound_bits);
  };
  RealBall coefficient;
  for (std::size_t j = rows_.size(); j-- > 0;) {
    RealBall row;
    RealBall row_d;
    RealBall row_d2;  // half of the second derivative
    const auto advance_row = [&](RealBall& sum, const RealBall& next) {
      arb_mul(sum.get(), sum.get(), inner.modulus.get(), bound_bits);
      arb_add(sum.get(), sum.get(), next.get(), bound_bits);
    };
    for (long i = rows_[j].degree(); i >= 0; --i) {
      arb_set_round_fmpz(coefficient.get(), fmpz_poly_get_coeff_ptr(rows_[j].get(), i), bound_bits);
      arb_abs(coefficient.get(), coefficient.get());
      advance_row(row_d2, row_d);
      advance_row(row_d, row);
      advance_row(row, coefficient);
    }
    arb_mul_2exp_si(row_d2.get(), row_d2.get(), 1);
    advance(d_outer2, d_outer);
    advance(d_outer, value);
    advance(d_inner_outer, d_inner);
    advance(value, row);
    advance(d_inner, row_d);
    advance(d_inner2, row_d2);
  }
  arb_mul_2exp_si(d_outer2.get(), d_outer2.get(), 1);
  BallSlopes slopes{std::move(at_middle.dx), std::move(at_middle.dy)};
  ComplexBall& inner_slope = outer_is_y_ ? slopes.dx : slopes.dy;
  ComplexBall& outer_slope = outer_is_y_ ? slopes.dy : slopes.dx;
  const bool real = acb_is_real(box.x.get()) != 0 && acb_is_real(box.y.get()) != 0;
  widen(inner_slope, d_inner2, inner.distance, d_inner_outer, outer.distance, real);
  widen(outer_slope, d_inner_outer, inner.distance, d_outer2, outer.distance, real);
  return slopes;
}

}  // namespace eliminant::bridge
