// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include <eliminant/numeric/cylinder_through_points.hpp>
#include <eliminant/numeric/fixed_degree_roots.hpp>

namespace eliminant::numeric {

namespace {

using Complex = std::complex<double>;
using Offsets = std::array<SpaceVector<double>, 4>;

/// The rotation of a quaternion.
constexpr std::array<SpaceVector<double>, 3> rotation(double a, double b, double c, double d) {
  const double n = a * a + b * b + c * c + d * d;
  return {{{(a * a + b * b - c * c - d * d) / n, 2 * (b * c - a * d) / n, 2 * (b * d + a * c) / n},
           {2 * (b * c + a * d) / n, (a * a - b * b + c * c - d * d) / n, 2 * (c * d - a * b) / n},
           {2 * (b * d - a * c) / n, 2 * (c * d + a * b) / n, (a * a - b * b - c * c + d * d) / n}}};
}

/// No simple direction is near an axis or a coordinate plane of any of them.
constexpr std::array<std::array<SpaceVector<double>, 3>, direction_frames> frames{
    rotation(7, 2, -3, 5), rotation(5, -6, 1, 3), rotation(4, 7, 6, -3)};

/// A conic and a cubic in the plane z = 1.
struct PlaneForms {
  std::array<double, 6> conic;
  std::array<double, 10> cubic;

  struct Jet {
    Complex value, dx, dy;
  };
  Jet conic_at(const Complex& x, const Complex& y) const {
    const auto& [xx, xy, xz, yy, yz, zz] = conic;
    const Complex in_x = xx * x + xy * y + xz;
    const Complex in_y = yy * y + yz;
    return {plain_product(in_x, x) + plain_product(in_y, y) + zz, in_x + xx * x, xy * x + in_y + yy * y};
  }
  Jet cubic_at(const Complex& x, const Complex& y) const {
    const std::array<double, 10>& c = cubic;
    // By powers of y: c0 + y (c1 + y (c2 + y c3)).
    const Complex c0 = plain_product(plain_product(c[0] * x + c[2], x) + c[5], x) + c[9];
    const Complex c0_dx = plain_product(3 * c[0] * x + 2 * c[2], x) + c[5];
    const Complex c1 = plain_product(c[1] * x + c[4], x) + c[8];
    const Complex c1_dx = 2 * c[1] * x + c[4];
    const Complex c2 = c[3] * x + c[7];
    const Complex inner = c[6] * y + c2;
    const Complex middle = plain_product(inner, y) + c1;
    return {plain_product(middle, y) + c0, plain_product(c[3] * y + c1_dx, y) + c0_dx,
            middle + plain_product(inner + c[6] * y, y)};
  }
};

/// The sextic in x, ascending, and A, B of y = -B / A.
struct Elimination {
  std::array<double, 7> sextic{};
  std::array<double, 3> a{};
  std::array<double, 4> b{};
};

template <std::size_t M, std::size_t N>
std::array<double, M + N - 1> product(const std::array<double, M>& f, const std::array<double, N>& g) {
  std::array<double, M + N - 1> result{};
  for (std::size_t i = 0; i < M; ++i)
    for (std::size_t j = 0; j < N; ++j) result[i + j] += f[i] * g[j];
  return result;
}

/// With y^2 = -q_1 y - q_0 on the conic the cubic is A y + B, and its norm B^2 - q_1 A B + q_0 A^2.
Elimination eliminate_y(const PlaneForms& forms) {
  const auto& [xx, xy, xz, yy, yz, zz] = forms.conic;
  const std::array<double, 10>& c = forms.cubic;
  const std::array<double, 2> q1{yz / yy, xy / yy};
  const std::array<double, 3> q0{zz / yy, xz / yy, xx / yy};
  const std::array<double, 2> f2{c[7], c[3]};
  Elimination result;
  const auto q1q1 = product(q1, q1);
  const auto q1q0 = product(q1, q0);
  const auto f2q1 = product(f2, q1);
  const auto f2q0 = product(f2, q0);
  result.a = {c[8], c[4], c[1]};
  result.b = {c[9], c[5], c[2], c[0]};
  for (std::size_t i = 0; i < 3; ++i) result.a[i] += c[6] * (q1q1[i] - q0[i]) - f2q1[i];
  for (std::size_t i = 0; i < 4; ++i) result.b[i] += c[6] * q1q0[i] - f2q0[i];
  const auto bb = product(result.b, result.b);
  const auto ab = product(q1, product(result.a, result.b));
  const auto aa = product(q0, product(result.a, result.a));
  for (std::size_t i = 0; i < 7; ++i) result.sextic[i] = bb[i] - ab[i] + aa[i];
  return result;
}

template <std::size_t N>
Complex value_at(const std::array<double, N>& f, const Complex& x) {
  Complex value = f[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) value = plain_product(value, x) + f[k];
  return value;
}

/// Two or three steps of Newton's iteration; false when it left the numbers.
bool polish(const PlaneForms& forms, Complex& x, Complex& y) {
  for (int step = 0; step < 3; ++step) {
    const PlaneForms::Jet f = forms.conic_at(x, y);
    const PlaneForms::Jet g = forms.cubic_at(x, y);
    const Complex determinant = plain_product(f.dx, g.dy) - plain_product(f.dy, g.dx);
    const Complex dx = plain_quotient(plain_product(f.value, g.dy) - plain_product(f.dy, g.value), determinant);
    const Complex dy = plain_quotient(plain_product(f.dx, g.value) - plain_product(f.value, g.dx), determinant);
    x -= dx;
    y -= dy;
    // The next step would be below the rounding error.
    if (std::norm(dx) + std::norm(dy) < 1e-17 * (1 + std::norm(x) + std::norm(y))) break;
  }
  return std::isfinite(std::norm(x) + std::norm(y));
}

/// Of an approximate root: nearer to its conjugate than the error of a double root.
bool nearly_real(const Complex& x) { return std::fabs(x.imag()) <= 1e-7 * (1 + std::fabs(x.real())); }

/// R^t (x, y, 1) with the axes of y and the fixed coordinate exchanged as `order` says, over its largest coordinate.
ComplexDirection rotated_back(const std::array<SpaceVector<double>, 3>& frame, const std::array<std::size_t, 3>& order,
                              const Complex& x, const Complex& y) {
  ComplexDirection turned{};
  for (std::size_t j = 0; j < 3; ++j) turned[j] = frame[order[0]][j] * x + frame[order[1]][j] * y + frame[order[2]][j];
  std::size_t largest = 0;
  for (std::size_t j = 1; j < 3; ++j)
    if (std::norm(turned[j]) > std::norm(turned[largest])) largest = j;
  const Complex scale = plain_quotient(1.0, turned[largest]);
  for (std::size_t j = 0; j < 3; ++j) turned[j] = j == largest ? Complex(1) : plain_product(turned[j], scale);
  return turned;
}

}  // namespace

AtMostSix<ComplexDirection> cylinder_directions(const std::array<std::array<double, 3>, 4>& offsets,
                                                std::size_t frame) {
  AtMostSix<ComplexDirection> directions;
  double size = 0;
  for (const auto& d : offsets)
    for (const double coordinate : d) size = std::max(size, std::fabs(coordinate));
  if (!(size > 0) || !std::isfinite(size)) return directions;
  Offsets turned{};
  for (std::size_t k = 0; k < 4; ++k) {
    const SpaceVector<double> d{offsets[k][0] / size, offsets[k][1] / size, offsets[k][2] / size};
    for (std::size_t i = 0; i < 3; ++i) turned[k][i] = dot_product(frames[frame][i], d);
  }
  const std::array<double, 4> weights = offset_relation(turned);
  std::size_t left_out = 0;
  for (std::size_t k = 1; k < 4; ++k)
    if (std::fabs(weights[k]) > std::fabs(weights[left_out])) left_out = k;
  // y is the coordinate whose axis is farthest from the conic.
  const CylinderDirectionForms<double> seen = cylinder_direction_forms(turned, weights, left_out);
  const std::array<double, 3> squares{std::fabs(seen.conic[0]), std::fabs(seen.conic[3]), std::fabs(seen.conic[5])};
  const auto largest = static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const std::array<std::size_t, 3> order{(largest + 2) % 3, largest, (largest + 1) % 3};
  Offsets ordered{};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < 3; ++i) ordered[k][i] = turned[k][order[i]];
  const auto [conic, cubic] = cylinder_direction_forms(ordered, weights, left_out);
  const PlaneForms forms{conic, cubic};
  const Elimination elimination = eliminate_y(forms);
  if (elimination.sextic[6] == 0 || !std::isfinite(elimination.sextic[6])) return directions;

  AtMostSix<ComplexDirection> not_real;
  for (const Complex& root : fixed_degree_roots<6>(elimination.sextic, 60)) {
    const bool real = nearly_real(root);
    if (!real && root.imag() < 0) continue;
    Complex x = real ? Complex(root.real()) : root;
    Complex y = -plain_quotient(value_at(elimination.b, x), value_at(elimination.a, x));
    if (!polish(forms, x, y)) continue;
    (real ? directions : not_real).push_back(rotated_back(frames[frame], order, x, y));
  }
  for (const ComplexDirection& direction : not_real) directions.push_back(direction);
  return directions;
}

SpaceVector<double> axis_offset(const Offsets& offsets, const SpaceVector<double>& t) {
  std::array<SpaceVector<double>, 4> turned{};  // d_k x t
  for (std::size_t k = 0; k < 4; ++k) turned[k] = cross_product(offsets[k], t);
  double best = 0;
  std::pair<std::size_t, std::size_t> pair{0, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double determinant = dot_product(offsets[i], turned[j]);
      if (std::fabs(determinant) > std::fabs(best)) {
        best = determinant;
        pair = {i, j};
      }
    }
  }
  const auto [i, j] = pair;
  const double n_i = dot_product(turned[i], turned[i]);
  const double n_j = dot_product(turned[j], turned[j]);
  const double denominator = 2 * dot_product(t, t) * best;
  SpaceVector<double> c{};
  for (std::size_t k = 0; k < 3; ++k) c[k] = (n_i * turned[j][k] - n_j * turned[i][k]) / denominator;
  return c;
}

AtMostSix<Cylinder> real_cylinders_through(const std::array<std::array<double, 3>, 5>& points) {
  Offsets offsets{};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < 3; ++i) offsets[k][i] = points[k + 1][i] - points[0][i];
  AtMostSix<Cylinder> cylinders;
  for (const ComplexDirection& direction : cylinder_directions(offsets)) {
    if (direction[0].imag() != 0 || direction[1].imag() != 0 || direction[2].imag() != 0) continue;
    SpaceVector<double> t{direction[0].real(), direction[1].real(), direction[2].real()};
    const double length = std::sqrt(dot_product(t, t));
    for (double& coordinate : t) coordinate /= length;
    const SpaceVector<double> c = axis_offset(offsets, t);
    const double radius = std::sqrt(dot_product(c, c));
    if (!std::isfinite(radius)) continue;
    cylinders.push_back({t, {points[0][0] + c[0], points[0][1] + c[1], points[0][2] + c[2]}, radius});
  }
  return cylinders;
}

}  // namespace eliminant::numeric
