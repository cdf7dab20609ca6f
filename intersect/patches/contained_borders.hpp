// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <eliminant/bridge/branches/branch_subdivision.hpp>
#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/contacts/contact_curves.hpp>
#include <eliminant/intersect/patches/balanced_pair.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// On which borders of the domain a point of a border curve lies, as far as its accuracy goes: a curve along a border
/// ends where one of both patches does.
std::array<int, 4> sides_at(const std::array<double, 4>& at);

/// Border curves that lie in the other patch as components, one that is a border of both patches once, none for a
/// border that is one point. They end at the contacts in which branches cross them (the singular point is the index of
/// the contact). Where both patches are tangent along one it is not certified.
std::vector<SurfaceComponent> contained_curves(const BalancedPair& pair,
                                               const std::vector<bridge::ContainedBorder>& borders,
                                               const bridge::BranchGraph& graph, double tolerance);

/// Whether branches of the graph end in a contact.
bool crosses(const bridge::BranchGraph& graph, std::size_t contact);

/// Whether a contact is on a border curve that lies in the other patch.
bool is_on(const bridge::ContainedBorder& border, const bridge::CellContact& contact);

/// Once the rest of the intersection is known: borders along which a curve of contact is proven are certified, those
/// that pass through parts of the domain that are `open` are not.
void settle_contained_curves(std::vector<SurfaceComponent>& components, const BalancedPair& pair,
                             const std::vector<bridge::ContainedBorder>& borders, const bridge::ContactCurves& curves,
                             const bridge::BranchGraph& graph);

}  // namespace eliminant::intersect
