// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/map_pair.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curves/curve_boxes.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/plane_curves/local_multiplicity.hpp>
#include <eliminant/intersect/plane_curves/parameter_roots.hpp>
#include <eliminant/intersect/plane_curves/plane_curves.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>
#include <eliminant/intersect/plane_curves/third_equation.hpp>
#include <eliminant/symbolic/arithmetic/hidden_variable.hpp>
#include <eliminant/symbolic/elimination/common_component.hpp>
#include <eliminant/symbolic/elimination/factors.hpp>
#include <eliminant/symbolic/elimination/resultant.hpp>
#include <eliminant/symbolic/matrices/moving_lines.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::Integer;
using symbolic::Interval;
using symbolic::Polynomial;
using symbolic::Rational;
using symbolic::RationalCurve;
using symbolic::UnivariatePolynomial;

/// The sum of line_k(t) curve_k(u).
Polynomial incidence(const symbolic::MovingLine& line, const RationalCurve& curve) {
  std::vector<Polynomial::Term> terms;
  for (std::size_t k = 0; k < line.size(); ++k)
    for (long i = 0; i <= line[k].degree(); ++i)
      for (long j = 0; j <= curve.coordinates()[k].degree(); ++j)
        terms.push_back({Rational(line[k].coefficient(i) * curve.coordinates()[k].coefficient(j)),
                         {static_cast<unsigned long>(i), static_cast<unsigned long>(j)}});
  return Polynomial::from_terms(2, terms);
}

long degree_of(const symbolic::MovingLine& line) {
  long degree = 0;
  for (const UnivariatePolynomial& entry : line) degree = std::max(degree, entry.degree());
  return degree;
}

/// One of the two equations, with its degrees on the projective lines, which may exceed the affine ones.
struct Equation {
  Polynomial polynomial{2};
  std::array<long, 2> bidegree{};

  /// With 1 / x in place of x for one of the variables.
  Equation reversed(std::size_t axis) const {
    std::vector<Polynomial::Term> terms = polynomial.terms();
    for (Polynomial::Term& term : terms)
      term.exponents[axis] = static_cast<unsigned long>(bidegree[axis]) - term.exponents[axis];
    return {Polynomial::from_terms(2, terms), bidegree};
  }

  /// On the line where one of the variables is 0.
  UnivariatePolynomial at_zero(std::size_t axis) const {
    const symbolic::HiddenVariablePolynomial rows = symbolic::hide_variable(polynomial, 1 - axis);
    return rows.coefficients.empty() ? UnivariatePolynomial() : rows.coefficients.front();
  }
};

/// A pair of parameters; nullopt is infinity.
struct Pair {
  std::optional<ComplexBall> t;
  std::optional<ComplexBall> u;
  /// The end of the domain at which the parameter is, exactly.
  std::optional<Rational> t_end;
  std::optional<Rational> u_end;
  unsigned long multiplicity = 1;
  Reality reality = Reality::undecided;
  bool certified = false;
  std::string reason;
};

/// Significant bits of a ball; those of an exact one have no end.
long accuracy(const ComplexBall& z) { return std::clamp<long>(acb_rel_accuracy_bits(z.get()), 0, 1L << 20); }

/// What looks as if both branches were singular at so many bits is taken for that.
constexpr long most_bits_for_multiplicities = 500;

struct Moebius;

class MapPair {
 public:
  /// With `itself` the two pieces are one, and t = u is divided out.
  MapPair(const symbolic::CurvePiece& first, const symbolic::CurvePiece& second, bool itself, const Options& options,
          const Context& context)
      : first_(first), second_(second), options_(options), context_(context) {
    const long diagonal = itself ? 1 : 0;
    const Polynomial difference = Polynomial::variable(2, 0) - Polynomial::variable(2, 1);
    for (const symbolic::MovingLine& line : symbolic::moving_line_basis(first.map)) {
      Polynomial equation = incidence(line, second.map);
      // Curves in one plane: that plane says nothing.
      if (equation.is_zero()) continue;
      if (itself) equation = symbolic::exact_quotient(equation, difference);
      component_ = symbolic::split_common_component(component_, equation).component;
      equations_.push_back({equation, {degree_of(line) - diagonal, second.map.degree() - diagonal}});
    }
    for (Equation& equation : equations_) {
      equation.polynomial = symbolic::exact_quotient(equation.polynomial, component_);
      for (std::size_t axis = 0; axis < 2; ++axis) equation.bidegree[axis] -= component_.degree(axis);
    }
    while (equations_.size() < 2) equations_.push_back({Polynomial::constant(2, Rational(1)), {0, 0}});
  }

  MapPairResult run() {
    const std::array<long, 2>& a = equations_[0].bidegree;
    const std::array<long, 2>& b = equations_[1].bidegree;
    // In space the number is not known beforehand.
    if (!in_space()) result_.counts.expected = static_cast<unsigned long>(a[0] * b[1] + a[1] * b[0]);
    result_.coincident = !component_.is_constant();
    result_.component_degree = std::max(component_.degree(0), 0L);
    constexpr long guard_digits = 8;
    for (long digits = options_.digits + guard_digits;; digits *= 2) {
      context_.checkpoint("intersecting curves");
      solve(digits);
      if (present()) break;
    }
    if (result_.coincident) find_overlap();
    return std::move(result_);
  }

  /// The squarefree polynomial of all finite t (axis 0) or u (axis 1) of the solutions.
  const UnivariatePolynomial& eliminant(std::size_t axis) {
    std::optional<UnivariatePolynomial>& known = eliminants_[axis];
    if (!known) {
      const UnivariatePolynomial all = common_resultant(axis);
      UnivariatePolynomial product({Integer(1)});
      for (const symbolic::SquarefreeFactor& part : symbolic::squarefree_decomposition(all))
        product = product * part.factor;
      known = product;
    }
    return *known;
  }

 private:
  bool in_space() const { return equations_.size() > 2; }

  bool real_only() const {
    if (options_.field == Field::automatic) return first_.domain || second_.domain;
    return options_.field == Field::real;
  }

  /// Fills pairs_ and the counts.
  void solve(long digits) {
    pairs_.clear();
    result_.counts.distinct = result_.counts.with_multiplicity = 0;
    result_.counts.real = result_.counts.undecided = 0;
    result_.status = Status::certified;
    result_.warnings.clear();
    Options options = options_;
    options.digits = digits;
    options.certificate = false;
    options.field = real_only() ? Field::real : Field::complex;
    const Result finite = solve_chart(equations_, options);
    result_.engine = finite.engine;
    result_.warnings = finite.warnings;
    result_.counts.with_multiplicity = finite.counts.with_multiplicity;
    result_.counts.distinct = finite.counts.distinct;
    result_.counts.real = finite.counts.real;
    result_.counts.undecided = finite.counts.undecided;
    for (const Solution& s : finite.solutions) add_pair(s, s.x.ball, s.y.ball);
    if (undecided_) return;

    // Where a parameter is infinite, which a look at the leading coefficients tells.
    options.field = Field::complex;
    for (const auto& [t_infinite, u_infinite] : {std::pair{true, false}, {false, true}, {true, true}}) {
      std::vector<Equation> chart = equations_;
      for (Equation& equation : chart) {
        if (t_infinite) equation = equation.reversed(0);
        if (u_infinite) equation = equation.reversed(1);
      }
      if (!may_vanish_at_zero(chart, t_infinite, u_infinite)) continue;
      for (const Solution& s : solve_chart(chart, options).solutions) {
        const auto at_infinity = [](const Coordinate& c) { return c.exact && c.exact->is_zero(); };
        if ((t_infinite && !at_infinity(s.x)) || (u_infinite && !at_infinity(s.y))) continue;
        result_.counts.with_multiplicity += s.multiplicity;
        ++result_.counts.distinct;
        if (s.reality == Reality::real) ++result_.counts.real;
        if (s.reality == Reality::undecided) ++result_.counts.undecided;
        if (real_only() && s.reality != Reality::real) continue;
        add_pair(s, t_infinite ? std::nullopt : std::optional(s.x.ball),
                 u_infinite ? std::nullopt : std::optional(s.y.ball));
      }
    }
    if (!in_space() && result_.counts.with_multiplicity != result_.counts.expected) result_.status = Status::numeric;
  }

  /// Whether the equations have a common zero where the first variable, the second one, or both are 0.
  static bool may_vanish_at_zero(const std::vector<Equation>& chart, bool first, bool second) {
    if (first && second)
      return std::all_of(chart.begin(), chart.end(),
                         [](const Equation& equation) { return equation.polynomial.constant_term().is_zero(); });
    UnivariatePolynomial common;
    for (const Equation& equation : chart) common = symbolic::gcd(common, equation.at_zero(first ? 0 : 1));
    return common.degree() > 0;
  }

  Result solve_chart(const std::vector<Equation>& chart, const Options& options) {
    PlaneCurvesProblem problem;
    problem.p = chart[0].polynomial;
    problem.q = chart[1].polynomial;
    // Of three equations the third one is added to the others, until they have finitely many zeros.
    for (long factor = 1; in_space(); ++factor) {
      problem.p = chart[0].polynomial + Rational(factor) * chart[2].polynomial;
      problem.q = chart[1].polynomial + Rational(factor * factor + 1) * chart[2].polynomial;
      if (symbolic::split_common_component(problem.p, problem.q).component.is_constant()) break;
    }
    Result result = intersect_plane_curves(problem, options, context_);
    if (in_space()) keep_zeros(chart, problem, options, result);
    if (result.status == Status::incomplete) throw LimitReached(*result.limit);
    if (result.status != Status::certified) result_.status = Status::numeric;
    return result;
  }

  /// Keeps the zeros of all three equations, of which two combinations have been solved, and counts them.
  void keep_zeros(const std::vector<Equation>& chart, const PlaneCurvesProblem& problem, const Options& options,
                  Result& result) {
    KeptSolutions kept = solutions_of_third(problem, chart[2].polynomial, result.solutions, options_.seed, context_);
    if (!kept.decided) undecided_ = true;
    result.solutions = std::move(kept.solutions);
    result.counts = {};
    const LocalMultiplicity local({chart[0].polynomial, chart[1].polynomial, chart[2].polynomial}, options, context_);
    for (Solution& s : result.solutions) {
      const std::optional<unsigned long> multiplicity = local.at(problem, s);
      if (multiplicity) {
        s.multiplicity = *multiplicity;
      } else if (std::min(accuracy(s.x.ball), accuracy(s.y.ball)) < most_bits_for_multiplicities) {
        undecided_ = true;
      } else {
        s.certified = false;
        s.reason = "both branches are singular there: the multiplicity is an upper bound";
      }
      ++result.counts.distinct;
      result.counts.with_multiplicity += s.multiplicity;
      if (s.reality == Reality::real) ++result.counts.real;
      if (s.reality == Reality::undecided) ++result.counts.undecided;
    }
  }

  void add_pair(const Solution& s, std::optional<ComplexBall> t, std::optional<ComplexBall> u) {
    pairs_.push_back({std::move(t), std::move(u), {}, {}, s.multiplicity, s.reality, s.certified, s.reason});
  }

  /// Fills the solutions; false when some of them needs more digits.
  bool present() {
    result_.solutions.clear();
    if (std::exchange(undecided_, false)) return false;
    for (Pair& pair : pairs_) {
      const Answer inside = is_inside(pair);
      if (inside == Answer::unknown) return false;
      if (inside == Answer::no && real_only()) continue;
      CurveSolution solution;
      solution.multiplicity = pair.multiplicity;
      solution.reality = pair.reality;
      solution.certified = pair.certified;
      solution.reason = pair.reason;
      solution.inside = inside == Answer::yes;
      solution.radius_exponent = -options_.digits;
      bool enough = true;
      const auto print = [&](const std::optional<ComplexBall>& value) -> Parameter {
        if (!value) return std::nullopt;
        Parameter printed = print_value(*value, options_.digits, solution.radius_exponent);
        enough = enough && printed.has_value();
        return printed;
      };
      solution.t = print(pair.t);
      solution.u = print(pair.u);
      if (*solution.t) (*solution.t)->exact = pair.t_end;
      if (*solution.u) (*solution.u)->exact = pair.u_end;
      enough = enough && print_common_point(pair, solution);
      if (!enough) return false;
      result_.solutions.push_back(std::move(solution));
    }
    sort_solutions(result_.solutions);
    return true;
  }

  bool print_common_point(const Pair& pair, CurveSolution& solution) {
    if (!pair.t || !pair.u) {
      const RationalCurve& map = pair.t ? second_.map : first_.map;
      std::vector<Rational> exact;
      for (const Integer& coordinate : map.at_infinity()) exact.emplace_back(coordinate);
      solution.point = print_exact_point(exact, options_.digits, solution.radius_exponent);
      return true;
    }
    const long precision_bits = 2 * bits_for_digits(options_.digits) + accuracy(*pair.t);
    std::vector<ComplexBall> coordinates;
    for (const UnivariatePolynomial& f : first_.map.coordinates())
      coordinates.push_back(evaluate(f, *pair.t, precision_bits));
    auto point =
        print_point(coordinates, options_.digits, precision_bits, solution.radius_exponent,
                    [&](std::size_t k) { return vanishes(first_.map.coordinates()[k], *pair.t, 0) == Answer::yes; });
    if (!point) return false;
    solution.point = *std::move(point);
    return true;
  }

  /// Whether g is 0 at the parameter in this ball, of which the eliminant knows that it is one of its roots.
  Answer vanishes(const UnivariatePolynomial& g, const ComplexBall& at, std::size_t axis) {
    const long precision_bits = accuracy(at) + 128;
    if (acb_contains_zero(evaluate(g, at, precision_bits).get()) == 0) return Answer::no;
    const UnivariatePolynomial& all = eliminant(axis);
    const UnivariatePolynomial common = symbolic::gcd(all, g);
    if (common.degree() < 1) return Answer::no;
    UnivariatePolynomial rest;
    fmpz_poly_div(rest.get(), all.get(), common.get());
    if (acb_contains_zero(evaluate(rest, at, precision_bits).get()) == 0) return Answer::yes;
    if (acb_contains_zero(evaluate(common, at, precision_bits).get()) == 0) return Answer::no;
    return Answer::unknown;
  }

  /// A polynomial that is not zero and vanishes at the t (axis 0) or u of every finite solution.
  UnivariatePolynomial common_resultant(std::size_t axis) const {
    UnivariatePolynomial common;
    for (std::size_t i = 0; i < equations_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto of = [&](std::size_t k) { return symbolic::hide_variable(equations_[k].polynomial, axis); };
        // Without the variable that is eliminated the resultant would be 1, whatever they have in common.
        const bool one_variable =
            equations_[i].polynomial.degree(1 - axis) < 1 && equations_[j].polynomial.degree(1 - axis) < 1;
        common =
            symbolic::gcd(common, one_variable ? symbolic::gcd(of(i).coefficients.front(), of(j).coefficients.front())
                                               : symbolic::resultant(of(j), of(i), options_.seed, context_));
      }
    // And of those whose other parameter is infinite.
    UnivariatePolynomial at_infinity;
    for (const Equation& equation : equations_)
      at_infinity = symbolic::gcd(at_infinity, equation.reversed(1 - axis).at_zero(1 - axis));
    return at_infinity.is_zero() ? common : common * at_infinity;
  }

  Answer is_inside(Pair& pair) {
    if (pair.reality != Reality::real) return Answer::no;
    const Answer first = is_within(pair.t, first_.domain, 0, pair.t_end);
    const Answer second = is_within(pair.u, second_.domain, 1, pair.u_end);
    if (first == Answer::no || second == Answer::no) return Answer::no;
    return first == Answer::yes && second == Answer::yes ? Answer::yes : Answer::unknown;
  }

  /// Also fills in the end of the domain where the value is that.
  Answer is_within(const std::optional<ComplexBall>& value, const std::optional<Interval>& domain, std::size_t axis,
                   std::optional<Rational>& at_end) {
    if (!domain) return Answer::yes;
    if (!value) return Answer::no;
    for (const bool lower : {true, false}) {
      const Rational& end = lower ? domain->lower : domain->upper;
      if (at_end && *at_end == end) continue;
      UnivariatePolynomial linear;
      fmpz_poly_set_coeff_fmpz(linear.get(), 1, fmpq_denref(end.get()));
      fmpz_poly_set_coeff_fmpz(linear.get(), 0, (-end.numerator()).get());
      const long precision_bits = accuracy(*value) + 128;
      const ComplexBall difference = evaluate(linear, *value, precision_bits);
      if (arb_is_positive(difference.real()) != 0) {
        if (!lower) return Answer::no;
      } else if (arb_is_negative(difference.real()) != 0) {
        if (lower) return Answer::no;
      } else if (vanishes(linear, *value, axis) == Answer::yes) {
        at_end = end;
      } else {
        return Answer::unknown;
      }
    }
    return Answer::yes;
  }

  void find_overlap();
  void add_overlap(const Moebius& map);
  void add_arc(const Moebius& map, const Rational& lower, const Rational& upper);

  const symbolic::CurvePiece& first_;
  const symbolic::CurvePiece& second_;
  const Options& options_;
  const Context& context_;
  Polynomial component_{2};  // 0 at first
  /// Two in the plane, three in space.
  std::vector<Equation> equations_;
  /// More digits are needed to tell the zeros of two equations from those of three.
  bool undecided_ = false;
  std::array<std::optional<UnivariatePolynomial>, 2> eliminants_;
  std::vector<Pair> pairs_;
  MapPairResult result_;
};

/// A point of the real projective line; nullopt is infinity.
using Point = std::optional<Rational>;

/// u = (a t + b) / (c t + d), of determinant not 0.
struct Moebius {
  Rational a, b, c, d;

  Point operator()(const Point& t) const {
    const Rational numerator = t ? a * *t + b : a;
    const Rational denominator = t ? c * *t + d : c;
    if (denominator.is_zero()) return std::nullopt;
    return numerator / denominator;
  }
  Moebius inverse() const { return {d, -b, -c, a}; }
  bool increasing() const { return b * c < a * d; }
};

Parameter printed(const Point& point, long digits) {
  if (!point) return std::nullopt;
  long radius_exponent = 0;
  for (long precision_bits = 2 * bits_for_digits(digits);; precision_bits *= 2) {
    ComplexBall ball;
    arb_set_fmpq(ball.real(), point->get(), precision_bits);
    if (Parameter parameter = print_value(ball, digits, radius_exponent)) {
      parameter->exact = *point;
      return parameter;
    }
  }
}

void MapPair::find_overlap() {
  for (const Polynomial& factor : symbolic::irreducible_factors(component_)) {
    if (factor.degree(0) != 1 || factor.degree(1) != 1) {
      // A correspondence that is not one to one: some of its real points may lie in the domains.
      if (factor.degree(0) == 0 || factor.degree(1) == 0) continue;
      Overlap overlap;
      if (first_.domain || second_.domain || real_only()) {
        result_.warnings.emplace_back(
            "the curves coincide, with several parameters for one point: which real parts coincide is not known");
        result_.status = Status::numeric;
      } else {
        overlap.certified = true;
      }
      result_.overlap.push_back(overlap);
      continue;
    }
    // a t + b - u (c t + d)
    Moebius map;
    for (const Polynomial::Term& term : factor.terms()) {
      Rational& entry =
          term.exponents[1] == 0 ? (term.exponents[0] == 0 ? map.b : map.a) : (term.exponents[0] == 0 ? map.d : map.c);
      entry = term.exponents[1] == 0 ? term.coefficient : -term.coefficient;
    }
    add_overlap(map);
  }
}

/// u = map(t): the t of the first domain whose u lies in the second one.
void MapPair::add_overlap(const Moebius& map) {
  const auto image = [&](const Moebius& of, const Interval& domain) {
    Point from = of(domain.lower);
    Point to = of(domain.upper);
    if (!of.increasing()) std::swap(from, to);
    return ParameterInterval{printed(from, options_.digits), printed(to, options_.digits)};
  };
  const auto exactly = [&](const Interval& domain) {
    return ParameterInterval{printed(domain.lower, options_.digits), printed(domain.upper, options_.digits)};
  };
  if (!first_.domain || !second_.domain) {
    Overlap overlap;
    overlap.certified = true;
    overlap.reversed = !map.increasing();
    if (first_.domain) overlap.u = image(map, *first_.domain);
    if (first_.domain) overlap.t = exactly(*first_.domain);
    if (second_.domain) overlap.t = image(map.inverse(), *second_.domain);
    if (second_.domain) overlap.u = exactly(*second_.domain);
    result_.overlap.push_back(overlap);
    return;
  }
  // The second domain seen from t: from one point upwards to another one, perhaps through infinity.
  Point from = map.inverse()(second_.domain->lower);
  Point to = map.inverse()(second_.domain->upper);
  if (!map.increasing()) std::swap(from, to);
  const Rational& lower = first_.domain->lower;
  const Rational& upper = first_.domain->upper;
  const auto larger = [](const Rational& a, const Rational& b) { return a < b ? b : a; };
  const auto smaller = [](const Rational& a, const Rational& b) { return a < b ? a : b; };
  const bool through_infinity = !from || !to || (*to < *from);
  if (!through_infinity) {
    add_arc(map, larger(lower, *from), smaller(upper, *to));
    return;
  }
  if (to) add_arc(map, lower, smaller(upper, *to));
  if (from) add_arc(map, larger(lower, *from), upper);
}

void MapPair::add_arc(const Moebius& map, const Rational& lower, const Rational& upper) {
  if (upper < lower) return;
  Point u_lower = map(lower);
  Point u_upper = map(upper);
  if (upper == lower) {
    // The ends touch: a point, whatever its multiplicity.
    CurveSolution touch;
    touch.t = printed(lower, options_.digits);
    touch.u = printed(u_lower, options_.digits);
    touch.radius_exponent = -options_.digits;
    touch.point = print_exact_point(first_.map.at(lower), options_.digits, touch.radius_exponent);
    touch.inside = true;
    touch.reality = Reality::real;
    touch.certified = true;
    result_.touches.push_back(std::move(touch));
    return;
  }
  if (!map.increasing()) std::swap(u_lower, u_upper);
  Overlap overlap;
  overlap.certified = true;
  overlap.reversed = !map.increasing();
  overlap.t = ParameterInterval{printed(lower, options_.digits), printed(upper, options_.digits)};
  overlap.u = ParameterInterval{printed(u_lower, options_.digits), printed(u_upper, options_.digits)};
  result_.overlap.push_back(overlap);
}

void require_curves(const symbolic::CurvePiece& first, const symbolic::CurvePiece& second) {
  for (const symbolic::CurvePiece* piece : {&first, &second})
    if (piece->map.degree() < 1) throw InvalidInput("a curve is a single point", "a map that is not constant");
}

/// The box engine answers for real solutions within bounded domains.
std::optional<MapPairResult> within_boxes(const symbolic::CurvePiece& first, const symbolic::CurvePiece& second,
                                          const Options& options, const Context& context) {
  if (options.engine != Engine::automatic && options.engine != Engine::box) return std::nullopt;
  if (options.field == Field::complex) return std::nullopt;
  auto solutions = solve_by_boxes(first, second, options, context);
  if (!solutions) return std::nullopt;
  MapPairResult result;
  result.status = Status::certified;
  result.counts.distinct = result.counts.real = static_cast<unsigned long>(solutions->size());
  for (const CurveSolution& solution : *solutions) result.counts.with_multiplicity += solution.multiplicity;
  result.counts.within_domains_only = true;
  result.engine.method = "box";
  result.engine.precision_bits = 53;
  result.solutions = *std::move(solutions);
  return result;
}

}  // namespace

MapPairResult intersect_map_pair(const symbolic::CurvePiece& first, const symbolic::CurvePiece& second,
                                 const Options& options, const Context& context) {
  require_curves(first, second);
  if (std::optional<MapPairResult> result = within_boxes(first, second, options, context)) return *std::move(result);
  Options by_equations = options;
  // What boxes leave open.
  if (options.engine == Engine::box) by_equations.engine = Engine::automatic;
  return MapPair(first, second, false, by_equations, context).run();
}

MapPairResult intersect_map_with_itself(const symbolic::CurvePiece& piece, const Options& options,
                                        const Context& context) {
  require_curves(piece, piece);
  return MapPair(piece, piece, true, options, context).run();
}

UnivariatePolynomial common_parameters(const symbolic::CurvePiece& first, const symbolic::CurvePiece& second,
                                       std::size_t axis, const Options& options, const Context& context) {
  return MapPair(first, second, &first == &second, options, context).eliminant(axis);
}

}  // namespace eliminant::intersect
