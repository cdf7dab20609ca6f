// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <cmath>

#include <support/branch_graphs.hpp>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>

using namespace eliminant;
using namespace eliminant::bridge;
using namespace eliminant::test;

namespace {

const PatchText ground{"u", "v", "0"};

/// Both points at every crossing point are one, as far as its radius goes, and the ends of arcs are in their boxes.
void check_points(const NetPair& nets, const BranchGraph& graph, double speed) {
  PatchJets first(nets.first);
  PatchJets second(nets.second);
  for (const CrossingPoint& point : graph.points) {
    const auto& [u, v, s, t] = point.parameters;
    const Array4d gap = first.at(u, v).point - second.at(s, t).point;
    CHECK(gap.head<3>().abs().maxCoeff() <= speed * point.radius + 1e-13);
  }
  for (const CellArc& arc : graph.arcs)
    for (const std::size_t end : {arc.from, arc.to}) {
      const CrossingPoint& point = graph.points[end];
      bool inside = true;
      for (std::size_t k = 0; k < 4; ++k)
        inside = inside && point.parameters[k] >= arc.box.lower[k] - point.radius &&
                 point.parameters[k] <= arc.box.upper[k] + point.radius;
      CHECK(inside);
    }
}

void check_curves(const NetPair& nets, const CurveCount& expected) {
  const BranchGraph graph = branch_graph(nets);
  CHECK(graph.complete);
  CHECK(graph.open.empty());
  CHECK(graph.contacts.empty());
  const CurveCount found = count_curves(graph);
  CHECK(found.open == expected.open);
  CHECK(found.closed == expected.closed);
  check_points(nets, graph, 64);
}

struct Planted {
  std::string height;
  CurveCount count;
};

/// With u and v for each other.
std::string exchanged(std::string text) {
  for (char& c : text) c = c == 'u' ? 'v' : c == 'v' ? 'u' : c;
  return text;
}

// Over the unit square, against z = 0.
const std::vector<Planted> planted{
    {"u - 1/3", {1, 0}},
    {"u + 2*v - 1", {1, 0}},
    {"(u - 1/2)*(v - 1/2) - 1/64", {2, 0}},
    {"(u - 1/2)^2 - (v - 1/2)^2/2 + 1/100", {2, 0}},
    {"(u - 1/2)^2 + (v - 1/2)^2 - 1/9", {0, 1}},
    {"(u - 1/3)^2 + 2*(v - 5/8)^2 - 1/1000000", {0, 1}},
    {"u^2 + v^2 - 1/4", {1, 0}},
    {"(u - 1/2)^2 + (v - 1/2)^2 - 5/16", {4, 0}},
    {"((u - 1/4)^2 + (v - 1/2)^2 - 1/25)*((u - 3/4)^2 + (v - 1/2)^2 - 1/25)*4", {0, 2}},
    {"((u - 1/2)^2 + (v - 1/2)^2 - 1/25)*((u - 1/2)^2 + (v - 1/2)^2 - 1/9)*4", {0, 2}},
    {"((u - 1/2)^2 + (v - 1/2)^2 - 1/25)*(u - 1/8)", {1, 1}},
    {"(u - 1/4)*(u - 1/2)*(u - 3/4)", {3, 0}},
    {"(u - 1/2)*(u - 21/40)", {2, 0}},
    {"(u - 1/2)^2 + (v - 1/2)^2 + 1/1000000", {0, 0}},
    {"(u - 1/2)^2 + 1/1000000", {0, 0}},
    {"1 + u*v", {0, 0}},
};

}  // namespace

TEST_CASE("Branch subdivision: as many arcs and loops as were planted, every point on both patches") {
  for (const Planted& curves : planted) {
    const std::string& height = curves.height;
    const CurveCount& count = curves.count;
    CAPTURE(height);
    check_curves(NetPair(ground, {"u", "v", height}), count);
    // The difference is what matters, not which of them is flat.
    check_curves(NetPair({"u", "v", "u^2 - u*v + v^3/2"}, {"u", "v", "u^2 - u*v + v^3/2 + (" + height + ")"}), count);
  }
}

TEST_CASE("Branch subdivision: exchange of the patches and of parameters, and maps of space change no count") {
  const std::array<std::array<long, 4>, 4> affine{{{3, 1, 0, 100}, {-1, 2, 1, 0}, {0, 1, 4, -2}, {0, 0, 0, 5}}};
  const std::array<std::array<long, 4>, 4> projective{{{9, 1, 0, 1}, {-1, 8, 1, 0}, {0, 1, 9, 2}, {1, 1, 0, 20}}};
  for (const Planted& curves : planted) {
    const std::string& height = curves.height;
    const CurveCount& count = curves.count;
    CAPTURE(height);
    check_curves(NetPair({"u", "v", height}, ground), count);
    check_curves(NetPair({"v", "u", exchanged(height)}, ground), count);
    for (const auto& map : {affine, projective}) {
      ExactNet a = patch_net(ground);
      ExactNet b = patch_net({"u", "v", height});
      transform(a, map);
      transform(b, map);
      check_curves(NetPair(a, b), count);
    }
  }
}

TEST_CASE("Branch subdivision: four arcs meet in a proven contact, a touching point is a contact of its own") {
  for (const std::string height : {"(u - 1/2)*(v - 1/2)", "(u - v)*(u + v - 1)", "(u - 1/3)^2 + (v - 1/4)^2"}) {
    const std::size_t arcs = height == "(u - 1/3)^2 + (v - 1/4)^2" ? 0 : 4;
    CAPTURE(height);
    const NetPair nets(ground, {"u", "v", height});
    const SurfaceContactProver prover(nets.first, nets.second, nets.exact_first, nets.exact_second);
    const BranchGraph graph = branch_graph(nets, &prover);
    CHECK(graph.complete);
    CHECK(graph.open.empty());
    REQUIRE(graph.contacts.size() == 1);
    const CellContact& contact = graph.contacts[0];
    CHECK(contact.around.crossing == (arcs == 4));
    CHECK(static_cast<std::size_t>(std::count_if(graph.arcs.begin(), graph.arcs.end(), [&](const CellArc& arc) {
            return arc.contact.has_value() && arc.to == contact.point;
          })) == arcs);
    // Without a prover the place is left open.
    const BranchGraph unproven = branch_graph(nets);
    CHECK(unproven.contacts.empty());
    REQUIRE_FALSE(unproven.open.empty());
    for (const CellBox& box : unproven.open)
      for (std::size_t k = 0; k < 4; ++k) {
        CHECK(box.lower[k] <= contact.contact.rounded[k] + 1e-3);
        CHECK(box.upper[k] >= contact.contact.rounded[k] - 1e-3);
      }
  }
}

TEST_CASE("Branch subdivision: one patch twice is left open, and limits end it") {
  const PatchText bent{"u", "v", "u^2 - u*v"};
  const NetPair twice(bent, bent);
  const Context context;
  const BranchGraph graph = branch_subdivision(twice.first, twice.second, {}, {}, nullptr, {}, context);
  CHECK_FALSE(graph.open.empty());
  CHECK(graph.arcs.empty());

  const NetPair close(ground, {"u", "v", "(u - 1/2)*(u - 501/1000)"});
  BranchLimits limits;
  limits.most_cells = 500;
  const BranchGraph cut_short = branch_graph(close, nullptr, limits);
  CHECK_FALSE(cut_short.complete);
  CHECK(cut_short.cells <= 501);
  Context cancelled;
  cancelled.cancel();
  CHECK_THROWS_AS(branch_subdivision(close.first, close.second, {}, {}, nullptr, {}, cancelled), LimitReached);
}
