// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include <doctest/doctest.h>

#include <support/representation_data.hpp>

#include <eliminant/symbolic/elimination/pencil_structure.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>

using namespace eliminant;
using namespace eliminant::test;
using Steps = std::vector<std::array<long, 2>>;

namespace {

symbolic::PencilStructure structure(const std::string& surface, const std::vector<std::string>& curve,
                                    std::uint64_t seed = 0) {
  return symbolic::pencil_structure_modulo(symbolic::matrix_representation(reference_surface(surface)),
                                           curve_map(curve), seed);
}

}  // namespace

TEST_CASE("Pencil structure: the examples of [LuuBuseMourrain2009]") {
  // 19 x 18: 13 finite eigenvalues, one infinite block of order 2, and the left minimal index 3.
  const symbolic::PencilStructure first = structure("ex1_cubic", {"1", "t", "t^2", "t^3"});
  CHECK(first.column_steps == Steps{{17, 1}, {16, 1}});
  CHECK(first.row_steps == Steps{{16, 1}, {15, 1}, {14, 1}, {13, 0}});
  CHECK(first.regular_size == 13);
  CHECK(first.full_rank);
  // 10 x 9: 6 finite ones and the left index 3.
  const symbolic::PencilStructure second = structure("sphere_quadratic", {"1", "t", "t^2", "t^3"});
  CHECK(second.column_steps.empty());
  CHECK(second.row_steps == Steps{{9, 1}, {8, 1}, {7, 1}, {6, 0}});
  CHECK(second.regular_size == 6);
  // 4 x 3: 3 finite ones and the left index 0.
  const symbolic::PencilStructure third = structure("sphere_quadratic", {"1", "0", "0", "t"});
  CHECK(third.column_steps.empty());
  CHECK(third.row_steps == Steps{{3, 0}});
  CHECK(third.regular_size == 3);
}

TEST_CASE("Pencil structure: a curve inside the surface leaves no full rank, whatever the prime") {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const symbolic::PencilStructure equator = structure("torus_2_1", {"3 - 3*t^2", "6*t", "0", "t^2 + 1"}, seed);
    CHECK_FALSE(equator.full_rank);
    // Finite eigenvalues without meaning.
    CHECK(equator.regular_size == 4);
    CHECK_FALSE(structure("cylinder_2_1", {"1", "0", "t", "1"}, seed).full_rank);
    CHECK(structure("torus_2_1", {"t", "0", "0", "1"}, seed).full_rank);
  }
}
