// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::bridge {

/// All complex roots of a squarefree polynomial over Z, each in a ball of its own: the balls are pairwise disjoint and
/// each contains exactly one root. Real roots have imaginary part exactly 0; the ball of any other root does not meet
/// the real axis. The root 0 is exact. Each root keeps its index, in the order of (real part, imaginary part).
///
/// Proof: with n the degree, the disc of radius n |p(z) / p'(z)| around z contains a root of p; n pairwise disjoint
/// discs contain one each ([Henrici1974], section 6.4). A disc that meets no other disc's mirror image on the real axis
/// but its own holds a real root. The approximations themselves need no proof: Ehrlich and Aberth's iteration in
/// doubles, then at growing precision for the roots that are not isolated yet, where a cluster of k roots is spread
/// again along the Newton polygon of the first k + 1 Taylor coefficients in its centre ([Bini1996]).
class IsolatedRoots {
 public:
  IsolatedRoots() = default;
  /// Isolates the roots; the degree is at least 1. `approximations` of some roots, possibly none and possibly wrong,
  /// make it quicker where the roots are ill-conditioned; the midpoints count.
  IsolatedRoots(const symbolic::UnivariatePolynomial& squarefree, const Context& context,
                const std::vector<ComplexBall>& approximations = {});
  /// The real roots alone, by Descartes' rule of signs where that is quick (bridge/roots/descartes_isolation): their
  /// balls are disjoint; roots that are not real are nowhere, perhaps also within a ball.
  static IsolatedRoots real(const symbolic::UnivariatePolynomial& squarefree, const Context& context);

  const std::vector<ComplexBall>& balls() const { return balls_; }
  /// Makes the radius of one ball at most 2^-relative_bits times the modulus of the root, by Newton's method; the
  /// accepted discs lie in the ball that isolated the root.
  void refine(std::size_t index, long relative_bits, const Context& context);

 private:
  void decide_reality(const Context& context);

  symbolic::UnivariatePolynomial p_;  ///< without the root 0
  bool by_signs_ = false;             ///< the balls are those of descartes_isolation
  std::vector<ComplexBall> balls_;
};

/// The same for one use: all balls with the radius asked for.
std::vector<ComplexBall> enclose_roots(const symbolic::UnivariatePolynomial& squarefree, long relative_bits,
                                       const Context& context);

}  // namespace eliminant::bridge
