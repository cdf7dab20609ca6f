// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/enclosures/ball.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>

namespace eliminant::bridge {

// Notation. g in Z[x][y], X = [left, right] an interval of abscissae, alpha a number in X: the arcs of g = 0 over X are
// ordered around the fibre x = alpha.

/// A root of g(alpha, y) of multiplicity at least 2.
struct MultipleFibrePoint {
  RealBall y;
  long multiplicity = 2;
};

/// An open interval of y at whose ends no g(x, y) vanishes, x in X.
struct FibreInterval {
  symbolic::Rational lower;
  symbolic::Rational upper;
  /// Index of the multiple point: at alpha it is the only root within. Unset: over every x of X there is exactly one
  /// root within, a simple one.
  std::optional<std::size_t> multiple;
};

struct FibreIsolation {
  enum class State {
    isolated,
    wide_interval,  ///< X or the precision is too coarse
    wide_points,    ///< an enclosure of a multiple point is
  };
  State state = State::wide_interval;
  /// Disjoint, ascending. Over every x of X the real roots of g lie in them or beyond -bound or bound; roots
  /// beyond tend to infinity as x tends to alpha, and are none where the degree does not drop.
  std::vector<FibreInterval> intervals;
  symbolic::Rational bound;
};

/// Separates the real roots of g(alpha, y) from each other for all x of X at once. `multiple` are all multiple real
/// roots with their exact multiplicities, `degree_drop` is deg_y g - deg g(alpha, y), exactly; g(alpha, y) is not zero.
///
/// Proof: where the k-th derivative in y has no zero over X, g(x, y) has at most k roots; a multiple point of
/// multiplicity k is then alone. Elsewhere there is no root, or g is monotone between ends of known signs. Infinity is
/// the point z = 1/y = 0 of multiplicity degree_drop. Enclosures by Taylor expansion about midpoints, in ball
/// arithmetic. The boxes are those of [ChengEtAl2010], proven over the whole of X.
FibreIsolation isolate_fibre(const symbolic::HiddenVariablePolynomial& g, const symbolic::Rational& left,
                             const symbolic::Rational& right, const std::vector<MultipleFibrePoint>& multiple,
                             long degree_drop, long precision_bits, const Context& context);

/// The simple root of g(alpha, y) in an interval of isolate_fibre, by the interval Newton method: as narrow as `alpha`
/// and the precision make it.
RealBall refine_simple_root(const symbolic::HiddenVariablePolynomial& g, const RealBall& alpha,
                            const FibreInterval& interval, long precision_bits);

/// The real roots of g(x, y) for one rational x, ascending, each to be refined.
class RationalFibre {
 public:
  RationalFibre(const symbolic::HiddenVariablePolynomial& g, const symbolic::Rational& x, const Context& context);
  std::size_t count() const { return roots_.size(); }
  /// -1, 0 or 1: the root is below, exactly at, or above the number.
  int position(std::size_t index, const symbolic::Rational& y);
  /// Roots below a number that is no root.
  std::size_t count_below(const symbolic::Rational& y);
  /// With a radius of at most 2^-relative_bits times the root.
  const RealBall& refined(std::size_t index, long relative_bits);

 private:
  symbolic::UnivariatePolynomial polynomial_;  ///< squarefree
  std::vector<RealBall> roots_;
  const Context& context_;
};

}  // namespace eliminant::bridge
