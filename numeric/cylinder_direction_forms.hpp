// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace eliminant::numeric {

// Notation. p_1, ..., p_5 the points, d_k = p_(k+1) - p_1 the offsets, k = 1, ..., 4, t = (x, y, z) a direction,
// N_k(t) = |t x d_k|^2 = (t.t)(d_k.d_k) - (t.d_k)^2, D(a, b, c) = a . (b x c).

/// The directions of the cylinders through five points that do not all lie in a plane: the six common zeros, counted
/// with multiplicity, of
///   conic  sum_k w_k N_k(t), where sum_k w_k d_k = 0,
///   cubic  N_a (d_b x d_c).t + N_b (d_c x d_a).t + N_c (d_a x d_b).t  with D(d_a, d_b, d_c) = +-w_k not 0, k the index
///          left out.
/// The points seen along t lie on a circle through p_1 with the centre c when 2 (t.t) c.d_k = N_k for all k; the conic
/// says that the right-hand sides satisfy the relation of the left-hand sides, the cubic that c.t = 0 can be satisfied,
/// too. The cubic vanishes at the edges of the tetrahedron p_1, d_a, d_b, d_c, the conic does so only where the edge is
/// the direction of a cylinder. Source: the cubic is that of [BuseKhalilMourrain2005], section 5.3, without its choice
/// of coordinates; the conic is the combination of two such cubics that their common plane divides.
template <class Scalar>
struct CylinderDirectionForms {
  std::array<Scalar, 6> conic;   ///< of xx, xy, xz, yy, yz, zz
  std::array<Scalar, 10> cubic;  ///< of xxx, xxy, xxz, xyy, xyz, xzz, yyy, yyz, yzz, zzz
};

template <class Scalar>
using SpaceVector = std::array<Scalar, 3>;

template <class Scalar>
SpaceVector<Scalar> cross_product(const SpaceVector<Scalar>& a, const SpaceVector<Scalar>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Scalar>
Scalar dot_product(const SpaceVector<Scalar>& a, const SpaceVector<Scalar>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The weights w of sum_k w_k d_k = 0: signed volumes of the parallelepipeds of the other three offsets.
template <class Scalar>
std::array<Scalar, 4> offset_relation(const std::array<SpaceVector<Scalar>, 4>& offsets) {
  const SpaceVector<Scalar> first = cross_product(offsets[0], offsets[1]);
  const SpaceVector<Scalar> last = cross_product(offsets[2], offsets[3]);
  return {dot_product(offsets[1], last), -dot_product(offsets[0], last), dot_product(first, offsets[3]),
          -dot_product(first, offsets[2])};
}

/// |t x d|^2 as a quadratic form in t.
template <class Scalar>
std::array<Scalar, 6> squared_distance_form(const SpaceVector<Scalar>& d) {
  const Scalar xx = d[0] * d[0];
  const Scalar yy = d[1] * d[1];
  const Scalar zz = d[2] * d[2];
  const Scalar xy = -(d[0] * d[1]);
  const Scalar xz = -(d[0] * d[2]);
  const Scalar yz = -(d[1] * d[2]);
  return {yy + zz, xy + xy, xz + xz, xx + zz, yz + yz, xx + yy};
}

/// cubic += quadratic * (linear . t).
template <class Scalar>
void add_product(const std::array<Scalar, 6>& q, const SpaceVector<Scalar>& linear, std::array<Scalar, 10>& cubic) {
  const auto& [a, b, c] = linear;
  cubic[0] = cubic[0] + q[0] * a;
  cubic[1] = cubic[1] + (q[0] * b + q[1] * a);
  cubic[2] = cubic[2] + (q[0] * c + q[2] * a);
  cubic[3] = cubic[3] + (q[1] * b + q[3] * a);
  cubic[4] = cubic[4] + (q[1] * c + q[2] * b + q[4] * a);
  cubic[5] = cubic[5] + (q[2] * c + q[5] * a);
  cubic[6] = cubic[6] + q[3] * b;
  cubic[7] = cubic[7] + (q[3] * c + q[4] * b);
  cubic[8] = cubic[8] + (q[4] * c + q[5] * b);
  cubic[9] = cubic[9] + q[5] * c;
}

/// Both forms, the cubic without the offset `left_out`, whose weight should be the largest. Scalar may be an interval.
template <class Scalar>
CylinderDirectionForms<Scalar> cylinder_direction_forms(const std::array<SpaceVector<Scalar>, 4>& offsets,
                                                        const std::array<Scalar, 4>& weights, std::size_t left_out) {
  CylinderDirectionForms<Scalar> forms{};
  std::array<std::array<Scalar, 6>, 4> distances;
  for (std::size_t k = 0; k < 4; ++k) {
    distances[k] = squared_distance_form(offsets[k]);
    for (std::size_t i = 0; i < 6; ++i) forms.conic[i] = forms.conic[i] + weights[k] * distances[k][i];
  }
  const std::size_t a = (left_out + 1) % 4;
  const std::size_t b = (left_out + 2) % 4;
  const std::size_t c = (left_out + 3) % 4;
  add_product(distances[a], cross_product(offsets[b], offsets[c]), forms.cubic);
  add_product(distances[b], cross_product(offsets[c], offsets[a]), forms.cubic);
  add_product(distances[c], cross_product(offsets[a], offsets[b]), forms.cubic);
  return forms;
}

}  // namespace eliminant::numeric
