// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <support/text_surfaces.hpp>

#include <eliminant/symbolic/elimination/blown_up_base_point.hpp>

using namespace eliminant::symbolic;
using eliminant::test::map_of;

TEST_CASE("blown-up base point: the pole of a stereographic sphere") {
  // In the inverses of both parameters.
  const auto charts = blown_up_at_origin(map_of({"2*u*v^2", "2*u^2*v", "u^2 + v^2 - u^2*v^2", "u^2 + v^2 + u^2*v^2"}));
  REQUIRE(charts);
  CHECK((*charts)[0].coordinates() ==
        map_of({"2*u*v^2", "2*u*v", "1 + v^2 - u^2*v^2", "1 + v^2 + u^2*v^2"}).coordinates());
  CHECK((*charts)[1].coordinates() ==
        map_of({"2*u*v", "2*u^2*v", "1 + u^2 - u^2*v^2", "1 + u^2 + u^2*v^2"}).coordinates());
}

TEST_CASE("blown-up base point: nothing where a direction leads to infinity or the origin is no base point") {
  // The weight vanishes in real directions; along u = 0 alone; another coordinate is of lower degree; no base point.
  CHECK_FALSE(blown_up_at_origin(map_of({"2*u*v^2", "2*u^2*v", "v^2 - u^2 - u^2*v^2", "v^2 - u^2 + u^2*v^2"})));
  CHECK_FALSE(blown_up_at_origin(map_of({"u", "v", "u + v", "u"})));
  CHECK_FALSE(blown_up_at_origin(map_of({"u", "v", "0", "u^2 + v^2"})));
  CHECK_FALSE(blown_up_at_origin(map_of({"u", "v", "0", "1 + u^2"})));
  CHECK_FALSE(blown_up_at_origin(map_of({"u", "v", "0", "0"})));
}
