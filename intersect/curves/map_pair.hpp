// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// What two maps of curves have in common.
struct MapPairResult {
  Status status = Status::numeric;  ///< certified or numeric, of the isolated solutions
  CurveCounts counts;               ///< without `inside` and `listed`
  std::vector<CurveSolution> solutions;
  std::vector<Overlap> overlap;
  /// Ends of the domains of coinciding curves that touch without an overlap of positive length.
  std::vector<CurveSolution> touches;
  /// The curves coincide, whether or not within their domains.
  bool coincident = false;
  /// The degree in t of the correspondence of parameters of coinciding curves.
  long component_degree = 0;
  EngineReport engine;
  std::vector<std::string> warnings;
};

/// All pairs of parameters (t, u) with the same point of the plane, or of space.
///
/// The two moving lines p, q of a basis for the first curve Phi meet in Phi(t) for every t, so the pairs are the common
/// zeros of p(t).Psi(u) and q(t).Psi(u) on the product of two projective lines, of bidegrees (mu, e) and (d - mu, e):
/// d e of them, and the multiplicity of a pair is the intersection multiplicity of the two branches. They are solved as
/// plane curves in up to four charts. Where the curves coincide the two equations have a common component, the
/// correspondence of parameters. In space there are three moving planes and three equations; of the common zeros of two
/// combinations those are kept at which, exactly, the third vanishes too. Their multiplicity is that of the three
/// equations (local_multiplicity.hpp); where both branches are singular the one of the two combinations stands for it,
/// an upper bound that is not certified.
/// Throws InvalidInput when one of the maps is constant.
MapPairResult intersect_map_pair(const symbolic::CurvePiece& first, const symbolic::CurvePiece& second,
                                 const Options& options, const Context& context);

/// All ordered pairs of parameters (t, u) with the same point of one curve, where t = u is divided out of the
/// equations: with (t, u) also (u, t), and t = u where the derivative of the map vanishes. In the plane the equations
/// have bidegrees (mu - 1, d - 1) and (d - mu - 1, d - 1), and (d - 1) (d - 2) common zeros; the multiplicity of a pair
/// t != u is the intersection multiplicity of its branches, of t = u twice the delta invariant of the branch. A map
/// that takes general points k times has a common component, of bidegree (k - 1, k - 1). `domain` and options as above.
/// Throws InvalidInput when the map is constant.
MapPairResult intersect_map_with_itself(const symbolic::CurvePiece& piece, const Options& options,
                                        const Context& context);

/// The squarefree polynomial of all finite t (axis 0) or u (axis 1) of the isolated pairs of two pieces, or, when both
/// are one object, of that piece with itself.
symbolic::UnivariatePolynomial common_parameters(const symbolic::CurvePiece& first, const symbolic::CurvePiece& second,
                                                 std::size_t axis, const Options& options, const Context& context);

}  // namespace eliminant::intersect
