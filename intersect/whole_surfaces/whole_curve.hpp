// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/intersect/whole_surfaces/arc_filling.hpp>
#include <eliminant/intersect/whole_surfaces/projected_arcs.hpp>
#include <eliminant/intersect/whole_surfaces/projection_charts.hpp>
#include <eliminant/intersect/whole_surfaces/tube_tracing.hpp>
#include <eliminant/intersect/whole_surfaces/vertex_lifts.hpp>

namespace eliminant::intersect {

/// Points farther away, compared with the size of the curve, are not drawn.
inline constexpr double drawn_reach = 100;

/// Two surfaces, or one twice, in parameters (u, v) and (s, t) that suit the projection to (u, t).
struct PreparedSurfaces {
  symbolic::RationalSurface first;
  symbolic::RationalSurface second;
  bool with_itself = false;
  /// Which parameter of the problem, in the order u, v, s, t, each of those here is.
  std::array<std::size_t, 4> source{0, 1, 2, 3};
  /// u and t for the parameters of the projection, in which nothing particular happens where these are infinite; of
  /// one surface, for the parameters of each of its two points.
  std::array<ProjectiveChange, 2> change{};

  /// In the parameters of the projection.
  symbolic::RationalSurface changed_first() const {
    return change_parameters(first, {change[0], with_itself ? change[1] : ProjectiveChange()});
  }
  symbolic::RationalSurface changed_second() const {
    return change_parameters(second, {with_itself ? change[0] : ProjectiveChange(), change[1]});
  }
};

/// The intersection curve above a squarefree projection, each of whose points has one common point above it in general.
/// Branches are traced (whole_curve), ended and continued over gaps (whole_curve_ends), singular points explained
/// (whole_curve_vertices), both copies of double curves folded (whole_curve_folding), all presented
/// (whole_curve_components).
class WholeCurve {
 public:
  /// All must outlive the object. `extraneous` is the product of the other factors of the determinant.
  WholeCurve(const PreparedSurfaces& surfaces, const symbolic::Polynomial& curve,
             const symbolic::Polynomial& extraneous, const Options& options, const Context& context);

  WholeCurve(const WholeCurve&) = delete;
  WholeCurve& operator=(const WholeCurve&) = delete;

  /// Fills components, singular points, counts and warnings. True when all of it is proven.
  bool find(SurfaceResult& result);

 private:
  /// The rest of an arc that the tracer left: towards its end, 0 or 1.
  struct ArcEnd {
    std::size_t arc = 0;
    std::size_t end = 0;
  };
  /// Parameters u and t in charts, between which an arc of the projection stays.
  struct KeptBox {
    std::array<bool, 2> inverted{};
    std::array<DoubleInterval, 2> box;
  };
  /// A chord that no tube proves; the arc below it is in the box.
  struct Gap {
    std::size_t chord = 0;
    std::optional<KeptBox> below;
  };
  /// Between a point of a branch and the next one.
  struct Chord {
    /// Bounds the distance in space from the branch.
    double error = 0;
    bool crosses_infinity = false;
    /// Holds that part of the branch.
    std::optional<BranchTube> tube;
  };
  struct Branch {
    std::vector<PointEnclosure> points;
    std::vector<Chord> chords;
    std::vector<Gap> gaps;
    bool mirrored = false;
    bool closed = false;
    std::array<std::optional<ArcEnd>, 2> ends;
    /// Pinch points take the place of ends.
    std::array<std::optional<std::size_t>, 2> pinch_points;
    /// Bounds the distance of the chord to the pinch point from the branch.
    std::array<double, 2> pinch_errors{};
    /// Why errors of chords are estimates, if some are.
    std::string reason;
  };
  struct VertexState {
    VertexLifts::Found lift;
    bool at_infinity = false;
    std::optional<std::size_t> singular_point;
    std::size_t branches = 0;  ///< that ended there
    bool repeats = false;      ///< the singular point is that of another vertex
  };

  void trace_all(SurfaceResult& result);
  void mark_unbounded(BranchSeed& seed) const;
  Branch trace_from(std::size_t seed, SurfaceResult& result);
  /// From a seed to one side, over gaps that tubes cannot pass but arcs of the projection do.
  Branch walk(const TubeTracer& tracer, std::size_t seed, bool forward, SurfaceResult& result);
  void append(Branch& branch, const TracedBranch& traced) const;
  /// Whether the branch ends at the end of the arc, near which it was left.
  bool is_end(const ArcEnd& end, const PointEnclosure& last, SurfaceResult& result);
  /// Whether a point is near the vertex at an end of an arc.
  bool is_near(std::size_t arc, std::size_t end, const PointEnclosure& last, double tolerance) const;
  std::optional<std::size_t> seed_beyond(const ArcEnd& end, const PointEnclosure& last);
  /// Holds the arc between two points above it; over a vertex at which two arcs meet, if one is given.
  std::optional<KeptBox> box_between(std::size_t arc, const PointEnclosure& from, const PointEnclosure& to,
                                     const std::optional<std::size_t>& vertex = {}) const;
  /// Bounds the distance of the chord from the branch above an arc that is held by the box.
  std::optional<double> gap_error(const KeptBox& below, const PointEnclosure& from, const PointEnclosure& to) const;
  /// Goes on to the other arc at a smooth vertex, whose index is returned.
  std::optional<std::size_t> turn_at_vertex(ArcEnd& end) const;
  std::optional<ArcEnd> arc_end(const TracedBranch& traced, std::size_t seed, bool forward) const;
  /// The diameter in space of the boxes that touch and hold both points.
  std::optional<double> distance_within(const std::vector<FibreBox>& boxes, const PointEnclosure& from,
                                        const PointEnclosure& to) const;
  /// Whether a traced branch is proven to stay above the inside of an arc, from a segment on.
  bool stays_above(std::size_t arc, std::size_t axis, const TracedBranch& traced, std::size_t first_segment) const;
  VertexState& state(std::size_t vertex, SurfaceResult& result);
  bool is_at_infinity(const TopologyVertex& vertex) const;
  void add_singular_point(std::size_t vertex, VertexState& state, SurfaceResult& result);
  void finish_vertices(SurfaceResult& result);
  BranchEnd branch_end(const Branch& branch, std::size_t end, SurfaceResult& result, std::string& reason);
  /// Draws a branch up to the singular point at its end.
  void close_gap(SurfaceComponent& piece, const Branch& branch, std::size_t end, const BranchEnd& at,
                 const SurfaceResult& result) const;
  bool weight_changes_sign(const PointEnclosure& from, const PointEnclosure& to) const;
  /// Of a surface with itself: of every two branches that the exchange of both points maps to each other one remains;
  /// of a branch mapped to itself the half from pinch point to its end, or to the next pinch point.
  void fold(std::vector<Branch>& branches, SurfaceResult& result);
  void halve(Branch& branch, SurfaceResult& result);
  /// The parameters in the gap's charts at which the exchange of both points turns the branch round.
  std::optional<std::array<DoubleInterval, 2>> enclosed_pinch_point(const Gap& gap) const;
  SurfaceSingularPoint pinch_point(const Branch& branch, const Gap& gap) const;
  /// Draws the branch to the pinch point that takes the place of an end.
  void lead_to_pinch_point(Branch& branch, std::size_t end, const Gap& gap) const;
  void add_components(const Branch& branch, SurfaceResult& result);
  SurfaceComponent component(const Branch& branch, std::size_t first, std::size_t last, bool from_infinity,
                             bool to_infinity) const;
  /// Points between a point of the branch and the next one, and the latter, with the tolerance asked for.
  std::vector<ArcPoint> filled(const Branch& branch, std::size_t chord) const;
  /// Largest distance in space of a polyline near a point from the branch.
  double tolerance_at(const PointEnclosure& point) const;
  bool are_polynomial() const { return is_polynomial(surfaces_.first) && is_polynomial(surfaces_.second); }
  SurfacePoint presented(const PointEnclosure& point) const;
  void doubt(SurfaceResult& result, const std::string& reason);

  const PreparedSurfaces& surfaces_;
  const Options& options_;
  const Context& context_;
  SurfacePair pair_;
  symbolic::SeparatedBezoutian matrix_;
  ProjectedArcs arcs_;
  VertexLifts lifts_;
  std::vector<WeightFactor> weights_;
  std::vector<BranchSeed> seeds_;
  TracingLimits limits_;
  std::vector<std::size_t> visits_;
  std::map<std::size_t, VertexState> states_;
  bool proven_ = true;
};

}  // namespace eliminant::intersect
