// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/intersect/whole_surfaces/vertex_lifts.hpp>

#include <cmath>

#include <Eigen/Dense>

#include <eliminant/bridge/enclosures/ball_matrix.hpp>

namespace eliminant::intersect {

namespace {

using bridge::RealBall;

std::array<RealBall, 6> lines_at(const symbolic::SeparatedBezoutian::LineCoordinates& lines, const RealBall& at,
                                 long precision) {
  std::array<RealBall, 6> result;
  for (std::size_t k = 0; k < 6; ++k) {
    const fmpz_poly_struct* const p = lines[k].get();
    for (long i = fmpz_poly_length(p) - 1; i >= 0; --i) {
      arb_mul(result[k].get(), result[k].get(), at.get(), precision);
      RealBall coefficient;
      arb_set_fmpz(coefficient.get(), fmpz_poly_get_coeff_ptr(p, i));
      arb_add(result[k].get(), result[k].get(), coefficient.get(), precision);
    }
  }
  return result;
}

/// Without the first row and column for a surface with itself.
std::vector<std::vector<RealBall>> matrix_at(const symbolic::SeparatedBezoutian& matrix, const RealBall& u,
                                             const RealBall& t, bool with_itself, long precision) {
  const std::size_t n = matrix.first_degree();
  const std::size_t m = matrix.second_degree();
  std::vector<std::vector<RealBall>> result(n * m, std::vector<RealBall>(n * m));
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t k = 0; k < m; ++k) {
      const auto second = lines_at(matrix.second_lines(i, k), t, precision);
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t l = 0; l < n; ++l) {
          const auto first = lines_at(matrix.first_lines(j, l), u, precision);
          RealBall& entry = result[i * n + j][k * n + l];
          for (std::size_t c = 0; c < 6; ++c) arb_addmul(entry.get(), first[c].get(), second[c].get(), precision);
        }
    }
  if (with_itself) {
    result.erase(result.begin());
    for (auto& row : result) row.erase(row.begin());
  }
  return result;
}

/// Whether the surface takes no point twice on the box.
bool is_injective(const SurfaceCharts& surface, const std::array<bool, 2>& inverted,
                  const std::array<DoubleInterval, 2>& box) {
  if (!box[0].is_finite() || !box[1].is_finite()) return false;
  const SurfaceJet jet = surface.jet(inverted, box);
  for (std::size_t k = 0; k < 4; ++k) {
    if (!jet.value[k].excludes_zero()) continue;
    // Derivatives of the affine coordinates value[i] / value[k], times value[k]^2 on the same box.
    std::array<std::array<DoubleInterval, 2>, 4> slope;
    const DoubleInterval scale = inverse(jet.value[k] * jet.value[k]);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t p = 0; p < 2; ++p)
        slope[i][p] = (jet.derivative[p][i] * jet.value[k] - jet.value[i] * jet.derivative[p][k]) * scale;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < a; ++b) {
        if (a == k || b == k) continue;
        Eigen::Matrix2d centre;
        centre << middle(slope[a][0]), middle(slope[a][1]), middle(slope[b][0]), middle(slope[b][1]);
        const Eigen::Matrix2d inverse_matrix = centre.inverse();
        if (!inverse_matrix.allFinite()) continue;
        bool regular = true;
        for (long i = 0; i < 2; ++i) {
          double row = 0;
          for (std::size_t j = 0; j < 2; ++j)
            row += (DoubleInterval(inverse_matrix(i, 0)) * slope[a][j] +
                    DoubleInterval(inverse_matrix(i, 1)) * slope[b][j] -
                    DoubleInterval(static_cast<std::size_t>(i) == j ? 1.0 : 0.0))
                       .magnitude();
          regular = regular && row < 0.9;
        }
        if (regular) return true;
      }
  }
  return false;
}

double to_double(const RealBall& ball) { return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR); }

}  // namespace

bool VertexLifts::has_corank_one(const TopologyVertex& vertex) const {
  const long precision = 256;
  const auto matrix =
      matrix_at(matrix_, RealBall(vertex.x.ball.real()), RealBall(vertex.y.ball.real()), with_itself_, precision);
  const std::size_t n = matrix.size();
  if (n == 0) return false;
  // [B w; w^T 0] is regular for some w if and only if the rank of the symmetric B is at least n - 1.
  Eigen::MatrixXd approximation(static_cast<long>(n), static_cast<long>(n));
  double scale = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double entry = to_double(matrix[i][j]);
      approximation(static_cast<long>(i), static_cast<long>(j)) = entry;
      scale = std::max(scale, std::fabs(entry));
    }
  if (!(scale > 0) || !std::isfinite(scale)) {
    if (n > 1) return false;
    scale = 1;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(approximation, Eigen::ComputeFullV);
  const Eigen::VectorXd kernel = svd.matrixV().col(static_cast<long>(n) - 1);
  bridge::BallMatrix bordered(n + 1, n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) acb_set_arb(bordered.entry(i, j), matrix[i][j].get());
    acb_set_d(bordered.entry(i, n), scale * kernel[static_cast<long>(i)]);
    acb_set_d(bordered.entry(n, i), scale * kernel[static_cast<long>(i)]);
  }
  bridge::ComplexBall determinant;
  acb_mat_det(determinant.get(), bordered.get(), precision);
  return acb_contains_zero(determinant.get()) == 0;
}

VertexLifts::Found VertexLifts::above(const TopologyVertex& vertex, const std::array<bool, 2>& inverted,
                                      const std::array<DoubleInterval, 2>& kept) const {
  const Charts charts{inverted[0], false, false, inverted[1]};
  Found found;
  const bool one_point = has_corank_one(vertex);
  for (const double side : {0x1p-7, 0x1p-10, 0x1p-13, 0x1p-16, 0x1p-19, 0x1p-22}) {
    const auto boxes = fibre_boxes(pair_, charts, kept[0], kept[1], side, 3000);
    if (!boxes) return found;
    std::vector<FibreBox> groups;
    for (const auto& members : gather_boxes(*boxes)) {
      const auto box = hull_of(*boxes, members);
      if (!box) return found;
      if (with_itself_) {
        // The point itself is no second preimage.
        const ParameterBox own = in_charts(box->box, box->inverted,
                                           {box->inverted[0], box->inverted[3], box->inverted[0], box->inverted[3]});
        if (overlap(own[1], own[3]) && overlap(own[0], own[2])) {
          const std::array<DoubleInterval, 2> around{hull(own[0], own[2]), hull(own[1], own[3])};
          if (one_point || is_injective(pair_.first(), {box->inverted[0], box->inverted[3]}, around)) continue;
        }
      }
      groups.push_back(*box);
    }
    if (one_point) {
      if (groups.size() != 1) continue;
      found.lift = VertexLift::one_point;
      found.box = groups.front();
      continue;
    }
    if (groups.empty()) {
      found.lift = VertexLift::complex;
      return found;
    }
    bool smooth = true;
    for (const FibreBox& group : groups) smooth = smooth && is_smooth_branch(pair_, group);
    if (smooth) {
      found.lift = VertexLift::branches;
      return found;
    }
  }
  return found;
}

}  // namespace eliminant::intersect
