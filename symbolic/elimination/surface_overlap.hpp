// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <eliminant/base/context.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// Whether two maps have one and the same surface as their image (apart from lower dimensional sets; domains play no
/// part). A proof either way: a point of one where the matrix of the other has full rank, or the implicit equation of
/// one, which vanishes on the other. Throws LimitReached when the equation is too large, InvalidInput when an image is
/// no surface.
bool have_equal_image(const RationalSurface& first, const RationalSurface& second, std::uint64_t seed,
                      const Context& context);

}  // namespace eliminant::symbolic
