// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include <support/curves.hpp>
#include <support/patch_families.hpp>
#include <support/patch_fibres.hpp>
#include <support/patch_nets.hpp>
#include <support/patch_oracle.hpp>
#include <support/patch_sampling.hpp>
#include <support/self_patch_families.hpp>
#include <support/space_distances.hpp>

// What the tests of patches are compared with, tested itself.

using namespace eliminant;
using symbolic::Polynomial;
using symbolic::Rational;
using test::distance;
using test::PatchCase;
using test::PatchCounts;
using test::TrueComponent;
using test::TrueIntersection;

namespace {

PatchCounts counts_in_unit_square(const char* equation) {
  return test::plane_intersection({test::curve(equation), {{0, 1}, {0, 1}}}).counts;
}

/// z = f over z = g, both of bidegree (3, 3).
PatchCase graphs(const char* f, const char* g) {
  const auto net = [](const char* height) {
    return test::control_net(test::affine_patch(test::curve("x"), test::curve("y"), test::curve(height)), 3, 3);
  };
  test::RationalNet first = net(f);
  test::RationalNet second = net(g);
  test::make_binary(first, second);
  return {"graphs", 0, test::in_doubles(first), test::in_doubles(second), {}};
}

std::size_t crossings_of(const TrueIntersection& intersection, double u) {
  std::size_t count = 0;
  for (const TrueComponent& component : intersection.components)
    for (std::size_t k = 0; k + 1 < component.parameters.size(); ++k)
      if ((component.parameters[k][0] < u) != (component.parameters[k + 1][0] < u)) ++count;
  return count;
}

}  // namespace

TEST_CASE("Patch oracle: known plane curves have the known numbers of arcs, loops and points") {
  CHECK(counts_in_unit_square("(x - 1/2)^2 + (y - 1/2)^2 - 1/16") == PatchCounts{0, 1, 0, 0});
  CHECK(counts_in_unit_square("(x - 1/2)^2 + (y - 1/2)^2 - 9/25") == PatchCounts{4, 0, 0, 0});
  CHECK(counts_in_unit_square("x^2 + y^2 - 1/4") == PatchCounts{1, 0, 0, 0});
  CHECK(counts_in_unit_square("x^2 + y^2 - 3") == PatchCounts{0, 0, 0, 0});
  CHECK(counts_in_unit_square("(x - 1/2)^2 - (y - 1/2)^2 - 1/64") == PatchCounts{2, 0, 0, 0});
  CHECK(counts_in_unit_square("(x - 1/2)^2 - (y - 1/3)^2") == PatchCounts{4, 0, 0, 1});
  CHECK(counts_in_unit_square("(x - 1/2)^2 + (y - 1/3)^2") == PatchCounts{0, 0, 1, 1});
  CHECK(counts_in_unit_square("((x - 1/2)^2 + (y - 1/2)^2 - 1/16)^2") == PatchCounts{0, 1, 0, 0});
  // A lemniscate: two arcs from its node to itself.
  CHECK(counts_in_unit_square("((2*x - 1)^2 + (2*y - 1)^2)^2 - 1/2*(2*x - 1)^2 + 1/2*(2*y - 1)^2") ==
        PatchCounts{2, 0, 0, 1});
  CHECK(counts_in_unit_square("(y - 1/2)^2 - (x - 1/2)^3") == PatchCounts{2, 0, 0, 1});
  CHECK(counts_in_unit_square("x + y") == PatchCounts{0, 0, 1, 0});
  CHECK(counts_in_unit_square("x*(1 + y)") == PatchCounts{1, 0, 0, 0});
}

TEST_CASE("Patch oracle: graphs are recognised in any coordinates, and substituted") {
  const PatchCase circle = graphs("(x - 1/2)^2 + (y - 1/2)^2", "1/16");
  CHECK(test::true_intersection(circle).counts == PatchCounts{0, 1, 0, 0});
  CHECK(test::true_intersection(test::exchanged(circle)).counts == PatchCounts{0, 1, 0, 0});
  CHECK(test::true_intersection(graphs("x^2 - 2*y^2 + x*y", "x^2 + x*y - 1/2")).counts == PatchCounts{1, 0, 0, 0});
  // A saddle and a plane through its centre, and beside it.
  CHECK(test::true_intersection(graphs("(x - 1/2)*(y - 1/2)", "0")).counts == PatchCounts{4, 0, 0, 1});
  CHECK(test::true_intersection(graphs("(x - 1/2)*(y - 1/2)", "1/1000000")).counts == PatchCounts{2, 0, 0, 0});
  CHECK(test::true_intersection(graphs("x", "y + 2")).counts == PatchCounts{0, 0, 0, 0});
  for (const PatchCase& patches : test::patch_cases("random biquadratic"))
    CHECK_FALSE(test::substituted_in_graph(patches));
}

TEST_CASE("Patch oracle: what is planted in a family is there") {
  const std::map<std::string, PatchCounts> planted{{"loop of diameter 1e-1", {0, 1, 0, 0}},
                                                   {"loop of diameter 1e-2", {0, 1, 0, 0}},
                                                   {"loop of diameter 1e-3", {0, 1, 0, 0}},
                                                   {"loop of diameter 1e-4", {0, 1, 0, 0}},
                                                   {"gap of 1e-1", {0, 0, 0, 0}},
                                                   {"gap of 1e-5", {0, 0, 0, 0}},
                                                   {"contact in a point", {0, 0, 1, 1}},
                                                   {"rational contact in a point", {0, 0, 1, 1}},
                                                   {"crossing contact", {4, 0, 0, 1}},
                                                   {"rational crossing contact", {4, 0, 0, 1}},
                                                   {"cusp", {2, 0, 0, 1}},
                                                   {"touching in a corner", {0, 0, 1, 0}},
                                                   {"meeting along an edge", {1, 0, 0, 0}},
                                                   {"touching an edge", {0, 0, 1, 0}},
                                                   {"through a corner", {1, 0, 0, 0}},
                                                   {"beside each other, crossing", {0, 0, 1, 0}},
                                                   {"beside each other, with a common edge", {1, 0, 0, 0}},
                                                   {"skew loop", {0, 1, 0, 0}},
                                                   {"skew gap", {0, 0, 0, 0}},
                                                   {"skew contact in a point", {0, 0, 1, 1}},
                                                   {"skew crossing contact", {4, 0, 0, 1}},
                                                   {"skew branches and loops", {6, 2, 0, 0}}};
  for (const auto& entry : planted) {
    const std::string& family = entry.first;
    CAPTURE(family);
    const std::vector<PatchCase> cases = test::patch_cases(family);
    CHECK(cases.size() >= 4);
    for (const PatchCase& patches : cases) {
      CAPTURE(patches.index);
      REQUIRE(test::substituted_in_graph(patches));
      CHECK(test::true_intersection(patches).counts == entry.second);
    }
  }
  const std::array<PatchCounts, 3> along{{{1, 0, 0, 0}, {4, 0, 0, 1}, {0, 1, 0, 0}}};
  for (const PatchCase& patches : test::patch_cases("contact along a curve"))
    CHECK(test::true_intersection(patches).counts == along[patches.index % 3]);
  // The boards of Chebyshev polynomials without much noise.
  CHECK(test::true_intersection(test::patch_cases("branches and loops, degree 3")[0]).counts ==
        PatchCounts{6, 2, 0, 0});
  CHECK(test::true_intersection(test::patch_cases("branches and loops, degree 5")[0]).counts ==
        PatchCounts{10, 8, 0, 0});
}

TEST_CASE("Patch oracle: there are 300 cases and more, the same ones at every run") {
  const std::vector<PatchCase> all = test::patch_cases();
  CHECK(all.size() >= 300);
  const std::vector<PatchCase> alone = test::patch_cases("loop of diameter 1e-3");
  std::size_t seen = 0;
  for (const PatchCase& patches : all)
    if (patches.family == alone.front().family) {
      CHECK(patches.first == alone[patches.index].first);
      CHECK(patches.second == alone[patches.index].second);
      ++seen;
    }
  CHECK(seen == alone.size());
}

TEST_CASE("Patch oracle: the components lie on both patches") {
  for (const std::string family : {"branches and loops, degree 3", "loop of diameter 1e-4", "crossing contact"}) {
    CAPTURE(family);
    for (const PatchCase& patches : test::patch_cases(family)) {
      // Not mixed, over the same square.
      if (patches.index % 2 != 0 || patches.index % 5 == 4) continue;
      for (const TrueComponent& component : test::true_intersection(patches).components)
        for (const auto& [u, v] : component.parameters)
          CHECK(distance(test::patch_point(patches.first, u, v), test::patch_point(patches.second, u, v)) < 1e-12);
    }
  }
}

TEST_CASE("Patch oracle: dense sampling sees what substitution proves") {
  for (const std::string family :
       {"branches and loops, degree 3", "biquadratic over a graph", "loop of diameter 1e-1"}) {
    CAPTURE(family);
    for (const PatchCase& patches : test::patch_cases(family)) {
      if (patches.index >= 8 || patches.index % 2 != 0) continue;
      CAPTURE(patches.index);
      CHECK(test::sampled_intersection(patches, 128).counts == test::true_intersection(patches).counts);
    }
  }
}

TEST_CASE("Patch oracle: sampling has the points of elimination above single parameters") {
  std::size_t compared = 0;
  for (const std::string family : {"random bicubic", "random biquadratic", "random rational bicubic"}) {
    CAPTURE(family);
    for (const PatchCase& patches : test::patch_cases(family)) {
      if (patches.index >= 2) break;
      CAPTURE(patches.index);
      const TrueIntersection sampled = test::true_intersection(patches);
      const test::PatchFibres fibres(patches);
      for (long k = 1; k < 16; ++k) {
        const auto fibre = fibres.at(Rational(k) / Rational(17));
        REQUIRE(fibre);
        // Both may err at a turning point or a border.
        if (fibre->unclear > 0) continue;
        CHECK(crossings_of(sampled, static_cast<double>(k) / 17) == fibre->points.size());
        ++compared;
      }
    }
  }
  CHECK(compared >= 80);
}

TEST_CASE("Patch oracle: a fibre agrees with polylines that cross it as often, nearby") {
  const std::vector<std::vector<std::array<double, 4>>> polylines{{{0, 0.2, 0.3, 0.4}, {1, 0.4, 0.3, 0.4}},
                                                                  {{0.4, 0.9, 0.9, 0.9}, {0.6, 0.8, 0.8, 0.8}}};
  test::PatchFibres::Fibre fibre;
  fibre.points = {{0.5, 0.3, 0.3, 0.4}, {0.5, 0.85, 0.85, 0.85}};
  CHECK(test::agrees_with_fibre(polylines, 0.5, fibre, 0.01));
  CHECK_FALSE(test::agrees_with_fibre(polylines, 0.3, fibre, 0.01));
  fibre.points.pop_back();
  CHECK_FALSE(test::agrees_with_fibre(polylines, 0.5, fibre, 0.01));
  fibre.unclear = 1;
  CHECK(test::agrees_with_fibre(polylines, 0.5, fibre, 0.01));
  fibre.unclear = 0;
  fibre.points.push_back({0.5, 0.5, 0.85, 0.85});
  CHECK_FALSE(test::agrees_with_fibre(polylines, 0.5, fibre, 0.01));
}

TEST_CASE("Patch oracle: double curves are those planted, and both preimages have one point") {
  const std::map<std::string, std::vector<PatchCounts>> planted{
      {"double curve from edge to edge", {{1, 0, 0, 0}}},
      {"double curve with pinch points", {{1, 0, 0, 1}, {1, 0, 0, 2}, {2, 0, 0, 2}}},
      {"closed double curve", {{0, 1, 0, 0}}},
      {"triple point", {{3, 0, 0, 4}}}};
  std::size_t meeting = 0;
  std::size_t embedded = 0;
  for (const test::SelfPatchCase& patch : test::self_patch_cases()) {
    CAPTURE(patch.patches.family);
    CAPTURE(patch.patches.index);
    const TrueIntersection truth = test::true_self_intersection(patch);
    const auto expected = planted.find(patch.patches.family);
    if (expected == planted.end()) {
      ++embedded;
      CHECK(truth.counts == PatchCounts{});
    } else {
      ++meeting;
      CHECK(truth.counts == expected->second[patch.patches.index % expected->second.size()]);
    }
    if (!patch.sheets) continue;
    for (const TrueComponent& component : truth.components)
      for (const auto& on_half : component.parameters) {
        const auto [u, v, s, t] = patch.sheets->parameters(on_half);
        for (const double parameter : {u, v, s, t}) CHECK((parameter > -1e-12 && parameter < 1 + 1e-12));
        CHECK(distance(test::patch_point(patch.patches.first, u, v), test::patch_point(patch.patches.first, s, t)) <
              1e-12);
      }
  }
  CHECK(meeting == 20);
  CHECK(embedded == 20);
}
