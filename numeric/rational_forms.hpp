// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>

#include <eliminant/numeric/scalar.hpp>

namespace eliminant::numeric {

/// Four rows, one for each homogeneous coordinate (x : y : z : w).
using CoordinateRows = Eigen::Matrix<double, 4, Eigen::Dynamic>;

/// The largest degree in one parameter of the maps of this header.
inline constexpr long largest_numeric_degree = 31;

/// A rational curve in doubles: coordinate k is the sum over i of coefficients(k, i) t_0^i t_1^(e - i).
struct CurveForms {
  CoordinateRows coefficients;
  /// The parameter is t_0 / (t_0 + t_1) instead of t_0 / t_1: the forms are those of Bernstein's basis, in which the
  /// binomial coefficients belong to the coefficients here.
  bool bernstein = false;

  long degree() const { return coefficients.cols() - 1; }
};

/// A rational surface in doubles. Tensor products: monomial s_0^i s_1^(m - i) t_0^j t_1^(n - j) in column i (n + 1) +
/// j. Over the projective plane: s^i t^j u^(d - i - j) by increasing i, then j.
struct SurfaceForms {
  CoordinateRows coefficients;
  bool triangular = false;
  std::array<long, 2> degrees{};  ///< (m, n), or (d, 0)
  bool bernstein = false;         ///< as for curves, in both parameters of a tensor product
};

/// The curve with these homogeneous control points (weights multiplied in), e + 1 columns.
CurveForms bezier_curve_forms(const CoordinateRows& control_points);

/// The tensor-product patch with these homogeneous control points: point (i, j) in column i (n + 1) + j.
SurfaceForms bezier_patch_forms(const CoordinateRows& control_points, std::array<long, 2> degrees);

/// Position of the monomial with exponents i and j (of s_0 and t_0, or of s and t) among those of the degrees.
inline long monomial_index(bool triangular, std::array<long, 2> degrees, long i, long j) {
  return triangular ? i * (degrees[0] + 1) - i * (i - 1) / 2 + j : i * (degrees[1] + 1) + j;
}

/// How many monomials there are.
inline long monomial_count(bool triangular, std::array<long, 2> degrees) {
  return triangular ? (degrees[0] + 1) * (degrees[0] + 2) / 2 : (degrees[0] + 1) * (degrees[1] + 1);
}

/// Homogeneous parameters of which one of each group is 1, and which one: (s_0, s_1, t_0, t_1) or (s, t, u).
template <class Scalar>
struct ParameterChart {
  std::array<Scalar, 4> values{};
  std::array<std::size_t, 2> variables{};  ///< positions of the two that vary
};

/// A point and its derivatives by the varying parameters.
template <class Scalar>
struct PointJet {
  std::array<Scalar, 4> value{};
  std::array<std::array<Scalar, 4>, 2> derivative{};
};

template <class Scalar>
PointJet<Scalar> jet(const SurfaceForms& surface, const ParameterChart<Scalar>& at);

/// Of a curve at (t_0, t_1), by t_0 (variable 0) or t_1 (1); only the first derivative is filled.
template <class Scalar>
PointJet<Scalar> jet(const CurveForms& curve, const std::array<Scalar, 2>& at, std::size_t variable);

extern template PointJet<double> jet(const SurfaceForms&, const ParameterChart<double>&);
extern template PointJet<std::complex<double>> jet(const SurfaceForms&, const ParameterChart<std::complex<double>>&);
extern template PointJet<double> jet(const CurveForms&, const std::array<double, 2>&, std::size_t);
extern template PointJet<std::complex<double>> jet(const CurveForms&, const std::array<std::complex<double>, 2>&,
                                                   std::size_t);

}  // namespace eliminant::numeric
