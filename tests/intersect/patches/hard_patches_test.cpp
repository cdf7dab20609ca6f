// SPDX-License-Identifier: BSD-3-Clause
//
// Patches of which nothing was proven once: drawn as those of the families are, from other seeds. Their numbers are
// those of exact elimination.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <eliminant/intersect/patches/patch_pair.hpp>
#include <support/patch_nets.hpp>

using namespace eliminant;
using intersect::SurfaceResult;

namespace {

test::ControlNet net_of(const nlohmann::json& rows) {
  test::ControlNet net;
  for (const auto& row : rows) {
    test::ControlPolygon& points = net.emplace_back();
    for (const auto& p : row) points.push_back({p[0], p[1], p[2], 1});
  }
  return net;
}

SurfaceResult solve(const test::ControlNet& first, const test::ControlNet& second) {
  intersect::Options options;
  options.tolerance = 1e-6;
  if (second.empty()) return intersect::intersect_patch_with_itself(test::surface_piece(first), options, Context());
  return intersect::intersect_patches(test::surface_piece(first), test::surface_piece(second), options, Context());
}

}  // namespace

TEST_CASE("Hard patches: every component is proven") {
  std::ifstream file(std::string(ELIMINANT_TEST_DATA) + "/hard_patches.json");
  REQUIRE(file);
  for (const auto& patches : nlohmann::json::parse(file)) {
    INFO(patches["name"].get<std::string>());
    const test::ControlNet first = net_of(patches["first"]);
    const test::ControlNet second = net_of(patches.value("second", nlohmann::json::array()));
    for (const bool exchanged : {false, true}) {
      INFO("u and v exchanged: ", exchanged);
      const SurfaceResult result = solve(exchanged ? test::parameters_exchanged(first) : first, second);
      CHECK(result.status == intersect::Status::certified);
      CHECK(result.singular_points.size() == patches["singular_points"].get<std::size_t>());
      CHECK(result.components.size() == patches["curves"].get<std::size_t>());
      CHECK(std::all_of(result.components.begin(), result.components.end(), [](const auto& component) {
        return component.kind == intersect::SurfaceComponentKind::curve && component.certified;
      }));
    }
  }
}
