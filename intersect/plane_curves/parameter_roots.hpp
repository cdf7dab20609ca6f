// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/intersect/plane_curves/solution_set.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>

namespace eliminant::intersect {

/// The roots of a polynomial over Z with their multiplicities, each of which can be enclosed as tightly as wanted and
/// compared exactly: the parameters at which a curve meets something.
class ParameterRoots {
 public:
  /// f is not zero. `context` must outlive the object.
  ParameterRoots(const symbolic::UnivariatePolynomial& f, Wanted wanted, const Context& context);

  std::size_t size() const { return roots_.size(); }
  const bridge::ComplexBall& ball(std::size_t i) const { return classes_[roots_[i].factor].balls()[roots_[i].index]; }
  unsigned long multiplicity(std::size_t i) const { return factors_[roots_[i].factor].multiplicity; }
  bool is_real(std::size_t i) const { return arb_is_zero(ball(i).imaginary()) != 0; }
  /// The squarefree factor that has root i.
  const symbolic::UnivariatePolynomial& factor(std::size_t i) const { return factors_[roots_[i].factor].factor; }
  /// The number of distinct roots in the complex plane, whatever is wanted.
  unsigned long distinct() const;

  /// Makes the radius of ball i at most 2^-relative_bits times the root.
  void refine(std::size_t i, long relative_bits);
  /// Whether g(root i) = 0, decided exactly.
  bool is_zero_of(std::size_t i, const symbolic::UnivariatePolynomial& g);
  /// The sign of root i, which is real, minus `value`, decided exactly.
  int compare(std::size_t i, const symbolic::Rational& value);

 private:
  struct Root {
    std::size_t factor;
    std::size_t index;
  };
  std::vector<symbolic::SquarefreeFactor> factors_;
  std::vector<bridge::IsolatedRoots> classes_;
  std::vector<Root> roots_;
  const Context& context_;
};

/// The value of a polynomial over Z in a ball.
bridge::ComplexBall evaluate(const symbolic::UnivariatePolynomial& p, const bridge::ComplexBall& at,
                             long precision_bits);

}  // namespace eliminant::intersect
