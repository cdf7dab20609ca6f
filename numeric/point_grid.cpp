// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/point_grid.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace eliminant::numeric {

namespace {

// Cubes are numbered from 1 in 21 bits; whatever lies further out shares the last one.
constexpr double most_cubes = 2097000;

}  // namespace

PointGrid::PointGrid(std::span<const Point> points, double side) : points_(points), side_(side) {
  origin_.fill(std::numeric_limits<double>::max());
  for (const Point& point : points)
    for (std::size_t k = 0; k < 3; ++k) origin_[k] = std::min(origin_[k], point[k]);
  slots_.resize(std::bit_ceil(2 * points.size() + 16));
  std::vector<std::uint32_t> counts;
  std::vector<std::uint32_t> cells(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) place(key_of(cube_of(points[i])), counts, cells[i]);
  first_.assign(counts.size() + 1, 0);
  for (std::size_t c = 0; c < counts.size(); ++c) first_[c + 1] = first_[c] + counts[c];
  order_.resize(points.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) order_[next[cells[i]]++] = static_cast<std::uint32_t>(i);
}

void PointGrid::place(std::uint64_t key, std::vector<std::uint32_t>& counts, std::uint32_t& cell) {
  Slot& slot = slots_[slot_of(key)];
  if (slot.key == 0) {
    slot = {key, static_cast<std::uint32_t>(counts.size())};
    counts.push_back(0);
  }
  cell = slot.cell;
  ++counts[cell];
}

PointGrid::Cube PointGrid::cube_of(const Point& point) const {
  Cube cube{};
  for (std::size_t k = 0; k < 3; ++k)
    cube[k] = 1 + static_cast<std::int32_t>(std::min(std::floor((point[k] - origin_[k]) / side_), most_cubes));
  return cube;
}

std::uint64_t PointGrid::key_of(const Cube& cube) {
  const auto part = [&](std::size_t k) { return static_cast<std::uint64_t>(cube[k]); };
  return 1 + (part(0) | (part(1) << 21U) | (part(2) << 42U));
}

std::size_t PointGrid::slot_of(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = static_cast<std::size_t>(SplitMix64(key).next()) & mask;
  while (slots_[at].key != 0 && slots_[at].key != key) at = (at + 1) & mask;
  return at;
}

void PointGrid::sample_ball(std::size_t center, std::size_t draws, SplitMix64& random,
                            std::vector<std::uint32_t>& ball) const {
  struct Range {
    std::uint32_t first;
    std::size_t up_to;  // the number of points in this cube and those before it
  };
  std::array<Range, 27> ranges{};
  std::size_t cubes = 0;
  std::size_t total = 0;
  const Cube home = cube_of(points_[center]);
  for (std::int32_t n = 0; n < 27; ++n) {
    const Slot& slot = slots_[slot_of(key_of({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1}))];
    if (slot.key == 0) continue;
    total += first_[slot.cell + 1] - first_[slot.cell];
    ranges[cubes++] = {first_[slot.cell], total};
  }
  ball.clear();
  const Point& middle = points_[center];
  const auto take = [&](std::size_t drawn) {
    const auto end = ranges.begin() + static_cast<std::ptrdiff_t>(cubes);
    const auto range =
        std::upper_bound(ranges.begin(), end, drawn, [](std::size_t n, const Range& r) { return n < r.up_to; });
    const std::size_t before = range == ranges.begin() ? 0 : (range - 1)->up_to;
    const std::uint32_t index = order_[range->first + (drawn - before)];
    const Point& point = points_[index];
    const double x = point[0] - middle[0];
    const double y = point[1] - middle[1];
    const double z = point[2] - middle[2];
    if (index != center && x * x + y * y + z * z <= side_ * side_) ball.push_back(index);
  };
  if (total <= draws) {
    for (std::size_t i = 0; i < total; ++i) take(i);
    return;
  }
  for (std::size_t i = 0; i < draws; ++i) take(random.below(total));
  std::sort(ball.begin(), ball.end());
  ball.erase(std::unique(ball.begin(), ball.end()), ball.end());
}

}  // namespace eliminant::numeric
