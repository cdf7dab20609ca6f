// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/bezoutian_eliminant.hpp>

#include <algorithm>
#include <array>
#include <optional>

#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/base_parameters.hpp>
#include <eliminant/symbolic/elimination/bezoutian_determinant.hpp>
#include <eliminant/symbolic/elimination/bezoutian_minors.hpp>
#include <eliminant/symbolic/elimination/bivariate_factors.hpp>
#include <eliminant/symbolic/elimination/component_proofs.hpp>
#include <eliminant/symbolic/elimination/curve_meetings.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/elimination/surface_overlap.hpp>
#include <eliminant/symbolic/geometry/image_dimension.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>

namespace eliminant::symbolic {

namespace {

/// A point (u, t) of a plane over a prime field.
struct PlanePoint {
  mp_limb_t u = 0;
  mp_limb_t t = 0;
};

std::optional<mp_limb_t> some_root(const ModularPolynomial& f) {
  if (f.degree() < 1) return std::nullopt;
  nmod_poly_factor_t roots;
  nmod_poly_factor_init(roots);
  nmod_poly_roots(roots, f.get(), 0);
  std::optional<mp_limb_t> root;
  if (roots->num > 0) root = nmod_neg(nmod_poly_get_coeff_ui(roots->p, 0), roots->p->mod);
  nmod_poly_factor_clear(roots);
  return root;
}

/// f with `value` in place of variable `index`.
ModularPolynomial restricted(const Polynomial& f, std::size_t index, mp_limb_t value, const PrimeField& field) {
  const HiddenVariablePolynomial hidden = hide_variable(f, index);
  ModularPolynomial result(field);
  ModularPolynomial coefficient(field);
  for (std::size_t k = 0; k < hidden.coefficients.size(); ++k) {
    fmpz_poly_get_nmod_poly(coefficient.get(), hidden.coefficients[k].get());
    nmod_poly_set_coeff_ui(result.get(), static_cast<slong>(k), nmod_poly_evaluate_nmod(coefficient.get(), value));
  }
  return result;
}

/// What is seen above one point, and whether it is the same point of space above another one.
struct Observation {
  CurveMeetings meetings;
  bool one_image = false;
};

/// Looks at the common points above points (u, t) modulo primes.
class Observer {
 public:
  Observer(const RationalSurface& first, const RationalSurface& second, bool self, std::uint64_t seed)
      : first_(first), second_(second), self_(self), seed_(seed) {}

  /// Above a general point of the plane.
  CurveMeetings anywhere(std::uint64_t round) const {
    const PrimeField field(PrimeSequence(mix(seed_, round)).next());
    return above({mix(seed_, round + 100) % field.prime(), mix(seed_, round + 200) % field.prime()}, field, round);
  }

  /// Above a general point of the curve f = 0; nullopt when no rational point of it was found.
  std::optional<Observation> on(const Polynomial& f, std::uint64_t round) const {
    PrimeSequence primes(mix(seed_, round + 300));
    constexpr std::uint64_t most_trials = 2000;
    for (std::uint64_t trial = 0; trial < most_trials; ++trial) {
      const PrimeField field(primes.next());
      const mp_limb_t free = mix(seed_ + round, trial) % field.prime();
      const std::size_t fixed = f.degree(1) > 0 ? 0 : 1;
      const std::optional<mp_limb_t> root = some_root(restricted(f, fixed, free, field));
      if (!root) continue;
      const auto point = [&](mp_limb_t other) {
        return fixed == 0 ? PlanePoint{other, *root} : PlanePoint{*root, other};
      };
      Observation result{above(point(free), field, round), false};
      if (f.degree(0) > 0 && f.degree(1) > 0) return result;
      // On a line of the plane the other coordinate moves.
      const mp_limb_t elsewhere = mix(seed_ + round, trial + most_trials) % field.prime();
      const CurveMeetings moved = above(point(elsewhere), field, round);
      result.one_image = !moved.images.empty() && moved.images == result.meetings.images;
      return result;
    }
    return std::nullopt;
  }

 private:
  static ModularCurve curve_at(const RationalSurface& surface, std::size_t kept, mp_limb_t value,
                               const PrimeField& field) {
    ModularCurve curve(static_cast<std::size_t>(surface.bidegree()[1 - kept]) + 1, {0, 0, 0, 0});
    for (std::size_t k = 0; k < 4; ++k) {
      const ModularPolynomial coordinate = restricted(surface.coordinates()[(k + 3) % 4], kept, value, field);
      for (long e = 0; e <= coordinate.degree(); ++e)
        curve[static_cast<std::size_t>(e)][k] = nmod_poly_get_coeff_ui(coordinate.get(), e);
    }
    return curve;
  }

  CurveMeetings above(const PlanePoint& point, const PrimeField& field, std::uint64_t round) const {
    const std::optional<TrivialPair> trivial = self_ ? std::optional<TrivialPair>({point.t, point.u}) : std::nullopt;
    return curve_meetings(curve_at(first_, 0, point.u, field), curve_at(second_, 1, point.t, field), trivial, field,
                          mix(seed_, round + 400), mix(seed_, round + 500));
  }

  const RationalSurface& first_;
  const RationalSurface& second_;
  bool self_;
  std::uint64_t seed_;
};

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
    EliminantComponent result{factor.factor, factor.multiplicity, factor.irreducible, ComponentKind::curve, false, 0};
    long finite = 0;
    long at_infinity = 0;
    bool one_image = true;
    bool base_points = true;
    for (const std::uint64_t round : {1, 2}) {
      const std::optional<Observation> seen = observer_.on(factor.factor, round);
      if (!seen || seen->meetings.infinite) return result;
      finite = std::max(finite, seen->meetings.finite - general_.finite);
      at_infinity = std::max(at_infinity, seen->meetings.at_infinity - general_.at_infinity);
      one_image = one_image && seen->one_image;
      base_points = base_points && (seen->meetings.first_has_base_point || seen->meetings.second_has_base_point);
    }
    result.meetings = finite;
    if (finite > 0 && !one_image) {
      // Polynomial surfaces have neither base points nor infinite points above it.
      result.proven = !self_ && general_.finite == 0 && is_bivariate(factor.factor) && has_constant_weight(first_) &&
                      has_constant_weight(second_);
      return result;
    }
    if (base_points && base_points_proven(factor.factor)) {
      result.kind = ComponentKind::base_point;
      result.proven = true;
    } else if (at_infinity > 0) {
      result.kind = ComponentKind::at_infinity;
      result.proven = at_infinity_proven(factor.factor);
    } else if (finite > 0) {
      result.kind = ComponentKind::contracted_curve;
      result.proven = !self_ && proves_one_point(matrix_, factor.factor, seed_, context_);
    } else if (self_) {
      result.kind = ComponentKind::coincident_parameters;
    }
    return result;
  }

 private:
  static bool is_bivariate(const Polynomial& f) { return f.degree(0) > 0 && f.degree(1) > 0; }

  bool at_infinity_proven(const Polynomial& f) const {
    for (const std::size_t index : {0, 1})
      if (f.degree(1 - index) == 0 && divides_weight(index == 0 ? first_ : second_, f)) return true;
    return !self_ && proves_weight_zero(matrix_, first_, second_, f, seed_, context_);
  }

  bool base_points_proven(const Polynomial& f) const {
    for (const std::size_t index : {0, 1})
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
  Observer observer_;
  CurveMeetings general_;
};

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
  // Without weights there are no common points at infinity, and all other extraneous factors are in one variable.
  constexpr long small = 20;
  const bool cheap = result.divisor.degree(0) <= small && result.divisor.degree(1) <= small;
  const bool whole = has_constant_weight(first) && has_constant_weight(second) && !cheap;
  const Classification classification(matrix, first, second, self, seed, context);
  for (const BivariateFactor& factor :
       bivariate_factors(result.divisor, whole ? FactorDepth::squarefree : FactorDepth::irreducible, seed)) {
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
  return result;
}

}  // namespace eliminant::symbolic
