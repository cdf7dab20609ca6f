// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/surface_surface.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/branch_spline.hpp>
#include <eliminant/intersect/patch_pair.hpp>
#include <eliminant/intersect/whole_surfaces.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::ParametricSurface;
using symbolic::RationalSurface;
using symbolic::SurfacePiece;

void require_tensor_product(const ParametricSurface& surface) {
  if (std::any_of(surface.pieces.begin(), surface.pieces.end(),
                  [](const SurfacePiece& piece) { return piece.map.kind() == RationalSurface::Kind::triangular; }))
    throw InvalidInput("a surface of three homogeneous parameters cannot be intersected with a surface yet",
                       "two parameters");
}

bool is_bounded(const ParametricSurface& surface) {
  return std::all_of(surface.pieces.begin(), surface.pieces.end(),
                     [](const SurfacePiece& piece) { return piece.region.has_value(); });
}

double extent(const SurfaceResult& result) {
  double size = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lower = INFINITY;
    double upper = -INFINITY;
    for (const SurfaceComponent& component : result.components)
      for (const SurfacePoint& point : component.points)
        if (std::isfinite(point.point[axis])) {
          lower = std::min(lower, point.point[axis]);
          upper = std::max(upper, point.point[axis]);
        }
    size = std::max(size, upper - lower);
  }
  return size;
}

// Polylines that leave two thirds of the tolerance to the splines fitted to them.
Options tracing_options(const Options& options) {
  Options result = options;
  if (options.splines) result.tolerance = options.tolerance / 3;
  return result;
}

void fit_splines(SurfaceResult& result, const Options& options) {
  if (!options.splines) return;
  // The size of the surfaces is at least that of the curves.
  const double tolerance = 2 * options.tolerance / 3 * extent(result);
  for (SurfaceComponent& component : result.components)
    component.spline = branch_spline(component, std::max(tolerance, 2 * component.error));
}

}  // namespace

SurfaceResult intersect_surface_surface(const SurfaceSurfaceProblem& problem, const Options& options,
                                        const Context& context) {
  const auto* first = std::get_if<ParametricSurface>(&problem.first);
  const auto* second = std::get_if<ParametricSurface>(&problem.second);
  if (first == nullptr && second == nullptr)
    throw InvalidInput("both surfaces are given by equations", "at least one surface with parameters");
  if (first == nullptr || second == nullptr)
    throw InvalidInput("a surface given by an equation cannot be intersected with a surface yet", "two parameters");
  require_tensor_product(*first);
  require_tensor_product(*second);
  const Options tracing = tracing_options(options);
  SurfaceResult result;
  if (is_bounded(*first) && is_bounded(*second)) {
    result.status = Status::certified;
    for (const SurfacePiece& a : first->pieces)
      for (const SurfacePiece& b : second->pieces)
        if (!result.limit) append(result, intersect_patches(a, b, tracing, context));
  } else if (!is_bounded(*first) && !is_bounded(*second)) {
    result = intersect_whole_surfaces(first->pieces.front().map, second->pieces.front().map, tracing, context);
  } else {
    throw InvalidInput("one surface has a domain and the other one has none", "a domain for both surfaces, or none");
  }
  result.problem = "surface_surface";
  fit_splines(result, options);
  return result;
}

SurfaceResult intersect_surface_with_itself(const SurfaceSelfIntersectionProblem& problem, const Options& options,
                                            const Context& context) {
  const auto& pieces = problem.surface.pieces;
  require_tensor_product(problem.surface);
  const Options tracing = tracing_options(options);
  SurfaceResult result;
  if (is_bounded(problem.surface)) {
    result.status = Status::certified;
    for (std::size_t i = 0; i < pieces.size() && !result.limit; ++i) {
      append(result, intersect_patch_with_itself(pieces[i], tracing, context));
      for (std::size_t j = i + 1; j < pieces.size() && !result.limit; ++j)
        append(result, intersect_patches(pieces[i], pieces[j], tracing, context));
    }
  } else {
    result = intersect_whole_surface_with_itself(pieces.front().map, tracing, context);
  }
  result.problem = "self_intersection";
  fit_splines(result, options);
  return result;
}

}  // namespace eliminant::intersect
