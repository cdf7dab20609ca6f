// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include <eliminant/bridge/certificates/cylinder_direction_certificate.hpp>
#include <eliminant/numeric/fixed_degree_roots.hpp>

namespace eliminant::bridge {

namespace {

using Complex = std::complex<double>;
using numeric::ComplexDirection;
using numeric::plain_product;
using numeric::plain_quotient;
using numeric::SpaceVector;

/// Bounds the rounding errors of an evaluation, over the sum of the absolute coefficients.
constexpr double rounding = 0x1p-46;

/// Forms with a smaller sum of absolute coefficients are left to others. Above it value errors exceed 2^-246, far more
/// than the 2^-537 that squares of moduli can lose to underflow.
constexpr double smallest_form = 0x1p-200;

/// The modulus within a few units in the last place, or below 2^-500 within 2^-537.
double size(const Complex& z) { return std::sqrt(z.real() * z.real() + z.imag() * z.imag()); }

/// A form with middles and one bound for all that is uncertain in it.
template <std::size_t Count>
struct RoundedForm {
  std::array<double, Count> middle{};
  double sum = 0;          ///< of the absolute coefficients, from above
  double value_error = 0;  ///< of a value, from above

  explicit RoundedForm(const std::array<DoubleInterval, Count>& coefficients) {
    double radii = 0;
    for (std::size_t i = 0; i < Count; ++i) {
      const DoubleInterval& c = coefficients[i];
      middle[i] = c.lower + (c.upper - c.lower) / 2;
      radii += (c.upper - c.lower) / 2 + 0x1p-51 * c.magnitude();
      sum += c.magnitude();
    }
    sum *= 1 + 0x1p-45;
    value_error = (radii + rounding * sum) * (1 + 0x1p-45);
  }
};

struct Jet {
  Complex value;
  ComplexDirection gradient;
};

Jet conic_at(const std::array<double, 6>& q, const ComplexDirection& t) {
  const auto& [x, y, z] = t;
  const Complex dx = 2 * q[0] * x + q[1] * y + q[2] * z;
  const Complex dy = q[1] * x + 2 * q[3] * y + q[4] * z;
  const Complex dz = q[2] * x + q[4] * y + 2 * q[5] * z;
  return {(plain_product(x, dx) + plain_product(y, dy) + plain_product(z, dz)) / 2.0, {dx, dy, dz}};
}

Jet cubic_at(const std::array<double, 10>& c, const ComplexDirection& t) {
  const auto& [x, y, z] = t;
  const Complex xx = plain_product(x, x);
  const Complex xy = plain_product(x, y);
  const Complex xz = plain_product(x, z);
  const Complex yy = plain_product(y, y);
  const Complex yz = plain_product(y, z);
  const Complex zz = plain_product(z, z);
  const Complex dx = 3 * c[0] * xx + 2 * c[1] * xy + 2 * c[2] * xz + c[3] * yy + c[4] * yz + c[5] * zz;
  const Complex dy = c[1] * xx + 2 * c[3] * xy + c[4] * xz + 3 * c[6] * yy + 2 * c[7] * yz + c[8] * zz;
  const Complex dz = c[2] * xx + c[4] * xy + 2 * c[5] * xz + c[7] * yy + 2 * c[8] * yz + 3 * c[9] * zz;
  return {(plain_product(x, dx) + plain_product(y, dy) + plain_product(z, dz)) / 3.0, {dx, dy, dz}};
}

/// The Krawczyk test around one direction.
std::optional<CertifiedDirection> certify(const RoundedForm<6>& conic, const RoundedForm<10>& cubic,
                                          const ComplexDirection& direction) {
  CertifiedDirection result;
  result.center = direction;
  while (result.pivot < 3 && direction[result.pivot] != Complex(1)) ++result.pivot;
  if (result.pivot == 3) return std::nullopt;
  for (const Complex& coordinate : direction)
    if (!(std::norm(coordinate) <= 1 + 0x1p-49)) return std::nullopt;
  const std::size_t a = (result.pivot + 1) % 3;
  const std::size_t b = (result.pivot + 2) % 3;
  const Jet f = conic_at(conic.middle, direction);
  const Jet g = cubic_at(cubic.middle, direction);
  const Complex determinant = plain_product(f.gradient[a], g.gradient[b]) - plain_product(f.gradient[b], g.gradient[a]);
  const Complex scale = plain_quotient(1.0, determinant);
  // C, the approximate inverse of the Jacobian (f_a f_b; g_a g_b).
  const std::array<std::array<Complex, 2>, 2> inverse{
      {{plain_product(g.gradient[b], scale), -plain_product(f.gradient[b], scale)},
       {-plain_product(g.gradient[a], scale), plain_product(f.gradient[a], scale)}}};
  const std::array<std::array<Complex, 2>, 2> jacobian{
      {{f.gradient[a], f.gradient[b]}, {g.gradient[a], g.gradient[b]}}};
  double step = 0;
  for (const auto& row : inverse)
    step = std::max(
        step, size(row[0]) * (size(f.value) + conic.value_error) + size(row[1]) * (size(g.value) + cubic.value_error));
  result.radius = 2 * step * (1 + 0x1p-40) + std::numeric_limits<double>::min();
  if (!(result.radius < 0x1p-10)) return std::nullopt;  // also when it is no number
  // How far an entry of the Jacobian is from its value in the center, on all of the polydisc: 2 and 6 times the sum of
  // the coefficients bound the sums of the second derivatives there, up to (1 + radius)^2 < 1.01.
  const double conic_entry = 2 * conic.value_error + 2.02 * result.radius * conic.sum;
  const double cubic_entry = 3 * cubic.value_error + 6.06 * result.radius * cubic.sum;
  for (std::size_t i = 0; i < 2; ++i) {
    double row = 2 * (size(inverse[i][0]) * conic_entry + size(inverse[i][1]) * cubic_entry);
    for (std::size_t j = 0; j < 2; ++j) {
      const Complex entry = plain_product(inverse[i][0], jacobian[0][j]) + plain_product(inverse[i][1], jacobian[1][j]);
      row += size(entry - Complex(i == j ? 1 : 0));
      row += 0x1p-48 * (size(inverse[i][0]) * size(jacobian[0][j]) + size(inverse[i][1]) * size(jacobian[1][j]));
    }
    if (!(row <= 0.25)) return std::nullopt;
  }
  result.real = direction[0].imag() == 0 && direction[1].imag() == 0 && direction[2].imag() == 0;
  return result;
}

/// No direction within both polydiscs: a component of the cross product of the centers exceeds what the radii allow.
bool distinct(const CertifiedDirection& u, const ComplexDirection& v, double v_radius) {
  const double reach = 2.02 * (u.radius + v_radius) + 0x1p-46;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    if (size(plain_product(u.center[i], v[j]) - plain_product(u.center[j], v[i])) > reach) return true;
  }
  return false;
}

ComplexDirection conjugate(const ComplexDirection& t) { return {std::conj(t[0]), std::conj(t[1]), std::conj(t[2])}; }

bool all_distinct(const CertifiedDirections& directions) {
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const CertifiedDirection& u = directions[i];
    if (!u.real && !distinct(u, conjugate(u.center), u.radius)) return false;
    for (std::size_t j = i + 1; j < directions.size(); ++j) {
      const CertifiedDirection& v = directions[j];
      if (u.real != v.real) continue;  // one is proven to be real, the other not to be
      if (!distinct(u, v.center, v.radius)) return false;
      if (!u.real && !distinct(u, conjugate(v.center), v.radius)) return false;
    }
  }
  return true;
}

DoubleInterval square(const DoubleInterval& a) {
  const DoubleInterval product = a * a;
  return {std::max(product.lower, 0.0), product.upper};
}

}  // namespace

ScaledOffsets scaled_offsets(const std::array<std::array<double, 3>, 5>& points) {
  ScaledOffsets result;
  double largest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      result.offsets[k][i] = DoubleInterval(points[k + 1][i]) - DoubleInterval(points[0][i]);
      largest = std::max(largest, result.offsets[k][i].magnitude());
    }
  }
  // Scaling by a power of two is exact above the subnormal numbers, which the certificate leaves to others.
  if (!(largest > 0x1p-900 && largest < 0x1p900)) return result;
  result.scale_log2 = std::ilogb(largest) + 1;
  const double scale = std::ldexp(1.0, -result.scale_log2);
  for (auto& offset : result.offsets)
    for (DoubleInterval& d : offset) d = DoubleInterval::widened(d.lower * scale, d.upper * scale);
  return result;
}

std::optional<CertifiedDirections> certify_cylinder_directions(const ScaledOffsets& points) {
  std::array<SpaceVector<double>, 4> middles{};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      const DoubleInterval& d = points.offsets[k][i];
      middles[k][i] = d.lower + (d.upper - d.lower) / 2;
      if (!(std::fabs(middles[k][i]) <= 1)) return std::nullopt;
    }
  const std::array<DoubleInterval, 4> weights = numeric::offset_relation(points.offsets);
  std::size_t left_out = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (weights[k].magnitude() > weights[left_out].magnitude()) left_out = k;
  if (!weights[left_out].excludes_zero()) return std::nullopt;
  const auto forms = numeric::cylinder_direction_forms(points.offsets, weights, left_out);
  const RoundedForm<6> conic(forms.conic);
  const RoundedForm<10> cubic(forms.cubic);
  if (!(conic.sum > smallest_form && cubic.sum > smallest_form)) return std::nullopt;
  for (std::size_t frame = 0; frame < numeric::direction_frames; ++frame) {
    CertifiedDirections directions;
    std::size_t count = 0;
    bool proven = true;
    for (const ComplexDirection& candidate : numeric::cylinder_directions(middles, frame)) {
      const std::optional<CertifiedDirection> direction = certify(conic, cubic, candidate);
      proven = direction.has_value();
      if (!proven) break;
      directions.push_back(*direction);
      count += direction->real ? 1 : 2;
    }
    if (proven && count == 6 && all_distinct(directions)) return directions;
  }
  return std::nullopt;
}

EnclosedAxis enclose_axis(const ScaledOffsets& points, const CertifiedDirection& direction) {
  EnclosedAxis axis;
  SpaceVector<DoubleInterval>& t = axis.direction;
  for (std::size_t i = 0; i < 3; ++i)
    t[i] =
        i == direction.pivot ? DoubleInterval(1) : DoubleInterval::around(direction.center[i].real(), direction.radius);
  std::array<SpaceVector<DoubleInterval>, 4> turned;  // d_k x t
  for (std::size_t k = 0; k < 4; ++k) turned[k] = numeric::cross_product(points.offsets[k], t);
  std::pair<std::size_t, std::size_t> pair{0, 1};
  DoubleInterval best(0);
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const DoubleInterval determinant = numeric::dot_product(points.offsets[i], turned[j]);
      if (!(determinant.magnitude() > best.magnitude())) continue;
      best = determinant;
      pair = {i, j};
    }
  }
  const auto [i, j] = pair;
  const auto squared_length = [](const SpaceVector<DoubleInterval>& v) {
    return square(v[0]) + square(v[1]) + square(v[2]);
  };
  const DoubleInterval n_i = squared_length(turned[i]);
  const DoubleInterval n_j = squared_length(turned[j]);
  const DoubleInterval denominator = DoubleInterval(2) * (squared_length(t) * best);
  for (std::size_t k = 0; k < 3; ++k) axis.offset[k] = (n_i * turned[j][k] - n_j * turned[i][k]) / denominator;
  axis.radius_squared = squared_length(axis.offset);
  return axis;
}

}  // namespace eliminant::bridge
