// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/self_intersection.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <eliminant/base/error.hpp>
#include <eliminant/intersect/curves/curve_condition.hpp>
#include <eliminant/intersect/curves/curve_presentation.hpp>
#include <eliminant/intersect/curves/double_points.hpp>
#include <eliminant/intersect/curves/piece_boxes.hpp>
#include <eliminant/intersect/curves/seams.hpp>
#include <eliminant/intersect/curves/singular_points.hpp>
#include <eliminant/symbolic/arithmetic/flint_errors.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::ParametricCurve;
using symbolic::Rational;
using symbolic::UnivariatePolynomial;

/// A solution, and the pieces that its parameters belong to.
struct Found {
  CurveSolution solution;
  std::array<std::size_t, 2> pieces;
};

class SelfIntersection {
 public:
  SelfIntersection(const ParametricCurve& curve, const Options& options, const Context& context)
      : curve_(curve), seams_(curve, true), boxes_(boxes_of_pieces(curve)), options_(options), context_(context) {
    result_.problem = "self_intersection";
    result_.status = Status::certified;
    result_.in_plane = curve.pieces.front().map.dimension() == 2;
    result_.closed = seams_.closed();
  }

  CurveResult run() {
    for (std::size_t i = 0; i < curve_.pieces.size(); ++i) add_piece(i);
    for (std::size_t i = 0; i < curve_.pieces.size(); ++i)
      for (std::size_t j = i + 1; j < curve_.pieces.size(); ++j) add_pieces(i, j);
    std::erase_if(found_, [&](const Found& f) {
      CurveSolution exchanged = f.solution;
      std::swap(exchanged.t, exchanged.u);
      return ends_overlap(f.solution, result_.overlap, seams_, seams_) ||
             ends_overlap(exchanged, result_.overlap, seams_, seams_);
    });
    join_overlaps(result_.overlap);
    gather_points();
    for (Found& f : found_) result_.solutions.push_back(std::move(f.solution));
    return std::move(result_);
  }

 private:
  bool listed(const CurveSolution& solution) const {
    const bool has_domain = curve_.pieces.front().domain.has_value();
    if (!real_only(options_, has_domain)) return true;
    return has_domain ? solution.inside : solution.reality == Reality::real;
  }

  void add_piece(std::size_t i) {
    MapPairResult part = double_points(curve_.pieces[i], options_, context_);
    add_part(part.status, part.counts, part.engine, part.warnings, result_);
    result_.covering = std::max(result_.covering, static_cast<unsigned long>(part.component_degree) + 1);
    for (CurveSolution& solution : part.solutions) {
      if (!listed(solution)) continue;
      const bool cusp = solution.kind == PairKind::cusp;
      if (cusp ? is_known_cusp(i, solution) : is_seam(i, solution, i)) continue;
      found_.push_back({std::move(solution), {i, i}});
    }
    for (const Overlap& overlap : part.overlap) add_overlap_once(overlap);
  }

  void add_pieces(std::size_t i, std::size_t j) {
    if (excluded_by_boxes(boxes_[i], boxes_[j], options_, result_)) return;
    MapPairResult part = intersect_map_pair(curve_.pieces[i], curve_.pieces[j], options_, context_);
    add_part(part.status, part.counts, part.engine, part.warnings, result_);
    for (std::vector<CurveSolution>* solutions : {&part.solutions, &part.touches})
      for (CurveSolution& solution : *solutions) {
        if (solution.reality == Reality::real) solution.kind = PairKind::crossing;
        if (solution.reality == Reality::non_real) solution.kind = PairKind::complex;
        const bool twice = solutions == &part.touches &&
                           std::any_of(part.solutions.begin(), part.solutions.end(), [&](const CurveSolution& other) {
                             return is_at(other.t, *(*solution.t)->exact) && is_at(other.u, *(*solution.u)->exact);
                           });
        if (twice || is_seam(i, solution, j)) continue;
        found_.push_back({std::move(solution), {i, j}});
      }
    result_.overlap.insert(result_.overlap.end(), part.overlap.begin(), part.overlap.end());
  }

  /// Where the pieces, or the ends of a closed curve, meet, and what another pair of pieces lists.
  bool is_seam(std::size_t i, const CurveSolution& solution, std::size_t j) const {
    const auto& pieces = curve_.pieces;
    if (j == i + 1 && joined(pieces[i], pieces[j]) && is_at(solution.t, pieces[i].domain->upper) &&
        is_at(solution.u, pieces[j].domain->lower))
      return true;
    if (seams_.closed() && i == 0 && j + 1 == pieces.size() && is_at(solution.t, pieces[i].domain->lower) &&
        is_at(solution.u, pieces[j].domain->upper))
      return true;
    return seams_.is_left_to_another(i, solution.t) || seams_.is_left_to_another(j, solution.u);
  }

  /// A cusp on a seam belongs to the first piece that has it.
  bool is_known_cusp(std::size_t piece, const CurveSolution& cusp) const {
    const auto& domain = curve_.pieces[piece].domain;
    if (!domain || !seams_.is_left_to_another(piece, cusp.t)) return false;
    return std::any_of(found_.begin(), found_.end(), [&](const Found& other) {
      if (other.solution.kind != PairKind::cusp) return false;
      return (is_at(cusp.t, domain->lower) && seams_.is_same(other.solution.t, domain->lower)) ||
             (is_at(cusp.t, domain->upper) && seams_.is_same(other.solution.t, domain->upper));
    });
  }

  /// A correspondence and its inverse give the same stretches, with t and u exchanged.
  void add_overlap_once(const Overlap& overlap) {
    const auto lower = [](const std::optional<ParameterInterval>& interval) -> std::optional<Rational> {
      return interval && (*interval)[0] ? (*interval)[0]->exact : std::nullopt;
    };
    const std::optional<Rational> t = lower(overlap.t);
    const std::optional<Rational> u = lower(overlap.u);
    if (t && u && *u < *t) return;
    const bool known = std::any_of(result_.overlap.begin(), result_.overlap.end(), [&](const Overlap& other) {
      const bool whole = !overlap.t && !overlap.u && !other.t && !other.u;
      return whole || (t && u && lower(other.t) == t && lower(other.u) == u);
    });
    if (!known) result_.overlap.push_back(overlap);
  }

  /// One of the two parameters of a solution.
  struct Place {
    const Found* found;
    std::size_t axis;
    const Parameter& value() const { return axis == 0 ? *found->solution.t : *found->solution.u; }
    std::size_t piece() const { return found->pieces[axis]; }
  };

  /// A squarefree polynomial of which the parameter is a root.
  const UnivariatePolynomial& polynomial_of(const Place& place) {
    const auto& [i, j] = place.found->pieces;
    const auto [position, added] = polynomials_.try_emplace({i, j, i == j ? 0 : place.axis});
    if (added)
      position->second =
          common_parameters(curve_.pieces[i], curve_.pieces[j], i == j ? 0 : place.axis, options_, context_);
    return position->second;
  }

  /// Whether two parameters are one: by the roots that their polynomials share.
  bool same(const Place& a, const Place& b) {
    if (!a.value() || !b.value()) return !a.value() && !b.value();
    if (a.value()->exact && b.value()->exact) return seams_.is_same(a.value(), *b.value()->exact);
    const ComplexBall& first = a.value()->ball;
    const ComplexBall& second = b.value()->ball;
    if (acb_overlaps(first.get(), second.get()) == 0) return false;
    const UnivariatePolynomial common = symbolic::gcd(polynomial_of(a), polynomial_of(b));
    if (common.degree() < 1) return false;
    const long bits = std::max(acb_rel_accuracy_bits(first.get()), acb_rel_accuracy_bits(second.get())) + 64;
    const std::vector<ComplexBall> roots = bridge::enclose_roots(common, std::clamp(bits, 64L, 1L << 20), context_);
    const std::optional<std::size_t> of_first = root_of(polynomial_of(a), common, roots, first);
    const std::optional<std::size_t> of_second = root_of(polynomial_of(b), common, roots, second);
    return of_first && of_second && *of_first == *of_second && *of_first < roots.size();
  }

  /// Which of the roots of a factor the ball contains, of which it is known that it contains one root of the whole;
  /// as many as there are when it is a root of the cofactor. nullopt, and more digits needed, where that is open.
  std::optional<std::size_t> root_of(const UnivariatePolynomial& whole, const UnivariatePolynomial& factor,
                                     const std::vector<ComplexBall>& roots, const ComplexBall& ball) {
    const long bits = 2 * std::clamp<long>(acb_rel_accuracy_bits(ball.get()), 64, 1L << 20) + 64;
    UnivariatePolynomial cofactor;
    fmpz_poly_div(cofactor.get(), whole.get(), factor.get());
    if (acb_contains_zero(evaluate(factor, ball, bits).get()) == 0) return roots.size();
    std::optional<std::size_t> root;
    bool open = acb_contains_zero(evaluate(cofactor, ball, bits).get()) != 0;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      if (acb_overlaps(roots[i].get(), ball.get()) == 0) continue;
      open = open || root.has_value();
      root = i;
    }
    if (!open && root) return root;
    needs_more_digits_ = true;
    return std::nullopt;
  }

  /// Solutions that share a parameter have one point.
  void gather_points() {
    std::vector<std::vector<Place>> points;
    for (const Found& f : found_) {
      std::vector<Place> parameters{{&f, 0}};
      if (f.solution.kind != PairKind::cusp) parameters.push_back({&f, 1});
      for (std::size_t k = points.size(); k-- > 0;) {
        std::vector<Place> rest;
        for (const Place& other : points[k])
          if (std::none_of(parameters.begin(), parameters.end(), [&](const Place& p) { return same(other, p); }))
            rest.push_back(other);
        if (rest.size() == points[k].size()) continue;
        rest.insert(rest.end(), parameters.begin(), parameters.end());
        parameters = std::move(rest);
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(k));
      }
      points.push_back(std::move(parameters));
    }
    for (const std::vector<Place>& places : points) {
      SingularPoint& point = result_.singular_points.emplace_back();
      for (const Place& place : places) point.parameters.push_back(place.value());
      const CurveSolution& one = places.front().found->solution;
      point.point = one.point;
      point.reality = one.reality;
    }
    // Every solution belongs to the point that has its parameter.
    for (const Found& f : found_)
      for (std::size_t k = 0; k < points.size(); ++k)
        if (std::any_of(points[k].begin(), points[k].end(), [&](const Place& p) { return same(p, Place{&f, 0}); })) {
          SingularPoint& point = result_.singular_points[k];
          point.multiplicity += f.solution.multiplicity;
          if (f.solution.reality == Reality::real) point.reality = Reality::real;
          break;
        }
    sort_points();
  }

  void sort_points() {
    for (SingularPoint& point : result_.singular_points)
      std::stable_sort(point.parameters.begin(), point.parameters.end(),
                       [](const Parameter& a, const Parameter& b) { return compare_parameters(a, b) < 0; });
    std::stable_sort(result_.singular_points.begin(), result_.singular_points.end(),
                     [](const SingularPoint& a, const SingularPoint& b) {
                       return compare_parameters(a.parameters.front(), b.parameters.front()) < 0;
                     });
  }

 public:
  bool needs_more_digits() const { return needs_more_digits_; }

 private:
  const ParametricCurve& curve_;
  Seams seams_;
  std::vector<std::optional<symbolic::BoundingBox>> boxes_;
  const Options& options_;
  const Context& context_;
  bool needs_more_digits_ = false;
  std::vector<Found> found_;
  std::map<std::array<std::size_t, 3>, UnivariatePolynomial> polynomials_;
  CurveResult result_;
};

CurveResult solve_parametric(const ParametricCurve& curve, const Options& options, const Context& context) {
  Options more = options;
  constexpr int most_doublings = 6;
  for (int doubling = 0;; ++doubling) {
    SelfIntersection solver(curve, more, context);
    CurveResult result = solver.run();
    if (!solver.needs_more_digits()) return result;
    if (doubling == most_doublings) {
      result.status = Status::numeric;
      result.warnings.emplace_back("not all equal parameters of different pairs are proven equal");
      return result;
    }
    more.digits *= 2;
  }
}

CurveResult solve_once(const SelfIntersectionProblem& problem, const Options& options, const Context& context) {
  symbolic::install_flint_error_handler();
  const auto start = std::chrono::steady_clock::now();
  CurveResult result;
  if (const auto* curve = std::get_if<ParametricCurve>(&problem.curve)) {
    result = solve_parametric(*curve, options, context);
  } else {
    result.problem = "self_intersection";
    result.status = Status::certified;
    result.in_plane = true;
    result.first_implicit = true;
    result.engine.method = "none";
    add_singular_points(std::get<ImplicitCurve>(problem.curve).equation, options, context, result);
  }
  finish(options, result);
  result.seconds.emplace_back("total", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return result;
}

}  // namespace

CurveResult intersect_curve_with_itself(const SelfIntersectionProblem& problem, const Options& options,
                                        const Context& context) {
  return with_enough_digits(options, [&](const Options& more) { return solve_once(problem, more, context); });
}

}  // namespace eliminant::intersect
