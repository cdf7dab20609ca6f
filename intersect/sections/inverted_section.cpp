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
#include <eliminant/intersect/sections/section_patch.hpp>
#include <eliminant/intersect/sections/space_form.hpp>
#include <eliminant/intersect/whole_surfaces/surface_charts.hpp>
#include <eliminant/symbolic/elimination/rational_inversion.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::ParameterQuotient;
using symbolic::Polynomial;
using symbolic::RationalInversion;
using symbolic::RationalSurface;

/// Parameters of points in doubles.
class ParameterReader {
 public:
  explicit ParameterReader(const std::vector<ParameterQuotient>& quotients) {
    for (const ParameterQuotient& q : quotients) forms_.emplace_back(SpaceForm(q.numerator), SpaceForm(q.denominator));
  }

  struct Bounded {
    double value;
    double radius;
  };

  /// For all points within the radius, by the quotient that is farthest from 0/0; of an infinite value the radius
  /// bounds the inverse. Not a number where nothing is known.
  Bounded at(const std::array<double, 3>& point, double radius) const {
    const std::array<DoubleInterval, 3> ball{DoubleInterval::around(point[0], radius),
                                             DoubleInterval::around(point[1], radius),
                                             DoubleInterval::around(point[2], radius)};
    Bounded result{NAN, INFINITY};
    double largest = -1;
    for (const auto& [numerator, denominator] : forms_) {
      const DoubleInterval a = numerator.at(ball).value;
      const DoubleInterval b = denominator.at(ball).value;
      const double size = std::max(std::fabs(middle(a)), std::fabs(middle(b)));
      if (!(size > largest)) continue;
      largest = size;
      if (b.excludes_zero()) {
        const DoubleInterval value = a / b;
        result = {middle(value), DoubleInterval::around(0, width(value)).upper};
      } else if (a.excludes_zero()) {
        result = {INFINITY, (b / a).magnitude()};
      } else {
        result = {NAN, INFINITY};
      }
    }
    return result;
  }

  /// Without a bound; not a number where all quotients are 0/0 but for rounding.
  double middle_at(const std::array<double, 3>& point) const {
    const std::array<DoubleInterval, 3> at{DoubleInterval(point[0]), DoubleInterval(point[1]),
                                           DoubleInterval(point[2])};
    constexpr double rounding = 1e-13;
    double largest = -1;
    double result = NAN;
    for (const auto& [numerator, denominator] : forms_) {
      const SpaceForm::Value a = numerator.at(at);
      const SpaceForm::Value b = denominator.at(at);
      const double size = std::max(std::fabs(middle(a.value)), std::fabs(middle(b.value)));
      if (!(size > largest) || !(size > rounding * std::max(a.size, b.size))) continue;
      largest = size;
      result = middle(b.value) == 0 ? INFINITY : middle(a.value) / middle(b.value);
    }
    return result;
  }

 private:
  std::vector<std::pair<SpaceForm, SpaceForm>> forms_;
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

/// Where F is zero on the other surface a point has parameters on this one: one pair, or a whole line.
bool has_parameters(const RationalSurface& surface, const RationalInversion& inversion, const Options& options,
                    const Context& context) {
  if (inversion.exceptions_are_lines) return true;
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

/// Adds (s, t) to all points.
void lift(SurfaceResult& result, const RationalInversion& inversion) {
  const std::array<ParameterReader, 2> readers{ParameterReader(inversion.parameters[0]),
                                               ParameterReader(inversion.parameters[1])};
  for (SurfaceComponent& component : result.components)
    for (SurfacePoint& point : component.points)
      for (std::size_t k = 0; k < 2; ++k) point.parameters[2 + k] = readers[k].middle_at(point.point);
  for (SurfaceSingularPoint& singular : result.singular_points)
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [value, radius] = readers[k].at(singular.at.point, singular.radius);
      singular.at.parameters[2 + k] = value;
      if (std::isfinite(radius)) singular.radius = std::max(singular.radius, radius);
    }
}

/// The section of `surface` by the one that has inverses.
std::optional<SurfaceResult> section(const RationalSurface& surface, const RationalInversion& inversion,
                                     const Options& options, const Context& context) {
  const std::array<Polynomial, 4> affine{Polynomial::variable(3, 0), Polynomial::variable(3, 1),
                                         Polynomial::variable(3, 2), Polynomial::constant(3, 1)};
  const Polynomial equation = inversion.equation.compose(affine);
  if (equation.is_constant() || inversion.equation.compose(surface.coordinates()).is_zero()) return std::nullopt;
  if (!has_parameters(surface, inversion, options, context)) return std::nullopt;
  SurfaceResult result = intersect_surface_with_equation(symbolic::ParametricSurface{{{surface, std::nullopt}}},
                                                         equation, options, context);
  if (result.limit) throw LimitReached(*result.limit);
  const auto is_doubtful = [](const std::string& warning) {
    return warning == topology_not_proven || warning == beyond_doubles;
  };
  if (std::any_of(result.warnings.begin(), result.warnings.end(), is_doubtful)) return std::nullopt;
  lift(result, inversion);
  return result;
}

}  // namespace

std::optional<SurfaceResult> intersect_by_inversion(const RationalSurface& first, const RationalSurface& second,
                                                    const Options& options, const Context& context) {
  std::array<std::optional<RationalInversion>, 2> inversions{symbolic::rational_inversion(first),
                                                             symbolic::rational_inversion(second)};
  const auto degree = [&](std::size_t k) { return inversions[k] ? inversions[k]->equation.total_degree() : 100; };
  const std::size_t better = degree(0) < degree(1) ? 0 : 1;
  std::optional<SurfaceResult> unproven;
  for (const std::size_t inverted : {better, 1 - better}) {
    if (!inversions[inverted]) continue;
    std::optional<SurfaceResult> result =
        section(inverted == 1 ? first : second, *inversions[inverted], options, context);
    if (!result) continue;
    if (inverted == 0) exchange_surfaces(*result);
    if (result->status == Status::certified) return result;
    if (!unproven) unproven = std::move(result);
  }
  return unproven;
}

}  // namespace eliminant::intersect
