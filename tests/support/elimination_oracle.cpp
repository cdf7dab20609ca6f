// SPDX-License-Identifier: BSD-3-Clause
#include <support/elimination_oracle.hpp>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <eliminant/symbolic/arithmetic/rational_univariate.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>
#include <support/bezier_problems.hpp>

namespace eliminant::test {

namespace {

using bridge::RealBall;
using symbolic::Integer;
using symbolic::Interval;
using symbolic::Polynomial;
using symbolic::Rational;
using symbolic::RationalUnivariate;
using symbolic::UnivariatePolynomial;

/// Coefficient of s^i t^j, integers.
using Grid = std::vector<std::vector<Integer>>;

/// What the curve meets: coordinates as grids, the weight last. A curve has one column.
struct Target {
  std::vector<Grid> coordinates;
  std::size_t m = 0;
  std::size_t n = 0;
};

Target target_of(const BezierCase& bezier) {
  Target target;
  if (bezier.in_plane()) {
    const auto map = symbolic::bezier_curve(exact_polygon(bezier.second, true)).map;
    target.m = static_cast<std::size_t>(map.degree());
    for (const UnivariatePolynomial& f : map.coordinates()) {
      Grid& grid = target.coordinates.emplace_back(target.m + 1, std::vector<Integer>(1));
      for (std::size_t i = 0; i <= target.m; ++i) grid[i][0] = f.coefficient(static_cast<long>(i));
    }
    return target;
  }
  const auto map = symbolic::bezier_patch(exact_net(bezier.patch)).map;
  target.m = static_cast<std::size_t>(map.bidegree()[0]);
  target.n = static_cast<std::size_t>(map.bidegree()[1]);
  for (const Polynomial& f : map.coordinates()) {
    Grid& grid = target.coordinates.emplace_back(target.m + 1, std::vector<Integer>(target.n + 1));
    for (const Polynomial::Term& term : f.terms())
      grid[term.exponents[0]][term.exponents[1]] = term.coefficient.numerator();
  }
  return target;
}

Integer value_at(const UnivariatePolynomial& f, const Integer& t) {
  Integer result;
  fmpz_poly_evaluate_fmpz(result.get(), f.get(), t.get());
  return result;
}

struct IntegerMatrix {
  IntegerMatrix(std::size_t order) { fmpz_mat_init(value, static_cast<slong>(order), static_cast<slong>(order)); }
  IntegerMatrix(const IntegerMatrix&) = delete;
  IntegerMatrix& operator=(const IntegerMatrix&) = delete;
  ~IntegerMatrix() { fmpz_mat_clear(value); }
  fmpz_mat_t value;
};

/// The determinant of the products of the forms w_P x - x_P w, w_P y - y_P w, ... with all monomials of bidegree
/// (2 m - 1, n - 1); for a curve of degree m - 1. Each column is linear in the point P.
Integer determinant_at(const Target& target, const std::vector<Integer>& point) {
  const std::size_t forms = target.coordinates.size() - 1;
  const bool curve = forms == 2;
  const std::size_t shifts_s = curve ? target.m : 2 * target.m;
  const std::size_t shifts_t = curve ? 1 : target.n;
  const std::size_t order = forms * shifts_s * shifts_t;
  const std::size_t width = curve ? 1 : 2 * target.n;
  IntegerMatrix matrix(order);
  std::size_t column = 0;
  for (std::size_t k = 0; k < forms; ++k)
    for (std::size_t a = 0; a < shifts_s; ++a)
      for (std::size_t b = 0; b < shifts_t; ++b, ++column)
        for (std::size_t i = 0; i < target.coordinates[k].size(); ++i)
          for (std::size_t j = 0; j < target.coordinates[k][i].size(); ++j) {
            const Integer entry =
                point[forms] * target.coordinates[k][i][j] - point[k] * target.coordinates[forms][i][j];
            fmpz_set(
                fmpz_mat_entry(matrix.value, static_cast<slong>((i + a) * width + j + b), static_cast<slong>(column)),
                entry.get());
          }
  Integer result;
  fmpz_mat_det(result.get(), matrix.value);
  return result;
}

/// The polynomial over Z, up to a factor, of degree below the number of these values.
UnivariatePolynomial interpolated(const std::vector<Integer>& at, const std::vector<Rational>& values) {
  // Newton's divided differences.
  std::vector<Rational> differences = values;
  for (std::size_t k = 1; k < at.size(); ++k)
    for (std::size_t i = at.size(); i-- > k;)
      differences[i] = (differences[i] - differences[i - 1]) / Rational(at[i] - at[i - k]);
  RationalUnivariate sum;
  for (std::size_t i = at.size(); i-- > 0;) {
    RationalUnivariate factor;
    const Rational constant = -Rational(at[i]);
    fmpq_poly_set_coeff_si(factor.get(), 1, 1);
    fmpq_poly_set_coeff_fmpq(factor.get(), 0, constant.get());
    RationalUnivariate difference;
    fmpq_poly_set_fmpq(difference.get(), differences[i].get());
    fmpq_poly_mul(sum.get(), sum.get(), factor.get());
    fmpq_poly_add(sum.get(), sum.get(), difference.get());
  }
  return sum.numerator().primitive_part();
}

// Parts of the domain in ball arithmetic.

constexpr long bits = 400;

/// Values of one linear form in the control points of a part of the patch.
using FormNet = std::vector<std::vector<RealBall>>;

bool has_one_sign(const FormNet& net) {
  bool positive = true;
  bool negative = true;
  for (const auto& row : net)
    for (const RealBall& value : row) {
      positive = positive && arb_is_positive(value.get()) != 0;
      negative = negative && arb_is_negative(value.get()) != 0;
    }
  return positive || negative;
}

/// Of one polygon, into its halves.
void halve(const std::vector<RealBall>& polygon, std::vector<RealBall>& lower, std::vector<RealBall>& upper) {
  std::vector<RealBall> level = polygon;
  const std::size_t count = level.size();
  lower.assign(count, {});
  upper.assign(count, {});
  for (std::size_t k = 0; k < count; ++k) {
    lower[k] = level[0];
    upper[count - 1 - k] = level[count - 1 - k];
    for (std::size_t i = 0; i + 1 < count - k; ++i) {
      arb_add(level[i].get(), level[i].get(), level[i + 1].get(), bits);
      arb_mul_2exp_si(level[i].get(), level[i].get(), -1);
    }
  }
}

FormNet transposed(const FormNet& net) {
  FormNet result(net.front().size(), std::vector<RealBall>(net.size()));
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t j = 0; j < net[i].size(); ++j) result[j][i] = net[i][j];
  return result;
}

std::array<FormNet, 2> halves(const FormNet& net, bool first_parameter) {
  const FormNet rows = first_parameter ? transposed(net) : net;
  std::array<FormNet, 2> result;
  for (const auto& row : rows) halve(row, result[0].emplace_back(), result[1].emplace_back());
  if (first_parameter)
    for (FormNet& half : result) half = transposed(half);
  return result;
}

bool apart(const std::vector<FormNet>& forms, int depth, bool plane) {
  constexpr int deepest = 160;
  if (std::any_of(forms.begin(), forms.end(), has_one_sign)) return true;
  if (depth == deepest) return false;
  std::array<std::vector<FormNet>, 2> parts;
  for (const FormNet& form : forms) {
    auto both = halves(form, plane || depth % 2 == 0);
    for (std::size_t k = 0; k < 2; ++k) parts[k].push_back(std::move(both[k]));
  }
  return apart(parts[0], depth + 1, plane) && apart(parts[1], depth + 1, plane);
}

}  // namespace

symbolic::RationalCurve curve_map(const BezierCase& bezier) {
  return symbolic::bezier_curve(exact_polygon(bezier.curve, bezier.in_plane())).map;
}

UnivariatePolynomial eliminated(const BezierCase& bezier) {
  const symbolic::RationalCurve curve = curve_map(bezier);
  const Target target = target_of(bezier);
  const bool plane = bezier.in_plane();
  const std::size_t degree_of_target = plane ? target.m : 2 * target.m * target.n;
  const std::size_t extraneous = plane ? target.m : 4 * target.m * target.n;
  const std::size_t needed = degree_of_target * static_cast<std::size_t>(curve.degree()) + 1;
  const UnivariatePolynomial weight = curve.coordinates().back().primitive_part();
  std::vector<Integer> at;
  std::vector<Rational> values;
  for (long k = 0; at.size() < needed; ++k) {
    const Integer t(k % 2 == 0 ? k / 2 : -(k + 1) / 2);
    const Integer divisor = power(value_at(weight, t), extraneous);
    if (divisor.is_zero()) continue;
    std::vector<Integer> point;
    for (const UnivariatePolynomial& f : curve.coordinates()) point.push_back(value_at(f, t));
    at.push_back(t);
    values.push_back(Rational(determinant_at(target, point), divisor));
  }
  return interpolated(at, values);
}

std::optional<UnivariatePolynomial> substituted_in_graph(const BezierCase& bezier) {
  if (bezier.in_plane()) return std::nullopt;
  const auto patch = symbolic::bezier_patch(exact_net(bezier.patch)).map;
  const auto& [x, y, z, w] =
      std::tie(patch.coordinates()[0], patch.coordinates()[1], patch.coordinates()[2], patch.coordinates()[3]);
  const auto slope = [&](const Polynomial& f, std::size_t axis) -> std::optional<Rational> {
    const Rational factor = f.derivative(axis).constant_term();
    if (factor.is_zero() || !(f == factor * Polynomial::variable(2, axis))) return std::nullopt;
    return factor;
  };
  const auto slope_x = slope(x, 0);
  const auto slope_y = slope(y, 1);
  const symbolic::RationalCurve curve = curve_map(bezier);
  const UnivariatePolynomial& weight = curve.coordinates().back();
  if (!slope_x || !slope_y || !w.is_constant() || weight.degree() != 0) return std::nullopt;
  // In affine coordinates s = x w / slope_x.
  std::vector<Polynomial> affine;
  for (std::size_t k = 0; k < 3; ++k) {
    std::vector<Polynomial::Term> terms;
    for (long i = 0; i <= curve.coordinates()[k].degree(); ++i)
      terms.push_back(
          {Rational(curve.coordinates()[k].coefficient(i), weight.coefficient(0)), {static_cast<unsigned long>(i)}});
    affine.push_back(w.constant_term() * Polynomial::from_terms(1, terms));
  }
  const std::vector<Polynomial> parameters{(Rational(1) / *slope_x) * affine[0], (Rational(1) / *slope_y) * affine[1]};
  const Polynomial difference = (z.compose(parameters) - affine[2]).primitive_part();
  std::vector<Integer> coefficients(static_cast<std::size_t>(std::max(difference.degree(0), 0L)) + 1);
  for (const Polynomial::Term& term : difference.terms())
    coefficients[term.exponents[0]] = term.coefficient.numerator();
  return UnivariatePolynomial(coefficients);
}

long sturm_count_in_unit_interval(const UnivariatePolynomial& squarefree) {
  // t = 1 / (1 + x) maps the positive x to (0, 1).
  UnivariatePolynomial moebius;
  fmpz_poly_reverse(moebius.get(), squarefree.get(), squarefree.degree() + 1);
  const Integer one(1);
  fmpz_poly_taylor_shift(moebius.get(), moebius.get(), one.get());
  // Roots at t = 0 and 1 are x at infinity and 0.
  slong zeros = 0;
  while (fmpz_is_zero(fmpz_poly_get_coeff_ptr(moebius.get(), zeros)) != 0) ++zeros;
  fmpz_poly_shift_right(moebius.get(), moebius.get(), zeros);
  slong negative = 0;
  slong positive = 0;
  if (moebius.degree() > 0)
    _fmpz_poly_num_real_roots_sturm(&negative, &positive, moebius.get()->coeffs, moebius.degree() + 1);
  return positive;
}

bool proven_apart(const BezierCase& bezier, const RealBall& t) {
  std::vector<RealBall> point;
  const symbolic::RationalCurve curve = curve_map(bezier);
  for (const UnivariatePolynomial& f : curve.coordinates()) {
    RealBall& value = point.emplace_back();
    arb_fmpz_poly_evaluate_arb(value.get(), f.get(), t.get(), bits);
  }
  std::vector<std::vector<symbolic::ControlPoint>> net;
  if (bezier.in_plane())
    for (const auto& control : exact_polygon(bezier.second, true)) net.push_back({control});
  else
    net = exact_net(bezier.patch);
  std::vector<FormNet> forms;
  const std::size_t last = point.size() - 1;
  for (std::size_t k = 0; k < last; ++k) {
    FormNet& form = forms.emplace_back();
    for (const auto& row : net) {
      form.emplace_back();
      for (const auto& control : row) {
        RealBall value;
        const RealBall coordinate(control[k], bits);
        const RealBall weight(control[last], bits);
        arb_mul(value.get(), point[last].get(), coordinate.get(), bits);
        arb_submul(value.get(), point[k].get(), weight.get(), bits);
        form.back().push_back(value);
      }
    }
  }
  return apart(forms, 0, bezier.in_plane());
}

}  // namespace eliminant::test
