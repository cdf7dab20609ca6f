// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/parameter_fibre.hpp>

#include <cmath>
#include <numeric>

#include <Eigen/Dense>

namespace eliminant::intersect {

std::optional<std::vector<FibreBox>> fibre_boxes(const SurfacePair& pair, const Charts& inverted,
                                                 const DoubleInterval& u, const DoubleInterval& t, double side,
                                                 std::size_t most) {
  std::vector<FibreBox> open;
  for (const bool v_inverted : {false, true})
    for (const bool s_inverted : {false, true})
      open.push_back(
          {{inverted[0], v_inverted, s_inverted, inverted[3]}, {u, DoubleInterval(-1, 1), DoubleInterval(-1, 1), t}});
  std::vector<FibreBox> left;
  std::size_t visited = 0;
  while (!open.empty()) {
    const FibreBox box = open.back();
    open.pop_back();
    if (++visited > 200 * most) return std::nullopt;
    if (pair.excludes(box.inverted, box.box)) continue;
    const std::size_t widest = width(box.box[1]) >= width(box.box[2]) ? 1 : 2;
    if (width(box.box[widest]) <= side) {
      left.push_back(box);
      if (left.size() > most) return std::nullopt;
      continue;
    }
    FibreBox half = box;
    const double at = middle(box.box[widest]);
    half.box[widest].upper = at;
    open.push_back(half);
    half = box;
    half.box[widest].lower = at;
    open.push_back(half);
  }
  return left;
}

namespace {

bool touch(const FibreBox& a, const FibreBox& b) {
  const ParameterBox moved = in_charts(b.box, b.inverted, a.inverted);
  for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
    if (!overlap(a.box[i], moved[i])) return false;
  return true;
}

}  // namespace

std::vector<std::vector<std::size_t>> gather_boxes(const std::vector<FibreBox>& boxes) {
  std::vector<std::size_t> parent(boxes.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (touch(boxes[i], boxes[j])) parent[root(i)] = root(j);
  std::vector<std::vector<std::size_t>> by_root(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) by_root[root(i)].push_back(i);
  std::erase_if(by_root, [](const auto& members) { return members.empty(); });
  return by_root;
}

std::optional<FibreBox> hull_of(const std::vector<FibreBox>& boxes, const std::vector<std::size_t>& members) {
  FibreBox result = boxes[members.front()];
  for (const std::size_t k : members) {
    const ParameterBox moved = in_charts(boxes[k].box, boxes[k].inverted, result.inverted);
    for (std::size_t i = 0; i < 4; ++i) {
      if (!moved[i].is_finite()) return std::nullopt;
      result.box[i] = hull(result.box[i], moved[i]);
    }
  }
  return result;
}

bool is_smooth_branch(const SurfacePair& pair, const FibreBox& box) {
  BranchPoint centre{box.inverted, {}};
  for (std::size_t i = 0; i < 4; ++i) centre.at[i] = middle(box.box[i]);
  const auto equations = pair.equations(box.inverted, box.box, pair.pivot(centre));
  if (!equations.valid) return false;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    Eigen::Matrix3d jacobian;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0, column = 0; j < 4; ++j)
        if (j != axis) jacobian(static_cast<long>(i), static_cast<long>(column++)) = middle(equations.jacobian[i][j]);
    const Eigen::Matrix3d inverse = jacobian.inverse();
    if (!inverse.allFinite()) continue;
    bool regular = true;
    for (std::size_t i = 0; i < 3; ++i) {
      double row = 0;
      for (std::size_t j = 0, column = 0; j < 4; ++j) {
        if (j == axis) continue;
        DoubleInterval entry(i == column ? -1.0 : 0.0);
        for (std::size_t l = 0; l < 3; ++l)
          entry =
              entry + DoubleInterval(inverse(static_cast<long>(i), static_cast<long>(l))) * equations.jacobian[l][j];
        row += entry.magnitude();
        ++column;
      }
      regular = regular && row < 0.9;
    }
    if (regular) return true;
  }
  return false;
}

}  // namespace eliminant::intersect
