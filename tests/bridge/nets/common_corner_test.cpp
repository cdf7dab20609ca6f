// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <support/text_patches.hpp>

#include <eliminant/bridge/nets/common_corner.hpp>

using namespace eliminant::bridge;
using namespace eliminant::test;

TEST_CASE("Common corner: the one point in which two patches meet, in either order") {
  const ExactNet first = patch_net({"u", "v", "u*v"});
  const ExactNet beyond = patch_net({"1 + u", "1 + v", "1 + u + v + u*v"});
  using Sides4 = std::array<int, 4>;
  CHECK(only_common_corner(first, beyond) == Sides4{1, 1, -1, -1});
  CHECK(only_common_corner(beyond, first) == Sides4{-1, -1, 1, 1});
  const ExactNet weighted = patch_net({"(1 + u)*(1 + u)", "(1 - v)*(1 + u)", "1 + u", "1 + u"});
  CHECK(only_common_corner(first, weighted) == Sides4{1, 1, -1, -1});
}

TEST_CASE("Common corner: not where patches have a border, another point or nothing in common") {
  const ExactNet first = patch_net({"u", "v", "0"});
  CHECK_FALSE(only_common_corner(first, patch_net({"1 + u", "v", "u"})));
  CHECK_FALSE(only_common_corner(first, patch_net({"2 + u", "v", "u"})));
  // From the corner back across the first.
  CHECK_FALSE(only_common_corner(first, patch_net({"1 - u", "1 - v", "u - v"})));
  CHECK_FALSE(only_common_corner(first, patch_net({"1 - u", "1 + v - 3*u*v", "u^2 + v - 2*v^2"})));
}
