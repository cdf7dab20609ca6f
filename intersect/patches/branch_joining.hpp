// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/intersect/patches/parameter_metric.hpp>
#include <eliminant/intersect/patches/surface_result.hpp>

namespace eliminant::intersect {

/// The reason of a curve whose continuation was not found.
inline constexpr const char* not_followed = "it could not be followed from one piece of a surface to the next";

/// Joins curves that were cut where pieces of a surface meet: an end that is on no border of the whole domain is
/// continued by the one other end at the same parameters, which both enclose one simple zero. Sides of ends that are no
/// borders are set to 0, points that several pieces have found are listed once, and not where a curve passes, and an
/// end without a continuation makes its curve uncertified. Where three or more curves end in a corner of pieces, or
/// some in a contact that another piece has there, that is a crossing; singular points are listed once. `symmetric`:
/// both surfaces are one, and (u, v) and (s, t) may be exchanged.
void join_branches(SurfaceResult& result, const DomainBounds& bounds, bool symmetric = false);

/// Of a surface with itself, where every curve was found with (u, v) and (s, t) exchanged, too: keeps one of both, or
/// marks the curve as mirrored that is mapped to itself. Points of contact likewise.
void remove_mirror_images(SurfaceResult& result, const DomainBounds& bounds);

}  // namespace eliminant::intersect
