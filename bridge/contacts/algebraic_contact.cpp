// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/algebraic_contact.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/LU>

#include <eliminant/bridge/contacts/contact_conditions.hpp>
#include <eliminant/bridge/nets/ball_patch.hpp>
#include <eliminant/bridge/nets/exact_map.hpp>
#include <eliminant/symbolic/arithmetic/integer_relation.hpp>
#include <eliminant/symbolic/elimination/contact_identity.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::Integer;
using symbolic::Polynomial;
using symbolic::Rational;
using Numbers = std::array<RealBall, 4>;

constexpr long bits = 640;
/// Digits that relations are looked for in; the rest is a reserve.
constexpr long digits = 512;
constexpr std::size_t highest_degree = 8;

RealBall dot(const std::array<RealBall, 3>& a, const std::array<RealBall, 3>& b) {
  RealBall sum;
  for (std::size_t k = 0; k < 3; ++k) arb_addmul(sum.get(), a[k].get(), b[k].get(), bits);
  return sum;
}

std::array<RealBall, 3> cross(const std::array<RealBall, 3>& a, const std::array<RealBall, 3>& b) {
  std::array<RealBall, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    arb_mul(result[k].get(), a[i].get(), b[j].get(), bits);
    arb_submul(result[k].get(), a[j].get(), b[i].get(), bits);
  }
  return result;
}

double middle_of(const RealBall& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

/// As contact_conditions, and the height of the first patch above the tangent plane of the second, not normed.
struct Conditions {
  Eigen::Vector4d value;
  double height = 0;
};

Conditions conditions_at(const BallPatch& first, const BallPatch& second, const Numbers& x) {
  const BallPatch::Jet a = first.jet_at(x[0], x[1]);
  const BallPatch::Jet b = second.jet_at(x[2], x[3]);
  const std::array<RealBall, 3> normal = cross(b.by[0], b.by[1]);
  std::array<RealBall, 3> difference;
  for (std::size_t k = 0; k < 3; ++k) arb_sub(difference[k].get(), a.point[k].get(), b.point[k].get(), bits);
  Conditions result;
  for (std::size_t i = 0; i < 2; ++i) {
    result.value[static_cast<long>(i)] = middle_of(dot(normal, a.by[i]));
    result.value[static_cast<long>(2 + i)] = middle_of(dot(difference, b.by[i]));
  }
  result.height = middle_of(dot(normal, difference));
  return result;
}

/// The common point to all digits; nullopt where there is none, or Newton's method does not converge.
std::optional<Numbers> refined(const ControlNet& first, const ControlNet& second, const ExactNet& exact_first,
                               const ExactNet& exact_second, const std::array<double, 4>& near) {
  PatchJets first_jets(first);
  PatchJets second_jets(second);
  const ContactConditions here =
      contact_conditions(first_jets, second_jets, Eigen::Vector4d(near[0], near[1], near[2], near[3]));
  double size = 0;
  for (const Array4d& point : first.points) size = std::max(size, point.head<3>().abs().maxCoeff());
  constexpr double apart = 1e-11;
  if (!(std::fabs(here.gap) < apart * size)) return std::nullopt;
  const Eigen::Matrix4d inverse = here.jacobian.inverse();
  if (!inverse.allFinite()) return std::nullopt;
  const BallPatch first_patch(exact_first, bits);
  const BallPatch second_patch(exact_second, bits);
  Numbers x;
  for (std::size_t k = 0; k < 4; ++k) arb_set_d(x[k].get(), near[k]);
  // With one matrix each step gains the digits that it has.
  constexpr int most_steps = 60;
  constexpr double gain = 0.01;
  double before = 1e-6;
  for (int step = 0; step < most_steps; ++step) {
    const Conditions conditions = conditions_at(first_patch, second_patch, x);
    const Eigen::Vector4d change = inverse * conditions.value;
    const double moved = change.lpNorm<Eigen::Infinity>();
    if (!(moved < before)) return std::nullopt;
    if (moved < 0x1p-560) {
      if (!(std::fabs(conditions.height) < 0x1p-480 * size)) return std::nullopt;
      return x;
    }
    before = gain * moved;
    for (std::size_t k = 0; k < 4; ++k) {
      RealBall step_k;
      arb_set_d(step_k.get(), change[static_cast<long>(k)]);
      arb_sub(x[k].get(), x[k].get(), step_k.get(), bits);
      arb_get_mid_arb(x[k].get(), x[k].get());
    }
  }
  return std::nullopt;
}

Integer scaled(const RealBall& x) {
  RealBall large;
  arb_mul_2exp_si(large.get(), x.get(), digits);
  Integer result;
  arf_get_fmpz(result.get(), arb_midref(large.get()), ARF_RND_NEAR);
  return result;
}

/// Those of a relation that is no accident have far fewer digits than the numbers.
bool are_small(const std::vector<Integer>& relation) {
  const auto most = static_cast<unsigned long>(digits) / (2 * relation.size());
  return std::all_of(relation.begin(), relation.end(), [&](const Integer& c) { return c.bit_length() < most; });
}

/// The polynomial in the first variable with these coefficients, from the constant term on.
Polynomial polynomial_of(const std::vector<Rational>& coefficients) {
  std::vector<Polynomial::Term> terms;
  for (std::size_t i = 0; i < coefficients.size(); ++i) terms.push_back({coefficients[i], {i, 0}});
  return Polynomial::from_terms(2, terms);
}

Rational rational_of(const RealBall& x, long precision) {
  RealBall rounded;
  arf_set_round(arb_midref(rounded.get()), arb_midref(x.get()), precision, ARF_RND_NEAR);
  Rational result;
  arf_get_fmpq(result.get(), arb_midref(rounded.get()));
  return result;
}

class Recognition {
 public:
  explicit Recognition(const Numbers& x) : x_(x) {
    // A combination that is likely to generate the field of all four.
    constexpr std::array<long, 4> factor{1, 3, 5, 7};
    for (std::size_t k = 0; k < 4; ++k) arb_addmul_si(generator_.get(), x[k].get(), factor[k], bits);
    powers_.emplace_back(Rational(1), bits);
    for (std::size_t k = 1; k <= highest_degree; ++k) {
      powers_.emplace_back();
      arb_mul(powers_[k].get(), powers_[k - 1].get(), generator_.get(), bits);
    }
  }

  /// Of the least degree; its root near the generator is proven.
  std::optional<Polynomial> minimal_polynomial() {
    for (degree_ = 1; degree_ <= highest_degree; ++degree_) {
      std::vector<Integer> numbers;
      for (std::size_t k = 0; k <= degree_; ++k) numbers.push_back(scaled(powers_[k]));
      const std::vector<Integer> relation = symbolic::integer_relation(numbers);
      if (!are_small(relation) || relation.back().is_zero()) continue;
      const Polynomial p = polynomial_of({relation.begin(), relation.end()});
      if (!changes_sign(p)) return std::nullopt;
      return p;
    }
    return std::nullopt;
  }

  /// One of the numbers as a polynomial in the generator.
  std::optional<Polynomial> in_generator(std::size_t index) const {
    std::vector<Integer> numbers;
    for (std::size_t k = 0; k < degree_; ++k) numbers.push_back(scaled(powers_[k]));
    numbers.push_back(scaled(x_[index]));
    const std::vector<Integer> relation = symbolic::integer_relation(numbers);
    if (!are_small(relation) || relation.back().is_zero()) return std::nullopt;
    std::vector<Rational> coefficients;
    double steepness = 0;
    for (std::size_t k = 0; k < degree_; ++k) {
      coefficients.push_back(Rational(0) - Rational(relation[k], relation.back()));
      const RealBall size(coefficients.back(), bits);
      steepness += static_cast<double>(k) * std::fabs(middle_of(size)) *
                   std::pow(std::fabs(middle_of(generator_)) + 1, static_cast<double>(k));
    }
    // The root is within 2^-300 of the generator, and so is this number of its value there.
    RealBall value;
    for (std::size_t k = 0; k < degree_; ++k)
      arb_addmul(value.get(), powers_[k].get(), RealBall(coefficients[k], bits).get(), bits);
    arb_sub(value.get(), value.get(), x_[index].get(), bits);
    if (!(steepness < 0x1p100) || !(std::fabs(middle_of(value)) < 0x1p-300)) return std::nullopt;
    return polynomial_of(coefficients);
  }

 private:
  bool changes_sign(const Polynomial& p) const {
    const Rational middle = rational_of(generator_, bits);
    const RealBall small(
        [] {
          Rational result;
          fmpq_set_si(result.get(), 1, 1);
          fmpq_div_2exp(result.get(), result.get(), 300);
          return result;
        }(),
        bits);
    const Rational reach = rational_of(small, bits);
    const auto sign_at = [&](const Rational& at) {
      const std::array<Polynomial, 2> images{Polynomial::constant(2, at), Polynomial(2)};
      return p.compose(images).constant_term().sign();
    };
    return sign_at(middle - reach) * sign_at(middle + reach) < 0;
  }

  const Numbers& x_;
  RealBall generator_;
  std::vector<RealBall> powers_;
  std::size_t degree_ = 0;
};

}  // namespace

std::optional<std::array<Rational, 4>> algebraic_contact(const ControlNet& first, const ControlNet& second,
                                                         const ExactNet& exact_first, const ExactNet& exact_second,
                                                         const std::array<double, 4>& near) {
  const auto x = refined(first, second, exact_first, exact_second, near);
  if (!x) return std::nullopt;
  Recognition recognition(*x);
  const auto minimal = recognition.minimal_polynomial();
  if (!minimal) return std::nullopt;
  std::array<Polynomial, 4> parameters{Polynomial(2), Polynomial(2), Polynomial(2), Polynomial(2)};
  for (std::size_t k = 0; k < 4; ++k) {
    auto parameter = recognition.in_generator(k);
    if (!parameter) return std::nullopt;
    parameters[k] = *std::move(parameter);
  }
  if (!symbolic::touch_at_roots(coordinates_of(exact_first), coordinates_of(exact_second), *minimal, parameters))
    return std::nullopt;
  std::array<Rational, 4> result;
  constexpr long precision = 192;
  // A constant is the number itself, which decides whether it is a bound of a domain.
  for (std::size_t k = 0; k < 4; ++k)
    result[k] = parameters[k].total_degree() <= 0 ? parameters[k].constant_term() : rational_of((*x)[k], precision);
  return result;
}

}  // namespace eliminant::bridge
