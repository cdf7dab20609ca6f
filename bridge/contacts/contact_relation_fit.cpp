// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/contacts/contact_relation_fit.hpp>

#include <cmath>
#include <utility>

#include <Eigen/QR>
#include <Eigen/SVD>

#include <eliminant/bridge/rounding/simple_fraction.hpp>

namespace eliminant::bridge {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using symbolic::Polynomial;
using symbolic::Rational;

using Points = std::vector<std::array<double, 4>>;
/// Exponents of a and b.
using Monomial = std::array<unsigned long, 2>;

/// A value this small beside others is a rounded zero.
constexpr double rounded_zero = 1e-11;
/// Beside this the accuracy of coefficients suffices.
constexpr double well_conditioned = 1e-6;

VectorXd values_of(const Monomial& monomial, const Points& points) {
  VectorXd values(static_cast<long>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    values[static_cast<long>(i)] = std::pow(points[i][0], static_cast<double>(monomial[0])) *
                                   std::pow(points[i][1], static_cast<double>(monomial[1]));
  return values;
}

std::optional<Rational> fraction_of(double value) {
  constexpr double accuracy = 1e-10;
  constexpr double largest_denominator = 0x1p15;
  return simple_fraction(value, accuracy, largest_denominator);
}

std::optional<Polynomial> polynomial_of(const std::vector<Monomial>& monomials, const VectorXd& coefficients) {
  std::vector<Polynomial::Term> terms;
  for (std::size_t i = 0; i < monomials.size(); ++i) {
    const auto fraction = fraction_of(coefficients[static_cast<long>(i)]);
    if (!fraction) return std::nullopt;
    terms.push_back({*fraction, {monomials[i][0], monomials[i][1]}});
  }
  return Polynomial::from_terms(2, terms);
}

/// The one polynomial with these monomials that vanishes at the points.
std::optional<Polynomial> vanishing(const std::vector<Monomial>& monomials, const Points& points) {
  MatrixXd matrix(points.size(), monomials.size());
  for (std::size_t k = 0; k < monomials.size(); ++k) matrix.col(static_cast<long>(k)) = values_of(monomials[k], points);
  const Eigen::JacobiSVD<MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const VectorXd sizes = svd.singularValues();
  const long last = sizes.size() - 1;
  if (!(sizes[last] < rounded_zero * sizes[0]) || !(sizes[last - 1] > well_conditioned * sizes[0])) return std::nullopt;
  VectorXd coefficients = svd.matrixV().col(last);
  long largest = 0;
  coefficients.cwiseAbs().maxCoeff(&largest);
  coefficients /= coefficients[largest];
  return polynomial_of(monomials, coefficients);
}

std::optional<Polynomial> curve_through(const Points& points) {
  static const std::vector<std::vector<Monomial>> shapes{
      {{0, 0}, {1, 0}},
      {{0, 0}, {0, 1}},
      {{0, 0}, {1, 0}, {0, 1}},
      {{0, 0}, {1, 0}, {0, 1}, {1, 1}},
      {{0, 0}, {1, 0}, {0, 1}, {2, 0}},
      {{0, 0}, {1, 0}, {0, 1}, {0, 2}},
      {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}},
      {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {2, 1}},
      {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}},
      {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {2, 1}, {1, 2}, {2, 2}},
      {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}},
  };
  for (const std::vector<Monomial>& shape : shapes)
    if (auto curve = vanishing(shape, points)) return curve;
  return std::nullopt;
}

/// Numerator and denominator.
using Quotient = std::pair<Polynomial, Polynomial>;

/// Columns that do not depend on one another.
class IndependentColumns {
 public:
  explicit IndependentColumns(std::size_t rows) : orthogonal_(rows, 0) {}

  /// False where the column depends on those before.
  bool take(const VectorXd& column) {
    VectorXd rest = column;
    for (int round = 0; round < 2; ++round) rest -= orthogonal_ * (orthogonal_.transpose() * rest);
    if (!(rest.norm() > well_conditioned * column.norm())) return false;
    orthogonal_.conservativeResize(Eigen::NoChange, orthogonal_.cols() + 1);
    orthogonal_.rightCols(1) = rest.normalized();
    return true;
  }

 private:
  MatrixXd orthogonal_;
};

/// The coordinate as a quotient with the monomials of `above` and `below`, the constant term of the denominator 1; of
/// monomials that depend on those before them along the curve none is used.
std::optional<Quotient> quotient_with(const std::vector<Monomial>& above, const std::vector<Monomial>& below,
                                      std::size_t coordinate, const Points& points) {
  VectorXd target(static_cast<long>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) target[static_cast<long>(i)] = points[i][coordinate];
  IndependentColumns columns(points.size());
  MatrixXd used(points.size(), 0);
  std::vector<std::pair<bool, Monomial>> kept;
  const auto take = [&](const VectorXd& column, bool is_above, const Monomial& monomial) {
    if (!columns.take(column)) return;
    used.conservativeResize(Eigen::NoChange, used.cols() + 1);
    used.rightCols(1) = column;
    kept.emplace_back(is_above, monomial);
  };
  for (const Monomial& monomial : above) take(values_of(monomial, points), true, monomial);
  // A denominator that is constant along the curve would be one times the coordinate itself.
  IndependentColumns denominators(points.size());
  denominators.take(values_of({0, 0}, points));
  for (const Monomial& monomial : below) {
    const VectorXd values = values_of(monomial, points);
    if (denominators.take(values)) take(values.cwiseProduct(target), false, monomial);
  }
  const VectorXd coefficients = used.colPivHouseholderQr().solve(target);
  if (!((used * coefficients - target).lpNorm<Eigen::Infinity>() < rounded_zero)) return std::nullopt;
  Quotient result{Polynomial(2), Polynomial::constant(2, 1)};
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto fraction = fraction_of(coefficients[static_cast<long>(i)]);
    if (!fraction) return std::nullopt;
    const std::array<Polynomial::Term, 1> term{{{*fraction, {kept[i].second[0], kept[i].second[1]}}}};
    const Polynomial p = Polynomial::from_terms(2, term);
    if (kept[i].first)
      result.first = result.first + p;
    else
      result.second = result.second - p;
  }
  return result;
}

std::optional<Quotient> quotient_for(std::size_t coordinate, const Points& points) {
  using Shape = std::pair<std::vector<Monomial>, std::vector<Monomial>>;
  static const std::vector<Shape> shapes{
      {{{0, 0}, {1, 0}, {0, 1}}, {}},
      {{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {}},
      {{{0, 0}, {1, 0}}, {{1, 0}}},
      {{{0, 0}, {0, 1}}, {{0, 1}}},
      {{{0, 0}, {1, 0}, {2, 0}}, {{1, 0}, {2, 0}}},
      {{{0, 0}, {0, 1}, {0, 2}}, {{0, 1}, {0, 2}}},
      {{{0, 0}, {1, 0}, {2, 0}, {3, 0}}, {}},
      {{{0, 0}, {0, 1}, {0, 2}, {0, 3}}, {}},
      {{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}}, {}},
      {{{0, 0}, {1, 0}, {0, 1}}, {{1, 0}, {0, 1}}},
      {{{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{1, 0}, {0, 1}, {1, 1}}},
      {{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}, {2, 1}, {1, 2}, {2, 2}}, {}},
  };
  for (const auto& [above, below] : shapes)
    if (auto quotient = quotient_with(above, below, coordinate, points)) return quotient;
  return std::nullopt;
}

}  // namespace

std::optional<symbolic::ContactRelation> contact_relation_fit(const Points& points) {
  const auto curve = curve_through(points);
  if (!curve || curve->is_constant()) return std::nullopt;
  symbolic::ContactRelation relation;
  relation.curve = curve->primitive_part();
  for (std::size_t k = 0; k < 2; ++k) {
    auto quotient = quotient_for(2 + k, points);
    if (!quotient) return std::nullopt;
    relation.numerator[k] = std::move(quotient->first);
    relation.denominator[k] = std::move(quotient->second);
  }
  return relation;
}

}  // namespace eliminant::bridge
