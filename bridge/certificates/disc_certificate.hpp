// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include <eliminant/bridge/enclosures/ball_curve.hpp>
#include <eliminant/numeric/newton_refinement.hpp>

namespace eliminant::bridge {

/// A bivariate polynomial rounded to double, for evaluation with proven bounds. Its true coefficients are the rounded
/// ones times (1 + d), |d| <= 2^-53.
class RoundedCurve {
 public:
  /// p must have integer coefficients. nullopt when a coefficient would be subnormal after scaling.
  static std::optional<RoundedCurve> round(const symbolic::Polynomial& p);
  /// The rounded p / 2^scale_log2.
  const numeric::BivariatePolynomial<double>& polynomial() const { return polynomial_; }
  long scale_log2() const { return scale_log2_; }

  /// Values at (x, y) >= 0 of the polynomial with absolute coefficients and of its derivatives up to the second order,
  /// as upper bounds: rounding included.
  struct Majorant {
    double value, dx, dy, dxx, dxy, dyy;
  };
  Majorant majorant(double x, double y) const;

  /// Number of rounded operations behind each term of an evaluation, at most.
  double operation_count() const { return operation_count_; }

 private:
  numeric::BivariatePolynomial<double> polynomial_;
  numeric::Matrix<double> absolute_;
  double operation_count_ = 0;
  long scale_log2_ = 0;
};

/// Proof that the polydisc |x - center.x| <= radius, |y - center.y| <= radius contains exactly one zero of (p, q), a
/// simple one: with C = `inverse`, |I - C J| <= contraction <= 1/4 (largest row sum) on all of it and |C F(center)| <=
/// radius / 2. When the center is real, the zero is, the polydisc being its own conjugate.
struct DiscCertificate {
  numeric::PlanePoint<double> center;
  double radius = 0;
  double contraction = 0;
  /// C, row by row, for (p / 2^p_scale_log2, q / 2^q_scale_log2).
  std::array<std::complex<double>, 4> inverse;
  long p_scale_log2 = 0;
  long q_scale_log2 = 0;
};

/// The Krawczyk test in hardware doubles, rounded to nearest, every rounding error bounded a priori: with u = 2^-53 and
/// k rounded operations behind each term, a computed value differs from the true one by at most 16 k u times the
/// majorant, and J differs on the polydisc from J(center) by at most radius times the second derivatives of the
/// majorant. nullopt: nothing was proven; ball arithmetic decides. Source: as krawczyk_test; the rounding bounds are
/// those of Horner's rule, [Higham2002], section 5.1.
std::optional<DiscCertificate> disc_krawczyk_test(const RoundedCurve& p, const RoundedCurve& q,
                                                  const numeric::PlanePoint<double>& center);

/// True when the polydiscs have no point in common, seen at a glance.
bool far_apart(const DiscCertificate& a, const DiscCertificate& b);

/// The same for the complex conjugate polydisc.
DiscCertificate conjugate(const DiscCertificate& certificate);

/// A square box inside the polydisc, with 0.7 of its radius as half-width, that holds its zero: that one is within
/// |C F(center)| / (1 - contraction) of the center, two thirds of the radius.
PlaneBall region_of(const DiscCertificate& certificate);

/// Encloses the zero of a certificate in a box of radius at most 2^target_log2 by m <- m - C F(m) in ball arithmetic.
/// For every m of the polydisc |z - m| <= |C F(m)| / (1 - contraction), and the next m is nearer by the factor
/// contraction, up to the error of C F(m). nullopt when too many steps would be needed.
std::optional<PlaneBall> enclose_zero(const DiscCertificate& certificate, const BallCurve& p, const BallCurve& q,
                                      long target_log2);

}  // namespace eliminant::bridge
