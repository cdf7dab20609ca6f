// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/geometry/rational_surface.hpp>

#include <algorithm>
#include <numeric>

#include <eliminant/base/error.hpp>

namespace eliminant::symbolic {

bool is_form(const Polynomial& p) {
  const auto degree = static_cast<unsigned long>(p.total_degree());
  const std::vector<Polynomial::Term> terms = p.terms();
  return std::all_of(terms.begin(), terms.end(), [&](const Polynomial::Term& term) {
    return std::accumulate(term.exponents.begin(), term.exponents.end(), 0UL) == degree;
  });
}

namespace {

void require_forms_of_one_degree(const std::vector<Polynomial>& coordinates) {
  long degree = -1;
  for (const Polynomial& coordinate : coordinates) {
    if (coordinate.is_zero()) continue;
    if (!is_form(coordinate))
      throw InvalidInput("a coordinate of a map with three parameters is not homogeneous", "forms of one degree");
    if (degree >= 0 && coordinate.total_degree() != degree)
      throw InvalidInput("the coordinates of a map with three parameters have the degrees " + std::to_string(degree) +
                             " and " + std::to_string(coordinate.total_degree()),
                         "forms of one degree");
    degree = coordinate.total_degree();
  }
}

// Divides the gcd over Q out, then makes the coefficients integers without a common factor.
void divide_common_factors_out(std::vector<Polynomial>& coordinates) {
  Polynomial common(coordinates.front().variable_count());
  for (const Polynomial& coordinate : coordinates) {
    if (coordinate.is_zero()) continue;
    if (fmpq_mpoly_gcd(common.get(), common.get(), coordinate.get(), common.ring()) == 0)
      throw LimitReached("the coordinates of a rational surface are too large for their greatest common divisor");
    if (common.is_constant()) break;
  }
  if (!common.is_constant())
    for (Polynomial& coordinate : coordinates)
      if (!coordinate.is_zero()) coordinate = exact_quotient(coordinate, common);
  Rational content;
  for (const Polynomial& coordinate : coordinates) {
    if (coordinate.is_zero()) continue;
    Rational own;
    fmpq_mpoly_content(own.get(), coordinate.get(), coordinate.ring());
    fmpq_gcd(content.get(), content.get(), own.get());
  }
  for (Polynomial& coordinate : coordinates) coordinate = (Rational(1) / content) * coordinate;
}

}  // namespace

RationalSurface::RationalSurface(Kind kind, std::vector<Polynomial> coordinates)
    : kind_(kind), coordinates_(std::move(coordinates)) {
  if (coordinates_.size() != 4)
    throw InvalidInput("a rational surface has " + std::to_string(coordinates_.size()) + " homogeneous coordinates",
                       "four, the weight last");
  const std::size_t parameters = kind_ == Kind::triangular ? 3 : 2;
  for (const Polynomial& coordinate : coordinates_)
    if (coordinate.variable_count() != parameters)
      throw InvalidInput(
          "a coordinate of a rational surface has " + std::to_string(coordinate.variable_count()) + " variables",
          "polynomials in the " + std::to_string(parameters) + " parameters");
  if (std::all_of(coordinates_.begin(), coordinates_.end(), [](const Polynomial& p) { return p.is_zero(); }))
    throw InvalidInput("all coordinates of a rational surface are zero", "a coordinate that is not zero");
  if (kind_ == Kind::triangular) require_forms_of_one_degree(coordinates_);
  divide_common_factors_out(coordinates_);
  for (const Polynomial& coordinate : coordinates_) {
    if (kind_ == Kind::triangular) {
      degrees_[0] = std::max(degrees_[0], coordinate.total_degree());
    } else {
      degrees_[0] = std::max(degrees_[0], coordinate.degree(0));
      degrees_[1] = std::max(degrees_[1], coordinate.degree(1));
    }
  }
}

std::vector<Rational> RationalSurface::at(const std::vector<Rational>& parameters) const {
  if (parameters.size() != coordinates_.front().variable_count())
    throw InvalidInput(
        "a point of a rational surface was asked for at " + std::to_string(parameters.size()) + " parameters",
        std::to_string(coordinates_.front().variable_count()) + " parameters");
  std::vector<const fmpq*> values;
  for (const Rational& value : parameters) values.push_back(value.get());
  std::vector<Rational> point(coordinates_.size());
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Polynomial& coordinate = coordinates_[i];
    // FLINT takes an array of pointers to values that it does not change.
    if (fmpq_mpoly_evaluate_all_fmpq(point[i].get(), coordinate.get(), const_cast<fmpq* const*>(values.data()),
                                     coordinate.ring()) == 0)
      throw LimitReached("a point of a rational surface is too large to evaluate");
  }
  return point;
}

}  // namespace eliminant::symbolic
