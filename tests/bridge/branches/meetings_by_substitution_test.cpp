// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include <eliminant/bridge/branches/meetings_by_substitution.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>

using namespace eliminant;

namespace {

using Meetings = std::vector<std::array<double, 2>>;

symbolic::RationalCurve curve(const std::vector<std::string>& coordinates) {
  std::vector<symbolic::Polynomial> polynomials;
  polynomials.reserve(coordinates.size());
  const std::vector<std::string> names{"t"};
  for (const std::string& text : coordinates) polynomials.push_back(symbolic::parse_polynomial(text, names));
  return symbolic::rational_curve(polynomials);
}

std::optional<Meetings> meetings(const std::vector<std::string>& first, const std::vector<std::string>& second) {
  return bridge::meetings_by_substitution(curve(first), curve(second), Context());
}

}  // namespace

TEST_CASE("Meetings by substitution: graphs over one line, and over lines of other speeds") {
  CHECK(meetings({"0", "t", "t^2", "1"}, {"0", "t", "1/4", "1"}) == Meetings{{0.5, 0.5}});
  CHECK(meetings({"0", "t", "t^2", "1"}, {"0", "t/2", "1/16", "1"}) == Meetings{{0.25, 0.5}});
  // Half of the first line is beyond the second one.
  CHECK(meetings({"0", "2*t", "(4*t - 1)*(4*t - 3)", "1"}, {"0", "t", "0", "1"}) == Meetings{{0.25, 0.5}});
  CHECK(meetings({"0", "t", "t^3 - t/8", "1"}, {"0", "1 - t", "0", "2"})->size() == 2);
  // The linear coordinate is that of the first curve.
  CHECK(meetings({"t", "t", "0", "1"}, {"t^2", "t^2", "(2*t - 1)*(3*t + 1)", "1"}) == Meetings{{0.25, 0.5}});
}

TEST_CASE("Meetings by substitution: ends of domains count, exactly") {
  CHECK(meetings({"t", "0", "t^2 - t", "1"}, {"t", "0", "0", "1"}) == Meetings{{0, 0}, {1, 1}});
  CHECK(meetings({"t", "0", "0", "1"}, {"0", "t", "0", "1"}) == Meetings{{0, 0}});
  // t = 1 gives u = 2, and t = 1/3 gives u = 2/3.
  CHECK(meetings({"2*t", "0", "(3*t - 1)*(t - 1)", "1"}, {"t", "0", "0", "1"})->size() == 1);
  // At u = 1 and t = 1/2: no proof on this side of the end.
  CHECK_FALSE(meetings({"2*t", "0", "(2*t - 1)*(7*t - 2)*(t^2 + 1)", "1"}, {"t", "0", "0", "1"}) == Meetings{});
}

TEST_CASE("Meetings by substitution: tangent and repeated roots once, common curves and curved pairs not at all") {
  CHECK(meetings({"t", "0", "(2*t - 1)^2", "1"}, {"t", "0", "0", "1"}) == Meetings{{0.5, 0.5}});
  CHECK(meetings({"t", "0", "(2*t - 1)^3*t^2", "1"}, {"t", "0", "0", "1"}) == Meetings{{0, 0}, {0.5, 0.5}});
  CHECK(meetings({"t", "0", "1", "1"}, {"t", "0", "0", "1"}) == Meetings{});
  CHECK(meetings({"t", "0", "0", "1"}, {"t", "1", "0", "1"}) == Meetings{});
  CHECK_FALSE(meetings({"t", "0", "0", "1"}, {"t", "0", "0", "1"}));
  CHECK_FALSE(meetings({"t^2", "t^3", "0", "1"}, {"t^3", "t^2", "0", "1"}));
  CHECK_FALSE(meetings({"t", "0", "0", "1 + t"}, {"t", "0", "0", "1"}));
}
