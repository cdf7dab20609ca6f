// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>

#include <eliminant/symbolic/geometry/rational_curve.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// f(x, y) = 0 in the affine plane.
struct ImplicitCurve {
  symbolic::Polynomial equation{2};
};

/// f(x, y, z) = 0 in affine space.
struct ImplicitSurface {
  symbolic::Polynomial equation{3};
};

using Curve = std::variant<symbolic::ParametricCurve, ImplicitCurve>;
using Surface = std::variant<symbolic::ParametricSurface, ImplicitSurface>;

/// All points of a space curve on a surface.
struct CurveSurfaceProblem {
  symbolic::ParametricCurve curve;
  Surface surface;
};

/// All common points of two curves, both in the plane or both in space.
struct CurveCurveProblem {
  Curve first;
  Curve second;
};

/// All points that a curve passes more than once, and its singular points.
struct SelfIntersectionProblem {
  Curve curve;
};

}  // namespace eliminant::intersect
