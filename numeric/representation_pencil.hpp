// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <vector>

#include <eliminant/numeric/coordinate_frame.hpp>
#include <eliminant/numeric/hessenberg_eigenpairs.hpp>
#include <eliminant/numeric/moving_plane_blocks.hpp>
#include <eliminant/numeric/rectangular_staircase.hpp>

namespace eliminant::numeric {

/// What arithmetic in doubles says of one eigenvalue. Never a proof.
enum class NumericState {
  converged,    ///< Newton's iteration settled on a point of curve and surface that looks simple and alone
  undetermined  ///< multiple, near to another one, a base point, or at several parameters of the surface
};

/// One eigenvalue and the parameters on the surface that its eigenvector names. All numbers are finite.
struct NumericIntersection {
  /// On the curve: (t_0 : t_1), t = t_0 / t_1, the larger one of modulus about 1.
  std::array<std::complex<double>, 2> t{};
  /// On the surface: (s_0 : s_1), (t_0 : t_1), or (s : t : u) and an unused entry; of each group the largest one has
  /// modulus about 1. Zero when there are none.
  std::array<std::complex<double>, 4> parameters{};
  bool has_parameters = false;
  /// Length of the last step of Newton's iteration, in parameters of which the largest is 1; the error left is about
  /// its square.
  double step = 0;
  /// Length of the first one, which is about the error of eigenvalue and eigenvector.
  double first_step = 0;
  /// Sine of the angle between both points as vectors (x, y, z, w), in the coordinates the object works in.
  double distance = 0;
  NumericState state = NumericState::undetermined;
};

enum class NumericOutcome {
  solved,
  rank_deficient,  ///< the matrix has less than full rank along the curve, or nearly: the curve may lie in the surface
  not_converged    ///< the QR algorithm gave up
};

struct NumericIntersections {
  NumericOutcome outcome = NumericOutcome::solved;
  std::vector<NumericIntersection> solutions;
};

/// A surface prepared for any number of curves, in doubles: all common points from the eigenvalues of its matrix
/// representation along the curve. After construction it is constant, and threads may share it, each with a workspace
/// of its own.
///
/// The parameter of the curve is turned by an angle at which the leading matrix is well conditioned, so that no point
/// is at infinity; its LU factorisation makes a standard eigenvalue problem of the companion pencil
/// ([LuuBuseMourrain2009], Definition 2). The parameters on the surface are ratios of entries of the eigenvectors, and
/// Newton's iteration in all three parameters ends what they began. A representation with more columns than rows is
/// projected to a square one by a fixed orthonormal combination ([HochstenbachMehlPlestenjak2023]); an eigenvalue whose
/// vector the square matrix takes to zero, and the whole one far from it, belongs to the projection and is left out.
/// Guarantee: none.
class RepresentationPencil {
 public:
  struct Workspace {
    CurveForms framed;     // in the frame of the surface
    CurveForms curve;      // and in the turned parameter
    Matrix<double> along;  // the matrix coefficients, one beside the other
    Matrix<double> companion;
    std::vector<int> pivots;
    std::vector<std::complex<double>> eigenvalues;  // in the turned parameter
    std::vector<long> chosen;
    std::vector<double> real_vector;
    std::vector<std::complex<double>> complex_vector;
    HessenbergEigenpairs eigenpairs;
  };

  /// From coefficients or control points alone. Throws as moving_plane_blocks.
  explicit RepresentationPencil(const SurfaceForms& surface);
  /// With a representation of the surface that is known.
  RepresentationPencil(const SurfaceForms& surface, const MovingPlaneBlocks& m);

  /// All eigenvalues of the curve, or those alone that come out real (a double one may not); conjugate ones stand side
  /// by side. Throws InvalidInput when a coefficient is not finite, the curve is a point, or its degree exceeds
  /// largest_numeric_degree.
  void intersect(const CurveForms& curve, bool real_only, Workspace& workspace, NumericIntersections& result) const;

  /// The same from the regular part of the companion pencil of the whole matrix, [LuuBuseMourrain2009], section 3.3:
  /// the finite eigenvalues alone, and none of a projection. The steps are the exact ranks for this curve. Slower, and
  /// it allocates.
  void intersect_by_staircase(const CurveForms& curve, const StaircaseSteps& column_steps,
                              const StaircaseSteps& row_steps, Workspace& workspace,
                              NumericIntersections& result) const;

  long rows() const { return rows_; }
  long columns() const { return columns_; }

 private:
  template <class Scalar>
  struct Candidate;

  double into_frame(const CurveForms& curve, Workspace& workspace) const;
  void prepare(const MovingPlaneBlocks& m);
  double factor_leading(const ParameterTurn& turn, Workspace& workspace) const;
  void solve_companion(Workspace& workspace) const;
  template <class Scalar>
  ParameterChart<Scalar> read_parameters(const Scalar* vector) const;
  template <class Scalar>
  void reflect(Scalar* vector) const;
  template <class Scalar>
  bool is_spurious(const std::array<Scalar, 4>& point, const Scalar* vector, bool vector_is_best) const;
  template <class Scalar>
  void inverse_iteration(const std::array<Scalar, 4>& point, Scalar* vector) const;
  template <class Scalar>
  bool solve_eigenvalue(const Workspace& workspace, long index, bool vector_is_known, Scalar* vector,
                        Candidate<Scalar>& candidate) const;
  template <class Scalar>
  NumericIntersection intersection(const ParameterTurn& turn, bool bernstein, const Candidate<Scalar>& candidate) const;
  void read_solutions(const ParameterTurn& turn, bool bernstein, const Matrix<double>* vectors, Workspace& workspace,
                      NumericIntersections& result) const;

  CoordinateFrame frame_;
  SurfaceForms surface_;  // in the frame
  long rows_ = 0;
  long columns_ = 0;
  std::array<long, 2> row_degrees_{};
  /// For each group of parameters and each of them: the rows that are multiples of it, in the order of what is left.
  std::vector<std::vector<std::vector<long>>> multiples_;
  std::array<Matrix<double>, 4> blocks_;  // all columns, transposed: columns x rows
  Matrix<double> square_;                 // the transposed square matrices as columns: rows^2 x 4, of reflected vectors
  Vector<double> mirror_;                 // the unit vector across which they are reflected
  double surface_norm_ = 0;
};

}  // namespace eliminant::numeric
