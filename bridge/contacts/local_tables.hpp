// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <eliminant/bridge/contacts/contact_series.hpp>
#include <eliminant/bridge/enclosures/double_interval.hpp>
#include <eliminant/bridge/nets/taylor_tables.hpp>
#include <eliminant/symbolic/arithmetic/rational.hpp>

/// Patches as power series at an exact point: all Taylor coefficients of their homogeneous coordinates, enclosed, so
/// that what is small near the point has a small error.
namespace eliminant::bridge::local {

using Table = TaylorTable<DoubleInterval>;
using Frame = std::array<std::array<symbolic::Rational, 3>, 3>;

/// Exact linear coordinates by rows: the tangent plane of a patch at the origin of its table, dual to its partial
/// derivatives up to rounding, and an exact normal, near those of `near`. nullopt at a singular point.
std::optional<Frame> exact_frame(const TaylorTable<symbolic::Rational>& patch, const ContactFrame& near);

/// The coefficients with the point of the table moved to the origin of the frame, all weights divided by the one there
/// where they are equal (`polynomial`).
Table enclosed_in(const Frame& frame, const TaylorTable<symbolic::Rational>& exact, bool polynomial);

Table exchanged_parameters(const Table& table);

/// The Taylor coefficients up to the order at all points that far from the origin; the table holds all of them.
Table moved(const Table& table, const std::array<DoubleInterval, 2>& by, std::size_t order);

/// In x and z, where the first parameter is x and the second is z and a series in x without constant term.
Table sheared(const Table& table, const std::vector<DoubleInterval>& series);

/// Powers 0 to `highest`.
std::vector<DoubleInterval> powers(const DoubleInterval& x, std::size_t highest);

double binomial(std::size_t n, std::size_t k);

inline double middle(const DoubleInterval& x) { return 0.5 * (x.lower + x.upper); }

/// Affine coordinates and their first derivatives, from Taylor coefficients of order 1 at least.
struct EnclosedSlopes {
  std::array<DoubleInterval, 3> value;
  std::array<std::array<DoubleInterval, 3>, 2> slope;

  explicit EnclosedSlopes(const Table& table);
  /// The inverse of the derivatives along the plane: by the parameter, then by the coordinate.
  std::array<std::array<DoubleInterval, 2>, 2> inverse() const;
};

/// The same at one point, approximately.
struct Jet {
  Eigen::Vector3d value;
  std::array<Eigen::Vector3d, 2> slope;
};

Jet jet_at(const Table& table, double a, double b);

}  // namespace eliminant::bridge::local
