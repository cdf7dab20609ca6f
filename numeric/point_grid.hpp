// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <eliminant/numeric/splitmix64.hpp>

namespace eliminant::numeric {

using Point = std::array<double, 3>;

/// Points sorted into cubes, for random samples of balls whose radius is the side of the cubes.
class PointGrid {
 public:
  /// The points must be finite and outlive the grid; at most 2^32 - 1 of them. `side` > 0.
  PointGrid(std::span<const Point> points, double side);

  /// Draws up to `draws` points, all alike likely, from the 27 cubes around the point `center`, and puts the indices of
  /// those within `side` of it into `ball`, each once and without the center itself. With few enough points there, all
  /// of them are taken.
  void sample_ball(std::size_t center, std::size_t draws, SplitMix64& random, std::vector<std::uint32_t>& ball) const;

  double side() const { return side_; }

 private:
  using Cube = std::array<std::int32_t, 3>;
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t cell = 0;
  };

  Cube cube_of(const Point& point) const;
  static std::uint64_t key_of(const Cube& cube);
  std::size_t slot_of(std::uint64_t key) const;
  void place(std::uint64_t key, std::vector<std::uint32_t>& counts, std::uint32_t& cell);

  std::span<const Point> points_;
  double side_;
  Point origin_{};
  /// Open addressing; a key of 0 is a free slot. The points of cell c are order_[first_[c]], ...,
  /// order_[first_[c+1]-1].
  std::vector<Slot> slots_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> order_;
};

}  // namespace eliminant::numeric
