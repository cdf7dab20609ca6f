// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/intersect/result.hpp>
#include <eliminant/symbolic/arithmetic/univariate_polynomial.hpp>

namespace eliminant::intersect {

/// A point of the projective line: nullopt is infinity.
using Parameter = std::optional<Coordinate>;

/// What a pair of parameters with one point is, of a curve with itself.
enum class PairKind {
  crossing,  ///< two real parameters, transversal or not
  isolated,  ///< conjugate parameters: a real point away from the real branches (acnode)
  cusp,      ///< one parameter at which the derivative of the map vanishes (ramification)
  complex,   ///< neither
};

/// One intersection of a curve with a curve or a surface, or of a curve with itself.
struct CurveSolution {
  /// On the curve; with two curves on the first. Absent where it is given by an equation (curve_curve).
  std::optional<Parameter> t;
  /// With two curves: on the second. Absent where that is given by an equation.
  std::optional<Parameter> u;
  /// Homogeneous coordinates (x : y : z : w), in the plane (x : y : w); the last one that is not zero is 1.
  std::vector<Coordinate> point;
  /// With a parametrised surface: every preimage, each a list of two parameters, or three homogeneous ones
  /// (triangular; the last one that is not zero is 1).
  std::vector<std::vector<Parameter>> surface_parameters;
  /// A squarefree polynomial over Z of which t is a root, where the engine had one.
  std::optional<symbolic::UnivariatePolynomial> t_polynomial;
  /// Intersection multiplicity of the curve (at this parameter) with the surface or the other curve; of a patch with
  /// its sheets at the parameters listed. Where the curve touches one of several sheets, the matrix engines count every
  /// sheet of the surface through the point, also beyond the patch.
  /// Of a curve with itself: of the two branches, of a cusp the delta invariant of its branch; of an equation the
  /// Milnor number.
  unsigned long multiplicity = 1;
  /// Of a curve with itself, where it is known.
  std::optional<PairKind> kind;
  /// Of the eigenvalue of the pencil: larger at embedded points of the matrix representation. Only the pencil engine.
  std::optional<unsigned long> eigenvalue_multiplicity;
  /// Real, and within all closed domains.
  bool inside = false;
  /// 10^radius_exponent bounds the distance of the true value from each printed parameter and coordinate.
  long radius_exponent = 0;
  Reality reality = Reality::undecided;
  bool certified = false;
  std::string reason;
};

/// A closed interval of real parameters.
using ParameterInterval = std::array<Parameter, 2>;

/// A part of the curve inside the surface, or of the first curve on the second.
struct Overlap {
  /// On the curve (the first one); absent when the whole projective parameter line belongs to it.
  std::optional<ParameterInterval> t;
  /// With two curves: on the second one.
  std::optional<ParameterInterval> u;
  bool certified = false;
  /// With two curves: u decreases as t increases.
  bool reversed = false;
};

/// A point of a curve with all parameters that are listed of it.
struct SingularPoint {
  std::vector<Coordinate> point;
  /// Each once, in the order of solutions.
  std::vector<Parameter> parameters;
  Reality reality = Reality::undecided;
  /// The sum over its pairs: the delta invariant of a plane curve, where all parameters are listed.
  unsigned long multiplicity = 0;
};

/// The audit over the complex projective parameter line.
struct CurveCounts {
  unsigned long distinct = 0;
  unsigned long real = 0;
  unsigned long undecided = 0;
  unsigned long inside = 0;
  /// Sum of all multiplicities; `expected` is what Bezout's theorem says, degree of the curve times degree of the
  /// surface (or of the other curve).
  unsigned long with_multiplicity = 0;
  unsigned long expected = 0;
  /// The box engine answered, at least in part: it looks at the domains alone, and there is no Bezout number of them.
  bool within_domains_only = false;
  unsigned long listed = 0;
};

struct CurveResult {
  std::string problem;  ///< "curve_surface", "curve_curve" or "self_intersection"
  /// Two plane curves: points are (x : y : w).
  bool in_plane = false;
  /// With two curves: the first, the second is given by an equation and has no parameter.
  bool first_implicit = false;
  bool second_implicit = false;
  Status status = Status::numeric;
  std::optional<Status> rest_status;
  std::optional<std::string> limit;
  CurveCounts counts;
  /// Sorted by the (first) parameter: (Re t, Im t), infinity last; then by u or the point.
  std::vector<CurveSolution> solutions;
  /// Of a curve with itself: the solutions by their points.
  /// By their first parameters.
  std::vector<SingularPoint> singular_points;
  /// Of a curve with itself: it ends where it begins, which is no solution.
  bool closed = false;
  /// Of a curve with itself: how often the map of its pieces takes a general point, at most.
  unsigned long covering = 1;
  /// Only for `infinite`.
  std::vector<Overlap> overlap;
  EngineReport engine;
  std::vector<std::pair<std::string, double>> seconds;
  std::vector<std::string> warnings;
};

}  // namespace eliminant::intersect
