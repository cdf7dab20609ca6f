// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curve_surface/surface_representation.hpp>
#include <eliminant/symbolic/matrices/rational_preimages.hpp>
#include <support/curves.hpp>
#include <support/representation_data.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using nlohmann::json;
using symbolic::Integer;

namespace {

using Point = std::vector<Rational>;

std::array<double, 4> rounded(const Point& point) {
  std::array<double, 4> result{};
  for (std::size_t k = 0; k < 4; ++k) result[k] = fmpq_get_d(point[k].get());
  return result;
}

/// s and t of a tensor product, s / u and t / u of a triangular surface.
std::array<std::complex<double>, 2> affine(const std::vector<std::complex<double>>& parameters) {
  if (parameters.size() == 3) return {parameters[0] / parameters[2], parameters[1] / parameters[2]};
  return {parameters[0] / parameters[1], parameters[2] / parameters[3]};
}

Rational fraction(long numerator, long denominator) { return {Integer(numerator), Integer(denominator)}; }

}  // namespace

TEST_CASE("surface representation: points of each reference surface and points beside it") {
  Random random(41);
  for (const json& entry : representation_data().at("surfaces")) {
    CAPTURE(entry.at("name").get<std::string>());
    const symbolic::RationalSurface phi = surface_of(entry);
    const SurfaceRepresentation representation(phi);
    const long sheets = entry.at("map_degree");
    CHECK(representation.degree().product == entry.at("product_of_degrees"));
    for (int sample = 0; sample < 4; ++sample) {
      const Rational s = fraction(random.nonzero(12), random.between(1, 5));
      const Rational t = fraction(random.nonzero(12), random.between(1, 5));
      const bool triangular = phi.kind() == symbolic::RationalSurface::Kind::triangular;
      const Point point = phi.at(triangular ? Point{s, t, 1} : Point{s, t});
      const Membership on = representation.membership(point);
      CHECK(on.on_surface);
      CHECK(on.kernel_dimension == sheets);
      CHECK(static_cast<long>(on.preimages.size()) == sheets);
      std::vector<RationalParameter> expected{s, t};
      if (triangular) expected.emplace_back(1);
      CHECK(std::find(on.preimages.begin(), on.preimages.end(), expected) != on.preimages.end());
      const ApproximateMembership approximate = representation.approx_membership(rounded(point), 1e-9);
      CAPTURE(approximate.relative_singular_value);
      CHECK(approximate.relative_singular_value < 1e-12);
      CHECK(approximate.kernel_dimension == sheets);
      REQUIRE(!approximate.preimages.empty());
      double nearest = 1;
      for (const auto& parameters : approximate.preimages) {
        const auto [a, b] = affine(parameters);
        nearest = std::min(nearest, std::abs(a - fmpq_get_d(s.get())) + std::abs(b - fmpq_get_d(t.get())));
      }
      CHECK(nearest < 1e-4);
      // Beside it.
      Point moved = point;
      for (Rational& coordinate : moved) coordinate = coordinate + fraction(random.nonzero(50), 7);
      const Membership off = representation.membership(moved);
      CHECK_FALSE(off.on_surface);
      CHECK(off.kernel_dimension == 0);
      CHECK(off.preimages.empty());
    }
  }
}

TEST_CASE("surface representation: a point of an extraneous plane is not on the surface") {
  const SurfaceRepresentation representation(reference_surface("cubic_almost_ci"));
  CHECK(representation.degree().minors == representation.degree().product + 1);
  const auto plane = surface_entry("cubic_almost_ci").at("extraneous_plane").get<std::vector<long>>();
  const Membership found = representation.membership({plane[1], -plane[0], plane[3], -plane[2]});
  CHECK(found.kernel_dimension == 1);
  CHECK_FALSE(found.on_surface);
  CHECK(found.preimages.empty());
}

TEST_CASE("surface representation: points that the map does not reach, or reaches along a curve") {
  // The embedded point (1 : 0 : 0 : -1) of Example 3 is the image of the line s = 0 through both base points.
  const SurfaceRepresentation sphere(reference_surface("sphere_quadratic"));
  const Membership embedded = sphere.membership({1, 0, 0, -1});
  CHECK(embedded.on_surface);
  CHECK(embedded.kernel_dimension == 2);
  // No preimages are listed where there are infinitely many.
  CHECK(embedded.preimages.empty());
  const Membership simple = sphere.membership({1, 0, 0, 1});
  CHECK(simple.on_surface);
  CHECK(simple.preimages == std::vector<std::vector<RationalParameter>>{{1, 0, 0}});
  // The torus at s = infinity, t = infinity.
  const symbolic::RationalSurface torus_map = reference_surface("torus_2_1");
  const SurfaceRepresentation torus(torus_map);
  const Membership infinite = torus.membership(symbolic::image_of(torus_map, {1, 0, 1, 0}));
  CHECK(infinite.on_surface);
  CHECK(infinite.preimages == std::vector<std::vector<RationalParameter>>{{std::nullopt, std::nullopt}});
}

TEST_CASE("surface representation: bilinear surfaces and planes have matrices that tell both parameters") {
  const SurfaceRepresentation bilinear(reference_surface("bilinear"));
  CHECK(bilinear.matrix().rows() == 4);
  const SurfaceRepresentation plane(surface_map({"s", "t", "u"}, {"s", "t", "u", "s+t+u"}));
  CHECK(plane.matrix().rows() == 3);
  const Membership found = plane.membership({1, 2, 3, 6});
  CHECK(found.preimages == std::vector<std::vector<RationalParameter>>{{fraction(1, 3), fraction(2, 3), 1}});
  CHECK_FALSE(plane.membership({1, 2, 3, 7}).on_surface);
}

TEST_CASE("surface representation: double precision follows the distance") {
  const SurfaceRepresentation torus(reference_surface("torus_2_1"));
  double previous = 0;
  for (const double distance : {1e-12, 1e-7, 1e-5, 1e-3}) {
    const ApproximateMembership near = torus.approx_membership({3 + distance, 0, 0, 1});
    CAPTURE(distance);
    CHECK(near.relative_singular_value > previous);
    CHECK(near.relative_singular_value < 10 * distance);
    CHECK(near.kernel_dimension == (distance < 1e-10 ? 1 : 0));
    CHECK(near.preimages.size() == static_cast<std::size_t>(near.kernel_dimension));
    previous = near.relative_singular_value;
  }
  CHECK(torus.approx_membership({3e200, 0, 0, 1e200}).kernel_dimension == 1);
  CHECK(torus.approx_membership({3e-200, 0, 0, 1e-200}).kernel_dimension == 1);
}

TEST_CASE("surface representation: parts that do not belong together are refused") {
  const SurfaceRepresentation torus(reference_surface("torus_2_1"));
  const SurfaceRepresentation again(torus.surface(), torus.matrix(), torus.degree());
  CHECK(again.membership({3, 0, 0, 1}).on_surface);
  CHECK_THROWS_AS(SurfaceRepresentation(reference_surface("sphere_lonlat_biquadratic"), torus.matrix(), torus.degree()),
                  InvalidInput);
  const auto changed = [&](auto change) {
    symbolic::MatrixRepresentation m = torus.matrix();
    change(m);
    CHECK_THROWS_AS(SurfaceRepresentation(torus.surface(), m, torus.degree()), InvalidInput);
  };
  changed([](auto& m) { fmpz_add_ui(m.coefficients[2].entry(0, 0), m.coefficients[2].entry(0, 0), 1); });
  changed([](auto& m) { m.row_monomials.pop_back(); });
  changed([](auto& m) { m.row_monomials[1] = m.row_monomials[0]; });
  changed([](auto& m) { m.coefficients.pop_back(); });
  changed([](auto& m) {
    for (auto& coefficients : m.coefficients)
      for (long i = 0; i < coefficients.rows(); ++i) fmpz_set(coefficients.entry(i, 1), coefficients.entry(i, 0));
  });
}

TEST_CASE("surface representation: what is no point or no tolerance is refused") {
  const SurfaceRepresentation torus(reference_surface("torus_2_1"));
  CHECK_THROWS_AS(torus.membership({0, 0, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(torus.membership({1, 2, 3}), InvalidInput);
  CHECK_THROWS_AS(torus.approx_membership({0, 0, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(torus.approx_membership({1, std::nan(""), 0, 0}), InvalidInput);
  CHECK_THROWS_AS(torus.approx_membership({1, 0, 0, std::numeric_limits<double>::infinity()}), InvalidInput);
  CHECK_THROWS_AS(torus.approx_membership({1, 0, 0, 1}, 0), InvalidInput);
  CHECK_THROWS_AS(torus.approx_membership({1, 0, 0, 1}, 2), InvalidInput);
}
