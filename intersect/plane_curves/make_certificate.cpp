// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/bridge/enclosures/decimal.hpp>
#include <eliminant/intersect/plane_curves/certificate_check.hpp>
#include <eliminant/intersect/plane_curves/make_certificate.hpp>
#include <eliminant/symbolic/elimination/chow_form.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::Polynomial;
using symbolic::Rational;

/// True when x + s y has disjoint enclosures at all points, which are known to about so many digits.
bool separates(const SolutionSet& set, long s, long digits) {
  long magnitude_log2 = 0;
  for (const EnclosedPoint& point : set.points())
    for (const ComplexBall* z : {&point.box.x, &point.box.y})
      for (const arb_srcptr part : {z->real(), z->imaginary()})
        magnitude_log2 = std::max(magnitude_log2, static_cast<long>(arf_abs_bound_lt_2exp_si(arb_midref(part))));
  const long precision_bits = magnitude_log2 + 4 * digits + 64;
  std::vector<ComplexBall> values;
  for (const EnclosedPoint& point : set.points()) {
    ComplexBall& t = values.emplace_back();
    acb_mul_si(t.get(), point.box.y.get(), s, precision_bits);
    acb_add(t.get(), t.get(), point.box.x.get(), precision_bits);
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (acb_overlaps(values[i].get(), values[j].get())) return false;
  return true;
}

/// The first `count` shears in the order 0, 1, -1, 2, ... at which no leading form vanishes and, where `separating` is
/// asked for, the points are told apart.
std::vector<long> choose_shears(const Polynomial& p, const Polynomial& q, const SolutionSet& set, std::size_t count,
                                bool separating, long digits) {
  const symbolic::PrimeField field(symbolic::PrimeSequence(0).next());
  const symbolic::ModularCurve p_modular(p, field);
  const symbolic::ModularCurve q_modular(q, field);
  std::vector<long> shears;
  constexpr int attempts = 4000;
  long s = 0;
  for (int attempt = 0; attempt < attempts && shears.size() < count; ++attempt, s = s > 0 ? -s : 1 - s)
    if (p_modular.leading_form_at(field.reduce(s)) != 0 && q_modular.leading_form_at(field.reduce(s)) != 0 &&
        (!separating || separates(set, s, digits)))
      shears.push_back(s);
  return shears;
}

/// The point with about `digits` digits. Its ball is far larger than the error of its centre: Newton's operator needs
/// room.
CertifiedBall write_ball(SolutionSet& set, std::size_t index, long digits) {
  const auto magnitude_of = [](const ComplexBall& z) {
    return acb_contains_zero(z.get()) != 0 ? 0L : std::max(0L, bridge::decimal_magnitude(z, 15));
  };
  const bridge::PlaneBall& known = set.points()[index].box;
  CertifiedBall ball;
  ball.radius_exponent = std::max(magnitude_of(known.x), magnitude_of(known.y)) - digits;
  const long unit = ball.radius_exponent - 3;
  set.enclose(index, 10 * unit / 3 - 4);
  const EnclosedPoint& point = set.points()[index];
  const auto rounded = [&](arb_srcptr part) { return bridge::round_to_decimal(part, unit).to_rational(); };
  ball.x_real = rounded(point.box.x.real());
  ball.x_imaginary = rounded(point.box.x.imaginary());
  ball.y_real = rounded(point.box.y.real());
  ball.y_imaginary = rounded(point.box.y.imaginary());
  ball.multiplicity = point.multiplicity;
  ball.real = point.reality == Reality::real;
  return ball;
}

}  // namespace

std::optional<Certificate> make_certificate(const PlaneCurvesProblem& problem, const symbolic::CommonComponent& split,
                                            SolutionSet* set, const Context& context) {
  Certificate certificate;
  certificate.variables = problem.variables;
  certificate.p = problem.p;
  certificate.q = problem.q;
  if (!split.component.is_constant() || split.component.is_zero()) certificate.common_component = split.component;
  if (set == nullptr) return certificate;

  bool simple = true;
  unsigned long total = 0;
  for (const EnclosedPoint& point : set->points()) {
    simple = simple && point.multiplicity == 1;
    total += point.multiplicity;
  }
  certificate.at_infinity =
      static_cast<unsigned long>(split.first.total_degree()) * static_cast<unsigned long>(split.second.total_degree()) -
      total;
  constexpr long first_digits = 30;
  constexpr long most_digits = 4000;
  for (long digits = first_digits; digits <= most_digits; digits *= 2) {
    context.checkpoint("writing the certificate");
    certificate.balls.clear();
    for (std::size_t i = 0; i < set->points().size(); ++i) certificate.balls.push_back(write_ball(*set, i, digits));
    if (!simple || certificate.at_infinity > 0)
      certificate.shears = choose_shears(split.first, split.second, *set, simple ? 1 : 2, !simple, digits);
    if (check_certificate(problem, certificate, context).empty()) return certificate;
  }
  return std::nullopt;
}

}  // namespace eliminant::intersect
