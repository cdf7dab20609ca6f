// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include <random>

#include <support/text_patches.hpp>

#include <eliminant/bridge/branches/surface_cell.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

/// Both patches as one cell.
struct Pair {
  ControlNet first;
  ControlNet second;
  SurfaceCell cell;

  Pair(const ExactNet& a, const ExactNet& b) : first(in_doubles(a)), second(in_doubles(b)) {
    put(cell.first, first);
    put(cell.second, second);
  }
  Pair(const PatchText& a, const PatchText& b) : Pair(patch_net(a), patch_net(b)) {}
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;

 private:
  static void put(Side<2>& side, ControlNet& net) {
    side.shape.degree = {net.degrees[0], net.degrees[1]};
    side.polynomial = net.polynomial;
    side.points = net.points.data();
    side.error = net.error;
    REQUIRE(bound(side));
  }
};

const PatchText ground{"u", "v", "0"};
const std::array<std::array<long, 4>, 4> projective{{{9, 1, 0, 1}, {-1, 8, 1, 0}, {0, 1, 9, 2}, {1, 1, 0, 20}}};

}  // namespace

TEST_CASE("Surface cell: patches apart, and those that only a tilted plane separates") {
  CHECK(Pair(ground, {"u", "v", "1/1000000"}).cell.apart());
  Pair tilted({"u", "v", "3*u - 2*v"}, {"u", "v", "3*u - 2*v + 1/1000"});
  CHECK_FALSE(tilted.cell.apart());
  CHECK(tilted.cell.examine().excluded);
  ExactNet a = patch_net({"u", "v", "3*u - 2*v + u^2/9000"});
  ExactNet b = patch_net({"u", "v", "3*u - 2*v - v^2/9000 - 1/1000"});
  CHECK(Pair(a, b).cell.examine().excluded);
  transform(a, projective);
  transform(b, projective);
  CHECK_FALSE(Pair(a, b).cell.apart());
  CHECK(Pair(a, b).cell.examine().excluded);
}

TEST_CASE("Surface cell: a transversal arc is regular, in any position and with weights") {
  for (const PatchText& text : {PatchText{"u", "v", "u - 1/2"}, PatchText{"u", "1/2", "v - 1/2"},
                                PatchText{"u", "v", "u - 1/2 + v^2/4"}, PatchText{"u", "v", "u + v - 1 + u*v/8"}}) {
    CAPTURE(text.z);
    ExactNet a = patch_net(ground);
    ExactNet b = patch_net(text);
    for (const bool moved : {false, true}) {
      if (moved) transform(a, projective);
      if (moved) transform(b, projective);
      const CellVerdict verdict = Pair(a, b).cell.examine();
      CHECK_FALSE(verdict.excluded);
      CHECK(verdict.regular);
      CHECK_FALSE(verdict.nearly_parallel);
    }
  }
}

TEST_CASE("Surface cell: loops, crossing arcs, two arcs and coincidence are not regular") {
  for (const std::string height : {"(u - 1/2)^2 + (v - 1/2)^2 - 1/9", "(u - 1/2)*(v - 1/2)", "(u - 1/4)*(u - 3/4)", "0",
                                   "(u - 1/2)^3 + v^2 - v/2"}) {
    CAPTURE(height);
    const CellVerdict verdict = Pair(ground, {"u", "v", height}).cell.examine();
    CHECK_FALSE(verdict.excluded);
    CHECK_FALSE(verdict.regular);
  }
  CHECK(Pair(ground, ground).cell.examine().nearly_parallel);
  CHECK(Pair(ground, {"u", "v", "(u - 1/2)*(v - 1/2)"}).cell.examine().nearly_parallel);
}

TEST_CASE("Surface cell: a planted point is never excluded, a planted contact never regular") {
  std::mt19937 engine(42);
  const auto draw = [&] { return std::to_string(static_cast<long>(engine() % 9) - 4); };
  unsigned transversal = 0;
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    const std::string u0 = std::to_string(engine() % 17) + "/16";
    const std::string v0 = std::to_string(engine() % 17) + "/16";
    const std::string p = "(u - " + u0 + ")";
    const std::string q = "(v - " + v0 + ")";
    const std::string height = "(" + draw() + "*u^2 + " + draw() + "*v^3 + " + draw() + "*u*v)/16";
    const std::string square =
        "(" + draw() + "*" + p + "^2 + " + draw() + "*" + p + "*" + q + " + " + draw() + "*" + q + "^2*u)/16";
    const std::string slope = "(" + draw() + "*" + p + " + " + draw() + "*" + q + ")";
    ExactNet first = patch_net({"u", "v", height});
    ExactNet touching = patch_net({"u", "v", height + " + " + square});
    ExactNet crossing = patch_net({"u", "v", height + " + " + slope + " + " + square});
    if (round % 2 == 1)
      for (ExactNet* net : {&first, &touching, &crossing}) transform(*net, projective);
    const CellVerdict contact = Pair(first, touching).cell.examine();
    CHECK_FALSE(Pair(first, touching).cell.apart());
    CHECK_FALSE(contact.excluded);
    CHECK_FALSE(contact.regular);
    CHECK_FALSE(Pair(first, crossing).cell.apart());
    const CellVerdict verdict = Pair(first, crossing).cell.examine();
    CHECK_FALSE(verdict.excluded);
    if (verdict.regular) ++transversal;
  }
  CHECK(transversal > 100);
}

TEST_CASE("Surface cell: spreads are the largest lengths of lines of control points, in one coordinate") {
  const auto widest = [](const SurfaceCell& cell) {
    const std::array<double, 4> spreads = cell.spreads();
    return std::max_element(spreads.begin(), spreads.end()) - spreads.begin();
  };
  CHECK(widest(Pair({"4*u", "v", "0"}, {"u", "2*v", "u"}).cell) == 0);
  CHECK(widest(Pair({"u", "5*v", "0"}, {"3*u", "v", "u"}).cell) == 1);
  CHECK(widest(Pair({"u", "v", "0"}, {"v", "2*v", "7*u"}).cell) == 2);
  CHECK(widest(Pair({"u", "v", "0"}, {"u", "2*u", "7*v"}).cell) == 3);
  // There and back again counts.
  CHECK(widest(Pair({"u", "v", "0"}, {"u", "2*v", "16*v*(1 - v)"}).cell) == 3);
}
