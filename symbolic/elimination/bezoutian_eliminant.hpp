// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/elimination/stationary_components.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// What lies above a component of the determinant's curve.
enum class ComponentKind {
  curve,                 ///< a curve of space: pairs of parameters of finite common points that move along it
  base_point,            ///< all coordinates of a surface vanish for these parameters, and nothing else is there
  at_infinity,           ///< common points of weight zero only
  contracted_curve,      ///< one point: one surface contracts a curve of parameters to a point of the other
  coincident_parameters  ///< self-intersection only: no other parameters than the point itself (a cuspidal edge)
};

/// A sentence for the user.
std::string_view explanation(ComponentKind kind);

/// Why the determinant vanishes identically.
enum class DeterminantVanishing {
  no,
  no_surface,   ///< the image of a map is only a curve or a point
  overlap,      ///< both maps have the same image
  many_to_one,  ///< the map covers its image several times
  contracted    ///< both surfaces contract a curve of parameters, also at infinity, to one common point
};

std::string_view explanation(DeterminantVanishing vanishing);

struct EliminantComponent {
  Polynomial factor{2};            ///< irreducible over Q, primitive over Z
  unsigned long multiplicity = 1;  ///< in the determinant, or in the gcd of the minors
  ComponentKind kind = ComponentKind::curve;
  /// The kind is proven by exact arithmetic; otherwise it was seen at random points modulo two primes of 62 bits.
  /// Curves in both variables are proven of two polynomial surfaces; of the extraneous kinds all but those above which
  /// the rank of the matrix falls by more than one, and points at infinity of self-intersections that are not a curve
  /// of parameters at infinity.
  bool proven = false;
  /// Finite common points above a general point of the component, by their parameters on the surface where these are
  /// more. With k of them the projection to the kept parameters is k to 1, and the multiplicity at least k.
  long meetings = 0;
  /// v, or s, is infinite at all of them: the component is on the surfaces, but not for finite parameters.
  bool infinite_parameters = false;
};

/// The eliminant of an intersection in (u, t), or of a self-intersection in (u, v).
struct BezoutianEliminant {
  std::size_t size = 0;  ///< of the Bezoutian matrix
  std::size_t rank = 0;  ///< of it over Q(u, t)
  Polynomial determinant{2};
  DeterminantVanishing vanishing = DeterminantVanishing::no;
  /// The primitive part of the determinant; where that vanishes, the gcd of the minors of size `rank`.
  Polynomial divisor{2};
  /// Of `divisor`, those in u alone first, then those in t (or v) alone.
  std::vector<EliminantComponent> components;
  /// The product of the factors of kind `curve`, each once: the projection of the curve, squarefree.
  Polynomial curve{2};
  /// Where common curves may hide from the projection.
  StationaryComponents stationary;
};

/// The eliminant of Phi(u, v) = Psi(s, t) with v and s eliminated, its components told apart by what lies above them.
/// Throws InvalidInput for a surface of triangular kind or one that does not depend on the eliminated parameter,
/// LimitReached.
/// Source: [BuseElkadiGalligo2008], Theorems 2 and 3.
BezoutianEliminant intersection_eliminant(const RationalSurface& first, const RationalSurface& second,
                                          std::uint64_t seed, const Context& context);

/// The eliminant of Phi(u, v') = Phi(s, v), (u, v') != (s, v), in (u, v): the same for the self-intersection. Every
/// curve of double points shows twice, once for each of its parameters.
/// Source: [BuseElkadiGalligo2008], Theorems 4 and 5.
BezoutianEliminant self_intersection_eliminant(const RationalSurface& surface, std::uint64_t seed,
                                               const Context& context);

}  // namespace eliminant::symbolic
