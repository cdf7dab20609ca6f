// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include <eliminant/bridge/contacts/contact_curve.hpp>
#include <eliminant/bridge/contacts/contact_series.hpp>
#include <eliminant/bridge/contacts/height_series.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/patch_jets.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>

/// What the files of ContactCurve share: Taylor tables along lines and in other parameters, and the parts of the curve.
namespace eliminant::bridge {

namespace contact {

using Place = std::array<double, 2>;

inline constexpr std::size_t weight = 3;
/// Both directions as columns.
inline Eigen::Matrix2d columns_of(const Place& a, const Place& b) {
  Eigen::Matrix2d result;
  result << a[0], b[0], a[1], b[1];
  return result;
}

inline double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double cross(const Place& a, const Place& b) { return a[0] * b[1] - a[1] * b[0]; }
inline Place unit(const Place& a) {
  const double length = std::hypot(a[0], a[1]);
  return {a[0] / length, a[1] / length};
}

inline double factorial(std::size_t n) { return n < 2 ? 1 : static_cast<double>(n) * factorial(n - 1); }

inline DoubleInterval symmetric(double reach) { return {-reach, reach}; }

/// The table of a patch in parameters (p, q) with s = m00 p + m01 q, t = m10 p + m11 q; weights too unless
/// `polynomial`.
template <class Scalar>
TaylorTable<Scalar> in_parameters(const TaylorTable<Scalar>& patch, const Eigen::Matrix2d& m, bool polynomial) {
  const std::size_t coordinates = polynomial ? weight : weight + 1;
  const std::size_t order = patch.order();
  TaylorTable<Scalar> result(2, order);
  for (std::size_t i = 0; i <= order; ++i)
    for (std::size_t j = 0; i + j <= order; ++j) result.at(i, j).fill(Scalar(0));
  if (polynomial) result.at(0, 0)[weight] = Scalar(1);
  const auto times = [](const std::vector<Scalar>& form, double p, double q) {
    std::vector<Scalar> next(form.size() + 1, Scalar(0));
    for (std::size_t a = 0; a < form.size(); ++a) {
      next[a + 1] = next[a + 1] + form[a] * Scalar(p);
      next[a] = next[a] + form[a] * Scalar(q);
    }
    return next;
  };
  // The forms s^i t^j by powers of p.
  std::vector<Scalar> power_of_s{Scalar(1)};
  for (std::size_t i = 0; i <= order; ++i) {
    std::vector<Scalar> form = power_of_s;
    for (std::size_t j = 0; i + j <= order; ++j) {
      for (std::size_t a = 0; a < form.size(); ++a)
        for (std::size_t k = 0; k < coordinates; ++k)
          result.at(a, i + j - a)[k] = result.at(a, i + j - a)[k] + form[a] * patch.at(i, j)[k];
      if (i + j < order) form = times(form, m(1, 0), m(1, 1));
    }
    if (i < order) power_of_s = times(power_of_s, m(0, 0), m(0, 1));
  }
  return result;
}

/// The derivative of this order in the direction (x, y) of the function with that series.
template <class Scalar>
Scalar derivative_in(const PlaneSeries<Scalar>& series, const Place& direction, std::size_t order) {
  Scalar sum(0);
  for (std::size_t j = 0; j <= order; ++j) {
    Scalar term = series.at(order - j, j);
    for (std::size_t k = 0; k < order; ++k) term = term * Scalar(direction[k < j ? 1 : 0]);
    sum = sum + term;
  }
  return Scalar(factorial(order)) * sum;
}

/// Encloses the table at all points whose parameters differ by at most `reach` from those of the table; `around` is the
/// table on a box that holds them, of a higher order.
inline TaylorTable<DoubleInterval> widened(const TaylorTable<DoubleInterval>& table, double reach,
                                           const TaylorTable<DoubleInterval>& around) {
  TaylorTable<DoubleInterval> result = table;
  for (std::size_t i = 0; i <= table.order(); ++i)
    for (std::size_t j = 0; i + j <= table.order(); ++j)
      for (std::size_t k = 0; k < 4; ++k) {
        const double fastest = static_cast<double>(i + 1) * around.at(i + 1, j)[k].magnitude() +
                               static_cast<double>(j + 1) * around.at(i, j + 1)[k].magnitude();
        result.at(i, j)[k] = result.at(i, j)[k] + symmetric(reach * fastest);
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
  /// In coordinates across and along.
  TaylorTable<DoubleInterval> base{2, 0};
  /// In parameters that are nearly those of the tangent plane.
  TaylorTable<DoubleInterval> other{2, 0};
  bool polynomial = false;
  /// Of both tables, and of the second one's parameters.
  ContactFrame frame;
  Eigen::Matrix2d by_plane = Eigen::Matrix2d::Identity();
  /// The parameters of the other patch: at the origin, and all.
  contact::Place middle_of_other{};
  contact::Place lower_of_other{};
  contact::Place upper_of_other{};
  /// Bounds |ds| + |dt| where both parameters of the base move by at most one.
  double following = 0;

  /// The derivatives of the other parameters by a step across, at every point of the parallelogram.
  std::array<DoubleInterval, 2> other_across() const {
    const HeightSeries<DoubleInterval> series = height_series(base, other, 1, polynomial);
    std::array<DoubleInterval, 2> result;
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t c = 0; c < 2; ++c)
        result[k] = result[k] +
                    DoubleInterval(by_plane(static_cast<long>(k), static_cast<long>(c))) * series.second[c].at(1, 0);
    return result;
  }
  /// h by coordinates across and along, at every point of the parallelogram.
  PlaneSeries<DoubleInterval> heights(std::size_t order) const {
    return height_series(base, other, order, polynomial).height;
  }
};

/// Both patches at a point of the curve, approximately, in the frame of the base.
struct ContactCurve::Tables {
  TaylorTable<double> base;
  TaylorTable<double> other;
  bool polynomial = false;

  /// h by coordinates in two directions.
  PlaneSeries<double> heights(const contact::Place& across, const contact::Place& along, std::size_t order) const {
    return height_series(contact::in_parameters(base, contact::columns_of(across, along), polynomial), other, order,
                         polynomial)
        .height;
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
