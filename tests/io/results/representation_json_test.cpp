// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <eliminant/base/error.hpp>
#include <eliminant/io/results/representation_json.hpp>
#include <support/representation_data.hpp>

using namespace eliminant;
using namespace eliminant::io;
using namespace eliminant::test;
using intersect::SurfaceRepresentation;
using nlohmann::json;

namespace {

/// The text of the saddle with one part replaced.
std::string changed(const std::string& part, const std::string& by) {
  const SurfaceRepresentation saddle(surface_map({"s", "t"}, {"s", "t", "s*t", "1"}));
  std::string text = representation_json(saddle);
  const std::size_t position = text.find(part);
  REQUIRE(position != std::string::npos);
  return text.replace(position, part.size(), by);
}

void check_refused(const std::string& text, const std::string& message) {
  CAPTURE(text);
  try {
    read_representation(text);
    FAIL_CHECK("not refused");
  } catch (const InvalidInput& error) {
    CAPTURE(error.what());
    CHECK(std::string(error.what()).find(message) != std::string::npos);
    CHECK(error.place().line > 0);
  }
}

}  // namespace

TEST_CASE("representation as JSON: what is read is exactly what was written") {
  for (const json& entry : representation_data().at("surfaces")) {
    CAPTURE(entry.at("name").get<std::string>());
    const SurfaceRepresentation written(surface_of(entry));
    const std::string text = representation_json(written);
    const SurfaceRepresentation read = read_representation(text);
    CHECK(read.surface().kind() == written.surface().kind());
    CHECK(read.surface().coordinates() == written.surface().coordinates());
    CHECK(read.matrix().row_monomials == written.matrix().row_monomials);
    CHECK(read.matrix().coefficients == written.matrix().coefficients);
    CHECK(read.degree().product == written.degree().product);
    CHECK(read.degree().map_degree == written.degree().map_degree);
    CHECK(read.degree().minors == written.degree().minors);
    CHECK(read.degree().proven == written.degree().proven);
    CHECK(representation_json(read) == text);
  }
}

TEST_CASE("representation as JSON: the text of a saddle") {
  const SurfaceRepresentation saddle(surface_map({"s", "t"}, {"s", "t", "s*t", "1"}));
  const json text = json::parse(representation_json(saddle));
  CHECK(text.at("format") == 1);
  CHECK(text.at("representation") == "surface");
  CHECK(text.at("parameters") == json{"s", "t"});
  CHECK(text.at("z") == "s*t");
  CHECK(text.at("row_monomials") == json{"1", "t", "s", "s*t"});
  CHECK(text.at("matrix").size() == 4);
  CHECK(text.at("product") == 2);
  CHECK(text.at("map_degree") == 1);
  CHECK(text.at("minors") == 2);
}

TEST_CASE("representation as JSON: what is none is refused with its place") {
  check_refused("[]", "the representation is an array");
  check_refused(changed("\"format\": 1", "\"format\": 2"), "\"format\"");
  check_refused(changed("\"surface\"", "\"curve\""), "a representation of \"curve\"");
  check_refused(changed("[\"s\", \"t\"]", "[\"s\"]"), "\"parameters\" has 1 names");
  check_refused(changed("\"s*t\"", "\"s*t + 1\""), "is no moving plane");
  check_refused(changed("\"x\": \"s\"", "\"x\": \"u\""), "x: ");
  check_refused(changed("\"z\": \"s*t\"", "\"z\": \"s*t\", \"v\": 1"), "unknown field \"v\"");
  check_refused(changed("[\"1\", \"t\", ", "[\"1\", \"2*t\", "), "a row monomial is none");
  check_refused(changed("[\"1\", \"t\", ", "[\"t\", \"t\", "), "its rows do not belong to all monomials");
  check_refused(changed("[\"1\", \"t\", ", "[\"t\", "), "\"matrix\" has 4 rows");
  check_refused(changed("\"product\": 2", "\"product\": 0"), "\"product\"");
  check_refused(changed("\"minors\": 2", "\"minors\": \"two\""), "\"minors\"");
  check_refused(changed("\"0\"", "\"1\""), "an entry of the matrix is no linear form");
  check_refused(changed("\"0\"", "\"x*y\""), "an entry of the matrix is no linear form");
  check_refused(changed("\"0\"", "\"x/2\""), "an entry of the matrix is no linear form");
  check_refused(changed("\"0\"", "\"x\""), "is no moving plane");
  check_refused(changed("\"0\", ", ""), "a row of the matrix has");
}
