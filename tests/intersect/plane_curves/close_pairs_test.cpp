// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

TEST_CASE("Close pairs: certified at every distance from 1e-1 to 1e-60, real and conjugate") {
  for (long exponent = 1; exponent <= 60; ++exponent)
    for (const char sign : {'-', '+'}) {
      const std::string square = "1e-" + std::to_string(2 * exponent);
      const std::pair<std::string, std::string> pairs[] = {
          {"y - x^3 + x", std::string("y - x^3 + x + (x+2)*((x-1)^2 ") + sign + " 1/4*" + square + ")"},
          {"x^2 + y^2 - 1", std::string("(x-2)^2 + y^2 - 1 ") + sign + " " + square},
          {"x^2 + x*y + 3*y^2 - 5", std::string("(x - y)^2 ") + sign + " " + square}};
      for (const auto& [p, q] : pairs) {
        CAPTURE(p);
        CAPTURE(q);
        const Result result = solve(p, q);
        CHECK(result.status == Status::certified);
        CHECK(audit_holds(result));
      }
    }
}
