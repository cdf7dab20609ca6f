// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/surface_pencil.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <Eigen/QR>

#include <eliminant/intersect/common_points.hpp>
#include <eliminant/intersect/parameter_roots.hpp>
#include <eliminant/intersect/presentation.hpp>
#include <eliminant/numeric/generalized_eigen.hpp>
#include <eliminant/symbolic/elimination/prime_field.hpp>

namespace eliminant::intersect {

namespace {

using bridge::ComplexBall;
using numeric::Matrix;

struct Zero {
  HomogeneousParameters parameters;
  ComplexBall t;
  bool real = false;
};

ComplexBall exact(std::complex<double> z) { return {z.real(), z.imag()}; }

/// The coefficients of a polynomial in doubles, divided by a power of two that is common to all of the curve.
double scaled_coefficient(const symbolic::UnivariatePolynomial& f, long i, long scale_log2) {
  slong exponent = 0;
  const double mantissa = fmpz_get_d_2exp(&exponent, f.coefficient(i).get());
  return mantissa == 0 ? 0
                       : std::ldexp(mantissa, static_cast<int>(std::clamp<long>(exponent - scale_log2, -1000, 1000)));
}

}  // namespace

SurfacePencil::SurfacePencil(const symbolic::MatrixRepresentation& m, const SurfaceInversion& inversion)
    : inversion_(inversion) {
  const long rows = m.rows();
  const long columns = m.columns();
  Matrix<double> stacked(4 * rows, columns);
  for (long j = 0; j < columns; ++j) {
    // Each column by its own power of two: they are only a basis.
    slong largest = std::numeric_limits<slong>::min();
    for (const symbolic::IntegerMatrix& block : m.coefficients)
      for (long i = 0; i < rows; ++i) largest = std::max(largest, static_cast<slong>(fmpz_bits(block.entry(i, j))));
    for (std::size_t k = 0; k < 4; ++k)
      for (long i = 0; i < rows; ++i) {
        slong exponent = 0;
        const double mantissa = fmpz_get_d_2exp(&exponent, m.coefficients[k].entry(i, j));
        const long shift = std::max<long>(-1000, exponent - largest);
        stacked(static_cast<long>(k) * rows + i, j) = mantissa == 0 ? 0 : std::ldexp(mantissa, static_cast<int>(shift));
      }
  }
  const Eigen::HouseholderQR<Matrix<double>> qr(stacked);
  Matrix<double> basis = qr.householderQ() * Matrix<double>::Identity(4 * rows, columns);
  if (columns > rows) {
    Matrix<double> random(columns, rows);
    std::uint64_t drawn = 0;
    for (long i = 0; i < columns; ++i)
      for (long j = 0; j < rows; ++j)
        random(i, j) = static_cast<double>(symbolic::mix(11, drawn++) % 2001) / 1000.0 - 1.0;
    const Eigen::HouseholderQR<Matrix<double>> projection(random);
    basis = basis * (projection.householderQ() * Matrix<double>::Identity(columns, rows));
  }
  for (long k = 0; k < 4; ++k) blocks_[static_cast<std::size_t>(k)] = basis.block(k * rows, 0, rows, rows);
}

std::optional<std::vector<CurveSolution>> SurfacePencil::solve(const symbolic::RationalCurve& curve,
                                                               unsigned long expected, const Options& options,
                                                               const Context& context, EngineReport& report) const {
  const long rows = blocks_[0].rows();
  const long degree = curve.degree();
  long scale_log2 = 0;
  for (const symbolic::UnivariatePolynomial& f : curve.coordinates())
    for (long i = 0; i <= f.degree(); ++i)
      scale_log2 = std::max(scale_log2, static_cast<long>(f.coefficient(i).bit_length()));
  numeric::MatrixPolynomial<double> along;
  for (long i = 0; i <= degree; ++i) {
    Matrix<double> coefficient = Matrix<double>::Zero(rows, rows);
    for (std::size_t k = 0; k < 4; ++k)
      coefficient += scaled_coefficient(curve.coordinates()[k], i, scale_log2) * blocks_[k];
    along.coefficients.push_back(std::move(coefficient));
  }
  const numeric::Pencil<double> pencil = numeric::companion_pencil(along);
  report.method = "pencil";
  report.matrix = "moving planes";
  report.matrix_size = rows;
  report.matrix_degree = degree;
  report.pencil_size = pencil.size();
  report.regular_size = static_cast<long>(expected);
  report.precision_bits = 53;
  context.checkpoint("eigenvalues");
  const auto pairs = numeric::generalized_eigen(pencil);
  if (!pairs) return std::nullopt;

  const long bits = bits_for_digits(options.digits) + 40;
  std::vector<Zero> zeros;
  for (Eigen::Index i = 0; i < pairs->values.size() && zeros.size() <= expected; ++i) {
    context.checkpoint("certifying");
    const std::complex<double> t = pairs->values(i);
    // A conjugate pair at once.
    if (t.imag() < 0) continue;
    std::vector<ComplexBall> kernel;
    for (long row = 0; row < rows; ++row) kernel.push_back(exact(pairs->vectors(row, i)));
    const std::optional<HomogeneousParameters> start = inversion_.read(kernel, 64);
    if (!start) continue;
    const auto variables = chart_variables(inversion_.surface(), *start);
    if (!variables) continue;
    const ComplexBall start_t = exact(t);
    std::vector<ComplexBall> point;
    for (const symbolic::UnivariatePolynomial& f : curve.coordinates()) point.push_back(evaluate(f, start_t, 64));
    std::size_t pivot = 0;
    for (std::size_t k = 1; k < 4; ++k)
      if (acb_is_zero(point[pivot].get()) != 0) pivot = k;
    bridge::HomogeneousParameters chart = *start;
    const bool real = t.imag() == 0;
    std::vector<ComplexBall> from{chart[(*variables)[0]], chart[(*variables)[1]], start_t};
    if (real)
      for (ComplexBall& value : from) arb_zero(value.imaginary());
    const bridge::System system = common_point_system(inversion_.surface(), curve, chart, *variables, pivot);
    auto found = bridge::enclose_system_zero(system, from, bits, newton_steps(bits) + 2);
    if (!found) continue;
    Zero zero{*start, (*found)[2], real};
    for (std::size_t k = 0; k < 2; ++k) zero.parameters[(*variables)[k]] = (*found)[k];
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
