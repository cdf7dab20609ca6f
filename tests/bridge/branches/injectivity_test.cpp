// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <random>

#include <support/text_patches.hpp>

#include <eliminant/bridge/branches/injectivity.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

const ParameterRectangle whole{{0, 0}, {1, 1}};

bool is_injective(const PatchText& text, const ParameterRectangle& rectangle = whole) {
  return is_injective_on(in_doubles(patch_net(text)), rectangle);
}

}  // namespace

TEST_CASE("Injectivity: proven for graphs, wherever they stand in space and with weights") {
  const std::vector<PatchText> graphs{
      {"u", "v", "0"}, {"u", "v", "u^2 + v^2"}, {"3*u + v", "v - u", "u^3*v/4"}, {"u", "v/1000", "u*v^2/2000"}};
  const std::array<std::array<long, 4>, 4> turned{{{3, 1, 0, 10}, {-1, 2, 1, 0}, {0, 1, 4, -20}, {0, 0, 0, 5}}};
  const std::array<std::array<long, 4>, 4> projective{{{9, 1, 0, 1}, {-1, 8, 1, 0}, {0, 1, 9, 2}, {1, 1, 0, 20}}};
  for (const PatchText& text : graphs) {
    CAPTURE(text.z);
    CHECK(is_injective(text));
    ExactNet net = patch_net(text);
    transform(net, turned);
    CHECK(is_injective_on(in_doubles(net), {{0.25, 0.25}, {0.75, 0.75}}));
    net = patch_net(text);
    transform(net, projective);
    CHECK(is_injective_on(in_doubles(net), {{0.25, 0.25}, {0.75, 0.75}}));
  }
}

TEST_CASE("Injectivity: not claimed of folds, edges and pinch points") {
  // A fold along u = 1/2, an edge there, and pairs far apart.
  CHECK_FALSE(is_injective({"(2*u - 1)^2", "v", "0"}));
  CHECK_FALSE(is_injective({"(2*u - 1)^2", "(2*u - 1)^3", "v"}));
  CHECK_FALSE(is_injective({"(2*u - 1)^2", "(2*u - 1)^2*(4*u - 2) - (2*u - 1)/2", "v"}));
  // Whitney's umbrella, on ever smaller rectangles around its pinch point.
  for (const double half : {0.5, 0x1p-4, 0x1p-12})
    CHECK_FALSE(is_injective({"(2*u - 1)*(2*v - 1)", "2*u - 1", "(2*v - 1)^2"},
                             {{0.5 - half, 0.5 - half}, {0.5 + half, 0.5 + half}}));
}

TEST_CASE("Injectivity: parts of a surface that meets itself") {
  // The nodal cubic (t^2 - 1, t^3 - t), t = 3 u - 3/2, meets itself at t = -1 and 1: u = 1/6 and 5/6.
  const PatchText cylinder{"(3*u - 3/2)^2 - 1", "(3*u - 3/2)^3 - (3*u - 3/2)", "v"};
  CHECK_FALSE(is_injective(cylinder));
  CHECK_FALSE(is_injective(cylinder, {{0.125, 0}, {0.875, 0.125}}));
  CHECK(is_injective(cylinder, {{0.45, 0}, {0.55, 1}}));
  CHECK(is_injective(cylinder, {{0.1, 0}, {0.2, 1}}));
}

TEST_CASE("Injectivity: never claimed where two parameters are planted at one point") {
  std::mt19937 engine(41);
  const auto draw = [&] { return std::to_string(static_cast<long>(engine() % 17) - 8); };
  // u = 1/4 and 3/4 with one v, and v = 1/8 and 7/8 with one u.
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    const bool along_u = round % 2 == 0;
    const std::string a = along_u ? "u" : "v";
    const std::string b = along_u ? "v" : "u";
    const std::string even = along_u ? "(4*u - 1)*(4*u - 3)" : "(8*v - 1)*(8*v - 7)";
    // The difference between both parameters is a multiple of b - 1/2.
    const auto coordinate = [&] {
      return "(" + draw() + " + " + draw() + "*" + a + ")*" + even + "/8 + (2*" + b + " - 1)*(" + draw() + " + " +
             draw() + "*" + a + " + " + draw() + "*" + b + ")";
    };
    const PatchText text{coordinate(), coordinate(), coordinate()};
    CAPTURE(text.x);
    CHECK_FALSE(is_injective(text));
    CHECK_FALSE(is_injective(text, along_u ? ParameterRectangle{{0.25, 0.4375}, {0.75, 0.5625}}
                                           : ParameterRectangle{{0.4375, 0.125}, {0.5625, 0.875}}));
  }
}

TEST_CASE("Injectivity: of two parts with a kink between them, at any angle but a fold") {
  // From u = 0 to 1 in a plane, from 1 to 2 in another one.
  const auto joined = [](const PatchText& first, const PatchText& second, double scale = 1) {
    const ControlNet a = in_doubles(patch_net(first));
    const ControlNet b = in_doubles(patch_net(second));
    return is_injective_on({NetOnRectangle{a, whole}, NetOnRectangle{b, whole, {scale, 1}}});
  };
  CHECK(joined({"u", "v", "u"}, {"1 + u", "v", "1 - u"}));
  CHECK(joined({"u", "v", "0"}, {"1", "v", "u"}));
  CHECK(joined({"u", "v", "u/5"}, {"1 - u", "v", "1/5 + u/5"}));
  // The second parameter runs faster, or its part is longer.
  CHECK(joined({"u", "v", "0"}, {"1", "v", "u"}, 50));
  CHECK(joined({"u", "v", "0"}, {"1", "v", "30*u"}));
  CHECK_FALSE(joined({"u", "v", "0"}, {"1 - u", "v", "0"}));
  CHECK_FALSE(joined({"u", "v", "0"}, {"1 - u/2", "v", "0"}));
  // (u, v) and (v, u) have opposite orientations.
  CHECK_FALSE(joined({"u", "v", "0"}, {"v", "u", "0"}));
}
