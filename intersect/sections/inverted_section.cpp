// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/sections/inverted_section.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/sections/common_zeros.hpp>
#include <eliminant/intersect/sections/implicit_section.hpp>
#include <eliminant/intersect/sections/section_factors.hpp>
#include <eliminant/intersect/whole_surfaces/surface_charts.hpp>
#include <eliminant/symbolic/elimination/linear_inversion.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::LinearInversion;
using symbolic::LinearParameter;
using symbolic::Polynomial;
using symbolic::RationalSurface;

/// A linear form in doubles.
struct LinearForm {
  std::array<DoubleInterval, 4> coefficients{};

  explicit LinearForm(const Polynomial& form) {
    for (const auto& term : form.terms())
      for (std::size_t i = 0; i < 4; ++i)
        if (term.exponents[i] == 1) coefficients[i] = enclose(term.coefficient);
  }
  DoubleInterval at(const std::array<DoubleInterval, 3>& point) const {
    DoubleInterval sum = coefficients[3];
    for (std::size_t i = 0; i < 3; ++i) sum = sum + coefficients[i] * point[i];
    return sum;
  }
};

/// Parameters of points in doubles.
class ParameterReader {
 public:
  explicit ParameterReader(const std::vector<LinearParameter>& quotients) {
    for (const LinearParameter& q : quotients) forms_.emplace_back(LinearForm(q.numerator), LinearForm(q.denominator));
  }

  struct Bounded {
    double value;
    double radius;
  };

  /// For all points within the radius, by the quotient that is farthest from 0/0; of an infinite value the radius
  /// bounds the inverse. Infinite where nothing is known.
  Bounded at(const std::array<double, 3>& point, double radius) const {
    const std::array<DoubleInterval, 3> ball{DoubleInterval::around(point[0], radius),
                                             DoubleInterval::around(point[1], radius),
                                             DoubleInterval::around(point[2], radius)};
    Bounded result{NAN, INFINITY};
    double largest = -1;
    for (const auto& [numerator, denominator] : forms_) {
      const DoubleInterval a = numerator.at(ball);
      const DoubleInterval b = denominator.at(ball);
      const double size = std::max(std::fabs(middle(a)), std::fabs(middle(b)));
      if (!(size > largest)) continue;
      largest = size;
      if (b.excludes_zero()) {
        const DoubleInterval value = a / b;
        result = {middle(value), DoubleInterval::around(0, width(value)).upper};
      } else {
        result = {INFINITY, a.excludes_zero() ? (b / a).magnitude() : INFINITY};
      }
    }
    return result;
  }

  double middle_at(const std::array<double, 3>& point) const {
    double largest = -1;
    double result = NAN;
    for (const auto& [numerator, denominator] : forms_) {
      const std::array<DoubleInterval, 3> ball{DoubleInterval(point[0]), DoubleInterval(point[1]),
                                               DoubleInterval(point[2])};
      const double a = middle(numerator.at(ball));
      const double b = middle(denominator.at(ball));
      const double size = std::max(std::fabs(a), std::fabs(b));
      if (!(size > largest)) continue;
      largest = size;
      result = b == 0 ? INFINITY : a / b;
    }
    return result;
  }

 private:
  std::vector<std::pair<LinearForm, LinearForm>> forms_;
};

/// The form F on the surface without multiplicities and without the factors that divide the weight: its real zeros are
/// those of F at finite points of space, and limits of them.
BidegreeForm reduced_section(const RationalSurface& surface, const Polynomial& form, std::uint64_t seed) {
  const Polynomial section = form.compose(surface.coordinates());
  BidegreeForm result{Polynomial::constant(2, 1), {0, 0}};
  for (const SectionFactor& factor : section_factors(surface, section, seed))
    if (factor.kind != SectionFactorKind::at_infinity) result.polynomial = result.polynomial * factor.factor;
  const std::array<long, 2> bidegree = surface.bidegree();
  for (std::size_t k = 0; k < 2; ++k) {
    const bool vanishes = section.degree(k) < form.total_degree() * bidegree[k];
    const bool weight_vanishes = surface.coordinates()[3].degree(k) < bidegree[k];
    result.degrees[k] = result.polynomial.degree(k) + (vanishes && !weight_vanishes ? 1 : 0);
  }
  return result;
}

/// Where F is zero on the other surface, not all witnesses of the inversion are.
bool has_unique_parameters(const RationalSurface& surface, const LinearInversion& inversion, const Options& options,
                           const Context& context) {
  if (inversion.is_inverse_everywhere()) return true;
  const std::array<long, 2> bidegree = surface.bidegree();
  std::vector<BidegreeForm> forms{reduced_section(surface, inversion.equation, options.seed)};
  for (const Polynomial& witness : inversion.witnesses) {
    const long degree = witness.total_degree();
    forms.push_back({witness.compose(surface.coordinates()), {degree * bidegree[0], degree * bidegree[1]}});
  }
  std::vector<BidegreeForm> coordinates;
  for (const Polynomial& coordinate : surface.coordinates()) coordinates.push_back({coordinate, bidegree});
  return have_no_common_real_zero(forms, coordinates, context);
}

/// Adds (s, t) to all points. False when the error of a singular point cannot be bounded.
bool lift(SurfaceResult& result, const LinearInversion& inversion) {
  const std::array<ParameterReader, 2> readers{ParameterReader(inversion.parameters[0]),
                                               ParameterReader(inversion.parameters[1])};
  for (SurfaceComponent& component : result.components)
    for (SurfacePoint& point : component.points)
      for (std::size_t k = 0; k < 2; ++k) point.parameters[2 + k] = readers[k].middle_at(point.point);
  for (SurfaceSingularPoint& singular : result.singular_points)
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [value, radius] = readers[k].at(singular.at.point, singular.radius);
      if (!std::isfinite(radius)) return false;
      singular.at.parameters[2 + k] = value;
      singular.radius = std::max(singular.radius, radius);
    }
  return true;
}

/// The section of `surface` by the one that has inverses.
std::optional<SurfaceResult> section(const RationalSurface& surface, const LinearInversion& inversion,
                                     const Options& options, const Context& context) {
  const std::array<Polynomial, 4> affine{Polynomial::variable(3, 0), Polynomial::variable(3, 1),
                                         Polynomial::variable(3, 2), Polynomial::constant(3, 1)};
  const Polynomial equation = inversion.equation.compose(affine);
  if (equation.is_constant() || inversion.equation.compose(surface.coordinates()).is_zero()) return std::nullopt;
  if (!has_unique_parameters(surface, inversion, options, context)) return std::nullopt;
  SurfaceResult result = intersect_surface_with_equation(symbolic::ParametricSurface{{{surface, std::nullopt}}},
                                                         equation, options, context);
  if (result.limit) throw LimitReached(*result.limit);
  if (result.status != Status::certified || !lift(result, inversion)) return std::nullopt;
  return result;
}

}  // namespace

std::optional<SurfaceResult> intersect_by_inversion(const RationalSurface& first, const RationalSurface& second,
                                                    const Options& options, const Context& context) {
  std::array<std::optional<LinearInversion>, 2> inversions{symbolic::linear_inversion(first),
                                                           symbolic::linear_inversion(second)};
  const auto degree = [&](std::size_t k) { return inversions[k] ? inversions[k]->equation.total_degree() : 100; };
  const std::size_t better = degree(0) < degree(1) ? 0 : 1;
  for (const std::size_t inverted : {better, 1 - better}) {
    if (!inversions[inverted]) continue;
    std::optional<SurfaceResult> result =
        section(inverted == 1 ? first : second, *inversions[inverted], options, context);
    if (!result) continue;
    if (inverted == 0) exchange_surfaces(*result);
    return result;
  }
  return std::nullopt;
}

}  // namespace eliminant::intersect
