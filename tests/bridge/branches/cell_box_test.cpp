// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/bridge/branches/cell_box.hpp>

using eliminant::bridge::ContainedBorder;

TEST_CASE("Contained border: holds the points of its border curve between its ends, and no others") {
  // u = 1 from v = 1/4 to 1/2.
  const ContainedBorder of_first{0, 1, 0.25, 0.5};
  CHECK(of_first.holds({1, 0.25, 0.1, 0.9}, 0));
  CHECK(of_first.holds({1, 0.5, 0.7, 0.2}, 0));
  CHECK_FALSE(of_first.holds({0, 0.4, 0.1, 0.9}, 0));
  CHECK_FALSE(of_first.holds({1, 0.51, 0.1, 0.4}, 0));
  CHECK_FALSE(of_first.holds({1, 0.24, 0.1, 0.4}, 0));
  CHECK_FALSE(of_first.holds({0.99, 0.4, 1, 0.4}, 0));
  // t = 0 from s = 1/4 to 1/2.
  const ContainedBorder of_second{3, -1, 0.25, 0.5};
  CHECK(of_second.holds({0.1, 0.9, 0.3, 0}, 0));
  CHECK_FALSE(of_second.holds({0.1, 0.9, 0.3, 1}, 0));
  CHECK_FALSE(of_second.holds({0.3, 0.3, 0.9, 0}, 0));
  CHECK_FALSE(of_second.holds({0.3, 0, 0.3, 0.9}, 0));
}

TEST_CASE("Contained border: a point that may be on it counts") {
  const ContainedBorder border{1, -1, 0.25, 0.5};
  CHECK(border.holds({0.3, 0.01, 0.5, 0.5}, 0.011));
  CHECK(border.holds({0.3, -0.01, 0.5, 0.5}, 0.011));
  CHECK_FALSE(border.holds({0.3, 0.01, 0.5, 0.5}, 0.009));
  CHECK(border.holds({0.51, 0, 0.5, 0.5}, 0.011));
  CHECK_FALSE(border.holds({0.51, 0, 0.5, 0.5}, 0.009));
  CHECK(border.holds({0.24, 0, 0.5, 0.5}, 0.011));
  CHECK_FALSE(border.holds({0.24, 0, 0.5, 0.5}, 0.009));
}
