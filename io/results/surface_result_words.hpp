// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <eliminant/intersect/patches/surface_result.hpp>
#include <eliminant/intersect/patches/surface_surface.hpp>
#include <eliminant/symbolic/geometry/domain.hpp>

namespace eliminant::io {

/// The parameters of both surfaces and the coordinates, as every format calls them.
inline constexpr std::array parameter_names{"u", "v", "s", "t"};
inline constexpr std::array coordinate_names{"x", "y", "z"};

/// Of u, v, s and t: the interval that it runs through, where it has a domain.
using SurfaceDomains = std::array<std::optional<symbolic::Interval>, 4>;

/// From the first lower to the last upper end where a surface has several pieces.
SurfaceDomains domains_of(const intersect::SurfaceSurfaceProblem& problem);
SurfaceDomains domains_of(const intersect::SurfaceSelfIntersectionProblem& problem);

/// `curve`, `loop`, `point`, `overlap`.
const char* word_for(intersect::SurfaceComponentKind kind);
/// `border`, `singular_point`, `infinity`, `unknown`.
const char* word_for(intersect::BranchEndKind kind);
/// `out`, `in`, `touching`.
const char* word_for(intersect::Transition transition);
/// `contact`, `crossing`, `cusp`, `pinch_point`, `triple_point`, `undecided`.
const char* word_for(intersect::SurfaceSingularity kind);
/// `curve`, `base_point`, `at_infinity`, `contracted_curve`, `coincident_parameters`.
const char* word_for(symbolic::ComponentKind kind);
/// `no`, `no_surface`, `overlap`, `many_to_one`, `contracted`.
const char* word_for(symbolic::DeterminantVanishing vanishing);

/// The borders on which an end lies: `u=lower`, `t=upper`.
std::vector<std::string> border_words(const intersect::BranchEnd& end);

/// The four parameters and three coordinates of a point.
std::array<double, 7> values_of(const intersect::SurfacePoint& point);

/// The shortest decimal text that reads back as the same double, without a sign for zero. A parameter at infinity is
/// `inf` on either side, a coordinate there `-inf` or `inf`; what is not known is empty.
std::string parameter_text(double value);
std::string coordinate_text(double value);

}  // namespace eliminant::io
