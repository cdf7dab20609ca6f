// SPDX-License-Identifier: BSD-3-Clause
//
// The systems of tests/data/local_multiplicities.txt: dimensions of local rings from Singular, see
// generate_local_multiplicities.py there.
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <doctest/doctest.h>

#include <support/plane_curves.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using namespace eliminant::test;

namespace {

struct MultiplePoint {
  unsigned long multiplicity = 0;
  /// Re x, Im x, Re y, Im y to 12 digits.
  std::array<double, 4> coordinates{};
};

struct LocalMultiplicities {
  std::string p;
  std::string q;
  /// Multiplicity -> number of solutions.
  std::map<unsigned long, unsigned long> numbers;
  std::vector<MultiplePoint> multiple_points;
};

/// p ; q ; 1x5 2x1 ; 2@x_re,x_im,y_re,y_im
LocalMultiplicities parse_line(const std::string& line) {
  std::array<std::string, 4> fields;
  std::istringstream fields_of_line(line);
  for (std::string& field : fields) std::getline(fields_of_line, field, ';');
  LocalMultiplicities system{fields[0], fields[1], {}, {}};
  std::istringstream numbers(fields[2]);
  char separator = 0;
  for (unsigned long multiplicity = 0, number = 0; numbers >> multiplicity >> separator >> number;)
    system.numbers[multiplicity] = number;
  std::istringstream points(fields[3]);
  for (MultiplePoint point; points >> point.multiplicity;) {
    for (double& coordinate : point.coordinates) points >> separator >> coordinate;
    REQUIRE(points);
    system.multiple_points.push_back(point);
  }
  return system;
}

const std::vector<LocalMultiplicities>& systems_with_local_multiplicities() {
  static const std::vector<LocalMultiplicities> systems = [] {
    std::vector<LocalMultiplicities> result;
    std::ifstream file(ELIMINANT_TEST_DATA "/local_multiplicities.txt");
    for (std::string line; std::getline(file, line);) result.push_back(parse_line(line));
    return result;
  }();
  return systems;
}

bool lies_at(const Solution& s, const std::array<double, 4>& place) {
  const std::array<const std::string*, 4> printed{&s.x.real, &s.x.imaginary, &s.y.real, &s.y.imaginary};
  for (std::size_t i = 0; i < 4; ++i)
    if (std::abs(std::strtod(printed[i]->c_str(), nullptr) - place[i]) > 1e-10 * (1 + std::abs(place[i]))) return false;
  return true;
}

void check_system(const LocalMultiplicities& system, const Options& options) {
  CAPTURE(system.p);
  CAPTURE(system.q);
  const Result result = solve(system.p, system.q, options);
  CHECK(result.status == Status::certified);
  CHECK(audit_holds(result));
  std::map<unsigned long, unsigned long> numbers;
  for (const Solution& s : result.solutions) ++numbers[s.multiplicity];
  CHECK(numbers == system.numbers);
  for (const MultiplePoint& point : system.multiple_points) {
    CAPTURE(point.coordinates[0]);
    CAPTURE(point.coordinates[1]);
    CAPTURE(point.coordinates[2]);
    CAPTURE(point.coordinates[3]);
    CHECK(std::count_if(result.solutions.begin(), result.solutions.end(), [&](const Solution& s) {
            return lies_at(s, point.coordinates) && s.multiplicity == point.multiplicity;
          }) == 1);
  }
}

}  // namespace

TEST_CASE("Local multiplicities: 2000 systems, 1350 with a multiple point, 100 and more with non-rational ones") {
  const auto& systems = systems_with_local_multiplicities();
  CHECK(systems.size() == 2000);
  CHECK(std::count_if(systems.begin(), systems.end(),
                      [](const LocalMultiplicities& system) { return !system.multiple_points.empty(); }) == 1350);
  CHECK(std::count_if(systems.begin(), systems.end(), [](const LocalMultiplicities& system) {
          return std::any_of(system.multiple_points.begin(), system.multiple_points.end(),
                             [](const MultiplePoint& point) {
                               // Rational points of such small systems have small denominators.
                               const double x = 5040 * point.coordinates[0];
                               const double y = 5040 * point.coordinates[2];
                               return std::abs(x - std::round(x)) > 1e-3 || std::abs(y - std::round(y)) > 1e-3 ||
                                      point.coordinates[1] != 0 || point.coordinates[3] != 0;
                             });
        }) >= 100);
}

TEST_CASE("Local multiplicities: those of Singular, by the automatic engine") {
  for (const LocalMultiplicities& system : systems_with_local_multiplicities()) check_system(system, {});
}

TEST_CASE("Local multiplicities: those of Singular, by the exact engine") {
  Options options;
  options.engine = Engine::exact;
  for (const LocalMultiplicities& system : systems_with_local_multiplicities()) check_system(system, options);
}
