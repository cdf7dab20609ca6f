// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/bridge/certificates/krawczyk_test.hpp>

namespace eliminant::bridge {

namespace {

/// A 2 x 2 matrix of complex balls, row by row.
struct BallMatrix {
  ComplexBall a, b, c, d;
};

/// Replaces a ball by its midpoint.
void drop_radius(ComplexBall& z) { acb_get_mid(z.get(), z.get()); }

/// An approximate inverse of the Jacobian at one point, exact numbers; nullopt when its determinant may be zero.
std::optional<BallMatrix> approximate_inverse(const BallJet& p, const BallJet& q, long precision_bits) {
  ComplexBall determinant;
  ComplexBall product;
  acb_mul(determinant.get(), p.dx.get(), q.dy.get(), precision_bits);
  acb_mul(product.get(), p.dy.get(), q.dx.get(), precision_bits);
  acb_sub(determinant.get(), determinant.get(), product.get(), precision_bits);
  drop_radius(determinant);
  if (acb_is_zero(determinant.get())) return std::nullopt;
  BallMatrix inverse{q.dy, p.dy, q.dx, p.dx};
  acb_neg(inverse.b.get(), inverse.b.get());
  acb_neg(inverse.c.get(), inverse.c.get());
  for (ComplexBall* entry : {&inverse.a, &inverse.b, &inverse.c, &inverse.d}) {
    drop_radius(*entry);
    acb_div(entry->get(), entry->get(), determinant.get(), precision_bits);
    drop_radius(*entry);
    if (!acb_is_finite(entry->get())) return std::nullopt;
  }
  return inverse;
}

/// u v + w z.
ComplexBall inner_product(const ComplexBall& u, const ComplexBall& v, const ComplexBall& w, const ComplexBall& z,
                          long precision_bits) {
  ComplexBall sum;
  acb_mul(sum.get(), u.get(), v.get(), precision_bits);
  acb_addmul(sum.get(), w.get(), z.get(), precision_bits);
  return sum;
}

PlaneBall midpoint(const PlaneBall& box) { return {midpoint(box.x), midpoint(box.y)}; }

/// |u| + |v| < 1, proven.
bool row_sum_below_one(const ComplexBall& u, const ComplexBall& v) {
  Magnitude sum;
  Magnitude term;
  acb_get_mag(sum.get(), u.get());
  acb_get_mag(term.get(), v.get());
  mag_add(sum.get(), sum.get(), term.get());
  return mag_cmp_2exp_si(sum.get(), 0) < 0;
}

/// What stands for log2 0.
constexpr long no_magnitude = -(1L << 40);

/// An upper bound of log2 |z|; no_magnitude for zero.
long magnitude_log2(const ComplexBall& z) {
  Magnitude magnitude;
  acb_get_mag(magnitude.get(), z.get());
  if (mag_is_special(magnitude.get()) == 0) return static_cast<long>(fmpz_get_si(MAG_EXPREF(magnitude.get())));
  return mag_is_inf(magnitude.get()) ? 1L << 40 : no_magnitude;
}

/// The square box of half-width 2^radius_log2 around an exact point.
PlaneBall inflate(const PlaneBall& point, long radius_log2) {
  PlaneBall box = point;
  for (ComplexBall* coordinate : {&box.x, &box.y}) {
    arb_add_error_2exp_si(coordinate->real(), radius_log2);
    arb_add_error_2exp_si(coordinate->imaginary(), radius_log2);
  }
  return box;
}

long radius_log2(const PlaneBall& box) {
  ComplexBall radius;
  long result = no_magnitude;
  for (const ComplexBall* coordinate : {&box.x, &box.y}) {
    arb_get_rad_arb(radius.real(), coordinate->real());
    arb_get_rad_arb(radius.imaginary(), coordinate->imaginary());
    result = std::max(result, magnitude_log2(radius));
  }
  return result;
}

PlaneBall conjugate(const PlaneBall& box) {
  PlaneBall result = box;
  acb_conj(result.x.get(), result.x.get());
  acb_conj(result.y.get(), result.y.get());
  return result;
}

/// A square box around both, with room for the Krawczyk test on all sides: the test sees no difference between the
/// directions, so a box narrower in one than its own width times the second derivatives would fail.
PlaneBall square_hull(const PlaneBall& a, const PlaneBall& b, long precision_bits) {
  PlaneBall hull;
  acb_union(hull.x.get(), a.x.get(), b.x.get(), precision_bits);
  acb_union(hull.y.get(), a.y.get(), b.y.get(), precision_bits);
  return inflate(midpoint(hull), radius_log2(hull) + 1);
}

/// The Krawczyk test on a box around both, at a precision at which rounding is small beside its radius.
bool hull_has_one_zero(const BallCurve& p, const BallCurve& q, const PlaneBall& a, const PlaneBall& b) {
  const long radius = std::max(radius_log2(a), radius_log2(b));
  if (radius == no_magnitude)  // two exact points
    return acb_equal(a.x.get(), b.x.get()) != 0 && acb_equal(a.y.get(), b.y.get()) != 0;
  const long size = std::max({0L, magnitude_log2(a.x), magnitude_log2(a.y)});
  const long precision_bits = std::max(128L, 2 * (size - radius) + 64);
  return krawczyk_test(p, q, square_hull(a, b, precision_bits), precision_bits).has_value();
}

}  // namespace

std::optional<PlaneBall> krawczyk_test(const BallCurve& p, const BallCurve& q, const PlaneBall& box,
                                       long precision_bits) {
  const PlaneBall m = midpoint(box);
  const BallJet p_at_m = p.jet(m, precision_bits);
  const BallJet q_at_m = q.jet(m, precision_bits);
  const std::optional<BallMatrix> inverse = approximate_inverse(p_at_m, q_at_m, precision_bits);
  if (!inverse) return std::nullopt;
  const BallMatrix& c = *inverse;
  const BallSlopes p_on_box = p.slopes_on(box, precision_bits);
  const BallSlopes q_on_box = q.slopes_on(box, precision_bits);
  // E = I - C J(X).
  BallMatrix e{inner_product(c.a, p_on_box.dx, c.b, q_on_box.dx, precision_bits),
               inner_product(c.a, p_on_box.dy, c.b, q_on_box.dy, precision_bits),
               inner_product(c.c, p_on_box.dx, c.d, q_on_box.dx, precision_bits),
               inner_product(c.c, p_on_box.dy, c.d, q_on_box.dy, precision_bits)};
  acb_sub_si(e.a.get(), e.a.get(), 1, precision_bits);
  acb_sub_si(e.d.get(), e.d.get(), 1, precision_bits);
  for (ComplexBall* entry : {&e.a, &e.b, &e.c, &e.d}) acb_neg(entry->get(), entry->get());
  if (!row_sum_below_one(e.a, e.b) || !row_sum_below_one(e.c, e.d)) return std::nullopt;

  PlaneBall offset;  // X - m
  acb_sub(offset.x.get(), box.x.get(), m.x.get(), precision_bits);
  acb_sub(offset.y.get(), box.y.get(), m.y.get(), precision_bits);
  PlaneBall image{inner_product(e.a, offset.x, e.b, offset.y, precision_bits),
                  inner_product(e.c, offset.x, e.d, offset.y, precision_bits)};
  const ComplexBall step_x = inner_product(c.a, p_at_m.value, c.b, q_at_m.value, precision_bits);
  const ComplexBall step_y = inner_product(c.c, p_at_m.value, c.d, q_at_m.value, precision_bits);
  acb_sub(image.x.get(), image.x.get(), step_x.get(), precision_bits);
  acb_sub(image.y.get(), image.y.get(), step_y.get(), precision_bits);
  acb_add(image.x.get(), image.x.get(), m.x.get(), precision_bits);
  acb_add(image.y.get(), image.y.get(), m.y.get(), precision_bits);
  if (!acb_contains(box.x.get(), image.x.get()) || !acb_contains(box.y.get(), image.y.get())) return std::nullopt;
  return image;
}

std::optional<NewtonStep> newton_step(const BallCurve& p, const BallCurve& q, const PlaneBall& point,
                                      long precision_bits) {
  const PlaneBall m = midpoint(point);
  const BallJet p_at_m = p.jet(m, precision_bits);
  const BallJet q_at_m = q.jet(m, precision_bits);
  const std::optional<BallMatrix> inverse = approximate_inverse(p_at_m, q_at_m, precision_bits);
  if (!inverse) return std::nullopt;
  PlaneBall step{inner_product(inverse->a, p_at_m.value, inverse->b, q_at_m.value, precision_bits),
                 inner_product(inverse->c, p_at_m.value, inverse->d, q_at_m.value, precision_bits)};
  const long noise_log2 = radius_log2(step);
  drop_radius(step.x);
  drop_radius(step.y);
  NewtonStep result{m, std::max(magnitude_log2(step.x), magnitude_log2(step.y)), noise_log2};
  acb_sub(result.point.x.get(), m.x.get(), step.x.get(), precision_bits);
  acb_sub(result.point.y.get(), m.y.get(), step.y.get(), precision_bits);
  drop_radius(result.point.x);
  drop_radius(result.point.y);
  if (!acb_is_finite(result.point.x.get()) || !acb_is_finite(result.point.y.get())) return std::nullopt;
  return result;
}

std::optional<SimpleZero> enclose_simple_zero(const BallCurve& p, const BallCurve& q, const PlaneBall& start,
                                              long target_log2, long max_precision_bits, long first_precision_bits) {
  PlaneBall point = midpoint(start);
  const long size_log2 = std::max({0L, magnitude_log2(point.x), magnitude_log2(point.y)});
  // Rounding loses some bits in the evaluation: start with room for them.
  long precision_bits = std::max(first_precision_bits, size_log2 - target_log2 + 40);
  for (; precision_bits <= max_precision_bits; precision_bits *= 2) {
    // Newton's method doubles the digits: low precision first, the full one for the last steps.
    long working = std::min(precision_bits, std::max(128L, first_precision_bits));
    for (int step = 0; step < 60; ++step) {
      const std::optional<NewtonStep> next = newton_step(p, q, point, working);
      if (!next) return std::nullopt;
      point = next->point;
      if (working < precision_bits && next->step_log2 < size_log2 - working / 4)
        working = std::min(precision_bits, working * 2);
      else if (working == precision_bits && next->step_log2 < target_log2 - 4)
        break;
    }
    const std::optional<NewtonStep> check = newton_step(p, q, point, precision_bits);
    if (!check) return std::nullopt;
    const long floor_log2 = std::max(size_log2 - precision_bits + 16, check->noise_log2 + 2);
    for (const long radius :
         {std::max(check->step_log2 + 2, floor_log2), std::max(check->step_log2 + 8, floor_log2 + 8)}) {
      const PlaneBall region = inflate(point, radius);
      const std::optional<PlaneBall> image = krawczyk_test(p, q, region, precision_bits);
      if (image && radius_log2(*image) <= target_log2) return SimpleZero{region, *image};
    }
  }
  return std::nullopt;
}

std::optional<SimpleZero> refine_simple_zero(const BallCurve& p, const BallCurve& q, const PlaneBall& region,
                                             long target_log2, long max_precision_bits) {
  SimpleZero zero{region, region};
  const long size_log2 = std::max({0L, magnitude_log2(region.x), magnitude_log2(region.y)});
  const auto in_region = [&](const PlaneBall& box) {
    return acb_contains(zero.region.x.get(), box.x.get()) != 0 && acb_contains(zero.region.y.get(), box.y.get()) != 0;
  };
  // Near another zero a step computed with too few bits leads to that one: enough bits for the size of the region, more
  // if a step leaves its surroundings.
  const auto near_region = [&](const PlaneBall& point) {
    const PlaneBall square = inflate(midpoint(zero.region), radius_log2(zero.region) + 1);
    return acb_overlaps(square.x.get(), point.x.get()) != 0 && acb_overlaps(square.y.get(), point.y.get()) != 0;
  };
  long precision_bits = std::max(96L, 2 * (size_log2 - radius_log2(region)) + 32);
  for (; radius_log2(zero.box) > target_log2; precision_bits *= 2) {
    if (precision_bits > max_precision_bits) return std::nullopt;
    PlaneBall point = midpoint(zero.box);
    constexpr int max_steps = 60;
    std::optional<NewtonStep> step;
    for (int count = 0; count < max_steps; ++count) {
      step = newton_step(p, q, point, precision_bits);
      if (!step || !near_region(step->point)) break;
      point = step->point;
      if (step->step_log2 <= std::max({target_log2 - 4, step->noise_log2, size_log2 - precision_bits + 8})) break;
    }
    if (!step || !near_region(step->point)) continue;
    const long floor_log2 = std::max(size_log2 - precision_bits + 16, step->noise_log2 + 2);
    for (const long radius :
         {std::max(step->step_log2 + 2, floor_log2), std::max(step->step_log2 + 8, floor_log2 + 8)}) {
      const PlaneBall square = inflate(point, radius);
      const std::optional<PlaneBall> image = krawczyk_test(p, q, square, precision_bits);
      if (!image || !in_region(*image)) continue;
      zero = {square, *image};
      break;
    }
  }
  return zero;
}

bool zero_is_real(const BallCurve& p, const BallCurve& q, const PlaneBall& box) {
  return hull_has_one_zero(p, q, box, conjugate(box));
}

bool enclose_same_zero(const BallCurve& p, const BallCurve& q, const PlaneBall& a, const PlaneBall& b) {
  return hull_has_one_zero(p, q, a, b);
}

}  // namespace eliminant::bridge
