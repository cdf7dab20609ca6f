// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/symbolic/geometry/bounding_box.hpp>

namespace eliminant::intersect {

/// The boxes of the pieces of a curve or surface on their domains.
template <class Geometry>
std::vector<std::optional<symbolic::BoundingBox>> boxes_of_pieces(const Geometry& geometry) {
  std::vector<std::optional<symbolic::BoundingBox>> boxes;
  for (const auto& piece : geometry.pieces) boxes.push_back(symbolic::bounding_box(piece));
  return boxes;
}

/// Whether the boxes of two pieces have no common point, where points inside the domains alone are asked for and the
/// engine is free to look nowhere else. Then the result has what is left to say: of other points nothing is known.
inline bool excluded_by_boxes(const std::optional<symbolic::BoundingBox>& a,
                              const std::optional<symbolic::BoundingBox>& b, const Options& options,
                              CurveResult& result) {
  const bool free = options.engine == Engine::automatic || options.engine == Engine::box;
  if (!free || options.field == Field::complex || !a || !b || !symbolic::are_disjoint(*a, *b)) return false;
  CurveCounts counts;
  counts.within_domains_only = true;
  EngineReport engine = result.engine;
  engine.method = "box";
  add_part(Status::certified, counts, engine, {}, result);
  return true;
}

}  // namespace eliminant::intersect
