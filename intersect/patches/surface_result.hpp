// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/intersect/result.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/elimination/bezoutian_eliminant.hpp>

namespace eliminant::intersect {

/// A point of the intersection of two surfaces, or a double point of one, in doubles.
struct SurfacePoint {
  /// (u, v) on the first surface, (s, t) on the second; of one surface both pairs are on it. Of a triangle they are the
  /// first two barycentric coordinates. +inf is the parameter at infinity, NaN one that is not known (a border that is
  /// one point).
  std::array<double, 4> parameters{};
  /// Affine coordinates.
  std::array<double, 3> point{};
};

enum class SurfaceComponentKind {
  curve,   ///< an arc with two ends
  loop,    ///< a closed curve
  point,   ///< a point of contact on its own
  overlap  ///< a part of both surfaces
};

enum class BranchEndKind {
  border,    ///< of a domain
  singular,  ///< a singular point, an index into SurfaceResult::singular_points
  infinity,  ///< the curve goes to infinity in space
  unknown    ///< not followed further: see the reason of the component
};

/// How a border, followed by its increasing parameter, crosses the other surface: to the side to which the normal of
/// that points (its first times its second partial derivative), to the other side, or neither is known. The third
/// border of a triangle is followed by increasing v (t).
enum class Transition { out, in, touching };

/// In BranchEnd::side, until branches are joined: an end on a line on which parts of a triangle meet.
inline constexpr int seam_in_triangle = 2;

/// Where a curve begins or ends.
struct BranchEnd {
  BranchEndKind kind = BranchEndKind::border;
  /// Of a border, for each of u, v, s, t: -1 at its lower bound, 1 at its upper one, 0 inside.
  std::array<int, 4> side{};
  /// Of the first and of the second surface, where they are triangles: on the border u + v = 1 (s + t = 1).
  std::array<bool, 2> third_side{};
  Transition transition = Transition::touching;
  /// Of a singular point.
  std::optional<std::size_t> singular_point;
};

/// A curve as a cubic B-spline in (u, v, s, t, x, y, z).
struct BranchSpline {
  std::size_t degree = 3;
  /// With the ends repeated degree + 1 times.
  std::vector<double> knots;
  std::vector<std::array<double, 7>> control_points;
  /// Bounds the distance in space from the true curve.
  double error = 0;
};

/// A piece of the intersection, as a user wants it: from end to end.
struct SurfaceComponent {
  SurfaceComponentKind kind = SurfaceComponentKind::curve;
  /// From start to end; of a loop the last point is the first. Of an overlap: its outline, closed; empty
  /// where that is the whole of surfaces without domains.
  std::vector<SurfacePoint> points;
  /// Of an arc.
  BranchEnd start;
  BranchEnd end;
  /// The surfaces are tangent along it.
  bool tangential = false;
  /// Of a self-intersection: exchanging both preimages maps the curve to itself.
  bool mirrored = false;
  /// Of the first and of the second surface: it runs along a line on which parts of a triangle meet, so that it is
  /// found in both.
  std::array<bool, 2> along_seam{};
  /// Bounds the distance in space of every point of the polyline from the true curve and the other way round.
  double error = 0;
  std::optional<BranchSpline> spline;
  /// There is exactly one such curve, it is of the kind said, and `error` is proven.
  bool certified = false;
  /// Why not, where `certified` is false.
  std::string reason;
};

enum class SurfaceSingularity {
  contact,       ///< the surfaces touch in that point alone
  crossing,      ///< branches cross at a point of contact
  cusp,          ///< a singular point of another kind
  pinch_point,   ///< of one surface: both parameter pairs become one
  triple_point,  ///< of one surface: three branches of double points meet
  undecided
};

/// A point at which the intersection is not a smooth curve.
struct SurfaceSingularPoint {
  SurfaceSingularity kind = SurfaceSingularity::undecided;
  SurfacePoint at;
  /// Bounds the error of each parameter and coordinate; of an infinite parameter that of its inverse.
  double radius = 0;
  /// Of a triple point, beside the two in `at`.
  std::optional<std::array<double, 2>> third_preimage;
  /// Half-branches of the real curve there.
  std::size_t half_branches = 0;
  bool certified = false;
  std::string reason;
};

/// The projection to two of the parameters: the eliminant (symbolic/elimination/bezoutian_eliminant).
struct SurfaceProjection {
  /// The two parameters kept: (u, t), or (u, v) of one surface.
  std::vector<std::string> variables;
  symbolic::BezoutianEliminant eliminant;
};

struct SurfaceCounts {
  unsigned long curves = 0;
  unsigned long loops = 0;
  unsigned long points = 0;
  unsigned long overlaps = 0;
  unsigned long singular = 0;
  /// Real points or components of the projection that lift to complex or infinite parameters only.
  unsigned long excluded = 0;
};

/// What two surfaces, or one surface with itself, have in common.
struct SurfaceResult {
  std::string problem = "surface_surface";
  Status status = Status::numeric;
  /// With `infinite`: of what is listed beside the overlaps.
  std::optional<Status> rest_status;
  std::optional<std::string> limit;
  SurfaceCounts counts;
  /// Curves first, then loops, points, overlaps; each sorted by the smallest parameters (u, v, s, t) of their points.
  std::vector<SurfaceComponent> components;
  std::vector<SurfaceSingularPoint> singular_points;
  std::optional<SurfaceProjection> projection;
  EngineReport engine;
  std::vector<std::pair<std::string, double>> seconds;
  std::vector<std::string> warnings;
};

}  // namespace eliminant::intersect
