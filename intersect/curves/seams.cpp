// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curves/seams.hpp>

#include <algorithm>
#include <utility>

#include <eliminant/intersect/curves/curve_condition.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::CurvePiece;
using symbolic::ParametricCurve;
using symbolic::Rational;

bool same_point(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!(a[i] * b[j] == a[j] * b[i])) return false;
  return true;
}

bool ends_where_it_begins(const ParametricCurve& curve) {
  const CurvePiece& first = curve.pieces.front();
  const CurvePiece& last = curve.pieces.back();
  if (!first.domain || !last.domain || !(first.domain->lower < last.domain->upper)) return false;
  return same_point(first.map.at(first.domain->lower), last.map.at(last.domain->upper));
}

bool is_exactly(const Parameter& a, const Parameter& b) {
  return a && b && a->exact && b->exact && *a->exact == *b->exact;
}

}  // namespace

Seams::Seams(const ParametricCurve& curve, bool of_one_piece)
    : curve_(curve), closed_((of_one_piece || curve.pieces.size() > 1) && ends_where_it_begins(curve)) {}

bool Seams::is_left_to_another(std::size_t piece, const std::optional<Parameter>& parameter) const {
  const std::optional<symbolic::Interval>& domain = curve_.pieces[piece].domain;
  if (!domain) return false;
  if (closed_ && piece + 1 == curve_.pieces.size() && is_at(parameter, domain->upper)) return true;
  return piece > 0 && joined(curve_.pieces[piece - 1], curve_.pieces[piece]) && is_at(parameter, domain->lower);
}

bool Seams::is_same(const std::optional<Parameter>& parameter, const Rational& value) const {
  if (is_at(parameter, value)) return true;
  if (!closed_) return false;
  const Rational& lower = curve_.pieces.front().domain->lower;
  const Rational& upper = curve_.pieces.back().domain->upper;
  return (value == upper && is_at(parameter, lower)) || (value == lower && is_at(parameter, upper));
}

bool ends_overlap(const CurveSolution& solution, const std::vector<Overlap>& overlaps, const Seams& first,
                  const Seams& second) {
  return std::any_of(overlaps.begin(), overlaps.end(), [&](const Overlap& overlap) {
    if (!overlap.t || !overlap.u) return false;
    for (std::size_t end = 0; end < 2; ++end) {
      const Parameter& t = (*overlap.t)[end];
      const Parameter& u = (*overlap.u)[overlap.reversed ? 1 - end : end];
      if (t && u && t->exact && u->exact && first.is_same(solution.t, *t->exact) &&
          second.is_same(solution.u, *u->exact))
        return true;
    }
    return false;
  });
}

void join_overlaps(std::vector<Overlap>& overlaps) {
  const auto follows = [](const Overlap& a, const Overlap& b) {
    if (!a.t || !a.u || !b.t || !b.u || a.reversed != b.reversed) return false;
    return is_exactly((*a.t)[1], (*b.t)[0]) &&
           (a.reversed ? is_exactly((*a.u)[0], (*b.u)[1]) : is_exactly((*a.u)[1], (*b.u)[0]));
  };
  for (std::size_t i = 0; i < overlaps.size();) {
    const auto next = std::find_if(overlaps.begin(), overlaps.end(),
                                   [&](const Overlap& other) { return follows(overlaps[i], other); });
    if (next == overlaps.end()) {
      ++i;
      continue;
    }
    (*overlaps[i].t)[1] = (*next->t)[1];
    (*overlaps[i].u)[overlaps[i].reversed ? 0 : 1] = (*next->u)[overlaps[i].reversed ? 0 : 1];
    overlaps[i].certified = overlaps[i].certified && next->certified;
    overlaps.erase(next);
    i = 0;
  }
}

}  // namespace eliminant::intersect
