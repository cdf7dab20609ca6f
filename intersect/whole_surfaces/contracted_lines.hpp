// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

/// Whether no real line u = constant or v = constant of `surface`, infinity included, is one affine point of `other`,
/// the pole of a sphere say: an isolated common point may hide there from every projection. False also when it cannot
/// be told.
bool contracts_nothing_to(const symbolic::RationalSurface& surface, const symbolic::RationalSurface& other,
                          const Context& context);

}  // namespace eliminant::intersect
