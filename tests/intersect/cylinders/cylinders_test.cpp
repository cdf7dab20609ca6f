// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <complex>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <eliminant/intersect/cylinders/cylinders.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>

using namespace eliminant;
using namespace eliminant::intersect;
using symbolic::parse_number;
using symbolic::Rational;
using symbolic::SpacePoint;
using Points = std::array<SpacePoint, 5>;

namespace {

CylindersResult cylinders(const Points& points, long digits = 15, Field field = Field::automatic) {
  Options options;
  options.digits = digits;
  options.field = field;
  return cylinders_through({points}, options, Context());
}

const Points special{{{0, 0, 0},
                      {1, 1, 0},
                      {1, 0, 1},
                      {0, 1, 1},
                      {Rational(4) / Rational(3), Rational(-1) / Rational(3), Rational(-1) / Rational(3)}}};

Rational magnitude(const Rational& x) { return x.sign() < 0 ? -x : x; }

/// The numbers of a solution as printed, for exact comparison.
std::vector<std::string> printed(const CylinderSolution& solution) {
  std::vector<std::string> words;
  for (const auto* vector : {&solution.direction, &solution.axis_point})
    for (const Coordinate& coordinate : *vector) words.insert(words.end(), {coordinate.real, coordinate.imaginary});
  words.insert(words.end(), {solution.radius_squared.real, solution.radius_squared.imaginary});
  words.push_back(solution.radius ? solution.radius->real : "-");
  words.push_back(std::to_string(solution.multiplicity));
  return words;
}

std::vector<std::vector<std::string>> printed(const CylindersResult& result) {
  std::vector<std::vector<std::string>> lines;
  for (const CylinderSolution& solution : result.solutions) lines.push_back(printed(solution));
  return lines;
}

struct RandomSet {
  unsigned long real = 0;
  Points points;
};

std::vector<RandomSet> random_sets() {
  std::ifstream file(ELIMINANT_TEST_DATA "/cylinders/random_points.txt");
  std::vector<RandomSet> sets;
  for (RandomSet set; file >> set.real;) {
    for (SpacePoint& point : set.points)
      for (Rational& coordinate : point) {
        long value = 0;
        file >> value;
        coordinate = value;
      }
    sets.push_back(set);
  }
  return sets;
}

/// Every sum of the audit, and that everything listed is certified.
void check_audit(const CylindersResult& result) {
  CHECK(result.status == Status::certified);
  CHECK(result.counts.with_multiplicity + result.counts.isotropic == result.counts.bezout_number);
  unsigned long listed = 0;
  for (const CylinderSolution& solution : result.solutions) {
    CHECK(solution.certified);
    listed += solution.multiplicity;
  }
  CHECK(listed == result.counts.with_multiplicity);
  CHECK(result.solutions.size() == result.counts.distinct);
}

}  // namespace

TEST_CASE("Cylinders: the special five points have six real ones of radius squared 27/50") {
  const CylindersResult result = cylinders(special, 40);
  check_audit(result);
  CHECK(result.counts.real == 6);
  CHECK(result.counts.distinct == 6);
  std::vector<std::array<long, 3>> expected{{0, 2, 1}, {0, 1, 2}, {2, 0, -1}, {2, -1, 0}, {-1, 2, 0}, {-1, 0, 2}};
  for (const CylinderSolution& solution : result.solutions) {
    CHECK(solution.radius_squared.real == "0.54");
    CHECK(solution.radius_squared.imaginary == "0");
    CHECK(solution.multiplicity == 1);
    CHECK(solution.reality == Reality::real);
    REQUIRE(solution.radius);
    CHECK(solution.radius->real.starts_with("0.73484692283495342945918"));
    // The printed direction over 5^(-1/2) is the integer one: compared by cross products.
    const auto found = std::find_if(expected.begin(), expected.end(), [&](const std::array<long, 3>& t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const Rational minor = parse_number(solution.direction[i].real) * Rational(t[j]) -
                               parse_number(solution.direction[j].real) * Rational(t[i]);
        if (!(magnitude(minor) < parse_number("1e-38"))) return false;
      }
      return true;
    });
    REQUIRE(found != expected.end());
    expected.erase(found);
  }
}

TEST_CASE("Cylinders: the 1000 random sets have the real counts known, in any order of the points") {
  const std::vector<RandomSet> sets = random_sets();
  REQUIRE(sets.size() == 1000);
  std::map<unsigned long, int> histogram;
  for (std::size_t n = 0; n < sets.size(); ++n) {
    const Points& p = sets[n].points;
    const CylindersResult result = cylinders(p);
    CAPTURE(n);
    check_audit(result);
    CHECK(result.counts.distinct == 6);
    CHECK(result.counts.real == sets[n].real);
    ++histogram[result.counts.real];
    if (n % 4 == 0) CHECK(printed(cylinders({{p[3], p[1], p[4], p[0], p[2]}})) == printed(result));
  }
  CHECK(histogram == std::map<unsigned long, int>{{0, 213}, {2, 543}, {4, 225}, {6, 19}});
}

TEST_CASE("Cylinders: the first 50 sets to 30 digits") {
  std::ifstream file(ELIMINANT_TEST_DATA "/cylinders/first_50.json");
  const nlohmann::json sets = nlohmann::json::parse(file);
  REQUIRE(sets.size() == 50);
  for (const auto& set : sets) {
    Points points;
    for (std::size_t k = 0; k < 5; ++k)
      for (std::size_t i = 0; i < 3; ++i) points[k][i] = Rational(set["points"][k][i].get<long>());
    const CylindersResult result = cylinders(points, 30, Field::real);
    CHECK(result.status == Status::certified);
    CHECK(result.counts.real == set["real_count"].get<unsigned long>());
    REQUIRE(result.solutions.size() == set["real"].size());
    for (const auto& expected : set["real"]) {
      const auto near = [](const Rational& a, const nlohmann::json& b, const char* error) {
        return magnitude(a - parse_number(b.get<std::string>())) < parse_number(error);
      };
      const auto found =
          std::find_if(result.solutions.begin(), result.solutions.end(), [&](const CylinderSolution& solution) {
            for (std::size_t i = 0; i < 3; ++i)
              if (!near(parse_number(solution.direction[i].real), expected["direction"][i], "2e-30")) return false;
            return true;
          });
      REQUIRE(found != result.solutions.end());
      CHECK(
          near(parse_number(found->radius->real) / parse_number(expected["radius"].get<std::string>()), "1", "1e-28"));
      // The foot from the origin: a - (a.t) t.
      Rational along(0);
      for (std::size_t i = 0; i < 3; ++i)
        along = along + parse_number(found->axis_point[i].real) * parse_number(found->direction[i].real);
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(near(parse_number(found->axis_point[i].real) - along * parse_number(found->direction[i].real),
                   expected["axis_foot_from_origin"][i], "1e-24"));
    }
    // Of the others x/z and y/z.
    const CylindersResult all = cylinders(points, 30);
    CHECK(all.counts.distinct == all.counts.real + set["nonreal_l_over_n_m_over_n"].size());
    const auto complex_of = [](const Coordinate& c) {
      return std::complex<double>(std::stod(c.real), std::stod(c.imaginary));
    };
    for (const auto& ratios : set["nonreal_l_over_n_m_over_n"]) {
      const auto part = [&ratios](std::size_t k) { return std::stod(ratios[k].get<std::string>()); };
      const std::complex<double> x(part(0), part(1));
      const std::complex<double> y(part(2), part(3));
      CHECK(std::any_of(all.solutions.begin(), all.solutions.end(), [&](const CylinderSolution& solution) {
        const std::complex<double> z = complex_of(solution.direction[2]);
        return solution.reality == Reality::non_real && std::abs(complex_of(solution.direction[0]) - x * z) < 1e-13 &&
               std::abs(complex_of(solution.direction[1]) - y * z) < 1e-13;
      }));
    }
  }
}

TEST_CASE("Cylinders: degenerate positions have the counts that follow from the geometry") {
  struct Position {
    const char* name;
    Points points;
    unsigned long distinct, real, with_multiplicity, isotropic, bezout_number;
  };
  const std::vector<Position> positions{
      {"two points on a ruling", {{{3, 4, 0}, {3, 4, 7}, {5, 0, 1}, {-4, 3, 2}, {0, -5, -3}}}, 6, 4, 6, 0, 6},
      {"two pairs on rulings", {{{3, 4, 0}, {3, 4, 7}, {5, 0, 1}, {5, 0, 9}, {0, -5, -3}}}, 6, 2, 6, 0, 6},
      {"three on a line", {{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 1, 2}, {1, 5, 7}}}, 5, 1, 6, 0, 6},
      {"four in a plane", {{{0, 0, 0}, {1, 0, 0}, {3, 1, 0}, {0, 1, 0}, {1, 5, 7}}}, 6, 2, 6, 0, 6},
      {"square pyramid", {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}, 6, 6, 6, 0, 6},
      {"ellipse", {{{5, 0, 0}, {-5, 0, 0}, {0, 3, 0}, {0, -3, 0}, {3, Rational(12) / Rational(5), 0}}}, 4, 2, 4, 0, 4},
      {"circle", {{{5, 0, 0}, {-5, 0, 0}, {0, 5, 0}, {0, -5, 0}, {3, 4, 0}}}, 1, 1, 4, 0, 4},
      {"crossing lines", {{{0, 1, 0}, {0, 2, 0}, {0, 5, 0}, {1, 0, 0}, {3, 0, 0}}}, 4, 0, 4, 0, 4},
      {"parabola", {{{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}, {2, 4, 0}, {3, 9, 0}}}, 0, 0, 0, 0, 0},
      {"tetrahedron and its centre", {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {0, 0, 0}}}, 0, 0, 0, 6, 6},
      {"some isotropic", {{{0, -1, 1}, {1, 1, 1}, {0, 1, 0}, {0, 0, 1}, {-1, 1, 1}}}, 4, 0, 4, 2, 6},
      {"some isotropic, some real", {{{0, 1, 0}, {0, 1, 1}, {-1, 1, -1}, {0, 0, -1}, {0, -1, -1}}}, 4, 2, 4, 2, 6},
      {"multiple", {{{0, 1, -1}, {0, -1, -1}, {-1, 0, 0}, {-1, 0, 1}, {1, 0, -1}}}, 2, 2, 6, 0, 6},
  };
  for (const Position& position : positions) {
    CAPTURE(position.name);
    const CylindersResult result = cylinders(position.points);
    check_audit(result);
    CHECK(result.counts.distinct == position.distinct);
    CHECK(result.counts.real == position.real);
    CHECK(result.counts.with_multiplicity == position.with_multiplicity);
    CHECK(result.counts.isotropic == position.isotropic);
    CHECK(result.counts.bezout_number == position.bezout_number);
    const Points& p = position.points;
    CHECK(printed(cylinders({{p[4], p[2], p[0], p[3], p[1]}})) == printed(result));
  }
}

TEST_CASE("Cylinders: an ellipse is on two real ones as wide as its minor axis") {
  const CylindersResult result =
      cylinders({{{5, 0, 0}, {-5, 0, 0}, {0, 3, 0}, {0, -3, 0}, {3, Rational(12) / Rational(5), 0}}}, 15, Field::real);
  REQUIRE(result.solutions.size() == 2);
  CHECK(result.counts.distinct == 4);
  CHECK(printed(result.solutions[0]) == std::vector<std::string>{"0.8", "0", "0", "0", "-0.6", "0", "0.384", "0", "0",
                                                                 "0", "-0.288", "0", "9", "0", "3", "1"});
  CHECK(printed(result.solutions[1]) == std::vector<std::string>{"0.8", "0", "0", "0", "0.6", "0", "0.384", "0", "0",
                                                                 "0", "0.288", "0", "9", "0", "3", "1"});
}

TEST_CASE("Cylinders: a triple of points on a ruling makes its direction double") {
  const CylindersResult result = cylinders({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 1, 2}, {1, 5, 7}}}, 15, Field::real);
  REQUIRE(result.solutions.size() == 1);
  CHECK(result.solutions[0].multiplicity == 2);
  CHECK(result.solutions[0].direction[0].real == "1");
}

TEST_CASE("Cylinders: infinitely many through repeated, collinear and other special points") {
  const auto infinite = [](const Points& points) {
    const CylindersResult result = cylinders(points);
    CHECK(result.status == Status::infinite);
    CHECK(result.solutions.empty());
    CHECK(result.degeneracy);
    return result.directions.has_value();
  };
  CHECK(!infinite({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}));
  CHECK(!infinite({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}}}));
  CHECK(!infinite({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 1, 0}, {5, 1, 0}}}));
  CHECK(!infinite({{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {7, 0, 0}, {5, 1, 1}}}));
  CHECK(infinite({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}}));
  CHECK(infinite({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 5, 0}, {0, 0, 0}}}));
}

TEST_CASE("Cylinders: planted ones are found exactly") {
  std::mt19937 generator(7);
  const auto small = [&generator] { return Rational(static_cast<long>(generator() % 19) - 9); };
  for (int round = 0; round < 60; ++round) {
    // Columns of a rational rotation: two axes across the cylinder and the direction.
    const Rational a = small() + Rational(20);
    const Rational b = small();
    const Rational c = small();
    const Rational d = small();
    const Rational n = a * a + b * b + c * c + d * d;
    const Rational two(2);
    const SpacePoint across{(a * a + b * b - c * c - d * d) / n, two * (b * c + a * d) / n, two * (b * d - a * c) / n};
    const SpacePoint other{two * (b * c - a * d) / n, (a * a - b * b + c * c - d * d) / n, two * (c * d + a * b) / n};
    const SpacePoint direction = symbolic::cross_product(across, other);
    const Rational radius = small() + Rational(10);
    const SpacePoint centre{small(), small(), small()};
    Points points;
    for (std::size_t k = 0; k < 5; ++k) {
      // Different points of the circle, by its rational parametrisation; every third round two points share a ruling.
      const std::size_t place = round % 3 == 0 && k == 4 ? 3 : k;
      const Rational s = Rational(static_cast<long>(3 * place) - 5) / Rational(static_cast<long>(place) + 2);
      const Rational cosine = (Rational(1) - s * s) / (Rational(1) + s * s);
      const Rational sine = two * s / (Rational(1) + s * s);
      const Rational height = small() + Rational(static_cast<long>(40 * k));
      for (std::size_t i = 0; i < 3; ++i)
        points[k][i] = centre[i] + radius * (cosine * across[i] + sine * other[i]) + height * direction[i];
    }
    const CylindersResult result = cylinders(points, 20);
    check_audit(result);
    bool found = false;
    for (const CylinderSolution& solution : result.solutions) {
      if (solution.reality != Reality::real) continue;
      const Rational radius_error = parse_number(solution.radius->real) - radius;
      Rational largest(0);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const Rational minor = parse_number(solution.direction[i].real) * direction[j] -
                               parse_number(solution.direction[j].real) * direction[i];
        if (largest < magnitude(minor)) largest = magnitude(minor);
      }
      found = found || (magnitude(radius_error) < parse_number("1e-17") && largest < parse_number("1e-19"));
    }
    CAPTURE(round);
    CHECK(found);
  }
}

TEST_CASE("Cylinders: huge, tiny and far-off coordinates") {
  const CylindersResult plain = cylinders(special, 20);
  for (const char* scale_text : {"1e300", "1e-300", "1e-2000", "7e9"}) {
    const Rational scale = parse_number(scale_text);
    Points points = special;
    for (SpacePoint& point : points)
      for (Rational& coordinate : point) coordinate = coordinate * scale;
    const CylindersResult result = cylinders(points, 20);
    check_audit(result);
    REQUIRE(result.solutions.size() == 6);
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(parse_number(result.solutions[k].radius_squared.real) == parse_number("0.54") * scale * scale);
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(result.solutions[k].direction[i].real == plain.solutions[k].direction[i].real);
    }
  }
  Points moved = special;
  for (SpacePoint& point : moved)
    for (Rational& coordinate : point) coordinate = coordinate + parse_number("1e12");
  const CylindersResult result = cylinders(moved, 20);
  check_audit(result);
  for (const CylinderSolution& solution : result.solutions) CHECK(solution.radius_squared.real == "0.54");
}

TEST_CASE("Cylinders: directions that look the same get digits until they do not") {
  // The special points stretched: six digits do not tell their directions apart.
  Points points = special;
  for (SpacePoint& point : points) point[2] = point[2] * parse_number("1e20");
  const CylindersResult result = cylinders(points, 6);
  check_audit(result);
  CHECK(std::any_of(result.solutions.begin(), result.solutions.end(),
                    [](const CylinderSolution& solution) { return solution.direction_error_exponent < -6; }));
  for (std::size_t i = 0; i < result.solutions.size(); ++i)
    for (std::size_t j = i + 1; j < result.solutions.size(); ++j) {
      const std::vector<std::string> a = printed(result.solutions[i]);
      const std::vector<std::string> b = printed(result.solutions[j]);
      CHECK(!std::equal(a.begin(), a.begin() + 6, b.begin()));
    }
}

TEST_CASE("Cylinders: options") {
  Options options;
  options.digits = 0;
  CHECK_THROWS_AS(cylinders_through({special}, options, Context()), InvalidInput);
  options.digits = 15;
  options.certify = false;
  const CylindersResult result = cylinders_through({special}, options, Context());
  CHECK(result.status == Status::numeric);
  for (const CylinderSolution& solution : result.solutions) CHECK(!solution.certified);
}
