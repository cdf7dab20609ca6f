// SPDX-License-Identifier: BSD-3-Clause
#include <support/overlap_families.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::test {

namespace {

using Point = std::array<double, 2>;

/// A quadrilateral by its corners at (0, 0), (1, 0), (0, 1), (1, 1), in plane coordinates p, q.
struct Quadrilateral {
  std::array<std::array<long, 2>, 4> corners;
  long denominator = 4;

  std::string coordinate(std::size_t k) const {
    const auto c = [&](std::size_t i) { return "(" + std::to_string(corners[i][k]) + ")"; };
    return "((1-u)*(1-v)*" + c(0) + " + u*(1-v)*" + c(1) + " + (1-u)*v*" + c(2) + " + u*v*" + c(3) + ")/" +
           std::to_string(denominator);
  }
  /// In the plane z = x/3 - y.
  SurfacePiece patch() const {
    const std::string p = coordinate(0);
    const std::string q = coordinate(1);
    return test::patch({p, q, "(" + p + ")/3 - (" + q + ")"});
  }
  Point corner(std::size_t i) const {
    return {static_cast<double>(corners[i][0]) / static_cast<double>(denominator),
            static_cast<double>(corners[i][1]) / static_cast<double>(denominator)};
  }
  Point at(double u, double v) const {
    Point result{};
    for (std::size_t k = 0; k < 2; ++k)
      result[k] = (1 - u) * (1 - v) * corner(0)[k] + u * (1 - v) * corner(1)[k] + (1 - u) * v * corner(2)[k] +
                  u * v * corner(3)[k];
    return result;
  }
  /// Signed distance from the sides, of a convex one.
  double depth(const Point& at) const {
    constexpr std::array<std::size_t, 5> round{0, 1, 3, 2, 0};
    double least = INFINITY;
    double turn = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point a = corner(round[i]);
      const Point b = corner(round[i + 1]);
      const Point middle{0.25 * (corner(0)[0] + corner(1)[0] + corner(2)[0] + corner(3)[0]),
                         0.25 * (corner(0)[1] + corner(1)[1] + corner(2)[1] + corner(3)[1])};
      const auto side = [&](const Point& p) {
        return ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / std::hypot(b[0] - a[0], b[1] - a[1]);
      };
      turn = side(middle) > 0 ? 1 : -1;
      least = std::min(least, turn * side(at));
    }
    return least;
  }
};

OverlapPair quadrilaterals(const std::string& name, const Quadrilateral& first, const Quadrilateral& second,
                           const std::array<unsigned long, 4>& counts) {
  return {name, first.patch(), second.patch(), counts,
          [=](double u, double v) { return place_by(second.depth(first.at(u, v))); }};
}

/// The unit sphere from one of its poles: stereographic, with the coordinate `pole` last and the other two in order.
SurfacePiece sphere_part(std::size_t pole, const Sides& sides) {
  std::array<std::string, 3> x;
  x[pole] = "u^2 + v^2 - 1";
  x[(pole + 1) % 3] = "2*u";
  x[(pole + 2) % 3] = "2*v";
  return patch({x[0], x[1], x[2], "u^2 + v^2 + 1"}, sides);
}

double within(double x, const Interval& side) {
  return std::min(x - fmpq_get_d(side.lower.get()), fmpq_get_d(side.upper.get()) - x);
}

OverlapPair spheres(const std::string& name, const Sides& first, std::size_t pole, const Sides& second,
                    const std::array<unsigned long, 4>& counts) {
  const auto place = [=](double u, double v) {
    const double w = u * u + v * v + 1;
    const std::array<double, 3> point{2 * u / w, 2 * v / w, (u * u + v * v - 1) / w};  // pole 2
    const double s = point[(pole + 1) % 3] / (1 - point[pole]);
    const double t = point[(pole + 2) % 3] / (1 - point[pole]);
    return place_by(std::min(within(s, second[0]), within(t, second[1])));
  };
  return {name, sphere_part(2, first), sphere_part(pole, second), counts, place};
}

/// x^2 + y^2 = 1 by the angle, and z = v, or v + u with the circle begun elsewhere.
OverlapPair cylinders(const std::string& name, const Sides& first, const Sides& second,
                      const std::array<unsigned long, 4>& counts) {
  const auto place = [=](double u, double v) {
    const double x = (1 - u * u) / (1 + u * u);
    const double y = 2 * u / (1 + u * u);
    // (2 s, 1 - s^2) / (1 + s^2), t = z - s.
    const double s = x / (1 + y);
    return place_by(std::min(within(s, second[0]), within(v - s, second[1])));
  };
  return {name, patch({"1 - u^2", "2*u", "v*(1 + u^2)", "1 + u^2"}, first),
          patch({"2*u", "1 - u^2", "(v + u)*(1 + u^2)", "1 + u^2"}, second), counts, place};
}

Sides sides(const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
  return {Interval{a, b}, Interval{c, d}};
}

}  // namespace

std::vector<OverlapPair> overlaps_of_common_surfaces() {
  const Quadrilateral square{{{{0, 0}, {4, 0}, {0, 4}, {4, 4}}}};
  const Quadrilateral uneven{{{{0, 0}, {5, 1}, {-1, 4}, {3, 6}}}};
  std::vector<OverlapPair> result{
      quadrilaterals("corner", square, {{{{2, 2}, {6, 3}, {1, 6}, {5, 7}}}}, {0, 0, 0, 1}),
      quadrilaterals("octagon", square, {{{{2, -1}, {5, 2}, {-1, 2}, {2, 5}}}}, {0, 0, 0, 1}),
      quadrilaterals("inside", square, {{{{2, 1}, {3, 2}, {1, 2}, {2, 3}}}}, {0, 0, 0, 1}),
      quadrilaterals("across", square, {{{{1, -2}, {1, 6}, {3, -2}, {3, 6}}}}, {0, 0, 0, 1}),
      quadrilaterals("two corners", uneven, {{{{4, -1}, {6, 1}, {1, 7}, {4, 8}}}}, {0, 0, 0, 1}),
      quadrilaterals("touching in a corner", square, {{{{4, 0}, {8, 4}, {6, -4}, {10, 0}}}}, {0, 0, 1, 0}),
      quadrilaterals("corner on a side", square, {{{{4, 2}, {8, 1}, {8, 4}, {12, 3}}}}, {0, 0, 1, 0}),
      quadrilaterals("side in common", square, {{{{4, 0}, {4, 4}, {8, 0}, {8, 8}}}}, {1, 0, 0, 0}),
      quadrilaterals("part of a side", square, {{{{4, -2}, {4, 2}, {8, 0}, {8, 8}}}}, {1, 0, 0, 0}),
      quadrilaterals("two sides within", square, {{{{0, 0}, {4, 0}, {0, 2}, {2, 3}}}}, {0, 0, 0, 1}),
      quadrilaterals("apart", square, {{{{9, 0}, {12, 0}, {9, 4}, {12, 8}}}}, {0, 0, 0, 0}),
      spheres("sphere, two poles", sides(ratio(-1, 4), 1, ratio(-1, 4), 1), 0,
              sides(ratio(-1, 3), ratio(3, 4), ratio(-1, 2), ratio(3, 4)), {0, 0, 0, 1}),
      spheres("sphere, within", sides(ratio(1, 4), ratio(1, 2), ratio(1, 4), ratio(1, 2)), 1,
              sides(ratio(-3, 2), ratio(-1, 4), ratio(1, 4), ratio(3, 2)), {0, 0, 0, 1}),
      spheres("sphere, one pole", sides(0, ratio(1, 2), 0, ratio(1, 2)), 2, sides(ratio(1, 4), 1, ratio(1, 4), 1),
              {0, 0, 0, 1}),
      spheres("sphere, apart", sides(0, ratio(1, 2), 0, ratio(1, 2)), 2, sides(1, 2, 1, 2), {0, 0, 0, 0}),
      cylinders("cylinder, skew", unit_square(), unit_square(), {0, 0, 0, 1}),
      cylinders("cylinder, band", sides(ratio(1, 4), ratio(3, 4), 0, 2), sides(ratio(1, 8), 1, 0, ratio(1, 2)),
                {0, 0, 0, 1}),
  };
  return result;
}

std::vector<OverlapPair> overlaps_of_shared_maps(unsigned seed) {
  std::mt19937 random(seed);
  const Sides left = sides(0, ratio(1, 2), 0, 1);
  const std::vector<std::pair<std::string, std::array<Sides, 2>>> places{
      {"equal", {unit_square(), unit_square()}},
      {"overlapping corners", {sides(0, ratio(3, 4), 0, ratio(2, 3)), sides(ratio(1, 4), 1, ratio(1, 3), 1)}},
      {"one inside", {unit_square(), sides(ratio(1, 4), ratio(5, 7), ratio(1, 10), ratio(9, 10))}},
      {"across", {sides(ratio(1, 3), ratio(2, 3), 0, 1), sides(0, 1, ratio(2, 5), ratio(3, 5))}},
      {"side within", {left, sides(0, ratio(1, 4), ratio(1, 4), ratio(1, 2))}},
      {"border in common", {left, sides(ratio(1, 2), 1, 0, 1)}},
      {"part of a border", {left, sides(ratio(1, 2), 1, ratio(1, 3), ratio(2, 3))}},
      {"corner in common", {sides(0, ratio(1, 2), 0, ratio(1, 2)), sides(ratio(1, 2), 1, ratio(1, 2), 1)}},
      {"apart", {left, sides(ratio(5, 8), 1, 0, 1)}},
      {"narrow", {unit_square(), sides(ratio(127, 128), 1, ratio(1, 2), ratio(65, 128))}},
  };
  const std::vector<std::array<Fraction, 2>> changes{
      {Fraction{}, Fraction{}},
      {Fraction{-1, 1, 0, 1}, Fraction{3, ratio(1, 5), 0, 2}},
      {Fraction{3, 1, 1, 4}, Fraction{-2, 5, 1, 3}},
  };
  std::vector<OverlapPair> result;
  for (const auto& [name, rectangle] : places) {
    const std::size_t i = result.size();
    const long degree = 2 + static_cast<long>(i % 2);
    OverlapPair pair = rectangles(name, random_text(random, degree, i % 3 == 2), rectangle[0], rectangle[1]);
    pair.second = reparametrised(pair.second, changes[i % changes.size()], i % 4 == 3);
    result.push_back(std::move(pair));
  }
  return result;
}

}  // namespace eliminant::test
