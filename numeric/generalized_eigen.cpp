// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/numeric/generalized_eigen.hpp>
#include <eliminant/numeric/lapack.hpp>

namespace eliminant::numeric {

template <>
std::optional<Eigenpairs<double>> generalized_eigen(const Pencil<double>& pencil) {
  Matrix<double> a = pencil.a;
  Matrix<double> b = pencil.b;
  const int n = static_cast<int>(pencil.size());
  Eigenpairs<double> pairs;
  if (n == 0) return pairs;
  if (!all_finite(a) || !all_finite(b)) return std::nullopt;
  Vector<double> alpha_real(n);
  Vector<double> alpha_imaginary(n);
  Vector<double> beta(n);
  Matrix<double> vectors(n, n);
  const char no = 'N';
  const char yes = 'V';
  const int one = 1;
  double unused = 0;
  double optimal = 0;
  int info = 0;
  int work_size = -1;
  dggev_(&no, &yes, &n, a.data(), &n, b.data(), &n, alpha_real.data(), alpha_imaginary.data(), beta.data(), &unused,
         &one, vectors.data(), &n, &optimal, &work_size, &info);
  work_size = static_cast<int>(optimal);
  Vector<double> work(work_size);
  dggev_(&no, &yes, &n, a.data(), &n, b.data(), &n, alpha_real.data(), alpha_imaginary.data(), beta.data(), &unused,
         &one, vectors.data(), &n, work.data(), &work_size, &info);
  if (info != 0) return std::nullopt;

  pairs.values.resize(n);
  pairs.vectors.resize(n, n);
  long count = 0;
  const auto keep = [&](int k, const Eigen::VectorXcd& vector, double sign) {
    const std::complex<double> value(alpha_real(k) / beta(k), sign * alpha_imaginary(k) / beta(k));
    if (beta(k) == 0 || !is_finite(value)) return;
    pairs.values(count) = value;
    pairs.vectors.col(count) = vector;
    ++count;
  };
  for (int k = 0; k < n; ++k) {
    if (alpha_imaginary(k) == 0 || !std::isfinite(alpha_imaginary(k)) || k + 1 == n) {
      keep(k, vectors.col(k).cast<std::complex<double>>(), 1);
      continue;
    }
    // A complex pair occupies two columns: real and imaginary part of the vector of the first value.
    const Eigen::VectorXcd vector = vectors.col(k) + std::complex<double>(0, 1) * vectors.col(k + 1);
    keep(k, vector, 1);
    keep(k, vector.conjugate(), -1);
    ++k;
  }
  pairs.values.conservativeResize(count);
  pairs.vectors.conservativeResize(n, count);
  return pairs;
}

}  // namespace eliminant::numeric
