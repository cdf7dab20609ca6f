// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/plane_curves/make_certificate.hpp>
#include <eliminant/intersect/plane_curves/pencil_candidates.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>
#include <eliminant/intersect/plane_curves/solution_set.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>
#include <eliminant/symbolic/elimination/change_of_variables.hpp>
#include <eliminant/symbolic/elimination/common_component.hpp>
#include <eliminant/symbolic/elimination/solution_profile.hpp>
#include <eliminant/symbolic/elimination/squarefree.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::Polynomial;
using symbolic::SolutionProfile;

/// The dense eigenproblems grow with the cube of the columns: beyond these the exact engine is faster and smaller.
constexpr long largest_double_pencil = 2500;
constexpr long largest_multiprecision_pencil = 500;

/// Beyond this number of solutions no engine answers in reasonable time.
constexpr unsigned long largest_bezout_number = 20000;

/// Rows of the relations of the graded pencil: monomials of degree < m in y and total degree < m + n - 1.
long graded_rows(long m, long n) {
  long rows = 0;
  for (long j = 0; j < m; ++j) rows += m + n - 1 - j;
  return rows;
}

/// Wall-clock seconds of the stages of one solve.
class StageClock {
 public:
  explicit StageClock(Result& result) : result_(result), start_(Clock::now()), last_(start_) {
    result_.seconds.emplace_back("total", 0.0);
  }
  void finish(const std::string& stage) {
    const auto now = Clock::now();
    result_.seconds.emplace_back(stage, std::chrono::duration<double>(now - last_).count());
    last_ = now;
    result_.seconds.front().second = std::chrono::duration<double>(now - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Result& result_;
  Clock::time_point start_;
  Clock::time_point last_;
};

void check(const PlaneCurvesProblem& problem, const Options& options) {
  for (const Polynomial* curve : {&problem.p, &problem.q})
    if (curve->variable_count() != 2)
      throw InvalidInput(
          "a plane curve was given by a polynomial in " + std::to_string(curve->variable_count()) + " variables",
          "two variables");
  if (options.engine == Engine::box)
    throw InvalidInput("the engine box is for curves and patches with bounded domains", "auto, pencil or exact");
  if (options.digits < 1 || options.digits > 100000)
    throw InvalidInput("digits is " + std::to_string(options.digits), "a number from 1 to 100000");
  constexpr std::array<int, 6> precisions{0, 53, 128, 256, 512, 1024};
  if (std::find(precisions.begin(), precisions.end(), options.precision_bits) == precisions.end())
    throw InvalidInput("the precision is " + std::to_string(options.precision_bits),
                       "auto, 53, 128, 256, 512 or 1024 bits");
  if (options.epsilon && !(*options.epsilon > 0 && *options.epsilon < 1))
    throw InvalidInput("epsilon is not between 0 and 1", "a number between 0 and 1");
  if (!problem.box) return;
  for (const auto* side : {&problem.box->x, &problem.box->y})
    if ((*side)[1] < (*side)[0])
      throw InvalidInput("a side of the box is [" + (*side)[0].to_string() + ", " + (*side)[1].to_string() + "]",
                         "a lower end that is not above the upper end");
}

/// One solve of two coprime curves, none of them constant.
class Solver {
 public:
  Solver(const Polynomial& p, const Polynomial& q, Wanted wanted, const Options& options, const Context& context,
         Result& result, StageClock& clock)
      : p_(p),
        q_(q),
        options_(options),
        context_(context),
        result_(result),
        clock_(clock),
        wanted_(wanted),
        set_(p, q, wanted, context) {}

  /// Fills the counts, the engine report and the set; true when every wanted solution is proven and none is missing.
  bool run() {
    result_.engine.seed = options_.seed;
    counts().bezout_number =
        static_cast<unsigned long>(p_.total_degree()) * static_cast<unsigned long>(q_.total_degree());
    if (counts().bezout_number > largest_bezout_number)
      throw LimitReached("the curves of degrees " + std::to_string(p_.total_degree()) + " and " +
                         std::to_string(q_.total_degree()) + " may have " + std::to_string(counts().bezout_number) +
                         " intersections; the limit is " + std::to_string(largest_bezout_number));
    if (options_.engine == Engine::pencil) count_by_clusters();
    if (!solve_product() && !solve_generic()) solve_counted();
    set_.decide_reality();
    clock_.finish("certification");
    report_method();
    return missing_ == 0;
  }

  /// The number of simple solutions that the pencil engine did not find, known after run().
  unsigned long missing() const { return missing_; }

  SolutionSet& set() { return set_; }

  /// After a limit: what was found so far, each point once.
  const SolutionSet& found_so_far() {
    if (superseded_.size() > set_.points().size()) set_.put_back(std::move(superseded_));
    return set_;
  }

  /// The number of distinct solutions, known after run().
  unsigned long expected_distinct() const {
    return set_.representation() ? set_.representation()->distinct() : profile_.distinct();
  }

 private:
  Counts& counts() { return result_.counts; }

  /// One curve in x only, the other in y only: the solutions are pairs of roots of univariate polynomials.
  bool solve_product() {
    const bool x_then_y = p_.degree(1) == 0 && q_.degree(0) == 0;
    const bool y_then_x = p_.degree(0) == 0 && q_.degree(1) == 0;
    const bool nothing_asked = options_.engine != Engine::pencil && options_.matrix == ResultantMatrix::automatic &&
                               options_.precision_bits == 0 && !options_.epsilon;
    if (!x_then_y && !y_then_x) return false;
    // A resultant matrix of the two is a multiple of a constant one and knows nothing of the other variable.
    if (!nothing_asked)
      result_.warnings.emplace_back(
          "each curve is in one variable: their roots were paired, there is no resultant matrix with a kernel to "
          "solve");
    const auto factors = [&](const Polynomial& curve, std::size_t hidden) {
      return symbolic::squarefree_decomposition(symbolic::hide_variable(curve, hidden).leading_coefficient());
    };
    const std::vector<symbolic::SquarefreeFactor> x_factors = factors(x_then_y ? p_ : q_, 0);
    const std::vector<symbolic::SquarefreeFactor> y_factors = factors(x_then_y ? q_ : p_, 1);
    set_.add_product(x_factors, y_factors);
    profile_.bezout_holds = true;
    profile_.with_multiplicity = counts().bezout_number;
    for (const symbolic::SquarefreeFactor& in_x : x_factors)
      for (const symbolic::SquarefreeFactor& in_y : y_factors) {
        auto& distinct = profile_.distinct_by_multiplicity;
        const unsigned long multiplicity = in_x.multiplicity * in_y.multiplicity;
        distinct.resize(std::max<std::size_t>(distinct.size(), multiplicity), 0);
        distinct[multiplicity - 1] += static_cast<unsigned long>(in_x.factor.degree() * in_y.factor.degree());
      }
    counts().with_multiplicity = counts().bezout_number;
    clock_.finish("roots of both polynomials");
    return true;
  }

  /// The pencil's own word on the multiplicities, before the exact side is asked.
  void count_by_clusters() {
    constexpr unsigned long most_solutions = 100;
    if (counts().bezout_number > most_solutions) return;
    const bridge::PowerOfTwoScaling scaling = bridge::choose_scaling(p_, q_);
    result_.engine.pencil_multiplicities =
        pencil_multiplicities(scaled(p_, scaling), scaled(q_, scaling), options_.seed, context_);
    clock_.finish("clusters of the graded pencil");
  }

  /// The generic case, which needs no elimination: nothing at infinity, and as many simple solutions proven as Bezout's
  /// number. False when that was not tried or did not come out; what was found is kept.
  bool solve_generic() {
    const bool graded_allowed =
        options_.matrix == ResultantMatrix::automatic || options_.matrix == ResultantMatrix::hybrid;
    const long m = std::max(p_.total_degree(), q_.total_degree());
    const long n = std::min(p_.total_degree(), q_.total_degree());
    if (options_.engine == Engine::exact || !graded_allowed || options_.epsilon ||
        graded_rows(m, n) > std::min(largest_double_pencil * 3 / 2, 4 * m * n + 200) ||
        (options_.precision_bits != 0 && options_.precision_bits != 53) ||
        !symbolic::do_not_meet_at_infinity(p_, q_, options_.seed))
      return false;
    const bridge::PowerOfTwoScaling scaling = bridge::choose_scaling(p_, q_);
    const Polynomial p = scaled(p_, scaling);
    const Polynomial q = scaled(q_, scaling);
    graded_tried_ = true;
    add_candidates(graded_pencil_candidates(p, q, false, context_), 0, scaling, counts().bezout_number);
    // Where more are missing, multiple solutions are the likely reason: the exact count will tell, and quickly where
    // there are few solutions.
    constexpr unsigned long few_solutions = 200;
    const unsigned long missing = counts().bezout_number - set_.points().size();
    if (counts().bezout_number > few_solutions && missing <= 4 + counts().bezout_number / 16)
      add_in_ball_arithmetic(counts().bezout_number);
    clock_.finish("graded pencil");
    if (set_.points().size() < counts().bezout_number) return false;
    profile_.bezout_holds = true;
    profile_.with_multiplicity = counts().bezout_number;
    profile_.distinct_by_multiplicity = {counts().bezout_number};
    counts().with_multiplicity = counts().bezout_number;
    return true;
  }

  /// The general case: count first, exactly, then find.
  void solve_counted() {
    profile_ = symbolic::solution_profile(p_, q_, options_.seed, context_);
    // Simple solutions only, and as many as Bezout's number: nothing else has to be known exactly beforehand.
    if (options_.engine == Engine::exact || !profile_.all_simple()) represent();
    if (!profile_.all_simple() && !set_.representation())
      throw PrecisionExhausted("no shear could be proven to separate the solutions");
    count_with_multiplicity();
    clock_.finish("exact count");
    if (options_.matrix == ResultantMatrix::hybrid && !graded_tried_ && options_.engine != Engine::exact)
      result_.warnings.emplace_back(
          "the hybrid matrix is for curves that do not meet at infinity, in double precision, without epsilon; the "
          "bezout matrix was used");
    if (options_.engine != Engine::exact) solve_by_pencil();
    add_exact_classes(set_.points().size() == expected_simple());
  }

  static Polynomial scaled(const Polynomial& p, const bridge::PowerOfTwoScaling& scaling) {
    return symbolic::scale_by_powers_of_two(p, scaling.x_log2, scaling.y_log2).primitive_part();
  }

  unsigned long expected_simple() const {
    if (!set_.representation()) return profile_.distinct();
    for (const auto& part : set_.representation()->classes)
      if (part.multiplicity == 1) return static_cast<unsigned long>(part.factor.degree());
    return 0;
  }

  /// Computes the representation with the first shear that can be proven generic.
  void represent() {
    if (set_.representation()) return;
    constexpr int attempts = 64;
    long shear = profile_.shear;
    for (int attempt = 0; attempt<attempts; ++attempt, shear = shear> 0 ? -shear : 1 - shear) {
      if (!symbolic::is_admissible_shear(p_, q_, shear)) continue;
      auto representation = symbolic::univariate_representation(p_, q_, shear, options_.seed, context_);
      if (!representation) continue;
      result_.engine.shear = shear;
      set_.set_representation(std::move(*representation));
      return;
    }
  }

  /// The number of affine solutions with multiplicity, proven: by Bezout's theorem when nothing lies at infinity, else
  /// by the degree of the Chow form over Z.
  void count_with_multiplicity() {
    unsigned long total = profile_.with_multiplicity;
    if (set_.representation()) {
      total = set_.representation()->with_multiplicity();
    } else if (!profile_.bezout_holds) {
      const auto form = symbolic::chow_form(p_, q_, profile_.shear, false, options_.seed, context_).form;
      if (form.degree() != static_cast<long>(total)) {  // the prime of the profile was unlucky
        represent();
        if (!set_.representation()) throw PrecisionExhausted("no shear could be proven to separate the solutions");
        total = set_.representation()->with_multiplicity();
      }
    }
    counts().with_multiplicity = total;
    counts().at_infinity = counts().bezout_number - total;
  }

  void solve_by_pencil() {
    std::vector<int> ladder{options_.precision_bits};
    if (options_.precision_bits == 0)
      ladder = options_.engine == Engine::pencil ? std::vector<int>{53, 128, 256, 512, 1024} : std::vector<int>{53};
    const bridge::PowerOfTwoScaling scaling = bridge::choose_scaling(p_, q_);
    const Polynomial p = scaled(p_, scaling);
    const Polynomial q = scaled(q_, scaling);
    const std::size_t first = smaller_pencil_variable(p, q, options_.matrix);
    if (graded_tried_ && set_.points().size() < expected_simple()) {
      // Where a line holds two solutions, or nearly so, eigenvalues alone do not lead to them; eigenvectors may.
      std::vector<PencilCandidates::Candidate> left = std::move(unproven_);
      add_candidates(graded_pencil_candidates(p, q, true, context_), 0, scaling, expected_simple());
      unproven_.insert(unproven_.end(), std::make_move_iterator(left.begin()), std::make_move_iterator(left.end()));
      add_in_ball_arithmetic(expected_simple());
      clock_.finish("graded pencil with eigenvectors");
    }
    for (const int precision_bits : ladder) {
      // The other orientation is a second, independent chance.
      for (const std::size_t hidden : {first, 1 - first}) {
        if (set_.points().size() == expected_simple()) return;
        const std::size_t eliminated = 1 - hidden;
        if (std::max(p.degree(eliminated), q.degree(eliminated)) < 1) continue;
        // After the graded pencil a large companion pencil would hardly find more.
        const bool second_chance = graded_tried_ && options_.engine != Engine::pencil;
        const long limit = precision_bits > 53 || second_chance ? largest_multiprecision_pencil : largest_double_pencil;
        const long size = companion_pencil_size(p, q, hidden, options_.matrix);
        if (size > limit) continue;
        // Far more columns than solutions: the exact engine is quicker.
        constexpr long small_pencil = 200;
        const auto solutions = static_cast<long>(profile_.with_multiplicity);
        if (options_.engine != Engine::pencil && options_.precision_bits == 0 && size > small_pencil + 3 * solutions)
          continue;
        add_candidates(pencil_candidates(p, q, hidden, precision_bits, options_, context_), hidden, scaling,
                       expected_simple());
        add_in_ball_arithmetic(expected_simple());
        clock_.finish(precision_bits == 53 ? "pencil in double precision"
                                           : "pencil at " + std::to_string(precision_bits) + " bits");
      }
    }
  }

  /// Proves what doubles can prove of the candidates, until there are as many points as `wanted`; the others wait for
  /// add_in_ball_arithmetic.
  void add_candidates(PencilCandidates found, std::size_t hidden, const bridge::PowerOfTwoScaling& scaling,
                      unsigned long wanted) {
    EngineReport& report = result_.engine;
    report.matrix = found.report.matrix;
    report.hidden_variable = result_.variables[hidden];
    report.matrix_size = found.report.matrix_size;
    report.matrix_degree = found.report.matrix_degree;
    report.pencil_size = found.report.pencil_size;
    report.regular_size = found.report.regular_size;
    report.precision_bits = found.report.precision_bits;
    unproven_.clear();
    for (auto& candidate : found.candidates) {
      if (set_.points().size() == wanted) return;
      for (bridge::PlaneBall* point : {&candidate.approximate, &candidate.refined}) {
        acb_mul_2exp_si(point->x.get(), point->x.get(), scaling.x_log2);
        acb_mul_2exp_si(point->y.get(), point->y.get(), scaling.y_log2);
      }
      if (!add_candidate(candidate, scaling, 53)) unproven_.push_back(std::move(candidate));
    }
  }

  /// Candidates that doubles could not prove, in more precision. A candidate near a multiple solution costs much and
  /// comes to nothing: after more failures than there are solutions missing it is left to the exact side.
  void add_in_ball_arithmetic(unsigned long wanted) {
    const long max_precision_bits = std::max(1024, 2 * result_.engine.precision_bits);
    unsigned long failures = 0;
    for (const auto& candidate : unproven_) {
      const unsigned long found = set_.points().size();
      if (found >= wanted || failures > 4 + 2 * (wanted - found)) break;
      if (!add_candidate(candidate, bridge::choose_scaling(p_, q_), max_precision_bits)) ++failures;
    }
    unproven_.clear();
  }

  /// True when a new solution was proven.
  bool add_candidate(const PencilCandidates::Candidate& candidate, const bridge::PowerOfTwoScaling& scaling,
                     long max_precision_bits) {
    const int added = set_.add_simple(candidate.refined, first_radius_log2, max_precision_bits,
                                      std::max(96, result_.engine.precision_bits));
    if (added == 0) return false;
    const std::size_t first_new = set_.points().size() - static_cast<std::size_t>(added);
    note_error(candidate.approximate, set_.points()[first_new].box, scaling);
    return true;
  }

  /// Tight enough to print 15 digits of most solutions without enclosing them again. The same for any number of digits,
  /// which must not decide what is found.
  static constexpr long first_radius_log2 = -bits_for_digits(15) - 2;

  /// Distance of the pencil's answer from the solution just added, relative to max(1, |coordinate|), measured in the
  /// scaled coordinates in which the pencil worked.
  void note_error(const bridge::PlaneBall& approximate, const bridge::PlaneBall& box,
                  const bridge::PowerOfTwoScaling& scaling) {
    const auto relative_distance = [](const bridge::ComplexBall& found, const bridge::ComplexBall& truth, long log2) {
      bridge::ComplexBall exact = truth;
      acb_mul_2exp_si(exact.get(), exact.get(), -log2);
      bridge::ComplexBall difference;
      acb_sub(difference.get(), found.get(), truth.get(), 64);
      acb_mul_2exp_si(difference.get(), difference.get(), -log2);
      const auto magnitude = [](const bridge::ComplexBall& z) {
        return std::hypot(arf_get_d(arb_midref(z.real()), ARF_RND_NEAR),
                          arf_get_d(arb_midref(z.imaginary()), ARF_RND_NEAR));
      };
      return magnitude(difference) / std::max(1.0, magnitude(exact));
    };
    const double error = std::max(relative_distance(approximate.x, box.x, scaling.x_log2),
                                  relative_distance(approximate.y, box.y, scaling.y_log2));
    auto& largest = result_.engine.largest_error_before_refinement;
    largest = std::max(largest.value_or(0), error);
  }

  /// Multiple solutions come from the representation, and so do the simple ones that the pencil did not all find.
  void add_exact_classes(bool pencil_complete) {
    std::vector<bridge::PlaneBall> known;
    if (!pencil_complete && options_.engine == Engine::pencil) {
      missing_ = expected_simple() - static_cast<unsigned long>(set_.points().size());
      result_.warnings.push_back("the pencil engine found " + std::to_string(set_.points().size()) + " of " +
                                 std::to_string(expected_simple()) + " simple solutions");
    } else if (!pencil_complete) {
      represent();
      if (!set_.representation()) throw PrecisionExhausted("no shear could be proven to separate the solutions");
      if (options_.engine != Engine::exact)
        result_.warnings.push_back("the pencil engine found " + std::to_string(set_.points().size()) + " of " +
                                   std::to_string(expected_simple()) + " simple solutions; the exact engine computed " +
                                   (wanted_ == Wanted::all ? "all of them" : "the real ones"));
      for (std::size_t i = 0; i < set_.points().size() && wanted_ == Wanted::all; ++i) {
        // Beyond double precision: the roots of the eliminant may need it.
        set_.enclose(i, 4 * first_radius_log2);
        known.push_back(set_.points()[i].box);
      }
      superseded_ = set_.take_points();
    }
    if (!set_.representation()) return;
    const auto& classes = set_.representation()->classes;
    const bool simple_too = !pencil_complete && options_.engine != Engine::pencil;
    for (std::size_t k = 0; k < classes.size(); ++k)
      if (classes[k].multiplicity > 1 || simple_too)
        set_.add_class(k, classes[k].multiplicity == 1 ? known : std::vector<bridge::PlaneBall>{});
    superseded_.clear();
  }

  void report_method() {
    const bool from_pencil = std::any_of(set_.points().begin(), set_.points().end(), [](const EnclosedPoint& point) {
      return !point.class_index && !point.product;
    });
    const bool from_representation =
        std::any_of(set_.points().begin(), set_.points().end(),
                    [](const EnclosedPoint& point) { return point.class_index || point.product; });
    result_.engine.method = from_pencil && from_representation ? "pencil+exact"
                            : from_pencil                      ? "pencil"
                            : from_representation              ? "exact"
                                                               : "none";
  }

  const Polynomial& p_;
  const Polynomial& q_;
  const Options& options_;
  const Context& context_;
  Result& result_;
  StageClock& clock_;
  Wanted wanted_;
  SolutionSet set_;
  /// What the pencil found, while the exact engine finds it again.
  std::vector<EnclosedPoint> superseded_;
  SolutionProfile profile_;
  std::vector<PencilCandidates::Candidate> unproven_;
  bool graded_tried_ = false;
  unsigned long missing_ = 0;
};

/// Whether a real point lies in the closed box, decided exactly: equality with a border has been found before.
bool inside(SolutionSet& set, std::size_t index, const Box& box) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& side = axis == 0 ? box.x : box.y;
    for (std::size_t end = 0; end < 2; ++end) {
      const symbolic::Rational& border = side[end];
      for (long target_log2 = -64;; target_log2 *= 2) {
        const EnclosedPoint& point = set.points()[index];
        const auto& exact = axis == 0 ? point.exact_x : point.exact_y;
        if (exact && *exact == border) break;
        const bridge::ComplexBall& coordinate = axis == 0 ? point.box.x : point.box.y;
        if (!arb_contains_fmpq(coordinate.real(), border.get())) {
          const long precision_bits = 2 * std::labs(target_log2) + 128;
          bridge::RealBall difference(border, precision_bits);
          arb_sub(difference.get(), coordinate.real(), difference.get(), precision_bits);
          if (end == 0 ? arb_is_positive(difference.get()) : arb_is_negative(difference.get())) break;
          if (end == 0 ? arb_is_negative(difference.get()) : arb_is_positive(difference.get())) return false;
        }
        set.enclose(index, target_log2);
      }
    }
  }
  return true;
}

std::vector<std::size_t> listed_points(SolutionSet& set, const PlaneCurvesProblem& problem, const Options& options) {
  const bool real_only = problem.box || options.field == Field::real;
  if (problem.box)
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (const symbolic::Rational& border : axis == 0 ? problem.box->x : problem.box->y)
        set.find_exact_coordinate(axis, border);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < set.points().size(); ++i) {
    if (real_only && set.points()[i].reality != Reality::real) continue;
    if (problem.box && !inside(set, i, *problem.box)) continue;
    indices.push_back(i);
  }
  return indices;
}

/// Fills the solutions and the counts of a complete run.
void list_solutions(Solver& solver, const PlaneCurvesProblem& problem, const Options& options, Result& result) {
  Counts& counts = result.counts;
  counts.distinct = solver.expected_distinct();
  for (const EnclosedPoint& point : solver.set().points()) {
    if (point.reality == Reality::real) ++counts.real;
    if (point.reality == Reality::undecided) ++counts.undecided;
  }
  // What was not found is neither proven real nor proven non-real.
  counts.undecided += solver.missing();
  result.solutions = present(solver.set(), listed_points(solver.set(), problem, options), options.digits);
}

/// Fills them after a limit, without any further computation: the counts are of what is listed.
void list_found(const SolutionSet& set, const PlaneCurvesProblem& problem, const Options& options, Result& result) {
  const auto surely_inside = [](const bridge::ComplexBall& coordinate, const std::array<symbolic::Rational, 2>& side) {
    constexpr long precision_bits = 128;
    return arb_ge(coordinate.real(), bridge::RealBall(side[0], precision_bits).get()) != 0 &&
           arb_le(coordinate.real(), bridge::RealBall(side[1], precision_bits).get()) != 0;
  };
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < set.points().size(); ++i) {
    const EnclosedPoint& point = set.points()[i];
    if ((problem.box || options.field == Field::real) && point.reality != Reality::real) continue;
    if (problem.box && !(surely_inside(point.box.x, problem.box->x) && surely_inside(point.box.y, problem.box->y)))
      continue;
    indices.push_back(i);
  }
  result.solutions = present_as_enclosed(set, indices, options.digits);
  Counts counts;
  counts.bezout_number = result.counts.bezout_number;
  for (Solution& solution : result.solutions) {
    solution.reason = "a limit was reached";
    ++counts.distinct;
    ++counts.listed;
    counts.with_multiplicity += solution.multiplicity;
    if (solution.reality == Reality::real) ++counts.real;
    if (solution.reality == Reality::undecided) ++counts.undecided;
  }
  result.counts = counts;
}

}  // namespace

Result intersect_plane_curves(const PlaneCurvesProblem& problem, const Options& options, const Context& context) {
  symbolic::install_flint_error_handler();
  check(problem, options);
  Result result;
  result.variables = problem.variables;
  StageClock clock(result);
  if (problem.box && options.field == Field::complex)
    result.warnings.emplace_back("a box is a part of the real plane: only the real solutions in it are listed");

  const symbolic::CommonComponent split = symbolic::split_common_component(problem.p, problem.q);
  clock.finish("common component");
  const bool infinite = !split.component.is_constant() || split.component.is_zero();
  if (infinite) result.common_component = split.component;
  bool proven = true;
  // A zero or constant cofactor leaves nothing to intersect.
  if (split.first.is_constant() || split.second.is_constant()) {
    result.engine.method = "none";
    result.engine.seed = options.seed;
    if (options.certificate) result.certificate = make_certificate(problem, split, nullptr, context);
  } else {
    // A certificate is of all solutions.
    const bool real_only = (problem.box || options.field == Field::real) && !options.certificate;
    Solver solver(split.first, split.second, real_only ? Wanted::real : Wanted::all, options, context, result, clock);
    try {
      proven = solver.run();
      list_solutions(solver, problem, options, result);
      clock.finish("refinement");
      if (options.certificate && proven) {
        result.certificate = make_certificate(problem, split, &solver.set(), context);
        clock.finish("certificate");
      }
    } catch (const LimitReached& limit) {
      if (solver.found_so_far().points().empty()) throw;
      list_found(solver.found_so_far(), problem, options, result);
      result.status = Status::incomplete;
      result.limit = limit.what();
      return result;
    }
  }
  result.counts.listed = static_cast<unsigned long>(result.solutions.size());
  for (Solution& solution : result.solutions) {
    // A solution that was not found might lie within the printed radius of one that was.
    solution.certified = options.certify && proven;
    if (!options.certify)
      solution.reason = "certification was not asked for";
    else if (!proven)
      solution.reason = "not all solutions were found";
  }
  if (options.certificate && !result.certificate)
    result.warnings.emplace_back(proven ? "no certificate: no number of digits within reason makes it checkable"
                                        : "no certificate: not all solutions were found");
  const Status status = options.certify && proven ? Status::certified : Status::numeric;
  result.status = infinite ? Status::infinite : status;
  if (infinite) result.rest_status = status;
  return result;
}

}  // namespace eliminant::intersect
