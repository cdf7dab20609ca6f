// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <optional>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/roots/descartes_isolation.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/numeric/ehrlich_aberth.hpp>

namespace eliminant::bridge {

namespace {

/// With fewer significant bits of the value Newton's step leads nowhere.
constexpr long useful_bits = 8;

/// Far above the root separation of any polynomial within the size limits: it only bounds what a mistake could cost.
constexpr long precision_ceiling = 1L << 26;

/// A polynomial with real balls as coefficients (Arb).
class RealBallPolynomial {
 public:
  RealBallPolynomial(const symbolic::UnivariatePolynomial& p, long precision_bits) {
    arb_poly_init(value_);
    arb_poly_set_fmpz_poly(value_, p.get(), precision_bits);
  }
  RealBallPolynomial(const RealBallPolynomial&) = delete;
  RealBallPolynomial& operator=(const RealBallPolynomial&) = delete;
  ~RealBallPolynomial() { arb_poly_clear(value_); }
  const arb_poly_struct* get() const { return value_; }
  /// Replaces the polynomial by its derivative over `divisor`.
  void differentiate(unsigned long divisor, long precision_bits) {
    arb_poly_derivative(value_, value_, precision_bits);
    for (slong i = 0; i < arb_poly_length(value_); ++i) {
      arb_ptr coefficient = arb_poly_get_coeff_ptr(value_, i);
      arb_div_ui(coefficient, coefficient, divisor, precision_bits);
    }
  }

 private:
  arb_poly_t value_;
};

struct Value {
  ComplexBall value, derivative;
};

Value evaluate(const RealBallPolynomial& p, const ComplexBall& z, long precision_bits) {
  Value result;
  arb_poly_evaluate2_acb_rectangular(result.value.get(), result.derivative.get(), p.get(), z.get(), precision_bits);
  return result;
}

/// The smallest box around the disc of radius n |p / p'| around z, or only its real axis; nullopt when p' may be 0.
std::optional<ComplexBall> inclusion_box(const ComplexBall& z, const Value& at_z, long degree, bool real = false) {
  Magnitude radius;
  Magnitude slope;
  acb_get_mag(radius.get(), at_z.value.get());
  acb_get_mag_lower(slope.get(), at_z.derivative.get());
  mag_div(radius.get(), radius.get(), slope.get());
  mag_mul_ui(radius.get(), radius.get(), static_cast<mp_limb_t>(degree));
  if (mag_is_finite(radius.get()) == 0) return std::nullopt;
  ComplexBall box = z;
  arb_add_error_mag(box.real(), radius.get());
  if (!real) arb_add_error_mag(box.imaginary(), radius.get());
  return box;
}

numeric::ScaledReal scaled(const symbolic::Integer& value) {
  slong exponent = 0;
  const double mantissa = fmpz_get_d_2exp(&exponent, value.get());
  return {mantissa, mantissa == 0 ? 0 : exponent};
}

ComplexBall exact_ball(const numeric::ScaledComplex& z) {
  ComplexBall ball(z.mantissa.real(), z.mantissa.imag());
  acb_mul_2exp_si(ball.get(), ball.get(), z.exponent);
  return ball;
}

double magnitude_log2(const ComplexBall& z) {
  Magnitude magnitude;
  acb_get_mag(magnitude.get(), z.get());
  return mag_get_d_log2_approx(magnitude.get());
}

/// The approximations of all roots on the way to isolation.
class Isolation {
 public:
  Isolation(const symbolic::UnivariatePolynomial& p, const std::vector<ComplexBall>& approximations,
            const Context& context)
      : p_(p), degree_(p.degree()), context_(context) {
    std::vector<numeric::ScaledReal> coefficients;
    for (long i = 0; i <= degree_; ++i) coefficients.push_back(scaled(p.coefficient(i)));
    constexpr int max_sweeps = 60;
    for (const numeric::ScaledComplex& z : numeric::ehrlich_aberth(coefficients, max_sweeps))
      roots_.push_back({exact_ball(z), {}, {}, {}});
    replace_nearest(approximations);
  }

  std::vector<ComplexBall> run() {
    for (long precision_bits = 64; precision_bits <= precision_ceiling; precision_bits *= 2) {
      context_.checkpoint("isolating roots");
      const RealBallPolynomial rounded(p_, precision_bits);
      if (precision_bits > 64) spread_clusters(precision_bits);
      for (Root& root : roots_)
        if (root.active || precision_bits == 64) update(root, rounded, precision_bits);
      if (iterate(rounded, precision_bits)) {
        std::vector<ComplexBall> boxes;
        for (Root& root : roots_) boxes.push_back(std::move(*root.box));
        return boxes;
      }
    }
    throw PrecisionExhausted("the roots of a polynomial of degree " + std::to_string(degree_) +
                             " could not be isolated");
  }

 private:
  struct Root {
    ComplexBall z;                   ///< exact
    std::complex<double> rough;      ///< the same rounded, perhaps to 0 or infinity
    Value value;                     ///< of the polynomial in z
    std::optional<ComplexBall> box;  ///< contains a root
    bool settled = false;            ///< the value is hardly more than its rounding error, or steps change no digit
    bool active = true;              ///< not isolated from all others
  };

  /// Each approximation takes the place of the nearest value that no other one has taken.
  void replace_nearest(const std::vector<ComplexBall>& approximations) {
    std::vector<bool> taken(roots_.size(), false);
    const std::size_t count = std::min(approximations.size(), roots_.size());
    for (std::size_t i = 0; i < count; ++i) {
      const ComplexBall z = midpoint(approximations[i]);
      std::optional<std::size_t> nearest;
      double smallest = INFINITY;
      for (std::size_t j = 0; j < roots_.size(); ++j) {
        if (taken[j]) continue;
        ComplexBall difference;
        acb_sub(difference.get(), z.get(), roots_[j].z.get(), 64);
        const double distance = magnitude_log2(difference);
        if (nearest && distance >= smallest) continue;
        nearest = j;
        smallest = distance;
      }
      taken[*nearest] = true;
      roots_[*nearest].z = z;
    }
  }

  void update(Root& root, const RealBallPolynomial& rounded, long precision_bits) const {
    root.rough = {arf_get_d(arb_midref(root.z.real()), ARF_RND_NEAR),
                  arf_get_d(arb_midref(root.z.imaginary()), ARF_RND_NEAR)};
    root.value = evaluate(rounded, root.z, precision_bits);
    root.box = inclusion_box(root.z, root.value, degree_);
    root.settled = acb_rel_accuracy_bits(root.value.value.get()) < useful_bits;
  }

  /// Sweeps over the active roots until all are isolated (true) or this precision has nothing more to give (false).
  bool iterate(const RealBallPolynomial& rounded, long precision_bits) {
    constexpr int max_sweeps = 100;
    constexpr int patience = 10;
    std::size_t most_settled = 0;
    int sweeps_in_vain = 0;
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
      find_clusters();
      std::size_t active = 0;
      std::size_t settled = 0;
      for (const Root& root : roots_) {
        if (root.active) ++active;
        if (root.active && root.settled) ++settled;
      }
      if (active == 0) return true;
      // Once some have settled, the others follow soon, or wander in the rounding error.
      sweeps_in_vain = settled > most_settled || settled == 0 ? 0 : sweeps_in_vain + 1;
      most_settled = std::max(most_settled, settled);
      if (settled == active || sweeps_in_vain > patience) return false;
      for (std::size_t i = 0; i < roots_.size(); ++i) {
        Root& root = roots_[i];
        if (!root.active || root.settled) continue;
        context_.checkpoint("isolating roots");
        aberth_step(i, precision_bits);
        const bool at_rest = root.settled;
        update(root, rounded, precision_bits);
        root.settled = root.settled || at_rest;
      }
    }
    return false;
  }

  /// The sum of 1 / (z_i - z_j): in doubles where they tell both apart well, in balls of that precision else.
  ComplexBall repulsion_on(std::size_t i, long precision_bits) const {
    constexpr double least = 1e-100;
    constexpr double largest = 1e100;
    constexpr double well_apart = 1e-14;  // squared and relative
    const std::complex<double> here = roots_[i].rough;
    const double size = std::norm(here);
    const bool doubles = size > least * least && size < largest * largest;
    double re = 0;
    double im = 0;
    ComplexBall sum;
    ComplexBall term;
    for (std::size_t j = 0; j < roots_.size(); ++j) {
      if (j == i) continue;
      const double d_re = here.real() - roots_[j].rough.real();
      const double d_im = here.imag() - roots_[j].rough.imag();
      const double square = d_re * d_re + d_im * d_im;
      if (doubles && square > well_apart * size && square < largest * largest) {
        re += d_re / square;
        im -= d_im / square;
        continue;
      }
      acb_sub(term.get(), roots_[i].z.get(), roots_[j].z.get(), precision_bits);
      if (acb_contains_zero(term.get())) continue;
      acb_inv(term.get(), term.get(), precision_bits);
      acb_add(sum.get(), sum.get(), term.get(), precision_bits);
    }
    acb_add(sum.get(), sum.get(), ComplexBall(re, im).get(), precision_bits);
    return sum;
  }

  /// z <- z - N / (1 - N A) with N = p / p' and A the sum of 1 / (z - z_j), where there is such a step.
  void aberth_step(std::size_t i, long precision_bits) {
    // The repulsion of the others needs no more accuracy than this to drive the iteration.
    constexpr long repulsion_bits = 64;
    Root& root = roots_[i];
    const ComplexBall repulsion = midpoint(repulsion_on(i, repulsion_bits));
    ComplexBall step;
    acb_mul(step.get(), root.value.value.get(), repulsion.get(), precision_bits);
    acb_sub(step.get(), root.value.derivative.get(), step.get(), precision_bits);
    step = midpoint(step);
    if (acb_is_zero(step.get())) return;
    acb_div(step.get(), midpoint(root.value.value).get(), step.get(), precision_bits);
    step = midpoint(step);
    if (!acb_is_finite(step.get())) return;
    const double relative = magnitude_log2(step) - magnitude_log2(root.z);
    acb_sub(root.z.get(), root.z.get(), step.get(), precision_bits);
    root.z = midpoint(root.z);
    root.settled = relative < static_cast<double>(8 - precision_bits);
  }

  /// Marks the roots whose boxes meet another one as active, and gathers them in connected components. A root without a
  /// box is active alone. Only boxes whose real parts meet are compared, in the order of their left ends.
  void find_clusters() {
    clusters_.clear();
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      roots_[i].active = !roots_[i].box;
      if (roots_[i].box) order.push_back(i);
    }
    constexpr long bound_bits = 64;
    std::vector<RealBall> left(roots_.size());
    std::vector<RealBall> right(roots_.size());
    for (const std::size_t i : order) {
      arb_get_lbound_arf(arb_midref(left[i].get()), roots_[i].box->real(), bound_bits);
      arb_get_ubound_arf(arb_midref(right[i].get()), roots_[i].box->real(), bound_bits);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const int comparison = arf_cmp(arb_midref(left[a].get()), arb_midref(left[b].get()));
      return comparison != 0 ? comparison < 0 : a < b;
    });
    std::vector<std::size_t> parent(roots_.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto representative = [&](std::size_t i) {
      while (parent[i] != i) i = parent[i] = parent[parent[i]];
      return i;
    };
    for (std::size_t a = 0; a < order.size(); ++a)
      for (std::size_t b = a + 1; b < order.size(); ++b) {
        if (arf_cmp(arb_midref(left[order[b]].get()), arb_midref(right[order[a]].get())) > 0) break;
        if (!acb_overlaps(roots_[order[a]].box->get(), roots_[order[b]].box->get())) continue;
        parent[representative(order[b])] = representative(order[a]);
        roots_[order[a]].active = roots_[order[b]].active = true;
      }
    std::vector<std::vector<std::size_t>> components(roots_.size());
    for (std::size_t i = 0; i < roots_.size(); ++i) components[representative(i)].push_back(i);
    for (auto& component : components)
      if (component.size() > 1) clusters_.push_back(std::move(component));
  }

  /// At the last precision the members of a cluster only know that they are near each other. The Newton polygon of the
  /// Taylor expansion in the centre knows how far from each other, and gives new starting values.
  void spread_clusters(long precision_bits) {
    for (const std::vector<std::size_t>& cluster : clusters_) spread(cluster, precision_bits);
  }

  void spread(const std::vector<std::size_t>& cluster, long precision_bits) {
    const auto size = static_cast<long>(cluster.size());
    ComplexBall centre;
    for (const std::size_t i : cluster) acb_add(centre.get(), centre.get(), roots_[i].z.get(), precision_bits);
    acb_div_si(centre.get(), centre.get(), size, precision_bits);
    centre = midpoint(centre);
    const auto distance_log2 = [&](const ComplexBall& z) {
      ComplexBall difference;
      acb_sub(difference.get(), z.get(), centre.get(), precision_bits);
      return magnitude_log2(difference);
    };
    double reach = -INFINITY;
    for (const std::size_t i : cluster) reach = std::max(reach, distance_log2(*roots_[i].box));
    // The derivative of order k - 1 has one root in the middle of k roots, a well-conditioned one.
    RealBallPolynomial middle(p_, precision_bits);
    for (long k = 1; k < size; ++k) middle.differentiate(static_cast<unsigned long>(k), precision_bits);
    const ComplexBall first_centre = centre;
    constexpr int max_steps = 40;
    for (int step = 0; step < max_steps; ++step) {
      const Value at_centre = evaluate(middle, centre, precision_bits);
      if (acb_contains_zero(at_centre.value.get()) || acb_contains_zero(at_centre.derivative.get())) break;
      ComplexBall change;
      acb_div(change.get(), at_centre.value.get(), at_centre.derivative.get(), precision_bits);
      acb_sub(centre.get(), centre.get(), change.get(), precision_bits);
      centre = midpoint(centre);
      if (!acb_is_finite(centre.get()) || distance_log2(first_centre) > reach) return;
    }
    std::vector<double> taylor_log2;
    RealBallPolynomial derivative(p_, precision_bits);
    for (long k = 0; k <= size; ++k) {
      if (k > 0) derivative.differentiate(static_cast<unsigned long>(k), precision_bits);
      taylor_log2.push_back(magnitude_log2(evaluate(derivative, centre, precision_bits).value));
    }
    if (!std::isfinite(taylor_log2.front()) || !std::isfinite(taylor_log2.back())) return;
    const std::vector<double> radii = numeric::newton_polygon_radii(taylor_log2);
    if (radii.back() > reach + 1) return;
    const std::vector<numeric::ScaledComplex> offsets = numeric::points_on_circles(radii);
    for (std::size_t k = 0; k < cluster.size(); ++k) {
      Root& root = roots_[cluster[k]];
      acb_add(root.z.get(), centre.get(), exact_ball(offsets[k]).get(), precision_bits);
      root.z = midpoint(root.z);
    }
  }

  const symbolic::UnivariatePolynomial& p_;
  long degree_;
  const Context& context_;
  std::vector<Root> roots_;
  std::vector<std::vector<std::size_t>> clusters_;
};

}  // namespace

IsolatedRoots::IsolatedRoots(const symbolic::UnivariatePolynomial& squarefree, const Context& context,
                             const std::vector<ComplexBall>& approximations)
    : p_(squarefree) {
  const bool zero = fmpz_is_zero(p_.coefficient(0).get()) != 0;
  if (zero) fmpz_poly_shift_right(p_.get(), p_.get(), 1);
  if (p_.degree() >= 1) {
    balls_ = Isolation(p_, approximations, context).run();
    decide_reality(context);
  }
  if (zero) {
    // The others are isolated from each other, not yet from 0.
    for (std::size_t i = 0; i < balls_.size(); ++i)
      for (long bits = 8; acb_contains_zero(balls_[i].get()) != 0; bits *= 2) refine(i, bits, context);
    balls_.emplace_back();
  }
  std::sort(balls_.begin(), balls_.end(), [](const ComplexBall& a, const ComplexBall& b) {
    const int by_real = arf_cmp(arb_midref(a.real()), arb_midref(b.real()));
    if (by_real != 0) return by_real < 0;
    return arf_cmp(arb_midref(a.imaginary()), arb_midref(b.imaginary())) < 0;
  });
}

IsolatedRoots IsolatedRoots::real(const symbolic::UnivariatePolynomial& squarefree, const Context& context) {
  const std::optional<std::vector<RealBall>> isolated = descartes_isolation(squarefree, context);
  if (!isolated) {
    IsolatedRoots all(squarefree, context);
    std::erase_if(all.balls_, [](const ComplexBall& ball) { return arb_is_zero(ball.imaginary()) == 0; });
    return all;
  }
  IsolatedRoots result;
  result.p_ = squarefree;
  result.by_signs_ = true;
  for (const RealBall& root : *isolated) arb_set(result.balls_.emplace_back().real(), root.get());
  return result;
}

void IsolatedRoots::decide_reality(const Context& context) {
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    for (long bits = 64; arb_contains_zero(balls_[i].imaginary()) != 0; bits *= 2) {
      ComplexBall mirrored;
      acb_conj(mirrored.get(), balls_[i].get());
      bool alone = true;
      for (std::size_t j = 0; j < balls_.size() && alone; ++j)
        alone = j == i || acb_overlaps(mirrored.get(), balls_[j].get()) == 0;
      if (alone) {
        arb_zero(balls_[i].imaginary());
        break;
      }
      refine(i, bits, context);
    }
  }
}

void IsolatedRoots::refine(std::size_t index, long relative_bits, const Context& context) {
  ComplexBall& ball = balls_[index];
  if (by_signs_) {
    RealBall real(ball.real());
    refine_real_root(p_, real, relative_bits, context);
    arb_swap(ball.real(), real.get());
    return;
  }
  // Also when the ball is exact: its accuracy is the largest number there is.
  const auto accuracy = [](const ComplexBall& z) { return static_cast<long>(acb_rel_accuracy_bits(z.get())); };
  if (acb_is_zero(ball.get()) || accuracy(ball) >= relative_bits) return;
  // Of a real root the ball is what its isolating box and the mirror image of that have of the real axis. Their union
  // holds no other root, and reaches as far from the axis as along it: the disc around a real z is in it with its
  // diameter.
  const bool real = arb_is_zero(ball.imaginary()) != 0;
  ComplexBall z = midpoint(ball);
  long precision_bits = std::max(64L, 2 * accuracy(ball));
  while (accuracy(ball) < relative_bits) {
    context.checkpoint("refining roots");
    if (precision_bits > precision_ceiling) throw PrecisionExhausted("a root could not be refined");
    const RealBallPolynomial rounded(p_, precision_bits);
    // Within one precision Newton's method is quick to reach the rounding error.
    bool shrunk = false;
    constexpr int max_steps = 8;
    for (int step = 0; step < max_steps; ++step) {
      const Value at_z = evaluate(rounded, z, precision_bits);
      const std::optional<ComplexBall> box = inclusion_box(z, at_z, p_.degree(), real);
      if (!box) break;
      if (acb_contains(ball.get(), box->get()) != 0) {
        shrunk = accuracy(*box) > accuracy(ball);
        if (shrunk) ball = *box;
        if (accuracy(ball) >= relative_bits || (step > 0 && !shrunk)) break;
      }
      if (acb_rel_accuracy_bits(at_z.value.get()) < useful_bits) break;
      ComplexBall change;
      acb_div(change.get(), at_z.value.get(), at_z.derivative.get(), precision_bits);
      acb_sub(z.get(), z.get(), change.get(), precision_bits);
      z = midpoint(z);
      if (acb_contains(ball.get(), z.get()) == 0) break;
    }
    if (acb_contains(ball.get(), z.get()) == 0) z = midpoint(ball);
    precision_bits *= 2;
  }
}

std::vector<ComplexBall> enclose_roots(const symbolic::UnivariatePolynomial& squarefree, long relative_bits,
                                       const Context& context) {
  IsolatedRoots roots(squarefree, context);
  for (std::size_t i = 0; i < roots.balls().size(); ++i) roots.refine(i, relative_bits, context);
  return roots.balls();
}

}  // namespace eliminant::bridge
