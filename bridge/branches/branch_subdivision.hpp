// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/bridge/branches/cell_box.hpp>
#include <eliminant/bridge/contacts/contact_curves.hpp>
#include <eliminant/bridge/contacts/surface_contact.hpp>
#include <eliminant/bridge/nets/control_net.hpp>

namespace eliminant::bridge {

/// A point of the intersection of two patches, parameters (u, v, s, t) in [0, 1].
struct CrossingPoint {
  std::array<double, 4> parameters{};
  /// Each parameter is wrong by at most that.
  double radius = 0;
  /// On the border of the domain: -1 where the parameter is 0, 1 where it is 1, else 0.
  std::array<int, 4> side{};
};

/// A smooth arc between two crossing points, all of the intersection in its box.
struct CellArc {
  std::size_t from = 0;
  std::size_t to = 0;
  CellBox box;
  /// `to` is a contact: index into BranchGraph::contacts.
  std::optional<std::size_t> contact;
  /// `to` is on a curve of contact: index into BranchGraph::crossings.
  std::optional<std::size_t> crossing;
};

/// A contact, all of the intersection in its box: a point of its own, or two or four arcs that end there, fewer where
/// it is on the border of the domain.
struct CellContact {
  SurfaceContact contact;
  ContactNeighbourhood around;
  CellBox box;
  /// Index of the point.
  std::size_t point = 0;
};

/// A point in which a branch crosses a curve of contact, all of the intersection in its box beside that curve.
struct CellCrossing {
  ContactCurves::Crossing crossing;
  CellBox box;
  /// Index of the point.
  std::size_t point = 0;
};

/// The intersection as a graph: crossing points of degree 1 (on the border) or 2, contacts of degree 0, 2 (cusps) or 4
/// (on the border 0 to 4), arcs between them. Curves of contact are no part of it.
struct BranchGraph {
  std::vector<CrossingPoint> points;
  std::vector<CellArc> arcs;
  std::vector<CellContact> contacts;
  std::vector<CellCrossing> crossings;
  /// Parts of the domain of which nothing is proven: contacts, singular points, arcs that touch the border; and what
  /// was not looked at, when `complete` is false.
  std::vector<CellBox> open;
  bool complete = true;
  /// Pairs of parts that were looked at.
  unsigned long cells = 0;
  /// Curve/patch problems that were solved on the sides of parts.
  unsigned long sections = 0;
};

struct BranchLimits {
  /// Boxes narrower than this in every parameter are left open.
  double smallest_width = 0x1p-20;
  std::size_t most_open = 64;
  unsigned long most_cells = 400000;
};

/// The real intersection of two tensor-product patches on [0, 1]^2, in hardware doubles with a bound on every rounding.
/// Weights must be positive. `border` are all its points on the borders of the domain at which an arc ends; they become
/// the first points of the graph. Border curves that are `contained` in the other patch are left out of it.
///
/// The parameters of both are cut in two until a pair of parts is proven to have no point in common, or only arcs that
/// are monotone in one direction of space (SurfaceCell), and at most one of these. Wherever a part is cut, the points
/// on the cut are all points of a curve on a patch (bernstein_subdivision): a monotone arc has exactly two on the sides
/// of its cell. A cut is moved where it would pass near points that are known already, or touch the intersection.
/// Where parts are small and not transversal, `contacts` (if given) is asked for a point of contact that explains it,
/// and `curves` (if given) for a curve of contact: parts in which there is nothing else are done.
/// Source: subdivision by transversality [SederbergMeyers1988].
BranchGraph branch_subdivision(const ControlNet& first, const ControlNet& second, std::vector<CrossingPoint> border,
                               std::vector<ContainedBorder> contained, const SurfaceContactProver* contacts,
                               const BranchLimits& limits, const Context& context, ContactCurves* curves = nullptr);

}  // namespace eliminant::bridge
