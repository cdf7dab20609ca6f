// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/intersect/plane_curves/certificate_check.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using bridge::midpoint;
using bridge::RealBall;
using symbolic::Polynomial;
using symbolic::Rational;
using symbolic::UnivariatePolynomial;

/// A step of the check that does not come out; the text is what the user is told.
struct Refusal {
  std::string reason;
};

struct PointBall {
  ComplexBall x, y;
};

std::string ball_name(std::size_t index) { return "ball " + std::to_string(index + 1); }

Rational power_of_ten(long exponent) {
  const symbolic::Integer power =
      symbolic::power(symbolic::Integer(10), static_cast<unsigned long>(std::labs(exponent)));
  return exponent >= 0 ? Rational(power) : Rational(symbolic::Integer(1), power);
}

ComplexBall complex_ball(const Rational& real, const Rational& imaginary, long precision_bits) {
  ComplexBall result;
  arb_set_fmpq(result.real(), real.get(), precision_bits);
  arb_set_fmpq(result.imaginary(), imaginary.get(), precision_bits);
  return result;
}

/// A polynomial and its partial derivatives, to be evaluated in balls by the powers of both variables.
class Curve {
 public:
  explicit Curve(const Polynomial& p) : value_(p.terms()), dx_(p.derivative(0).terms()), dy_(p.derivative(1).terms()) {
    x_degree_ = std::max(0L, p.degree(0));
    y_degree_ = std::max(0L, p.degree(1));
  }
  struct Jet {
    ComplexBall value, dx, dy;
  };
  Jet at(const PointBall& z, long precision_bits) const {
    const std::vector<ComplexBall> x_powers = powers(z.x, x_degree_, precision_bits);
    const std::vector<ComplexBall> y_powers = powers(z.y, y_degree_, precision_bits);
    const auto sum_of = [&](const std::vector<Polynomial::Term>& terms) {
      ComplexBall sum;
      ComplexBall term;
      RealBall coefficient;
      for (const Polynomial::Term& each : terms) {
        acb_mul(term.get(), x_powers[each.exponents[0]].get(), y_powers[each.exponents[1]].get(), precision_bits);
        arb_set_fmpq(coefficient.get(), each.coefficient.get(), precision_bits);
        acb_mul_arb(term.get(), term.get(), coefficient.get(), precision_bits);
        acb_add(sum.get(), sum.get(), term.get(), precision_bits);
      }
      return sum;
    };
    return {sum_of(value_), sum_of(dx_), sum_of(dy_)};
  }

 private:
  static std::vector<ComplexBall> powers(const ComplexBall& z, long degree, long precision_bits) {
    std::vector<ComplexBall> result(static_cast<std::size_t>(degree) + 1);
    acb_one(result[0].get());
    for (std::size_t i = 1; i < result.size(); ++i)
      acb_mul(result[i].get(), result[i - 1].get(), z.get(), precision_bits);
    return result;
  }
  std::vector<Polynomial::Term> value_, dx_, dy_;
  long x_degree_ = 0;
  long y_degree_ = 0;
};

/// The value of the leading form of p at (-s, 1).
Rational leading_form_at(const Polynomial& p, long s) {
  Rational sum;
  const auto degree = static_cast<unsigned long>(p.total_degree());
  for (const Polynomial::Term& term : p.terms())
    if (term.exponents[0] + term.exponents[1] == degree)
      sum = sum + term.coefficient * Rational(symbolic::power(symbolic::Integer(-s), term.exponents[0]));
  return sum;
}

/// The leading form of p at (x, 1).
UnivariatePolynomial leading_form(const Polynomial& p) {
  UnivariatePolynomial form;
  const auto degree = static_cast<unsigned long>(p.total_degree());
  for (const Polynomial::Term& term : p.primitive_part().terms())
    if (term.exponents[0] + term.exponents[1] == degree)
      fmpz_poly_set_coeff_fmpz(form.get(), static_cast<slong>(term.exponents[0]), term.coefficient.numerator().get());
  return form;
}

/// No common zero of the leading forms, neither with y = 1 nor (1 : 0).
bool leading_forms_coprime(const Polynomial& p, const Polynomial& q) {
  const UnivariatePolynomial f = leading_form(p);
  const UnivariatePolynomial g = leading_form(q);
  return symbolic::gcd(f, g).degree() == 0 && (f.degree() == p.total_degree() || g.degree() == q.total_degree());
}

/// RAII for a vector of integers as FLINT wants it.
class IntegerVector {
 public:
  explicit IntegerVector(slong size) : size_(size), value_(_fmpz_vec_init(size)) {}
  IntegerVector(const IntegerVector&) = delete;
  IntegerVector& operator=(const IntegerVector&) = delete;
  ~IntegerVector() { _fmpz_vec_clear(value_, size_); }
  fmpz* get() const { return value_; }

 private:
  slong size_;
  fmpz* value_;
};

/// Res_y(p(t - s y, y), q(t - s y, y)) in Z[t] up to a constant, by its values at one more integer than its degree can
/// be.
UnivariatePolynomial eliminant(const Polynomial& p, const Polynomial& q, long s, const Context& context) {
  const Polynomial t = Polynomial::variable(2, 0);
  const Polynomial y = Polynomial::variable(2, 1);
  const std::array<Polynomial, 2> line{t - Rational(s) * y, y};
  const symbolic::HiddenVariablePolynomial f = symbolic::hide_variable(p.compose(line).primitive_part(), 0);
  const symbolic::HiddenVariablePolynomial g = symbolic::hide_variable(q.compose(line).primitive_part(), 0);
  const auto restrict_to = [](const symbolic::HiddenVariablePolynomial& h, const symbolic::Integer& value) {
    UnivariatePolynomial result;
    symbolic::Integer coefficient;
    for (std::size_t j = 0; j < h.coefficients.size(); ++j) {
      fmpz_poly_evaluate_fmpz(coefficient.get(), h.coefficients[j].get(), value.get());
      fmpz_poly_set_coeff_fmpz(result.get(), static_cast<slong>(j), coefficient.get());
    }
    return result;
  };
  const long count = p.total_degree() * q.total_degree() + 1;
  const IntegerVector points(count);
  const IntegerVector values(count);
  UnivariatePolynomial result;
  for (long k = 0; k < count; ++k) {
    context.checkpoint("eliminant of the certificate");
    fmpz_set_si(points.get() + k, k % 2 == 0 ? k / 2 : -(k + 1) / 2);
    const symbolic::Integer value(points.get() + k);
    fmpz_poly_resultant(values.get() + k, restrict_to(f, value).get(), restrict_to(g, value).get());
  }
  fmpz_poly_interpolate_fmpz_vec(result.get(), points.get(), values.get(), count);
  return result;
}

/// The check of one certificate about the coprime curves p = q = 0, none of them constant.
class Check {
 public:
  Check(const Polynomial& p, const Polynomial& q, const Certificate& certificate, const Context& context)
      : p_(p), q_(q), p_curve_(p), q_curve_(q), certificate_(certificate), context_(context) {
    // Enough for the centre's distance from the origin beside the radius: rounding must not make balls larger.
    long finest = 0;
    long largest = 0;
    for (const CertifiedBall& ball : certificate.balls) {
      finest = std::min(finest, ball.radius_exponent);
      for (const Rational* part : {&ball.x_real, &ball.x_imaginary, &ball.y_real, &ball.y_imaginary})
        largest = std::max(largest, static_cast<long>(part->numerator().bit_length()) -
                                        static_cast<long>(part->denominator().bit_length()));
    }
    precision_bits_ = 512 - 16 * finest + 4 * largest;
    for (std::size_t i = 0; i < certificate.balls.size(); ++i) boxes_.push_back(box_of(i));
  }

  void run() {
    check_disjoint();
    for (std::size_t i = 0; i < certificate_.balls.size(); ++i) {
      context_.checkpoint("checking balls");
      check_reality(i);
      if (certificate_.balls[i].multiplicity == 1) check_interval_newton(i);
    }
    check_count();
  }

 private:
  using Discs = std::vector<ComplexBall>;

  PointBall centre_of(std::size_t i) const {
    const CertifiedBall& ball = certificate_.balls[i];
    return {complex_ball(ball.x_real, ball.x_imaginary, precision_bits_),
            complex_ball(ball.y_real, ball.y_imaginary, precision_bits_)};
  }

  /// A box around the ball.
  PointBall box_of(std::size_t i) const {
    PointBall box = centre_of(i);
    const RealBall radius(power_of_ten(certificate_.balls[i].radius_exponent), precision_bits_);
    for (ComplexBall* coordinate : {&box.x, &box.y}) {
      arb_add_error(coordinate->real(), radius.get());
      arb_add_error(coordinate->imaginary(), radius.get());
    }
    return box;
  }

  /// A box inside the ball: of seven tenths of the radius, so that its corners are inside. What is enclosed in it lies
  /// in the ball that is claimed, whatever was rounded.
  PointBall core_of(std::size_t i) const {
    PointBall core = centre_of(i);
    const Rational inner = Rational(7) / Rational(10) * power_of_ten(certificate_.balls[i].radius_exponent);
    const RealBall radius(inner, precision_bits_);
    bridge::Magnitude error;
    arb_get_mag_lower(error.get(), radius.get());
    for (ComplexBall* coordinate : {&core.x, &core.y}) {
      arb_add_error_mag(coordinate->real(), error.get());
      arb_add_error_mag(coordinate->imaginary(), error.get());
    }
    return core;
  }

  void check_disjoint() const {
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (acb_overlaps(boxes_[i].x.get(), boxes_[j].x.get()) && acb_overlaps(boxes_[i].y.get(), boxes_[j].y.get()))
          throw Refusal{ball_name(j) + " and " + ball_name(i) + " meet"};
  }

  void check_reality(std::size_t i) const {
    const CertifiedBall& ball = certificate_.balls[i];
    const bool real_centre = ball.x_imaginary.is_zero() && ball.y_imaginary.is_zero();
    const bool off_the_plane =
        !arb_contains_zero(boxes_[i].x.imaginary()) || !arb_contains_zero(boxes_[i].y.imaginary());
    if (ball.real && !real_centre) throw Refusal{ball_name(i) + " is said to be real, but its centre is not"};
    if (!ball.real && !off_the_plane)
      throw Refusal{ball_name(i) + " is said not to be real, but it meets the real plane"};
  }

  void check_interval_newton(std::size_t i) const {
    const PointBall& box = boxes_[i];
    const PointBall m{midpoint(box.x), midpoint(box.y)};
    const Curve::Jet p_on_box = p_curve_.at(box, precision_bits_);
    const Curve::Jet q_on_box = q_curve_.at(box, precision_bits_);
    const ComplexBall p_at_m = p_curve_.at(m, precision_bits_).value;
    const ComplexBall q_at_m = q_curve_.at(m, precision_bits_).value;
    const auto determinant = [&](const ComplexBall& a, const ComplexBall& b, const ComplexBall& c,
                                 const ComplexBall& d) {
      ComplexBall result;
      ComplexBall product;
      acb_mul(result.get(), a.get(), d.get(), precision_bits_);
      acb_mul(product.get(), b.get(), c.get(), precision_bits_);
      acb_sub(result.get(), result.get(), product.get(), precision_bits_);
      return result;
    };
    const ComplexBall jacobian = determinant(p_on_box.dx, p_on_box.dy, q_on_box.dx, q_on_box.dy);
    if (acb_contains_zero(jacobian.get())) throw Refusal{ball_name(i) + ": the Jacobian may vanish in it"};
    const auto image = [&](const ComplexBall& centre, const ComplexBall& numerator) {
      ComplexBall result;
      acb_div(result.get(), numerator.get(), jacobian.get(), precision_bits_);
      acb_sub(result.get(), centre.get(), result.get(), precision_bits_);
      return result;
    };
    const ComplexBall x = image(m.x, determinant(p_at_m, p_on_box.dy, q_at_m, q_on_box.dy));
    const ComplexBall y = image(m.y, determinant(p_on_box.dx, p_at_m, q_on_box.dx, q_at_m));
    const PointBall core = core_of(i);
    if (!acb_contains(core.x.get(), x.get()) || !acb_contains(core.y.get(), y.get()))
      throw Refusal{ball_name(i) + ": Newton's operator does not map its box into it"};
  }

  void check_count() const {
    unsigned long total = 0;
    bool simple = true;
    for (const CertifiedBall& ball : certificate_.balls) {
      if (ball.multiplicity < 1 || ball.multiplicity > bezout_number())
        throw Refusal{"a multiplicity of " + std::to_string(ball.multiplicity) + " is impossible"};
      total += ball.multiplicity;
      simple = simple && ball.multiplicity == 1;
    }
    const std::vector<long>& shears = certificate_.shears;
    if (shears.size() > 2 || (shears.size() == 2 && shears[0] == shears[1]))
      throw Refusal{"a proof needs none, one or two different shears"};
    if (shears.size() < 2 && !simple)
      throw Refusal{"a multiplicity above 1 needs two shears, " + std::to_string(shears.size()) + " are given"};
    unsigned long expected = bezout_number();
    if (shears.empty() && !leading_forms_coprime(p_, q_))
      throw Refusal{"the leading forms have a common factor, which needs a shear"};
    std::vector<UnivariatePolynomial> eliminants;
    for (const long s : shears) {
      if (leading_form_at(p_, s).is_zero() || leading_form_at(q_, s).is_zero())
        throw Refusal{"a leading form vanishes in the direction of the shear " + std::to_string(s)};
      eliminants.push_back(eliminant(p_, q_, s, context_));
      if (eliminants.back().is_zero()) throw Refusal{"the curves have a common component that is not given"};
      expected = static_cast<unsigned long>(eliminants.back().degree());
    }
    if (total != expected)
      throw Refusal{"the multiplicities add up to " + std::to_string(total) + ", the solutions to " +
                    std::to_string(expected)};
    if (certificate_.at_infinity != bezout_number() - expected)
      throw Refusal{std::to_string(certificate_.at_infinity) + " solutions are said to be at infinity, there are " +
                    std::to_string(bezout_number() - expected)};
    if (shears.size() == 2) check_fibres(isolate(eliminants[0], shears[0]), isolate(eliminants[1], shears[1]));
  }

  unsigned long bezout_number() const {
    return static_cast<unsigned long>(p_.total_degree()) * static_cast<unsigned long>(q_.total_degree());
  }

  /// Step 5: a disc for each ball, the one root of the eliminant in it, all roots being in one.
  Discs isolate(const UnivariatePolynomial& eliminant, long shear) const {
    Discs discs(certificate_.balls.size());
    const std::string name = "the eliminant of shear " + std::to_string(shear);
    std::vector<symbolic::SquarefreeFactor> factors;
    if (eliminant.degree() > 0) factors = symbolic::squarefree_decomposition(eliminant);
    std::size_t covered = 0;
    for (const symbolic::SquarefreeFactor& part : factors) {
      const UnivariatePolynomial slope = part.factor.derivative();
      long found = 0;
      for (std::size_t i = 0; i < discs.size(); ++i) {
        const CertifiedBall& ball = certificate_.balls[i];
        if (ball.multiplicity != part.multiplicity) continue;
        ++found;
        const Rational s(shear);
        const ComplexBall t = midpoint(
            complex_ball(ball.x_real + s * ball.y_real, ball.x_imaginary + s * ball.y_imaginary, precision_bits_));
        ComplexBall value;
        ComplexBall derivative;
        arb_fmpz_poly_evaluate_acb(value.get(), part.factor.get(), t.get(), precision_bits_);
        arb_fmpz_poly_evaluate_acb(derivative.get(), slope.get(), t.get(), precision_bits_);
        if (acb_contains_zero(derivative.get())) throw Refusal{ball_name(i) + " isolates no root of " + name};
        acb_div(value.get(), value.get(), derivative.get(), precision_bits_);
        bridge::Magnitude radius;
        acb_get_mag(radius.get(), value.get());
        mag_mul_ui(radius.get(), radius.get(), static_cast<mp_limb_t>(part.factor.degree()));
        discs[i] = t;
        acb_add_error_mag(discs[i].get(), radius.get());
      }
      if (found != part.factor.degree())
        throw Refusal{name + " has " + std::to_string(part.factor.degree()) + " roots of multiplicity " +
                      std::to_string(part.multiplicity) + ", the certificate " + std::to_string(found)};
      covered += static_cast<std::size_t>(found);
    }
    if (covered != discs.size()) throw Refusal{name + " has no roots of a multiplicity in the certificate"};
    for (std::size_t i = 0; i < discs.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (acb_overlaps(discs[i].get(), discs[j].get()))
          throw Refusal{ball_name(j) + " and " + ball_name(i) + " do not isolate roots of " + name};
    return discs;
  }

  void check_fibres(const Discs& first, const Discs& second) const {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      context_.checkpoint("checking fibres");
      if (certificate_.balls[i].multiplicity == 1) {
        // Its solution lies above one of the discs, and it is this one.
        ComplexBall t;
        acb_mul_si(t.get(), boxes_[i].y.get(), certificate_.shears[0], precision_bits_);
        acb_add(t.get(), t.get(), boxes_[i].x.get(), precision_bits_);
        for (std::size_t j = 0; j < first.size(); ++j)
          if (j != i && acb_overlaps(t.get(), first[j].get()))
            throw Refusal{ball_name(i) + " may lie above the same root as " + ball_name(j)};
        continue;
      }
      const PointBall own = crossing(first[i], second[i]);
      const PointBall core = core_of(i);
      if (!acb_contains(core.x.get(), own.x.get()) || !acb_contains(core.y.get(), own.y.get()))
        throw Refusal{ball_name(i) + " does not hold the solution that the eliminants name"};
      for (std::size_t j = 0; j < second.size(); ++j) {
        if (j == i) continue;
        const PointBall other = crossing(first[i], second[j]);
        if (acb_contains_zero(p_curve_.at(other, precision_bits_).value.get()) &&
            acb_contains_zero(q_curve_.at(other, precision_bits_).value.get()))
          throw Refusal{ball_name(i) + " may share its multiplicity with another solution"};
      }
    }
  }

  /// The point with x + s_1 y = t, x + s_2 y = u.
  PointBall crossing(const ComplexBall& t, const ComplexBall& u) const {
    PointBall point;
    acb_sub(point.y.get(), t.get(), u.get(), precision_bits_);
    acb_div_si(point.y.get(), point.y.get(), certificate_.shears[0] - certificate_.shears[1], precision_bits_);
    acb_mul_si(point.x.get(), point.y.get(), certificate_.shears[0], precision_bits_);
    acb_sub(point.x.get(), t.get(), point.x.get(), precision_bits_);
    return point;
  }

  const Polynomial& p_;
  const Polynomial& q_;
  Curve p_curve_;
  Curve q_curve_;
  const Certificate& certificate_;
  const Context& context_;
  long precision_bits_ = 0;
  std::vector<PointBall> boxes_;
};

void check(const PlaneCurvesProblem& problem, const Certificate& certificate, const Context& context) {
  const Polynomial& p = problem.p;
  const Polynomial& q = problem.q;
  if (problem.variables != certificate.variables) throw Refusal{"the certificate is about other variables"};
  constexpr long largest_shear = 1L << 30;
  for (const long s : certificate.shears)
    if (s < -largest_shear || s > largest_shear) throw Refusal{"a shear is larger than 2^30"};
  if (!(p == certificate.p) || !(q == certificate.q)) throw Refusal{"the certificate is about other polynomials"};
  Polynomial first = p;
  Polynomial second = q;
  if (certificate.common_component) {
    const Polynomial& component = *certificate.common_component;
    if (component.is_zero() || (p.is_zero() && q.is_zero())) {
      if (!component.is_zero()) throw Refusal{"both polynomials are zero, the common component is not"};
      if (!p.is_zero() || !q.is_zero()) throw Refusal{"the common component is 0, the polynomials are not"};
    } else {
      if (component.is_constant()) throw Refusal{"the common component is constant"};
      try {
        first = symbolic::exact_quotient(p, component);
        second = symbolic::exact_quotient(q, component);
      } catch (const InvalidInput&) {
        throw Refusal{"the common component does not divide both polynomials"};
      }
    }
  } else if ((p.is_zero() && !q.is_constant()) || (q.is_zero() && !p.is_constant()) || (p.is_zero() && q.is_zero())) {
    throw Refusal{"the curves have a common component that is not given"};
  }
  if (!first.is_constant() && !second.is_constant()) {
    Check(first, second, certificate, context).run();
  } else if (!certificate.balls.empty() || certificate.at_infinity != 0) {
    throw Refusal{"there are balls, but no solutions: a polynomial is constant"};
  } else if ((first.is_zero() && !second.is_constant()) || (second.is_zero() && !first.is_constant())) {
    throw Refusal{"the common component is not the greatest common divisor"};
  }
}

}  // namespace

std::vector<std::string> check_certificate(const PlaneCurvesProblem& problem, const Certificate& certificate,
                                           const Context& context) {
  try {
    check(problem, certificate, context);
  } catch (const Refusal& refusal) {
    return {refusal.reason};
  }
  return {};
}

}  // namespace eliminant::intersect
