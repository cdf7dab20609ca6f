// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/cylinders/cylinders.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/bridge/enclosures/decimal.hpp>
#include <eliminant/intersect/cylinders/cylinder_axis.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>
#include <eliminant/symbolic/arithmetic/parse_number.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::CylinderConditions;
using symbolic::Polynomial;
using symbolic::Rational;

constexpr long most_digits = 40000;
// Of the directions in between, the most that plane curves have.
constexpr long most_working_digits = 100000;

/// The directions (x, y, 1 + k x + (k^2 + 1) y). A direction is missing in two of these charts at most: the condition
/// on k is quadratic.
struct Chart {
  long k = 1;
  long a() const { return k; }
  long b() const { return k * k + 1; }

  Polynomial in_chart(const Polynomial& form) const {
    const Polynomial x = Polynomial::variable(2, 0);
    const Polynomial y = Polynomial::variable(2, 1);
    const std::array<Polynomial, 3> images{
        x, y, Polynomial::constant(2, Rational(1)) + Rational(a()) * x + Rational(b()) * y};
    return form.compose(images);
  }

  BallVector direction(const Solution& solution, long precision_bits) const {
    BallVector t{solution.x.ball, solution.y.ball, ComplexBall(1, 0)};
    for (std::size_t i = 0; i < 2; ++i) {
      ComplexBall term;
      acb_mul_si(term.get(), t[i].get(), i == 0 ? a() : b(), precision_bits);
      acb_add(t[2].get(), t[2].get(), term.get(), precision_bits);
    }
    return t;
  }

  /// The form of least degree that is the polynomial in this chart.
  Polynomial homogenized(const Polynomial& p) const {
    const Polynomial x = Polynomial::variable(3, 0);
    const Polynomial y = Polynomial::variable(3, 1);
    const Polynomial one = Polynomial::variable(3, 2) - Rational(a()) * x - Rational(b()) * y;
    const auto degree = static_cast<unsigned long>(std::max(0L, p.total_degree()));
    Polynomial form(3);
    for (const Polynomial::Term& term : p.terms()) {
      const unsigned long i = term.exponents[0];
      const unsigned long j = term.exponents[1];
      form = form + term.coefficient * power(x, i) * power(y, j) * power(one, degree - i - j);
    }
    return form.primitive_part();
  }
};

struct DirectionsInChart {
  Chart chart;
  Result result;
};

/// The common zeros of two forms in a chart that shows all of them.
DirectionsInChart solve_directions(const Polynomial& first, const Polynomial& second, const Options& options,
                                   const Context& context) {
  DirectionsInChart solved;
  for (solved.chart.k = 1;; ++solved.chart.k) {
    PlaneCurvesProblem problem;
    problem.p = solved.chart.in_chart(first);
    problem.q = solved.chart.in_chart(second);
    // Where a form contains the line at infinity its degree is smaller here.
    if (problem.p.total_degree() < first.total_degree() || problem.q.total_degree() < second.total_degree()) continue;
    solved.result = intersect_plane_curves(problem, options, context);
    if (solved.result.counts.at_infinity == 0) return solved;
  }
}

/// t.t.
Polynomial square_of_direction() {
  Polynomial sum(3);
  for (std::size_t i = 0; i < 3; ++i) sum = sum + Polynomial::variable(3, i) * Polynomial::variable(3, i);
  return sum;
}

unsigned long distinct_zeros(const Polynomial& first, const Polynomial& second, const Options& options,
                             const Context& context) {
  Options exact;
  exact.seed = options.seed;
  const Result result = solve_directions(first, second, exact, context).result;
  if (result.status != Status::certified)
    throw PrecisionExhausted("isotropic directions could not be told from others");
  return result.counts.distinct;
}

/// How many different common zeros of the conditions have t.t = 0: those of one condition with the product of the other
/// and t.t are fewer than those with each.
unsigned long count_isotropic(const CylinderConditions& conditions, unsigned long distinct, const Options& options,
                              const Context& context) {
  const Polynomial square = square_of_direction();
  if (conditions.first == square) return distinct;
  return distinct + distinct_zeros(conditions.first, square, options, context) -
         distinct_zeros(conditions.first, conditions.second * square, options, context);
}

/// The six printed parts of a direction.
std::array<Rational, 6> printed_direction(const CylinderSolution& solution) {
  std::array<Rational, 6> parts;
  for (std::size_t i = 0; i < 3; ++i) {
    parts[2 * i] = symbolic::parse_number(solution.direction[i].real);
    parts[2 * i + 1] = symbolic::parse_number(solution.direction[i].imaginary);
  }
  return parts;
}

/// A solution with the index of its direction and the numbers that are printed of that.
struct FoundCylinder {
  std::size_t index = 0;
  CylinderSolution solution;
  std::array<Rational, 6> direction;
};

bool printed_boxes_meet(const FoundCylinder& u, const FoundCylinder& v) {
  const auto radius = [](const FoundCylinder& found) {
    return bridge::Decimal{symbolic::Integer(1), found.solution.direction_error_exponent}.to_rational();
  };
  const Rational reach = radius(u) + radius(v);
  const auto near = [&reach](const Rational& x) { return !(reach < x) && !(reach < -x); };
  const auto meet = [&](bool negated) {
    for (std::size_t k = 0; k < 6; ++k)
      if (!near(negated ? u.direction[k] + v.direction[k] : u.direction[k] - v.direction[k])) return false;
    return true;
  };
  // The sign of a real direction that has two largest coordinates may differ from that of its neighbour.
  const bool real = u.solution.reality == Reality::real && v.solution.reality == Reality::real;
  return meet(false) || (real && meet(true));
}

/// One computation of all cylinders.
class CylinderSolver {
 public:
  CylinderSolver(const CylindersProblem& problem, const Options& options, const Context& context,
                 CylindersResult& result)
      : points_(problem.points), options_(options), context_(context), result_(result) {
    working_.field = Field::complex;
    working_.certificate = false;
  }

  void run() {
    const CylinderConditions conditions = symbolic::cylinder_conditions(points_);
    finish("conditions");
    if (conditions.kind == CylinderConditions::Kind::infinite) {
      result_.status = Status::infinite;
      result_.degeneracy = conditions.reason;
      result_.directions = conditions.directions;
      result_.engine.method = "none";
      return;
    }
    if (conditions.kind == CylinderConditions::Kind::parabola) {
      result_.status = options_.certify ? Status::certified : Status::numeric;
      result_.degeneracy = "all points are on a parabola in a plane, which is on no cylinder";
      result_.engine.method = "none";
      return;
    }
    if (conditions.kind == CylinderConditions::Kind::coplanar) result_.degeneracy = "all points are in a plane";
    solve(conditions);
  }

  /// Adds the time since the last call to a stage.
  void finish(const std::string& stage) {
    const auto now = Clock::now();
    if (result_.seconds.empty()) result_.seconds.emplace_back("total", 0.0);
    const double elapsed = std::chrono::duration<double>(now - last_).count();
    const auto known = std::find_if(result_.seconds.begin(), result_.seconds.end(),
                                    [&stage](const auto& entry) { return entry.first == stage; });
    if (known == result_.seconds.end())
      result_.seconds.emplace_back(stage, elapsed);
    else
      known->second += elapsed;
    result_.seconds.front().second = std::chrono::duration<double>(now - start_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void solve(const CylinderConditions& conditions) {
    constexpr long guard_digits = 12;
    digits_.assign(1, options_.digits);
    std::optional<unsigned long> isotropic;
    for (long digits = options_.digits + guard_digits;; digits *= 2) {
      working_.digits = std::min(digits, most_working_digits);
      const DirectionsInChart solved = solve_directions(conditions.first, conditions.second, working_, context_);
      if (!begin(solved)) return;
      const bool printed = print(solved, isotropic);
      if (printed && !widen_crowded()) break;
      if (digits >= most_working_digits)
        throw PrecisionExhausted("the cylinders could not be enclosed with " + std::to_string(most_working_digits) +
                                 " digits: the coordinates of the points are too different in size");
      if (!printed && !isotropic && conditions.kind == CylinderConditions::Kind::general)
        isotropic = count_isotropic(conditions, solved.result.counts.distinct, options_, context_);
    }
    list();
    finish("axes");
  }

  /// Copies what is known of the directions; false when that is all there is.
  bool begin(const DirectionsInChart& solved) {
    const Result& directions = solved.result;
    finish("directions");
    result_.engine = directions.engine;
    result_.status = directions.status;
    result_.rest_status = directions.rest_status;
    result_.limit = directions.limit;
    result_.warnings = directions.warnings;
    if (directions.status == Status::incomplete) return false;
    if (directions.common_component) {
      result_.degeneracy = "the conditions on the direction have a common component";
      result_.directions = solved.chart.homogenized(*directions.common_component);
    }
    result_.counts = {};
    result_.counts.bezout_number = directions.counts.bezout_number;
    return true;
  }

  /// Computes all cylinders from their directions; false where these are not accurate enough. When the number of
  /// isotropic directions is known and no more can be isotropic, all of these are.
  bool print(const DirectionsInChart& solved, std::optional<unsigned long> isotropic) {
    const long precision_bits = bits_for_digits(working_.digits) + 64;
    found_.clear();
    unsigned long not_printed = 0;
    if (digits_.size() != solved.result.solutions.size())
      digits_.assign(solved.result.solutions.size(), options_.digits);
    for (std::size_t i = 0; i < solved.result.solutions.size(); ++i) {
      const Solution& found = solved.result.solutions[i];
      const bool real = found.reality == Reality::real;
      const BallVector t = solved.chart.direction(found, precision_bits);
      if (isotropic && acb_contains_zero(dot_product(t, t, precision_bits).get()) != 0) {
        ++not_printed;
        result_.counts.isotropic += found.multiplicity;
        continue;
      }
      const std::optional<CylinderBalls> cylinder = cylinder_of_direction(points_, t, real, precision_bits);
      if (!cylinder) return false;
      std::optional<CylinderSolution> printed = print_cylinder(points_, *cylinder, real, digits_[i], precision_bits);
      if (!printed) return false;
      printed->reality = found.reality;
      printed->multiplicity = found.multiplicity;
      printed->certified = found.certified;
      printed->reason = found.reason;
      std::array<Rational, 6> direction = printed_direction(*printed);
      found_.push_back({i, *std::move(printed), std::move(direction)});
    }
    return not_printed == isotropic.value_or(0);
  }

  /// Gives more digits to solutions whose printed directions could be the same, or isotropic; false when there are
  /// none.
  bool widen_crowded() {
    std::vector<bool> crowded(digits_.size(), false);
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (found_[i].solution.residual_exponent == unbounded_residual) crowded[found_[i].index] = true;
      for (std::size_t j = i + 1; j < found_.size(); ++j)
        if (printed_boxes_meet(found_[i], found_[j])) crowded[found_[i].index] = crowded[found_[j].index] = true;
    }
    for (std::size_t i = 0; i < digits_.size(); ++i)
      if (crowded[i]) digits_[i] *= 2;
    return std::find(crowded.begin(), crowded.end(), true) != crowded.end();
  }

  void list() {
    CylinderCounts& counts = result_.counts;
    std::stable_sort(found_.begin(), found_.end(), [](const FoundCylinder& a, const FoundCylinder& b) {
      return std::lexicographical_compare(a.direction.begin(), a.direction.end(), b.direction.begin(),
                                          b.direction.end());
    });
    for (FoundCylinder& found : found_) {
      ++counts.distinct;
      counts.with_multiplicity += found.solution.multiplicity;
      const bool real = found.solution.reality == Reality::real;
      if (real) ++counts.real;
      if (options_.field != Field::real || real) result_.solutions.push_back(std::move(found.solution));
    }
    counts.listed = result_.solutions.size();
  }

  const std::array<symbolic::SpacePoint, 5>& points_;
  const Options& options_;
  Options working_ = options_;
  const Context& context_;
  CylindersResult& result_;
  std::vector<long> digits_;
  std::vector<FoundCylinder> found_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace

CylindersResult cylinders_through(const CylindersProblem& problem, const Options& options, const Context& context) {
  symbolic::install_flint_error_handler();
  if (options.digits < 1 || options.digits > most_digits)
    throw InvalidInput("digits is " + std::to_string(options.digits) + " for cylinders",
                       "a whole number from 1 to " + std::to_string(most_digits));
  CylindersResult result;
  result.engine.seed = options.seed;
  CylinderSolver(problem, options, context, result).run();
  return result;
}

}  // namespace eliminant::intersect
