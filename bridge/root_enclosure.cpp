// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/root_enclosure.hpp>

namespace eliminant::bridge {

namespace {

/// RAII for a vector of complex balls as FLINT wants it.
class BallVector {
 public:
  explicit BallVector(slong size) : size_(size), value_(_acb_vec_init(size)) {}
  BallVector(const BallVector&) = delete;
  BallVector& operator=(const BallVector&) = delete;
  ~BallVector() { _acb_vec_clear(value_, size_); }
  acb_ptr get() { return value_; }
  acb_ptr operator[](slong i) { return value_ + i; }

 private:
  slong size_;
  acb_ptr value_;
};

class BallPolynomial {
 public:
  BallPolynomial() { acb_poly_init(value_); }
  BallPolynomial(const BallPolynomial&) = delete;
  BallPolynomial& operator=(const BallPolynomial&) = delete;
  ~BallPolynomial() { acb_poly_clear(value_); }
  acb_poly_struct* get() { return value_; }

 private:
  acb_poly_t value_;
};

bool accurate(acb_ptr roots, slong count, long relative_bits) {
  for (slong i = 0; i < count; ++i)
    if (acb_rel_accuracy_bits(roots + i) < relative_bits) return false;
  return true;
}

/// The simultaneous iteration converges badly from coinciding starting values.
bool usable(const std::vector<ComplexBall>& approximations, slong degree) {
  if (static_cast<slong>(approximations.size()) != degree) return false;
  for (std::size_t i = 0; i < approximations.size(); ++i) {
    if (!acb_is_finite(approximations[i].get())) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (acb_overlaps(approximations[i].get(), approximations[j].get())) return false;
  }
  return true;
}

}  // namespace

std::vector<ComplexBall> enclose_roots(const symbolic::UnivariatePolynomial& squarefree,
                                       const std::vector<ComplexBall>& approximations, long relative_bits,
                                       const Context& context) {
  symbolic::UnivariatePolynomial p = squarefree;
  std::vector<ComplexBall> result;
  if (fmpz_is_zero(p.coefficient(0).get())) {
    fmpz_poly_shift_right(p.get(), p.get(), 1);
    result.emplace_back();  // the root 0, exact
  }
  const slong degree = p.degree();
  if (degree < 1) return result;
  BallVector roots(degree);
  BallVector start(degree);
  BallPolynomial rounded;
  std::vector<ComplexBall> nonzero;
  for (const ComplexBall& approximation : approximations)
    if (result.empty() || !acb_is_zero(approximation.get())) nonzero.push_back(approximation);
  bool have_start = usable(nonzero, degree);
  for (slong i = 0; have_start && i < degree; ++i) acb_get_mid(start[i], nonzero[static_cast<std::size_t>(i)].get());

  for (long precision_bits = 64;; precision_bits *= 2) {
    context.checkpoint("isolating roots");
    // Only in theory: precision beyond this is far above the root separation of any polynomial within the size limits.
    if (precision_bits > (1L << 26)) throw PrecisionExhausted("the roots of the eliminant could not be isolated");
    acb_poly_set_fmpz_poly(rounded.get(), p.get(), precision_bits);
    const slong max_iterations = have_start ? 20 + degree / 4 : 4 * degree + 2 * precision_bits;
    const slong isolated = acb_poly_find_roots(roots.get(), rounded.get(), have_start ? start.get() : nullptr,
                                               max_iterations, precision_bits);
    // Values that did not separate the roots would not do so later either: the next round starts afresh.
    have_start = isolated == degree;
    if (!have_start) continue;
    for (slong i = 0; i < degree; ++i) acb_get_mid(start[i], roots[i]);
    if (!accurate(roots.get(), degree, relative_bits)) continue;
    if (!acb_poly_validate_real_roots(roots.get(), rounded.get(), precision_bits)) continue;
    break;
  }
  for (slong i = 0; i < degree; ++i) {
    if (arb_contains_zero(acb_imagref(roots[i]))) arb_zero(acb_imagref(roots[i]));
    result.emplace_back(roots[i]);
  }
  std::sort(result.begin(), result.end(), [](const ComplexBall& a, const ComplexBall& b) {
    const int by_real = arf_cmp(arb_midref(a.real()), arb_midref(b.real()));
    if (by_real != 0) return by_real < 0;
    return arf_cmp(arb_midref(a.imaginary()), arb_midref(b.imaginary())) < 0;
  });
  return result;
}

}  // namespace eliminant::bridge
