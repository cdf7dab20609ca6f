// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/symbolic/elimination/surface_overlap.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/implicit_equation.hpp>
#include <eliminant/symbolic/elimination/vanishing.hpp>
#include <eliminant/symbolic/geometry/image_dimension.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>
#include <eliminant/symbolic/matrices/representation_rank.hpp>

namespace eliminant::symbolic {

bool have_equal_image(const RationalSurface& first, const RationalSurface& second, std::uint64_t seed,
                      const Context& context) {
  if (!is_two_dimensional(first) || !is_two_dimensional(second))
    throw InvalidInput("a map was compared with a surface, but its image is only a curve or a point", "two surfaces");
  const MatrixRepresentation m = matrix_representation(first);
  // The rank modulo a prime is at most the true one: full rank proves that the general point of `second` is not on
  // `first`.
  if (rank_on_modulo(m, second, seed) == m.rows()) return false;
  const Polynomial equation = implicit_equation(first, m, implicit_degree(first, m, seed), seed, context);
  return vanishes_on(equation, second, context);
}

}  // namespace eliminant::symbolic
