// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/ball.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

/// Homogeneous control points (w x, w y, w z, w) of a Bezier curve or patch on [0, 1] or [0, 1]^2, rounded to doubles.
struct ControlNet {
  /// Degree in each parameter: one for a curve, two for a patch.
  std::vector<std::size_t> degrees;
  /// Coordinate k of all points, the last parameter running fastest.
  std::array<std::vector<double>, 4> coordinates;
  /// A bound of the error of each number.
  double error = 0;

  /// Rounds exact control points: for each coordinate its numbers in the order above. nullopt when a number is outside
  /// the range in which hardware doubles are safe.
  static std::optional<ControlNet> round(std::vector<std::size_t> degrees,
                                         const std::array<std::vector<symbolic::Rational>, 4>& coordinates);
};

/// Lower and upper ends of an interval for each homogeneous coordinate of a point.
using PointBox = std::array<std::array<double, 2>, 4>;

/// True when it is proven that no parameter in [0, 1]^2 has that point, whatever the signs of the weights: by
/// subdivision, until a minor of both coordinate vectors has one sign on every part. False when that does not come
/// soon.
bool excludes_point(const ControlNet& patch, const PointBox& point, const Context& context);

/// A box of parameters (u of the curve, s and t of the patch) that contains exactly one common point, a transversal
/// one.
using ParameterBox = std::array<ComplexBall, 3>;

/// Tries to prove a common point near these parameters (u, s, t), which Newton's steps in doubles have led to.
using CertifyNear = std::function<std::optional<ParameterBox>(const std::array<double, 3>&)>;

/// All common points of a curve and a patch within their closed parameter domains, or nullopt when some part of the
/// domain could not be decided: a contact, a singular point, a point on a border, or weights of mixed sign.
///
/// Every part of the domain is excluded or holds at most one common point: subdivision by de Casteljau's algorithm in
/// doubles with a bound on its error; a pair of parts is excluded when the boxes around their control points are
/// disjoint, or by the Krawczyk operator, and holds at most one point when the preconditioned derivative, bounded by
/// the control points of the derivatives, is near the identity. That point is proven by `certify`.
std::optional<std::vector<ParameterBox>> bernstein_subdivision(const ControlNet& curve, const ControlNet& patch,
                                                               const CertifyNear& certify, const Context& context);

}  // namespace eliminant::bridge
