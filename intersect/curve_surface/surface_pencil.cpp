// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/curve_surface/surface_pencil.hpp>

#include <algorithm>
#include <cmath>

#include <eliminant/bridge/rounding/round_representation.hpp>
#include <eliminant/intersect/curves/common_points.hpp>
#include <eliminant/intersect/plane_curves/parameter_roots.hpp>
#include <eliminant/intersect/plane_curves/presentation.hpp>
#include <eliminant/symbolic/elimination/pencil_structure.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;

struct Zero {
  HomogeneousParameters parameters;
  ComplexBall t;
  bool real = false;
};

ComplexBall exact(std::complex<double> z) { return {z.real(), z.imag()}; }

/// In the chart where the largest parameter of each group is 1.
HomogeneousParameters chart_of(const bridge::BallSurface& surface, const numeric::NumericIntersection& candidate) {
  std::size_t count = 0;
  for (const std::vector<std::size_t>& group : surface.groups()) count += group.size();
  HomogeneousParameters result(count);
  for (const std::vector<std::size_t>& group : surface.groups()) {
    const std::size_t largest = *std::max_element(group.begin(), group.end(), [&](std::size_t a, std::size_t b) {
      return std::abs(candidate.parameters[a]) < std::abs(candidate.parameters[b]);
    });
    for (const std::size_t k : group)
      if (k == largest)
        acb_one(result[k].get());
      else
        result[k] = exact(candidate.parameters[k] / candidate.parameters[largest]);
  }
  return result;
}

}  // namespace

SurfacePencil::SurfacePencil(const symbolic::RationalSurface& surface, const symbolic::MatrixRepresentation& m,
                             const SurfaceInversion& inversion)
    : m_(m), inversion_(inversion) {
  const bool triangular = surface.kind() == symbolic::RationalSurface::Kind::triangular;
  const long degree = triangular ? surface.degree() : std::max(surface.bidegree()[0], surface.bidegree()[1]);
  if (degree <= numeric::largest_numeric_degree)
    pencil_.emplace(bridge::round_surface(surface), bridge::round_representation(m, surface.kind()));
}

numeric::NumericIntersections SurfacePencil::candidates(const symbolic::RationalCurve& curve,
                                                        SingularPencilMethod method, std::uint64_t seed) const {
  numeric::RepresentationPencil::Workspace workspace;
  numeric::NumericIntersections found;
  found.outcome = numeric::NumericOutcome::not_converged;
  if (!pencil_ || curve.degree() > numeric::largest_numeric_degree) return found;
  const numeric::CurveForms rounded = bridge::round_curve(curve);
  if (method != SingularPencilMethod::staircase) {
    pencil_->intersect(rounded, false, workspace, found);
    return found;
  }
  const symbolic::PencilStructure structure = symbolic::pencil_structure_modulo(m_, curve, seed);
  if (structure.full_rank)
    pencil_->intersect_by_staircase(rounded, structure.column_steps, structure.row_steps, workspace, found);
  else
    found.outcome = numeric::NumericOutcome::rank_deficient;
  return found;
}

std::optional<std::vector<CurveSolution>> SurfacePencil::solve(const symbolic::RationalCurve& curve,
                                                               unsigned long expected, const Options& options,
                                                               const Context& context, EngineReport& report,
                                                               SingularPencilMethod method) const {
  report.method = "pencil";
  report.matrix = "moving planes";
  report.matrix_size = m_.rows();
  report.matrix_degree = curve.degree();
  report.pencil_size = m_.rows() * curve.degree();
  report.regular_size = static_cast<long>(expected);
  report.precision_bits = 53;
  if (method == SingularPencilMethod::staircase)
    report.singular_pencil = "staircase";
  else if (m_.columns() > m_.rows())
    report.singular_pencil = "projection";
  context.checkpoint("eigenvalues");
  const numeric::NumericIntersections found = candidates(curve, method, options.seed);
  if (found.outcome != numeric::NumericOutcome::solved) return std::nullopt;

  const long bits = bits_for_digits(options.digits) + 40;
  std::vector<Zero> zeros;
  std::size_t left = found.solutions.size();
  for (const numeric::NumericIntersection& candidate : found.solutions) {
    context.checkpoint("certifying");
    if (zeros.size() > expected || zeros.size() + left < expected) return std::nullopt;
    --left;
    const std::complex<double> t = candidate.t[0] / candidate.t[1];
    if (!candidate.has_parameters || !std::isfinite(t.real()) || !std::isfinite(t.imag())) continue;
    // A conjugate pair at once.
    if (t.imag() < 0) continue;
    const HomogeneousParameters start = chart_of(inversion_.surface(), candidate);
    const auto variables = chart_variables(inversion_.surface(), start);
    if (!variables) continue;
    const ComplexBall start_t = exact(t);
    std::vector<ComplexBall> point;
    for (const symbolic::UnivariatePolynomial& f : curve.coordinates()) point.push_back(evaluate(f, start_t, 64));
    std::size_t pivot = 0;
    for (std::size_t k = 1; k < 4; ++k)
      if (acb_is_zero(point[pivot].get()) != 0) pivot = k;
    bridge::HomogeneousParameters chart = start;
    const bool real = t.imag() == 0;
    std::vector<ComplexBall> from{chart[(*variables)[0]], chart[(*variables)[1]], start_t};
    if (real)
      for (ComplexBall& value : from) arb_zero(value.imaginary());
    const bridge::System system = common_point_system(inversion_.surface(), curve, chart, *variables, pivot);
    auto found_zero = bridge::enclose_system_zero(system, from, bits, newton_steps(bits) + 2);
    if (!found_zero) continue;
    Zero zero{start, (*found_zero)[2], real};
    for (std::size_t k = 0; k < 2; ++k) zero.parameters[(*variables)[k]] = (*found_zero)[k];
    if (real) {
      for (ComplexBall& value : zero.parameters) arb_zero(value.imaginary());
      arb_zero(zero.t.imaginary());
    } else if (arb_contains_zero(zero.t.imaginary()) != 0) {
      continue;
    }
    // Where the coordinate of the pivot vanishes, on the curve or (a base point) on the surface, the minors say
    // nothing.
    if (acb_contains_zero(evaluate(curve.coordinates()[pivot], zero.t, bits).get()) != 0 ||
        acb_contains_zero(inversion_.surface().point_at(zero.parameters, bits)[pivot].get()) != 0)
      continue;
    const bool known = std::any_of(zeros.begin(), zeros.end(),
                                   [&](const Zero& other) { return acb_overlaps(other.t.get(), zero.t.get()) != 0; });
    if (known) continue;
    zeros.push_back(zero);
    if (real) continue;
    acb_conj(zero.t.get(), zero.t.get());
    for (ComplexBall& value : zero.parameters) acb_conj(value.get(), value.get());
    zeros.push_back(std::move(zero));
  }
  if (zeros.size() != expected) return std::nullopt;
  std::vector<CurveSolution> solutions;
  for (const Zero& zero : zeros) {
    std::optional<CurveSolution> solution =
        print_common_point(inversion_.surface(), curve, zero.parameters, zero.t, options, bits);
    if (!solution) return std::nullopt;
    solution->reality = zero.real ? Reality::real : Reality::non_real;
    solutions.push_back(*std::move(solution));
  }
  return solutions;
}

}  // namespace eliminant::intersect
