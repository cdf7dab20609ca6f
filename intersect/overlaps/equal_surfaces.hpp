// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/intersect/options.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// Whether two tensor-product maps are proven to have one surface as image. False also where the equation is too large.
bool are_one_surface(const symbolic::RationalSurface& first, const symbolic::RationalSurface& second,
                     const Options& options, const Context& context);

/// Whether two maps with one surface as image are proven to have real points in common that fill an area: the images of
/// real parameters may be different parts of the surface. Looked for around a few points of the first. False decides
/// nothing.
bool have_common_real_part(const symbolic::RationalSurface& first, const symbolic::RationalSurface& second,
                           const Options& options, const Context& context);

}  // namespace eliminant::intersect
