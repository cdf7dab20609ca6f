// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/intersect/result.hpp>

namespace eliminant::intersect {

/// The real plane curve p = 0, p in Q[x, y] not constant, in the whole plane or in a closed box.
struct CurveTopologyProblem {
  symbolic::Polynomial p{2};
  std::vector<std::string> variables{"x", "y"};
  std::optional<Box> box;
};

enum class VertexKind {
  singular,  ///< both partial derivatives of the squarefree part vanish
  critical,  ///< a smooth point with a vertical tangent
  border,    ///< a smooth point on the border of the box, no vertical tangent there or the curve is a vertical line
  infinity,  ///< the end of an arc at infinity; each end has one of its own
};

/// A point where arcs begin or end.
struct TopologyVertex {
  VertexKind kind = VertexKind::critical;
  /// On the border of the box, whatever the kind.
  bool on_border = false;
  /// Of a vertex at infinity: -1 and 1 stand for the limits -inf and inf of the coordinate, and 0 for a finite one, the
  /// asymptote x = constant; y has no value where x is infinite.
  int x_infinite = 0;
  int y_infinite = 0;
  Coordinate x;
  Coordinate y;
  /// 10^radius_exponent bounds the distance of the true point in each coordinate.
  long radius_exponent = 0;
  /// Half-branches of the curve at the point, also those that leave the box: to smaller x, to greater x, and along a
  /// vertical line.
  unsigned long left = 0;
  unsigned long right = 0;
  unsigned long vertical = 0;
  /// Of the squarefree part of p; 0 at a smooth point.
  unsigned long milnor_number = 0;
  bool certified = false;

  unsigned long half_branches() const { return left + right + vertical; }
};

/// A smooth arc without a vertex inside: the graph of a function of x, or a part of a vertical line.
struct TopologyEdge {
  /// Indices of vertices, by increasing x; of a vertical line by increasing y.
  std::size_t from = 0;
  std::size_t to = 0;
  /// A part of the border of the box.
  bool on_border = false;
  /// Points of the curve, each within TopologyResult::error in each coordinate, from `from` to `to`; without ends at
  /// infinity. Arcs that lie above each other have points at the same abscissae, in the same order; a point whose
  /// abscissa is the double of the one before is left out.
  std::vector<std::array<double, 2>> polyline;
};

struct TopologyCounts {
  /// Connected components of the curve in the affine plane or in the box.
  unsigned long components = 0;
  /// Independent cycles: edges - vertices + components.
  unsigned long cycles = 0;
  /// Connected components of the complement of the curve in the plane or in the box; 0 for a box without inside.
  unsigned long faces = 0;
  unsigned long singular = 0;
  unsigned long critical = 0;
  unsigned long border = 0;
  unsigned long infinity = 0;
};

/// The curve as a graph: isotopic to it when edges are drawn as arcs.
struct TopologyResult {
  std::string problem = "curve_topology";
  Status status = Status::numeric;
  std::vector<std::string> variables{"x", "y"};
  TopologyCounts counts;
  /// By x, then y; those at infinity to the left first, to the right last, at an asymptote below first and above last.
  std::vector<TopologyVertex> vertices;
  std::vector<TopologyEdge> edges;
  /// Components that are simple closed curves, as indices of their edges in cyclic order.
  std::vector<std::vector<std::size_t>> loops;
  /// Vertices that are components of their own.
  std::vector<std::size_t> isolated;
  /// Bounds the distance of every point of a polyline from the curve, in each coordinate.
  double error = 0;
  EngineReport engine;
  std::optional<std::string> limit;
  std::vector<std::pair<std::string, double>> seconds;
  std::vector<std::string> warnings;
};

/// The certified topology of a real plane curve, for any curve: vertical lines, vertical asymptotes, several critical
/// points above one abscissa and any singularity are input like any other; repeated factors count once (with a
/// warning). With a box the curve is cut at its border, which belongs to the box.
///
/// Source: the cylindrical algorithm with boxes of [ChengEtAl2010], without change of coordinates: above the abscissae
/// of the points with p = p_y = 0 multiplicities of fibres are found exactly, half-branches are counted on rational
/// fibres next to them. Milnor numbers by Teissier's formula ([Teissier1973]). docs/curve-topology.md.
/// Throws InvalidInput when p is constant or the box is empty, PrecisionExhausted when no number of digits within
/// reason tells critical points apart, and LimitReached when `context` says so.
TopologyResult curve_topology(const CurveTopologyProblem& problem, const Options& options, const Context& context);

}  // namespace eliminant::intersect
