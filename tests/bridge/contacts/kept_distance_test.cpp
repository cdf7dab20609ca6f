// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <string>

#include <support/text_patches.hpp>

#include <eliminant/bridge/contacts/kept_distance.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

CellBox box_around(double u, double v, double half) {
  return {{u - half, v - half, u - half, v - half}, {u + half, v + half, u + half, v + half}};
}

const std::string wave = "u^2*v - u*v^2 + u/3 + v^3/4";

NetPair raised(const std::string& height) { return {{"u", "v", wave}, {"u", "v", wave + " + " + height}}; }

/// The same graph in other parameters.
NetPair raised_elsewhere(const std::string& p, const std::string& q, const std::string& height) {
  const std::string s = "(" + p + ")";
  const std::string t = "(" + q + ")";
  const std::string z = s + "^2*" + t + " - " + s + "*" + t + "^2 + " + s + "/3 + " + t + "^3/4";
  return {{"u", "v", wave}, {s, t, z + " + " + height}};
}

bool keep_distance(const NetPair& nets) { return bridge::keep_distance(nets.first, nets.second); }
bool keep_distance(const NetPair& nets, const CellBox& box) {
  return bridge::keep_distance(nets.first, nets.second, box);
}

/// Of the unit sphere by angles, and of one of another radius with its axes turned.
NetPair spheres(const std::string& radius) {
  return {{"2*u", "2*v", "1 - u^2 - v^2", "1 + u^2 + v^2"},
          {radius + "*(1 - u^2 - v^2)", radius + "*2*v", radius + "*2*u", "1 + u^2 + v^2"}};
}

}  // namespace

TEST_CASE("Kept distance: parallel parts keep a distance, on boxes far larger than it") {
  for (const double half : {0.01, 0.03}) {
    CHECK(keep_distance(raised("1/1000"), box_around(0.5, 0.375, half)));
    CHECK(keep_distance(raised("-1/1000"), box_around(0.25, 0.625, half)));
  }
  const NetPair close = raised("1/100000");
  CHECK(keep_distance(close, box_around(0.5, 0.375, 0.005)));
  // A bowl above its tangent plane.
  const NetPair bowl({"u", "v", "0"}, {"u", "v", "(u - 1/2)^2 + (v - 1/2)^2 + 1/100000"});
  CHECK(keep_distance(bowl, box_around(0.5, 0.5, 0.05)));
}

TEST_CASE("Kept distance: no distance is claimed where there are common points") {
  for (const std::string height :
       {"0", "(u - 1/2)^2", "(u - 1/2)*(v - 1/2)", "(u - 1/2)^2 + (v - 1/2)^2", "(u - 1/2)/1000",
        "(u - 1/2)^2 - 1/1000000", "(u - 1/2)^2 + (v - 1/2)^2 - 1/10000000"}) {
    CAPTURE(height);
    const NetPair nets = raised(height);
    for (const double half : {0.1, 0.01, 0.005, 0.002}) {
      CHECK_FALSE(keep_distance(nets, box_around(0.5, 0.5, half)));
      CHECK_FALSE(keep_distance(nets, box_around(0.5 + half / 3, 0.5 - half / 4, half)));
    }
    CHECK_FALSE(keep_distance(nets));
  }
}

TEST_CASE("Kept distance: translated patches as a whole, however near they are") {
  for (const std::string gap : {"1/10", "1/1000", "-1/100000", "1/10000000", "-1/1000000000"}) {
    CAPTURE(gap);
    CHECK(keep_distance(raised(gap)));
    CHECK(keep_distance({{"u", "v", wave}, {"u + " + gap, "v", wave + " + 2*" + gap}}));
    // In parameters that a linear map changes, and in domains of which none holds the other.
    CHECK(keep_distance(raised_elsewhere("u/2 + 1/5", "u/9 + v/3 + 1/7", gap)));
    CHECK(keep_distance(raised_elsewhere("u + 3/10", "v - 1/5", gap)));
    CHECK(keep_distance({{"u", "v", "u + v/2"}, {"u + v/3", "v", "u + 5*v/6 + " + gap}}));
  }
}

TEST_CASE("Kept distance: nearly parallel patches in different parameters, cut into parts") {
  for (const std::string gap : {"1/1000", "-1/100000"}) {
    CAPTURE(gap);
    CHECK(keep_distance(raised_elsewhere("u + u*(1 - u)*v/3", "v - v*(1 - v)*u/4", gap)));
    // The gap grows.
    CHECK(keep_distance(raised(gap + " + u*" + gap)));
  }
  for (const std::string radius : {"11/10", "1001/1000", "99999/100000"}) {
    CAPTURE(radius);
    CHECK(keep_distance(spheres(radius)));
  }
  // Coaxial cylinders.
  CHECK(keep_distance({{"2*u", "1 - u^2", "v*(1 + u^2)", "1 + u^2"},
                       {"100001/100000*2*u", "100001/100000*(1 - u^2)", "v*(1 + u^2)", "1 + u^2"}}));
}

TEST_CASE("Kept distance: none of patches with points in common, whatever the parameters") {
  CHECK_FALSE(keep_distance(spheres("1")));
  CHECK_FALSE(keep_distance(raised_elsewhere("u + u*(1 - u)*v/3", "v - v*(1 - v)*u/4", "0")));
  // Only near a corner of both domains, or only in it.
  for (const std::string height :
       {"1/1000 - 1001/1000*u^3*v^3", "1/1000 - u^3*v^3/1000", "(1 - u)/100000", "(u - 1/3)^2/1000"}) {
    CAPTURE(height);
    CHECK_FALSE(keep_distance(raised(height)));
    CHECK_FALSE(keep_distance(raised_elsewhere("u + u*(1 - u)*v/3", "v - v*(1 - v)*u/4", height)));
  }
}
