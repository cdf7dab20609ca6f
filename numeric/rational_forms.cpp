// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/rational_forms.hpp>

namespace eliminant::numeric {

namespace {

double binomial(long n, long k) {
  double result = 1;
  for (long i = 1; i <= k; ++i) result = result * static_cast<double>(n - k + i) / static_cast<double>(i);
  return result;
}

/// x^0, ..., x^degree and their derivatives.
template <class Scalar>
struct Powers {
  std::array<Scalar, largest_numeric_degree + 1> value;
  std::array<Scalar, largest_numeric_degree + 1> derivative;

  Powers(const Scalar& x, long degree) {
    value[0] = Scalar(1);
    derivative[0] = Scalar(0);
    for (long i = 1; i <= degree; ++i) {
      const auto at = static_cast<std::size_t>(i);
      value[at] = value[at - 1] * x;
      derivative[at] = static_cast<double>(i) * value[at - 1];
    }
  }
};

/// The monomials x_0^i x_1^(degree - i) where one of both is 1, and their derivatives by the other one.
template <class Scalar>
struct PairMonomials {
  Powers<Scalar> powers;
  long degree;
  bool reversed;

  PairMonomials(const Scalar& first, const Scalar& second, std::size_t variable, long monomial_degree)
      : powers(variable == 0 ? first : second, monomial_degree), degree(monomial_degree), reversed(variable == 1) {}
  const Scalar& value(long i) const { return powers.value[static_cast<std::size_t>(reversed ? degree - i : i)]; }
  const Scalar& derivative(long i) const {
    return powers.derivative[static_cast<std::size_t>(reversed ? degree - i : i)];
  }
};

template <class Scalar>
PointJet<Scalar> tensor_jet(const SurfaceForms& surface, const ParameterChart<Scalar>& at) {
  const auto [m, n] = surface.degrees;
  const PairMonomials<Scalar> s(at.values[0], at.values[1], at.variables[0], m);
  const PairMonomials<Scalar> t(at.values[2], at.values[3], at.variables[1] - 2, n);
  PointJet<Scalar> result;
  const double* coefficient = surface.coefficients.data();
  for (long i = 0; i <= m; ++i) {
    std::array<Scalar, 4> inner{};
    std::array<Scalar, 4> inner_derivative{};
    for (long j = 0; j <= n; ++j)
      for (std::size_t k = 0; k < 4; ++k, ++coefficient) {
        inner[k] += *coefficient * t.value(j);
        inner_derivative[k] += *coefficient * t.derivative(j);
      }
    for (std::size_t k = 0; k < 4; ++k) {
      result.value[k] += s.value(i) * inner[k];
      result.derivative[0][k] += s.derivative(i) * inner[k];
      result.derivative[1][k] += s.value(i) * inner_derivative[k];
    }
  }
  return result;
}

template <class Scalar>
PointJet<Scalar> triangular_jet(const SurfaceForms& surface, const ParameterChart<Scalar>& at) {
  const long d = surface.degrees[0];
  const std::array<Powers<Scalar>, 3> powers{Powers<Scalar>(at.values[0], d), Powers<Scalar>(at.values[1], d),
                                             Powers<Scalar>(at.values[2], d)};
  PointJet<Scalar> result;
  long column = 0;
  for (long i = 0; i <= d; ++i)
    for (long j = 0; i + j <= d; ++j, ++column) {
      const std::array<std::size_t, 3> exponents{static_cast<std::size_t>(i), static_cast<std::size_t>(j),
                                                 static_cast<std::size_t>(d - i - j)};
      const auto monomial = [&](std::size_t differentiated) {
        Scalar product(1);
        for (std::size_t p = 0; p < 3; ++p)
          product *= p == differentiated ? powers[p].derivative[exponents[p]] : powers[p].value[exponents[p]];
        return product;
      };
      const Scalar value = monomial(3);
      const Scalar first = monomial(at.variables[0]);
      const Scalar second = monomial(at.variables[1]);
      for (std::size_t k = 0; k < 4; ++k) {
        const double c = surface.coefficients(static_cast<long>(k), column);
        result.value[k] += c * value;
        result.derivative[0][k] += c * first;
        result.derivative[1][k] += c * second;
      }
    }
  return result;
}

}  // namespace

CurveForms bezier_curve_forms(const CoordinateRows& control_points) {
  CurveForms curve{control_points, true};
  for (long i = 0; i <= curve.degree(); ++i) curve.coefficients.col(i) *= binomial(curve.degree(), i);
  return curve;
}

SurfaceForms bezier_patch_forms(const CoordinateRows& control_points, std::array<long, 2> degrees) {
  SurfaceForms surface{control_points, false, degrees, true};
  for (long i = 0; i <= degrees[0]; ++i)
    for (long j = 0; j <= degrees[1]; ++j)
      surface.coefficients.col(monomial_index(false, degrees, i, j)) *=
          binomial(degrees[0], i) * binomial(degrees[1], j);
  return surface;
}

template <class Scalar>
PointJet<Scalar> jet(const SurfaceForms& surface, const ParameterChart<Scalar>& at) {
  return surface.triangular ? triangular_jet(surface, at) : tensor_jet(surface, at);
}

template <class Scalar>
PointJet<Scalar> jet(const CurveForms& curve, const std::array<Scalar, 2>& at, std::size_t variable) {
  const PairMonomials<Scalar> t(at[0], at[1], variable, curve.degree());
  PointJet<Scalar> result;
  for (long i = 0; i <= curve.degree(); ++i)
    for (std::size_t k = 0; k < 4; ++k) {
      const double c = curve.coefficients(static_cast<long>(k), i);
      result.value[k] += c * t.value(i);
      result.derivative[0][k] += c * t.derivative(i);
    }
  return result;
}

template PointJet<double> jet(const SurfaceForms&, const ParameterChart<double>&);
template PointJet<std::complex<double>> jet(const SurfaceForms&, const ParameterChart<std::complex<double>>&);
template PointJet<double> jet(const CurveForms&, const std::array<double, 2>&, std::size_t);
template PointJet<std::complex<double>> jet(const CurveForms&, const std::array<std::complex<double>, 2>&, std::size_t);

}  // namespace eliminant::numeric
