// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/text_patches.hpp>

#include <eliminant/intersect/patches/border_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

/// A pair of patches and their border curves.
struct Pair {
  bridge::ExactNet first;
  bridge::ExactNet second;
  Context context;
  BorderCurves curves{first, second, context};

  Pair(const PatchText& a, const PatchText& b) : first(patch_net(a)), second(patch_net(b)) {}
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;
};

bool is_near(const std::array<double, 2>& pair, double a, double b) {
  return std::fabs(pair[0] - a) <= 1e-11 && std::fabs(pair[1] - b) <= 1e-11;
}

}  // namespace

TEST_CASE("Border curves: meet where their patches do, to within 1e-11") {
  // (u, u^3, u^2) and (s, s/2, 1/2) at v = t = 0, at sqrt(1/2); one higher at v = t = 1.
  Pair pair({"u", "u^3 + v", "u^2"}, {"u", "u/2 + v", "1/2"});
  const double root = std::sqrt(0.5);
  for (const int side : {-1, 1}) {
    const auto meetings = pair.curves.meetings(1, side, 3, side);
    REQUIRE(meetings.size() == 1);
    CHECK(is_near(meetings[0], root, root));
    CHECK(pair.curves.meetings(1, side, 3, -side).empty());
  }
  CHECK(pair.curves.meetings(0, -1, 2, -1).empty());
  // The border u = 1, a line (1, 1 + v, 1), is above the second patch.
  CHECK(pair.curves.meetings(0, 1, 3, -1).empty());
}

TEST_CASE("Border curves: several meetings, and none at parameters beyond the ends") {
  // On z = 0 the borders v = 0 and t = 0: y = (4 x - 1) (4 x - 3) and y = 0.
  Pair pair({"u", "(4*u - 1)*(4*u - 3) + v", "v"}, {"u", "-v", "0"});
  auto meetings = pair.curves.meetings(1, -1, 3, -1);
  REQUIRE(meetings.size() == 2);
  if (meetings[0][0] > meetings[1][0]) std::swap(meetings[0], meetings[1]);
  CHECK(is_near(meetings[0], 0.25, 0.25));
  CHECK(is_near(meetings[1], 0.75, 0.75));
  // Another interval: x = s / 2.
  Pair half({"u", "(4*u - 1)*(4*u - 3) + v", "v"}, {"u/2", "-v", "0"});
  meetings = half.curves.meetings(1, -1, 3, -1);
  REQUIRE(meetings.size() == 1);
  CHECK(is_near(meetings[0], 0.25, 0.5));
}

TEST_CASE("Border curves: what lies in the other patch, all of it or a part") {
  const Pair all({"u", "v", "0"}, {"u", "v", "u"});
  for (const std::size_t axis : {0U, 2U}) {
    const auto parts = all.curves.contained(axis, -1).intervals;
    REQUIRE(parts.size() == 1);
    CHECK(parts[0] == std::array<double, 2>{0, 1});
    CHECK(all.curves.contained(axis, 1).intervals.empty());
    CHECK(all.curves.contained(axis + 1, -1).intervals.empty());
  }
  // x = 0 from y = 1/4 to 3/4 only.
  const Pair part({"u", "v", "0"}, {"u", "v/2 + 1/4", "u"});
  const auto parts = part.curves.contained(0, -1).intervals;
  REQUIRE(parts.size() == 1);
  CHECK(is_near(parts[0], 0.25, 0.75));
  CHECK(part.curves.contained(0, -1).nothing_else);
  const auto other = part.curves.contained(2, -1).intervals;
  REQUIRE(other.size() == 1);
  CHECK(other[0] == std::array<double, 2>{0, 1});
}

TEST_CASE("Border curves: a border that is one point meets and holds nothing") {
  Pair cone({"u*v", "u*(1 - v)", "u"}, {"u", "v", "0"});
  CHECK(cone.curves.meetings(0, -1, 2, -1).empty());
  CHECK(cone.curves.contained(0, -1).intervals.empty());
}
