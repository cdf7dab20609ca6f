// SPDX-License-Identifier: BSD-3-Clause
//
// The systems of tests/data/plane_curves_systems.json, solved by PARI: see generate_plane_curves_systems.py there.
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <eliminant/symbolic/arithmetic/parse_number.hpp>
#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;
using nlohmann::json;
using symbolic::parse_number;

namespace {

const json& reference_systems() {
  static const json data = json::parse(std::ifstream(ELIMINANT_TEST_DATA "/plane_curves_systems.json"));
  return data;
}

Rational power_of_ten(long exponent) { return parse_number("1e" + std::to_string(exponent)); }

/// One real number: stored (exact with fewer than 40 digits, else correct to one unit of the last digit) or printed.
struct Number {
  Rational value;
  Rational error;
  double approximation = 0;

  Number operator-() const { return {-value, error, -approximation}; }
};

Number stored_number(const std::string& text) {
  Number result{parse_number(text), 0, std::strtod(text.c_str(), nullptr)};
  const std::size_t mantissa_end = std::min(text.find('e'), text.size());
  const std::string mantissa = text.substr(0, mantissa_end);
  const std::size_t point = mantissa.find('.');
  const auto digits = std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return '0' <= c && c <= '9'; });
  if (digits < 40) return result;
  const long exponent = mantissa_end < text.size() ? std::stol(text.substr(mantissa_end + 1)) : 0;
  const long decimals = point == std::string::npos ? 0 : static_cast<long>(mantissa.size() - point - 1);
  result.error = power_of_ten(exponent - decimals);
  return result;
}

Number printed_number(const std::string& text) { return {parse_number(text), 0, std::strtod(text.c_str(), nullptr)}; }

/// x and y as [real part, imaginary part].
struct Point {
  std::array<Number, 4> coordinates;
  unsigned long multiplicity = 1;
  bool real = true;
};

/// The stored points, with the conjugates that are not stored.
std::vector<Point> stored_points(const json& system) {
  std::vector<Point> points;
  for (const json& stored : system["points"]) {
    Point point;
    point.multiplicity = stored["multiplicity"].get<unsigned long>();
    point.real = stored["real"].get<bool>();
    for (std::size_t i = 0; i < 4; ++i)
      point.coordinates[i] = stored_number(stored[i < 2 ? "x" : "y"][i % 2].get<std::string>());
    points.push_back(point);
    if (point.real) continue;
    point.coordinates[1] = -point.coordinates[1];
    point.coordinates[3] = -point.coordinates[3];
    points.push_back(point);
  }
  return points;
}

/// |a - b| less the error of b, at least 0.
Rational proven_distance(const Number& a, const Number& b) {
  const Rational difference = a.value - b.value;
  const Rational rest = (difference < Rational(0) ? -difference : difference) - b.error;
  return rest < Rational(0) ? Rational(0) : rest;
}

struct PrintedPoint {
  std::array<Number, 4> coordinates;
  double radius_approximation = 0;
  Rational radius_squared;
};

/// True when the stored point may lie within the printed radius in both coordinates.
bool within_radius(const PrintedPoint& printed, const Point& stored) {
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = printed.coordinates[i].approximation;
    const double b = stored.coordinates[i].approximation;
    if (std::abs(a - b) > 2 * printed.radius_approximation + 1e-12 * std::abs(b)) return false;
  }
  for (std::size_t i = 0; i < 4; i += 2) {
    const Rational real = proven_distance(printed.coordinates[i], stored.coordinates[i]);
    const Rational imaginary = proven_distance(printed.coordinates[i + 1], stored.coordinates[i + 1]);
    if (printed.radius_squared < real * real + imaginary * imaginary) return false;
  }
  return true;
}

PrintedPoint printed_point(const Solution& s) {
  const Rational radius = power_of_ten(s.radius_exponent);
  return {{printed_number(s.x.real), printed_number(s.x.imaginary), printed_number(s.y.real),
           printed_number(s.y.imaginary)},
          std::pow(10.0, static_cast<double>(s.radius_exponent)),
          radius * radius};
}

/// At least `digits` significant digits of the larger coordinate.
bool has_digits(const Solution& s, const PrintedPoint& printed, long digits) {
  Rational largest = 0;
  for (const Number& number : printed.coordinates) {
    const Rational size = number.value < Rational(0) ? -number.value : number.value;
    if (largest < size) largest = size;
  }
  return largest.is_zero() || !(largest * power_of_ten(1 - digits) < power_of_ten(s.radius_exponent));
}

void check_points(const Result& result, const std::vector<Point>& stored, long digits) {
  std::vector<PrintedPoint> printed;
  for (const Solution& s : result.solutions) printed.push_back(printed_point(s));
  std::vector<int> times_matched(printed.size());
  for (const Point& point : stored) {
    CAPTURE(point.coordinates[0].approximation);
    CAPTURE(point.coordinates[1].approximation);
    CAPTURE(point.coordinates[2].approximation);
    CAPTURE(point.coordinates[3].approximation);
    int matches = 0;
    for (std::size_t i = 0; i < printed.size(); ++i) {
      if (!within_radius(printed[i], point)) continue;
      ++matches;
      ++times_matched[i];
      CHECK(result.solutions[i].multiplicity == point.multiplicity);
      CHECK(result.solutions[i].reality == (point.real ? Reality::real : Reality::non_real));
    }
    CHECK(matches == 1);
  }
  CHECK(std::all_of(times_matched.begin(), times_matched.end(), [](int times) { return times == 1; }));
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const Solution& s = result.solutions[i];
    CHECK(s.certified);
    CHECK(has_digits(s, printed[i], digits));
    if (s.reality == Reality::real) CHECK((s.x.imaginary == "0" && s.y.imaginary == "0"));
  }
}

void check_system(const json& system, const Options& options) {
  const std::string p = system["p"];
  const std::string q = system["q"];
  CAPTURE(system["name"].get<std::string>());
  CAPTURE(p);
  CAPTURE(q);
  CAPTURE(options.digits);
  const Result result = solve(p, q, options);
  if (system["status"] == "infinite") {
    CHECK(result.status == Status::infinite);
    CHECK(result.rest_status == Status::certified);
    REQUIRE(result.common_component.has_value());
    const Polynomial component = curve(system["component"].get<std::string>());
    CHECK((*result.common_component == component || *result.common_component == Rational(-1) * component));
  } else {
    CHECK(result.status == Status::certified);
    CHECK(!result.common_component.has_value());
  }
  const bool real_only = options.field == Field::real;
  if (!real_only) CHECK(audit_holds(result));
  CHECK(result.counts.distinct == system["distinct"].get<unsigned long>());
  CHECK(result.counts.real == system["real"].get<unsigned long>());
  CHECK(result.counts.with_multiplicity == system["with_multiplicity"].get<unsigned long>());
  CHECK(result.counts.at_infinity == system["at_infinity"].get<unsigned long>());
  std::vector<Point> expected = stored_points(system);
  if (real_only) std::erase_if(expected, [](const Point& point) { return !point.real; });
  CHECK(result.solutions.size() == expected.size());
  check_points(result, expected, options.digits);
}

void check_all_systems(const Options& options) {
  for (const json& system : reference_systems()) check_system(system, options);
}

}  // namespace

TEST_CASE("Reference systems: enough of them, with enough multiple points") {
  CHECK(reference_systems().size() >= 100);
  const auto has_multiple_point = [](const json& system) {
    return std::any_of(system["points"].begin(), system["points"].end(),
                       [](const json& point) { return point["multiplicity"] > 1; });
  };
  CHECK(std::count_if(reference_systems().begin(), reference_systems().end(), has_multiple_point) >= 40);
}

TEST_CASE("Reference systems: certified, all points of PARI, every digit right at 15 digits") { check_all_systems({}); }

TEST_CASE("Reference systems: certified, all points of PARI, every digit right at 50 digits") {
  Options options;
  options.digits = 50;
  check_all_systems(options);
}

TEST_CASE("Reference systems: certified, all points of PARI, every digit right at 500 digits") {
  Options options;
  options.digits = 500;
  check_all_systems(options);
}

TEST_CASE("Reference systems: the exact engine agrees, also on the real solutions alone") {
  Options options;
  options.engine = Engine::exact;
  check_all_systems(options);
  options.field = Field::real;
  options.digits = 30;
  check_all_systems(options);
}
