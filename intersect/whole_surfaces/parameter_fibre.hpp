// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/intersect/whole_surfaces/branch_tube.hpp>

namespace eliminant::intersect {

/// A box of parameters that may hold common points.
struct FibreBox {
  Charts inverted{};
  ParameterBox box;
};

/// Boxes that hold all real common points whose parameters u and t lie in the given boxes (in the charts of
/// `inverted`, whose other two entries are not read), v and s over the whole projective lines: none of them could be
/// excluded with sides of v and s down to `side`. nullopt when there are more than `most`.
std::optional<std::vector<FibreBox>> fibre_boxes(const SurfacePair& pair, const Charts& inverted,
                                                 const DoubleInterval& u, const DoubleInterval& t, double side,
                                                 std::size_t most);

/// Boxes that touch, also over the borders of charts, gathered: indices of boxes.
std::vector<std::vector<std::size_t>> gather_boxes(const std::vector<FibreBox>& boxes);

/// Whether all of the intersection within the box is a part of one smooth arc without ends there.
bool is_smooth_branch(const SurfacePair& pair, const FibreBox& box);

/// The least box around boxes that touch, in charts that suit it; nullopt when none does.
std::optional<FibreBox> hull_of(const std::vector<FibreBox>& boxes, const std::vector<std::size_t>& members);

}  // namespace eliminant::intersect
