// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <support/patch_case.hpp>

/// What the intersection of two patches is, without the engine that is tested.
namespace eliminant::test {

/// One component in the parameters of the first patch.
struct TrueComponent {
  enum class Kind { curve, loop, point };

  Kind kind = Kind::curve;
  std::vector<std::array<double, 2>> parameters;
};

struct TrueIntersection {
  PatchCounts counts;
  std::vector<TrueComponent> components;
};

/// The part of the curve `equation` = 0 in a box.
struct PlaneCurve {
  symbolic::Polynomial equation{2};
  intersect::Box box;
};

/// Where the second patch is, up to a linear map of homogeneous coordinates, a graph (s, t, g(s, t), 1): the
/// intersection as a curve in the parameters of the first patch, by substitution. nullopt where it is no graph, the
/// first patch is none of weight 1 in these coordinates, or what lies over the unit square is not known to be a box.
std::optional<PlaneCurve> substituted_in_graph(const PatchCase& patches);

/// The arcs, loops and points of a plane curve in a box, by the exact topology of plane curves: a vertex that is
/// singular or on the border of the box is an end. Throws std::logic_error where that is not certified.
TrueIntersection plane_intersection(const PlaneCurve& curve);

/// By exact substitution where it is possible, else by dense sampling.
TrueIntersection true_intersection(const PatchCase& patches);

}  // namespace eliminant::test
