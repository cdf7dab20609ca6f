// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/certificates/krawczyk_system.hpp>

#include <eliminant/bridge/enclosures/ball_matrix.hpp>

namespace eliminant::bridge {

namespace {

std::vector<ComplexBall> midpoints(const std::vector<ComplexBall>& box) {
  std::vector<ComplexBall> result;
  for (const ComplexBall& z : box) result.push_back(midpoint(z));
  return result;
}

/// An approximate inverse, exact entries; false when there is none.
bool invert(const std::vector<std::vector<ComplexBall>>& jacobian, BallMatrix& inverse, long precision_bits) {
  BallMatrix middle(jacobian);
  middle.drop_radii();
  if (acb_mat_approx_inv(inverse.get(), middle.get(), precision_bits) == 0) return false;
  inverse.drop_radii();
  return true;
}

}  // namespace

std::optional<std::vector<ComplexBall>> enclose_system_zero(const System& system, const std::vector<ComplexBall>& start,
                                                            long precision_bits, int newton_steps) {
  const std::size_t n = start.size();
  std::vector<ComplexBall> z = midpoints(start);
  BallMatrix inverse(n, n);
  BallMatrix step(n, 1);
  for (int i = 0; i < newton_steps; ++i) {
    const SystemValue at = system(z, precision_bits);
    if (!invert(at.jacobian, inverse, precision_bits)) return std::nullopt;
    acb_mat_mul(step.get(), inverse.get(), BallMatrix(at.values).get(), precision_bits);
    for (std::size_t k = 0; k < n; ++k) {
      acb_sub(z[k].get(), z[k].get(), step.entry(k, 0), precision_bits);
      if (acb_is_finite(z[k].get()) == 0) return std::nullopt;
      z[k] = midpoint(z[k]);
    }
  }
  const SystemValue at = system(z, precision_bits);
  if (!invert(at.jacobian, inverse, precision_bits)) return std::nullopt;
  acb_mat_mul(step.get(), inverse.get(), BallMatrix(at.values).get(), precision_bits);
  Magnitude radius;
  Magnitude size;
  for (std::size_t k = 0; k < n; ++k) {
    acb_get_mag(size.get(), step.entry(k, 0));
    mag_max(radius.get(), radius.get(), size.get());
    acb_get_mag(size.get(), z[k].get());
    mag_mul_2exp_si(size.get(), size.get(), 16 - precision_bits);
    mag_max(radius.get(), radius.get(), size.get());
  }
  // Where all coordinates of an exact zero are 0.
  if (mag_is_zero(radius.get()) != 0) mag_set_ui_2exp_si(radius.get(), 1, -precision_bits);
  // The zero is about one step away; a wider box proves more, as long as the derivatives vary little.
  for (const long widening : {12L, 4L, 1L}) {
    Magnitude reach;
    mag_mul_2exp_si(reach.get(), radius.get(), widening);
    std::vector<ComplexBall> box = z;
    BallMatrix offset(n, 1);
    for (std::size_t k = 0; k < n; ++k) {
      acb_add_error_mag(box[k].get(), reach.get());
      acb_add_error_mag(offset.entry(k, 0), reach.get());
    }
    BallMatrix slope(n, n);
    acb_mat_mul(slope.get(), inverse.get(), BallMatrix(system(box, precision_bits).jacobian).get(), precision_bits);
    BallMatrix identity(n, n);
    acb_mat_one(identity.get());
    acb_mat_sub(slope.get(), identity.get(), slope.get(), precision_bits);
    BallMatrix image(n, 1);
    acb_mat_mul(image.get(), slope.get(), offset.get(), precision_bits);
    acb_mat_sub(image.get(), image.get(), step.get(), precision_bits);
    bool inside = true;
    for (std::size_t k = 0; k < n; ++k) {
      acb_add(image.entry(k, 0), image.entry(k, 0), z[k].get(), precision_bits);
      inside = inside && acb_contains_interior(box[k].get(), image.entry(k, 0)) != 0;
    }
    if (!inside) continue;
    std::vector<ComplexBall> result;
    for (std::size_t k = 0; k < n; ++k) result.emplace_back(image.entry(k, 0));
    return result;
  }
  return std::nullopt;
}

}  // namespace eliminant::bridge
