// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <eliminant/intersect/patches/branch_joining.hpp>
#include <eliminant/intersect/patches/surface_summary.hpp>

using namespace eliminant::intersect;

namespace {

using Parameters = std::array<double, 4>;

// Of both surfaces [0, 2] x [0, 1], with a seam where the first parameter is 1.
const DomainBounds bounds{{{{0, 2}}, {{0, 1}}, {{0, 2}}, {{0, 1}}}};

SurfacePoint point_at(const Parameters& p) { return {p, {p[0], p[1], p[2] + p[3]}}; }

SurfaceComponent piece(const std::vector<Parameters>& parameters, const std::array<int, 4>& start,
                       const std::array<int, 4>& end, double error = 1e-9) {
  SurfaceComponent component;
  for (const Parameters& p : parameters) component.points.push_back(point_at(p));
  component.start.side = start;
  component.end.side = end;
  component.error = error;
  component.certified = true;
  return component;
}

constexpr std::array<int, 4> lower_u{-1, 0, 0, 0};
constexpr std::array<int, 4> upper_u{1, 0, 0, 0};

SurfaceResult joined(std::vector<SurfaceComponent> pieces) {
  SurfaceResult result;
  result.status = Status::certified;
  result.components = std::move(pieces);
  join_branches(result, bounds);
  summarise(result);
  return result;
}

// From the border u = 0 to the seam, and from there to the border u = 2.
const SurfaceComponent left = piece({{0, 0.5, 0.25, 0.5}, {0.5, 0.5, 0.25, 0.5}, {1, 0.5, 0.5, 0.5}}, lower_u, upper_u);
const SurfaceComponent right = piece({{1, 0.5, 0.5, 0.5}, {2, 0.25, 0.75, 0.5}}, lower_u, upper_u, 3e-9);

}  // namespace

TEST_CASE("Joined branches: a curve cut by a seam is one, however its pieces are listed and turned") {
  for (const bool turn_left : {false, true})
    for (const bool turn_right : {false, true})
      for (const bool exchange : {false, true}) {
        std::vector<SurfaceComponent> pieces{left, right};
        for (std::size_t i = 0; i < 2; ++i)
          if (i == 0 ? turn_left : turn_right) {
            std::reverse(pieces[i].points.begin(), pieces[i].points.end());
            std::swap(pieces[i].start, pieces[i].end);
          }
        if (exchange) std::swap(pieces[0], pieces[1]);
        const SurfaceResult result = joined(pieces);
        CHECK(result.status == Status::certified);
        REQUIRE(result.components.size() == 1);
        const SurfaceComponent& curve = result.components[0];
        CHECK(curve.kind == SurfaceComponentKind::curve);
        CHECK(curve.certified);
        CHECK(curve.error == 3e-9);
        // The point on the seam once.
        REQUIRE(curve.points.size() == 4);
        const bool forward = curve.points.front().parameters[0] == 0;
        for (std::size_t i = 0; i < 4; ++i)
          CHECK(curve.points[forward ? i : 3 - i].parameters[0] == std::array{0.0, 0.5, 1.0, 2.0}[i]);
        CHECK((forward ? curve.start : curve.end).side == lower_u);
        CHECK((forward ? curve.end : curve.start).side == upper_u);
      }
}

TEST_CASE("Joined branches: one piece that is not certified takes that from the whole") {
  SurfaceComponent doubtful = right;
  doubtful.certified = false;
  doubtful.reason = "not proven";
  doubtful.tangential = true;
  const SurfaceResult result = joined({left, doubtful});
  REQUIRE(result.components.size() == 1);
  CHECK_FALSE(result.components[0].certified);
  CHECK(result.components[0].reason == "not proven");
  CHECK(result.components[0].tangential);
  CHECK(result.status == Status::numeric);
}

TEST_CASE("Joined branches: a closed loop of three pieces, and of one that returns to its seam") {
  const Parameters a{1, 0.25, 0.5, 0.5};
  const Parameters b{1, 0.75, 0.5, 0.5};
  const Parameters c{1, 0.5, 0.75, 0.5};
  const SurfaceResult result = joined({piece({a, {0.5, 0.5, 0.25, 0.5}, b}, upper_u, upper_u),
                                       piece({c, {1.5, 0.6, 0.5, 0.5}, b}, lower_u, lower_u),
                                       piece({a, {1.25, 0.3, 0.6, 0.5}, c}, lower_u, lower_u)});
  CHECK(result.status == Status::certified);
  REQUIRE(result.components.size() == 1);
  CHECK(result.components[0].kind == SurfaceComponentKind::loop);
  CHECK(result.components[0].points.size() == 7);
  CHECK(result.components[0].points.front().parameters == result.components[0].points.back().parameters);
  CHECK(result.counts.loops == 1);

  const SurfaceResult alone = joined({piece({a, {0.5, 0.5, 0.25, 0.5}, {0.25, 0.3, 0.5, 0.5}, a}, upper_u, upper_u)});
  CHECK(alone.counts.loops == 1);
  CHECK(alone.status == Status::certified);
}

TEST_CASE("Joined branches: ends without a continuation, or with several, are unknown and not certified") {
  const SurfaceResult lonely = joined({left});
  REQUIRE(lonely.components.size() == 1);
  CHECK_FALSE(lonely.components[0].certified);
  CHECK(lonely.components[0].reason == not_followed);
  CHECK(lonely.components[0].start.kind == BranchEndKind::border);
  CHECK(lonely.components[0].end.kind == BranchEndKind::unknown);
  // A little too far away.
  SurfaceComponent shifted = right;
  shifted.points.front().parameters[1] += 1e-8;
  CHECK(joined({left, shifted}).counts.curves == 2);
  // Three ends at one place, in any order, also two that are nearly there: none of them is joined.
  for (const double distance : {0.0, 5e-8}) {
    std::vector<SurfaceComponent> three{
        left, right, piece({{1, 0.5 + distance, 0.5, 0.5}, {1.5, 1, 0.5, 0.25}}, lower_u, {0, 1, 0, 0})};
    for (int turn = 0; turn < 3; ++turn) {
      std::rotate(three.begin(), three.begin() + 1, three.end());
      const SurfaceResult result = joined(three);
      CHECK(result.counts.curves == 3);
      for (const SurfaceComponent& curve : result.components) CHECK_FALSE(curve.certified);
    }
  }
  // Two loops through one point of the seam: which continues which is not known.
  const Parameters a{1, 0.25, 0.5, 0.5};
  const SurfaceResult two = joined({piece({a, {0.5, 0.5, 0.25, 0.5}, {0.5, 0.1, 0.5, 0.5}, a}, upper_u, upper_u),
                                    piece({a, {1.5, 0.5, 0.25, 0.5}, {1.5, 0.1, 0.5, 0.5}, a}, lower_u, lower_u)});
  CHECK(two.counts.loops == 0);
  for (const SurfaceComponent& curve : two.components) CHECK_FALSE(curve.certified);
}

TEST_CASE(
    "Joined branches: three or more ends in a common corner of pieces are a crossing, one at a contact ends there") {
  const Parameters at{1, 0.5, 0.5, 0.5};
  std::vector<SurfaceComponent> pieces;
  for (const double u : {0.0, 2.0})
    for (const double v : {0.25, 0.75})
      pieces.push_back(
          piece({{u, v, 0.25, 0.5}, at}, u < 1 ? lower_u : upper_u, {u < 1 ? 1 : -1, v < 0.5 ? 1 : -1, 0, 0}));
  const SurfaceResult four = joined(pieces);
  REQUIRE(four.singular_points.size() == 1);
  CHECK(four.singular_points[0].kind == SurfaceSingularity::crossing);
  CHECK(four.singular_points[0].half_branches == 4);
  CHECK(four.singular_points[0].certified);
  CHECK(four.counts.curves == 4);
  pieces.resize(2);
  CHECK(joined(pieces).singular_points.empty());

  SurfaceResult contact;
  contact.status = Status::certified;
  contact.components = {left};
  SurfaceSingularPoint point;
  point.kind = SurfaceSingularity::contact;
  point.at = left.points.back();
  point.certified = true;
  contact.singular_points = {point};
  join_branches(contact, bounds);
  REQUIRE(contact.components.size() == 1);
  CHECK(contact.components[0].certified);
  CHECK(contact.components[0].end.singular_point == 0U);
  CHECK(contact.singular_points[0].half_branches == 1);
}

TEST_CASE("Joined branches: a curve along a seam, found from both sides, is one with its own ends") {
  const SurfaceComponent from_left = piece({{1, 0, 0.5, 0.5}, {1, 1, 0.75, 0.5}}, {1, -1, 0, 0}, {1, 1, 0, 0});
  const SurfaceComponent from_right =
      piece({{1, 1, 0.75, 0.5}, {1, 0.5, 0.625, 0.5}, {1, 0, 0.5, 0.5}}, {-1, 1, 0, 0}, {-1, -1, 0, 0});
  const SurfaceResult result = joined({from_left, from_right});
  CHECK(result.status == Status::certified);
  REQUIRE(result.components.size() == 1);
  CHECK(result.components[0].kind == SurfaceComponentKind::curve);
  CHECK(result.components[0].start.side == std::array{0, -1, 0, 0});
  CHECK(result.components[0].end.side == std::array{0, 1, 0, 0});
  // Two curves with the same ends that are not along the seam are a loop.
  CHECK(joined({piece({{1, 0.25, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}, {1, 0.75, 0.5, 0.5}}, upper_u, upper_u),
                piece({{1, 0.25, 0.5, 0.5}, {1.5, 0.5, 0.5, 0.5}, {1, 0.75, 0.5, 0.5}}, lower_u, lower_u)})
            .counts.loops == 1);
  // Along the border v = 0 over the seam.
  const SurfaceResult along = joined({piece({{0, 0, 0.5, 0.5}, {1, 0, 0.6, 0.5}}, {-1, -1, 0, 0}, {1, -1, 0, 0}),
                                      piece({{1, 0, 0.6, 0.5}, {2, 0, 0.7, 0.5}}, {-1, -1, 0, 0}, {1, -1, 0, 0})});
  CHECK(along.status == Status::certified);
  REQUIRE(along.components.size() == 1);
  CHECK(along.components[0].points.size() == 3);
}

TEST_CASE("Joined branches: a point found on several pieces is one, and none where a curve passes or ends") {
  const auto point = [](const Parameters& at, const std::array<int, 4>& side) {
    SurfaceComponent result = piece({at}, side, side);
    result.kind = SurfaceComponentKind::point;
    return result;
  };
  const SurfaceComponent on_seam = point({1, 0.25, 0.5, 0.25}, upper_u);
  const SurfaceComponent other_side = point({1, 0.25, 0.5, 0.25}, lower_u);
  const SurfaceComponent on_border = point({0, 0.25, 0.5, 0.5}, lower_u);
  const SurfaceComponent inside = point({0.5, 0.25, 0.5, 0.5}, {});
  CHECK(joined({on_seam, other_side, on_border, inside}).counts.points == 3);
  // The curve passes the seam in one of these points, begins in another, and has one on its way.
  const SurfaceComponent where_it_passes = point({1, 0.5, 0.5, 0.5}, {0, 1, 0, 0});
  const SurfaceComponent where_it_begins = point({0, 0.5, 0.25, 0.5}, lower_u);
  const SurfaceComponent on_its_way = point({0.25, 0.5, 0.25, 0.5}, {0, 1, 0, 0});
  const SurfaceResult result = joined({left, where_it_passes, on_seam, where_it_begins, right, on_its_way});
  CHECK(result.counts.curves == 1);
  CHECK(result.counts.points == 1);
  CHECK(result.status == Status::certified);
}

TEST_CASE("Mirror images: of two one is kept, a curve that is its own image is marked") {
  SurfaceResult result;
  const std::vector<Parameters> curve{{0.1, 0.2, 0.8, 0.9}, {0.2, 0.2, 0.8, 0.8}, {0.3, 0.2, 0.8, 0.7}};
  std::vector<Parameters> image;
  for (const Parameters& p : curve) image.push_back({p[2], p[3], p[0], p[1]});
  result.components.push_back(piece(curve, {}, {}));
  result.components.push_back(piece({{0.2, 0.5, 0.6, 0.5}, {0.4, 0.5, 0.4, 0.5}, {0.6, 0.5, 0.2, 0.5}}, {}, {}));
  result.components.push_back(piece({image.rbegin(), image.rend()}, {}, {}));
  result.components.push_back(piece({{0.7, 0.1, 0.7, 0.9}, {0.7, 0.2, 0.7, 0.8}, {0.7, 0.3, 0.7, 0.7}}, {}, {}));
  remove_mirror_images(result, bounds);
  REQUIRE(result.components.size() == 3);
  CHECK(result.components[0].points[0].parameters == curve[0]);
  CHECK_FALSE(result.components[0].mirrored);
  CHECK(result.components[0].certified);
  CHECK(result.components[1].mirrored);
  CHECK(result.components[1].certified);
  // The last one has no image.
  CHECK_FALSE(result.components[2].certified);
  CHECK_FALSE(result.components[2].reason.empty());
}

TEST_CASE("Appended results: singular points keep their curves, the worse status counts, warnings once") {
  SurfaceResult all;
  all.status = Status::certified;
  all.warnings = {"one"};
  all.singular_points.resize(2);
  SurfaceResult part;
  part.status = Status::numeric;
  part.warnings = {"one", "two"};
  part.singular_points.resize(1);
  part.components.push_back(left);
  part.components[0].end.singular_point = 0;
  append(all, part);
  CHECK(all.status == Status::numeric);
  CHECK(all.warnings == std::vector<std::string>{"one", "two"});
  CHECK(all.singular_points.size() == 3);
  CHECK(all.components[0].end.singular_point == 2);
  CHECK_FALSE(all.components[0].start.singular_point.has_value());
}
