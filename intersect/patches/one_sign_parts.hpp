// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::intersect {

enum class WeightSigns {
  one,       ///< the weight has no zero on the patch: proven
  both,      ///< it has one, where the patch goes to infinity or is not defined: proven
  undecided  ///< it comes so near to zero that neither was found out
};

/// A tensor-product patch in parts whose Bernstein weights have one sign, which those of the whole need not have.
struct OneSignParts {
  WeightSigns signs = WeightSigns::one;
  /// Rectangles of the same parameters; the patch alone where `signs` is not `one`.
  std::vector<symbolic::SurfacePiece> parts;
};

/// Cuts the patch exactly, into four again and again, where its weights have both signs or are zero. Cuts of different
/// `which` (0 to 2) are at different places, none in the middle.
OneSignParts one_sign_parts(const symbolic::SurfacePiece& patch, std::size_t which);

}  // namespace eliminant::intersect
