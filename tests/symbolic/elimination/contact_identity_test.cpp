// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/arithmetic/parse_polynomial.hpp>
#include <eliminant/symbolic/elimination/contact_identity.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;

namespace {

Polynomial parsed(const std::string& text) {
  static const std::vector<std::string> names{"u", "v"};
  return parse_polynomial(text, names);
}

std::vector<Polynomial> map_of(const std::array<std::string, 4>& text) {
  std::vector<Polynomial> result;
  for (const std::string& coordinate : text) result.push_back(parsed(coordinate));
  return result;
}

ContactRelation relation_of(const std::string& curve, const std::string& s, const std::string& t,
                            const std::string& below = "1") {
  return {parsed(curve), {parsed(s), parsed(t)}, {parsed(below), parsed(below)}};
}

}  // namespace

TEST_CASE("Contact identity: patches whose difference is a square touch along its root, and along nothing else") {
  const auto first = map_of({"u", "v", "u*v", "1"});
  const auto second = map_of({"u", "v", "u*v + (u^2 + v^2 - 1/3)^2*(u + 2)", "1"});
  CHECK(touch_along(first, second, relation_of("u^2 + v^2 - 1/3", "u", "v")));
  CHECK(touch_along(second, first, relation_of("u^2 + v^2 - 1/3", "u", "v")));
  // They cross there.
  CHECK_FALSE(touch_along(first, second, relation_of("u + 2", "u", "v")));
  // Other points, another curve.
  CHECK_FALSE(touch_along(first, second, relation_of("u^2 + v^2 - 1/3", "v", "u")));
  CHECK_FALSE(touch_along(first, second, relation_of("u^2 + v^2 - 1/2", "u", "v")));
}

TEST_CASE("Contact identity: quotients as parameters, and weights") {
  const auto first = map_of({"u", "v", "0", "1 + u"});
  // The same plane with s = u/(1 + u), lifted by a square.
  const auto second = map_of({"u", "v", "(u - 2*v)^2", "1"});
  const ContactRelation relation = relation_of("u - 2*v", "u", "v", "1 + u");
  CHECK(touch_along(first, second, relation));
  // A denominator that vanishes along the curve says nothing.
  CHECK_FALSE(touch_along(first, second, relation_of("u - 2*v", "u*(u - 2*v)", "v*(u - 2*v)", "(1 + u)*(u - 2*v)")));
  CHECK_THROWS_AS(touch_along(first, second, relation_of("2", "u", "v")), InvalidInput);
}

TEST_CASE("Contact identity: maps that cross along a curve meet there, and do not touch") {
  const auto first = map_of({"u", "v", "u*v", "1"});
  const auto second = map_of({"u", "v", "u*v + (u - 1/3)*(v + 2)", "1"});
  CHECK(meet_along(first, second, relation_of("u - 1/3", "u", "v")));
  CHECK_FALSE(touch_along(first, second, relation_of("u - 1/3", "u", "v")));
  CHECK_FALSE(meet_along(first, second, relation_of("u - 1/3", "v", "u")));
  CHECK_FALSE(meet_along(first, second, relation_of("u - 1/3", "u*(u - 1/3)", "v*(u - 1/3)", "u - 1/3")));
  CHECK_THROWS_AS(meet_along(first, second, relation_of("2", "u", "v")), InvalidInput);
}
