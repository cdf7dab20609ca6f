// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include <eliminant/numeric/eigenvalue_clusters.hpp>
#include <eliminant/numeric/lapack.hpp>

namespace eliminant::numeric {

namespace {

using Complex = std::complex<double>;

/// Relative error of the multiplication matrices, which come from an LU factorisation.
constexpr double matrix_error = 1e-13;
/// A cluster is complete when nothing is nearer than this many errors of its mean.
constexpr double clear_gap = 10;

/// The Schur form M = Q T Q^* of a complex matrix, to be reordered.
struct SchurForm {
  Matrix<Complex> t, q;
  Vector<Complex> eigenvalues;
};

std::optional<SchurForm> schur_form(const Matrix<double>& matrix) {
  if (!all_finite(matrix)) return std::nullopt;
  const int n = static_cast<int>(matrix.rows());
  SchurForm schur{matrix.cast<Complex>(), Matrix<Complex>(n, n), Vector<Complex>(n)};
  const char vectors = 'V';
  const char no = 'N';
  int sorted = 0;
  int info = 0;
  const int work_size = std::max(1, 64 * n);
  Vector<Complex> work(work_size);
  Vector<double> real_work(n);
  std::vector<int> unused(static_cast<std::size_t>(n));
  zgees_(&vectors, &no, nullptr, &n, schur.t.data(), &n, &sorted, schur.eigenvalues.data(), schur.q.data(), &n,
         work.data(), &work_size, real_work.data(), unused.data(), &info);
  if (info != 0) return std::nullopt;
  return schur;
}

/// Brings the members of a cluster to the top; the reciprocal condition number of their mean.
double bring_to_top(SchurForm& schur, const std::vector<int>& members) {
  const int n = static_cast<int>(schur.t.rows());
  std::vector<int> select(static_cast<std::size_t>(n), 0);
  for (const int k : members) select[static_cast<std::size_t>(k)] = 1;
  const char condition_of_mean = 'E';
  const char with_vectors = 'V';
  int dimension = 0;
  double condition = 0;
  double separation = 0;
  int info = 0;
  const int work_size = std::max(1, n * n);
  Vector<Complex> work(work_size);
  ztrsen_(&condition_of_mean, &with_vectors, select.data(), &n, schur.t.data(), &n, schur.q.data(), &n,
          schur.eigenvalues.data(), &dimension, &condition, &separation, work.data(), &work_size, &info);
  return info == 0 ? condition : 0;
}

class Clusters {
 public:
  explicit Clusters(const SchurForm& schur) : schur_(schur), size_(schur.t.norm()) {
    for (int k = 0; k < static_cast<int>(schur.eigenvalues.size()); ++k) clusters_.push_back({k});
  }

  const std::vector<std::vector<int>>& gather() {
    for (std::size_t i = 0; i < clusters_.size();) {
      const auto [nearest, gap] = nearest_other(i);
      if (nearest == clusters_.size()) break;
      SchurForm reordered = schur_;
      const double condition = bring_to_top(reordered, clusters_[i]);
      const double error = matrix_error * size_ / std::max(condition, std::numeric_limits<double>::min());
      if (gap > clear_gap * error) {
        ++i;
        continue;
      }
      // The joined cluster is looked at again, at the place of the first one.
      const std::size_t low = std::min(i, nearest);
      const std::size_t high = std::max(i, nearest);
      clusters_[low].insert(clusters_[low].end(), clusters_[high].begin(), clusters_[high].end());
      clusters_.erase(clusters_.begin() + static_cast<std::ptrdiff_t>(high));
      i = low;
    }
    return clusters_;
  }

 private:
  std::pair<std::size_t, double> nearest_other(std::size_t i) const {
    std::pair<std::size_t, double> nearest{clusters_.size(), std::numeric_limits<double>::infinity()};
    for (std::size_t j = 0; j < clusters_.size(); ++j) {
      if (j == i) continue;
      for (const int a : clusters_[i])
        for (const int b : clusters_[j]) {
          const double distance = std::abs(schur_.eigenvalues(a) - schur_.eigenvalues(b));
          if (distance < nearest.second) nearest = {j, distance};
        }
    }
    return nearest;
  }

  const SchurForm& schur_;
  double size_;
  std::vector<std::vector<int>> clusters_;
};

std::optional<std::vector<ClusteredPoint>> clusters_of(const MultiplicationMatrices<double>& matrices, double x_weight,
                                                       double y_weight) {
  const auto schur = schur_form(x_weight * matrices.x + y_weight * matrices.y);
  if (!schur) return std::nullopt;
  std::vector<ClusteredPoint> points;
  Clusters clusters(*schur);
  for (const std::vector<int>& members : clusters.gather()) {
    SchurForm reordered = *schur;
    bring_to_top(reordered, members);
    const auto dimension = static_cast<long>(members.size());
    const Matrix<Complex> basis = reordered.q.leftCols(dimension);
    const auto mean = [&](const Matrix<double>& matrix) {
      return (basis.adjoint() * (matrix.cast<Complex>() * basis)).trace() / static_cast<double>(dimension);
    };
    points.push_back({{mean(matrices.x), mean(matrices.y)}, dimension});
  }
  return points;
}

std::vector<long> multiplicities(const std::vector<ClusteredPoint>& points) {
  std::vector<long> result;
  for (const ClusteredPoint& point : points) result.push_back(point.multiplicity);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

std::optional<std::vector<ClusteredPoint>> points_by_clusters(const MultiplicationMatrices<double>& matrices) {
  if (matrices.x.rows() == 0) return std::vector<ClusteredPoint>{};
  auto points = clusters_of(matrices, 0.74526130466719678, 0.66677837257372732);
  const auto witness = clusters_of(matrices, 0.41352643046671967, -0.91050683725737273);
  if (!points || !witness || multiplicities(*points) != multiplicities(*witness)) return std::nullopt;
  return points;
}

}  // namespace eliminant::numeric
