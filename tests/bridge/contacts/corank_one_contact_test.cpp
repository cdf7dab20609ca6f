// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/corank_one_contact.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

const std::string ground = "u*v/3 + u^2/5";

/// At (1/2, 1/3) on both.
std::optional<CorankOneContact> contact_of(const std::string& height) {
  return corank_one_contact(patch_net({"u", "v", ground}), patch_net({"u", "v", ground + " - (" + height + ")"}),
                            {ratio(1, 2), ratio(1, 3), ratio(1, 2), ratio(1, 3)});
}

/// x and y for u - 1/2 and v - 1/3.
std::string placed(const std::string& height) {
  std::string result;
  for (const char c : height) result += c == 'x' ? "(u - 1/2)" : c == 'y' ? "(v - 1/3)" : std::string(1, c);
  return result;
}

}  // namespace

TEST_CASE("Corank one contact: the order and the ridge, exactly") {
  struct Case {
    std::string height;
    bool exchanged;
    std::size_t order;
    std::vector<Rational> ridge;
  };
  const std::vector<Case> cases{
      {"x^2 - y^3", true, 3, {0, 0, 0}},
      {"y^2 - 2*x^3", false, 3, {0, 0, 0}},
      {"-3*y^2 + x^4", false, 4, {0, 0, 0, 0}},
      {"(y - x^2)^2 - x^5", false, 5, {0, 0, 1, 0}},
      {"(2*y - x)^2 + x^3", false, 3, {0, ratio(1, 2), 0}},
      {"(y - 2*x)^2 + x^6", true, 6, {0, ratio(1, 2), 0, 0, 0}},
      // (1 + x) y^2 + (x^2 + x^3 / 2) y + x^4 / 4 is least where y = -(x^2 / 2) (1 + x / 2) / (1 + x): -x^6 / 16 + ...
      {"y^2 + x^2*y + x^4/4 + x*y^2 + x^3*y/2", false, 6, {0, 0, ratio(-1, 2), ratio(1, 4), ratio(-1, 4)}},
      {"y^2 + x^7", false, 7, {0, 0, 0, 0, 0}},
      {"y^2 - x^8", false, 8, {0, 0, 0, 0, 0, 0}},
  };
  for (const Case& given : cases) {
    CAPTURE(given.height);
    const auto contact = contact_of(placed(given.height));
    REQUIRE(contact);
    CHECK(contact->exchanged == given.exchanged);
    CHECK(contact->order == given.order);
    CHECK(contact->ridge == given.ridge);
  }
}

TEST_CASE("Corank one contact: none where the Hessian has rank two or zero, or along a curve of contact") {
  for (const std::string height : {"x^2 + y^2", "x*y", "x^3 - 3*x*y^2", "(x + y)^2", "(y - x^2)^2", "y^2 + x^9"}) {
    CAPTURE(height);
    CHECK_FALSE(contact_of(placed(height)));
  }
}

TEST_CASE("Corank one contact: the place is found to doubles where Newton's method for contacts is slow") {
  for (const std::string height : {"x^2 - y^3", "x^2 - y^4", "x^2 + y^5 + x*y^3", "(x - y^2)^2 + y^6"}) {
    CAPTURE(height);
    const NetPair nets({"u", "v", ground}, {"u", "v", ground + " - (" + placed(height) + ")"});
    const CellBox box{{0.45, 0.3, 0.45, 0.3}, {0.6, 0.45, 0.6, 0.45}};
    const auto found = corank_one_contacts_near(nets.first, nets.second, box);
    REQUIRE(found.size() == 1);
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::fabs(found[0][k] - (k % 2 == 0 ? 0.5 : 1.0 / 3)) < 1e-11);
  }
}

TEST_CASE("Corank one contact: near misses are not taken for one") {
  for (const std::string height : {"x^2 - y^3 + 1/1000", "x^2 - y^3 - y/100", "x^2 + y^2"}) {
    CAPTURE(height);
    const NetPair nets({"u", "v", ground}, {"u", "v", ground + " - (" + placed(height) + ")"});
    const CellBox box{{0.45, 0.3, 0.45, 0.3}, {0.6, 0.45, 0.6, 0.45}};
    CHECK(corank_one_contacts_near(nets.first, nets.second, box).empty());
  }
}
