// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using nlohmann::json;

namespace {

/// The examples of [BuseKhalilMourrain2005], with exact expected values to 30 digits.
const json& examples() {
  static const json data = json::parse(std::ifstream(ELIMINANT_TEST_DATA "/plane_curves_examples.json"));
  return data;
}

bool close(const std::string& printed, const std::string& expected) {
  const Rational difference = symbolic::parse_number(printed) - symbolic::parse_number(expected);
  const Rational bound = symbolic::parse_number("2e-29");
  return difference < bound && -bound < difference;
}

void check_against(const Result& result, const json& expected) {
  CHECK(result.status == Status::certified);
  CHECK(audit_holds(result));
  CHECK(result.counts.at_infinity == expected["at_infinity"].get<unsigned long>());
  CHECK(result.counts.with_multiplicity == expected["with_multiplicity"].get<unsigned long>());
  CHECK(result.counts.distinct == expected["distinct"].get<unsigned long>());
  CHECK(result.counts.real == expected["real"].get<unsigned long>());
  for (const json& point : expected["points"]) {
    const auto matches = [&](const Solution& s) {
      return close(s.x.real, point["x"][0].get<std::string>()) &&
             close(s.x.imaginary, point["x"][1].get<std::string>()) &&
             close(s.y.real, point["y"][0].get<std::string>()) &&
             close(s.y.imaginary, point["y"][1].get<std::string>()) &&
             s.multiplicity == point["multiplicity"].get<unsigned long>() &&
             (s.reality == Reality::real) == point["real"].get<bool>() && s.certified;
    };
    CAPTURE(point.dump());
    CHECK(std::count_if(result.solutions.begin(), result.solutions.end(), matches) == 1);
  }
}

}  // namespace

TEST_CASE("Examples of the plane curves paper: points to 30 digits, multiplicities and counts, with both matrices") {
  for (const json& example : examples())
    for (const ResultantMatrix matrix : {ResultantMatrix::bezout, ResultantMatrix::sylvester})
      for (const int precision_bits : {0, 53, 128, 256}) {
        CAPTURE(example["name"].get<std::string>());
        CAPTURE(static_cast<int>(matrix));
        CAPTURE(precision_bits);
        Options options;
        options.digits = 31;
        options.matrix = matrix;
        options.precision_bits = precision_bits;
        check_against(solve(example["p"].get<std::string>(), example["q"].get<std::string>(), options), example);
      }
}

TEST_CASE("Examples of the plane curves paper: the pencil finds all simple points by itself") {
  for (const json& example : examples()) {
    CAPTURE(example["name"].get<std::string>());
    const Result result = solve(example["p"].get<std::string>(), example["q"].get<std::string>());
    CHECK(result.warnings.empty());
  }
}

TEST_CASE("Examples of the plane curves paper: the exact engine gives the same") {
  for (const json& example : examples()) {
    CAPTURE(example["name"].get<std::string>());
    Options options;
    options.digits = 31;
    options.engine = Engine::exact;
    check_against(solve(example["p"].get<std::string>(), example["q"].get<std::string>(), options), example);
  }
}

TEST_CASE("Examples of the plane curves paper: multiplicities do not depend on the paper's epsilon") {
  for (const json& example : examples())
    for (const double epsilon : {1e-12, 1e-6, 1e-2}) {
      CAPTURE(example["name"].get<std::string>());
      Options options;
      options.digits = 31;
      options.epsilon = epsilon;
      check_against(solve(example["p"].get<std::string>(), example["q"].get<std::string>(), options), example);
    }
}
