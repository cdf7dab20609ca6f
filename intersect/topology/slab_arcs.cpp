// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/topology/slab_arcs.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/base/error.hpp>

namespace eliminant::intersect {

namespace {

using bridge::RationalFibre;
using bridge::RealBall;
using symbolic::Rational;

constexpr long point_bits = 64;
constexpr int samples_in_slab = 17;

Rational rational_of(double value) {
  arf_t exact;
  arf_init(exact);
  arf_set_d(exact, value);
  Rational result;
  arf_get_fmpq(result.get(), exact);
  arf_clear(exact);
  return result;
}

Rational rational_of(arf_srcptr value) {
  Rational result;
  arf_get_fmpq(result.get(), value);
  return result;
}

/// An end of a ball, exactly: events may be closer than any number of bits.
Rational end_of(const RealBall& ball, bool upper) {
  RealBall radius;
  arb_get_rad_arb(radius.get(), ball.get());
  const Rational middle = rational_of(arb_midref(ball.get()));
  const Rational reach = rational_of(arb_midref(radius.get()));
  return upper ? middle + reach : middle - reach;
}

/// A multiple of a power of two between two numbers, as short as that can be, at about this part of the way.
Rational short_number_between(const Rational& lower, const Rational& upper, double part) {
  const Rational length = upper - lower;
  const Rational wanted = lower + length * rational_of(part);
  // Distances of neighbours are at least a thousandth of the whole.
  const Rational tolerance = length / Rational(1L << 14);
  Rational unit(1);
  while (tolerance < unit) unit = unit / Rational(2);
  const Rational quotient = wanted / unit;
  symbolic::Integer floor;
  fmpz_fdiv_q(floor.get(), fmpq_numref(quotient.get()), fmpq_denref(quotient.get()));
  const Rational rounded = Rational(floor) * unit;
  return lower < rounded && rounded < upper ? rounded : wanted;
}

}  // namespace

SlabSampler::SlabSampler(const symbolic::ReducedCurve& curve, const std::optional<Box>& box, const Context& context)
    : g_(symbolic::hide_variable(curve.rest, 0)), box_(box), context_(context) {}

double SlabSampler::nearest(const RealBall& value) {
  const double result = arf_get_d(arb_midref(value.get()), ARF_RND_NEAR);
  RealBall difference;
  arf_set_d(arb_midref(difference.get()), result);
  arb_sub(difference.get(), value.get(), difference.get(), 2 * point_bits);
  bridge::Magnitude bound;
  arb_get_mag(bound.get(), difference.get());
  error_ = std::max(error_, mag_get_d(bound.get()));
  return result;
}

std::array<double, 2> SlabSampler::nearest(const RealBall& x, const RealBall& y) { return {nearest(x), nearest(y)}; }

SlabArcs SlabSampler::between(const EventFibre* before, const EventFibre* after, double width) {
  std::vector<Rational> abscissae;
  if (before == nullptr && after == nullptr) {
    for (int i = 0; i < samples_in_slab; ++i)
      abscissae.push_back(rational_of(width * (static_cast<double>(i) / ((samples_in_slab - 1) / 2) - 1)));
    return arcs_at(abscissae, Rational(0));
  }
  if (before != nullptr && after != nullptr) {
    const Rational lower = end_of(before->x, true);
    const Rational upper = end_of(after->x, false);
    for (int i = 0; i < samples_in_slab; ++i) {
      const double angle = std::acos(-1.0) * (i + 0.5) / samples_in_slab;
      abscissae.push_back(short_number_between(lower, upper, (1 - std::cos(angle)) / 2));
    }
    return arcs_at(abscissae, before->after);
  }
  const bool to_the_left = before == nullptr;
  const Rational end = to_the_left ? end_of(after->x, false) : end_of(before->x, true);
  const Rational far = to_the_left ? end - rational_of(width) : end + rational_of(width);
  for (int i = 0; i < samples_in_slab; ++i) {
    const double part = std::pow((i + 0.5) / samples_in_slab, 2);
    abscissae.push_back(to_the_left ? short_number_between(far, end, 1 - part) : short_number_between(end, far, part));
  }
  if (to_the_left) std::reverse(abscissae.begin(), abscissae.end());
  return arcs_at(abscissae, to_the_left ? after->before : before->after);
}

SlabArcs SlabSampler::arcs_at(const std::vector<Rational>& abscissae, const Rational& safe) {
  SlabArcs arcs;
  RationalFibre inner(g_, safe, context_);
  arcs.count = inner.count();
  for (std::size_t i = 0; i < arcs.count; ++i) arcs.places.push_back(place_of(inner, i, box_));
  arcs.polylines.resize(arcs.count);
  if (std::none_of(arcs.places.begin(), arcs.places.end(), is_inside)) return arcs;
  for (const Rational& x : abscissae) {
    context_.checkpoint("tracing arcs");
    RationalFibre fibre(g_, x, context_);
    if (fibre.count() != arcs.count) throw PrecisionExhausted("the number of arcs changes between two events");
    const RealBall exact_x(x, 4 * point_bits);
    for (std::size_t i = 0; i < arcs.count; ++i)
      if (is_inside(arcs.places[i])) arcs.polylines[i].push_back(nearest(exact_x, fibre.refined(i, point_bits)));
  }
  return arcs;
}

}  // namespace eliminant::intersect
