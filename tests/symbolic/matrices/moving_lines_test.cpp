// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/representation_minors.hpp>
#include <eliminant/symbolic/matrices/moving_lines.hpp>
#include <eliminant/symbolic/matrices/representation_rank.hpp>
#include <support/curves.hpp>
#include <support/representation_data.hpp>

using namespace eliminant;
using namespace eliminant::symbolic;
using namespace eliminant::test;

namespace {

struct Example {
  const char* name;
  std::vector<std::string> coordinates;
  long map_degree;
};

const std::vector<Example>& plane_curves() {
  static const std::vector<Example> curves{{"line", {"1+2*t", "3-t", "1"}, 1},
                                           {"circle", {"1-t^2", "2*t", "1+t^2"}, 1},
                                           {"nodal cubic", {"t^2-1", "t^3-t", "1"}, 1},
                                           {"cuspidal cubic", {"t^2", "t^3", "1"}, 1},
                                           {"parabola drawn twice", {"t^2", "t^4", "1"}, 2},
                                           {"conic drawn three times", {"1-(t^3-t)^2", "2*(t^3-t)", "1+(t^3-t)^2"}, 3},
                                           {"quintic", {"t^5-3*t+1", "2*t^4-t^3+7", "t^5+t^2-5"}, 1},
                                           {"descartes", {"3*t", "3*t^2", "1+t^3"}, 1}};
  return curves;
}

const std::vector<Example>& space_curves() {
  static const std::vector<Example> curves{{"line", {"1", "t", "2*t", "3"}, 1},
                                           {"twisted cubic", {"t", "t^2", "t^3", "1"}, 1},
                                           {"plane conic in space", {"t", "t^2", "0", "1"}, 1},
                                           {"quartic", {"t^4-1", "t^3+t", "t^2-5*t", "t^4+2"}, 1},
                                           {"drawn twice", {"t^2", "t^4", "t^6-t^2", "1"}, 2}};
  return curves;
}

bool is_moving_line(const MovingLine& line, const RationalCurve& curve) {
  UnivariatePolynomial sum;
  for (std::size_t k = 0; k < line.size(); ++k) sum = sum + line[k] * curve.coordinates()[k];
  return sum.is_zero();
}

}  // namespace

TEST_CASE("moving lines: a basis has n elements whose degrees add up to that of the curve") {
  for (const auto* curves : {&plane_curves(), &space_curves()})
    for (const Example& example : *curves) {
      CAPTURE(example.name);
      const RationalCurve curve = curve_map(example.coordinates);
      const std::vector<MovingLine> basis = moving_line_basis(curve);
      CHECK(basis.size() == curve.dimension());
      long sum = 0;
      long previous = 0;
      for (const MovingLine& line : basis) {
        CHECK(is_moving_line(line, curve));
        long degree = 0;
        for (const UnivariatePolynomial& entry : line) degree = std::max(degree, entry.degree());
        CHECK(degree >= previous);
        previous = degree;
        sum += degree;
      }
      CHECK(sum == curve.degree());
    }
}

TEST_CASE("moving lines: the matrix has full rank beside the curve and loses the degree of the map on it") {
  Random random(5);
  for (const auto* curves : {&plane_curves(), &space_curves()})
    for (const Example& example : *curves) {
      CAPTURE(example.name);
      const RationalCurve curve = curve_map(example.coordinates);
      for (long nu = std::max(curve.degree() - 1, 1L); nu <= curve.degree() + 1; ++nu) {
        CAPTURE(nu);
        const MatrixRepresentation m = moving_line_matrix(curve, nu);
        CHECK(m.rows() == nu + 1);
        // The moving lines of a basis of degree mu_k give nu - mu_k + 1 columns each.
        CHECK(m.columns() == static_cast<long>(curve.dimension()) * (nu + 1) - curve.degree());
        CHECK(generic_rank_modulo(m, 0) == m.rows());
        CHECK(rank_on_modulo(m, curve, 0) == m.rows() - example.map_degree);
        for (int sample = 0; sample < 3; ++sample) {
          const Rational t(Integer(random.nonzero(50)), Integer(random.between(1, 20)));
          const IntegerMatrix value = value_at(m, curve.at(t));
          CHECK(value.rank() == m.rows() - example.map_degree);
          // The row monomials at t are in the left kernel.
          IntegerMatrix powers(1, m.rows());
          for (long i = 0; i < m.rows(); ++i) {
            const auto e = m.row_monomials[static_cast<std::size_t>(i)].front();
            fmpz_set(powers.entry(0, i),
                     (power(t.numerator(), e) * power(t.denominator(), static_cast<unsigned long>(nu) - e)).get());
          }
          IntegerMatrix product(1, m.columns());
          fmpz_mat_mul(product.get(), powers.get(), value.get());
          CHECK(fmpz_mat_is_zero(product.get()) != 0);
        }
      }
      std::vector<Rational> at_infinity;
      for (const Integer& coordinate : curve.at_infinity()) at_infinity.emplace_back(coordinate);
      const MatrixRepresentation m = moving_line_matrix(curve, std::max(curve.degree() - 1, 1L));
      CHECK(value_at(m, at_infinity).rank() < m.rows());
    }
}

TEST_CASE("moving lines: of degree d - 1 they make a square matrix, whose determinant is the equation to a power") {
  const Context context;
  for (const Example& example : plane_curves()) {
    CAPTURE(example.name);
    const RationalCurve curve = curve_map(example.coordinates);
    const MatrixRepresentation m = moving_line_matrix(curve, curve.degree() - 1);
    REQUIRE(m.rows() == m.columns());
    CHECK(m.rows() == curve.degree());
    const ParameterForm itself = minors_on_curve(m, curve, 0, context);
    CHECK(itself.finite.is_zero());
    const RationalCurve line = curve_map({"3+t", "1-2*t", "7+4*t"});
    CHECK(minors_on_curve(m, line, 0, context).degree() == curve.degree());
  }
  // x^2 + y^2 = w^2 on the line (3 + t : 1 - 2 t : 7 + 4 t)
  const MatrixRepresentation circle = moving_line_matrix(curve_map({"1-t^2", "2*t", "1+t^2"}), 1);
  const RationalCurve line = curve_map({"3+t", "1-2*t", "7+4*t"});
  CHECK(text(minors_on_curve(circle, line, 0, context).finite) == text(univariate("(3+t)^2 + (1-2*t)^2 - (7+4*t)^2")));
}

TEST_CASE("moving lines: below degree d - 1 there are too few, and a negative degree is refused") {
  const RationalCurve quintic = curve_map({"t^5-3*t+1", "2*t^4-t^3+7", "t^5+t^2-5"});
  const MatrixRepresentation m = moving_line_matrix(quintic, 3);
  CHECK(m.columns() < m.rows());
  CHECK_THROWS_AS(moving_line_matrix(quintic, -1), InvalidInput);
}
