// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/topology/event_fibres.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/roots/isolated_roots.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>
#include <eliminant/intersect/plane_curves/third_equation.hpp>

namespace eliminant::intersect {

namespace {

using bridge::FibreInterval;
using bridge::FibreIsolation;
using bridge::RationalFibre;
using bridge::RealBall;
using symbolic::HiddenVariablePolynomial;
using symbolic::Polynomial;
using symbolic::Rational;
using symbolic::UnivariatePolynomial;

/// Thrown and caught here: the enclosures of the critical points are too wide.
struct NeedsMoreDigits {};

Rational exact(const arf_t value) {
  Rational result;
  arf_get_fmpq(result.get(), value);
  return result;
}

Rational midpoint_of(const RealBall& ball) { return exact(arb_midref(ball.get())); }

Rational radius_of(const RealBall& ball) {
  RealBall radius;
  arb_get_rad_arb(radius.get(), ball.get());
  return midpoint_of(radius);
}

Rational halved(const Rational& value, unsigned long times) {
  Rational result;
  fmpq_div_2exp(result.get(), value.get(), times);
  return result;
}

/// g without its factor y - c, restricted to y = c, and whether there is that factor.
struct OnBorder {
  UnivariatePolynomial polynomial;
  bool contains_line = false;
};

OnBorder on_border(const Polynomial& g, const Rational& c) {
  OnBorder result{symbolic::on_horizontal_line(g, c), false};
  if (!result.polynomial.is_zero()) return result;
  const Polynomial line = Polynomial::variable(2, 1) - Polynomial::constant(2, c);
  return {symbolic::on_horizontal_line(symbolic::exact_quotient(g, line), c), true};
}

/// A real solution of g = g_y = 0, and the multiplicity of its y in the fibre.
struct CriticalPoint {
  Solution solution;
  long fibre_multiplicity = 2;
};

/// One attempt, with a fixed number of digits for the critical points.
class EventSearch {
 public:
  EventSearch(const symbolic::ReducedCurve& curve, const std::optional<Box>& box, const Options& options,
              const Context& context)
      : curve_(curve), g_(symbolic::hide_variable(curve.rest, 0)), box_(box), options_(options), context_(context) {}

  EventFibres run() {
    find_critical_points();
    find_events();
    for (std::size_t i = 0; i < events_.size(); ++i) result_.fibres.push_back(fibre_of(i));
    return std::move(result_);
  }

 private:
  struct Event {
    std::size_t root = 0;
    std::vector<CriticalPoint> critical;
    std::optional<Rational> exact_x;
    bool vertical_line = false;
    long degree_drop = 0;
    std::array<bool, 2> on_border{};
  };

  void find_critical_points() {
    result_.engine.method = "none";
    result_.engine.seed = options_.seed;
    if (g_.degree() < 2) return;
    PlaneCurvesProblem problem;
    problem.p = curve_.rest;
    problem.q = curve_.rest.derivative(1);
    Options real = options_;
    real.field = Field::real;
    real.certificate = false;
    real.certify = true;
    Result solved = intersect_plane_curves(problem, real, context_);
    if (solved.status == Status::numeric) {
      // Arcs cannot be connected while critical points are missing.
      real.engine = Engine::exact;
      std::vector<std::string> warnings = std::move(solved.warnings);
      solved = intersect_plane_curves(problem, real, context_);
      solved.warnings.insert(solved.warnings.begin(), warnings.begin(), warnings.end());
    }
    if (solved.status == Status::incomplete) throw LimitReached(*solved.limit);
    result_.status = solved.status;
    result_.engine = solved.engine;
    result_.warnings = solved.warnings;
    find_fibre_multiplicities(problem, solved.solutions);
  }

  /// By I = k - 1 + mu, [Teissier1973]: I the intersection multiplicity of g and g_y, k that of the root y in the
  /// fibre, mu the Milnor number, which is 0 at smooth points. At others it is found out how many derivatives vanish.
  void find_fibre_multiplicities(const PlaneCurvesProblem& problem, const std::vector<Solution>& solutions) {
    const Polynomial slope = curve_.rest.derivative(0);
    std::vector<Solution> left;
    for (const Solution& s : solutions) {
      const long precision_bits = 4 * bits_for_digits(options_.digits);
      const bool smooth =
          s.multiplicity == 1 || acb_contains_zero(evaluate(slope, s.x.ball, s.y.ball, precision_bits).get()) == 0;
      critical_.push_back({s, smooth ? static_cast<long>(s.multiplicity) + 1 : 2});
      if (!smooth) left.push_back(s);
    }
    Polynomial derivative = problem.q;
    for (long k = 2; !left.empty(); ++k) {
      derivative = derivative.derivative(1);
      KeptSolutions kept = solutions_of_third(problem, derivative, left, options_.seed, context_);
      if (!kept.decided) throw NeedsMoreDigits();
      left = std::move(kept.solutions);
      for (const Solution& s : left)
        for (CriticalPoint& point : critical_)
          if (point.solution.x.real == s.x.real && point.solution.y.real == s.y.real) point.fibre_multiplicity = k + 1;
    }
  }

  void find_events() {
    std::vector<UnivariatePolynomial> others;
    if (box_) {
      for (std::size_t end = 0; end < 2; ++end) {
        borders_[end] = on_border(curve_.rest, box_->y[end]);
        others.push_back(borders_[end].polynomial);
        others.push_back(UnivariatePolynomial::with_root(box_->x[end]));
      }
    }
    polynomial_ = symbolic::event_polynomial(curve_, others, options_.seed, context_);
    if (polynomial_.degree() < 1) return;
    roots_ = bridge::IsolatedRoots::real(polynomial_, context_);
    for (std::size_t i = 0; i < roots_.balls().size(); ++i) refine(i, bits_for_digits(options_.digits));
    std::map<std::size_t, std::vector<CriticalPoint>> critical;
    for (const CriticalPoint& point : critical_) critical[root_of(point)].push_back(point);
    for (std::size_t i = 0; i < roots_.balls().size(); ++i) {
      Event event;
      event.root = i;
      if (box_) {
        if (compare(i, box_->x[0]) < 0 || compare(i, box_->x[1]) > 0) continue;
        for (const Rational& end : box_->x)
          if (compare(i, end) == 0) event.exact_x = end;
      }
      event.critical = std::move(critical[i]);
      event.vertical_line = is_root_of(i, curve_.vertical_lines);
      event.degree_drop = degree_drop(i);
      for (std::size_t end = 0; end < 2 && box_; ++end)
        event.on_border[end] = borders_[end].contains_line || is_root_of(i, borders_[end].polynomial);
      const bool crosses_border =
          box_ && (is_root_of(i, borders_[0].polynomial) || is_root_of(i, borders_[1].polynomial));
      if (event.exact_x || !event.critical.empty() || event.vertical_line || event.degree_drop > 0 || crosses_border)
        events_.push_back(std::move(event));
    }
  }

  RealBall root(std::size_t i) const { return RealBall(roots_.balls()[i].real()); }

  void refine(std::size_t i, long relative_bits) {
    if (arb_is_exact(roots_.balls()[i].real()) == 0) roots_.refine(i, relative_bits, context_);
  }

  /// The event above which a critical point lies: the one root that its enclosure meets.
  std::size_t root_of(const CriticalPoint& point) const {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < roots_.balls().size(); ++i) {
      if (arb_overlaps(roots_.balls()[i].real(), point.solution.x.ball.real()) == 0) continue;
      if (found) throw NeedsMoreDigits();
      found = i;
    }
    if (!found) throw PrecisionExhausted("a critical point lies above no root of the discriminant");
    return *found;
  }

  int compare(std::size_t i, const Rational& x) {
    if (arb_contains_fmpq(root(i).get(), x.get()) != 0 && symbolic::sign_at(polynomial_, x) == 0) return 0;
    for (long bits = 64; arb_contains_fmpq(root(i).get(), x.get()) != 0; bits *= 2) refine(i, bits);
    return midpoint_of(root(i)) < x ? -1 : 1;
  }

  /// Whether a root of the event polynomial is one of another polynomial: their gcd has at most this root in its ball.
  bool is_root_of(std::size_t i, const UnivariatePolynomial& other) const {
    if (other.is_zero()) return true;
    const UnivariatePolynomial common = symbolic::gcd(polynomial_, other);
    if (common.degree() < 1) return false;
    const RealBall ball = root(i);
    const Rational lower = midpoint_of(ball) - radius_of(ball);
    const Rational upper = midpoint_of(ball) + radius_of(ball);
    return symbolic::sign_at(common, lower) * symbolic::sign_at(common, upper) <= 0;
  }

  long degree_drop(std::size_t i) const {
    long drop = 0;
    UnivariatePolynomial common;
    for (auto c = g_.coefficients.rbegin(); c != g_.coefficients.rend(); ++c, ++drop) {
      common = symbolic::gcd(common, *c);
      if (!is_root_of(i, common)) return drop;
    }
    throw PrecisionExhausted("a curve without vertical lines contains one");
  }

  /// Half the distance to the next event.
  Rational reach(std::size_t i) const {
    std::optional<Rational> distance;
    const auto consider = [&](std::size_t j) {
      const RealBall here = root(events_[i].root);
      const RealBall there = root(events_[j].root);
      const Rational between = midpoint_of(there) - midpoint_of(here);
      const Rational gap = (between.sign() < 0 ? -between : between) - radius_of(here) - radius_of(there);
      if (!distance || gap < *distance) distance = gap;
    };
    if (i > 0) consider(i - 1);
    if (i + 1 < events_.size()) consider(i + 1);
    return distance ? halved(*distance, 1) : Rational(1);
  }

  EventFibre fibre_of(std::size_t i) {
    const Event& event = events_[i];
    EventFibre fibre;
    fibre.exact_x = event.exact_x;
    fibre.vertical_line = event.vertical_line;
    std::vector<bridge::MultipleFibrePoint> multiple;
    for (const CriticalPoint& point : event.critical)
      multiple.push_back({RealBall(point.solution.y.ball.real()), point.fibre_multiplicity});
    const FibreIsolation isolation = isolate(i, multiple, fibre);
    refine_to(event.root, halved(fibre.after - fibre.before, 64));
    refine(event.root, 2 * bits_for_digits(options_.digits));
    fibre.x = root(event.root);
    RationalFibre before(g_, fibre.before, context_);
    RationalFibre after(g_, fibre.after, context_);
    const auto within = [](RationalFibre& on, const FibreInterval& interval) {
      return on.count_below(interval.upper) - on.count_below(interval.lower);
    };
    for (const FibreInterval& interval : isolation.intervals) {
      EventPoint& point = fibre.points.emplace_back();
      if (interval.multiple) {
        const CriticalPoint& critical = event.critical[*interval.multiple];
        point.critical = critical.solution;
        point.fibre_multiplicity = static_cast<unsigned long>(critical.fibre_multiplicity);
        point.y = RealBall(critical.solution.y.ball.real());
      } else {
        point.y = bridge::refine_simple_root(g_, fibre.x, interval, 64 + 4 * bits_for_digits(options_.digits));
      }
      point.left = within(before, interval);
      point.right = within(after, interval);
      if (!interval.multiple && (point.left != 1 || point.right != 1))
        throw PrecisionExhausted("a simple point of a fibre does not have one arc on each side");
      place(event, interval, point);
    }
    fibre.left_to_infinity = beyond(before, isolation.bound);
    fibre.right_to_infinity = beyond(after, isolation.bound);
    return fibre;
  }

  static std::array<std::size_t, 2> beyond(RationalFibre& fibre, const Rational& bound) {
    return {fibre.count_below(-bound), fibre.count() - fibre.count_below(bound)};
  }

  /// Makes the radius of a root at most this.
  void refine_to(std::size_t i, const Rational& radius) {
    for (long bits = 32; radius < radius_of(root(i)); bits *= 2) refine(i, bits);
  }

  /// Narrows the neighbourhood of the event until the fibre comes apart over all of it.
  FibreIsolation isolate(std::size_t i, const std::vector<bridge::MultipleFibrePoint>& multiple, EventFibre& fibre) {
    const std::size_t index = events_[i].root;
    // A power of two below half the distance, so that neighbourhoods of different events are apart.
    Rational width(1);
    for (const Rational most = halved(reach(i), 1); most < width;) width = halved(width, 1);
    const auto most_bits = static_cast<unsigned long>(256 + 8 * bits_for_digits(options_.digits));
    unsigned long step = 1;
    for (unsigned long bits = 0; bits < most_bits; bits += step, step *= 2) {
      refine_to(index, halved(width, 5));
      const Rational unit = halved(width, 3);
      const Rational quotient = midpoint_of(root(index)) / unit;
      symbolic::Integer floor;
      fmpz_fdiv_q(floor.get(), fmpq_numref(quotient.get()), fmpq_denref(quotient.get()));
      const Rational center = Rational(floor) * unit;
      fibre.before = center - width;
      fibre.after = center + width;
      const auto size =
          static_cast<long>(fibre.after.denominator().bit_length() + fibre.after.numerator().bit_length());
      FibreIsolation isolation = bridge::isolate_fibre(g_, fibre.before, fibre.after, multiple, events_[i].degree_drop,
                                                       64 + 4 * size, context_);
      if (isolation.state == FibreIsolation::State::isolated) return isolation;
      if (isolation.state == FibreIsolation::State::wide_points) throw NeedsMoreDigits();
      width = halved(width, step);
    }
    throw NeedsMoreDigits();
  }

  /// Where a point lies relative to the heights of the box.
  void place(const Event& event, const FibreInterval& interval, EventPoint& point) const {
    if (!box_) return;
    const auto side = [&](std::size_t end) {
      const Rational& height = box_->y[end];
      if (!(interval.lower < height)) return 1;
      if (!(height < interval.upper)) return -1;
      if (event.on_border[end]) {
        point.exact_y = height;
        point.y = RealBall(height, 64 + 4 * bits_for_digits(options_.digits));
        return 0;
      }
      if (arb_contains_fmpq(point.y.get(), height.get()) != 0) throw NeedsMoreDigits();
      return midpoint_of(point.y) < height ? -1 : 1;
    };
    const int lower = side(0);
    const int upper = side(1);
    point.place = lower < 0 ? -2 : lower == 0 ? -1 : upper > 0 ? 2 : upper == 0 ? 1 : 0;
  }

  const symbolic::ReducedCurve& curve_;
  HiddenVariablePolynomial g_;
  const std::optional<Box>& box_;
  const Options& options_;
  const Context& context_;
  std::vector<CriticalPoint> critical_;
  std::array<OnBorder, 2> borders_;
  UnivariatePolynomial polynomial_;
  bridge::IsolatedRoots roots_;
  std::vector<Event> events_;
  EventFibres result_;
};

}  // namespace

EventFibres event_fibres(const symbolic::ReducedCurve& curve, const std::optional<Box>& box, const Options& options,
                         const Context& context) {
  constexpr int most_doublings = 10;
  Options more = options;
  for (int doubling = 0; doubling <= most_doublings; ++doubling, more.digits *= 2) {
    try {
      return EventSearch(curve, box, more, context).run();
    } catch (const NeedsMoreDigits&) {
      context.checkpoint("enclosing critical points with more digits");
    }
  }
  throw PrecisionExhausted("critical points of the curve could not be told apart with " +
                           std::to_string(more.digits / 2) + " digits");
}

Place place_of(RationalFibre& fibre, std::size_t root, const std::optional<Box>& box) {
  if (!box) return 0;
  const int lower = fibre.position(root, box->y[0]);
  if (lower <= 0) return lower - 1;
  const int upper = fibre.position(root, box->y[1]);
  return upper < 0 ? 0 : 1 + upper;
}

}  // namespace eliminant::intersect
