// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/whole_curve.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::intersect {

namespace {

/// The topology is asked for boxes with fewer digits than doubles have: a zero proven nearby then surely lies inside.
Options topology_options(const Options& options) {
  Options result = options;
  result.digits = 12;
  result.engine = Engine::automatic;
  result.certify = true;
  return result;
}

}  // namespace

WholeCurve::WholeCurve(const PreparedSurfaces& surfaces, const symbolic::Polynomial& curve,
                       const symbolic::Polynomial& extraneous, const Options& options, const Context& context)
    : surfaces_(surfaces),
      options_(options),
      context_(context),
      pair_(surfaces.first, surfaces.second),
      matrix_(surfaces.changed_first(), surfaces.changed_second()),
      arcs_(curve, extraneous, surfaces.change, topology_options(options), context),
      lifts_(pair_, matrix_, surfaces.with_itself),
      weights_(weight_factors(surfaces.first, surfaces.second, options.seed)) {}

void WholeCurve::doubt(SurfaceResult& result, const std::string& reason) {
  proven_ = false;
  if (std::find(result.warnings.begin(), result.warnings.end(), reason) == result.warnings.end())
    result.warnings.push_back(reason);
}

bool WholeCurve::find(SurfaceResult& result) {
  if (arcs_.topology().status != Status::certified) doubt(result, "the topology of the projection is not proven");
  trace_all(result);
  finish_vertices(result);
  return proven_;
}

void WholeCurve::trace_all(SurfaceResult& result) {
  std::vector<double> sizes;
  std::vector<std::size_t> seedless;
  for (std::size_t arc = 0; arc < arcs_.arcs().size(); ++arc) {
    std::optional<BranchSeed> seed;
    for (const double share : {0.5, 0.4, 0.6, 0.25, 0.75})
      if (!seed) seed = arcs_.seed_above(pair_, arc, arcs_.parameter_at(arc, share), context_);
    if (!seed) {
      seedless.push_back(arc);
      continue;
    }
    double reach = 0;
    for (const DoubleInterval& x : pair_.point(seed->point.inverted, seed->point.box))
      if (x.is_finite()) reach = std::max(reach, std::fabs(middle(x)));
    sizes.push_back(reach);
    mark_unbounded(*seed);
    seeds_.push_back(*std::move(seed));
  }
  if (!seedless.empty())
    doubt(result, "no point was proven above " + std::to_string(seedless.size()) + " arcs of the projection");
  // Arcs that go to infinity make some of them very large.
  std::sort(sizes.begin(), sizes.end());
  if (!sizes.empty() && sizes[sizes.size() / 2] > 0) limits_.size = sizes[sizes.size() / 2];
  limits_.tolerance = std::max(options_.tolerance, 1e-3);
  if (are_polynomial()) limits_.reach = 10 * drawn_reach;
  visits_.assign(seeds_.size(), 0);
  const std::size_t arcs = seeds_.size();
  std::vector<Branch> branches;
  for (std::size_t seed = 0; seed < arcs; ++seed)
    if (visits_[seed] == 0) branches.push_back(trace_from(seed, result));
  for (const Branch& branch : branches)
    for (const std::optional<ArcEnd>& end : branch.ends)
      if (end && !branch.closed) ++state(arcs_.arcs()[end->arc].ends[end->end], result).branches;
  if (surfaces_.with_itself) fold(branches, result);
  for (const Branch& branch : branches) add_components(branch, result);
  if (std::any_of(visits_.begin(), visits_.end(), [](std::size_t visits) { return visits != 1; }))
    doubt(result, "an arc was traced more than once");
}

void WholeCurve::mark_unbounded(BranchSeed& seed) const {
  const ProjectedArc& arc = arcs_.arcs()[seed.arc];
  const bool increasing = arcs_.from_chart(seed.axis == 0 ? 0 : 1, seed.point.inverted[seed.axis]).is_increasing();
  for (std::size_t end = 0; end < 2; ++end)
    seed.unbounded[increasing ? end : 1 - end] =
        are_polynomial() && arcs_.topology().vertices[arc.ends[end]].kind == VertexKind::infinity;
}

WholeCurve::Branch WholeCurve::trace_from(std::size_t seed, SurfaceResult& result) {
  const TubeTracer tracer(pair_, seeds_, weights_, limits_, context_);
  ++visits_[seed];
  Branch branch = walk(tracer, seed, true, result);
  if (!branch.closed) {
    Branch back = walk(tracer, seed, false, result);
    std::reverse(back.points.begin(), back.points.end());
    std::reverse(back.chords.begin(), back.chords.end());
    back.points.pop_back();
    for (Gap& gap : branch.gaps) gap.chord += back.chords.size();
    for (const Gap& gap : back.gaps) branch.gaps.push_back({back.chords.size() - 1 - gap.chord, gap.below});
    branch.points.insert(branch.points.begin(), back.points.begin(), back.points.end());
    branch.chords.insert(branch.chords.begin(), back.chords.begin(), back.chords.end());
    branch.ends[0] = back.ends[1];
    if (branch.reason.empty()) branch.reason = back.reason;
  } else {
    // The last tube reaches beyond the seed; what it crosses there was met by the first one.
    branch.points.back() = branch.points.front();
    bool& crosses = branch.chords.back().crosses_infinity;
    crosses = crosses && weight_changes_sign(branch.points[branch.points.size() - 2], branch.points.front());
  }
  return branch;
}

void WholeCurve::append(Branch& branch, const TracedBranch& traced) const {
  for (const BranchSegment& segment : traced.segments) {
    branch.points.push_back(segment.end);
    branch.chords.push_back({segment.error, segment.crosses_infinity, segment.tube});
  }
}

WholeCurve::Branch WholeCurve::walk(const TubeTracer& tracer, std::size_t seed, bool forward, SurfaceResult& result) {
  Branch branch;
  branch.points.push_back(seeds_[seed].point);
  std::size_t from = seed;
  for (int gaps = 0; gaps < 40; ++gaps) {
    const TracedBranch traced = tracer.trace(from, forward, seed);
    append(branch, traced);
    for (const SeedPassage& passage : traced.passages)
      if (passage.seed != seed) ++visits_[passage.seed];
    branch.closed = traced.closed;
    if (traced.closed) break;
    branch.ends[1] = arc_end(traced, from, forward);
    if (!branch.ends[1] || is_end(*branch.ends[1], branch.points.back(), result)) break;
    std::optional<std::size_t> vertex;
    std::optional<std::size_t> next;
    if (!is_near(branch.ends[1]->arc, branch.ends[1]->end, branch.points.back(), 1e-3))
      next = seed_beyond(*branch.ends[1], branch.points.back());
    if (!next) {
      vertex = turn_at_vertex(*branch.ends[1]);
      if (vertex) next = seed_beyond(*branch.ends[1], branch.points.back());
    }
    if (!next) {
      branch.ends[1].reset();
      break;
    }
    // The arc goes on, and the branch above it: draw it from the other side, too.
    from = *next;
    const std::size_t arc = branch.ends[1]->arc;
    const std::size_t axis = seeds_[from].axis;
    const std::size_t own = axis == 0 ? 0 : 1;
    const bool increasing = arcs_.from_chart(own, seeds_[from].point.inverted[axis]).is_increasing();
    forward = (branch.ends[1]->end == 1) == increasing;
    TracedBranch back = tracer.trace(from, !forward, from);
    const double left = middle(arcs_.projection(branch.points.back())[own]);
    const auto is_behind = [&](const BranchSegment& segment) {
      const double x = middle(arcs_.projection(segment.end)[own]);
      if (vertex) return false;
      return branch.ends[1]->end == 1 ? x < left : x > left;
    };
    // Nothing but the least step was in the way: what is behind was traced before.
    if (!back.passages.empty() || std::any_of(back.segments.begin(), back.segments.end(), is_behind)) back = {};
    for (const SeedPassage& passage : back.passages) ++visits_[passage.seed];
    const PointEnclosure beyond = back.segments.empty() ? seeds_[from].point : back.segments.back().end;
    const auto below = box_between(arc, branch.points.back(), beyond, vertex);
    const auto error = below ? gap_error(*below, branch.points.back(), beyond) : std::nullopt;
    if (!error)
      branch.reason = "how far the polyline is from the curve is not proven near a point that tubes cannot pass";
    branch.gaps.push_back({branch.chords.size(), below});
    branch.chords.push_back({error.value_or(0), weight_changes_sign(branch.points.back(), beyond), {}});
    for (std::size_t k = back.segments.size(); k-- > 0;) {
      const BranchSegment& segment = back.segments[k];
      branch.points.push_back(segment.end);
      branch.chords.push_back({segment.error, segment.crosses_infinity, segment.tube});
    }
    branch.points.push_back(seeds_[from].point);
  }
  return branch;
}

}  // namespace eliminant::intersect
