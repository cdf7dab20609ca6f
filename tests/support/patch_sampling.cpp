// SPDX-License-Identifier: BSD-3-Clause
#include <support/patch_sampling.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include <eliminant/intersect/curve_surface/curve_surface.hpp>
#include <eliminant/symbolic/geometry/bezier.hpp>
#include <support/patch_nets.hpp>
#include <support/power_patch.hpp>

namespace eliminant::test {

namespace {

/// What lies over a point of the first patch.
struct Sample {
  double height = 0;
  std::array<double, 2> below{};
  bool known = false;

  bool inside() const { return known && below[0] >= 0 && below[0] <= 1 && below[1] >= 0 && below[1] <= 1; }
};

class Heights {
 public:
  explicit Heights(const PatchCase& patches) : first_(patches.first), second_(patches.second) {}

  /// By Newton's method for the place on the second patch, from a place nearby.
  Sample at(double u, double v, std::array<double, 2> start) const {
    constexpr int steps = 20;
    constexpr double far = 0.5;
    constexpr double enough = 1e-10;
    const PowerPatch::Jet point = first_.at(u, v);
    Sample sample;
    sample.below = start;
    for (int step = 0; step < steps; ++step) {
      const PowerPatch::Jet jet = second_.at(sample.below[0], sample.below[1]);
      const double x = point[0][0] - jet[0][0];
      const double y = point[1][0] - jet[1][0];
      const double determinant = jet[0][1] * jet[1][2] - jet[0][2] * jet[1][1];
      const double s = (x * jet[1][2] - y * jet[0][2]) / determinant;
      const double t = (y * jet[0][1] - x * jet[1][1]) / determinant;
      sample.below = {sample.below[0] + s, sample.below[1] + t};
      sample.height = point[2][0] - second_.at(sample.below[0], sample.below[1])[2][0];
      sample.known = std::abs(s) + std::abs(t) < enough;
      if (sample.known) return sample;
      // Far from its domain nothing of the second patch counts.
      for (const double place : sample.below)
        if (!(place > -far && place < 1 + far)) return sample;
    }
    return sample;
  }

 private:
  PowerPatch first_;
  PowerPatch second_;
};

/// A zero of the height on an edge of the grid.
struct Crossing {
  std::array<double, 2> parameters{};
  bool inside = false;
  std::vector<std::size_t> neighbours;
};

class Board {
 public:
  Board(const PatchCase& patches, std::size_t cells) : heights_(patches), cells_(cells) {
    for (std::size_t i = 0; i <= cells_; ++i)
      for (std::size_t j = 0; j <= cells_; ++j) samples_.push_back(sample(i, j));
    for (std::size_t i = 0; i < cells_; ++i)
      for (std::size_t j = 0; j < cells_; ++j) link_cell(i, j);
  }

  TrueIntersection chains() {
    TrueIntersection result;
    std::vector<bool> taken(crossings_.size(), false);
    const auto follow = [&](std::size_t start, TrueComponent::Kind kind) {
      TrueComponent component{kind, {}};
      std::optional<std::size_t> now = start;
      while (now) {
        taken[*now] = true;
        component.parameters.push_back(crossings_[*now].parameters);
        std::optional<std::size_t> next;
        for (const std::size_t k : inner_neighbours(*now))
          if (!taken[k]) next = k;
        now = next;
      }
      ++(kind == TrueComponent::Kind::curve ? result.counts.curves : result.counts.loops);
      if (kind == TrueComponent::Kind::loop) component.parameters.push_back(component.parameters.front());
      result.components.push_back(std::move(component));
    };
    for (std::size_t k = 0; k < crossings_.size(); ++k)
      if (!taken[k] && crossings_[k].inside && inner_neighbours(k).size() < 2) follow(k, TrueComponent::Kind::curve);
    for (std::size_t k = 0; k < crossings_.size(); ++k)
      if (!taken[k] && crossings_[k].inside) follow(k, TrueComponent::Kind::loop);
    return result;
  }

 private:
  double parameter(std::size_t i) const { return static_cast<double>(i) / static_cast<double>(cells_); }

  /// From its neighbours, or else from places all over the second patch: one inside where there is one.
  Sample sample(std::size_t i, std::size_t j) const {
    const double u = parameter(i);
    const double v = parameter(j);
    std::optional<Sample> outside;
    const auto is_inside = [&](const std::array<double, 2>& start, Sample& found) {
      found = heights_.at(u, v, start);
      if (found.known && !outside) outside = found;
      return found.inside();
    };
    Sample found;
    for (const std::size_t back : {std::size_t{1}, cells_ + 1}) {
      if (back > samples_.size() || !samples_[samples_.size() - back].known) continue;
      if (is_inside(samples_[samples_.size() - back].below, found)) return found;
    }
    for (const double s : {0.1, 0.5, 0.9})
      for (const double t : {0.1, 0.5, 0.9})
        if (is_inside({s, t}, found)) return found;
    return outside.value_or(Sample{});
  }

  const Sample& node(std::size_t k) const { return samples_[k]; }
  std::array<double, 2> place(std::size_t k) const {
    return {parameter(k / (cells_ + 1)), parameter(k % (cells_ + 1))};
  }

  /// On the edge between two nodes.
  std::optional<std::size_t> crossing(std::size_t a, std::size_t b) {
    if (!node(a).known || !node(b).known || (node(a).height < 0) == (node(b).height < 0)) return std::nullopt;
    const std::pair key(a, b);
    if (const auto found = by_edge_.find(key); found != by_edge_.end()) return found->second;
    constexpr int halvings = 45;
    double low = 0;
    double high = 1;
    Sample middle = node(node(a).inside() ? a : b);
    Crossing made;
    for (int step = 0; step < halvings; ++step) {
      const double t = (low + high) / 2;
      for (std::size_t k = 0; k < 2; ++k) made.parameters[k] = (1 - t) * place(a)[k] + t * place(b)[k];
      middle = heights_.at(made.parameters[0], made.parameters[1], middle.below);
      ((middle.height < 0) == (node(a).height < 0) ? low : high) = t;
    }
    // Elsewhere two preimages change places.
    constexpr double zero = 1e-9;
    made.inside = middle.inside() && std::abs(middle.height) < zero;
    crossings_.push_back(made);
    by_edge_[key] = crossings_.size() - 1;
    return crossings_.size() - 1;
  }

  void link(std::size_t a, std::size_t b) {
    crossings_[a].neighbours.push_back(b);
    crossings_[b].neighbours.push_back(a);
  }

  void link_cell(std::size_t i, std::size_t j) {
    const std::size_t corner = i * (cells_ + 1) + j;
    const std::array<std::size_t, 4> nodes{corner, corner + 1, corner + cells_ + 2, corner + cells_ + 1};
    // Of each side the end with the smaller number comes first.
    std::vector<std::size_t> found;
    std::size_t first_side = 4;
    for (std::size_t side = 0; side < 4; ++side) {
      const std::size_t a = std::min(nodes[side], nodes[(side + 1) % 4]);
      const std::size_t b = std::max(nodes[side], nodes[(side + 1) % 4]);
      if (const auto k = crossing(a, b)) {
        if (found.empty()) first_side = side;
        found.push_back(*k);
      }
    }
    if (found.size() == 2) link(found[0], found[1]);
    if (found.size() != 4 || first_side != 0) return;
    // Sides 0 and 3 meet in the first node: they are joined where the middle is on the side of the second one.
    const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(cells_);
    const double v = (static_cast<double>(j) + 0.5) / static_cast<double>(cells_);
    const Sample middle = heights_.at(u, v, node(nodes[0]).below);
    const bool around_first = (middle.height < 0) != (node(nodes[0]).height < 0);
    link(found[0], found[around_first ? 3 : 1]);
    link(found[2], found[around_first ? 1 : 3]);
  }

  std::vector<std::size_t> inner_neighbours(std::size_t k) const {
    std::vector<std::size_t> result;
    for (const std::size_t other : crossings_[k].neighbours)
      if (crossings_[other].inside) result.push_back(other);
    return result;
  }

  Heights heights_;
  std::size_t cells_;
  std::vector<Sample> samples_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> by_edge_;
  std::vector<Crossing> crossings_;
};

/// How often the borders of the first patch meet the second.
std::size_t border_points(const ControlNet& first, const ControlNet& second) {
  std::size_t count = 0;
  for (const ControlNet& net : {first, parameters_exchanged(first)})
    for (const ControlPolygon& side : {net.front(), net.back()}) {
      intersect::CurveSurfaceProblem problem;
      problem.curve.pieces.push_back(symbolic::bezier_curve(rational_net({side}).front()));
      problem.surface = symbolic::ParametricSurface{{surface_piece(second)}};
      intersect::Options options;
      options.engine = intersect::Engine::exact;
      const intersect::CurveResult result = intersect::intersect_curve_surface(problem, options, Context());
      if (result.status != intersect::Status::certified)
        throw std::logic_error("the points of a border are not certified");
      for (const intersect::CurveSolution& solution : result.solutions)
        if (solution.inside) count += std::max<std::size_t>(solution.surface_parameters.size(), 1);
    }
  return count;
}

}  // namespace

TrueIntersection sampled_intersection(const PatchCase& patches, std::size_t cells) {
  return Board(patches, cells).chains();
}

TrueIntersection sampled_intersection(const PatchCase& patches) {
  constexpr std::size_t fewest = 128;
  constexpr std::size_t most = 1024;
  const std::size_t ends = border_point_count(patches);
  for (std::size_t cells = fewest; cells <= most; cells *= 2) {
    TrueIntersection result = sampled_intersection(patches, cells);
    if (2 * result.counts.curves == ends) return result;
  }
  throw std::logic_error("sampling does not find the arcs between the border points");
}

std::size_t border_point_count(const PatchCase& patches) {
  return border_points(patches.first, patches.second) + border_points(patches.second, patches.first);
}

}  // namespace eliminant::test
