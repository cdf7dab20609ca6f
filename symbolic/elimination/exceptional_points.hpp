// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <eliminant/symbolic/arithmetic/polynomial.hpp>
#include <eliminant/symbolic/geometry/rational_surface.hpp>

namespace eliminant::symbolic {

/// Whether every real point with w != 0 of a quadric on which all `witnesses` vanish is one to which the surface
/// contracts a real line of parameters: the pole of a stereographic sphere, the apex of a cone. `equation` is the form
/// of the surface in x, y, z, w, the witnesses are forms in them. False decides nothing, and is the answer for other
/// degrees. Method: on the planes of linear factors of the witnesses the form is definite but for a kernel of one
/// point.
bool are_exceptions_contracted_lines(const RationalSurface& surface, const Polynomial& equation,
                                     const std::vector<Polynomial>& witnesses);

}  // namespace eliminant::symbolic
