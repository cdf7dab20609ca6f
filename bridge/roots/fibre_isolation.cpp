// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/roots/fibre_isolation.hpp>

#include <algorithm>
#include <array>
#include <numeric>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/roots/descartes_isolation.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/symbolic/elimination/curve_events.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::HiddenVariablePolynomial;
using symbolic::Rational;
using symbolic::UnivariatePolynomial;

/// A polynomial with ball coefficients.
class BallPolynomial {
 public:
  BallPolynomial() { arb_poly_init(value_); }
  BallPolynomial(const BallPolynomial&) = delete;
  BallPolynomial& operator=(const BallPolynomial&) = delete;
  ~BallPolynomial() { arb_poly_clear(value_); }
  arb_poly_struct* get() { return value_; }
  const arb_poly_struct* get() const { return value_; }

 private:
  arb_poly_t value_;
};

Rational midpoint_of(const Rational& lower, const Rational& upper) { return (lower + upper) / Rational(2); }

/// The ball 0 +- radius.
RealBall around_zero(const Rational& radius, long precision_bits) {
  RealBall ball(radius, precision_bits);
  Magnitude bound;
  arb_get_mag(bound.get(), ball.get());
  arb_zero(ball.get());
  arb_add_error_mag(ball.get(), bound.get());
  return ball;
}

/// p over [lower, upper], by its Taylor expansion about the midpoint.
RealBall on_interval(const BallPolynomial& p, const Rational& lower, const Rational& upper, long derivative,
                     long precision_bits) {
  BallPolynomial shifted;
  const RealBall middle(midpoint_of(lower, upper), precision_bits);
  arb_poly_taylor_shift(shifted.get(), p.get(), middle.get(), precision_bits);
  for (long k = 0; k < derivative; ++k) arb_poly_derivative(shifted.get(), shifted.get(), precision_bits);
  RealBall value;
  const RealBall step = around_zero(upper - midpoint_of(lower, upper), precision_bits);
  arb_poly_evaluate(value.get(), shifted.get(), step.get(), precision_bits);
  return value;
}

bool excludes_zero(const RealBall& value) { return arb_contains_zero(value.get()) == 0; }

int sign_of(const RealBall& value) {
  return arb_is_positive(value.get()) != 0 ? 1 : arb_is_negative(value.get()) != 0 ? -1 : 0;
}

/// 2^exponent.
Rational power_of_two(long exponent) {
  Rational value(1);
  if (exponent >= 0)
    fmpz_mul_2exp(fmpq_numref(value.get()), fmpq_numref(value.get()), static_cast<ulong>(exponent));
  else
    fmpz_mul_2exp(fmpq_denref(value.get()), fmpq_denref(value.get()), static_cast<ulong>(-exponent));
  return value;
}

/// The greatest power of two that is at most the number, which is positive.
Rational power_of_two_below(const Rational& value) {
  const auto bits = [](const symbolic::Integer& n) { return static_cast<long>(n.bit_length()); };
  long exponent = bits(value.numerator()) - bits(value.denominator());
  if (value < power_of_two(exponent)) --exponent;
  return power_of_two(exponent);
}

/// The number rounded to a multiple of a power of two.
Rational rounded_to(const Rational& value, const Rational& unit) {
  const Rational quotient = value / unit + Rational(1) / Rational(2);
  symbolic::Integer floor;
  fmpz_fdiv_q(floor.get(), fmpq_numref(quotient.get()), fmpq_denref(quotient.get()));
  return Rational(floor) * unit;
}

Rational exact_midpoint(const RealBall& ball) {
  Rational value;
  arf_get_fmpq(value.get(), arb_midref(ball.get()));
  return value;
}

Rational exact_radius(const RealBall& ball) {
  RealBall radius;
  arb_get_rad_arb(radius.get(), ball.get());
  return exact_midpoint(radius);
}

/// One separation of a fibre.
class FibreSeparation {
 public:
  FibreSeparation(const HiddenVariablePolynomial& g, const Rational& left, const Rational& right, long precision_bits,
                  const Context& context)
      : precision_bits_(precision_bits), context_(context) {
    for (std::size_t k = 0; k < g.coefficients.size(); ++k) {
      BallPolynomial coefficient;
      arb_poly_set_fmpz_poly(coefficient.get(), g.coefficients[k].get(), precision_bits);
      const RealBall over_all = on_interval(coefficient, left, right, 0, precision_bits);
      arb_poly_set_coeff_arb(family_.get(), static_cast<slong>(k), over_all.get());
      arb_poly_set_coeff_arb(reversed_.get(), g.degree() - static_cast<slong>(k), over_all.get());
    }
  }

  FibreIsolation run(const std::vector<MultipleFibrePoint>& multiple, long degree_drop) {
    if (!find_bound(degree_drop) || !enclose_multiple(multiple)) return std::move(result_);
    Rational lower = -result_.bound;
    const std::vector<FibreInterval> boxes = std::move(result_.intervals);
    result_.intervals.clear();
    for (std::size_t i = 0; i <= boxes.size(); ++i) {
      const Rational upper = i < boxes.size() ? boxes[i].lower : result_.bound;
      if (lower < upper && !separate_simple({lower, sign_at(lower)}, {upper, sign_at(upper)}, 0))
        return std::move(result_);
      if (i == boxes.size()) break;
      result_.intervals.push_back(boxes[i]);
      lower = boxes[i].upper;
    }
    result_.state = FibreIsolation::State::isolated;
    return std::move(result_);
  }

 private:
  RealBall value(const Rational& lower, const Rational& upper, long derivative) const {
    return on_interval(family_, lower, upper, derivative, precision_bits_);
  }
  int sign_at(const Rational& y) const { return sign_of(value(y, y, 0)); }

  /// A neighbourhood |1/y| <= 1/bound of infinity with no root but infinity itself at alpha.
  bool find_bound(long degree_drop) {
    RealBall at_infinity;
    arb_poly_get_coeff_arb(at_infinity.get(), reversed_.get(), degree_drop);
    if (!excludes_zero(at_infinity)) return false;
    // Not below 1: a bound that shrank with X would leave no room for the multiple points.
    constexpr long smallest_exponent = 0;
    const long largest_exponent = 64 + 4 * precision_bits_;
    for (long exponent = smallest_exponent; exponent <= largest_exponent; ++exponent) {
      const Rational zeta = power_of_two(-exponent);
      if (!excludes_zero(on_interval(reversed_, -zeta, zeta, degree_drop, precision_bits_))) continue;
      result_.bound = power_of_two(exponent);
      return excludes_zero(on_interval(reversed_, zeta, zeta, 0, precision_bits_)) &&
             excludes_zero(on_interval(reversed_, -zeta, -zeta, 0, precision_bits_));
    }
    return false;
  }

  bool enclose_multiple(const std::vector<MultipleFibrePoint>& multiple) {
    std::vector<std::size_t> order(multiple.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return arf_cmp(arb_midref(multiple[a].y.get()), arb_midref(multiple[b].y.get())) < 0;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Rational middle = exact_midpoint(multiple[order[i]].y);
      Rational room = result_.bound - (middle.sign() < 0 ? -middle : middle);
      if (i > 0) room = std::min(room, middle - exact_midpoint(multiple[order[i - 1]].y), std::less<>());
      if (i + 1 < order.size()) room = std::min(room, exact_midpoint(multiple[order[i + 1]].y) - middle, std::less<>());
      if (room.sign() <= 0) {
        result_.state = FibreIsolation::State::wide_points;
        return false;
      }
      if (!enclose_multiple(multiple[order[i]], order[i], middle, power_of_two_below(room / Rational(3)))) return false;
    }
    return true;
  }

  bool enclose_multiple(const MultipleFibrePoint& point, std::size_t index, const Rational& middle, Rational radius) {
    const Rational least = Rational(4) * exact_radius(point.y);
    constexpr int most_halvings = 4000;
    for (int step = 0; step < most_halvings; ++step, radius = radius / Rational(2)) {
      if (radius < least || radius.is_zero()) {
        result_.state = FibreIsolation::State::wide_points;
        return false;
      }
      // Short numbers: the ends take part in exact arithmetic.
      const Rational center = rounded_to(middle, radius / Rational(8));
      const FibreInterval interval{center - radius, center + radius, index};
      if (!excludes_zero(value(interval.lower, interval.upper, point.multiplicity))) {
        // The derivative at the point itself decides whether smaller boxes may help.
        RealBall derivative;
        BallPolynomial shifted;
        arb_poly_taylor_shift(shifted.get(), family_.get(), point.y.get(), precision_bits_);
        arb_poly_get_coeff_arb(derivative.get(), shifted.get(), point.multiplicity);
        if (!excludes_zero(derivative)) return false;
        continue;
      }
      if (sign_at(interval.lower) == 0 || sign_at(interval.upper) == 0) return false;
      result_.intervals.push_back(interval);
      return true;
    }
    return false;
  }

  struct End {
    Rational y;
    int sign = 0;
  };

  /// The simple roots between two ends at which the signs are known.
  bool separate_simple(const End& lower, const End& upper, long depth) {
    if (lower.sign == 0 || upper.sign == 0) return false;
    if (excludes_zero(value(lower.y, upper.y, 0))) return true;
    if (excludes_zero(value(lower.y, upper.y, 1))) {
      if (lower.sign != upper.sign) result_.intervals.push_back({lower.y, upper.y, std::nullopt});
      return true;
    }
    if (depth > 64 + 2 * precision_bits_) return false;
    context_.checkpoint("isolating a fibre");
    constexpr std::array sixteenths{8, 6, 10, 7, 9, 5, 11};
    for (const int part : sixteenths) {
      const Rational y = lower.y + (upper.y - lower.y) * Rational(part) / Rational(16);
      const End middle{y, sign_at(y)};
      if (middle.sign != 0)
        return separate_simple(lower, middle, depth + 1) && separate_simple(middle, upper, depth + 1);
    }
    return false;
  }

  long precision_bits_;
  const Context& context_;
  BallPolynomial family_;
  BallPolynomial reversed_;
  FibreIsolation result_;
};

}  // namespace

FibreIsolation isolate_fibre(const HiddenVariablePolynomial& g, const Rational& left, const Rational& right,
                             const std::vector<MultipleFibrePoint>& multiple, long degree_drop, long precision_bits,
                             const Context& context) {
  return FibreSeparation(g, left, right, precision_bits, context).run(multiple, degree_drop);
}

RealBall refine_simple_root(const HiddenVariablePolynomial& g, const RealBall& alpha, const FibreInterval& interval,
                            long precision_bits) {
  BallPolynomial at_alpha;
  for (std::size_t k = 0; k < g.coefficients.size(); ++k) {
    RealBall coefficient;
    arb_fmpz_poly_evaluate_arb(coefficient.get(), g.coefficients[k].get(), alpha.get(), precision_bits);
    arb_poly_set_coeff_arb(at_alpha.get(), static_cast<slong>(k), coefficient.get());
  }
  RealBall root;
  arb_union(root.get(), RealBall(interval.lower, precision_bits).get(), RealBall(interval.upper, precision_bits).get(),
            precision_bits);
  const auto value_at = [&](const RealBall& y) {
    RealBall value;
    arb_poly_evaluate(value.get(), at_alpha.get(), y.get(), precision_bits);
    return value;
  };
  const int sign_below = sign_of(value_at(RealBall(interval.lower, precision_bits)));
  const long most_steps = 4 * precision_bits;
  for (long step = 0; step < most_steps; ++step) {
    RealBall center;
    arb_get_mid_arb(center.get(), root.get());
    BallPolynomial shifted;
    arb_poly_taylor_shift(shifted.get(), at_alpha.get(), center.get(), precision_bits);
    RealBall value;
    arb_poly_get_coeff_arb(value.get(), shifted.get(), 0);
    arb_poly_derivative(shifted.get(), shifted.get(), precision_bits);
    RealBall offset;
    arb_sub(offset.get(), root.get(), center.get(), precision_bits);
    RealBall slope;
    arb_poly_evaluate(slope.get(), shifted.get(), offset.get(), precision_bits);
    RealBall next;
    arb_div(next.get(), value.get(), slope.get(), precision_bits);
    arb_sub(next.get(), center.get(), next.get(), precision_bits);
    RealBall common;
    Rational goal = exact_radius(root) * Rational(3) / Rational(4);
    const bool meets =
        arb_is_finite(next.get()) != 0 && arb_intersection(common.get(), root.get(), next.get(), precision_bits) != 0;
    if (!meets || goal < exact_radius(common)) {
      // Newton's method is not there yet: the half with the change of sign.
      const int sign = sign_of(value);
      if (sign == 0 || sign_below == 0) {
        if (meets) root = common;
        break;
      }
      RealBall end;
      if (sign == sign_below)
        arb_get_ubound_arf(arb_midref(end.get()), root.get(), precision_bits);
      else
        arb_get_lbound_arf(arb_midref(end.get()), root.get(), precision_bits);
      arb_union(common.get(), center.get(), end.get(), precision_bits);
    }
    if (!(exact_radius(common) < exact_radius(root))) break;
    root = common;
  }
  return root;
}

RationalFibre::RationalFibre(const HiddenVariablePolynomial& g, const Rational& x, const Context& context)
    : polynomial_(symbolic::on_vertical_line(g, x)), context_(context) {
  if (polynomial_.degree() < 1) return;
  const UnivariatePolynomial repeated = symbolic::gcd(polynomial_, polynomial_.derivative());
  if (repeated.degree() > 0) fmpz_poly_div(polynomial_.get(), polynomial_.get(), repeated.get());
  const IsolatedRoots isolated = IsolatedRoots::real(polynomial_, context);
  for (const ComplexBall& root : isolated.balls()) roots_.emplace_back(root.real());
}

int RationalFibre::position(std::size_t index, const Rational& y) {
  if (arb_contains_fmpq(roots_[index].get(), y.get()) != 0 && symbolic::sign_at(polynomial_, y) == 0) return 0;
  for (long bits = 32; arb_contains_fmpq(roots_[index].get(), y.get()) != 0; bits *= 2) refined(index, bits);
  return exact_midpoint(roots_[index]) < y ? -1 : 1;
}

std::size_t RationalFibre::count_below(const Rational& y) {
  std::size_t below = 0;
  while (below < roots_.size() && position(below, y) < 0) ++below;
  return below;
}

const RealBall& RationalFibre::refined(std::size_t index, long relative_bits) {
  if (arb_is_exact(roots_[index].get()) == 0) refine_real_root(polynomial_, roots_[index], relative_bits, context_);
  return roots_[index];
}

}  // namespace eliminant::bridge
