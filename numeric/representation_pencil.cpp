// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/representation_pencil.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include <Eigen/QR>

#include <eliminant/base/error.hpp>
#include <eliminant/numeric/common_point_newton.hpp>
#include <eliminant/numeric/generalized_eigen.hpp>
#include <eliminant/numeric/lapack.hpp>

namespace eliminant::numeric {

namespace {

using Complex = std::complex<double>;

double conjugated(double x) { return x; }
Complex conjugated(const Complex& x) { return std::conj(x); }
double size_of(double x) { return std::abs(x); }
/// Within a factor of the square root of two, and cheaper.
double size_of(const Complex& x) { return std::max(std::abs(x.real()), std::abs(x.imag())); }

bool finite(double x) { return std::isfinite(x); }
bool finite(const Complex& x) { return std::isfinite(x.real()) && std::isfinite(x.imag()); }

template <class Scalar>
double norm_of(const std::array<Scalar, 4>& v) {
  double sum = 0;
  for (const Scalar& x : v) sum += std::norm(x);
  return std::sqrt(sum);
}

/// Fixed numbers that look random, in [-1, 1] (splitmix64).
double fixed_random(std::uint64_t index) {
  std::uint64_t z = (index + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  z ^= z >> 31U;
  return static_cast<double>(z >> 11U) * 0x1p-52 - 1.0;
}

}  // namespace

template <class Scalar>
struct RepresentationPencil::Candidate : CommonPointGuess<Scalar> {
  bool has_parameters = false;
  NumericState state = NumericState::undetermined;
};

RepresentationPencil::RepresentationPencil(const SurfaceForms& surface) : frame_(), surface_(surface) {
  if (!all_finite(surface.coefficients)) throw InvalidInput("a coefficient of the surface is not finite", "numbers");
  frame_ = CoordinateFrame::of(surface);
  frame_.apply(surface_.coefficients);
  prepare(moving_plane_blocks(surface_, moving_plane_degrees(surface_)));
}

RepresentationPencil::RepresentationPencil(const SurfaceForms& surface, const MovingPlaneBlocks& m)
    : frame_(CoordinateFrame::of(surface)), surface_(surface) {
  frame_.apply(surface_.coefficients);
  // x_k = scale_k x'_k + centre_k scale_3 x'_3.
  MovingPlaneBlocks framed = m;
  for (std::size_t k = 0; k < 3; ++k) framed.blocks[3] += frame_.centre[k] * framed.blocks[k];
  for (std::size_t k = 0; k < 4; ++k) framed.blocks[k] *= frame_.scale[k];
  prepare(framed);
}

void RepresentationPencil::prepare(const MovingPlaneBlocks& m) {
  rows_ = m.rows();
  columns_ = m.columns();
  row_degrees_ = m.row_degrees;
  surface_norm_ = surface_.coefficients.norm();
  if (columns_ < rows_) throw InvalidInput("the matrix has fewer columns than rows", "a matrix representation");
  // An orthonormal basis of the moving planes.
  Matrix<double> stacked(4 * rows_, columns_);
  for (long k = 0; k < 4; ++k) stacked.middleRows(k * rows_, rows_) = m.blocks[static_cast<std::size_t>(k)];
  for (long j = 0; j < columns_; ++j) stacked.col(j) /= power_of_two_above(stacked.col(j).cwiseAbs().maxCoeff());
  if (!all_finite(stacked)) throw InvalidInput("an entry of the matrix is not finite", "a matrix representation");
  const Eigen::HouseholderQR<Matrix<double>> qr(stacked);
  const Matrix<double> basis = qr.householderQ() * Matrix<double>::Identity(4 * rows_, columns_);
  for (long k = 0; k < 4; ++k) blocks_[static_cast<std::size_t>(k)] = basis.middleRows(k * rows_, rows_).transpose();
  Matrix<double> combination = Matrix<double>::Identity(columns_, rows_);
  if (columns_ > rows_) {
    Matrix<double> random(columns_, rows_);
    for (long i = 0; i < random.size(); ++i) random(i) = fixed_random(static_cast<std::uint64_t>(i));
    combination = Eigen::HouseholderQR<Matrix<double>>(random).householderQ() * combination;
  }
  // The vectors of the square matrices are reflected: the symmetries of a surface would make some of them orthogonal to
  // the one vector with which the eigenvectors are found.
  mirror_.resize(rows_);
  for (long i = 0; i < rows_; ++i) mirror_(i) = fixed_random(static_cast<std::uint64_t>(i) + 7777);
  mirror_ /= mirror_.norm();
  square_.resize(rows_ * rows_, 4);
  for (long k = 0; k < 4; ++k) {
    Matrix<double> square = combination.transpose() * blocks_[static_cast<std::size_t>(k)];
    const Vector<double> image = square * mirror_;
    square -= 2 * image * mirror_.transpose();
    square_.col(k) = Eigen::Map<const Vector<double>>(square.data(), square.size());
  }
  // Rows that are multiples of each parameter, by what is left of the monomial.
  const bool triangular = surface_.triangular;
  const auto at = [&](long i, long j) { return monomial_index(triangular, row_degrees_, i, j); };
  if (triangular) {
    multiples_.assign(1, std::vector<std::vector<long>>(3));
    for (long i = 0; i < row_degrees_[0]; ++i)
      for (long j = 0; i + j < row_degrees_[0]; ++j) {
        multiples_[0][0].push_back(at(i + 1, j));
        multiples_[0][1].push_back(at(i, j + 1));
        multiples_[0][2].push_back(at(i, j));
      }
    return;
  }
  multiples_.assign(2, std::vector<std::vector<long>>(2));
  for (long i = 0; i <= row_degrees_[0]; ++i)
    for (long j = 0; j <= row_degrees_[1]; ++j) {
      if (i < row_degrees_[0]) {
        multiples_[0][0].push_back(at(i + 1, j));
        multiples_[0][1].push_back(at(i, j));
      }
      if (j < row_degrees_[1]) {
        multiples_[1][0].push_back(at(i, j + 1));
        multiples_[1][1].push_back(at(i, j));
      }
    }
}

/// The matrix along the turned curve, its leading coefficient factored: smallest over largest pivot.
double RepresentationPencil::factor_leading(const ParameterTurn& turn, Workspace& workspace) const {
  turn.apply(workspace.framed, workspace.curve);
  const long degree = workspace.framed.degree();
  workspace.along.resize(rows_ * rows_, degree + 1);
  const char no = 'N';
  const int entries = static_cast<int>(rows_ * rows_);
  const int count = static_cast<int>(degree + 1);
  const int four = 4;
  const double one = 1;
  const double zero = 0;
  dgemm_(&no, &no, &entries, &count, &four, &one, square_.data(), &entries, workspace.curve.coefficients.data(), &four,
         &zero, workspace.along.data(), &entries);
  const int n = static_cast<int>(rows_);
  workspace.pivots.resize(static_cast<std::size_t>(rows_));
  int info = 0;
  double* leading = workspace.along.col(degree).data();
  dgetrf_(&n, &n, leading, &n, workspace.pivots.data(), &info);
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (long i = 0; i < rows_; ++i) {
    const double pivot = std::abs(leading[i * (rows_ + 1)]);
    smallest = std::min(smallest, pivot);
    largest = std::max(largest, pivot);
  }
  return largest > 0 ? smallest / largest : 0;
}

/// The companion matrix of the monic matrix polynomial, of vectors (v, x v, ..., x^(e-1) v).
void RepresentationPencil::solve_companion(Workspace& workspace) const {
  const long degree = workspace.along.cols() - 1;
  const int n = static_cast<int>(rows_);
  const int right_sides = static_cast<int>(rows_ * degree);
  const char no = 'N';
  int info = 0;
  dgetrs_(&no, &n, &right_sides, workspace.along.col(degree).data(), &n, workspace.pivots.data(),
          workspace.along.data(), &n, &info);
  workspace.companion.setZero(rows_ * degree, rows_ * degree);
  const Eigen::Map<const Matrix<double>> quotient(workspace.along.data(), rows_, rows_ * degree);
  workspace.companion.bottomRows(rows_) = -quotient;
  for (long k = 0; k + 1 < degree; ++k)
    workspace.companion.block(k * rows_, (k + 1) * rows_, rows_, rows_).setIdentity();
}

/// Ratios of neighbouring entries, all of them weighed by their size.
template <class Scalar>
ParameterChart<Scalar> RepresentationPencil::read_parameters(const Scalar* vector) const {
  ParameterChart<Scalar> chart;
  std::size_t position = 0;
  std::size_t varying = 0;
  for (const std::vector<std::vector<long>>& group : multiples_) {
    std::size_t largest = 0;
    double largest_size = -1;
    for (std::size_t p = 0; p < group.size(); ++p) {
      double size = 0;
      for (const long row : group[p]) size += std::norm(vector[row]);
      if (!(size > largest_size)) continue;
      largest_size = size;
      largest = p;
    }
    for (std::size_t p = 0; p < group.size(); ++p) {
      if (p == largest) {
        chart.values[position + p] = Scalar(1);
        continue;
      }
      Scalar product(0);
      for (std::size_t i = 0; i < group[p].size(); ++i)
        product += vector[group[p][i]] * conjugated(vector[group[largest][i]]);
      chart.values[position + p] = product / largest_size;
      chart.variables[varying++] = position + p;
    }
    position += group.size();
  }
  return chart;
}

/// v - 2 (u . v) u: there and back.
template <class Scalar>
void RepresentationPencil::reflect(Scalar* vector) const {
  Scalar product(0);
  for (long i = 0; i < rows_; ++i) product += mirror_(i) * vector[i];
  product *= 2.0;
  for (long i = 0; i < rows_; ++i) vector[i] -= mirror_(i) * product;
}

/// The whole matrix does not take the vector to zero, and the square one does or the vector is the best there is: an
/// eigenvalue of the projection.
template <class Scalar>
bool RepresentationPencil::is_spurious(const std::array<Scalar, 4>& point, const Scalar* vector,
                                       bool vector_is_best) const {
  using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  // Of an eigenvalue of multiplicity m the vector is known to about the m-th root of the machine epsilon.
  constexpr double surely_not_zero = 1e-3;
  constexpr double surely_zero = 1e-6;
  Column v = Eigen::Map<const Column>(vector, rows_);
  const double scale = norm_of(point) * v.norm();
  if (!(scale > 0)) return false;
  Column whole = Column::Zero(columns_);
  for (std::size_t k = 0; k < 4; ++k) whole += blocks_[k] * (point[k] * v);
  if (!(whole.norm() > surely_not_zero * scale)) return false;
  if (vector_is_best) return true;
  reflect(v.data());
  Column square = Column::Zero(rows_);
  for (std::size_t k = 0; k < 4; ++k)
    square += Eigen::Map<const Matrix<double>>(square_.col(static_cast<long>(k)).data(), rows_, rows_) * (point[k] * v);
  return square.norm() < surely_zero * scale;
}

/// The smallest singular vector of the whole matrix at a point, by two steps of inverse iteration.
template <class Scalar>
void RepresentationPencil::inverse_iteration(const std::array<Scalar, 4>& point, Scalar* vector) const {
  using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Dense matrix = Dense::Zero(columns_, rows_);
  for (std::size_t k = 0; k < 4; ++k) matrix += point[k] * blocks_[k].template cast<Scalar>();
  const Eigen::HouseholderQR<Dense> qr(matrix);
  Dense r = qr.matrixQR().topRows(rows_);
  const double smallest = machine_epsilon<double>() * std::max(r.norm(), std::numeric_limits<double>::min());
  for (long i = 0; i < rows_; ++i)
    if (!(std::abs(r(i, i)) > smallest)) r(i, i) = Scalar(smallest);
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> v(rows_);
  for (long i = 0; i < rows_; ++i) v(i) = Scalar(fixed_random(static_cast<std::uint64_t>(i)));
  for (int step = 0; step < 2; ++step) {
    r.adjoint().template triangularView<Eigen::Lower>().solveInPlace(v);
    v /= v.cwiseAbs().maxCoeff();
    r.template triangularView<Eigen::Upper>().solveInPlace(v);
    v /= v.cwiseAbs().maxCoeff();
  }
  for (long i = 0; i < rows_; ++i) vector[i] = finite(v(i)) ? v(i) : Scalar(0);
}

/// False when the eigenvalue belongs to the projection alone.
template <class Scalar>
bool RepresentationPencil::solve_eigenvalue(const Workspace& workspace, long index, bool vector_is_known,
                                            Scalar* vector, Candidate<Scalar>& candidate) const {
  const Complex eigenvalue = workspace.eigenvalues[static_cast<std::size_t>(index)];
  Scalar x;
  if constexpr (std::is_same_v<Scalar, double>)
    x = eigenvalue.real();
  else
    x = eigenvalue;
  const bool large = std::abs(x) > 1;
  const std::array<Scalar, 2> t{large ? Scalar(1) : x, large ? Scalar(1) / x : Scalar(1)};
  const std::array<Scalar, 4> point = jet(workspace.curve, t, large ? 1 : 0).value;
  candidate.t = t;
  ParameterChart<Scalar> start;
  if (vector_is_known) reflect(vector);
  for (int attempt = vector_is_known ? 0 : 1; attempt < 2; ++attempt) {
    if (attempt == 1) inverse_iteration(point, vector);
    if (vector_is_known && columns_ > rows_ && is_spurious(point, vector, attempt == 1)) return false;
    double largest = 0;
    for (long i = 0; i < rows_; ++i) largest = std::max(largest, size_of(vector[i]));
    if (!(largest > 0)) continue;
    start = read_parameters(vector);
    if (!finite(start.values[start.variables[0]]) || !finite(start.values[start.variables[1]])) continue;
    candidate.chart = start;
    candidate.t = t;
    candidate.t_variable = large ? 1 : 0;
    candidate.has_parameters = true;
    if (settle_common_point(surface_, surface_norm_, workspace.curve, candidate)) {
      candidate.state = NumericState::converged;
      break;
    }
    candidate.chart = start;
    candidate.t = t;
    candidate.step = candidate.first_step = 0;
  }
  // Too far to be sure that it was this eigenvalue.
  constexpr double negligible = 1e-10;
  if (candidate.state != NumericState::converged || candidate.moved < negligible) return true;
  for (std::size_t k = 0; k < workspace.eigenvalues.size(); ++k) {
    if (static_cast<long>(k) == index) continue;
    const Complex other = workspace.eigenvalues[k];
    const double chord = std::abs(other - eigenvalue) / std::sqrt((1 + std::norm(other)) * (1 + std::norm(eigenvalue)));
    if (!(candidate.moved > chord / 3)) continue;
    candidate.chart = start;
    candidate.t = t;
    candidate.step = candidate.first_step = 0;
    candidate.state = NumericState::undetermined;
    break;
  }
  return true;
}

/// Back to the parameters of the caller.
template <class Scalar>
NumericIntersection RepresentationPencil::intersection(const ParameterTurn& turn, bool bernstein,
                                                       const Candidate<Scalar>& candidate) const {
  NumericIntersection solution;
  std::array<Scalar, 2> t = turn.back(candidate.t);
  if (bernstein) t[1] += t[0];
  const double t_size = std::max(std::abs(t[0]), std::abs(t[1]));
  for (std::size_t k = 0; k < 2; ++k) solution.t[k] = Complex(t[k] / t_size);
  solution.has_parameters = candidate.has_parameters;
  solution.step = candidate.step;
  solution.first_step = candidate.first_step;
  solution.distance = candidate.distance;
  solution.state = candidate.state;
  if (!candidate.has_parameters) return solution;
  std::array<Scalar, 4> values = candidate.chart.values;
  if (!surface_.triangular && surface_.bernstein)
    for (std::size_t k = 0; k < 4; k += 2) {
      values[k + 1] += values[k];
      const double size = std::max(std::abs(values[k]), std::abs(values[k + 1]));
      values[k] /= size;
      values[k + 1] /= size;
    }
  for (std::size_t k = 0; k < 4; ++k) solution.parameters[k] = Complex(values[k]);
  return solution;
}

/// What belongs to the chosen eigenvalues, conjugate ones at once.
void RepresentationPencil::read_solutions(const ParameterTurn& turn, bool bernstein, const Matrix<double>* vectors,
                                          Workspace& workspace, NumericIntersections& result) const {
  workspace.real_vector.resize(static_cast<std::size_t>(rows_));
  workspace.complex_vector.resize(static_cast<std::size_t>(rows_));
  long column = 0;
  for (const long k : workspace.chosen) {
    if (workspace.eigenvalues[static_cast<std::size_t>(k)].imag() == 0) {
      if (vectors != nullptr) std::copy_n(vectors->col(column).data(), rows_, workspace.real_vector.begin());
      ++column;
      Candidate<double> candidate;
      if (solve_eigenvalue(workspace, k, vectors != nullptr, workspace.real_vector.data(), candidate))
        result.solutions.push_back(intersection(turn, bernstein, candidate));
      continue;
    }
    if (vectors != nullptr)
      for (long i = 0; i < rows_; ++i)
        workspace.complex_vector[static_cast<std::size_t>(i)] = {(*vectors)(i, column), (*vectors)(i, column + 1)};
    column += 2;
    Candidate<Complex> candidate;
    if (!solve_eigenvalue(workspace, k, vectors != nullptr, workspace.complex_vector.data(), candidate)) continue;
    NumericIntersection solution = intersection(turn, bernstein, candidate);
    result.solutions.push_back(solution);
    for (Complex& value : solution.t) value = std::conj(value);
    for (Complex& value : solution.parameters) value = std::conj(value);
    result.solutions.push_back(solution);
  }
}

/// The curve in the frame of the surface, its coefficients about 1: the scale of its parameter that makes both ends
/// equally large.
double RepresentationPencil::into_frame(const CurveForms& curve, Workspace& workspace) const {
  if (curve.degree() < 1 || curve.degree() > largest_numeric_degree)
    throw InvalidInput("the degree of the curve is " + std::to_string(curve.degree()), "1 to 31");
  if (!all_finite(curve.coefficients)) throw InvalidInput("a coefficient of the curve is not finite", "numbers");
  CurveForms& framed = workspace.framed;
  framed = curve;
  framed.coefficients /= power_of_two_above(framed.coefficients.cwiseAbs().maxCoeff());
  frame_.apply(framed.coefficients);
  const double largest = framed.coefficients.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !std::isfinite(largest)) throw InvalidInput("the curve is nowhere", "a curve");
  framed.coefficients /= power_of_two_above(largest);
  const double first = framed.coefficients.col(0).norm();
  const double last = framed.coefficients.col(curve.degree()).norm();
  constexpr double negligible = 0x1p-40;
  if (!(first > negligible) || !(last > negligible)) return 1;
  return power_of_two_above(std::pow(first / last, 1.0 / static_cast<double>(curve.degree())));
}

void RepresentationPencil::intersect(const CurveForms& curve, bool real_only, Workspace& workspace,
                                     NumericIntersections& result) const {
  result.solutions.clear();
  result.outcome = NumericOutcome::rank_deficient;
  ParameterTurn turn;
  turn.scale = into_frame(curve, workspace);
  // Angles that no simple ratio of parameters has.
  constexpr std::array<double, 4> angles{0.91, 1.73, 2.39, 0.17};
  constexpr double well_conditioned = 1e-7;
  constexpr double singular = 1e-11;
  double best = -1;
  ParameterTurn best_turn = turn;
  for (const double angle : angles) {
    turn.cosine = std::cos(angle);
    turn.sine = std::sin(angle);
    const double ratio = factor_leading(turn, workspace);
    if (ratio > best) {
      best = ratio;
      best_turn = turn;
    }
    if (ratio > well_conditioned) break;
  }
  if (!(best > singular)) return;
  if (best_turn.cosine != turn.cosine) {
    turn = best_turn;
    factor_leading(turn, workspace);
  }
  solve_companion(workspace);
  if (!all_finite(workspace.companion)) return;
  HessenbergEigenpairs& eigenpairs = workspace.eigenpairs;
  result.outcome = NumericOutcome::not_converged;
  if (!eigenpairs.compute(workspace.companion)) return;
  result.outcome = NumericOutcome::solved;
  workspace.eigenvalues.clear();
  workspace.chosen.clear();
  for (long k = 0; k < eigenpairs.size(); ++k) {
    const Complex value = eigenpairs.eigenvalue(k);
    workspace.eigenvalues.push_back(value);
    if (real_only ? value.imag() == 0 : value.imag() >= 0) workspace.chosen.push_back(k);
  }
  const Matrix<double>& vectors = eigenpairs.eigenvectors(workspace.chosen, rows_);
  read_solutions(turn, curve.bernstein, &vectors, workspace, result);
}

void RepresentationPencil::intersect_by_staircase(const CurveForms& curve, const StaircaseSteps& column_steps,
                                                  const StaircaseSteps& row_steps, Workspace& workspace,
                                                  NumericIntersections& result) const {
  result.solutions.clear();
  result.outcome = NumericOutcome::not_converged;
  ParameterTurn turn;
  turn.scale = into_frame(curve, workspace);
  turn.apply(workspace.framed, workspace.curve);
  std::vector<Matrix<double>> along;
  for (long i = 0; i <= curve.degree(); ++i) {
    Matrix<double>& coefficient = along.emplace_back(Matrix<double>::Zero(columns_, rows_));
    for (std::size_t k = 0; k < 4; ++k)
      coefficient += workspace.curve.coefficients(static_cast<long>(k), i) * blocks_[k];
  }
  const std::optional<Eigenpairs<double>> pairs =
      generalized_eigen(regular_part_staircase(rectangular_companion_pencil(along), column_steps, row_steps));
  if (!pairs) return;
  result.outcome = NumericOutcome::solved;
  workspace.eigenvalues.assign(pairs->values.data(), pairs->values.data() + pairs->values.size());
  workspace.chosen.clear();
  for (long k = 0; k < pairs->values.size(); ++k)
    if (pairs->values(k).imag() >= 0) workspace.chosen.push_back(k);
  read_solutions(turn, curve.bernstein, nullptr, workspace, result);
}

}  // namespace eliminant::numeric
