// SPDX-License-Identifier: BSD-3-Clause
#include <support/patch_nets.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <support/binary_numbers.hpp>

namespace eliminant::test {

namespace {

using symbolic::ControlPoint;
using symbolic::Integer;
using symbolic::Polynomial;
using symbolic::Rational;

constexpr std::size_t coordinates = 4;
const symbolic::Interval unit{0, 1};

std::vector<Rational> column_of(const RationalNet& net, std::size_t j, std::size_t k) {
  std::vector<Rational> column;
  for (const auto& row : net) column.push_back(row[j][k]);
  return column;
}

/// The common denominator without its powers of two.
Integer odd_denominator(const RationalNet& net, Integer denominator) {
  for (const auto& row : net)
    for (const ControlPoint& point : row)
      for (const Rational& number : point) fmpz_lcm(denominator.get(), denominator.get(), fmpq_denref(number.get()));
  fmpz_tdiv_q_2exp(denominator.get(), denominator.get(), fmpz_val2(denominator.get()));
  return denominator;
}

std::string quotient_text(double number, double weight) {
  return '"' + (exact_rational(number) / exact_rational(weight)).to_string() + '"';
}

std::string bezier_json(const ControlNet& net) {
  std::string text = "{\"bezier\": {\"degree\": [" + std::to_string(net.size() - 1) + ", " +
                     std::to_string(net.front().size() - 1) + "], \"control_points\": [";
  for (std::size_t i = 0; i < net.size(); ++i) {
    text += i == 0 ? "[" : ", [";
    for (std::size_t j = 0; j < net[i].size(); ++j) {
      const HomogeneousPoint& p = net[i][j];
      text += j == 0 ? "[" : ", [";
      for (std::size_t k = 0; k < 3; ++k) text += quotient_text(p[k], p[3]) + ", ";
      text += quotient_text(p[3], 1) + "]";
    }
    text += "]";
  }
  return text + "]}}";
}

}  // namespace

PatchMap affine_patch(const Polynomial& x, const Polynomial& y, const Polynomial& z) {
  return {x, y, z, Polynomial::constant(2, 1)};
}

RationalNet control_net(const PatchMap& map, std::size_t m, std::size_t n) {
  RationalNet net(m + 1, std::vector<ControlPoint>(n + 1, ControlPoint(coordinates)));
  for (std::size_t k = 0; k < coordinates; ++k) {
    std::vector<std::vector<Rational>> power(m + 1, std::vector<Rational>(n + 1));
    for (const Polynomial::Term& term : map[k].terms())
      power.at(term.exponents[0]).at(term.exponents[1]) = term.coefficient;
    for (auto& row : power) row = symbolic::bernstein_coefficients(row, unit);
    for (std::size_t j = 0; j <= n; ++j) {
      std::vector<Rational> column;
      for (const auto& row : power) column.push_back(row[j]);
      const auto bernstein = symbolic::bernstein_coefficients(column, unit);
      for (std::size_t i = 0; i <= m; ++i) net[i][j][k] = bernstein[i];
    }
  }
  return net;
}

PatchMap patch_map(const RationalNet& net) {
  PatchMap result{Polynomial(2), Polynomial(2), Polynomial(2), Polynomial(2)};
  for (std::size_t k = 0; k < coordinates; ++k) {
    std::vector<std::vector<Rational>> columns;
    for (std::size_t j = 0; j < net.front().size(); ++j)
      columns.push_back(symbolic::power_coefficients(column_of(net, j, k), unit));
    std::vector<Polynomial::Term> terms;
    for (std::size_t i = 0; i < net.size(); ++i) {
      std::vector<Rational> row;
      for (const auto& column : columns) row.push_back(column[i]);
      const auto power = symbolic::power_coefficients(row, unit);
      for (std::size_t j = 0; j < power.size(); ++j) terms.push_back({power[j], {i, j}});
    }
    result[k] = Polynomial::from_terms(2, terms);
  }
  return result;
}

PatchMap patch_map(const ControlNet& net) { return patch_map(rational_net(net)); }

void make_binary(RationalNet& first, RationalNet& second) {
  const Integer odd = odd_denominator(second, odd_denominator(first, 1));
  Integer power_of_two(1);
  fmpz_mul_2exp(power_of_two.get(), power_of_two.get(), odd.bit_length());
  const Rational factor(odd, power_of_two);
  for (RationalNet* net : {&first, &second})
    for (auto& row : *net)
      for (ControlPoint& point : row)
        for (std::size_t k = 0; k + 1 < coordinates; ++k) point[k] = factor * point[k];
}

RationalNet transformed(RationalNet net, const Projectivity& matrix) {
  for (auto& row : net)
    for (ControlPoint& point : row) {
      ControlPoint image(coordinates);
      for (std::size_t i = 0; i < coordinates; ++i)
        for (std::size_t k = 0; k < coordinates; ++k) image[i] = image[i] + matrix[i][k] * point[k];
      point = std::move(image);
    }
  return net;
}

ControlNet in_doubles(const RationalNet& net) {
  ControlNet result;
  for (const auto& row : net) {
    result.emplace_back();
    for (const ControlPoint& point : row) {
      HomogeneousPoint& converted = result.back().emplace_back();
      std::transform(point.begin(), point.end(), converted.begin(), exact_double);
    }
  }
  return result;
}

RationalNet rational_net(const ControlNet& net) {
  RationalNet result;
  for (const ControlPolygon& row : net) {
    result.emplace_back();
    for (const HomogeneousPoint& point : row) {
      ControlPoint& converted = result.back().emplace_back();
      for (const double number : point) converted.push_back(exact_rational(number));
    }
  }
  return result;
}

symbolic::SurfacePiece surface_piece(const ControlNet& net) { return symbolic::bezier_patch(rational_net(net)); }

ControlNet parameters_exchanged(const ControlNet& net) {
  ControlNet result(net.front().size(), ControlPolygon(net.size()));
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t j = 0; j < net.front().size(); ++j) result[j][i] = net[i][j];
  return result;
}

ControlNet parameter_reversed(ControlNet net) {
  std::reverse(net.begin(), net.end());
  return net;
}

ControlNet scaled(ControlNet net, int exponent) {
  for (ControlPolygon& row : net)
    for (HomogeneousPoint& point : row)
      for (std::size_t k = 0; k < 3; ++k) point[k] = std::ldexp(point[k], exponent);
  return net;
}

ControlNet moved(ControlNet net, double by) {
  for (ControlPolygon& row : net)
    for (HomogeneousPoint& point : row)
      for (std::size_t k = 0; k < 3; ++k)
        point[k] = exact_double(exact_rational(point[k]) + exact_rational(by) * exact_rational(point[3]));
  return net;
}

std::array<double, 3> patch_point(const ControlNet& net, double u, double v) {
  const auto fold = [](ControlPolygon points, double t) {
    for (std::size_t size = points.size(); size > 1; --size)
      for (std::size_t i = 0; i + 1 < size; ++i)
        for (std::size_t k = 0; k < coordinates; ++k) points[i][k] = (1 - t) * points[i][k] + t * points[i + 1][k];
    return points.front();
  };
  ControlPolygon rows;
  for (const ControlPolygon& row : net) rows.push_back(fold(row, v));
  const HomogeneousPoint p = fold(rows, u);
  return {p[0] / p[3], p[1] / p[3], p[2] / p[3]};
}

std::string problem_json(const PatchCase& patches) {
  if (patches.second.empty())
    return R"({"problem": "self_intersection", "surface": )" + bezier_json(patches.first) + "}";
  return R"({"problem": "surface_surface", "first": )" + bezier_json(patches.first) +
         ", \"second\": " + bezier_json(patches.second) + "}";
}

}  // namespace eliminant::test
