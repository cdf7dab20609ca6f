// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/cylinder_votes.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace eliminant::numeric {

namespace {

constexpr double largest_angle_sine = 0.0872;  // of 5 degrees
constexpr double largest_radius_change = 0.15;
constexpr double largest_axis_shift = 0.25;  // in radii

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

bool same_direction(const Point& a, const Point& b) {
  const Point c = cross(a, b);
  return dot(c, c) <= largest_angle_sine * largest_angle_sine * dot(a, a) * dot(b, b);
}

}  // namespace

bool same_cylinder(const Cylinder& a, const Cylinder& b, const Point& near) {
  if (!same_direction(a.direction, b.direction)) return false;
  if (std::abs(a.radius - b.radius) > largest_radius_change * std::max(a.radius, b.radius)) return false;
  // Both axes where they pass `near`, compared across the direction of the first.
  const CylinderFrame first(a);
  const CylinderFrame second(b);
  const Point at_a = first.axis_at(first.at(near).height);
  const Point at_b = second.axis_at(second.at(near).height);
  const Point across = cross(difference(at_b, at_a), a.direction);
  const double shift = largest_axis_shift * b.radius;
  return dot(across, across) <= shift * shift * dot(a.direction, a.direction);
}

std::vector<CylinderVotes> gather_votes(std::span<const CylinderHypothesis> hypotheses, std::span<const Point> points) {
  std::vector<std::size_t> order(hypotheses.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return hypotheses[a].share > hypotheses[b].share; });
  std::vector<CylinderVotes> gathered;
  for (const std::size_t i : order) {
    const CylinderHypothesis& hypothesis = hypotheses[i];
    const auto same = std::find_if(gathered.begin(), gathered.end(), [&](const CylinderVotes& votes) {
      return same_cylinder(votes.best.cylinder, hypothesis.cylinder, points[hypothesis.seed]);
    });
    if (same == gathered.end())
      gathered.push_back({hypothesis, 1});
    else
      ++same->votes;
  }
  std::stable_sort(gathered.begin(), gathered.end(),
                   [](const CylinderVotes& a, const CylinderVotes& b) { return a.votes > b.votes; });
  return gathered;
}

}  // namespace eliminant::numeric
