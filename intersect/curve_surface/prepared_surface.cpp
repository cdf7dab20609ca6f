// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/prepared_surface.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include <eliminant/base/error.hpp>
#include <eliminant/symbolic/elimination/implicit_equation.hpp>
#include <eliminant/symbolic/matrices/moving_planes.hpp>

namespace eliminant::intersect {

namespace {

using symbolic::MatrixRepresentation;
using symbolic::Polynomial;
using symbolic::RationalSurface;

MatrixRepresentation inversion_matrix(const RationalSurface& surface, long least) {
  if (surface.kind() == RationalSurface::Kind::triangular)
    return symbolic::moving_plane_matrix(surface, std::max(least, symbolic::representation_degree(surface)));
  std::array<long, 2> nu = symbolic::representation_bidegree(surface);
  for (long& degree : nu) degree = std::max(degree, least);
  return symbolic::moving_plane_matrix(surface, nu);
}

/// The same map over the projective plane: s / u and t / u for the two affine parameters.
RationalSurface over_the_plane(const RationalSurface& surface) {
  long degree = 0;
  for (const Polynomial& f : surface.coordinates()) degree = std::max(degree, f.total_degree());
  std::vector<Polynomial> forms;
  for (const Polynomial& f : surface.coordinates()) {
    std::vector<Polynomial::Term> terms = f.terms();
    for (Polynomial::Term& term : terms)
      term.exponents.push_back(static_cast<unsigned long>(degree) - term.exponents[0] - term.exponents[1]);
    forms.push_back(Polynomial::from_terms(3, terms));
  }
  return {RationalSurface::Kind::triangular, std::move(forms)};
}

}  // namespace

Inversion::Inversion(const RationalSurface& surface, long least)
    : matrix(inversion_matrix(surface, least)), inversion(surface, matrix) {}

void PreparedSurface::settle() {
  if (smallest_) return;
  choose_map();
  if (degree_.proven && degree_.map_degree == 1) return;
  try {
    equation_ = symbolic::implicit_equation(map(), matrix(), degree_, seed_, context_);
  } catch (const LimitReached&) {
    context_.checkpoint("implicit equation");
  } catch (const InvalidInput&) {
    // The matrix represents nothing: there is no equation to be had from it.
  }
  // What is known of the degree of the map, and a lower bound else.
  degree_.proven = degree_.proven && equation_.has_value();
  degree_.map_degree = degree_.proven ? degree_.product / equation_->total_degree() : 1;
}

void PreparedSurface::choose_map() {
  smallest_ = std::make_unique<Inversion>(piece.map, 1);
  if (smallest_->matrix.columns() >= smallest_->matrix.rows())
    degree_ = symbolic::implicit_degree(piece.map, smallest_->matrix, seed_);
  if (degree_.proven || piece.map.kind() == RationalSurface::Kind::triangular) return;
  const RationalSurface other = over_the_plane(piece.map);
  auto inversion = std::make_unique<Inversion>(other, 1);
  if (inversion->matrix.columns() < inversion->matrix.rows()) return;
  const symbolic::ImplicitDegree degree = symbolic::implicit_degree(other, inversion->matrix, seed_);
  if (!degree.proven) return;
  over_the_plane_ = other;
  smallest_ = std::move(inversion);
  degree_ = degree;
}

}  // namespace eliminant::intersect
