// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <string>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/common_border.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

const std::array<symbolic::Rational, 3> origin{};

bool is_common(const PatchText& first, const PatchText& second, std::size_t axis, int side) {
  const NetPair nets(first, second);
  return is_common_border({nets.first, nets.second, nets.exact_first, nets.exact_second, origin}, axis, side);
}

/// A patch with the parabola z = y^2, 0 <= y <= 1, x = 0 where u = 0.
const PatchText parabolic{"u", "v", "v^2 + u/3"};

}  // namespace

TEST_CASE("Common border: whole borders of both, with the same parameters and with quotients of them") {
  // t as it is, turned round, by a projective map, and exchanged with s.
  for (const PatchText& second :
       {PatchText{"-u", "v", "v^2 + u*v"}, PatchText{"-u", "1 - v", "(1 - v)^2"},
        PatchText{"-u*(2 - v)^2", "v*(2 - v)", "v^2 + u*v*(2 - v)", "(2 - v)^2"}, PatchText{"u - 1", "v", "v^2"}}) {
    CAPTURE(second.y);
    const int side = second.x == "u - 1" ? 1 : -1;
    CHECK(is_common(parabolic, second, 0, -1));
    CHECK(is_common(parabolic, second, 2, side));
    for (const auto& [axis, other] : {std::pair<std::size_t, int>{0, 1}, {1, -1}, {1, 1}, {2, -side}, {3, -1}, {3, 1}})
      CHECK_FALSE(is_common(parabolic, second, axis, other));
  }
  CHECK(is_common(parabolic, {"-v", "u", "u^2"}, 0, -1));
  CHECK(is_common(parabolic, {"-v", "u", "u^2"}, 3, -1));
}

TEST_CASE("Common border: a parameter that is a polynomial of the other is one both ways, if it runs from end to end") {
  const PatchText straight{"u", "v", "u*v"};
  for (const std::string y : {"v*(1 + v)/2", "v*(1 + v)^2/4", "1 - v^3"}) {
    CAPTURE(y);
    const PatchText second{"-u", y, "0"};
    CHECK(is_common(straight, second, 0, -1));
    CHECK(is_common(straight, second, 2, -1));
  }
}

TEST_CASE("Common border: of a part only the shorter border is one, and a border that is nearly the other is none") {
  const PatchText longer{"-u", "2*v", "4*v^2"};
  CHECK(is_common(parabolic, longer, 0, -1));
  CHECK_FALSE(is_common(parabolic, longer, 2, -1));
  const PatchText shifted{"-u", "v + 1/4", "(v + 1/4)^2"};
  CHECK_FALSE(is_common(parabolic, shifted, 0, -1));
  CHECK_FALSE(is_common(parabolic, shifted, 2, -1));
  CHECK_FALSE(is_common(parabolic, {"-u", "v", "v^2 + v*(1 - v)/1000000000000000"}, 0, -1));
  // It lies within the other patch.
  CHECK_FALSE(is_common(parabolic, {"2*u - 1", "v", "v^2"}, 0, -1));
}
