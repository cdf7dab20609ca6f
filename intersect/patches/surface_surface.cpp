// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/patches/surface_surface.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/overlaps/equal_surfaces.hpp>
#include <eliminant/intersect/overlaps/overlap_borders.hpp>
#include <eliminant/intersect/patches/branch_joining.hpp>
#include <eliminant/intersect/patches/branch_spline.hpp>
#include <eliminant/intersect/patches/joined_self_intersection.hpp>
#include <eliminant/intersect/patches/one_sign_parts.hpp>
#include <eliminant/intersect/patches/patch_pair.hpp>
#include <eliminant/intersect/patches/surface_summary.hpp>
#include <eliminant/intersect/patches/thinned_polylines.hpp>
#include <eliminant/intersect/sections/implicit_section.hpp>
#include <eliminant/intersect/sections/inverted_section.hpp>
#include <eliminant/intersect/whole_surfaces/projective_charts.hpp>
#include <eliminant/intersect/whole_surfaces/whole_surfaces.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::ParametricSurface;
using symbolic::RationalSurface;
using symbolic::SurfacePiece;

bool is_triangular(const ParametricSurface& surface) {
  return surface.pieces.front().map.kind() == RationalSurface::Kind::triangular;
}

bool has_one_sign_of_weights(const symbolic::SurfacePiece& piece) {
  return has_positive_weights(prepared_patch(piece, "first"));
}

bool is_whole(const ParametricSurface& surface) { return !surface.pieces.front().region; }

void add_warning(SurfaceResult& result, const std::string& warning) {
  if (std::find(result.warnings.begin(), result.warnings.end(), warning) == result.warnings.end())
    result.warnings.push_back(warning);
}

/// The charts of a surface, those of bounded ones cut so that each has weights of one sign.
std::vector<ProjectiveChart> charts_to_intersect(const ParametricSurface& surface, std::size_t which,
                                                 SurfaceResult& result) {
  std::vector<ProjectiveChart> charts = projective_charts(surface, which);
  if (is_whole(surface)) return charts;
  std::vector<ProjectiveChart> all;
  for (const ProjectiveChart& chart : charts) {
    OneSignParts cut = one_sign_parts(chart.piece, which);
    const std::string name = which == 0 ? "the first surface" : "the second surface";
    if (cut.signs == WeightSigns::both)
      add_warning(result, "the weight of " + name + " is zero within its domain, where it goes to infinity");
    if (cut.signs == WeightSigns::undecided)
      add_warning(result, "the weight of " + name + " comes near to zero: it was not shown to have one sign");
    for (symbolic::SurfacePiece& part : cut.parts) all.push_back({std::move(part), chart.inverted, chart.corner});
  }
  return all;
}

/// What is found of a contact can depend on which patch is the first one, in whose parameters it is looked for.
SurfaceResult intersect_in_either_order(const symbolic::SurfacePiece& first, const symbolic::SurfacePiece& second,
                                        const Options& options, const Context& context) {
  SurfaceResult result = intersect_patches(first, second, options, context);
  if (result.status != Status::numeric || result.limit || !options.certify) return result;
  SurfaceResult other = intersect_patches(second, first, options, context);
  if (other.status == Status::numeric) return result;
  exchange_surfaces(other);
  return other;
}

enum class Wanted { everything, proof };

/// Every part of the first with every part of the second; where a proof is wanted, only until one pair of parts has
/// none.
SurfaceResult intersect_charts(const ParametricSurface& first, const ParametricSurface& second, const Options& options,
                               const Context& context, Wanted wanted = Wanted::everything) {
  const auto start = std::chrono::steady_clock::now();
  SurfaceResult result;
  result.status = Status::certified;
  const std::vector<ProjectiveChart> charts = charts_to_intersect(first, 0, result);
  const std::vector<ProjectiveChart> others = charts_to_intersect(second, 1, result);
  for (const ProjectiveChart& a : charts)
    for (const ProjectiveChart& b : others) {
      if (result.limit || (wanted == Wanted::proof && result.status != Status::certified)) break;
      SurfaceResult part = intersect_in_either_order(a.piece, b.piece, options, context);
      to_surface_parameters(part, a, b);
      append(result, std::move(part));
    }
  const DomainBounds bounds = domain_bounds(first, second);
  remove_borders_of_overlaps(result, bounds);
  join_branches(result, bounds);
  summarise(result);
  result.seconds = {{"total", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()}};
  return result;
}

/// As a section of one surface where the other one has inverses; by charts, whose curves are traced to the tolerance,
/// too, where that is proven; else by the eliminant, which is told in any case.
SurfaceResult intersect_whole(const ParametricSurface& first, const ParametricSurface& second, const Options& options,
                              const Context& context) {
  const RationalSurface& a = first.pieces.front().map;
  const RationalSurface& b = second.pieces.front().map;
  const auto with_projection = [&](SurfaceResult result) {
    result.projection = SurfaceProjection{{"u", "t"}, symbolic::intersection_eliminant(a, b, options.seed, context)};
    return result;
  };
  std::optional<SurfaceResult> section;
  if (options.engine == Engine::automatic && options.certify) {
    section = intersect_by_inversion(a, b, options, context);
    if (section && section->status == Status::certified) return with_projection(*std::move(section));
  }
  // Charts of one surface overlap each other everywhere.
  if (options.engine != Engine::exact && !are_one_surface(a, b, options, context)) {
    const Wanted wanted = options.engine == Engine::box ? Wanted::everything : Wanted::proof;
    SurfaceResult by_charts = intersect_charts(first, second, options, context, wanted);
    if (by_charts.status == Status::certified || options.engine == Engine::box)
      return with_projection(std::move(by_charts));
  }
  // Nothing is missing there; the eliminant would draw it with a much larger error.
  if (section) return with_projection(*std::move(section));
  return intersect_whole_surfaces(a, b, options, context);
}

/// One of both is given by an equation.
SurfaceResult intersect_with_equation(const SurfaceSurfaceProblem& problem, const Options& options,
                                      const Context& context) {
  const bool equation_first = std::holds_alternative<symbolic::Polynomial>(problem.first);
  const auto& surface = std::get<ParametricSurface>(equation_first ? problem.second : problem.first);
  const auto& equation = std::get<symbolic::Polynomial>(equation_first ? problem.first : problem.second);
  SurfaceResult result = intersect_surface_with_equation(surface, equation, options, context);
  if (equation_first) exchange_surfaces(result);
  return result;
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
  for (const ParametricSurface* surface : {first, second})
    if (surface != nullptr && is_triangular(*surface) && is_whole(*surface))
      throw InvalidInput(
          "a surface of three homogeneous parameters without a domain cannot be intersected with a surface yet",
          "\"domain\": \"triangle\", or two parameters");
  const Options tracing = tracing_options(options);
  SurfaceResult result = first == nullptr || second == nullptr   ? intersect_with_equation(problem, tracing, context)
                         : is_whole(*first) && is_whole(*second) ? intersect_whole(*first, *second, tracing, context)
                                                                 : intersect_charts(*first, *second, tracing, context);
  result.problem = "surface_surface";
  thin_polylines(result);
  fit_splines(result, options);
  return result;
}

SurfaceResult intersect_surface_with_itself(const SurfaceSelfIntersectionProblem& problem, const Options& options,
                                            const Context& context) {
  const auto& pieces = problem.surface.pieces;
  const bool whole = is_whole(problem.surface);
  if (whole && is_triangular(problem.surface))
    throw InvalidInput(
        "the self-intersection of a surface of three homogeneous parameters without a domain is not computed yet",
        "\"domain\": \"triangle\", or two parameters");
  const Options tracing = tracing_options(options);
  const bool is_patch =
      pieces.size() == 1 && !is_triangular(problem.surface) && (whole || has_one_sign_of_weights(pieces.front()));
  SurfaceResult result = whole      ? intersect_whole_surface_with_itself(pieces.front().map, tracing, context)
                         : is_patch ? intersect_patch_with_itself(pieces.front(), tracing, context)
                                    : intersect_joined_surface_with_itself(problem.surface, tracing, context);
  result.problem = "self_intersection";
  thin_polylines(result);
  fit_splines(result, options);
  return result;
}

}  // namespace eliminant::intersect
