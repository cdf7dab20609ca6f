// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/merge_pieces.hpp>

#include <algorithm>

#include <eliminant/bridge/roots/isolated_roots.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using symbolic::UnivariatePolynomial;

bool contains(const ComplexBall& ball, const ComplexBall& root) { return acb_contains(ball.get(), root.get()) != 0; }

/// Whether two solutions of different pieces have the same t: a root of both polynomials that lies in both balls, each
/// of which isolates one root of its own.
bool same_parameter(const CurveSolution& a, const CurveSolution& b, const Context& context) {
  if (!*a.t || !*b.t) return !*a.t && !*b.t;
  const ComplexBall& first = (*a.t)->ball;
  const ComplexBall& second = (*b.t)->ball;
  // Without a polynomial a point is transversal and inside its patch.
  if (acb_overlaps(first.get(), second.get()) == 0 || !a.t_polynomial || !b.t_polynomial) return false;
  for (const Coordinate* t : {&**a.t, &**b.t})
    if (t->exact) {
      const UnivariatePolynomial linear = UnivariatePolynomial::with_root(*t->exact);
      return symbolic::gcd(linear, *a.t_polynomial).degree() == 1 &&
             symbolic::gcd(linear, *b.t_polynomial).degree() == 1;
    }
  const UnivariatePolynomial common = symbolic::gcd(*a.t_polynomial, *b.t_polynomial);
  if (common.degree() < 1) return false;
  const long accuracy = std::min(acb_rel_accuracy_bits(first.get()), acb_rel_accuracy_bits(second.get()));
  constexpr long least_bits = 64;
  constexpr long most_bits = 1L << 16;
  for (long bits = std::max(accuracy + 8, least_bits);; bits *= 2) {
    bool undecided = false;
    for (const ComplexBall& root : bridge::enclose_roots(common, std::min(bits, most_bits), context)) {
      if (contains(first, root) && contains(second, root)) return true;
      undecided =
          undecided || (acb_overlaps(root.get(), first.get()) != 0 && acb_overlaps(root.get(), second.get()) != 0);
    }
    // On the border of a ball for ever: that ball is the root, or an end of it is.
    if (!undecided || bits >= most_bits) return undecided;
  }
}

bool same_text(const Parameter& a, const Parameter& b) {
  return a.has_value() == b.has_value() && (!a || (a->real == b->real && a->imaginary == b->imaginary));
}

}  // namespace

void merge_pieces(CurveResult& result, const std::vector<bool>& sheets_inside, const Context& context) {
  std::vector<CurveSolution> merged;
  std::vector<bool> merged_inside;
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    CurveSolution& solution = result.solutions[i];
    const auto known = std::find_if(merged.begin(), merged.end(), [&](const CurveSolution& other) {
      return same_parameter(other, solution, context);
    });
    if (known == merged.end()) {
      merged.push_back(std::move(solution));
      merged_inside.push_back(sheets_inside[i]);
      continue;
    }
    const auto at = static_cast<std::size_t>(known - merged.begin());
    known->inside = known->inside || solution.inside;
    known->certified = known->certified && solution.certified;
    if (known->reason.empty()) known->reason = solution.reason;
    known->radius_exponent = std::max(known->radius_exponent, solution.radius_exponent);
    merged_inside[at] = merged_inside[at] && sheets_inside[i];
    known->multiplicity = merged_inside[at] ? known->multiplicity + solution.multiplicity
                                            : std::max(known->multiplicity, solution.multiplicity);
    for (std::vector<Parameter>& parameters : solution.surface_parameters)
      if (std::none_of(known->surface_parameters.begin(), known->surface_parameters.end(),
                       [&](const std::vector<Parameter>& other) {
                         return std::equal(other.begin(), other.end(), parameters.begin(), same_text);
                       }))
        known->surface_parameters.push_back(std::move(parameters));
  }
  result.solutions = std::move(merged);
  std::vector<Overlap> overlaps;
  for (Overlap& overlap : result.overlap) {
    const auto adjacent = std::find_if(overlaps.begin(), overlaps.end(), [&](const Overlap& other) {
      return other.t && overlap.t &&
             (same_text((*other.t)[1], (*overlap.t)[0]) || same_text((*other.t)[0], (*overlap.t)[0]));
    });
    if (adjacent == overlaps.end()) {
      overlaps.push_back(std::move(overlap));
      continue;
    }
    adjacent->certified = adjacent->certified && overlap.certified;
    if (same_text((*adjacent->t)[1], (*overlap.t)[0])) (*adjacent->t)[1] = (*overlap.t)[1];
  }
  result.overlap = std::move(overlaps);
}

}  // namespace eliminant::intersect
