// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/curve_surface/prepared_surface.hpp>
#include <eliminant/intersect/curve_surface/surface_borders.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/intersect/options.hpp>

namespace eliminant::intersect {

/// Whether parameters of a point of the curve lie in the patch.
using PatchTest = std::function<Answer(const HomogeneousParameters&, const PointOnCurve&)>;

/// What of a curve inside a surface lies in a patch.
struct ContainedParts {
  std::vector<Overlap> stretches;
  /// Squarefree: the parameters at which the curve may enter or leave; without one where no border is in the way.
  symbolic::UnivariatePolynomial crossings;
  /// Indices of its real roots (ParameterRoots) with no stretch before or after: the point may lie in the patch alone,
  /// in a corner, at the end of the curve or tangent to a border.
  std::vector<std::size_t> isolated;
  bool certified = true;
};

/// The parts of a curve inside a surface that lie in the patch and in the domain of the curve, as closed intervals of
/// its parameter: between the parameters at which the curve crosses the borders, all of which are exact, one point of
/// each stretch is looked at. Stretches that meet at a border are one; one through infinity ends before it begins;
/// without a border in the way the whole curve is one overlap. An overlap is not `certified` where several parameters
/// of a point on the surface had to be told apart without proof, or certification was not asked for.
ContainedParts contained_parts(const symbolic::CurvePiece& curve, PreparedSurface& surface, SurfaceBorders& borders,
                               const PatchTest& is_within_patch, const Options& options, const Context& context);

}  // namespace eliminant::intersect
