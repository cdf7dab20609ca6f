// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <eliminant/intersect/curves/curve_result.hpp>
#include <eliminant/symbolic/geometry/rational_curve.hpp>

namespace eliminant::intersect {

/// Where the pieces of a curve meet: what lies there is one solution, whichever pieces found it, and whichever of two
/// curves comes first.
class Seams {
 public:
  /// `curve` must outlive the object. The ends of a curve of several pieces that meet are a seam, too. A single map
  /// whose domain ends where it begins has two parameters there, unless `of_one_piece` makes it closed likewise.
  explicit Seams(const symbolic::ParametricCurve& curve, bool of_one_piece = false);

  /// The curve has a domain, ends where it begins, and this is a seam.
  bool closed() const { return closed_; }
  /// Whether a solution of a piece at this parameter is left to another piece: on a seam to the one that ends there,
  /// and at the ends of a closed curve to the one that begins it.
  bool is_left_to_another(std::size_t piece, const std::optional<Parameter>& parameter) const;
  /// Whether the parameter, of a common point, is this one; the ends of a closed curve are one.
  bool is_same(const std::optional<Parameter>& parameter, const symbolic::Rational& value) const;

 private:
  const symbolic::ParametricCurve& curve_;
  bool closed_ = false;
};

/// Whether a solution is an end of an overlap, and so belongs to it.
bool ends_overlap(const CurveSolution& solution, const std::vector<Overlap>& overlaps, const Seams& first,
                  const Seams& second);

/// Overlaps that meet in both parameters become one.
void join_overlaps(std::vector<Overlap>& overlaps);

}  // namespace eliminant::intersect
