// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include <eliminant/bridge/roots/descartes_isolation.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

namespace eliminant::bridge {

namespace {

using symbolic::Integer;
using symbolic::Rational;
using symbolic::UnivariatePolynomial;

/// The number of sign changes of a sequence, as far as it matters.
enum class SignChanges { none, one, more, unknown };

/// The open interval (low, low + width) / 2^log2, at whose ends the polynomial is not 0.
struct Interval {
  Integer low;
  Integer width;
  unsigned long log2 = 0;

  Rational at(const Integer& numerator) const { return {numerator, symbolic::power(Integer(2), log2)}; }
  Rational lower() const { return at(low); }
  Rational upper() const { return at(low + width); }
};

/// A fixed-point number: an integer of less than 122 binary digits, in units that its owner knows.
__extension__ using Fixed = __int128;
constexpr unsigned long fixed_bits = 122;

/// The coefficients in the Bernstein basis of an interval: the largest has all digits, each has at most that error.
struct Bernstein {
  std::vector<Fixed> coefficients;
  Fixed error = 0;
};

struct Node {
  Interval interval;
  Bernstein bernstein;
  /// Known from the exact coefficients, or still to be read off the rounded ones.
  SignChanges changes = SignChanges::unknown;
};

SignChanges sign_changes(const Bernstein& bernstein) {
  int last = 0;
  int changes = 0;
  int unknown_run = 0;
  bool certain = true;
  for (const Fixed b : bernstein.coefficients) {
    const int sign = b > bernstein.error ? 1 : -b > bernstein.error ? -1 : 0;
    if (sign == 0) {
      ++unknown_run;
      continue;
    }
    if (last != 0 && sign != last) ++changes;
    if (changes > 1) return SignChanges::more;
    // One coefficient of unknown sign between two of opposite signs adds no change, whatever it is.
    if (unknown_run > 0 && (unknown_run > 1 || last == 0 || sign == last)) certain = false;
    unknown_run = 0;
    last = sign;
  }
  if (!certain || unknown_run > 0) return SignChanges::unknown;
  return changes == 0 ? SignChanges::none : SignChanges::one;
}

/// Multiplies by the power of two that gives the largest coefficient all digits.
void normalize(Bernstein& bernstein) {
  Fixed largest = bernstein.error;
  for (const Fixed b : bernstein.coefficients) largest = std::max(largest, b < 0 ? -b : b);
  if (largest == 0) return;
  int shift = 0;
  while ((largest << (shift + 1)) >> (fixed_bits - 1) == 0) ++shift;
  for (Fixed& b : bernstein.coefficients) b <<= shift;
  bernstein.error <<= shift;
}

/// value / divisor in units of 2^-log2, with an error below 2.
Fixed fixed_quotient(const Integer& value, const Integer& divisor, long log2) {
  Integer quotient = value;
  if (log2 >= 0)
    fmpz_mul_2exp(quotient.get(), quotient.get(), static_cast<ulong>(log2));
  else
    fmpz_tdiv_q_2exp(quotient.get(), quotient.get(), static_cast<ulong>(-log2));
  fmpz_tdiv_q(quotient.get(), quotient.get(), divisor.get());
  const int sign = quotient.sign();
  fmpz_abs(quotient.get(), quotient.get());
  ulong high = 0;
  ulong low = 0;
  fmpz_get_uiui(&high, &low, quotient.get());
  const Fixed magnitude = (static_cast<Fixed>(high) << 64) | static_cast<Fixed>(low);
  return sign < 0 ? -magnitude : magnitude;
}

/// A polynomial over Z in balls of growing precision.
class BallPolynomial {
 public:
  explicit BallPolynomial(const UnivariatePolynomial& p) : p_(p) {
    arb_poly_init(rounded_);
    round(64);
  }
  BallPolynomial(const BallPolynomial&) = delete;
  BallPolynomial& operator=(const BallPolynomial&) = delete;
  ~BallPolynomial() { arb_poly_clear(rounded_); }

  /// The sign at numerator / 2^log2: from the precision that served last, to where the evaluation is exact.
  int sign_at(const Integer& numerator, long log2) {
    RealBall point;
    arb_set_fmpz(point.get(), numerator.get());
    arb_mul_2exp_si(point.get(), point.get(), -log2);
    for (;; round(2 * precision_bits_)) {
      RealBall value;
      arb_poly_evaluate(value.get(), rounded_, point.get(), precision_bits_);
      if (arb_is_zero(value.get()) != 0) return 0;
      if (arb_contains_zero(value.get()) == 0) return arb_is_positive(value.get()) != 0 ? 1 : -1;
    }
  }

  /// The numerator over 2^log2 below the value of Newton's step from `point`; nothing is proven of it.
  std::optional<Integer> newton_step(const RealBall& point, long log2, long precision_bits) {
    if (precision_bits > precision_bits_) round(precision_bits);
    RealBall step;
    RealBall slope;
    arb_poly_evaluate2(step.get(), slope.get(), rounded_, point.get(), precision_bits_);
    arb_div(step.get(), step.get(), slope.get(), precision_bits_);
    arb_sub(step.get(), point.get(), step.get(), precision_bits_);
    if (arb_is_finite(step.get()) == 0) return std::nullopt;
    arb_mul_2exp_si(step.get(), step.get(), log2);
    Integer below;
    arf_get_fmpz(below.get(), arb_midref(step.get()), ARF_RND_FLOOR);
    return below;
  }

 private:
  void round(long precision_bits) {
    precision_bits_ = precision_bits;
    arb_poly_set_fmpz_poly(rounded_, p_.get(), precision_bits);
  }

  const UnivariatePolynomial& p_;
  arb_poly_t rounded_;
  long precision_bits_ = 0;
};

/// Of one polynomial p without the roots 0 and 1: the roots in (0, 1).
class UnitInterval {
 public:
  UnitInterval(const UnivariatePolynomial& p, const Context& context) : p_(p), rounded_(p), context_(context) {}

  /// nullopt when too many coefficients had to be computed exactly.
  std::optional<std::vector<Interval>> isolate() {
    std::vector<Interval> found;
    std::vector<Node> open{{{0, 1, 0}, {}}};
    if (!compute_exactly(open.front())) return std::nullopt;
    while (!open.empty()) {
      context_.checkpoint("isolating real roots");
      Node node = std::move(open.back());
      open.pop_back();
      SignChanges changes = node.changes;
      if (changes == SignChanges::unknown) changes = sign_changes(node.bernstein);
      if (changes == SignChanges::unknown) {
        if (!compute_exactly(node)) return std::nullopt;
        changes = node.changes;
      }
      if (changes == SignChanges::one) found.push_back(node.interval);
      if (changes != SignChanges::more) continue;
      std::optional<std::pair<Node, Node>> halves = divide(node);
      if (!halves) halves = divide_exactly(node);
      if (!halves) return std::nullopt;
      open.push_back(std::move(halves->second));
      open.push_back(std::move(halves->first));
    }
    return found;
  }

 private:
  bool compute_exactly(Node& node) {
    constexpr int most_exact_nodes = 200;
    constexpr unsigned long deepest = 400;
    if (++exact_nodes_ > most_exact_nodes || node.interval.log2 > deepest) return false;
    std::tie(node.bernstein, node.changes) = bernstein_on(node.interval);
    return true;
  }

  /// From the exact polynomial: q(x) = p(low + width x) and then the coefficients of (1 + z)^n q(1 / (1 + z)), which
  /// are those of the Bernstein basis times binomials. The number of sign changes is exact.
  std::pair<Bernstein, SignChanges> bernstein_on(const Interval& interval) const {
    const long n = p_.degree();
    UnivariatePolynomial q = p_;
    for (long i = 0; i <= n; ++i)
      fmpz_mul_2exp(q.get()->coeffs + i, q.get()->coeffs + i, interval.log2 * static_cast<unsigned long>(n - i));
    fmpz_poly_taylor_shift(q.get(), q.get(), interval.low.get());
    Integer scale(1);
    for (long i = 0; i <= n; ++i, scale = scale * interval.width)
      fmpz_mul(q.get()->coeffs + i, q.get()->coeffs + i, scale.get());
    fmpz_poly_reverse(q.get(), q.get(), n + 1);
    fmpz_poly_taylor_shift(q.get(), q.get(), Integer(1).get());

    std::vector<Integer> binomials{Integer(1)};
    std::vector<Integer> values;
    int last = 0;
    int changes = 0;
    long largest_log2 = std::numeric_limits<long>::min();
    for (long j = 0; j <= n; ++j) {
      const Integer& binomial = binomials.back();
      Integer& value = values.emplace_back(q.coefficient(n - j));
      if (value.sign() != 0) {
        if (last != 0 && value.sign() != last) ++changes;
        last = value.sign();
        largest_log2 = std::max(largest_log2,
                                static_cast<long>(value.bit_length()) - static_cast<long>(binomial.bit_length()) + 1);
      }
      Integer next = binomial;
      fmpz_mul_ui(next.get(), next.get(), static_cast<ulong>(n - j));
      fmpz_divexact_ui(next.get(), next.get(), static_cast<ulong>(j) + 1);
      binomials.push_back(std::move(next));
    }
    Bernstein bernstein;
    for (std::size_t j = 0; j < values.size(); ++j)
      bernstein.coefficients.push_back(
          fixed_quotient(values[j], binomials[j], static_cast<long>(fixed_bits) - largest_log2));
    bernstein.error = 2;
    return {std::move(bernstein), changes == 0   ? SignChanges::none
                                  : changes == 1 ? SignChanges::one
                                                 : SignChanges::more};
  }

  /// In the middle, or elsewhere where the sign in the middle is not known; nullopt when it is known nowhere.
  static std::optional<std::pair<Node, Node>> divide(const Node& node) {
    for (const int eighths : {4, 3, 5, 2, 6}) {
      std::pair<Bernstein, Bernstein> parts = de_casteljau(node.bernstein, eighths);
      const Fixed middle = parts.second.coefficients.front();
      if (std::max(middle, -middle) <= parts.second.error) continue;
      std::pair<Interval, Interval> intervals = halves_of(node.interval, eighths);
      normalize(parts.first);
      normalize(parts.second);
      return {{{std::move(intervals.first), std::move(parts.first)},
               {std::move(intervals.second), std::move(parts.second)}}};
    }
    return std::nullopt;
  }

  /// The same with the sign from the exact polynomial; nullopt when too much had to be computed exactly.
  std::optional<std::pair<Node, Node>> divide_exactly(const Node& node) {
    for (const int eighths : {4, 3, 5, 2, 6}) {
      std::pair<Interval, Interval> intervals = halves_of(node.interval, eighths);
      if (rounded_.sign_at(intervals.second.low, static_cast<long>(intervals.second.log2)) == 0) continue;
      std::pair<Node, Node> halves{{std::move(intervals.first), {}}, {std::move(intervals.second), {}}};
      if (!compute_exactly(halves.first) || !compute_exactly(halves.second)) return std::nullopt;
      return halves;
    }
    return std::nullopt;
  }

  static std::pair<Interval, Interval> halves_of(const Interval& whole, int eighths) {
    const Integer low = whole.low * Integer(8);
    const Integer left = whole.width * Integer(eighths);
    const Integer right = whole.width * Integer(8 - eighths);
    std::pair<Interval, Interval> halves{{low, left, whole.log2 + 3}, {low + left, right, whole.log2 + 3}};
    reduce(halves.first);
    reduce(halves.second);
    return halves;
  }

  static std::pair<Bernstein, Bernstein> de_casteljau(const Bernstein& whole, int eighths) {
    const std::size_t size = whole.coefficients.size();
    Bernstein right = whole;
    // Each of the convex combinations is rounded down.
    right.error = whole.error + static_cast<Fixed>(size);
    Bernstein left{{}, right.error};
    left.coefficients.reserve(size);
    Fixed* const b = right.coefficients.data();
    for (std::size_t length = size; length > 0; --length) {
      left.coefficients.push_back(b[0]);
      if (eighths == 4)
        for (std::size_t i = 0; i + 1 < length; ++i) b[i] = (b[i] + b[i + 1]) >> 1;
      else
        for (std::size_t i = 0; i + 1 < length; ++i) b[i] = ((8 - eighths) * b[i] + eighths * b[i + 1]) >> 3;
    }
    return {std::move(left), std::move(right)};
  }

  static void reduce(Interval& interval) {
    unsigned long common = std::min<unsigned long>(interval.log2, fmpz_val2(interval.width.get()));
    if (!interval.low.is_zero()) common = std::min<unsigned long>(common, fmpz_val2(interval.low.get()));
    fmpz_tdiv_q_2exp(interval.low.get(), interval.low.get(), common);
    fmpz_tdiv_q_2exp(interval.width.get(), interval.width.get(), common);
    interval.log2 -= common;
  }

  const UnivariatePolynomial& p_;
  BallPolynomial rounded_;
  const Context& context_;
  int exact_nodes_ = 0;
};

/// The cell [numerator, numerator + 1] / 2^log2 with opposite signs at its ends, or the root numerator / 2^log2 itself.
/// As a ball a cell is exact.
struct Cell {
  Integer numerator;
  long log2 = 0;
  bool exact = false;

  /// From such a ball, of a radius that is not 0.
  static Cell of(const RealBall& ball) {
    Cell cell;
    // The radius 2^(-log2 - 1) has a mantissa of 1/2.
    cell.log2 = -fmpz_get_si(MAG_EXPREF(arb_radref(ball.get())));
    RealBall scaled;
    arb_mul_2exp_si(scaled.get(), ball.get(), cell.log2);
    arf_get_fmpz(cell.numerator.get(), arb_midref(scaled.get()), ARF_RND_FLOOR);
    return cell;
  }

  RealBall ball() const {
    RealBall result;
    if (exact) {
      arb_set_fmpz(result.get(), numerator.get());
      arb_mul_2exp_si(result.get(), result.get(), -log2);
      return result;
    }
    arb_set_fmpz(result.get(), (numerator + numerator + Integer(1)).get());
    arb_mul_2exp_si(result.get(), result.get(), -log2 - 1);
    mag_set_ui_2exp_si(arb_radref(result.get()), 1, -log2 - 1);
    return result;
  }
};

/// The cell of a root between two numerators over 2^log2; nullopt when the signs there are equal.
std::optional<Cell> bisect(Integer lower, Integer upper, long log2, BallPolynomial& p) {
  const int lower_sign = p.sign_at(lower, log2);
  const int upper_sign = p.sign_at(upper, log2);
  if (lower_sign == 0) return Cell{std::move(lower), log2, true};
  if (upper_sign == 0) return Cell{std::move(upper), log2, true};
  if (lower_sign == upper_sign) return std::nullopt;
  for (;;) {
    Integer middle = lower + upper;
    fmpz_fdiv_q_2exp(middle.get(), middle.get(), 1);
    if (middle == lower) return Cell{std::move(lower), log2, false};
    const int sign = p.sign_at(middle, log2);
    if (sign == 0) return Cell{std::move(middle), log2, true};
    (sign == lower_sign ? lower : upper) = std::move(middle);
  }
}

/// The cell of the one root between two rational numbers, which are no roots.
Cell cell_between(const Rational& lower, const Rational& upper, BallPolynomial& p) {
  for (long log2 = 0;; log2 = 2 * log2 + 8) {
    const Rational scale(symbolic::power(Integer(2), static_cast<unsigned long>(log2)));
    const Rational scaled_lower = lower * scale;
    const Rational scaled_upper = upper * scale;
    Integer first;
    Integer last;
    fmpz_cdiv_q(first.get(), fmpq_numref(scaled_lower.get()), fmpq_denref(scaled_lower.get()));
    fmpz_fdiv_q(last.get(), fmpq_numref(scaled_upper.get()), fmpq_denref(scaled_upper.get()));
    if (fmpz_cmp(first.get(), last.get()) > 0) continue;
    if (std::optional<Cell> cell = bisect(std::move(first), std::move(last), log2, p)) return *std::move(cell);
  }
}

Integer shifted(const Integer& value, long log2) {
  Integer result;
  fmpz_mul_2exp(result.get(), value.get(), static_cast<ulong>(log2));
  return result;
}

/// Bisection and Newton's steps ([Abbott2014]): one of them is trusted with `gain` more bits, twice as many when it
/// deserved it.
class Refinement {
 public:
  Refinement(const UnivariatePolynomial& p, Cell cell) : p_(p), cell_(std::move(cell)), ball_(cell_.ball()) {}

  const RealBall& ball() const { return ball_; }
  const Cell& cell() const { return cell_; }
  long accuracy() const { return arb_rel_accuracy_bits(ball_.get()); }

  void step() {
    if (cell_.exact) return;
    if (std::optional<Cell> smaller = by_newton()) {
      cell_ = *std::move(smaller);
      gain_ *= 2;
    } else {
      const Integer lower = shifted(cell_.numerator, 1);
      cell_ = *bisect(lower, lower + Integer(2), cell_.log2 + 1, p_);
      gain_ = std::max(1L, gain_ / 2);
    }
    ball_ = cell_.ball();
  }

 private:
  std::optional<Cell> by_newton() {
    RealBall middle;
    arb_get_mid_arb(middle.get(), ball_.get());
    constexpr long spare_bits = 32;
    const long finer = cell_.log2 + gain_;
    const std::optional<Integer> below = p_.newton_step(middle, finer, std::max(64L, accuracy() + gain_ + spare_bits));
    if (!below) return std::nullopt;
    // A unit to each side, as far as the cell reaches.
    Integer lower = std::max(*below - Integer(1), shifted(cell_.numerator, gain_), less);
    Integer upper = std::min(*below + Integer(2), shifted(cell_.numerator + Integer(1), gain_), less);
    if (!less(lower, upper)) return std::nullopt;
    return bisect(std::move(lower), std::move(upper), finer, p_);
  }

  static bool less(const Integer& a, const Integer& b) { return fmpz_cmp(a.get(), b.get()) < 0; }

  BallPolynomial p_;
  Cell cell_;
  RealBall ball_;
  long gain_ = 4;
};

/// Makes the closed cells disjoint from each other and from the roots met exactly.
void separate(std::vector<Cell>& cells, const UnivariatePolynomial& p, const Context& context) {
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    const RealBall first = a.ball();
    const RealBall second = b.ball();
    return arf_cmp(arb_midref(first.get()), arb_midref(second.get())) < 0;
  });
  for (std::size_t i = 0; i + 1 < cells.size(); ++i)
    while (arb_overlaps(cells[i].ball().get(), cells[i + 1].ball().get()) != 0)
      for (Cell* cell : {&cells[i], &cells[i + 1]}) {
        context.checkpoint("isolating real roots");
        Refinement refinement(p, std::move(*cell));
        refinement.step();
        *cell = refinement.cell();
      }
}

/// p(-x) or p(1/x) times the power of x that makes it a polynomial.
UnivariatePolynomial mirrored(const UnivariatePolynomial& p) {
  UnivariatePolynomial result = p;
  for (long i = 1; i <= p.degree(); i += 2) fmpz_neg(result.get()->coeffs + i, result.get()->coeffs + i);
  return result;
}

UnivariatePolynomial inverted(const UnivariatePolynomial& p) {
  UnivariatePolynomial result;
  fmpz_poly_reverse(result.get(), p.get(), p.degree() + 1);
  return result;
}

/// Divides by x - root where that is a root; true when it was.
bool divide_out(UnivariatePolynomial& p, long root) {
  Integer value;
  fmpz_poly_evaluate_fmpz(value.get(), p.get(), Integer(root).get());
  if (!value.is_zero()) return false;
  const UnivariatePolynomial linear({Integer(-root), Integer(1)});
  fmpz_poly_div(p.get(), p.get(), linear.get());
  return true;
}

}  // namespace

std::optional<std::vector<RealBall>> descartes_isolation(const UnivariatePolynomial& squarefree,
                                                         const Context& context) {
  std::vector<Cell> cells;
  UnivariatePolynomial p = squarefree;
  for (const long root : {-1L, 0L, 1L})
    if (divide_out(p, root)) cells.push_back({Integer(root), 0, true});
  if (p.degree() >= 1) {
    Integer bound;
    fmpz_poly_bound_roots(bound.get(), p.get());
    BallPolynomial rounded(p);
    for (const bool negative : {true, false}) {
      const UnivariatePolynomial q = negative ? mirrored(p) : p;
      for (const bool large : {true, false}) {
        const UnivariatePolynomial unit = large ? inverted(q) : q;
        const auto intervals = UnitInterval(unit, context).isolate();
        if (!intervals) return std::nullopt;
        for (const Interval& interval : *intervals) {
          Rational lower = interval.lower();
          Rational upper = interval.upper();
          if (large) {
            const Rational above = lower.is_zero() ? Rational(bound + Integer(1)) : Rational(1) / lower;
            lower = Rational(1) / upper;
            upper = above;
          }
          if (negative) {
            std::swap(lower, upper);
            lower = -lower;
            upper = -upper;
          }
          cells.push_back(cell_between(lower, upper, rounded));
        }
      }
    }
  }
  separate(cells, p, context);
  std::vector<RealBall> balls;
  for (const Cell& cell : cells) balls.push_back(cell.ball());
  return balls;
}

void refine_real_root(const UnivariatePolynomial& squarefree, RealBall& ball, long relative_bits,
                      const Context& context) {
  if (arb_is_exact(ball.get()) != 0 || arb_rel_accuracy_bits(ball.get()) >= relative_bits) return;
  Refinement refinement(squarefree, Cell::of(ball));
  while (!refinement.cell().exact && refinement.accuracy() < relative_bits) {
    context.checkpoint("refining roots");
    refinement.step();
  }
  ball = refinement.ball();
}

}  // namespace eliminant::bridge
