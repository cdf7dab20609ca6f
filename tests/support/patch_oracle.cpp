// SPDX-License-Identifier: BSD-3-Clause
#include <support/patch_oracle.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include <eliminant/intersect/topology/curve_topology.hpp>
#include <support/patch_nets.hpp>
#include <support/patch_sampling.hpp>

namespace eliminant::test {

namespace {

using intersect::Box;
using intersect::TopologyEdge;
using intersect::TopologyResult;
using intersect::TopologyVertex;
using symbolic::Polynomial;
using symbolic::Rational;

using Row = std::array<Rational, 4>;

// Linear algebra.

std::map<std::vector<unsigned long>, Rational> coefficients(const Polynomial& p) {
  std::map<std::vector<unsigned long>, Rational> result;
  for (const Polynomial::Term& term : p.terms()) result[term.exponents] = term.coefficient;
  return result;
}

/// A c with c . map = target, by Gauss's elimination; nullopt where there is none.
std::optional<Row> functional(const PatchMap& map, const Polynomial& target) {
  std::map<std::vector<unsigned long>, std::array<Rational, 5>> by_monomial;
  for (std::size_t k = 0; k < 4; ++k)
    for (const auto& [monomial, coefficient] : coefficients(map[k])) by_monomial[monomial][k] = coefficient;
  for (const auto& [monomial, coefficient] : coefficients(target)) by_monomial[monomial][4] = coefficient;
  std::vector<std::array<Rational, 5>> rows;
  for (const auto& entry : by_monomial) rows.push_back(entry.second);
  Row result;
  std::array<std::size_t, 4> row_of_column{};
  std::size_t rank = 0;
  // Of several combinations that with the weight and without z.
  constexpr std::array<std::size_t, 4> order{3, 0, 1, 2};
  for (const std::size_t k : order) {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(rank);
    const auto pivot = std::find_if(begin, rows.end(), [&](const auto& row) { return !row[k].is_zero(); });
    row_of_column[k] = rows.size();
    if (pivot == rows.end()) continue;
    std::iter_swap(begin, pivot);
    const Rational leading = rows[rank][k];
    for (Rational& entry : rows[rank]) entry = entry / leading;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == rank || rows[i][k].is_zero()) continue;
      const Rational factor = rows[i][k];
      for (std::size_t j = 0; j < 5; ++j) rows[i][j] = rows[i][j] - factor * rows[rank][j];
    }
    row_of_column[k] = rank++;
  }
  for (std::size_t i = rank; i < rows.size(); ++i)
    if (!rows[i][4].is_zero()) return std::nullopt;
  for (std::size_t k = 0; k < 4; ++k)
    if (row_of_column[k] < rows.size()) result[k] = rows[row_of_column[k]][4];
  return result;
}

Polynomial applied(const Row& row, const PatchMap& map) {
  Polynomial sum(2);
  for (std::size_t k = 0; k < 4; ++k) sum = sum + row[k] * map[k];
  return sum;
}

/// Whether e_k is not a combination of three rows: a minor of theirs.
bool independent(const std::array<Row, 3>& rows, std::size_t k) {
  std::array<std::size_t, 3> c{};
  for (std::size_t i = 0, next = 0; i < 4; ++i)
    if (i != k) c[next++] = i;
  Rational determinant;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = c[(i + 1) % 3];
    const std::size_t b = c[(i + 2) % 3];
    determinant = determinant + rows[0][c[i]] * (rows[1][a] * rows[2][b] - rows[1][b] * rows[2][a]);
  }
  return !determinant.is_zero();
}

// Which parameters of the first patch lie over the unit square.

bool not_negative(const Polynomial& p) {
  const auto m = static_cast<std::size_t>(std::max(p.degree(0), 0L));
  const auto n = static_cast<std::size_t>(std::max(p.degree(1), 0L));
  for (const auto& row : control_net(affine_patch(p, p, p), m, n))
    for (const symbolic::ControlPoint& point : row)
      if (point[0].sign() < 0) return false;
  return true;
}

Rational smaller(const Rational& a, const Rational& b) { return a < b ? a : b; }
Rational greater(const Rational& a, const Rational& b) { return a < b ? b : a; }

/// The interval of variable `axis` in [0, 1] where 0 <= p <= 1.
std::optional<std::array<Rational, 2>> interval_over(const Polynomial& p, std::size_t axis) {
  if (not_negative(p) && not_negative(Polynomial::constant(2, 1) - p)) return std::array<Rational, 2>{0, 1};
  const bool affine = p.total_degree() == 1 && p.degree(1 - axis) <= 0;
  if (!affine) return std::nullopt;
  const Rational start = p.constant_term();
  const Rational slope = p.derivative(axis).constant_term();
  const Rational a = -start / slope;
  const Rational b = (Rational(1) - start) / slope;
  return std::array<Rational, 2>{greater(0, smaller(a, b)), smaller(1, greater(a, b))};
}

// From the graph of the curve to its components.

class Components {
 public:
  explicit Components(const TopologyResult& topology)
      : topology_(topology), taken_(topology.edges.size(), false), at_(topology.vertices.size()) {
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      at_[topology.edges[e].from].push_back(e);
      at_[topology.edges[e].to].push_back(e);
    }
  }

  TrueIntersection collect() {
    for (std::size_t vertex = 0; vertex < at_.size(); ++vertex)
      if (is_end(vertex))
        for (const std::size_t edge : at_[vertex])
          if (!taken_[edge]) add(TrueComponent::Kind::curve, vertex, edge);
    for (std::size_t edge = 0; edge < taken_.size(); ++edge)
      if (!taken_[edge]) add(TrueComponent::Kind::loop, topology_.edges[edge].from, edge);
    for (const std::size_t vertex : topology_.isolated)
      result_.components.push_back({TrueComponent::Kind::point, {place(topology_.vertices[vertex])}});
    result_.counts.points = topology_.isolated.size();
    result_.counts.singular = topology_.counts.singular;
    return std::move(result_);
  }

 private:
  bool is_end(std::size_t vertex) const {
    return topology_.vertices[vertex].on_border || topology_.vertices[vertex].kind == intersect::VertexKind::singular;
  }

  static std::array<double, 2> place(const TopologyVertex& vertex) {
    return {std::stod(vertex.x.real), std::stod(vertex.y.real)};
  }

  /// From a vertex along an edge to an end, or around.
  void add(TrueComponent::Kind kind, std::size_t vertex, std::size_t edge) {
    TrueComponent component{kind, {}};
    for (;;) {
      taken_[edge] = true;
      const TopologyEdge& now = topology_.edges[edge];
      const bool forwards = now.from == vertex;
      auto& points = component.parameters;
      if (forwards)
        points.insert(points.end(), now.polyline.begin(), now.polyline.end());
      else
        points.insert(points.end(), now.polyline.rbegin(), now.polyline.rend());
      vertex = forwards ? now.to : now.from;
      if (is_end(vertex)) break;
      const auto next = std::find_if(at_[vertex].begin(), at_[vertex].end(), [&](std::size_t e) { return !taken_[e]; });
      if (next == at_[vertex].end()) break;
      edge = *next;
    }
    ++(kind == TrueComponent::Kind::curve ? result_.counts.curves : result_.counts.loops);
    result_.components.push_back(std::move(component));
  }

  const TopologyResult& topology_;
  std::vector<bool> taken_;
  std::vector<std::vector<std::size_t>> at_;
  TrueIntersection result_;
};

}  // namespace

std::optional<PlaneCurve> substituted_in_graph(const PatchCase& patches) {
  const PatchMap second = patch_map(patches.second);
  const auto s = functional(second, Polynomial::variable(2, 0));
  const auto t = functional(second, Polynomial::variable(2, 1));
  const auto one = functional(second, Polynomial::constant(2, 1));
  if (!s || !t || !one) return std::nullopt;
  const PatchMap first = patch_map(patches.first);
  if (!(applied(*one, first) == Polynomial::constant(2, 1))) return std::nullopt;
  std::size_t height = 0;
  while (height < 4 && !independent({*s, *t, *one}, height)) ++height;
  if (height == 4) return std::nullopt;
  const std::vector<Polynomial> over{applied(*s, first), applied(*t, first)};
  const auto u = interval_over(over[0], 0);
  const auto v = interval_over(over[1], 1);
  if (!u || !v) return std::nullopt;
  return PlaneCurve{first[height] - second[height].compose(over), Box{*u, *v}};
}

TrueIntersection plane_intersection(const PlaneCurve& curve) {
  const Box& box = curve.box;
  if (curve.equation.is_zero()) throw std::logic_error("the patches have a part in common");
  if (curve.equation.is_constant() || box.x[1] < box.x[0] || box.y[1] < box.y[0]) return {};
  intersect::CurveTopologyProblem problem;
  problem.p = curve.equation;
  problem.box = box;
  const TopologyResult topology = intersect::curve_topology(problem, {}, Context());
  if (topology.status != intersect::Status::certified)
    throw std::logic_error("the topology of a plane curve is not certified");
  return Components(topology).collect();
}

TrueIntersection true_intersection(const PatchCase& patches) {
  if (const auto curve = substituted_in_graph(patches)) return plane_intersection(*curve);
  return sampled_intersection(patches);
}

}  // namespace eliminant::test
