// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include <eliminant/bridge/contact_curve.hpp>
#include <eliminant/bridge/contact_series.hpp>
#include <eliminant/bridge/double_interval.hpp>
#include <eliminant/bridge/patch_jets.hpp>
#include <eliminant/bridge/taylor_tables.hpp>

/// What the files of ContactCurve share: Taylor tables along lines and in other parameters, and the parts of the curve.
namespace eliminant::bridge {

namespace contact {

using Place = std::array<double, 2>;

inline constexpr std::size_t weight = 3;
/// Index of the coordinate along the normal in a frame.
inline constexpr std::size_t normal = 2;

inline double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double cross(const Place& a, const Place& b) { return a[0] * b[1] - a[1] * b[0]; }
inline Place unit(const Place& a) {
  const double length = std::hypot(a[0], a[1]);
  return {a[0] / length, a[1] / length};
}

inline DoubleInterval symmetric(double reach) { return {-reach, reach}; }

/// The table of a patch along a line of its parameters.
template <class Scalar>
TaylorTable<Scalar> along_line(const TaylorTable<Scalar>& patch, const Place& direction) {
  TaylorTable<Scalar> line(1, patch.order());
  for (std::size_t n = 0; n <= patch.order(); ++n)
    for (std::size_t k = 0; k < 4; ++k) {
      Scalar sum(0);
      for (std::size_t i = 0; i <= n; ++i) {
        Scalar term = patch.at(i, n - i)[k];
        for (std::size_t p = 0; p < n; ++p) term = term * Scalar(direction[p < i ? 0 : 1]);
        sum = sum + term;
      }
      line.at(n)[k] = sum;
    }
  return line;
}

/// The table of a patch in parameters (p, q) with s = m00 p + m01 q, t = m10 p + m11 q.
template <class Scalar>
TaylorTable<Scalar> in_parameters(const TaylorTable<Scalar>& patch, const Eigen::Matrix2d& m) {
  TaylorTable<Scalar> result(2, patch.order());
  for (std::size_t i = 0; i <= patch.order(); ++i)
    for (std::size_t j = 0; i + j <= patch.order(); ++j) result.at(i, j).fill(Scalar(0));
  for (std::size_t i = 0; i <= patch.order(); ++i)
    for (std::size_t j = 0; i + j <= patch.order(); ++j) {
      // The form s^i t^j by powers of p.
      std::vector<Scalar> form{Scalar(1)};
      for (std::size_t factor = 0; factor < i + j; ++factor) {
        const long row = factor < i ? 0 : 1;
        std::vector<Scalar> next(form.size() + 1, Scalar(0));
        for (std::size_t a = 0; a < form.size(); ++a) {
          next[a + 1] = next[a + 1] + form[a] * Scalar(m(row, 0));
          next[a] = next[a] + form[a] * Scalar(m(row, 1));
        }
        form = std::move(next);
      }
      for (std::size_t a = 0; a < form.size(); ++a)
        for (std::size_t k = 0; k < 4; ++k)
          result.at(a, i + j - a)[k] = result.at(a, i + j - a)[k] + form[a] * patch.at(i, j)[k];
    }
  return result;
}

inline void to_frame(const ContactFrame& frame, TaylorTable<double>& table) {
  for (std::size_t i = 0; i <= table.order(); ++i)
    for (std::size_t j = 0; i + j <= table.order(); ++j) {
      std::array<double, 4>& p = table.at(i, j);
      Array4d sum = Array4d::Zero();
      for (std::size_t k = 0; k < 3; ++k) sum += frame.columns[k] * (p[k] - frame.origin[static_cast<long>(k)] * p[3]);
      for (std::size_t k = 0; k < 3; ++k) p[k] = sum[static_cast<long>(k)];
    }
}

/// The parameters of the second patch by the coordinates in the tangent plane, to first order.
inline std::optional<Eigen::Matrix2d> parameters_by_plane(const ContactFrame& frame, const PatchJets::Value& second) {
  Eigen::Matrix2d derivative;
  for (long row = 0; row < 2; ++row)
    for (long k = 0; k < 2; ++k) {
      const Array4d& d = second.first[static_cast<std::size_t>(k)];
      derivative(row, k) = d[0] * frame.columns[0][row] + d[1] * frame.columns[1][row] + d[2] * frame.columns[2][row];
    }
  const Eigen::Matrix2d inverse = derivative.inverse();
  if (!inverse.allFinite()) return std::nullopt;
  return inverse;
}

inline double factorial(std::size_t n) { return n < 2 ? 1 : static_cast<double>(n) * factorial(n - 1); }

}  // namespace contact

/// A parallelogram of the base's parameters around a piece of the curve that meets all its lines across, and both
/// patches over it.
struct ContactCurve::Region {
  contact::Place origin{};
  contact::Place across{};
  contact::Place along{};
  /// Of coordinates across and along.
  double reach = 0;
  double length = 0;
  /// How much the curve moves across where it moves by one along, and how much that changes.
  DoubleInterval slope;
  DoubleInterval bend;
  TaylorTable<DoubleInterval> base{2, 0};
  TaylorTable<DoubleInterval> other{2, 0};
  /// The parameters of the other patch.
  contact::Place lower_of_other{};
  contact::Place upper_of_other{};
  /// Bounds |ds| + |dt| where both parameters of the base move by at most one.
  double following = 0;

  /// The derivative of h of an order in a direction, on the whole parallelogram.
  DoubleInterval derivative(const contact::Place& direction, std::size_t order) const {
    const ContactSeries<DoubleInterval> series =
        contact_series(contact::along_line(base.truncated(order), direction), other.truncated(order), contact::normal);
    return DoubleInterval(contact::factorial(order)) * series.difference[order];
  }
};

/// Both patches at a point of the curve, approximately, in the frame of the base.
struct ContactCurve::Tables {
  TaylorTable<double> base;
  TaylorTable<double> other;

  double derivative(const contact::Place& direction, std::size_t order) const {
    const TaylorTable<double> line = contact::along_line(base.truncated(order), direction);
    return contact::factorial(order) * contact_series(line, other.truncated(order), contact::normal).difference[order];
  }
};

/// The derivatives of h of orders two to four on a parallelogram as forms in x across and y along the curve.
struct ContactCurve::Forms {
  DoubleInterval xx;
  DoubleInterval xxx;
  DoubleInterval xxy;
  DoubleInterval xxxx;
  DoubleInterval xxxy;
  DoubleInterval xxyy;
};

}  // namespace eliminant::bridge
