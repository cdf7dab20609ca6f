// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/topology/curve_topology.hpp>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/topology/event_fibres.hpp>
#include <eliminant/intersect/topology/slab_arcs.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>

namespace eliminant::intersect {

namespace {

using bridge::RealBall;
using symbolic::Rational;

double approximation(const RealBall& value) { return arf_get_d(arb_midref(value.get()), ARF_RND_NEAR); }

/// Where an arc ends: at a vertex, or in an arc of the next slab.
struct ArcEnd {
  std::optional<std::size_t> vertex;
  std::optional<std::size_t> next_arc;
  /// The point where it passes into the next slab.
  std::optional<std::array<double, 2>> passage;
};

/// Joins the arcs between events to edges between vertices.
class GraphBuilder {
 public:
  GraphBuilder(const symbolic::ReducedCurve& curve, const CurveTopologyProblem& problem, const Options& options,
               const Context& context, TopologyResult& result)
      : box_(problem.box), options_(options), sampler_(curve, problem.box, context), result_(result) {}

  void build(const std::vector<EventFibre>& fibres) {
    sample(fibres);
    // The vertices of a fibre come between the left and the right ends of arcs: sorted by x, then y.
    open_left_ends();
    for (std::size_t i = 0; i < fibres.size(); ++i) pass(fibres[i], i, i + 1);
    close_right_ends();
    join_arcs();
    gather();
    result_.error = sampler_.error();
  }

 private:
  /// Slab i is to the left of event i; with a box there is none before the first and behind the last event.
  void sample(const std::vector<EventFibre>& fibres) {
    if (fibres.size() > 1) width_ = std::max(approximation(fibres.back().x) - approximation(fibres.front().x), 1e-300);
    for (std::size_t i = 0; i <= fibres.size(); ++i) {
      const EventFibre* const before = i > 0 ? &fibres[i - 1] : nullptr;
      const EventFibre* const after = i < fibres.size() ? &fibres[i] : nullptr;
      const bool outside = box_ && (before == nullptr || after == nullptr);
      slabs_.push_back(outside ? SlabArcs() : sampler_.between(before, after, width_));
      left_ends_.emplace_back(slabs_.back().count);
      right_ends_.emplace_back(slabs_.back().count);
    }
  }

  std::size_t add_vertex_at_infinity(int x_infinite, int y_infinite, const RealBall* x) {
    TopologyVertex vertex;
    vertex.kind = VertexKind::infinity;
    vertex.certified = options_.certify;
    vertex.x_infinite = x_infinite;
    vertex.y_infinite = y_infinite;
    if (x != nullptr) {
      const std::vector<Coordinate> printed = print({*x}, vertex.radius_exponent);
      vertex.x = printed[0];
    }
    result_.vertices.push_back(std::move(vertex));
    points_.push_back(std::nullopt);
    return result_.vertices.size() - 1;
  }

  void open_left_ends() {
    for (ArcEnd& end : left_ends_.front()) end.vertex = add_vertex_at_infinity(-1, 0, nullptr);
  }
  void close_right_ends() {
    for (ArcEnd& end : right_ends_.back()) end.vertex = add_vertex_at_infinity(1, 0, nullptr);
  }

  /// With as many digits of the greatest as are asked for, or of 1 where they may all be zero.
  std::vector<Coordinate> print(const std::vector<RealBall>& values, long& radius_exponent) const {
    std::vector<bridge::ComplexBall> balls(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) arb_set(balls[k].real(), values[k].get());
    const auto try_to_print = [&](long digits) {
      radius_exponent = std::numeric_limits<long>::min();
      return print_normalized(balls, digits, radius_exponent);
    };
    const bool may_vanish =
        std::all_of(balls.begin(), balls.end(), [](const auto& ball) { return acb_contains_zero(ball.get()) != 0; });
    if (!may_vanish)
      if (auto printed = try_to_print(options_.digits)) return *std::move(printed);
    acb_one(balls.emplace_back().get());
    for (long digits = options_.digits; digits > 0; --digits)
      if (auto printed = try_to_print(digits)) return *std::move(printed);
    throw PrecisionExhausted("a vertex is not enclosed tightly enough to be printed");
  }

  std::size_t add_vertex(const EventFibre& fibre, const EventPoint& point) {
    TopologyVertex vertex;
    vertex.left = point.left;
    vertex.right = point.right;
    vertex.vertical = fibre.vertical_line ? 2 : 0;
    vertex.milnor_number = point.milnor_number();
    if (fibre.vertical_line) vertex.milnor_number += 2 * point.fibre_multiplicity - 1;
    vertex.on_border = fibre.exact_x || point.exact_y;
    vertex.kind = vertex.milnor_number > 0 ? VertexKind::singular
                  : point.critical         ? VertexKind::critical
                                           : VertexKind::border;
    if (point.critical) {
      vertex.x = point.critical->x;
      vertex.y = point.critical->y;
      vertex.radius_exponent = point.critical->radius_exponent;
      vertex.certified = options_.certify && point.critical->certified;
    } else {
      set_point(vertex, fibre.x, point.y);
    }
    result_.vertices.push_back(std::move(vertex));
    points_.push_back(sampler_.nearest(fibre.x, point.y));
    return result_.vertices.size() - 1;
  }

  void set_point(TopologyVertex& vertex, const RealBall& x, const RealBall& y) const {
    std::vector<Coordinate> printed = print({x, y}, vertex.radius_exponent);
    vertex.x = std::move(printed[0]);
    vertex.y = std::move(printed[1]);
    vertex.certified = options_.certify;
  }

  /// A corner of a vertical line with the border of the box, where no other branch passes.
  std::size_t add_line_end(const EventFibre& fibre, std::size_t end) {
    if (!box_) return add_vertex_at_infinity(0, end == 0 ? -1 : 1, &fibre.x);
    TopologyVertex vertex;
    vertex.kind = VertexKind::border;
    vertex.on_border = true;
    vertex.vertical = 2;
    const RealBall height(box_->y[end], 64 + 8 * options_.digits);
    set_point(vertex, fibre.x, height);
    result_.vertices.push_back(std::move(vertex));
    points_.push_back(sampler_.nearest(fibre.x, height));
    return result_.vertices.size() - 1;
  }

  /// Follows arcs through one event from slab `left` to slab `right`.
  void pass(const EventFibre& fibre, std::size_t left, std::size_t right) {
    std::size_t from_left = 0;
    std::size_t to_right = 0;
    std::vector<std::size_t> on_line;
    end_at_infinity(fibre, 0, left, right, from_left, to_right);
    const bool first = box_ && left == 0;
    const bool last = box_ && right + 1 == slabs_.size();
    if (fibre.vertical_line && !has_point_at(fibre, -1)) on_line.push_back(add_line_end(fibre, 0));
    for (const EventPoint& point : fibre.points) {
      const bool is_vertex = is_inside(point.place) &&
                             (point.critical || fibre.vertical_line || point.place != 0 || fibre.exact_x.has_value());
      std::optional<std::size_t> vertex;
      if (is_vertex) vertex = add_vertex(fibre, point);
      if (is_vertex && fibre.vertical_line) on_line.push_back(*vertex);
      ArcEnd passing;
      if (!is_vertex && is_inside(point.place)) passing.passage = sampler_.nearest(fibre.x, point.y);
      const std::size_t first_left = from_left;
      const std::size_t first_right = to_right;
      if (!first) from_left += point.left;
      if (!last) to_right += point.right;
      for (std::size_t k = first_left; k < from_left; ++k) {
        ArcEnd& end = right_ends_[left].at(k);
        end = passing;
        end.vertex = vertex;
        if (!is_vertex) end.next_arc = first_right;
      }
      for (std::size_t k = first_right; k < to_right; ++k) {
        ArcEnd& end = left_ends_[right].at(k);
        end.vertex = vertex;
        if (!is_vertex) end.next_arc = first_left;
      }
    }
    const bool flat = box_ && box_->y[0] == box_->y[1];
    if (fibre.vertical_line && !has_point_at(fibre, 1) && !flat) on_line.push_back(add_line_end(fibre, 1));
    end_at_infinity(fibre, 1, left, right, from_left, to_right);
    if (from_left != slabs_[left].count || to_right != slabs_[right].count)
      throw PrecisionExhausted("the arcs at an event do not match those between events");
    for (std::size_t k = 0; k + 1 < on_line.size(); ++k) add_line_edge(fibre, on_line[k], on_line[k + 1]);
  }

  static bool has_point_at(const EventFibre& fibre, Place place) {
    return std::any_of(fibre.points.begin(), fibre.points.end(),
                       [&](const EventPoint& point) { return point.place == place && point.exact_y; });
  }

  void end_at_infinity(const EventFibre& fibre, std::size_t end, std::size_t left, std::size_t right,
                       std::size_t& from_left, std::size_t& to_right) {
    const bool first = box_ && left == 0;
    const bool last = box_ && right + 1 == slabs_.size();
    const int sign = end == 0 ? -1 : 1;
    for (std::size_t k = 0; !first && k < fibre.left_to_infinity[end]; ++k, ++from_left)
      if (!box_) right_ends_[left].at(from_left).vertex = add_vertex_at_infinity(0, sign, &fibre.x);
    for (std::size_t k = 0; !last && k < fibre.right_to_infinity[end]; ++k, ++to_right)
      if (!box_) left_ends_[right].at(to_right).vertex = add_vertex_at_infinity(0, sign, &fibre.x);
  }

  /// A part of a vertical line; what is unbounded is drawn as long as the events are apart.
  void add_line_edge(const EventFibre& fibre, std::size_t from, std::size_t to) {
    const auto drawn = [&](std::size_t vertex, std::size_t other) {
      if (points_[vertex]) return *points_[vertex];
      RealBall y;
      arb_set_d(y.get(), result_.vertices[vertex].y_infinite * width_ + (points_[other] ? (*points_[other])[1] : 0));
      return sampler_.nearest(fibre.x, y);
    };
    result_.edges.push_back({from, to, fibre.exact_x.has_value(), {drawn(from, to), drawn(to, from)}});
  }

  /// Every arc inside begins at a vertex or continues one that does.
  void join_arcs() {
    for (std::size_t slab = 0; slab < slabs_.size(); ++slab)
      for (std::size_t arc = 0; arc < slabs_[slab].count; ++arc) {
        if (!is_inside(slabs_[slab].places[arc]) || !left_ends_[slab][arc].vertex) continue;
        TopologyEdge edge;
        edge.from = *left_ends_[slab][arc].vertex;
        edge.on_border = slabs_[slab].places[arc] != 0;
        std::vector<std::array<double, 2>>& polyline = edge.polyline;
        const auto append = [&](const std::array<double, 2>& point) {
          if (polyline.empty() || polyline.back()[0] < point[0]) polyline.push_back(point);
        };
        if (points_[edge.from]) append(*points_[edge.from]);
        for (std::size_t at = slab, which = arc;; ++at) {
          const auto& points = slabs_[at].polylines[which];
          std::for_each(points.begin(), points.end(), append);
          const ArcEnd& end = right_ends_[at][which];
          if (end.vertex) {
            edge.to = *end.vertex;
            break;
          }
          if (!end.next_arc || at + 1 == slabs_.size()) throw PrecisionExhausted("an arc ends at no vertex");
          if (end.passage) append(*end.passage);
          which = *end.next_arc;
        }
        if (points_[edge.to]) {
          while (polyline.size() > 1 && !(polyline.back()[0] < (*points_[edge.to])[0])) polyline.pop_back();
          polyline.push_back(*points_[edge.to]);
        }
        result_.edges.push_back(std::move(edge));
      }
  }

  std::size_t root_of(std::size_t vertex) {
    while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
    return vertex;
  }

  /// Components, loops and isolated points.
  void gather() {
    const std::size_t n = result_.vertices.size();
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), 0U);
    std::vector<std::vector<std::size_t>> edges_at(n);
    for (std::size_t e = 0; e < result_.edges.size(); ++e) {
      const TopologyEdge& edge = result_.edges[e];
      parent_[root_of(edge.from)] = root_of(edge.to);
      edges_at[edge.from].push_back(e);
      edges_at[edge.to].push_back(e);
    }
    std::vector<bool> simple(n, true);
    TopologyCounts& counts = result_.counts;
    for (std::size_t v = 0; v < n; ++v) {
      if (edges_at[v].size() != 2) simple[root_of(v)] = false;
      if (edges_at[v].empty()) result_.isolated.push_back(v);
      if (root_of(v) == v) ++counts.components;
      unsigned long* const of_kind[] = {&counts.singular, &counts.critical, &counts.border, &counts.infinity};
      ++*of_kind[static_cast<std::size_t>(result_.vertices[v].kind)];
    }
    counts.cycles = result_.edges.size() + counts.components - n;
    counts.faces = faces();
    std::vector<bool> seen(n, false);
    for (std::size_t v = 0; v < n; ++v) {
      if (!simple[root_of(v)] || seen[root_of(v)]) continue;
      seen[root_of(v)] = true;
      result_.loops.push_back(cycle_from(v, edges_at));
    }
  }

  /// Euler's formula on the sphere that the plane, or the inside of the box, becomes with one point more: that point
  /// stands for infinity, or for the border. It is a vertex, also where nothing ends in it.
  unsigned long faces() {
    if (box_ && (box_->x[0] == box_->x[1] || box_->y[0] == box_->y[1])) return 0;
    const std::size_t n = result_.vertices.size();
    std::vector<std::size_t> saved = parent_;
    parent_.resize(n + 1);
    std::iota(parent_.begin(), parent_.end(), 0U);
    unsigned long edges = 0;
    for (const TopologyEdge& edge : result_.edges) {
      parent_[root_of(edge.from)] = root_of(edge.to);
      if (!edge.on_border) ++edges;
    }
    unsigned long vertices = 0;
    for (std::size_t v = 0; v < n; ++v) {
      const TopologyVertex& vertex = result_.vertices[v];
      if (vertex.on_border || vertex.kind == VertexKind::infinity)
        parent_[root_of(v)] = root_of(n);
      else
        ++vertices;
    }
    unsigned long components = 0;
    for (std::size_t v = 0; v <= n; ++v) components += root_of(v) == v ? 1 : 0;
    parent_ = std::move(saved);
    return edges + components - vertices;
  }

  std::vector<std::size_t> cycle_from(std::size_t start, const std::vector<std::vector<std::size_t>>& edges_at) const {
    std::vector<std::size_t> cycle;
    std::size_t vertex = start;
    std::size_t edge = edges_at[start][0];
    do {
      cycle.push_back(edge);
      vertex = result_.edges[edge].from == vertex ? result_.edges[edge].to : result_.edges[edge].from;
      edge = edges_at[vertex][0] == edge ? edges_at[vertex][1] : edges_at[vertex][0];
    } while (vertex != start);
    return cycle;
  }

  const std::optional<Box>& box_;
  const Options& options_;
  SlabSampler sampler_;
  TopologyResult& result_;
  /// Of the part of unbounded arcs that is drawn.
  double width_ = 1;
  std::vector<SlabArcs> slabs_;
  std::vector<std::vector<ArcEnd>> left_ends_;
  std::vector<std::vector<ArcEnd>> right_ends_;
  /// Of each vertex that is not at infinity.
  std::vector<std::optional<std::array<double, 2>>> points_;
  std::vector<std::size_t> parent_;
};

void check(const CurveTopologyProblem& problem, const Options& options) {
  if (problem.p.variable_count() != 2)
    throw InvalidInput(
        "a plane curve was given by a polynomial in " + std::to_string(problem.p.variable_count()) + " variables",
        "two variables");
  if (problem.p.is_constant())
    throw InvalidInput(problem.p.is_zero() ? "the equation of a curve is 0" : "the equation of a curve is constant",
                       "a polynomial that is not constant");
  if (options.engine == Engine::box)
    throw InvalidInput("the engine box is for curves and patches with bounded domains", "auto, pencil or exact");
  if (options.digits < 1 || options.digits > 100000)
    throw InvalidInput("digits is " + std::to_string(options.digits), "a number from 1 to 100000");
  if (!problem.box) return;
  for (const auto* side : {&problem.box->x, &problem.box->y})
    if ((*side)[1] < (*side)[0])
      throw InvalidInput("a side of the box is [" + (*side)[0].to_string() + ", " + (*side)[1].to_string() + "]",
                         "a lower end that is not above the upper end");
}

}  // namespace

TopologyResult curve_topology(const CurveTopologyProblem& problem, const Options& options, const Context& context) {
  using Clock = std::chrono::steady_clock;
  symbolic::install_flint_error_handler();
  check(problem, options);
  const auto start = Clock::now();
  TopologyResult result;
  result.variables = problem.variables;
  const symbolic::ReducedCurve curve = symbolic::reduced_curve(problem.p);
  EventFibres events = event_fibres(curve, problem.box, options, context);
  result.engine = std::move(events.engine);
  result.warnings = std::move(events.warnings);
  if (curve.repeated_factor)
    result.warnings.emplace_back("a factor of the equation is repeated: every component counts once");
  const auto found = Clock::now();
  GraphBuilder(curve, problem, options, context, result).build(events.fibres);
  result.status = options.certify ? events.status : Status::numeric;
  const auto finished = Clock::now();
  const auto seconds = [](auto from, auto to) { return std::chrono::duration<double>(to - from).count(); };
  result.seconds = {
      {"total", seconds(start, finished)}, {"events", seconds(start, found)}, {"arcs", seconds(found, finished)}};
  return result;
}

}  // namespace eliminant::intersect
