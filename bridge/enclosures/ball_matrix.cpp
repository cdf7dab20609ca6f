// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/bridge/enclosures/ball_matrix.hpp>

namespace eliminant::bridge {

namespace {

/// A vector of complex balls, as Arb's eigenvalue functions want it.
class BallVector {
 public:
  explicit BallVector(std::size_t size) : size_(static_cast<slong>(size)), value_(_acb_vec_init(size_)) {}
  BallVector(const BallVector&) = delete;
  BallVector& operator=(const BallVector&) = delete;
  ~BallVector() { _acb_vec_clear(value_, size_); }
  acb_ptr get() { return value_; }

 private:
  slong size_;
  acb_ptr value_;
};

}  // namespace

std::optional<BallMatrix> simple_eigenvectors(const BallMatrix& matrix, long precision_bits) {
  const std::size_t n = matrix.rows();
  BallVector approximate_values(n);
  BallMatrix approximate_vectors(n, n);
  BallMatrix middle(n, n);
  acb_mat_get_mid(middle.get(), matrix.get());
  acb_mat_approx_eig_qr(approximate_values.get(), nullptr, approximate_vectors.get(), middle.get(), nullptr, 0,
                        precision_bits);
  BallVector values(n);
  BallMatrix vectors(n, n);
  if (acb_mat_eig_simple_vdhoeven_mourrain(values.get(), nullptr, vectors.get(), matrix.get(), approximate_values.get(),
                                           approximate_vectors.get(), precision_bits) == 0)
    return std::nullopt;
  return vectors;
}

}  // namespace eliminant::bridge
