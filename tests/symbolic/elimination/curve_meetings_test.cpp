// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/symbolic/elimination/curve_meetings.hpp>

using namespace eliminant::symbolic;

namespace {

const PrimeField field(PrimeSequence(5).next());

/// Small integers for the coefficient vectors, the weight first.
ModularSpaceCurve curve_of(const std::vector<std::array<long, 4>>& coefficients) {
  ModularSpaceCurve result;
  for (const std::array<long, 4>& vector : coefficients) {
    result.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) result.back()[k] = field.reduce(vector[k]);
  }
  return result;
}

CurveMeetings meetings(const ModularSpaceCurve& a, const ModularSpaceCurve& c, std::uint64_t projection = 1,
                       const std::optional<TrivialPair>& trivial = std::nullopt) {
  return curve_meetings(a, c, trivial, field, 7, projection);
}

const ModularSpaceCurve cubic = curve_of({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});  // (1, v, v^2, v^3)

}  // namespace

TEST_CASE("curve meetings: a twisted cubic and its chords, tangents and other lines") {
  // Through v = 1 and v = 2.
  const CurveMeetings chord = meetings(cubic, curve_of({{1, 1, 1, 1}, {0, 1, 3, 7}}));
  CHECK(chord.finite == 2);
  CHECK(chord.at_infinity == 0);
  CHECK(chord.images.size() == 3);
  CHECK(chord.parameters == std::vector<mp_limb_t>{2, field.reduce(-3L), 1});  // (v - 1)(v - 2)
  CHECK_FALSE(chord.infinite);
  CHECK(meetings(cubic, curve_of({{1, 1, 1, 1}, {0, 1, 2, 3}})).finite == 1);  // the tangent at v = 1
  CHECK(meetings(cubic, curve_of({{1, 5, 0, 1}, {0, 1, 3, 8}})).finite == 0);
  // The line through v = 0 and the point at infinity of the cubic.
  const CurveMeetings parallel = meetings(cubic, curve_of({{1, 0, 0, 0}, {0, 0, 0, 1}}));
  CHECK(parallel.finite == 1);
  CHECK(parallel.at_infinity == 1);
  CHECK(meetings(cubic, cubic).infinite);
}

TEST_CASE("curve meetings: base points are divided out, also at infinity") {
  // (1 + v^2) times a line, and a line declared of degree 2.
  const ModularSpaceCurve line = curve_of({{1, 0, 0, 0}, {0, 1, 0, 0}});
  const ModularSpaceCurve multiplied = curve_of({{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}});
  const ModularSpaceCurve declared = curve_of({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}});
  const ModularSpaceCurve other = curve_of({{1, 3, 0, 0}, {0, 0, 1, 2}});
  CHECK_FALSE(meetings(line, other).first_has_base_point);
  for (const ModularSpaceCurve& curve : {multiplied, declared}) {
    const CurveMeetings seen = meetings(curve, other);
    CHECK(seen.first_has_base_point);
    CHECK_FALSE(seen.second_has_base_point);
    CHECK(seen.finite == 1);
    CHECK(meetings(other, curve).second_has_base_point);
    CHECK(meetings(other, curve).finite == 1);
  }
}

TEST_CASE("curve meetings: curves that are points") {
  const ModularSpaceCurve point = curve_of({{2, 4, 8, 16}, {1, 2, 4, 8}});  // (2 + v) times a point of the cubic
  CHECK(meetings(point, cubic).finite == 1);
  CHECK(meetings(cubic, point).finite == 1);
  const ModularSpaceCurve elsewhere = curve_of({{1, 2, 4, 9}, {1, 2, 4, 9}});
  CHECK(meetings(elsewhere, cubic).finite == 0);
  CHECK(meetings(elsewhere, point).finite == 0);
  CHECK(meetings(point, point).infinite);
}

TEST_CASE("curve meetings: the trivial pair does not count, others with one of its parameters do") {
  // A plane nodal cubic x = v^2 - 1, y = v (v^2 - 1): v = 1 and v = -1 give the origin.
  const ModularSpaceCurve nodal = curve_of({{1, -1, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}});
  const ModularSpaceCurve line = curve_of({{1, 0, 0, 0}, {0, 0, 0, 1}});  // the z axis, at the origin for s = 0
  const TrivialPair trivial{field.reduce(1L), 0};
  const CurveMeetings seen = meetings(nodal, line, 1, trivial);
  CHECK(seen.finite == 1);
  CHECK(meetings(nodal, line).finite == 2);
  CHECK(meetings(line, nodal, 1, TrivialPair{0, field.reduce(1L)}).finite == 1);
  const ModularSpaceCurve through = curve_of({{1, -1, 0, 0}, {0, 1, 0, 0}});  // y = z = 0, the origin for s = 1
  CHECK(meetings(line, through, 1, TrivialPair{0, field.reduce(1L)}).finite == 0);
}

TEST_CASE("curve meetings: the images of common points do not depend on the parameters") {
  const ModularSpaceCurve chord = curve_of({{1, 1, 1, 1}, {0, 1, 3, 7}});
  const ModularSpaceCurve faster = curve_of({{1, 1, 1, 1}, {0, 2, 6, 14}});
  CHECK(meetings(cubic, chord).images == meetings(cubic, faster).images);
  CHECK(meetings(cubic, chord).images == meetings(chord, cubic).images);
  CHECK(meetings(cubic, chord, 1).images != meetings(cubic, chord, 2).images);
}
