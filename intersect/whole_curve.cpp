// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_curve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <eliminant/bridge/krawczyk_system.hpp>

namespace eliminant::intersect {

namespace {

/// Points farther away, compared with the size of the curve, are not drawn.
constexpr double drawn_reach = 100;

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
  const BranchTracer tracer(pair_, seeds_, weights_, limits_, context_);
  ++visits_[seed];
  Branch branch = walk(tracer, seed, true, result);
  if (!branch.closed) {
    Branch back = walk(tracer, seed, false, result);
    std::reverse(back.points.begin(), back.points.end());
    std::reverse(back.errors.begin(), back.errors.end());
    std::reverse(back.crosses.begin(), back.crosses.end());
    back.points.pop_back();
    for (std::size_t& gap : branch.gaps) gap += back.errors.size();
    for (const std::size_t gap : back.gaps) branch.gaps.push_back(back.errors.size() - 1 - gap);
    branch.tubes.insert(branch.tubes.end(), back.tubes.begin(), back.tubes.end());
    branch.points.insert(branch.points.begin(), back.points.begin(), back.points.end());
    branch.errors.insert(branch.errors.begin(), back.errors.begin(), back.errors.end());
    branch.crosses.insert(branch.crosses.begin(), back.crosses.begin(), back.crosses.end());
    branch.ends[0] = back.ends[1];
    if (branch.reason.empty()) branch.reason = back.reason;
  } else {
    branch.points.back() = branch.points.front();
  }
  return branch;
}

void WholeCurve::append(Branch& branch, const TracedBranch& traced) const {
  for (const BranchSegment& segment : traced.segments) {
    branch.points.push_back(segment.end);
    branch.errors.push_back(segment.error);
    branch.crosses.push_back(segment.crosses_infinity);
    if (surfaces_.with_itself) branch.tubes.push_back(segment.tube);
  }
}

WholeCurve::Branch WholeCurve::walk(const BranchTracer& tracer, std::size_t seed, bool forward, SurfaceResult& result) {
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
    const auto error = gap_error(arc, branch.points.back(), beyond, vertex);
    if (!error)
      branch.reason = "how far the polyline is from the curve is not proven near a point that tubes cannot pass";
    branch.gaps.push_back(branch.errors.size());
    branch.errors.push_back(error.value_or(0));
    branch.crosses.push_back(weight_changes_sign(branch.points.back(), beyond));
    if (surfaces_.with_itself)
      for (const BranchSegment& segment : back.segments) branch.tubes.push_back(segment.tube);
    for (std::size_t k = back.segments.size(); k-- > 0;) {
      branch.points.push_back(back.segments[k].end);
      branch.errors.push_back(back.segments[k].error);
      branch.crosses.push_back(back.segments[k].crosses_infinity);
    }
    branch.points.push_back(seeds_[from].point);
  }
  return branch;
}

std::optional<std::size_t> WholeCurve::turn_at_vertex(ArcEnd& end) const {
  const std::size_t index = arcs_.arcs()[end.arc].ends[end.end];
  const TopologyVertex& vertex = arcs_.topology().vertices[index];
  if (vertex.kind == VertexKind::infinity || vertex.milnor_number > 0 || vertex.half_branches() != 2)
    return std::nullopt;
  for (std::size_t arc = 0; arc < arcs_.arcs().size(); ++arc)
    for (std::size_t side = 0; side < 2; ++side)
      if (arcs_.arcs()[arc].ends[side] == index && !(arc == end.arc && side == end.end)) {
        end = {arc, 1 - side};
        return index;
      }
  return std::nullopt;
}

bool WholeCurve::is_end(const ArcEnd& end, const PointEnclosure& last, SurfaceResult& result) {
  const std::size_t index = arcs_.arcs()[end.arc].ends[end.end];
  const TopologyVertex& vertex = arcs_.topology().vertices[index];
  const VertexState& there = state(index, result);
  if (!there.at_infinity && !there.singular_point) return false;
  if (vertex.kind == VertexKind::infinity) {
    double reach = 0;
    for (const DoubleInterval& x : pair_.point(last.inverted, last.box)) reach = std::max(reach, x.magnitude());
    return reach > drawn_reach * limits_.size;
  }
  return is_near(end.arc, end.end, last, 1e-2);
}

bool WholeCurve::is_near(std::size_t arc, std::size_t end, const PointEnclosure& last, double tolerance) const {
  const std::size_t index = arcs_.arcs()[arc].ends[end];
  if (arcs_.topology().vertices[index].kind == VertexKind::infinity) return false;
  const auto at = arcs_.projection(last);
  const auto goal = arcs_.enclosure(index);
  for (std::size_t i = 0; i < 2; ++i)
    if (!(std::fabs(middle(at[i]) - middle(goal[i])) < tolerance * (1 + goal[i].magnitude()))) return false;
  return true;
}

std::optional<std::size_t> WholeCurve::seed_beyond(const ArcEnd& end, const PointEnclosure& last) {
  const auto at = arcs_.projection(last);
  const ProjectedArc& arc = arcs_.arcs()[end.arc];
  double parameter = middle(at[arc.vertical ? 1 : 0]);
  // Where the arc begins beyond a vertex.
  parameter = std::min(std::max(parameter, arc.inside.lower), arc.inside.upper);
  for (const double beyond : arcs_.parameters_beyond(end.arc, parameter, end.end)) {
    auto seed = arcs_.seed_above(pair_, end.arc, beyond, context_);
    if (!seed) continue;
    mark_unbounded(*seed);
    seeds_.push_back(*std::move(seed));
    visits_.push_back(1);
    return seeds_.size() - 1;
  }
  return std::nullopt;
}

std::optional<double> WholeCurve::gap_error(std::size_t arc, const PointEnclosure& from, const PointEnclosure& to,
                                            const std::optional<std::size_t>& vertex) const {
  auto at = arcs_.projection(from);
  if (vertex)
    for (std::size_t i = 0; i < 2; ++i) at[i] = hull(at[i], arcs_.enclosure(*vertex)[i]);
  const auto box = arcs_.box_between(arc, at, arcs_.projection(to), context_);
  if (!box) return std::nullopt;
  std::array<DoubleInterval, 2> kept;
  for (std::size_t i = 0; i < 2; ++i) kept[i] = arcs_.from_chart(i, from.inverted[3 * i]).inverse()((*box)[i]);
  if (!kept[0].is_finite() || !kept[1].is_finite()) return std::nullopt;
  std::optional<double> best;
  for (double side = 0x1p-6; side > 1e-9; side /= 8) {
    const auto boxes = fibre_boxes(pair_, from.inverted, kept[0], kept[1], side, 1000);
    if (!boxes) break;
    const auto error = distance_within(*boxes, from, to);
    if (error && best && *error > 0.5 * *best) break;
    if (error) best = error;
  }
  return best;
}

std::optional<double> WholeCurve::distance_within(const std::vector<FibreBox>& boxes, const PointEnclosure& from,
                                                  const PointEnclosure& to) const {
  // v and s change continuously along the branch, so that it stays in boxes that touch.
  for (const auto& members : gather_boxes(boxes)) {
    const auto group = hull_of(boxes, members);
    if (!group) return std::nullopt;
    const auto holds = [&](const PointEnclosure& point) {
      const ParameterBox moved = in_charts(point.box, point.inverted, group->inverted);
      return overlap(moved[1], group->box[1]) && overlap(moved[2], group->box[2]);
    };
    if (!holds(from) || !holds(to)) continue;
    // Both surfaces hold the branch.
    double least = std::numeric_limits<double>::infinity();
    for (const SpaceBox& point :
         {pair_.point(group->inverted, group->box), pair_.second_point(group->inverted, group->box)}) {
      double square = 0;
      for (const DoubleInterval& x : point) square += width(x) * width(x);
      least = std::min(least, std::sqrt(square) * (1 + 1e-12));
    }
    if (std::isfinite(least)) return least;
  }
  return std::nullopt;
}

bool WholeCurve::stays_above(std::size_t index, std::size_t axis, const TracedBranch& traced,
                             std::size_t first_segment) const {
  const ProjectedArc& arc = arcs_.arcs()[index];
  for (std::size_t k = first_segment; k < traced.segments.size(); ++k) {
    const BranchTube& tube = traced.segments[k].tube;
    const DoubleInterval at = arcs_.from_chart(axis == 0 ? 0 : 1, tube.centre.inverted[axis])(tube.hull[axis]);
    // Finite points do not reach an end at infinity of two polynomial surfaces.
    const auto is_free = [&](std::size_t end) {
      return !traced.segments[k].crosses_infinity && are_polynomial() &&
             arcs_.topology().vertices[arc.ends[end]].kind == VertexKind::infinity;
    };
    if (!(arc.inside.lower < at.lower || is_free(0)) || !(at.upper < arc.inside.upper || is_free(1))) return false;
  }
  return true;
}

std::optional<WholeCurve::ArcEnd> WholeCurve::arc_end(const TracedBranch& traced, std::size_t seed,
                                                      bool forward) const {
  std::size_t last = seed;
  std::size_t first_segment = 0;
  if (!traced.passages.empty()) {
    last = traced.passages.back().seed;
    first_segment = traced.passages.back().segment;
    forward = traced.passages.back().forward;
  }
  // As long as its parameter stays between the ends of the arc the branch stays above it, and on its side of the seed.
  const BranchSeed& start = seeds_[last];
  if (stays_above(start.arc, start.axis, traced, first_segment)) {
    const bool increasing =
        forward == arcs_.from_chart(start.axis == 0 ? 0 : 1, start.point.inverted[start.axis]).is_increasing();
    return ArcEnd{start.arc, increasing ? std::size_t{1} : std::size_t{0}};
  }
  // It passed a vertex, but no seed since.
  for (std::size_t back = 1; back <= 8 && back + first_segment <= traced.segments.size(); ++back) {
    const std::size_t k = traced.segments.size() - back;
    const BranchSegment& segment = traced.segments[k];
    const DoubleInterval speed = segment.tube.velocity[0];
    if (!speed.excludes_zero()) continue;
    const auto arc = arcs_.arc_below(pair_, segment.end, context_);
    if (!arc || !stays_above(*arc, 0, traced, k + 1)) continue;
    const bool along = segment.tube.centre.at[segment.tube.axis] < middle(segment.end.box[segment.tube.axis]);
    const bool increasing =
        ((speed.lower > 0) == along) == arcs_.from_chart(0, segment.end.inverted[0]).is_increasing();
    return ArcEnd{*arc, increasing ? std::size_t{1} : std::size_t{0}};
  }
  return std::nullopt;
}

bool WholeCurve::is_at_infinity(const TopologyVertex& vertex) const {
  if (!are_polynomial()) return false;
  // The coefficients of the highest powers of v and s, the points for v = inf and s = inf, are parallel.
  const long n = surfaces_.first.bidegree()[1];
  const long m = surfaces_.second.bidegree()[0];
  if (n < 2 || m < 2) return false;
  const auto leading = [](const symbolic::Polynomial& p, std::size_t eliminated, long degree) {
    const auto hidden = symbolic::hide_variable(p, 1 - eliminated);
    return hidden.degree() == degree ? hidden.leading_coefficient() : symbolic::UnivariatePolynomial();
  };
  std::array<std::array<symbolic::UnivariatePolynomial, 3>, 2> points;
  for (std::size_t c = 0; c < 3; ++c) {
    // Integer coefficients: no denominators that differ.
    points[0][c] = leading(surfaces_.first.coordinates()[c], 1, n);
    points[1][c] = leading(surfaces_.second.coordinates()[c], 0, m);
  }
  const auto evaluate = [](const symbolic::UnivariatePolynomial& p, const bridge::ComplexBall& at, long precision) {
    bridge::ComplexBall result;
    for (long i = p.degree(); i >= 0; --i) {
      acb_mul(result.get(), result.get(), at.get(), precision);
      acb_add_fmpz(result.get(), result.get(), p.coefficient(i).get(), precision);
    }
    return result;
  };
  const long precision = 160;
  for (std::size_t k = 0; k < 3; ++k) {
    const bridge::System system = [&](const std::vector<bridge::ComplexBall>& at, long bits) {
      bridge::SystemValue value{{}, {}};
      for (std::size_t c = 0; c < 3; ++c) {
        if (c == k) continue;
        const auto product = [&](const auto& a, const auto& b, const auto& d, const auto& e) {
          bridge::ComplexBall first = evaluate(a, at[0], bits);
          const bridge::ComplexBall second = evaluate(b, at[1], bits);
          bridge::ComplexBall third = evaluate(d, at[0], bits);
          const bridge::ComplexBall fourth = evaluate(e, at[1], bits);
          acb_mul(first.get(), first.get(), second.get(), bits);
          acb_submul(first.get(), third.get(), fourth.get(), bits);
          return first;
        };
        const auto& [a, b] = points;
        value.values.push_back(product(a[k], b[c], a[c], b[k]));
        value.jacobian.push_back({product(a[k].derivative(), b[c], a[c].derivative(), b[k]),
                                  product(a[k], b[c].derivative(), a[c], b[k].derivative())});
      }
      return value;
    };
    const auto zero = bridge::enclose_system_zero(system, {vertex.x.ball, vertex.y.ball}, precision);
    if (!zero) continue;
    if (acb_contains_zero(evaluate(points[0][k], (*zero)[0], precision).get()) != 0) continue;
    if (acb_contains_zero(evaluate(points[1][k], (*zero)[1], precision).get()) != 0) continue;
    // The printed box holds one point with D = D_t = 0, and both sheets touch the plane at infinity here: it is that.
    const double radius = std::pow(10.0, static_cast<double>(vertex.radius_exponent));
    bool near = true;
    for (const auto& [coordinate, ball] : {std::pair(&vertex.x, &(*zero)[0]), std::pair(&vertex.y, &(*zero)[1])}) {
      bridge::ComplexBall distance;
      acb_sub(distance.get(), ball->get(), coordinate->ball.get(), precision);
      bridge::Magnitude bound;
      acb_get_mag(bound.get(), distance.get());
      near = near && mag_get_d(bound.get()) < radius / 4;
    }
    if (near) return true;
  }
  return false;
}

WholeCurve::VertexState& WholeCurve::state(std::size_t index, SurfaceResult& result) {
  const auto [place, is_new] = states_.try_emplace(index);
  VertexState& state = place->second;
  if (!is_new) return state;
  const TopologyVertex& vertex = arcs_.topology().vertices[index];
  if (vertex.kind == VertexKind::infinity) {
    state.at_infinity = are_polynomial();
    return state;
  }
  state.at_infinity = is_at_infinity(vertex);
  if (state.at_infinity) return state;
  if (vertex.milnor_number == 0) return state;
  std::array<DoubleInterval, 2> kept = arcs_.enclosure(index);
  std::array<bool, 2> inverted{};
  for (std::size_t i = 0; i < 2; ++i) {
    inverted[i] = !(arcs_.from_chart(i, false).inverse()(kept[i]).magnitude() <= 1);
    kept[i] = arcs_.from_chart(i, inverted[i]).inverse()(kept[i]);
  }
  state.lift = lifts_.above(vertex, inverted, kept);
  if (state.lift.lift == VertexLift::one_point) add_singular_point(index, state, result);
  return state;
}

void WholeCurve::add_singular_point(std::size_t index, VertexState& state, SurfaceResult& result) {
  const TopologyVertex& vertex = arcs_.topology().vertices[index];
  const FibreBox& box = *state.lift.box;
  const SpaceBox point = pair_.point(box.inverted, box.box);
  SurfaceSingularPoint singular;
  singular.at = presented({box.inverted, box.box});
  singular.half_branches = vertex.half_branches();
  singular.kind = singular.half_branches == 0   ? SurfaceSingularity::contact
                  : singular.half_branches == 2 ? SurfaceSingularity::cusp
                                                : SurfaceSingularity::crossing;
  for (const DoubleInterval& side : box.box) singular.radius = std::max(singular.radius, width(side));
  bool finite = true;
  for (const DoubleInterval& x : point) {
    finite = finite && x.is_finite();
    singular.radius = std::max(singular.radius, width(x));
  }
  if (!finite) {
    state.lift.lift = VertexLift::undecided;
    doubt(result, "whether a singular point lies at infinity is not proven");
    return;
  }
  singular.certified = vertex.certified;
  if (!singular.certified) singular.reason = "the singular point of the projection is not proven";
  // Of one surface a point shows twice, with both preimages exchanged.
  const auto is_same = [&](const SurfaceSingularPoint& other) {
    for (std::size_t i = 0; i < 4; ++i) {
      const double a = singular.at.parameters[i];
      const double b = other.at.parameters[(i + 2) % 4];
      if (a != b && !(std::fabs(a - b) <= 2 * (singular.radius + other.radius) * (1 + std::fabs(a)))) return false;
    }
    return true;
  };
  if (surfaces_.with_itself)
    for (std::size_t k = 0; k < result.singular_points.size(); ++k)
      if (result.singular_points[k].kind == singular.kind && is_same(result.singular_points[k])) {
        state.singular_point = k;
        state.repeats = true;
        return;
      }
  state.singular_point = result.singular_points.size();
  result.singular_points.push_back(std::move(singular));
}

void WholeCurve::finish_vertices(SurfaceResult& result) {
  const TopologyResult& topology = arcs_.topology();
  for (std::size_t k = 0; k < topology.vertices.size(); ++k) {
    const TopologyVertex& vertex = topology.vertices[k];
    if (vertex.kind == VertexKind::infinity || vertex.milnor_number == 0) continue;
    VertexState& found = state(k, result);
    const std::string place = "(" + vertex.x.real + ", " + vertex.y.real + ")";
    if (found.at_infinity) {
      ++result.counts.excluded;
    } else if (found.singular_point) {
      if (vertex.half_branches() == 0 && !found.repeats) {
        SurfaceComponent component;
        component.kind = SurfaceComponentKind::point;
        component.points = {result.singular_points[*found.singular_point].at};
        component.start.kind = component.end.kind = BranchEndKind::singular;
        component.start.singular_point = component.end.singular_point = found.singular_point;
        component.error = result.singular_points[*found.singular_point].radius;
        component.tangential = true;
        component.certified = result.singular_points[*found.singular_point].certified;
        result.components.push_back(std::move(component));
      }
      if (found.branches != vertex.half_branches()) {
        doubt(result, "not all branches at the singular point above " + place + " were followed to it");
      }
    } else if (found.lift.lift == VertexLift::complex && vertex.half_branches() == 0) {
      ++result.counts.excluded;
    } else if (found.lift.lift != VertexLift::branches || found.branches != 0) {
      doubt(result, "what lies above the point " + place + " of the projection is not proven");
    }
  }
}

BranchEnd WholeCurve::branch_end(const Branch& branch, std::size_t which, SurfaceResult& result, std::string& reason) {
  BranchEnd found;
  if (branch.pinch_points[which]) {
    found.kind = BranchEndKind::singular;
    found.singular_point = branch.pinch_points[which];
    return found;
  }
  found.kind = BranchEndKind::unknown;
  const std::optional<ArcEnd>& end = branch.ends[which];
  if (end) {
    const std::size_t vertex = arcs_.arcs()[end->arc].ends[end->end];
    const VertexState& there = state(vertex, result);
    if (there.at_infinity) {
      found.kind = BranchEndKind::infinity;
      return found;
    }
    if (there.singular_point) {
      found.kind = BranchEndKind::singular;
      found.singular_point = there.singular_point;
      return found;
    }
  }
  reason = "the branch could not be followed beyond one of its ends";
  doubt(result, "a branch could not be followed to its end");
  return found;
}

SurfacePoint WholeCurve::presented(const PointEnclosure& point) const {
  SurfacePoint result;
  for (std::size_t i = 0; i < 4; ++i) {
    const double value = middle(point.box[i]);
    const double affine = !point.inverted[i] ? value : value == 0 ? std::numeric_limits<double>::infinity() : 1 / value;
    result.parameters[surfaces_.source[i]] = affine;
  }
  const SpaceBox place = pair_.point(point.inverted, point.box);
  for (std::size_t i = 0; i < 3; ++i) result.point[i] = middle(place[i]);
  return result;
}

SurfaceComponent WholeCurve::component(const Branch& branch, std::size_t first, std::size_t last, bool from_infinity,
                                       bool to_infinity) const {
  SurfaceComponent result;
  for (std::size_t k = first; k <= last; ++k) result.points.push_back(presented(branch.points[k]));
  const auto reach = [](const SurfacePoint& point) {
    return std::max({std::fabs(point.point[0]), std::fabs(point.point[1]), std::fabs(point.point[2])});
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (const SurfacePoint& point : result.points) nearest = std::min(nearest, reach(point));
  const auto is_far = [&](const SurfacePoint& point) {
    return !(reach(point) < drawn_reach * std::max(limits_.size, nearest));
  };
  std::size_t begin = 0;
  std::size_t end = result.points.size();
  while (from_infinity && begin + 1 < end && is_far(result.points[begin])) ++begin;
  while (to_infinity && begin + 1 < end && is_far(result.points[end - 1])) --end;
  result.points = {result.points.begin() + static_cast<long>(begin), result.points.begin() + static_cast<long>(end)};
  for (std::size_t k = begin; k + 1 < end; ++k) result.error = std::max(result.error, branch.errors[first + k]);
  result.certified = true;
  return result;
}

void WholeCurve::close_gap(SurfaceComponent& piece, const Branch& branch, std::size_t end, const BranchEnd& at,
                           const SurfaceResult& result) const {
  if (!at.singular_point) return;
  const SurfaceSingularPoint& point = result.singular_points[*at.singular_point];
  piece.points.insert(end == 0 ? piece.points.begin() : piece.points.end(), point.at);
  std::optional<double> error;
  if (branch.pinch_points[end]) {
    error = point.radius;
  } else if (branch.ends[end]) {
    const std::size_t vertex = arcs_.arcs()[branch.ends[end]->arc].ends[branch.ends[end]->end];
    const FibreBox& box = *states_.at(vertex).lift.box;
    const PointEnclosure& last = end == 0 ? branch.points.front() : branch.points.back();
    error = gap_error(branch.ends[end]->arc, last, {box.inverted, box.box});
  }
  if (error)
    piece.error = std::max(piece.error, *error);
  else if (piece.reason.empty())
    piece.reason = "how far the polyline is from the curve is not proven near a singular point";
}

bool WholeCurve::weight_changes_sign(const PointEnclosure& from, const PointEnclosure& to) const {
  const ParameterBox moved = in_charts(to.box, to.inverted, from.inverted);
  return std::any_of(weights_.begin(), weights_.end(), [&](const WeightFactor& factor) {
    return middle(factor.jet(from.inverted, from.box).value) * middle(factor.jet(from.inverted, moved).value) < 0;
  });
}

void WholeCurve::fold(std::vector<Branch>& branches, SurfaceResult& result) {
  const auto exchanged = [](const PointEnclosure& point) {
    return PointEnclosure{{point.inverted[2], point.inverted[3], point.inverted[0], point.inverted[1]},
                          {point.box[2], point.box[3], point.box[0], point.box[1]}};
  };
  const auto lies_on = [](const PointEnclosure& point, const Branch& branch) {
    return std::any_of(branch.tubes.begin(), branch.tubes.end(), [&](const BranchTube& tube) {
      return tube.holds(in_charts(point.box, point.inverted, tube.centre.inverted));
    });
  };
  const auto maps_to = [&](const Branch& from, const Branch& to) {
    const std::size_t stride = std::max<std::size_t>(1, from.points.size() / 64);
    for (std::size_t k = 0; k < from.points.size(); k += stride)
      if (lies_on(exchanged(from.points[k]), to)) return true;
    return false;
  };
  std::vector<Branch> kept;
  std::vector<bool> used(branches.size(), false);
  for (std::size_t k = 0; k < branches.size(); ++k) {
    if (used[k]) continue;
    bool found = false;
    for (std::size_t other = k; other < branches.size() && !found; ++other) {
      if (used[other] || !maps_to(branches[k], branches[other])) continue;
      found = used[other] = true;
      branches[k].mirrored = other == k;
    }
    if (!found) doubt(result, "the other preimages of a branch of double points were not found");
    if (branches[k].mirrored) halve(branches[k], result);
    kept.push_back(std::move(branches[k]));
  }
  branches = std::move(kept);
}

void WholeCurve::halve(Branch& branch, SurfaceResult& result) {
  // The exchange of both points turns the branch round: its fixed points, at which these are one, are pinch points. No
  // tube contains such a point.
  std::vector<std::size_t> turning;
  for (const std::size_t gap : branch.gaps) {
    bool turns = true;
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
      const auto difference = [&](const PointEnclosure& point) {
        const double a = middle(point.box[i]);
        const double b =
            middle(in_charts(point.box, point.inverted,
                             {point.inverted[0], point.inverted[1], point.inverted[0], point.inverted[1]})[i + 2]);
        return (b - a) * (point.inverted[i] ? -1 : 1);
      };
      const double before = difference(branch.points[gap]);
      const double after = difference(branch.points[gap + 1]);
      turns = turns && (before * after < 0 || std::max(std::fabs(before), std::fabs(after)) < 1e-9);
    }
    if (turns) turning.push_back(gap);
  }
  std::sort(turning.begin(), turning.end());
  if (turning.size() != (branch.closed ? 2U : 1U)) {
    branch.reason = "the pinch points of the branch were not found";
    doubt(result, branch.reason);
    return;
  }
  const auto pinch_point = [&](std::size_t gap) {
    SurfaceSingularPoint point;
    const SurfacePoint before = presented(branch.points[gap]);
    const SurfacePoint after = presented(branch.points[gap + 1]);
    for (std::size_t i = 0; i < 4; ++i) {
      // Of both points, exchanged.
      const double first = before.parameters[i] + after.parameters[i];
      const double second = before.parameters[(i + 2) % 4] + after.parameters[(i + 2) % 4];
      point.at.parameters[i] = (first + second) / 4;
    }
    for (std::size_t i = 0; i < 3; ++i) point.at.point[i] = (before.point[i] + after.point[i]) / 2;
    for (std::size_t i = 0; i < 4; ++i)
      point.radius = std::max(point.radius, std::fabs(before.parameters[i] - after.parameters[i]));
    point.radius = std::max(point.radius, branch.errors[gap]);
    point.kind = SurfaceSingularity::pinch_point;
    point.half_branches = 1;
    point.certified = branch.reason.empty();
    point.reason = branch.reason;
    result.singular_points.push_back(point);
    return result.singular_points.size() - 1;
  };
  const std::size_t first = turning.front();
  const std::size_t last = branch.closed ? turning.back() : branch.errors.size();
  branch.pinch_points[0] = pinch_point(first);
  if (branch.closed) branch.pinch_points[1] = pinch_point(last);
  const auto part = [&](auto& list, std::size_t from, std::size_t to) {
    list.erase(list.begin() + static_cast<long>(to), list.end());
    list.erase(list.begin(), list.begin() + static_cast<long>(from));
  };
  part(branch.points, first + 1, last + 1);
  part(branch.errors, first + 1, last);
  part(branch.crosses, first + 1, last);
  branch.closed = false;
}

void WholeCurve::add_components(const Branch& branch, SurfaceResult& result) {
  std::vector<std::size_t> cuts;
  for (std::size_t k = 0; k < branch.crosses.size(); ++k)
    if (branch.crosses[k]) cuts.push_back(k);
  const std::size_t last = branch.points.size() - 1;
  BranchEnd at_infinity;
  at_infinity.kind = BranchEndKind::infinity;
  if (branch.closed && cuts.empty()) {
    SurfaceComponent loop = component(branch, 0, last, false, false);
    loop.kind = SurfaceComponentKind::loop;
    loop.reason = branch.reason;
    loop.mirrored = branch.mirrored;
    loop.certified = branch.reason.empty();
    if (!branch.reason.empty()) doubt(result, branch.reason);
    result.components.push_back(std::move(loop));
    return;
  }
  Branch open = branch;
  if (branch.closed) {
    // Begin behind the first passage through infinity.
    const std::size_t shift = cuts.front() + 1;
    open.points.pop_back();
    std::rotate(open.points.begin(), open.points.begin() + static_cast<long>(shift), open.points.end());
    std::rotate(open.errors.begin(), open.errors.begin() + static_cast<long>(shift), open.errors.end());
    std::rotate(open.crosses.begin(), open.crosses.begin() + static_cast<long>(shift), open.crosses.end());
    open.crosses.pop_back();
    open.errors.pop_back();
  }
  std::size_t first = 0;
  std::string reason = branch.reason;
  if (!reason.empty()) doubt(result, reason);
  BranchEnd start = branch.closed ? at_infinity : branch_end(branch, 0, result, reason);
  for (std::size_t k = 0; k < open.points.size(); ++k) {
    const bool is_last = k + 1 == open.points.size();
    if (!is_last && !open.crosses[k]) continue;
    const BranchEnd end = is_last && !branch.closed ? branch_end(branch, 1, result, reason) : at_infinity;
    SurfaceComponent piece =
        component(open, first, k, start.kind == BranchEndKind::infinity, end.kind == BranchEndKind::infinity);
    piece.start = start;
    piece.end = end;
    piece.mirrored = branch.mirrored;
    piece.reason = reason;
    if (first == 0) close_gap(piece, branch, 0, start, result);
    if (is_last) close_gap(piece, branch, 1, end, result);
    piece.certified = piece.reason.empty();
    if (!piece.certified) doubt(result, piece.reason);
    result.components.push_back(std::move(piece));
    start = at_infinity;
    first = k + 1;
    reason = branch.reason;
  }
}

}  // namespace eliminant::intersect
