// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/certificates/disc_certificate.hpp>
#include <eliminant/bridge/certificates/krawczyk_test.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/bridge/rounding/power_of_two_scaling.hpp>
#include <eliminant/intersect/result.hpp>
#include <eliminant/symbolic/elimination/univariate_representation.hpp>

namespace eliminant::intersect {

/// One solution, enclosed: `box` contains it and no other one.
struct EnclosedPoint {
  bridge::PlaneBall box;
  unsigned long multiplicity = 1;
  Reality reality = Reality::undecided;
  // Where it came from, which is how it can be enclosed more tightly: one of three.
  /// The Krawczyk test, where class and product are unset: `region`, in the scaled coordinates of the set, holds no
  /// other solution; `disc` is the proof where hardware doubles gave it.
  bridge::PlaneBall region;
  std::optional<bridge::DiscCertificate> disc;
  /// A class of the representation and a root of its factor.
  std::optional<std::size_t> class_index;
  std::size_t root_index = 0;
  /// For curves p(x) = 0 and q(y) = 0: for each coordinate a factor and one of its roots.
  struct ProductRoots {
    std::size_t x_factor, x_root, y_factor, y_root;
  };
  std::optional<ProductRoots> product;
  /// Coordinates that are known to be rational numbers.
  std::optional<symbolic::Rational> exact_x;
  std::optional<symbolic::Rational> exact_y;
};

/// Which solutions a set must hold: from the exact side the real ones alone come cheaper.
enum class Wanted { all, real };

/// The proven solutions of two coprime curves, each of which can be enclosed as tightly as wanted.
class SolutionSet {
 public:
  /// p and q are primitive over Z and coprime. `context` must outlive the set.
  SolutionSet(const symbolic::Polynomial& p, const symbolic::Polynomial& q, Wanted wanted, const Context& context);

  const std::vector<EnclosedPoint>& points() const { return points_; }

  /// Tries to prove a simple solution near `start` (given in the coordinates of p and q): by the Krawczyk test in
  /// hardware doubles, or in a box of radius at most 2^radius_log2 in ball arithmetic from `first_precision_bits`, that
  /// of `start`, to `max_precision_bits` (53: none). A solution that is not real brings its conjugate with it. Returns
  /// the number of solutions that are new: 0 when nothing was proven or it is already there.
  int add_simple(const bridge::PlaneBall& start, long radius_log2, long max_precision_bits,
                 long first_precision_bits = 96);

  /// Takes all points out, to be put back, or not.
  std::vector<EnclosedPoint> take_points() { return std::exchange(points_, {}); }
  void put_back(std::vector<EnclosedPoint> points) { points_ = std::move(points); }

  void set_representation(symbolic::UnivariateRepresentation representation);
  const std::optional<symbolic::UnivariateRepresentation>& representation() const { return representation_; }

  /// Adds all wanted points of one class of the representation. `approximations` of some of them, possibly none and
  /// possibly wrong, make it quicker.
  void add_class(std::size_t class_index, const std::vector<bridge::PlaneBall>& approximations);

  /// Adds all wanted points of p(x) = q(y) = 0: pairs of roots; multiplicities multiply, the local ring being a tensor
  /// product.
  void add_product(const std::vector<symbolic::SquarefreeFactor>& x_factors,
                   const std::vector<symbolic::SquarefreeFactor>& y_factors);

  /// Decides for every point whether it is real. p and q are real, so this always ends.
  void decide_reality();

  /// Makes the radius of every part of both coordinates of one point at most 2^radius_log2.
  void enclose(std::size_t index, long radius_log2);

  /// Finds out which wanted points have first (axis 0) or second (axis 1) coordinate exactly `value`, and makes it
  /// exact there. Afterwards the others can be told apart from `value` by enclosing them more tightly.
  void find_exact_coordinate(std::size_t axis, const symbolic::Rational& value);

 private:
  std::optional<bridge::DiscCertificate> certify_in_doubles(const bridge::PlaneBall& scaled_start) const;
  long scaled_target(long radius_log2) const;
  bridge::PlaneBall to_scaled(const bridge::PlaneBall& point) const;
  bridge::PlaneBall from_scaled(const bridge::PlaneBall& point) const;
  bridge::IsolatedRoots isolate(const symbolic::UnivariatePolynomial& squarefree,
                                const std::vector<bridge::ComplexBall>& approximations = {}) const;
  void enclose(EnclosedPoint& point, long radius_log2);
  bool enclose_product(EnclosedPoint& point, long radius_log2);
  void store(EnclosedPoint& point, bridge::PlaneBall box, long target_log2) const;

  symbolic::Polynomial p_;
  symbolic::Polynomial q_;
  bridge::PowerOfTwoScaling scaling_;
  bridge::BallCurve scaled_p_;
  bridge::BallCurve scaled_q_;
  std::optional<bridge::RoundedCurve> rounded_p_;
  std::optional<bridge::RoundedCurve> rounded_q_;
  Wanted wanted_;
  const Context& context_;
  std::vector<EnclosedPoint> points_;
  std::optional<symbolic::UnivariateRepresentation> representation_;
  std::vector<bridge::IsolatedRoots> classes_;    // of the representation
  std::vector<bridge::IsolatedRoots> x_classes_;  // of a product
  std::vector<bridge::IsolatedRoots> y_classes_;
};

/// An upper bound of log2 of the largest radius of a part of the coordinates.
long radius_log2(const bridge::PlaneBall& box);

/// True when the two boxes cannot contain a common point.
bool disjoint(const bridge::PlaneBall& a, const bridge::PlaneBall& b);

}  // namespace eliminant::intersect
