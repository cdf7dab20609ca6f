// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <eliminant/bridge/certificates/disc_certificate.hpp>
#include <eliminant/bridge/rounding/round_matrix.hpp>

namespace eliminant::bridge {

namespace {

using Complex = std::complex<double>;

constexpr double unit_roundoff = 0x1p-53;
/// Factor that makes a computed sum of non-negative terms an upper bound: fewer than 2^20 operations lie behind each.
constexpr double upward = 1 + 0x1p-30;
/// Below this a product might have lost bits to underflow.
constexpr double smallest_trusted = 1e-250;
constexpr double largest_trusted = 1e250;

double absolute(const Complex& z) { return std::hypot(z.real(), z.imag()) * upward; }

ComplexBall exact_ball(const Complex& z) { return {z.real(), z.imag()}; }

}  // namespace

std::optional<RoundedCurve> RoundedCurve::round(const symbolic::Polynomial& p) {
  RoundedCurve curve;
  Rounded<numeric::BivariatePolynomial<double>> rounded = round_polynomial<double>(p);
  curve.polynomial_ = std::move(rounded.value);
  curve.scale_log2_ = rounded.scale_log2;
  for (const auto& term : p.terms()) {
    const double c =
        curve.polynomial_.coefficients(static_cast<long>(term.exponents[0]), static_cast<long>(term.exponents[1]));
    if (std::fabs(c) < smallest_trusted) return std::nullopt;
  }
  curve.absolute_ = curve.polynomial_.coefficients.cwiseAbs();
  // Horner's rule takes two operations for each power of x and of y, derivatives one more; one for the coefficient.
  curve.operation_count_ = static_cast<double>(3 * (curve.absolute_.rows() + curve.absolute_.cols()) + 4);
  return curve;
}

RoundedCurve::Majorant RoundedCurve::majorant(double x, double y) const {
  Majorant sum{0, 0, 0, 0, 0, 0};
  for (long j = absolute_.cols(); j-- > 0;) {
    double row = 0;
    double row_dx = 0;
    double row_dxx = 0;  // half the second derivative
    for (long i = absolute_.rows(); i-- > 0;) {
      row_dxx = row_dxx * x + row_dx;
      row_dx = row_dx * x + row;
      row = row * x + absolute_(i, j);
    }
    sum.dyy = sum.dyy * y + sum.dy;  // half, as well
    sum.dxy = sum.dxy * y + sum.dx;
    sum.dxx = sum.dxx * y + row_dxx;
    sum.dy = sum.dy * y + sum.value;
    sum.dx = sum.dx * y + row_dx;
    sum.value = sum.value * y + row;
  }
  sum.dxx *= 2;
  sum.dyy *= 2;
  for (double* bound : {&sum.value, &sum.dx, &sum.dy, &sum.dxx, &sum.dxy, &sum.dyy}) *bound *= upward;
  return sum;
}

std::optional<DiscCertificate> disc_krawczyk_test(const RoundedCurve& p, const RoundedCurve& q,
                                                  const numeric::PlanePoint<double>& center) {
  if (!numeric::is_finite(center.x) || !numeric::is_finite(center.y)) return std::nullopt;
  const numeric::Jet<double> f = numeric::jet(p.polynomial(), center.x, center.y);
  const numeric::Jet<double> g = numeric::jet(q.polynomial(), center.x, center.y);
  const Complex determinant = f.dx * g.dy - f.dy * g.dx;
  DiscCertificate certificate;
  certificate.center = center;
  certificate.p_scale_log2 = p.scale_log2();
  certificate.q_scale_log2 = q.scale_log2();
  certificate.inverse = {g.dy / determinant, -f.dy / determinant, -g.dx / determinant, f.dx / determinant};
  const auto& c = certificate.inverse;
  std::array<double, 4> c_absolute{};
  for (std::size_t k = 0; k < 4; ++k) {
    if (!numeric::is_finite(c[k])) return std::nullopt;
    c_absolute[k] = absolute(c[k]);
  }
  const double x_size = absolute(center.x);
  const double y_size = absolute(center.y);
  const RoundedCurve::Majorant f_here = p.majorant(x_size, y_size);
  const RoundedCurve::Majorant g_here = q.majorant(x_size, y_size);
  for (const double size : {f_here.value, g_here.value, f_here.dx + f_here.dy, g_here.dx + g_here.dy})
    if (!(size > smallest_trusted && size < largest_trusted)) return std::nullopt;
  const double f_error = 16 * p.operation_count() * unit_roundoff;
  const double g_error = 16 * q.operation_count() * unit_roundoff;
  const double f_bound = absolute(f.value) + f_error * f_here.value;
  const double g_bound = absolute(g.value) + g_error * g_here.value;
  const double step = upward * std::max(c_absolute[0] * f_bound + c_absolute[1] * g_bound,
                                        c_absolute[2] * f_bound + c_absolute[3] * g_bound);
  certificate.radius = 2 * step;
  const double r = certificate.radius;
  if (!(r > smallest_trusted && r < largest_trusted)) return std::nullopt;
  const RoundedCurve::Majorant f_near = p.majorant((x_size + r) * upward, (y_size + r) * upward);
  const RoundedCurve::Majorant g_near = q.majorant((x_size + r) * upward, (y_size + r) * upward);
  // Bounds of |J(z) - computed J| on the polydisc, by column.
  const std::array<double, 2> f_change{f_error * f_here.dx + r * (f_near.dxx + f_near.dxy),
                                       f_error * f_here.dy + r * (f_near.dxy + f_near.dyy)};
  const std::array<double, 2> g_change{g_error * g_here.dx + r * (g_near.dxx + g_near.dxy),
                                       g_error * g_here.dy + r * (g_near.dxy + g_near.dyy)};
  const std::array<Complex, 2> f_row{f.dx, f.dy};
  const std::array<Complex, 2> g_row{g.dx, g.dy};
  for (std::size_t row = 0; row < 2; ++row) {
    double sum = 0;
    for (std::size_t column = 0; column < 2; ++column) {
      const Complex product = c[2 * row] * f_row[column] + c[2 * row + 1] * g_row[column];
      const double rounding =
          16 * unit_roundoff *
          (c_absolute[2 * row] * absolute(f_row[column]) + c_absolute[2 * row + 1] * absolute(g_row[column]) + 1);
      sum += absolute(Complex(row == column ? 1.0 : 0.0) - product) + rounding +
             c_absolute[2 * row] * f_change[column] + c_absolute[2 * row + 1] * g_change[column];
    }
    certificate.contraction = std::max(certificate.contraction, sum * upward);
  }
  // Then step + contraction * radius <= radius, with radius = 2 step, and the zero is within 4/3 step.
  if (!(certificate.contraction <= 0.25)) return std::nullopt;
  return certificate;
}

bool far_apart(const DiscCertificate& a, const DiscCertificate& b) {
  // Twice the radii leave room for the rounding of the differences.
  const double reach = 2 * (a.radius + b.radius);
  const Complex dx = a.center.x - b.center.x;
  const Complex dy = a.center.y - b.center.y;
  return std::fabs(dx.real()) > reach || std::fabs(dx.imag()) > reach || std::fabs(dy.real()) > reach ||
         std::fabs(dy.imag()) > reach;
}

DiscCertificate conjugate(const DiscCertificate& certificate) {
  DiscCertificate result = certificate;
  result.center = {std::conj(certificate.center.x), std::conj(certificate.center.y)};
  for (Complex& entry : result.inverse) entry = std::conj(entry);
  return result;
}

PlaneBall region_of(const DiscCertificate& certificate) {
  PlaneBall box{exact_ball(certificate.center.x), exact_ball(certificate.center.y)};
  // Below 1 / sqrt(2), so that the corners are in the disc, and above 2 / 3.
  Magnitude radius;
  mag_set_d_lower(radius.get(), 0.7 * certificate.radius);
  for (ComplexBall* coordinate : {&box.x, &box.y}) {
    arb_add_error_mag(coordinate->real(), radius.get());
    arb_add_error_mag(coordinate->imaginary(), radius.get());
  }
  return box;
}

std::optional<PlaneBall> enclose_zero(const DiscCertificate& certificate, const BallCurve& p, const BallCurve& q,
                                      long target_log2) {
  const double size = std::max({1.0, std::abs(certificate.center.x), std::abs(certificate.center.y)});
  const long precision_bits = std::max(96L, std::ilogb(size) - target_log2 + 32);
  // A zero of real curves in a polydisc with real center is real.
  const bool real = certificate.center.x.imag() == 0 && certificate.center.y.imag() == 0;
  const PlaneBall center{exact_ball(certificate.center.x), exact_ball(certificate.center.y)};
  PlaneBall point = center;
  std::array<ComplexBall, 4> c;
  for (std::size_t k = 0; k < 4; ++k) c[k] = exact_ball(certificate.inverse[k]);
  Magnitude contraction;
  mag_set_d(contraction.get(), certificate.contraction);
  constexpr int max_steps = 5;
  for (int step = 0; step < max_steps; ++step) {
    ComplexBall f = p.value(point, precision_bits);
    ComplexBall g = q.value(point, precision_bits);
    acb_mul_2exp_si(f.get(), f.get(), -certificate.p_scale_log2);
    acb_mul_2exp_si(g.get(), g.get(), -certificate.q_scale_log2);
    PlaneBall correction;
    acb_mul(correction.x.get(), c[0].get(), f.get(), precision_bits);
    acb_addmul(correction.x.get(), c[1].get(), g.get(), precision_bits);
    acb_mul(correction.y.get(), c[2].get(), f.get(), precision_bits);
    acb_addmul(correction.y.get(), c[3].get(), g.get(), precision_bits);
    // |z - m| <= 4/3 |C F(m)|, and z lies within contraction |z - m| of m - C F(m), which is a ball.
    Magnitude distance;
    Magnitude y_distance;
    acb_get_mag(distance.get(), correction.x.get());
    acb_get_mag(y_distance.get(), correction.y.get());
    mag_max(distance.get(), distance.get(), y_distance.get());
    mag_mul_2exp_si(distance.get(), distance.get(), 1);
    mag_mul(distance.get(), distance.get(), contraction.get());
    PlaneBall next;
    acb_sub(next.x.get(), point.x.get(), correction.x.get(), precision_bits);
    acb_sub(next.y.get(), point.y.get(), correction.y.get(), precision_bits);
    acb_add_error_mag(next.x.get(), distance.get());
    acb_add_error_mag(next.y.get(), distance.get());
    if (real) {
      arb_zero(next.x.imaginary());
      arb_zero(next.y.imaginary());
    }
    const auto reached = [&](arb_srcptr part) { return mag_cmp_2exp_si(arb_radref(part), target_log2) <= 0; };
    if (reached(next.x.real()) && reached(next.x.imaginary()) && reached(next.y.real()) && reached(next.y.imaginary()))
      return next;
    acb_get_mid(point.x.get(), next.x.get());
    acb_get_mid(point.y.get(), next.y.get());
    // The bounds hold in the polydisc only. Every exact step stays in it; rounding moves by far less than the radius.
    for (const auto& [now, start] : {std::pair{&point.x, &center.x}, {&point.y, &center.y}}) {
      ComplexBall moved;
      Magnitude length;
      acb_sub(moved.get(), now->get(), start->get(), precision_bits);
      acb_get_mag(length.get(), moved.get());
      if (mag_cmp_2exp_si(length.get(), std::ilogb(certificate.radius)) > 0) return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace eliminant::bridge
