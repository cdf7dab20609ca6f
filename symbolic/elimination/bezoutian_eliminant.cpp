// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/bezoutian_eliminant.hpp>

#include <algorithm>
#include <optional>

#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/base_parameters.hpp>
#include <eliminant/symbolic/elimination/bezoutian_determinant.hpp>
#include <eliminant/symbolic/elimination/bezoutian_minors.hpp>
#include <eliminant/symbolic/elimination/bivariate_factors.hpp>
#include <eliminant/symbolic/elimination/component_observer.hpp>
#include <eliminant/symbolic/elimination/component_proofs.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/elimination/surface_overlap.hpp>
#include <eliminant/symbolic/geometry/image_dimension.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>

namespace eliminant::symbolic {

namespace {

bool has_constant_weight(const RationalSurface& surface) { return surface.coordinates()[3].is_constant(); }

/// Finds the kind of each component. The numbers above a general point of the plane are subtracted: they are not zero
/// where the determinant vanishes identically.
class Classification {
 public:
  Classification(const SeparatedBezoutian& matrix, const RationalSurface& first, const RationalSurface& second,
                 bool self, std::uint64_t seed, const Context& context)
      : matrix_(matrix),
        first_(first),
        second_(second),
        self_(self),
        seed_(seed),
        context_(context),
        observer_(first, second, self, seed),
        general_(observer_.anywhere(0)) {}

  EliminantComponent component(const BivariateFactor& factor) const {
    context_.checkpoint("components of the eliminant");
    EliminantComponent result{factor.factor, factor.multiplicity, ComponentKind::curve, false, 0, false};
    long finite = 0;
    long at_infinity = 0;
    bool one_image = true;
    bool base_points = true;
    bool infinite_parameters = true;
    for (const std::uint64_t round : {1UL, 2UL}) {
      const std::optional<Observation> seen = observer_.on(factor.factor, round);
      if (!seen || seen->meetings.infinite) return result;
      finite = std::max(finite, seen->meetings.finite - general_.finite);
      at_infinity = std::max(at_infinity, seen->meetings.at_infinity - general_.at_infinity);
      one_image = one_image && seen->one_image;
      infinite_parameters = infinite_parameters && seen->meetings.infinite_parameters;
      base_points = base_points && (seen->meetings.first_has_base_point || seen->meetings.second_has_base_point);
    }
    result.meetings = finite;
    result.infinite_parameters = infinite_parameters;
    if (finite > 0 && !one_image) {
      // Polynomial surfaces have neither base points nor infinite points above it.
      result.proven = !self_ && general_.finite == 0 && is_bivariate(factor.factor) && has_constant_weight(first_) &&
                      has_constant_weight(second_);
      return result;
    }
    if (finite > 0) {
      // Also above base points: here the surfaces do meet.
      result.kind = ComponentKind::contracted_curve;
      result.proven = !self_ && proves_one_point(matrix_, factor.factor, seed_, context_);
    } else if (base_points && base_points_proven(factor.factor)) {
      result.kind = ComponentKind::base_point;
      result.proven = true;
    } else if (at_infinity > 0) {
      result.kind = ComponentKind::at_infinity;
      result.proven = at_infinity_proven(factor.factor);
    } else if (self_) {
      result.kind = ComponentKind::coincident_parameters;
    }
    return result;
  }

 private:
  static bool is_bivariate(const Polynomial& f) { return f.degree(0) > 0 && f.degree(1) > 0; }

  bool at_infinity_proven(const Polynomial& f) const {
    for (const std::size_t index : {0UL, 1UL})
      if (f.degree(1 - index) == 0 && divides_weight(index == 0 ? first_ : second_, f)) return true;
    return !self_ && proves_weight_zero(matrix_, first_, second_, f, seed_, context_);
  }

  bool base_points_proven(const Polynomial& f) const {
    for (const std::size_t index : {0UL, 1UL})
      if (f.degree(1 - index) == 0) {
        const HiddenVariablePolynomial univariate = hide_variable(f, index);
        return has_base_point_above(index == 0 ? first_ : second_, index, univariate.coefficients.front(), context_);
      }
    return false;
  }

  const SeparatedBezoutian& matrix_;
  const RationalSurface& first_;
  const RationalSurface& second_;
  bool self_;
  std::uint64_t seed_;
  const Context& context_;
  ComponentObserver observer_;
  CurveMeetings general_;
};

/// The pairs of parameters of common points are at least a surface then, with (u, t) general on it. Its image in space
/// is of dimension two: the images of the maps are equal; or a point, to which both contract a curve; it is a curve
/// only if all parameters of one map go to that curve.
DeterminantVanishing why_intersection_vanishes(const RationalSurface& first, const RationalSurface& second,
                                               std::uint64_t seed, const Context& context) {
  if (!is_two_dimensional(first) || !is_two_dimensional(second)) return DeterminantVanishing::no_surface;
  return have_equal_image(first, second, seed, context) ? DeterminantVanishing::overlap
                                                        : DeterminantVanishing::contracted;
}

DeterminantVanishing why_self_intersection_vanishes(const RationalSurface& surface, std::uint64_t seed) {
  if (!is_two_dimensional(surface)) return DeterminantVanishing::no_surface;
  const ImplicitDegree degree = implicit_degree(surface, matrix_representation(surface), seed);
  return degree.map_degree > 1 ? DeterminantVanishing::many_to_one : DeterminantVanishing::contracted;
}

/// `divisor` into components.
void decompose(BezoutianEliminant& result, const SeparatedBezoutian& matrix, const RationalSurface& first,
               const RationalSurface& second, bool self, std::uint64_t seed, const Context& context) {
  result.curve = Polynomial::constant(2, 1);
  if (result.divisor.is_constant()) return;
  const Classification classification(matrix, first, second, self, seed, context);
  for (const BivariateFactor& factor : bivariate_factors(result.divisor, seed)) {
    result.components.push_back(classification.component(factor));
    if (result.components.back().kind == ComponentKind::curve) result.curve = result.curve * factor.factor;
  }
  result.curve = result.curve.primitive_part();
}

}  // namespace

std::string_view explanation(ComponentKind kind) {
  switch (kind) {
    case ComponentKind::curve:
      return "a curve of common points";
    case ComponentKind::base_point:
      return "base points: all coordinates of a surface vanish there, and the surfaces need not meet";
    case ComponentKind::at_infinity:
      return "common points at infinity only";
    case ComponentKind::contracted_curve:
      return "a single point: a curve of parameters of one surface is contracted to a point of the other";
    case ComponentKind::coincident_parameters:
      return "no other parameters than those of the point itself: a cuspidal edge";
  }
  return "";
}

std::string_view explanation(DeterminantVanishing vanishing) {
  switch (vanishing) {
    case DeterminantVanishing::no:
      return "the determinant is not zero";
    case DeterminantVanishing::no_surface:
      return "the image of a map is only a curve or a point";
    case DeterminantVanishing::overlap:
      return "the surfaces are the same, up to their domains";
    case DeterminantVanishing::many_to_one:
      return "the map covers its surface several times";
    case DeterminantVanishing::contracted:
      return "curves of parameters of both surfaces are contracted to one common point";
  }
  return "";
}

BezoutianEliminant intersection_eliminant(const RationalSurface& first, const RationalSurface& second,
                                          std::uint64_t seed, const Context& context) {
  const SeparatedBezoutian matrix(first, second);
  BezoutianEliminant result;
  result.size = matrix.size();
  result.rank = result.size;
  result.determinant = bezoutian_determinant(matrix, seed, context);
  result.divisor = result.determinant.primitive_part();
  if (result.determinant.is_zero()) {
    result.vanishing = why_intersection_vanishes(first, second, seed, context);
    const BezoutianMinors minors = bezoutian_minors(matrix, seed, context);
    result.rank = minors.rank;
    result.divisor = minors.gcd;
  }
  decompose(result, matrix, first, second, false, seed, context);
  if (is_two_dimensional(first) && is_two_dimensional(second))
    result.stationary = stationary_components(first, second, seed, context);
  return result;
}

BezoutianEliminant self_intersection_eliminant(const RationalSurface& surface, std::uint64_t seed,
                                               const Context& context) {
  const SeparatedBezoutian matrix(surface, surface);
  BezoutianEliminant result;
  result.size = matrix.size() - 1;
  result.rank = result.size;
  result.determinant = self_intersection_determinant(matrix, seed, context);
  result.divisor = result.determinant.primitive_part();
  if (result.determinant.is_zero()) {
    result.vanishing = why_self_intersection_vanishes(surface, seed);
    // The two matrices are congruent by a unipotent matrix, up to a row and a column of zeros: equal minors.
    const BezoutianMinors minors = bezoutian_minors(matrix, seed, context);
    result.rank = minors.rank;
    result.divisor = minors.gcd;
  }
  decompose(result, matrix, surface, surface, true, seed, context);
  if (is_two_dimensional(surface)) result.stationary = stationary_components(surface, surface, seed, context);
  return result;
}

}  // namespace eliminant::symbolic
